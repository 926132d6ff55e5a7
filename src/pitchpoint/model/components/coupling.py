# SPDX-License-Identifier: Apache-2.0
"""A linear coupling or short shaft between two bodies."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.six import Damping6, Stiffness6
from pitchpoint.model.keys import component, derived, key, quantities


@dataclass(frozen=True, kw_only=True)
class Coupling(Component):
    """Linear spring and damper in six directions between two bodies on one axis.

    Bodies on different axes can be coupled in torsion only, or if neither has lateral motion. With inclined
    axes the coupling transmits torque like a constant-velocity joint.
    """

    bodies: tuple[str, str] = key(
        "names",
        "names of the two bodies; a body without position is located at the coupling, one without axes takes "
        "those of the other",
        length=(2, 2),
        names="bodies",
        also=("ends",),
    )
    position: tuple[float, float, float] = quantities(
        "length",
        "centre of the coupling relative to the origin of the first body, on its axis: [0, 0, z]",
        (0.0, 0.0, 0.0),
        length=(3, 3),
    )
    stiffness: Stiffness6 = component(
        Stiffness6, "stiffness against relative displacement and rotation", Stiffness6()
    )
    damping: Damping6 | None = component(Damping6, "damping in the same directions, or a damping ratio")
    stage: str | None = derived()
    """Scissor gear that contains the coupling, if any."""

    @property
    def carries_torque(self) -> bool:
        """Whether the coupling transmits torque: its torsional stiffness is not zero."""
        return self.stiffness.matrix6()[5][5] > 0.0
