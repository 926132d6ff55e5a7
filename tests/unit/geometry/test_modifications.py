# SPDX-License-Identifier: Apache-2.0
"""Intended micro-geometry: shapes, signs, places."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.modifications import (
    EndRelief,
    FlankModifications,
    Relief,
    base_tangent,
    deviation,
    flank_range,
    modification_problems,
    roll_length,
)

GEAR = CylindricalGear(z=50, m_n=3e-3, b=0.02)
RING = CylindricalGear(z=-80, m_n=3e-3, b=0.02)
MICRO = 1e-6


@pytest.mark.parametrize("gear", [GEAR, RING], ids=["external", "internal"])
@pytest.mark.parametrize(("shape", "half"), [("linear", 5.0), ("parabolic", 2.5)])
@pytest.mark.parametrize("end", ["tip_relief", "root_relief"])
def test_relief_grows_to_the_end_of_the_flank(
    gear: CylindricalGear, shape: str, half: float, end: str
) -> None:
    root, tip = flank_range(gear)
    last, other = (tip, root) if end == "tip_relief" else (root, tip)
    inward = math.copysign(1.0, other - last)
    relief = Relief(amount=10 * MICRO, length=4e-3, shape=shape)
    places = last + inward * np.array([0.0, 2e-3, 4e-3, 5e-3])
    removed = deviation(FlankModifications(**{end: relief}), gear, places)
    assert removed / MICRO == pytest.approx([10.0, half, 0.0, 0.0], abs=1e-9)


@pytest.mark.parametrize("gear", [GEAR, RING], ids=["external", "internal"])
def test_relief_by_diameter_is_relief_by_length(gear: CylindricalGear) -> None:
    start = 0.5 * (abs(gear.d) + abs(gear.d_Fa))
    length = abs(float(roll_length(gear, start)) - flank_range(gear)[1])
    roll = np.linspace(*flank_range(gear), 31)
    by_d, by_l = (
        deviation(FlankModifications(tip_relief=Relief(amount=10 * MICRO, **k)), gear, roll)
        for k in ({"start_diameter": start}, {"length": length})
    )
    assert by_d == pytest.approx(by_l, abs=1e-18)
    assert deviation(
        FlankModifications(tip_relief=Relief(amount=10 * MICRO, start_diameter=start)),
        gear,
        [start],
        coordinate="diameter",
    ) == pytest.approx([0.0], abs=1e-18)


def test_crownings_and_slopes() -> None:
    root, tip = flank_range(GEAR)
    roll = np.array([root, 0.5 * (root + tip), tip])
    z = np.array([-0.01, 0.0, 0.01])
    assert deviation(FlankModifications(profile_crowning=4 * MICRO), GEAR, roll) / MICRO == pytest.approx(
        [4.0, 0.0, 4.0], abs=1e-9
    )
    assert deviation(FlankModifications(lead_crowning=4 * MICRO), GEAR, roll[1], z) / MICRO == pytest.approx(
        [4.0, 0.0, 4.0], abs=1e-9
    )
    # positive slopes add material towards the tip and towards +z
    assert deviation(FlankModifications(profile_slope=4 * MICRO), GEAR, roll) / MICRO == pytest.approx(
        [2.0, 0.0, -2.0], abs=1e-9
    )
    assert deviation(FlankModifications(helix_slope=4 * MICRO), GEAR, roll[1], z) / MICRO == pytest.approx(
        [2.0, 0.0, -2.0], abs=1e-9
    )


def test_end_relief() -> None:
    z = np.array([-0.01, -0.009, -0.008, 0.0, 0.009, 0.01])
    ends = FlankModifications(end_relief=EndRelief(amount=8 * MICRO, length=2e-3, shape="parabolic"))
    assert deviation(ends, GEAR, 0.025, z) / MICRO == pytest.approx([8, 2, 0, 0, 2, 8], abs=1e-9)


def test_base_tangent_conversion_is_the_inverse_of_the_normal_one() -> None:
    for beta in (0.0, 0.2, -0.4):
        gear = CylindricalGear(z=30, m_n=2e-3, beta=beta)
        expected = 1.0 / math.sqrt(1.0 - (math.sin(beta) * math.cos(gear.alpha_n)) ** 2)
        assert float(base_tangent(1.0, gear)) == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize(
    "make",
    [
        lambda: Relief(amount=-1e-6, length=1e-3),
        lambda: Relief(amount=1e-6),
        lambda: Relief(amount=1e-6, length=1e-3, start_diameter=0.1),
        lambda: Relief(amount=1e-6, length=1e-3, shape="cubic"),
        lambda: EndRelief(amount=1e-6, length=0.0),
        lambda: FlankModifications(lead_crowning=math.nan),
        lambda: deviation(FlankModifications(tip_relief=Relief(amount=1e-6, start_diameter=1.0)), GEAR, 0.02),
        lambda: deviation(FlankModifications(tip_relief=Relief(amount=1e-6, length=1.0)), GEAR, 0.02),
        lambda: deviation(FlankModifications(), GEAR, 0.02, coordinate="angle"),
    ],
)
def test_nonsense_is_refused(make) -> None:
    with pytest.raises(GeometryError):
        make()


@pytest.mark.parametrize("gear", [GEAR, RING], ids=["external", "internal"])
def test_every_part_that_does_not_fit_is_named(gear: CylindricalGear) -> None:
    root, tip = sorted((abs(gear.d_Ff), abs(gear.d_Fa)))
    wrong = FlankModifications(
        tip_relief=Relief(amount=MICRO, start_diameter=1.01 * tip),
        root_relief=Relief(amount=MICRO, length=1.01 * abs(np.diff(flank_range(gear))[0])),
        end_relief=EndRelief(amount=MICRO, length=0.011),
    )
    found = modification_problems(wrong, gear, "left")
    assert [p.where for p in found] == [
        "left.tip_relief.start_diameter",
        "left.root_relief.length",
        "left.end_relief.length",
    ]
    assert all(p.value and p.limit and p.remedy for p in found)
    inside_base = FlankModifications(root_relief=Relief(amount=MICRO, start_diameter=0.9 * root))
    assert len(modification_problems(inside_base, gear)) == 1
    whole = FlankModifications(
        tip_relief=Relief(amount=MICRO, start_diameter=abs(gear.d_Ff)),
        root_relief=Relief(amount=MICRO, length=abs(float(np.diff(flank_range(gear))[0]))),
        end_relief=EndRelief(amount=MICRO, length=0.01),
    )
    assert modification_problems(whole, gear) == []
