# SPDX-License-Identifier: Apache-2.0
"""Contact of tooth surfaces for the record of a mesh."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.hertz import plane_strain_compliance
from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.elements.mesh import record as layout
from pitchpoint.elements.mesh.surface.nodes import NODE
from pitchpoint.elements.mesh.surface.scratch import scratch_size

if TYPE_CHECKING:
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.model.components.flank_contact import OilFilm, RigidContact, StructuralDamping

Array = NDArray[np.float64]

REACH = 0.5
"""Path before A and beyond E on which tip edges are in contact, in base pitches."""


LEAST_ROLL = 0.02
"""Least radius of curvature of a flank in the local contact, in base pitches: next to base circles."""


class Influence(Protocol):
    """Influence functions of the teeth of one gear (`contact.compliance`, `contact.tooth_fe`)."""

    @property
    def roll(self) -> tuple[float, float]:
        """Lengths of roll at the heights -1 and +1 [m]."""

    @property
    def own(self) -> Array:
        """Compliances of a tooth, shape (planes, planes, 4, 4) [m/N]."""

    @property
    def neighbour(self) -> Array:
        """Compliances between neighbouring teeth, likewise."""

    @property
    def windup(self) -> float:
        """Compliance of the blank in torsion along the base tangent [m/N]."""

    @property
    def depth(self) -> Array:
        """Depth of the reference point of the local contact over the height, shape (4,) [m]."""


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
    """

    gears: tuple[Influence, Influence]
    moduli: tuple[float, float]
    poisson: tuple[float, float]
    overlap: float = 0.0


def _set_elastic(row: Any, pair: GearPair, elastic: ElasticFlanks, keep: Callable[[Array], int]) -> None:
    """Set influence functions, local contact and scratch of flexible teeth."""
    planes, pairs = int(row["slices"]), pairs_in_reach(pair)
    cos_b = math.cos(pair.gear1.beta_b)
    row["is_flexible"] = 1
    row["n_slots"], row["n_slot_pairs"] = -1, pairs
    row["plane_width"] = width = pair.b_w / planes
    row["work"] = keep(np.zeros(scratch_size(int(row["max_nodes"]), pairs * planes)))
    c = [plane_strain_compliance(E, nu) for E, nu in zip(elastic.moduli, elastic.poisson, strict=True)]
    for k, gear in enumerate(elastic.gears):
        low, high = gear.roll
        row["height"][k] = 0.5 * (low + high), 0.5 * (high - low)
        row["own"][k], row["neighbour"][k] = keep(gear.own), keep(gear.neighbour)
        row["depth"][k] = gear.depth
        row["line"][k] = 2.0 * c[k] / (math.pi * cos_b * width)
        row[f"kappa_{k + 1}"] = elastic.poisson[k] / (1.0 - elastic.poisson[k])
    row["windup"] = sum(gear.windup for gear in elastic.gears)
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
    """

    planes: int = 11
    elastic: ElasticFlanks | None = None
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


def rigid_surfaces(contact: RigidContact) -> SurfaceContact:
    """Contact of rigid tooth surfaces."""
    return SurfaceContact(planes=contact.planes, oil=contact.oil, structural=contact.structural)


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
    row["max_nodes"] = contact.planes * pairs_in_reach(pair)
    row["nodes"] = keep(np.zeros(int(row["max_nodes"]) * NODE.itemsize // 8))
    cos_b = math.cos(pair.gear1.beta_b)
    if contact.elastic is not None:
        _set_elastic(row, pair, contact.elastic, keep)
    if contact.oil is not None:
        row["oil_rate"] = contact.oil.rate * cos_b**2
        row["oil_film"] = contact.oil.thickness / cos_b
        row["oil_power"] = contact.oil.exponent
        row["sep_min"] -= 2.0 * row["oil_film"]
    if contact.structural is not None:
        row["structural"] = contact.structural.factor
        row["structural_speed"] = contact.structural.speed / cos_b
