# SPDX-License-Identifier: Apache-2.0
"""Elastic bushings between markers of two bodies."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.components.six import Damping6, Stiffness6
from pitchpoint.model.keys import component, ends


@dataclass(frozen=True, kw_only=True)
class Bushing:
    """Linear spring and damper in six directions, for rotations up to half a turn.

    It is without force where its ends meet and stand to each other as the file places the bodies.
    """

    ends: tuple[str, str] = ends(
        "its two ends; the axes are those of the second, each is ground, a body or BODY.MARKER", length=(2, 2)
    )
    stiffness: Stiffness6 = component(Stiffness6, "stiffness along and about the axes", Stiffness6())
    damping: Damping6 | None = component(Damping6, "damping likewise, without ratio")
