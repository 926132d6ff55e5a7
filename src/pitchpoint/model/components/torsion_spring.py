# SPDX-License-Identifier: Apache-2.0
"""Springs and dampers about the spin axes of bodies."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.components.law import Law
from pitchpoint.model.keys import key, positive, quantity

TURNING = "names of the two bodies whose turns it couples; one name alone: the body and ground"


@dataclass(frozen=True, kw_only=True)
class TorsionSpring:
    """Torsion spring and damper side by side between two bodies, over any number of turns."""

    bodies: tuple[str, ...] = key("names", TURNING, length=(1, 2))
    stiffness: float = quantity("torsional_stiffness", "torque per angle", 0.0, minimum=0.0)
    damping: float = quantity("torsional_damping", "torque per relative speed", 0.0, minimum=0.0)
    angle: float = quantity("angle", "of the first body against the second without torque", 0.0)
    play: float = quantity("angle", "total angle within which the spring does not act", 0.0, minimum=0.0)
    torque: Law | None = key(
        "law",
        "further torque on the first body: a formula of t, angle, speed (of the first body against the "
        "second), {table: [[angle, T], ...], over: angle} (repeated if it is a whole turn long), "
        "{python: 'file.py:function', parameters: [...]} "
        "with f(t, angle, parameters), the speed behind the parameters",
        None,
        dimension="torque",
    )


@dataclass(frozen=True, kw_only=True)
class TorsionMaxwell:
    """Torsion spring and damper in series between two bodies; without torque at the start."""

    bodies: tuple[str, ...] = key("names", TURNING, length=(1, 2))
    stiffness: float = positive("torsional_stiffness", "of the spring")
    damping: float = positive("torsional_damping", "of the damper")
