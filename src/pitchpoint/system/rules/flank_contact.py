# SPDX-License-Identifier: Apache-2.0
"""Contact of tooth surfaces for the record of a mesh."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from pitchpoint.contact.compliance.blank import Blank
from pitchpoint.contact.compliance.description import FlankCompliance
from pitchpoint.contact.compliance.gear import flank_compliance, gear_slice
from pitchpoint.contact.compliance.heights import dual
from pitchpoint.contact.compliance.pair import contact_depth, pair_slice
from pitchpoint.contact.hertz import plane_strain_compliance
from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.contact.tooth_fe.flank_fields import flank_fields
from pitchpoint.contact.tooth_fe.store import stored_tooth_fe
from pitchpoint.contact.tooth_fe.tooth_model import ToothModel
from pitchpoint.core.errors import CompileError, ModelError
from pitchpoint.elements.mesh import record as layout
from pitchpoint.elements.mesh.surface.nodes import NODE
from pitchpoint.elements.mesh.surface.scratch import scratch_size
from pitchpoint.model.components.flank_contact import (
    OVERLAPS,
    FlexibleContact,
    PrecomputedContact,
    RigidContact,
)
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.contact.compliance.gear import GearSlice
    from pitchpoint.contact.tooth_fe.tooth import ToothFE
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.model.components.flank_contact import FlankContact, OilFilm, StructuralDamping
    from pitchpoint.model.components.gear import Gear

Array = NDArray[np.float64]

REACH = 0.5
"""Path before A and beyond E on which tip edges are in contact, in base pitches."""

LEAST_ROLL = 0.02
"""Least radius of curvature of a flank in the local contact, in base pitches: next to base circles."""


@dataclass(frozen=True)
class GearInfluence:
    """Elastic properties of one gear.

    Parameters
    ----------
    teeth
        Compliance of teeth and body.
    depth
        Depth of the reference point of the local contact, coefficients of the Legendre polynomials of the
        height, shape (4,) [m].
    back
        Compliance of teeth and body when the back flanks of the mesh are in contact; None: `teeth`.
    """

    teeth: FlankCompliance
    depth: Array
    back: FlankCompliance | None = None


@dataclass(frozen=True, kw_only=True)
class ElasticFlanks:
    """Elastic properties of both gears.

    Parameters
    ----------
    gears
        Influence functions of both gears, for the planes of the contact.
    moduli, poisson
        Young's moduli [Pa] and Poisson's ratios.
    overlap
        Additional compliance of one node [m/N].
    correction
        Factor C_M of the stiffness of the local contact; that of the teeth is in their influence functions.
    """

    gears: tuple[GearInfluence, GearInfluence]
    moduli: tuple[float, float]
    poisson: tuple[float, float]
    overlap: float = 0.0
    correction: float = 1.0


def _set_elastic(row: Any, pair: GearPair, elastic: ElasticFlanks, keep: Callable[[Array], int]) -> None:
    """Set influence functions, local contact and scratch of flexible teeth."""
    planes, pairs = int(row["slices"]), pairs_in_reach(pair)
    cos_b = math.cos(pair.gear1.beta_b)
    row["is_flexible"] = 1
    row["n_slots"], row["n_slot_pairs"] = -1, pairs
    row["plane_width"] = width = pair.b_w / planes
    row["work"] = keep(np.zeros(scratch_size(int(row["max_nodes"]), pairs, planes)))
    c = [plane_strain_compliance(E, nu) for E, nu in zip(elastic.moduli, elastic.poisson, strict=True)]
    for k, gear in enumerate(elastic.gears):
        low, high = gear.teeth.roll
        row["height"][k] = 0.5 * (low + high), 0.5 * (high - low)
        for side, teeth in enumerate((gear.teeth, gear.back)):
            parts = teeth and (teeth.own, teeth.beside, teeth.beside.transpose(1, 0, 3, 2))
            for j, name in enumerate(("own", "before", "after")):
                row[name][side, k] = keep(parts[j]) if parts else row[name][0, k]
        row["depth"][k] = gear.depth
        row["line"][k] = 2.0 * c[k] / (math.pi * cos_b * width * elastic.correction)
        row[f"kappa_{k + 1}"] = elastic.poisson[k] / (1.0 - elastic.poisson[k])
    row["windup"] = sum(gear.teeth.windup for gear in elastic.gears)
    # the radius normal to the contact line is the transverse one over cos(beta_b)
    row["strip"] = 4.0 * sum(c) / (math.pi * width * cos_b)
    row["least_roll"] = LEAST_ROLL * row["p_bt"]
    row["overlap"] = elastic.overlap


@dataclass(frozen=True, kw_only=True)
class SurfaceContact:
    """Contact of tooth surfaces, apart from its elastic law.

    Parameters
    ----------
    planes
        Number of contact planes over the face width.
    oil, structural
        Damping of each plane.
    elastic
        Compliance of flexible teeth; None: rigid.
    tables
        Tabulated potentials of front and back flanks, shape (n,) each; empty: not pre-computed.
    """

    planes: int = 11
    elastic: ElasticFlanks | None = None
    tables: tuple[Array, ...] = ()
    oil: OilFilm | None = None
    structural: StructuralDamping | None = None


def rigid_shape(contact: RigidContact, pair: GearPair, c_prime: float) -> PairShape:
    """Stiffness of a tooth pair with rigid surfaces per face width, along the base tangent.

    Parameters
    ----------
    contact
        The contact.
    pair
        The gear pair.
    c_prime
        Single stiffness to DIN 3990 along the base tangent [N/m^2], if the contact has no stiffness.

    Notes
    -----
    F_n = k h (x_n/h)^e with the stiffness k at the penetration h. Along the base tangent F_bt = F_n cos β_b
    and x_bt = x_n/cos β_b.
    """
    cos_b, e = math.cos(pair.gear1.beta_b), contact.exponent
    linear = c_prime if contact.stiffness is None else contact.stiffness * cos_b**2 / pair.b_w
    return PairShape(c_prime=linear * (contact.depth / cos_b) ** (1.0 - e), S_R=1.0, power=e)


LINE_LOAD = 3e5
"""Line load at which the stiffness of a flexible tooth pair is stated [N/m]."""
_ON_PATH = 65
"""Points of the path of contact at which it is stated."""
_HEIGHTS = 4
"""Legendre polynomials over the height of a tooth."""


def _slices(contact: FlexibleContact, gears: Sequence[Gear]) -> tuple[GearSlice, GearSlice]:
    """Slices of both gears in plane strain."""
    one, two = (
        gear_slice(
            g.geometry, material=g.material_data, blank=blank_of(g), body=contact.body, clamp=contact.clamp
        )
        for g in gears
    )
    return one, two


def blank_of(gear: Gear) -> Blank:
    """Blank of a gear of a model."""
    return Blank(
        bore_diameter=gear.bore_diameter or None,
        rim_thickness=gear.rim_thickness,
        web_thickness=gear.web_thickness,
    )


def flexible_shape(contact: FlexibleContact, pair: GearPair, gears: Sequence[Gear]) -> PairShape:
    """Stiffness of a flexible tooth pair alone in the mesh over its path, at the line load `LINE_LOAD`.

    Reference of damping ratios, time steps and the mesh cycle; the forces follow from the contact problem.
    """
    return _shape_of(pair, _slices(contact, gears), contact.correction)


@lru_cache(maxsize=64)
def _shape_of(pair: GearPair, parts: tuple[GearSlice, GearSlice], correction: float) -> PairShape:
    """`flexible_shape` of two slices; planets, both uses of a compilation, and all cases share it."""
    # a path that reaches a base circle has finite radii of curvature in the local contact, too
    least = LEAST_ROLL * pair.p_et
    end = math.inf if pair.is_internal else pair.T1T2 - least
    place = np.clip(np.linspace(pair.T1A, pair.T1E, _ON_PATH), least, end)
    stiffness = correction * pair_slice(pair, place, LINE_LOAD, parts).stiffness
    top = float(stiffness.max())
    return PairShape(c_prime=top, S_R=float(stiffness.min()) / top, table=stiffness / top)


_kept_compliance = lru_cache(maxsize=32)(flank_compliance)


def finite_elements_of(gear: Gear) -> ToothFE:
    """Finite elements of a gear of a model, from the disk or computed."""
    return stored_tooth_fe(
        ToothModel(
            gear=gear.geometry.replace(outline=None),  # the generated tooth
            E=gear.material_data.youngs_modulus,
            nu=gear.material_data.poisson_ratio,
            bore_diameter=gear.bore_diameter or None,
            rim_thickness=gear.rim_thickness,
            web_thickness=gear.web_thickness,
        )
    )


def has_finite_elements(contact: FlankContact) -> bool:
    """Whether the compliance of the teeth is that of finite elements, in a table, too."""
    if isinstance(contact, PrecomputedContact):
        contact = flexible_options(contact)
    return isinstance(contact, FlexibleContact) and contact.teeth == "finite_elements"


def common_width(offset: float, pair: GearPair) -> tuple[float, float]:
    """Ends of the common face width from the mid-face of a gear [m]; `offset`: its middle from there."""
    return offset - 0.5 * pair.b_w, offset + 0.5 * pair.b_w


def _compliance_of(
    contact: FlexibleContact, gear: Gear, width: tuple[float, float], *, right: bool
) -> FlankCompliance:
    """Compliance of the teeth and the body of one gear on the planes between two widths from its mid-face.

    `right`: of the right flanks of helical teeth by finite elements. Half a turn about the centre line of a
    tooth makes them left ones; it reverses the face width and the order of the teeth.
    """
    if contact.teeth == "analytic":
        return _kept_compliance(
            gear.geometry.replace(outline=None),  # the generated tooth
            planes=contact.planes,
            width=width,
            material=gear.material_data,
            blank=blank_of(gear),
            body=contact.body,
            clamp=contact.clamp,
            coupling=contact.coupling,
            C_M=contact.correction,
        )
    span = (-width[1], -width[0]) if right else width
    fields = flank_fields(finite_elements_of(gear), contact.planes, span, heights=_HEIGHTS)
    if right:
        own, beside = (part[::-1, ::-1] for part in (fields.own, fields.beside))
        fields = replace(fields, own=own, beside=beside, provenance={**fields.provenance, "flank": "right"})
    return fields if contact.correction == 1.0 else fields.scaled(contact.correction)


def flexible_surfaces(
    contact: FlexibleContact, pair: GearPair, gears: Sequence[Gear], offsets: tuple[float, float]
) -> SurfaceContact:
    """Contact of flexible teeth.

    Parameters
    ----------
    contact
        The contact.
    pair
        The gear pair.
    gears
        Both gears of the model.
    offsets
        Middle of the common face width from the mid-faces of both gears [m].
    """
    found = []
    parts = _slices(contact, gears)
    for gear, part, offset in zip(gears, parts, offsets, strict=True):
        width, geometry = common_width(offset, pair), gear.geometry
        ring, differs = geometry.is_internal, contact.teeth == "finite_elements" and geometry.beta != 0.0
        compliance = _compliance_of(contact, gear, width, right=ring)
        back = _compliance_of(contact, gear, width, right=not ring) if differs else None
        t, weights = leggauss(16)
        low, high = compliance.roll
        depth = contact_depth(part, 0.5 * (low + high + (high - low) * t), pair.gear1.beta_b)
        found.append(GearInfluence(compliance, (weights * depth) @ dual(t, _HEIGHTS), back))
    shape = flexible_shape(contact, pair, gears)
    assert shape.table is not None
    materials = [gear.material_data for gear in gears]
    elastic = ElasticFlanks(
        gears=(found[0], found[1]),
        moduli=(materials[0].youngs_modulus, materials[1].youngs_modulus),
        poisson=(materials[0].poisson_ratio, materials[1].poisson_ratio),
        overlap=OVERLAPS[contact.overlap]
        * float(np.mean(1.0 / (shape.c_prime * shape.table)))
        / (pair.b_w / contact.planes),
        correction=contact.correction,
    )
    return SurfaceContact(
        planes=contact.planes, oil=contact.oil, structural=contact.structural, elastic=elastic
    )


def flexible_options(contact: PrecomputedContact) -> FlexibleContact:
    """Flexible contact from which a table was computed.

    Raises
    ------
    CompileError
        If the table has not been read, because the model does not come from a file.
    """
    if contact.tables is None:
        raise CompileError(
            f"the contact table {contact.file} has not been read; load the model from its file"
        )
    reader = Reader()
    found = reader.component(FlexibleContact, contact.tables.inputs["contact"], ("contact",))
    if reader.problems:
        raise ModelError(reader.problems, contact.file)
    assert isinstance(found, FlexibleContact)
    return found


def surfaces(
    contact: FlankContact, pair: GearPair, gears: Sequence[Gear], offsets: tuple[float, float]
) -> SurfaceContact:
    """Contact of tooth surfaces of a mesh; arguments as for `flexible_surfaces`."""
    if isinstance(contact, PrecomputedContact):
        found = flexible_surfaces(flexible_options(contact), pair, gears, offsets)
        tables = (contact.tables.tables[flank].packed for flank in ("front", "back"))
        return replace(found, tables=tuple(tables))
    if isinstance(contact, FlexibleContact):
        return flexible_surfaces(contact, pair, gears, offsets)
    assert isinstance(contact, RigidContact)
    return SurfaceContact(planes=contact.planes, oil=contact.oil, structural=contact.structural)


def surface_shape(contact: FlankContact, pair: GearPair, gears: Sequence[Gear], c_prime: float) -> PairShape:
    """Stiffness of one tooth pair with contact of tooth surfaces; `c_prime` as for `rigid_shape`."""
    if isinstance(contact, PrecomputedContact):
        contact = flexible_options(contact)
    if isinstance(contact, FlexibleContact):
        return flexible_shape(contact, pair, gears)
    assert isinstance(contact, RigidContact)
    return rigid_shape(contact, pair, c_prime)


def pairs_in_reach(pair: GearPair) -> int:
    """Number of tooth pairs that may be in contact at the same time, tip edges included."""
    return math.ceil(pair.eps_gamma + 2.0 * REACH) + 1


def set_surfaces(row: Any, pair: GearPair, contact: SurfaceContact, keep: Callable[[Array], int]) -> None:
    """Set the fields of the tooth surfaces of a mesh record; stiffness and geometry must be set.

    Parameters
    ----------
    row
        Record of the mesh.
    pair
        Geometry of the gear pair.
    contact
        Contact planes and their damping.
    keep
        Stores an array in the pool of the kind and returns its offset.
    """
    row["source"], row["slices"] = layout.SURFACE, contact.planes
    row["is_rigid"] = contact.elastic is None
    row["reach"] = REACH * row["p_bt"]
    row["tip_share"] = -1.0
    row["rounding"] = [gear.tip_rounding or 0.0 for gear in (pair.gear1, pair.gear2)]
    row["max_nodes"] = contact.planes * pairs_in_reach(pair)
    row["nodes"] = keep(np.zeros(int(row["max_nodes"]) * NODE.itemsize // 8))
    cos_b = math.cos(pair.gear1.beta_b)
    if contact.elastic is not None:
        _set_elastic(row, pair, contact.elastic, keep)
    row["is_tabulated"] = bool(contact.tables)
    for side, table in enumerate(contact.tables):
        row["gcp"][side], row["gcp_size"][side] = keep(table), table.size
    if contact.oil is not None:
        row["oil_rate"] = (contact.oil.rate or 0.0) * cos_b**2
        row["oil_film"] = contact.oil.thickness / cos_b
        row["oil_power"] = contact.oil.exponent
        row["sep_min"] -= 2.0 * row["oil_film"]
    if contact.structural is not None:
        row["structural"] = contact.structural.factor
        row["structural_speed"] = contact.structural.speed / cos_b
