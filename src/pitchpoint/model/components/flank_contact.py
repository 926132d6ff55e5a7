# SPDX-License-Identifier: Apache-2.0
"""Contact of tooth surfaces at one of three levels; replaces the stiffness law of a mesh.

A new level is a class of this file, listed in `LEVELS`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar

from pitchpoint.model.component import Component
from pitchpoint.model.components.stiffness import StiffnessLaw
from pitchpoint.model.keys import choice, component, derived, integer, key, positive, quantity


@dataclass(frozen=True, kw_only=True)
class OilFilm(Component):
    """Squeeze film: damps flanks that approach or separate, up to a gap of twice its thickness."""

    rate: float | None = positive(
        "damping",
        "damping of one contact plane normal to the flanks, for flanks in contact",
        None,
        display="of the film at the pitch point, with the viscosity of lubricant",
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
class StructuralDamping(Component):
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


OVERLAPS = {"small": 0.005, "normal": 0.01, "high": 0.02}
"""Contact overlap: additional compliance of a contact plane over the compliance of a tooth pair."""


def default_clamp(internal: bool) -> str:
    """Default clamp of the teeth of a pair, with or without an internal gear."""
    return "30 deg, internal gear 60 deg" if internal else "30 deg"


@dataclass(frozen=True, kw_only=True)
class FlexibleContact(FlankContact):
    """Flexible teeth and bodies: the contact problem of all planes and pairs is solved in each evaluation."""

    level: ClassVar[str] = "flexible"
    law: ClassVar[str] = "flexible contact"
    teeth: str = choice(
        ("analytic", "finite_elements"),
        "source of the compliance: plates on an elastic body, or 3-D finite elements of tooth and body "
        "(seconds per gear, stored for the next time)",
        "analytic",
    )
    body: str = choice(
        ("ring", "weber_banaschek", "half_plane", "sainsot", "rigid"),
        "compliance of the gear body under analytic teeth",
        "ring",
    )
    clamp: float | None = quantity(
        "angle",
        "inclination of the fillet tangent at which an analytic tooth is clamped to its body",
        None,
        minimum=math.radians(5.0),
        maximum=math.radians(80.0),
        display="30 deg, internal gears 60 deg",
    )
    coupling: str = choice(
        ("plate", "springs", "none"), "coupling of the planes of analytic teeth over the face width", "plate"
    )
    correction: float = positive(
        "dimensionless", "correction factor C_M of the stiffness; 0.8 in ISO 6336-1", 1.0, maximum=10.0
    )
    overlap: str = choice(
        tuple(OVERLAPS),
        "contact overlap: additional compliance of each contact plane, 0.5, 1 or 2 % of that of a tooth pair",
        "small",
    )
    planes: int = integer("number of contact planes over the face width", 11, minimum=1, maximum=101)
    oil: OilFilm | None = component(OilFilm, "squeeze film between the flanks")
    structural: StructuralDamping | None = component(StructuralDamping, "structural damping of the teeth")


@dataclass(frozen=True, kw_only=True)
class PrecomputedContact(FlankContact):
    """Forces from a table of the elastic potential, computed from flexible contact by `contact-table`.

    The file contains the options of that contact. It is refused if a gear or the centre distance differs.
    """

    level: ClassVar[str] = "precomputed"
    law: ClassVar[str] = "pre-computed contact"
    file: str = key(
        "file",
        "table of the contact, .gcp.h5: from `pitchpoint contact-table` with level: flexible",
        sample="stage.gcp.h5",
    )
    tables: Any = derived()
    """Tables of front and back flanks and the options of the flexible contact, read with the model."""


LEVELS: dict[str, type[FlankContact]] = {
    c.level: c for c in (RigidContact, FlexibleContact, PrecomputedContact)
}
"""Levels of the contact of tooth surfaces."""
