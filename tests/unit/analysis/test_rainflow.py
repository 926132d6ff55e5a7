# SPDX-License-Identifier: Apache-2.0
"""Rain-flow cycles, equivalent loads, load duration: ASTM E1049, closed forms, another implementation."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.rainflow import RainflowCounter, equivalent_load, load_duration, rainflow
from pitchpoint.analysis.sampled import SignalError

ASTM = [-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0]
"""ASTM E1049-85, figure 6."""


def waves(n=2000):
    k = np.arange(n)
    return np.sin(0.7 * k) + 0.6 * np.sin(1.9 * k + 1) + 0.3 * np.sin(0.13 * k * k)


def table(found):
    return {float(r): float(found.count[found.range == r].sum()) for r in np.unique(found.range)}


def test_series_of_astm():
    found = rainflow(ASTM)
    assert table(found) == {3.0: 0.5, 4.0: 1.5, 6.0: 0.5, 8.0: 1.0, 9.0: 0.5}
    assert found.mean[found.range == 9.0] == [0.5]
    assert table(rainflow(np.repeat(ASTM, 3))) == table(found)


def test_another_implementation():
    """The package rainflow 3.2.0 (P. Janiszewski, MIT): 548 cycles, ranges to the fourth and tenth power."""
    x = waves()
    assert rainflow(x, 4.0, 1000.0).equivalent == pytest.approx(1.9430230012250953, rel=1e-12)
    found = rainflow(x, 10.0, 1000.0)
    assert found.equivalent == pytest.approx(2.5902360853838533, rel=1e-12)
    assert found.count.sum() == 548.0
    assert found.range.max() == pytest.approx(3.758915042285488, rel=1e-15)


@pytest.mark.parametrize("slope", [3.0, 4.0, 10.0])
def test_sine(slope):
    """n cycles of the amplitude A: DEL = 2 A (n/N)^(1/m); a record that ends at its mean has half cycles."""
    x = 7.0 + 3.0 * np.sin(2.0 * np.pi * np.arange(20 * 400 + 1) / 400.0)
    found = rainflow(x, slope, 1e6, "repeated")
    assert found.count.sum() == 20.0
    assert found.equivalent == pytest.approx(6.0 * (20.0 / 1e6) ** (1.0 / slope), rel=1e-12)
    halves = rainflow(x, slope, 1e6)
    lost = 0.5 * (3.0**slope + 3.0**slope) / 6.0**slope  # half a range at both ends in place of half a cycle
    assert halves.equivalent == pytest.approx(6.0 * ((19.5 + lost) / 1e6) ** (1.0 / slope), rel=1e-12)


def test_parts_of_a_record_are_counted_like_the_whole():
    x = waves()
    whole, parts = RainflowCounter(), RainflowCounter()
    whole.add(x)
    for k in range(0, x.size, 7):
        parts.add(x[k : k + 7])
    assert np.array_equal(whole.closed, parts.closed) and np.array_equal(whole.open, parts.open)


def test_repeated_residue_is_that_of_a_recurring_record():
    """Three more repetitions have three more times the cycles that the residue option closes."""
    x = waves(500)
    once, four = rainflow(x, residue="repeated"), rainflow(np.tile(x, 5), residue="repeated")
    assert four.count.sum() == 5 * once.count.sum()
    n = once.count.sum()
    assert four.equivalent == pytest.approx(once.equivalent, rel=1e-12) and n > 100


def test_constant_load():
    assert rainflow([2.0, 2.0, 2.0]).equivalent == 0.0
    assert equivalent_load([0.0], [3.0], 4.0, 1.0) == 0.0
    found = load_duration(np.full(10, 40e3), np.full(10, 0.1), bins=5)
    assert found.share.max() == 1.0 and np.count_nonzero(found.share) == 1
    assert found.level[found.share == 1.0] == pytest.approx([40e3], rel=1e-4)


def test_a_load_constant_except_for_rounding():
    """Classes between values a few units in the last place apart would not be distinct."""
    for value in (40e3, 1.0, 1e-9, 1e12):
        x = np.array([value, np.nextafter(value, 2.0 * value), np.nextafter(value, 0.0)])
        found = load_duration(x, bins=50)
        assert found.share.sum() == pytest.approx(1.0) and found.level[found.share > 0].max() / value < 2e9


def test_two_open_points_are_one_cycle_of_a_recurring_load():
    found = rainflow([0.0, 2.0], residue="repeated")
    assert found.count.tolist() == [1.0] and found.range.tolist() == [2.0]


def test_revolutions_as_weights():
    """Half of the time at a tenth of the speed is 1/11 of the revolutions."""
    torque = np.repeat([10.0, 50.0], 100)
    found = load_duration(torque, np.repeat([1.0, 0.1], 100), bins=2)
    assert found.share == pytest.approx([10 / 11, 1 / 11])
    assert found.exceeded[0] == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: rainflow([1.0, np.nan]), "finite"),
        (lambda: rainflow([1.0, 2.0], residue="none"), "residue"),
        (lambda: rainflow([1.0, 2.0], slope=0.0), "slope"),
        (lambda: rainflow([1.0, 2.0], cycles=-1.0), "cycles"),
        (lambda: load_duration([1.0, 2.0], [1.0]), "weight"),
    ],
)
def test_what_is_refused(call, words):
    with pytest.raises(SignalError, match=words):
        call()
