# SPDX-License-Identifier: Apache-2.0
"""Crossings of orders and modes; amplification of forced vibration."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.amplification import amplification_factor, load_factors
from pitchpoint.analysis.campbell import campbell_crossings
from pitchpoint.analysis.sampled import SignalError


def test_crossings_of_constant_modes() -> None:
    """f = z n: speed = 2π f/z, for every mode and harmonic."""
    found = campbell_crossings(np.linspace(0.0, 700.0, 15), [1000.0, 2500.0], [25, 50])
    expected = sorted((2 * np.pi * f / z, z, k) for k, f in enumerate([1000.0, 2500.0]) for z in (25.0, 50.0))
    assert [(c.order, c.mode) for c in found] == [(z, k) for _, z, k in expected]
    np.testing.assert_allclose([c.speed for c in found], [s for s, _, _ in expected])


def test_crossings_with_modes_that_change_with_speed() -> None:
    speed = np.array([0.0, 100.0])
    (crossing,) = campbell_crossings(speed, np.array([[100.0], [200.0]]), [2 * np.pi * 3.0])
    assert crossing.speed == pytest.approx(50.0)  # 100 + w = 3 w
    assert crossing.frequency == pytest.approx(150.0)


def test_crossing_on_a_sample_counts_once_and_gaps_do_not_cross() -> None:
    speed = np.array([0.0, 10.0, 20.0])
    assert len(campbell_crossings(speed, [10.0], [2 * np.pi])) == 1
    assert campbell_crossings(speed, np.array([[5.0], [np.nan], [5.0]]), [2 * np.pi]) == ()
    assert campbell_crossings(speed, np.empty((3, 0)), [1.0]) == ()


def test_crossings_have_the_names_of_their_orders_and_damping() -> None:
    """f = 40 + w^2/2000 against w/pi: w^2 - 2000 w/pi + 8e4 = 0; 0.1 Hz off with chords."""
    speed = np.arange(0.0, 301.0, 25.0)
    curve = (40.0 + speed**2 / 2000.0)[:, None]
    (one,) = campbell_crossings(speed, curve, {"2x": 2.0}, 0.01 + curve / 1e4)
    exact = 1000.0 / np.pi - np.sqrt((1000.0 / np.pi) ** 2 - 8e4)
    assert one.speed == pytest.approx(exact, rel=1e-4)
    assert one.name == "2x"
    assert one.damping_ratio == pytest.approx(0.01 + one.frequency / 1e4, rel=1e-2)


def test_campbell_input_is_checked() -> None:
    with pytest.raises(SignalError, match="orders"):
        campbell_crossings([0.0, 1.0], [1.0], [0.0])
    with pytest.raises(SignalError, match="both must come"):
        campbell_crossings([0.0, 1.0], np.ones((3, 1)), [1.0])


def test_amplification_of_the_linear_oscillator() -> None:
    """Peak 1/(2ζ√(1-ζ²)) at η = √(1-2ζ²)."""
    zeta = 0.1
    peak = 1 / (2 * zeta * np.sqrt(1 - zeta**2))
    assert amplification_factor(np.sqrt(1 - 2 * zeta**2), zeta) == pytest.approx(peak)
    assert np.isinf(amplification_factor(1.0, 0.0))
    with pytest.raises(SignalError, match="damping_ratio"):
        amplification_factor(1.0, -0.1)


def test_load_factors_with_negative_mean() -> None:
    """Back-flank drive has negative forces; factors are the same."""
    force = 100.0 + 40.0 * np.cos(np.linspace(0.0, 2 * np.pi, 64, endpoint=False))
    assert load_factors(-force) == load_factors(force)
    assert load_factors(force, 70.0).dynamic_factor == pytest.approx(2.0)
    with pytest.raises(SignalError, match="static_force"):
        load_factors([1.0, -1.0])
