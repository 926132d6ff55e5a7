# SPDX-License-Identifier: Apache-2.0
"""Fixed ratios between joint coordinates: gears without backlash, racks, belts, planetary gear sets."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.keys import key


class Arm(float):
    """A coefficient with the dimension of a length: travel per radian of rotation [m]."""


@dataclass(frozen=True, kw_only=True)
class Ratio(Component):
    """A linear constraint between coordinates: c1 q1 + c2 q2 (+ c3 q3) = constant.

    Gears: numbers of teeth (`{a: 20, b: 40}` rotate in opposite directions, `{a: 20, b: -40}` in the same
    direction). Belt: radii (`{a: 50 mm, b: -80 mm}`). Rack: pinion radius (`{pinion: 30 mm, rack.z: -1}`).
    Planetary gear set: `{sun: 24, planet: 18, carrier: -24}` with the spin of the planet on the carrier.
    """

    terms: Mapping[str, float] = key(
        "terms",
        "coefficients of two or three coordinates, named JOINT.COORDINATE, or BODY for its spin: plain "
        "numbers, or lengths for rotations that are coupled to translations (Arm in Python)",
    )
