# SPDX-License-Identifier: Apache-2.0
"""Section of the model file: what a user writes about magnetic couplings. No numerics."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.keys import ends, positive, quantity
from pitchpoint.model.sections import Section


@dataclass(frozen=True, kw_only=True)
class MagnetCoupling(Component):
    """Rotors with magnets that pull each other into line."""

    bodies: tuple[str, str] = ends("names of the two bodies", length=(2, 2))
    stiffness: float = positive("torsional_stiffness", "torque per angle")
    damping: float = quantity("torsional_damping", "torque of eddy currents per slip", 0.0, minimum=0.0)

    @property
    def carries_torque(self) -> bool:
        """Whether the two bodies turn together: speeds at the start go through it."""
        return True


SECTION = Section(
    name="magnet_couplings",
    meaning="magnetic couplings between two bodies",
    component=MagnetCoupling,
    rules=("pitchpoint_magnets.rule:magnet_bank",),
)
