# SPDX-License-Identifier: Apache-2.0
"""Elastic bushings between markers of two bodies."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.components.six import Damping6, Stiffness6
from pitchpoint.model.keys import component, key


@dataclass(frozen=True, kw_only=True)
class Bushing:
    """Spring and damper in six directions between two markers, for rotations up to half a turn."""

    ends: tuple[str, str] = key(
        "ends",
        "its two ends, bodies or BODY.MARKER, or one of them and ground, which is where the other is drawn; "
        "directions are those of the second, and without force both have the same place and directions",
        length=(2, 2),
    )
    stiffness: Stiffness6 = component(Stiffness6, "stiffness along and about the axes", Stiffness6())
    damping: Damping6 | None = component(Damping6, "damping in the same directions; not as a ratio")
