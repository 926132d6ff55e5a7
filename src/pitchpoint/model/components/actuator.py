# SPDX-License-Identifier: Apache-2.0
"""Actuators: a signal that becomes a torque or a force."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.keys import choice, ends, text

SIGNAL = "name of the signal"


@dataclass(frozen=True, kw_only=True)
class TorqueActuator:
    """Torque about the spin axis of a body, the reaction on a second one or on ground."""

    form: ClassVar[str] = "torque"
    signal: str = text(SIGNAL)
    bodies: tuple[str, ...] = ends(
        "the driven body, and the one that takes the reaction (ground if omitted); on a shaft BODY.MARKER "
        "is the place, else its start",
        length=(1, 2),
    )


@dataclass(frozen=True, kw_only=True)
class Strut:
    """Force along the line between two points; a positive signal pushes them apart."""

    form: ClassVar[str] = "strut"
    signal: str = text(SIGNAL)
    ends: tuple[str, str] = ends("its two ends: ground, BODY or BODY.MARKER", length=(2, 2))


@dataclass(frozen=True, kw_only=True)
class ForceActuator:
    """Force or moment at a marker along an axis of it or of the world, the reaction at the same place."""

    form: ClassVar[str] = "force"
    signal: str = text(SIGNAL)
    ends: tuple[str, str] = ends("where it acts, and what takes the reaction", length=(2, 2))
    quantity: str = choice(("force", "moment"), "what the signal is", "force")
    axis: str = choice(("x", "y", "z"), "its direction", "z")
    along: str = choice(("world", "first", "second"), "axes of the world or of one of the ends", "world")


Actuator: TypeAlias = TorqueActuator | Strut | ForceActuator

ACTUATORS: dict[str, type] = {c.form: c for c in (TorqueActuator, Strut, ForceActuator)}
