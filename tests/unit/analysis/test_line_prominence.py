# SPDX-License-Identifier: Apache-2.0
"""Prominence of lines over the running median: levels of known tones, and probabilities in noise."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.line_prominence import line_prominence, order_prominence, prominence_probability
from pitchpoint.analysis.line_tests import line_probability
from pitchpoint.analysis.sampled import SignalError


def test_a_tone_has_the_level_of_its_power_over_the_median_of_noise() -> None:
    """Hann window: peak power A² (n/4)² over n s² 3/8 of noise, times ln 2 for the median."""
    n, amplitude = 20_000, 0.5
    levels = []
    for seed in range(20):
        x = np.random.default_rng(seed).standard_normal(n) + amplitude * np.cos(0.4 * np.pi * np.arange(n))
        found = line_prominence(x, 1.0, width=1000.0 / n)
        k = int(np.argmin(np.abs(found.frequency - 0.2)))
        assert np.argmax(found.prominence) == k
        assert found.amplitude[k] == pytest.approx(amplitude, abs=0.06)
        levels.append(found.prominence[k])
    expected = amplitude**2 * n / 6.0 / np.log(2.0)
    assert np.mean(levels) == pytest.approx(10.0 * np.log10(expected), abs=0.2)


@pytest.mark.parametrize("width, average", [(128, 1), (512, 1), (512, 3), (512, 9)])
def test_probabilities_hold_for_lines_of_noise(width: int, average: int) -> None:
    """At most 1.5 times the stated rate, and not below a tenth of it; 480 000 lines."""
    n = 60_000
    chance = np.concatenate(
        [
            line_prominence(
                np.random.default_rng(seed).standard_normal(n), 1.0, width=width / n, average=average
            ).probability
            for seed in range(16)
        ]
    )
    for level in (0.1, 0.01, 1e-3):
        assert 0.1 * level < np.mean(chance < level) < 1.5 * level


def test_the_noise_may_be_coloured() -> None:
    """A density that varies by 40 dB: as many lines above each limit as in white noise."""
    from scipy.signal import lfilter

    x = lfilter([1.0], [1.0, -1.6, 0.8], np.random.default_rng(3).standard_normal(200_000))
    found = line_prominence(x, 1.0)
    assert np.ptp(10.0 * np.log10(found.background)) > 10.0
    for level in (0.1, 0.01):
        assert 0.3 * level < np.mean(found.probability < level) < 1.3 * level


def test_for_many_points_the_order_statistic_gives_the_same_probability() -> None:
    """The exact law of an order statistic of independent points (Rohling 1983), of which half are counted."""
    for ratio in (5.0, 10.0):
        exact = line_probability(ratio, 50_000, 25_000)
        assert float(prominence_probability(ratio, 100_000)) == pytest.approx(exact, rel=1e-2)


def test_orders_are_those_of_the_shaft() -> None:
    turned = np.arange(64 * 300) / 64
    x = np.cos(2 * np.pi * 5.41 * turned) + np.random.default_rng(0).standard_normal(turned.size)
    found = order_prominence(x, 64, highest=8.0, width=1.0)
    assert found.frequency[-1] == pytest.approx(8.0, abs=0.01)
    assert found.frequency[np.argmax(found.prominence)] == pytest.approx(5.41, abs=0.002)


def test_a_widened_line_is_clearer_in_the_average() -> None:
    """Random phase of 0.06 per sample: a line of 23 lines width, clearer in a mean."""
    gain, n = [], 40_000
    for seed in range(10):
        rng = np.random.default_rng(seed)
        phase = 2 * np.pi * 0.1 * np.arange(n) + np.cumsum(rng.normal(0.0, 0.06, n))
        x = 0.12 * np.cos(phase) + rng.standard_normal(n)
        single, mean = (line_prominence(x, 1.0, width=0.02, average=m) for m in (1, 9))
        near = np.abs(single.frequency - 0.1) < 3e-4
        gain.append(np.log10(single.probability[near].min() / mean.probability[near].min()))
    assert np.mean(gain) > 2.0


def test_what_cannot_be_is_refused_in_words() -> None:
    x = np.random.default_rng(0).standard_normal(1000)
    with pytest.raises(SignalError, match=r"average: 4 lines \(limit: an odd number\); choose 5"):
        line_prominence(x, 1.0, average=4)
    with pytest.raises(SignalError, match=r"width: 10 lines \(limit 32\)"):
        line_prominence(x, 1.0, width=0.01)
    with pytest.raises(SignalError, match=r"limit 128, those of the median"):
        line_prominence(x[:200], 1.0)
