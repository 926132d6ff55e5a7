# SPDX-License-Identifier: Apache-2.0
"""Joints between bodies and their free coordinates."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.law import Law
from pitchpoint.model.components.marker import Axes, Triple
from pitchpoint.model.keys import (
    boolean,
    choice,
    component,
    derived,
    ends,
    key,
    positive,
    quantities,
    quantity,
)

#: Displacements of a joint in the order in which they are applied, and their dimensions.
DISPLACEMENTS: dict[str, str] = {
    "x": "length",
    "y": "length",
    "z": "length",
    "alpha": "angle",
    "beta": "angle",
    "spin": "angle",
}
RATES = {"length": "speed", "angle": "angular_speed"}

#: Free displacements of each joint; `moved` prescribes them over time, `user` defines its own coordinates.
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
"""Joints whose displacements are given by functions."""
TUMBLING = ("spherical", "free")
"""Joints whose rotations are re-referenced during a run, so that no orientation is singular."""


@dataclass(frozen=True, kw_only=True)
class JointFriction(Component):
    """Friction of the surfaces of a joint, from the joint load.

    Normal load: the force across the axis, the axial force on the shoulder of a pin, and the bending moment
    divided by the length of the bush or slide; of a ball the whole force, of a screw the force normal to the
    thread, of a plane the force and moment normal to it.
    """

    coefficient: float = quantity(
        "dimensionless", "coefficient of sliding friction", minimum=0.0, also=("mu", "dynamic")
    )
    radius: float | None = positive(
        "length",
        "radius of the pin, pins of the cross (universal), ball (spherical), mean radius of the thread "
        "(screw); planar: friction torque over friction force, 2/3 of the radius of a disc",
        None,
    )
    shoulder_radius: float = quantity(
        "length", "revolute, universal: mean radius of the thrust shoulder", 0.0, minimum=0.0
    )
    length: float | None = positive(
        "length", "length of bush, nut, slide or plane; if omitted, moments cause no friction", None
    )
    preload: float = quantity("force", "constant normal force", 0.0, minimum=0.0)
    static_ratio: float = quantity("dimensionless", "ratio of static to sliding friction", 1.0, minimum=1.0)
    stribeck_speed: float = quantity(
        "speed",
        "Stribeck speed: sliding velocity over which friction falls from static to sliding",
        0.0,
        minimum=0.0,
    )
    slip_speed: float = positive(
        "speed", "sliding velocity of full friction; a sticking joint creeps more slowly than this", 1e-3
    )


@dataclass(frozen=True, kw_only=True)
class Joint(Component):
    """A joint between two bodies: the second moves relative to the first.

    Its displacements are x, y, z along its axes on the first body, then the rotations alpha about x, beta
    about the rotated y and spin about the rotated z. All are zero in the positions given in the file.
    """

    type: str = choice(
        tuple(COORDINATES),
        "free displacements; fixed: none; revolute: spin; prismatic: z; cylindrical: z and spin; screw: "
        "spin, with travel along z; universal: alpha and beta; spherical: all rotations; planar: x, y, "
        "spin; shaft: all six, for bodies that spin with small tilt; free: all six, for any rotation; "
        "moved: prescribed motion over time; user: user-defined coordinates",
    )
    bodies: tuple[str, str] = ends(
        "base and moved body, each of them ground, a body, BODY.MARKER or BEAM.STATION", length=(2, 2)
    )
    position: Triple | None = quantities(
        "length",
        "position in the world",
        None,
        length=(3, 3),
        display="that of its markers, else the origin of the moved body",
    )
    axes: Axes | None = component(
        Axes, "directions in the world; default: those of its first marker, else those of the world"
    )
    lead: float | None = quantity(
        "length", "screw: travel along z per revolution; negative for a left-hand thread", None
    )
    start: Mapping[str, float] = key(
        "displacements", "initial values of its coordinates, such as {spin: 30 deg}; default 0", {}
    )
    speed: Mapping[str, float] = key(
        "rates", "initial rates of its coordinates, such as {spin: 100 rpm}; default 0", {}
    )
    friction: JointFriction | None = component(JointFriction, "friction of the sliding surfaces of the joint")
    cut: bool = boolean("cut joint that closes a kinematic loop; another joint carries the moved body", False)
    coordinates: Mapping[str, str] = key(
        "coordinates", "user: names of its coordinates and their kind, length or angle: {s: length}", {}
    )
    motion: Mapping[str, tuple[Law, ...]] = key(
        "motions",
        "displacements as functions of t (moved) or of one coordinate each (user): "
        "{x: 2 mm * sin(2*pi*25 Hz*t)}, {x: {table: [[t, x], ...]}}; a list of functions is added up",
        {},
    )

    stage: str | None = derived()
    """Planetary stage that contains the joint, if any."""
    of_housing: bool = derived(False)
    """Whether the joint fixes a body in the housing of the model."""

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the coordinates."""
        return tuple(self.coordinates) if self.type == "user" else COORDINATES[self.type]

    def dimension(self, coordinate: str) -> str:
        """Dimension of a coordinate: length or angle."""
        return dict(self.coordinates).get(coordinate) or DISPLACEMENTS[coordinate]
