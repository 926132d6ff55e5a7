# SPDX-License-Identifier: Apache-2.0
"""Contact of tooth surfaces for the record of a mesh."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.hertz import plane_strain_compliance
from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.elements.mesh import record as layout
from pitchpoint.elements.mesh.surface.nodes import NODE
from pitchpoint.elements.mesh.surface.scratch import scratch_size
from pitchpoint.model.components.flank_contact import (
    FlexibleContact,
    PrecomputedContact,
    RigidContact,
)
from pitchpoint.system.rules.flexible_teeth import (
    LEAST_ROLL,
    ElasticFlanks,
    elastic_flanks,
    flexible_options,
    flexible_shape,
)

if TYPE_CHECKING:
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.model.components.flank_contact import FlankContact, OilFilm, StructuralDamping
    from pitchpoint.model.components.gear import Gear

Array = NDArray[np.float64]

REACH = 0.5
"""Path before A and beyond E on which tip edges are in contact, in base pitches."""


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


def surfaces(
    contact: FlankContact, pair: GearPair, gears: Sequence[Gear], offsets: tuple[float, float]
) -> SurfaceContact:
    """Contact of tooth surfaces of a mesh; arguments as for `elastic_flanks`."""
    if isinstance(contact, PrecomputedContact):
        found = surfaces(flexible_options(contact), pair, gears, offsets)
        tables = (contact.tables.tables[flank].packed for flank in ("front", "back"))
        return replace(found, tables=tuple(tables))
    assert isinstance(contact, FlexibleContact | RigidContact)
    elastic = None
    if isinstance(contact, FlexibleContact):
        elastic = elastic_flanks(contact, pair, gears, offsets)
    return SurfaceContact(
        planes=contact.planes, oil=contact.oil, structural=contact.structural, elastic=elastic
    )


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
