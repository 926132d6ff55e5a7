# SPDX-License-Identifier: Apache-2.0
"""A pair of bevel gears in mesh: backlash, stiffness, damping and friction."""

from __future__ import annotations

import math
from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.mesh import Backlash, ContactDamping, Damper, Friction, TransientDamping
from pitchpoint.model.components.stiffness import BEVEL_LAWS, BevelDin3990, BevelStiffnessLaw
from pitchpoint.model.keys import component, key, quantity


@dataclass(frozen=True, kw_only=True)
class BevelMesh(Component):
    """Two bevel gears in mesh; their bodies are placed so that both apexes coincide."""

    gears: tuple[str, str] = key(
        "names", "names of bevel gear 1 and bevel gear 2", length=(2, 2), names="bevel_gears"
    )
    shaft_angle: float | None = quantity(
        "angle",
        "shaft angle, between the directions from the apex into the gears",
        None,
        minimum=math.radians(1.0),
        maximum=math.radians(179.0),
        display="sum of both pitch cone angles",
    )
    backlash: Backlash | None = component(
        Backlash, "total gap at the mean cone distance, instead of that from geometry"
    )
    stiffness: BevelStiffnessLaw = key(
        "variant", "mesh stiffness", BevelDin3990(), of=BEVEL_LAWS, display="law: din3990"
    )
    damping: ContactDamping | None = component(ContactDamping, "damping of flanks in contact")
    damper: Damper | None = component(Damper, "damper that also acts within the backlash")
    transient_damping: TransientDamping | None = component(
        TransientDamping, "damper for the start of a run", later=True
    )
    friction: Friction | None = component(Friction, "sliding friction of the flanks")

    @property
    def law(self) -> BevelStiffnessLaw:
        """Stiffness law."""
        return self.stiffness
