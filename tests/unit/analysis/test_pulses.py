# SPDX-License-Identifier: Apache-2.0
"""Pulses of a shaft."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.pulses import pulse_times, tacho_levels
from pitchpoint.analysis.sampled import SignalError


def test_times_of_a_run_up_against_its_closed_form() -> None:
    """angle = a t^2/2: pulse k begins at sqrt(2 (2 pi k/p)/a).

    A straight line over a step h misses it by at most a h^2/8 in angle, over the speed there in time.
    """
    a, per_turn, h = 200.0, 10, 1e-4
    t = np.arange(0.0, 1.0, h)
    found = pulse_times(t, 0.5 * a * t**2, per_turn)
    k = np.arange(1, found.size + 1)
    wanted = np.sqrt(2.0 * (2.0 * np.pi * k / per_turn) / a)
    assert found.size == int(0.5 * a * t[-1] ** 2 * per_turn / (2.0 * np.pi))
    assert np.all(np.abs(found - wanted) <= a * h**2 / 8.0 / (a * wanted) + 1e-12)


def test_several_pulses_between_two_samples_and_backwards() -> None:
    t = np.array([0.0, 1.0])
    np.testing.assert_allclose(
        pulse_times(t, np.array([0.1, 0.1 + 2.0 * np.pi]), 4),
        [0.234085, 0.484085, 0.734085, 0.984085],
        atol=1e-6,
    )
    back = pulse_times(t, -np.array([0.1, 0.1 + 2.0 * np.pi]), 4)
    np.testing.assert_allclose(back, [0.234085, 0.484085, 0.734085, 0.984085], atol=1e-6)


def test_half_of_the_angle_is_high() -> None:
    levels = tacho_levels(np.linspace(-40.0, 40.0, 100001), 7)
    assert set(levels.tolist()) == {0, 1}
    assert abs(levels.mean() - 0.5) < 0.01  # 89 pulses, of which one at each end may be cut


def test_what_cannot_be_counted() -> None:
    with pytest.raises(SignalError, match="cannot be counted"):
        tacho_levels(np.zeros(3), 0)
    with pytest.raises(SignalError, match="there are 2 times"):
        pulse_times(np.zeros(2), np.zeros(3), 1)
