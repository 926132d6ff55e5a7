# SPDX-License-Identifier: Apache-2.0
"""Elastic bushings between markers of two bodies."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.six import Damping6, Stiffness6
from pitchpoint.model.keys import component, derived, key


@dataclass(frozen=True, kw_only=True)
class Bushing(Component):
    """Spring and damper in six directions between two markers, for rotations up to half a revolution."""

    ends: tuple[str, str] = key(
        "ends",
        "the two ends: bodies, BODY.MARKER, or one of these and ground, which takes the initial position of "
        "the other. The axes are those of the second end; the bushing is free of force when the two coincide",
        length=(2, 2),
    )
    stiffness: Stiffness6 = component(
        Stiffness6, "stiffness along and about the axes of the second end", Stiffness6()
    )
    damping: Damping6 | None = component(Damping6, "damping in the same directions; not a ratio")
    of_housing: bool = derived(False)
    """Whether the bushing is a mount of the housing of the model."""
