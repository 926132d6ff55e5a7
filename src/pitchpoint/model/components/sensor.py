# SPDX-License-Identifier: Apache-2.0
"""Sensors: numbers with a name that a machine shows to its controllers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.keys import choice, end, ends, integer, text

QUANTITIES = (
    "position",
    "velocity",
    "acceleration",
    "distance",
    "distance_rate",
    "angle",
    "angular_velocity",
    "angular_acceleration",
)
AXES = ("x", "y", "z")
UNITS = ("1", "m", "m/s", "m/s^2", "rad", "rad/s", "rad/s^2", "N", "N m", "W")
"""Units that a signal may have; its numbers are always those of SI."""


@dataclass(frozen=True, kw_only=True)
class FrameSensor:
    """A kinematic quantity between two frames, as seen from the second."""

    form: ClassVar[str] = "frames"
    quantity: str = choice(
        QUANTITIES,
        "component of the way between the markers and its rates, their distance and its rate, angle about "
        "the axis and its rates",
    )
    ends: tuple[str, str] = ends("what is sensed, and from where: ground, BODY or BODY.MARKER", length=(2, 2))
    axis: str = choice(
        AXES, "axis of the second marker: of the component, or about which an angle counts", "z"
    )


@dataclass(frozen=True, kw_only=True)
class JointSensor:
    """A coordinate of a joint, or its rate."""

    form: ClassVar[str] = "joint"
    coordinate: str = text("JOINT.COORDINATE, or a body for its spin")
    derivative: int = integer("0 the coordinate, 1 its rate, 2 its acceleration", 0, minimum=0, maximum=2)


@dataclass(frozen=True, kw_only=True)
class LoadSensor:
    """What the joint of a body puts on it: a component of the force, or of the moment about a marker."""

    form: ClassVar[str] = "load"
    at: str = end("BODY or BODY.MARKER: the body that the joint carries, and the place")
    quantity: str = choice(("force", "moment"), "component that is sensed", "force")
    seen_from: str = end("ground, BODY or BODY.MARKER that gives the axes", "ground")
    axis: str = choice(AXES, "axis of the component", "z")


@dataclass(frozen=True, kw_only=True)
class Listener:
    """An observation of another element by its name, such as tension[spring]."""

    form: ClassVar[str] = "observation"
    channel: str = text("name of the observation, as results have it")


Sensor: TypeAlias = FrameSensor | JointSensor | LoadSensor | Listener

SENSORS: dict[str, type] = {c.form: c for c in (FrameSensor, JointSensor, LoadSensor, Listener)}
