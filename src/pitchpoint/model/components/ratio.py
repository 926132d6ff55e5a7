# SPDX-License-Identifier: Apache-2.0
"""Fixed ratios between coordinates of joints: gears without play, racks, belts, planet sets."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.model.keys import key


class Arm(float):
    """A coefficient that is a length: the way per radian of a turn [m]."""


@dataclass(frozen=True, kw_only=True)
class Ratio:
    """A sum of coordinates that keeps its value: c1 q1 + c2 q2 (+ c3 q3) = constant.

    Gears take their numbers of teeth (`{a: 20, b: 40}` turn against each other, `{a: 20, b: -40}` the same
    way), a belt the radii (`{a: 50 mm, b: -80 mm}`), a rack its radius (`{pinion: 30 mm, rack.z: -1}`),
    planets `{sun: 24, planet: 18, carrier: -24}` with the spin of the planet on the carrier.
    """

    terms: Mapping[str, float] = key(
        "terms",
        "coefficients of two or three coordinates, each named as JOINT.COORDINATE, or by a body for its "
        "spin: plain numbers, or lengths for turns that go with travels (Arm in Python)",
    )
