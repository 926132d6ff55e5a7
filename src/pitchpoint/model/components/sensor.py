# SPDX-License-Identifier: Apache-2.0
"""Sensors: named signals measured on the model."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.component import Component
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
"""Units that a signal may have; its values are always in SI units."""


@dataclass(frozen=True, kw_only=True)
class FrameSensor(Component):
    """A kinematic quantity of the first frame relative to the second."""

    form: ClassVar[str] = "frames"
    quantity: str = choice(
        QUANTITIES,
        "component of the relative position and its derivatives, distance and its rate, angle about the axis "
        "and its derivatives",
    )
    ends: tuple[str, str] = ends(
        "measured frame and reference frame: ground, BODY or BODY.MARKER", length=(2, 2)
    )
    axis: str = choice(AXES, "axis of the reference frame for components and angles", "z")


@dataclass(frozen=True, kw_only=True)
class JointSensor(Component):
    """A coordinate of a joint, or its rate."""

    form: ClassVar[str] = "joint"
    coordinate: str = text("JOINT.COORDINATE, or a body for its spin")
    derivative: int = integer("0: coordinate, 1: rate, 2: acceleration", 0, minimum=0, maximum=2)


@dataclass(frozen=True, kw_only=True)
class LoadSensor(Component):
    """Joint reaction on a body: a component of the force, or of the moment about a marker."""

    form: ClassVar[str] = "load"
    at: str = end("BODY or BODY.MARKER: body carried by the joint, and reference point")
    quantity: str = choice(("force", "moment"), "measured quantity", "force")
    seen_from: str = end("ground, BODY or BODY.MARKER: reference axes", "ground")
    axis: str = choice(AXES, "axis of the component", "z")


@dataclass(frozen=True, kw_only=True)
class Listener(Component):
    """An output of another element by its name, such as tension[spring]."""

    form: ClassVar[str] = "observation"
    channel: str = text("name of the observation as in results")


Sensor: TypeAlias = FrameSensor | JointSensor | LoadSensor | Listener

SENSORS: dict[str, type] = {c.form: c for c in (FrameSensor, JointSensor, LoadSensor, Listener)}
