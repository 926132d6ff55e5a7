# SPDX-License-Identifier: Apache-2.0
"""Flexible rims of internal gears: section of the ring and its modes, from the data of the gear."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING

from pitchpoint.model.inertia import gear_by_geometry
from pitchpoint.multibody.ring_modes import RingMode, RingSection, ring_mode

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear


def ring_section(gear: Gear) -> RingSection:
    """Rim of an internal gear from the root circle outwards; the teeth add mass only.

    The outer radius is half the outside diameter `bore_diameter`, or follows from `rim_thickness`.
    """
    root = 0.5 * abs(gear.geometry.d_f)
    outer = 0.5 * gear.bore_diameter or root + (gear.rim_thickness or 0.0)
    data = gear.material_data
    bare = RingSection(
        inner=root,
        outer=outer,
        width=gear.face_width,
        youngs_modulus=data.youngs_modulus,
        poisson_ratio=data.poisson_ratio,
        density=data.density,
    )
    whole, polar, _ = gear_by_geometry(gear)
    mass = whole - bare.mass
    radius = math.sqrt((polar - 0.5 * bare.mass * (root**2 + outer**2)) / mass)
    return bare.with_teeth(mass, radius)


def rim_modes(gear: Gear) -> tuple[RingMode, ...]:
    """Modes of the flexible rim of a gear, free of supports; empty for a rigid rim."""
    if gear.flexible_rim is None:
        return ()
    return _modes(ring_section(gear), gear.flexible_rim.waves)


@lru_cache(maxsize=32)
def _modes(section: RingSection, waves: int) -> tuple[RingMode, ...]:
    return tuple(ring_mode(section, n) for n in range(2, waves + 1))
