# SPDX-License-Identifier: Apache-2.0
"""Springs and dampers about the spin axes of bodies."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.law import Law
from pitchpoint.model.keys import derived, key, positive, quantity

TURNING = (
    "names of the two bodies, BODY or BODY.MARKER (a place on a shaft; without it the start of the shaft); "
    "one name: the body and ground"
)


@dataclass(frozen=True, kw_only=True)
class TorsionSpring(Component):
    """Torsion spring and damper in parallel between two bodies, for any number of revolutions."""

    bodies: tuple[str, ...] = key("names", TURNING, length=(1, 2))
    stiffness: float = quantity("torsional_stiffness", "torsional stiffness", 0.0, minimum=0.0)
    damping: float = quantity("torsional_damping", "torsional damping", 0.0, minimum=0.0)
    angle: float = quantity("angle", "angle of the first body relative to the second at zero torque", 0.0)
    play: float = quantity(
        "angle", "backlash: total angle within which the spring does not act", 0.0, minimum=0.0
    )
    torque: Law | None = key(
        "law",
        "additional torque on the first body: a formula of t, angle, speed (of the first body relative to "
        "the second), {table: [[angle, T], ...], over: angle} (periodic if it covers a full revolution), "
        "{python: 'file.py:function', parameters: [...]} with f(t, angle, parameters); the speed is "
        "appended to the parameters",
        None,
        dimension="torque",
    )
    stage: str | None = derived()
    """Scissor gear that contains the spring, if any."""


@dataclass(frozen=True, kw_only=True)
class TorsionMaxwell(Component):
    """Torsion spring and damper in series between two bodies; zero torque at the start."""

    bodies: tuple[str, ...] = key("names", TURNING, length=(1, 2))
    stiffness: float = positive("torsional_stiffness", "torsional stiffness of the spring")
    damping: float = positive("torsional_damping", "torsional damping of the damper")
