# SPDX-License-Identifier: Apache-2.0
"""Joints between bodies: what moves against what, and in which directions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.model.components.law import Law
from pitchpoint.model.components.marker import Axes, Triple
from pitchpoint.model.keys import (
    boolean,
    choice,
    component,
    ends,
    key,
    positive,
    quantities,
    quantity,
)

#: Displacements of a joint in the order in which they are made, and their dimensions.
DISPLACEMENTS: dict[str, str] = {
    "x": "length",
    "y": "length",
    "z": "length",
    "alpha": "angle",
    "beta": "angle",
    "spin": "angle",
}
RATES = {"length": "speed", "angle": "angular_speed"}

#: Displacements that are free in each joint; those of `moved` follow time, those of `user` own coordinates.
COORDINATES: dict[str, tuple[str, ...]] = {
    "fixed": (),
    "revolute": ("spin",),
    "prismatic": ("z",),
    "cylindrical": ("z", "spin"),
    "screw": ("spin",),
    "universal": ("alpha", "beta"),
    "spherical": ("alpha", "beta", "spin"),
    "planar": ("x", "y", "spin"),
    "shaft": ("x", "y", "z", "alpha", "beta", "spin"),
    "free": ("x", "y", "z", "alpha", "beta", "spin"),
    "moved": (),
    "user": (),
}
FUNCTIONS = ("moved", "user")
"""Joints whose displacements are functions."""
TUMBLING = ("spherical", "free")
"""Joints whose turns start afresh while they run, so that no attitude is singular."""


@dataclass(frozen=True, kw_only=True)
class JointFriction:
    """Friction of a pin in its bush, or of a slide, from the load that the joint carries.

    What presses: the force across the axis, the one along it on the shoulder of a pin, and the moment that
    bends the axis, over the length of the bush or slide.
    """

    coefficient: float = quantity("dimensionless", "friction over load at fast sliding", minimum=0.0)
    radius: float | None = positive("length", "revolute: radius of the pin", None)
    shoulder_radius: float = quantity(
        "length", "revolute: mean radius of what carries along the axis", 0.0, minimum=0.0
    )
    length: float | None = positive("length", "length of bush or slide; without it no moment presses", None)
    preload: float = quantity("force", "force that always presses", 0.0, minimum=0.0)
    static_ratio: float = quantity("dimensionless", "static over sliding friction", 1.0, minimum=1.0)
    stribeck_speed: float = quantity(
        "speed", "sliding over which friction falls from the one to the other", 0.0, minimum=0.0
    )
    slip_speed: float = positive("speed", "sliding of full friction; what should stick creeps slower", 1e-3)


@dataclass(frozen=True, kw_only=True)
class Joint:
    """A joint between two bodies: it moves the second against the first.

    Its displacements are x, y, z along its axes on the first body, then the turns alpha about x, beta about
    the turned y, spin about the turned z. All are zero where the file places the bodies.
    """

    type: str = choice(
        tuple(COORDINATES),
        "fixed: none; revolute: spin; prismatic: z; cylindrical: z and spin; screw: spin, which moves along "
        "z; universal: alpha and beta; spherical: all turns; planar: x, y, spin; shaft: all six, for what "
        "spins and hardly tilts; free: all six, for what tumbles; moved: motion over time; user: coordinates "
        "of its own",
    )
    bodies: tuple[str, str] = ends(
        "what it sits on and what it moves, each of them ground, a body or BODY.MARKER", length=(2, 2)
    )
    position: Triple | None = quantities(
        "length",
        "place in the world",
        None,
        length=(3, 3),
        display="that of its markers, else the origin of the body that it moves",
    )
    axes: Axes | None = component(
        Axes, "directions in the world; without them those of its first marker, else those of the world"
    )
    lead: float | None = quantity(
        "length", "screw: way along z per turn; negative for a left-hand thread", None
    )
    start: Mapping[str, float] = key(
        "displacements", "values of its coordinates at the start, such as {spin: 30 deg}; 0 for others", {}
    )
    speed: Mapping[str, float] = key(
        "rates", "rates of its coordinates at the start, such as {spin: 100 rpm}; 0 for others", {}
    )
    friction: JointFriction | None = component(JointFriction, "friction of a revolute or prismatic joint")
    cut: bool = boolean("whether it closes a loop: it is not to carry the body that it moves", False)
    coordinates: Mapping[str, str] = key(
        "coordinates", "user: names of its coordinates, each a length or an angle: {s: length}", {}
    )
    motion: Mapping[str, tuple[Law, ...]] = key(
        "motions",
        "displacements as functions, of t (moved) or of one coordinate each (user): "
        "{x: 2 mm * sin(2*pi*25 Hz*t)}, {x: {table: [[t, x], ...]}}; a list of functions is their sum",
        {},
    )

    @property
    def names(self) -> tuple[str, ...]:
        """Names of its coordinates."""
        return tuple(self.coordinates) if self.type == "user" else COORDINATES[self.type]

    def dimension(self, coordinate: str) -> str:
        """Dimension of a coordinate: length or angle."""
        return dict(self.coordinates).get(coordinate) or DISPLACEMENTS[coordinate]
