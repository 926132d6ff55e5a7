# SPDX-License-Identifier: Apache-2.0
"""Levels of orders of synthetic signals, and of a published A-weighting table."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.levels import a_weighting, level, radiated_power, reference_of
from pitchpoint.analysis.order_levels import order_levels
from pitchpoint.analysis.rattle import rattle_index
from pitchpoint.analysis.sampled import SignalError

TIME = np.arange(40_000) / 40_000.0
ANGLE = 2.0 * np.pi * (20.3 * TIME + 0.5 * TIME**2)  # no whole revolutions, 2 % faster at the end


def test_a_ripple_of_the_speed_does_not_spread_an_order():
    """The weights follow the angle: 2 % fluctuation at order 2 leaves the amplitude of order 23.5."""
    angle = ANGLE + 0.005 * np.sin(2.0 * ANGLE)
    values = 3.0 + 7.0 * np.cos(23.5 * angle + 0.4) + 2.0 * np.cos(19.0 * angle) + np.cos(47.0 * angle)
    found = order_levels(values, angle, TIME, order=23.5, reference=1e-6, harmonics=2)
    assert found.amplitude == pytest.approx([7.0, 1.0], rel=2e-3)
    assert found.level == pytest.approx(level(np.array([7.0, 1.0]) / np.sqrt(2.0), "N"), abs=0.02)
    assert found.frequency == pytest.approx(np.array([23.5, 47.0]) * 20.8, rel=1e-3)
    back = order_levels(values, -angle, TIME, order=23.5, reference=1e-6, harmonics=2)
    assert back.amplitude == pytest.approx(found.amplitude, rel=1e-9)


def test_a_weighted_levels():
    found = order_levels(np.cos(10.0 * ANGLE), ANGLE, TIME, order=10.0, reference=1.0, harmonics=1)
    heard = order_levels(
        np.cos(10.0 * ANGLE), ANGLE, TIME, order=10.0, reference=1.0, harmonics=1, a_weighted=True
    )
    assert heard.level - found.level == pytest.approx(a_weighting(found.frequency), abs=1e-12)
    assert heard.total == pytest.approx(heard.level[0], abs=1e-12)


def test_a_weighting_of_the_octave_bands():
    """IEC 61672-1:2013, table 3, rounded to 0.1 dB there; the exact frequencies are 1000 times 10^(0.3 n)."""
    printed = [-39.4, -26.2, -16.1, -8.6, -3.2, 0.0, 1.2, 1.0, -1.1, -6.6]
    exact = 1000.0 * 10.0 ** (0.3 * np.arange(-5, 5))
    assert a_weighting(exact) == pytest.approx(printed, abs=0.05)


def test_two_surfaces_add_their_power():
    both = radiated_power([1e-3, 2e-3], [0.5, 0.1])
    assert both == pytest.approx(413.0 * (0.5 * 1e-6 + 0.1 * 4e-6), rel=1e-12)
    assert reference_of("rad") == (1.0, "1 rad")


def test_an_idle_gear_that_never_slows_down_has_the_index_zero():
    assert rattle_index([1.0, 2.0, 0.5], 1e-3, 0.1) == 0.0


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"order": 0.05}, "use a longer record"),
        ({"harmonics": 200}, "use fewer harmonics"),
        ({"harmonics": 0}, "limit 1 or more"),
        ({"reference": 0.0}, "reference"),
    ],
)
def test_refused(change, message):
    options = {"order": 20.0, "reference": 1e-6, "harmonics": 2} | change
    with pytest.raises(SignalError, match=message):
        order_levels(np.cos(ANGLE), ANGLE, TIME, **options)
    with pytest.raises(SignalError, match="frequencies above 0"):
        a_weighting(0.0)
    with pytest.raises(SignalError, match="inertia"):
        rattle_index([1.0, 2.0], 0.0, 1.0)
    with pytest.raises(SignalError, match="area"):
        radiated_power([1.0], 0.0)
