# SPDX-License-Identifier: Apache-2.0
"""Actuators: torques and forces that follow a signal."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.component import Component
from pitchpoint.model.keys import choice, ends, text

SIGNAL = "name of the signal"


@dataclass(frozen=True, kw_only=True)
class TorqueActuator(Component):
    """Torque about the spin axis of a body; the reaction acts on a second body or on ground."""

    form: ClassVar[str] = "torque"
    signal: str = text(SIGNAL)
    bodies: tuple[str, ...] = ends(
        "driven body, and the body that takes the reaction (ground if omitted); on a shaft, BODY.MARKER "
        "gives the position, default: its start",
        length=(1, 2),
    )


@dataclass(frozen=True, kw_only=True)
class Strut(Component):
    """Force along the line between two points; a positive signal pushes the points apart."""

    form: ClassVar[str] = "strut"
    signal: str = text(SIGNAL)
    ends: tuple[str, str] = ends("the two ends: ground, BODY or BODY.MARKER", length=(2, 2))


@dataclass(frozen=True, kw_only=True)
class ForceActuator(Component):
    """Force or moment at a marker, along a given axis; the reaction acts at the same point."""

    form: ClassVar[str] = "force"
    signal: str = text(SIGNAL)
    ends: tuple[str, str] = ends(
        "point of action, and the body that takes the reaction: ground, BODY or BODY.MARKER", length=(2, 2)
    )
    quantity: str = choice(("force", "moment"), "quantity that the signal gives", "force")
    axis: str = choice(("x", "y", "z"), "direction", "z")
    along: str = choice(
        ("world", "first", "second"),
        "axes that `axis` refers to: of the world, or of the first or second end",
        "world",
    )


Actuator: TypeAlias = TorqueActuator | Strut | ForceActuator

ACTUATORS: dict[str, type] = {c.form: c for c in (TorqueActuator, Strut, ForceActuator)}
