# SPDX-License-Identifier: Apache-2.0
"""Lines between the lines of a spectrum, and sidebands of modulated signals with closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import jv

from pitchpoint.analysis.harmonics import harmonic_table, read_tones
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.sidebands import sideband_table

TAU = 2.0 * np.pi
SHOVEL = (135.6666667, 20.0987654, 3.2512706)
"""Mesh frequencies of the mining shovel at 740 rpm [Hz]."""


def test_mesh_frequencies_of_the_shovel_from_four_seconds() -> None:
    """Lines 0.25 Hz apart, 8 % of the slowest mesh; each fundamental within 0.1 %, with harmonics and noise.

    The noise of 10 % of the amplitude of one tone moves a line by less than a hundredth of the distance of
    lines.
    """
    rate, t = 2000.0, np.arange(8000) / 2000.0
    x = 0.1 * np.random.default_rng(3).normal(size=t.size)
    for f in SHOVEL:
        x += sum(np.cos(TAU * k * f * t + k) / k for k in (1, 2, 3))
    for f in SHOVEL:
        table = harmonic_table(x, rate, 1.006 * f, harmonics=3)
        assert table.fundamental == pytest.approx(f, rel=1e-3)
        assert table.amplitude == pytest.approx([1.0, 1.0 / 2.0, 1.0 / 3.0], abs=0.02)
        assert np.all(table.amplitude > 10.0 * table.background)


@settings(max_examples=60)
@given(st.floats(20.0, 220.0), st.floats(0.0, 6.28), st.floats(1e-6, 1e6))
def test_a_tone_between_lines_is_read_exactly(f: float, phase: float, a: float) -> None:
    """Ten lines or more from zero the mirror image leaks 1e-4 into a line; amplitude and place follow
    that."""
    t = np.arange(1000) / 500.0
    found = read_tones(a * np.cos(TAU * f * t + phase), 500.0, [f], reach=0.6)
    assert found.is_peak[0]
    assert found.frequency[0] == pytest.approx(f, abs=2e-4 * 0.5)
    assert found.amplitude[0] == pytest.approx(a, rel=3e-4)


def test_the_flank_of_a_stronger_tone_is_no_peak() -> None:
    t = np.arange(1000) / 1000.0
    found = read_tones(np.cos(TAU * 100.3 * t), 1000.0, [98.0], reach=1.0)
    assert not found.is_peak[0]


def test_lost_harmonics_are_counted_or_refused_in_words() -> None:
    x = np.cos(TAU * 30.0 * np.arange(400) / 100.0)
    table = harmonic_table(x, 100.0, 30.0, harmonics=5)
    assert (table.harmonic.tolist(), table.lost) == ([1.0], 4)
    with pytest.raises(SignalError, match=r"is too low for any harmonic of 60 Hz \(limit > 120 Hz\)"):
        harmonic_table(x, 100.0, 60.0)
    with pytest.raises(SignalError, match=r"fundamental: 0.9 Hz.*line spacing of 0.25 Hz.*4.44 s or longer"):
        harmonic_table(x, 100.0, 0.9)
    with pytest.raises(SignalError, match="60 Hz is outside"):
        read_tones(x, 100.0, [60.0], reach=1.0)


def test_a_constant_signal_has_no_fundamental() -> None:
    table = harmonic_table(np.full(1000, 3.0), 100.0, 10.0)
    assert np.isnan(table.fundamental)
    assert not table.amplitude.any()


def test_sidebands_of_phase_modulation_are_bessel_functions() -> None:
    """cos(w t + b sin W t): J_n(b) at w + n W."""
    rate, t = 4000.0, np.arange(12000) / 4000.0
    b, f, w = 0.8, 501.3, 9.7
    x = 2.0 * np.cos(TAU * f * t + b * np.sin(TAU * w * t))
    table = sideband_table(x, rate, f, w, harmonics=1, sidebands=3)
    assert table.amplitude[0] == pytest.approx(2.0 * np.abs(jv(np.arange(-3, 4), b)), rel=2e-3)
    assert table.frequency[0] == pytest.approx(f + w * np.arange(-3, 4), abs=0.01)
    assert table.asymmetry[0] == pytest.approx(0.0, abs=3e-3)


def test_asymmetry_of_amplitude_and_phase_modulation_together() -> None:
    """(1 + m cos W t) cos(w t + b sin W t): J_n + m/2 (J_(n-1) + J_(n+1)) at w + n W."""
    rate, t = 4000.0, np.arange(16000) / 4000.0
    m, b, f, w = 0.5, 0.3, 480.0, 10.0
    x = (1.0 + m * np.cos(TAU * w * t)) * np.cos(TAU * f * t + b * np.sin(TAU * w * t))
    n = np.arange(-2, 3)
    closed = np.abs(jv(n, b) + 0.5 * m * (jv(n - 1, b) + jv(n + 1, b)))
    table = sideband_table(x, rate, f, w, harmonics=1, sidebands=2)
    assert table.amplitude[0] == pytest.approx(closed, rel=1e-6)
    assert table.level[0] == pytest.approx(20.0 * np.log10(closed / closed[2]), abs=1e-4)
    assert table.asymmetry[0, 0] == pytest.approx((closed[3] - closed[1]) / (closed[3] + closed[1]), rel=1e-6)
    assert table.ratio[0] == pytest.approx((closed.sum() - closed[2]) / closed[2], rel=1e-6)
    assert table.index[0] == pytest.approx(0.5 * (closed[1] + closed[3]), rel=1e-6)


def test_left_and_right_of_the_mesh_line_of_a_planet_set() -> None:
    """FD-SETS, SNU: 31/31(x3)/95, ring held; a planet fault shows as a left carrier sideband of 1.42 or
    more."""
    carrier = 3.7
    mesh = 95 * carrier
    rate, t = 4000.0, np.arange(12000) / 4000.0
    left, right = 1.6, 0.3
    x = sum(
        a * np.cos(TAU * f * t) for a, f in ((1.0, mesh), (left, mesh - carrier), (right, mesh + carrier))
    )
    table = sideband_table(x, rate, mesh, carrier, harmonics=1, sidebands=1)
    relative = 10.0 ** (table.level[0] / 20.0)
    assert (relative[0], relative[2]) == pytest.approx((left, right), rel=1e-3)
    assert table.asymmetry[0, 0] == pytest.approx((right - left) / (right + left), rel=1e-3)


def test_a_mesh_line_that_is_missing_does_not_move_the_sidebands() -> None:
    """Planets out of phase cancel the mesh line; its neighbours stay where they are looked for."""
    rate, t = 4000.0, np.arange(12000) / 4000.0
    x = 0.5 * np.cos(TAU * 396.0 * t) + 0.01 * np.random.default_rng(0).normal(size=t.size)
    table = sideband_table(x, rate, 400.0, 4.0, harmonics=1, sidebands=2)
    assert table.amplitude[0, 1] == pytest.approx(0.5, rel=0.01)
    assert np.delete(table.amplitude[0], 1).max() < 0.005


def test_records_too_short_for_the_sidebands_are_refused() -> None:
    x = np.cos(TAU * 50.0 * np.arange(1000) / 1000.0)
    with pytest.raises(SignalError, match=r"spacing: 2 Hz.*line spacing of 1 Hz.*2 s or longer"):
        sideband_table(x, 1000.0, 50.0, 2.0)
    with pytest.raises(SignalError, match=r"reach below zero from 50 Hz \(limit 4\)"):
        sideband_table(x, 1000.0, 50.0, 10.0, sidebands=5)
    with pytest.raises(SignalError, match="too low for any harmonic"):
        sideband_table(x, 1000.0, 490.0, 10.0, sidebands=3)
    assert sideband_table(x, 1000.0, 50.0, 10.0, harmonics=12).lost == 3


def test_sidebands_that_are_not_there_have_no_asymmetry() -> None:
    """A pure mesh line: what stands next to it is leakage and round-off, 1e-9 of it; in noise, noise."""
    rate, t = 4000.0, np.arange(12000) / 4000.0
    pure = np.cos(TAU * 400.0 * t)
    for x in (pure, pure + 0.01 * np.random.default_rng(0).normal(size=t.size)):
        table = sideband_table(x, rate, 400.0, 4.0, harmonics=2, sidebands=2)
        assert np.isnan(table.asymmetry).all()
    one = pure + 1e-4 * np.cos(TAU * 404.0 * t)
    table = sideband_table(one, rate, 400.0, 4.0, harmonics=1, sidebands=2)
    assert table.asymmetry[0, 0] == pytest.approx(1.0, abs=1e-3)
    assert np.isnan(table.asymmetry[0, 1])
