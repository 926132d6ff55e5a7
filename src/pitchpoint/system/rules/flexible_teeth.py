# SPDX-License-Identifier: Apache-2.0
"""Compliance of flexible teeth for their contact: influence functions, and stiffness of a tooth pair."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from pitchpoint.contact.compliance.blank import Blank
from pitchpoint.contact.compliance.description import FlankCompliance
from pitchpoint.contact.compliance.gear import flank_compliance, gear_slice
from pitchpoint.contact.compliance.heights import dual
from pitchpoint.contact.compliance.pair import contact_depth, pair_slice
from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.contact.tooth_fe.flank_fields import flank_fields
from pitchpoint.contact.tooth_fe.store import stored_tooth_fe
from pitchpoint.contact.tooth_fe.tooth_model import ToothModel
from pitchpoint.core.errors import CompileError, ModelError
from pitchpoint.model.components.flank_contact import (
    OVERLAPS,
    FlexibleContact,
    PrecomputedContact,
)
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.contact.compliance.gear import GearSlice
    from pitchpoint.contact.tooth_fe.tooth import ToothFE
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.model.components.flank_contact import FlankContact
    from pitchpoint.model.components.gear import Gear

Array = NDArray[np.float64]

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


def elastic_flanks(
    contact: FlexibleContact, pair: GearPair, gears: Sequence[Gear], offsets: tuple[float, float]
) -> ElasticFlanks:
    """Elastic properties of both gears of a mesh.

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
    return ElasticFlanks(
        gears=(found[0], found[1]),
        moduli=(materials[0].youngs_modulus, materials[1].youngs_modulus),
        poisson=(materials[0].poisson_ratio, materials[1].poisson_ratio),
        overlap=OVERLAPS[contact.overlap]
        * float(np.mean(1.0 / (shape.c_prime * shape.table)))
        / (pair.b_w / contact.planes),
        correction=contact.correction,
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
