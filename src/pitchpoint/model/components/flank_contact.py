# SPDX-License-Identifier: Apache-2.0
"""Contact of tooth surfaces at one of three levels; replaces the stiffness law of a mesh.

A new level is a class of this file, listed in `LEVELS`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from pitchpoint.model.components.stiffness import StiffnessLaw
from pitchpoint.model.keys import component, integer, positive, quantity


@dataclass(frozen=True, kw_only=True)
class OilFilm:
    """Squeeze film: damps flanks that approach or separate, up to a gap of twice its thickness."""

    rate: float = positive(
        "damping", "damping of one contact plane normal to the flanks, for flanks in contact"
    )
    thickness: float = positive("length", "film thickness h; the film acts at gaps below 2 h")
    exponent: float = quantity(
        "dimensionless",
        "exponent of the film share 1 - gap/(2 h)",
        1.0,
        minimum=0.0,
        above=True,
        maximum=10.0,
    )


@dataclass(frozen=True, kw_only=True)
class StructuralDamping:
    """Damping force as a fraction of the elastic force of each contact plane."""

    factor: float = quantity(
        "dimensionless", "damping force over elastic force", minimum=0.0, above=True, maximum=1.0
    )
    speed: float = positive("speed", "speed normal to the flanks at which it reaches its full value", 1e-3)


class FlankContact(StiffnessLaw):
    """Base class of the levels: name of a level, and what all of them have in common."""

    level: ClassVar[str]
    of_pairs: ClassVar[bool] = True


@dataclass(frozen=True, kw_only=True)
class RigidContact(FlankContact):
    """Rigid tooth surfaces: force of each contact plane from its penetration."""

    level: ClassVar[str] = "rigid"
    law: ClassVar[str] = "rigid contact"
    stiffness: float | None = positive(
        "stiffness",
        "force normal to the flanks over the penetration of one tooth pair in contact over the face width",
        None,
        display="c' b to DIN 3990",
    )
    exponent: float = quantity("dimensionless", "exponent of the penetration", 1.0, minimum=1.0, maximum=5.0)
    depth: float = positive("length", "penetration at which `stiffness` applies if exponent > 1", 1e-5)
    planes: int = integer("number of contact planes over the face width", 11, minimum=1, maximum=1001)
    oil: OilFilm | None = component(OilFilm, "squeeze film between the flanks")
    structural: StructuralDamping | None = component(StructuralDamping, "structural damping of the teeth")


LEVELS: dict[str, type[FlankContact]] = {c.level: c for c in (RigidContact,)}
"""Levels of the contact of tooth surfaces."""
