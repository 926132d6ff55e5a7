# SPDX-License-Identifier: Apache-2.0
"""Parts of a mean turn and the indicators made of them, against closed forms."""

from __future__ import annotations

from math import factorial, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.analysis.gear_indicators import (
    gear_indicators,
    na4,
    nb4,
    running_kurtosis,
    teager_kaiser_energy,
)
from pitchpoint.analysis.gear_signals import gear_signals, mesh_envelope
from pitchpoint.analysis.indicators import signal_indicators, standardised_moment
from pitchpoint.analysis.sampled import SignalError
from tests.support.gear_vibration import mesh_vibration, tooth_pulse

ANGLE = 2.0 * np.pi * np.arange(1024) / 1024
NOISE = np.random.default_rng(7).standard_normal(1_000_000)


@pytest.mark.parametrize("order", [4, 6, 8])
def test_moments_of_gaussian_noise(order: int) -> None:
    """(k - 1)!! = 3, 15, 105; the estimate scatters by √((2k - 1)!! - ...)/√n, here below √((2k - 1)!!/n)."""
    expected = factorial(order) // (2 ** (order // 2) * factorial(order // 2))
    scatter = sqrt(factorial(2 * order) / (2**order * factorial(order)) / NOISE.size)
    assert standardised_moment(NOISE, order) == pytest.approx(expected, abs=3.0 * scatter)


@pytest.mark.parametrize(("order", "expected"), [(4, 3 / 2), (6, 5 / 2), (8, 35 / 8)])
def test_moments_of_a_sine(order: int, expected: float) -> None:
    assert standardised_moment(1e-9 * np.sin(5 * ANGLE) + 3e-7, order) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("order", [4, 6, 8])
@pytest.mark.parametrize("n", [10, 1000])
def test_moments_of_one_impulse(order: int, n: int) -> None:
    """A value that is taken once in n samples is a Bernoulli variable of p = 1/n, whatever its height."""
    x = np.zeros(n)
    x[n // 3] = -0.037
    p = 1.0 / n
    moment = p * (1 - p) * ((1 - p) ** (order - 1) + p ** (order - 1))
    assert standardised_moment(x, order) == pytest.approx(moment / (p * (1 - p)) ** (order / 2), rel=1e-12)
    if order == 4:
        assert standardised_moment(x, 4) == pytest.approx(n - 2 + 1 / (n - 1), rel=1e-12)


def test_level_and_shape_of_square_triangle_and_impulse() -> None:
    square = signal_indicators(np.tile([3.0, 1.0], 50))
    assert (square.rms, square.peak, square.peak_to_peak) == (1.0, 1.0, 2.0)
    assert (square.kurtosis, square.crest_factor, square.shape_factor, square.impulse_factor) == (1, 1, 1, 1)
    # uniform distribution: kurtosis 9/5, crest √3, shape 2/√3, impulse 2
    ramp = signal_indicators((np.arange(10_000) + 0.5) / 10_000)
    found = (ramp.kurtosis, ramp.crest_factor, ramp.shape_factor, ramp.impulse_factor)
    assert found == pytest.approx((1.8, sqrt(3), 2 / sqrt(3), 2), rel=2e-4)
    impulse = signal_indicators(np.eye(1, 100)[0] * 5.0)
    # peak 5 (1 - 1/n), rms 5 √(1 - 1/n)/√n, mean magnitude 2·5 (1 - 1/n)/n
    assert impulse.crest_factor == pytest.approx(sqrt(100 - 1), rel=1e-12)
    assert impulse.impulse_factor == pytest.approx(100 / 2, rel=1e-12)


@given(st.integers(0, 2**31 - 1), st.floats(1e-12, 1e12), st.floats(-10, 10), st.integers(0, 255))
def test_shape_knows_neither_unit_nor_mean_nor_origin(
    seed: int, scale: float, offset: float, turn: int
) -> None:
    x = np.random.default_rng(seed).normal(size=256)
    one, other = signal_indicators(x), signal_indicators(scale * (offset + np.roll(x, turn)))
    for name in ("kurtosis", "crest_factor", "shape_factor", "impulse_factor"):
        assert getattr(other, name) == pytest.approx(getattr(one, name), rel=1e-9)
    assert other.rms == pytest.approx(scale * one.rms, rel=1e-9)


@given(st.integers(0, 2**31 - 1), st.integers(32, 301), st.integers(4, 15))
def test_parts_add_up_and_share_no_order(seed: int, n: int, teeth: int) -> None:
    x = np.random.default_rng(seed).normal(size=n) + 2.0
    parts = gear_signals(x, teeth=teeth)
    np.testing.assert_allclose(parts.regular + parts.residual + x.mean(), x, atol=1e-12)
    lines = {name: np.abs(np.fft.rfft(getattr(parts, name))) for name in ("residual", "difference")}
    order = np.arange(n // 2 + 1)
    mesh = (order % teeth == 0) | (order <= 2)
    beside = (order % teeth == 1) | (order % teeth == teeth - 1)
    assert lines["residual"][mesh].max() < 1e-10
    assert lines["difference"][mesh | beside].max() < 1e-10
    whole = np.abs(np.fft.rfft(x))
    np.testing.assert_allclose(lines["residual"][~mesh], whole[~mesh], atol=1e-10)
    kept = ~(mesh | beside)
    np.testing.assert_allclose(lines["difference"][kept], whole[kept], atol=1e-10)
    np.testing.assert_array_equal(parts.mesh_orders, order[(order % teeth == 0) & (order > 0)])


def test_two_gears_of_a_shaft_are_both_regular() -> None:
    x = np.cos(96 * ANGLE) + np.cos(48 * ANGLE + 1.0) + 0.1 * np.cos(31 * ANGLE)
    parts = gear_signals(x, teeth=[96, 48])
    np.testing.assert_allclose(parts.residual, 0.1 * np.cos(31 * ANGLE), atol=1e-12)


def test_indicators_of_a_damaged_tooth() -> None:
    """FM4 of a healthy gear is that of noise; one bad tooth raises it; damage all around does not."""
    healthy = mesh_vibration(ANGLE, 20, modulation=0.05) + 0.02 * NOISE[:1024]
    pulse = 0.5 * tooth_pulse(ANGLE, 20, tooth=6) * np.cos(110 * ANGLE)
    one_tooth = healthy + pulse
    all_teeth = mesh_vibration(ANGLE, 20, modulation=0.05) + 0.2 * NOISE[:1024]
    # kurtosis of 900 free lines of noise scatters by √(24/900) = 0.16
    for x in (healthy, all_teeth):
        found = gear_indicators(x, teeth=20)
        assert found.fm4 == pytest.approx(3.0, abs=0.5)
        assert found.m6a == pytest.approx(15.0, abs=7.0)
    worn = gear_indicators(one_tooth, teeth=20)
    assert worn.fm4 > 15.0
    assert worn.m6a > 15.0 * worn.fm4
    assert worn.m8a > worn.m6a
    assert worn.energy_operator > 15.0


def test_na4_rises_where_fm4_does_not() -> None:
    """Damage all around: ten times the noise after three good records, K 10⁴/((3 + 100)/4)² and K 10⁴."""
    healthy, worn = (mesh_vibration(ANGLE, 20) + level * NOISE[:1024] for level in (0.02, 0.2))
    history = [healthy, healthy, healthy, worn]
    kurtosis = standardised_moment(gear_signals(worn, teeth=20).residual, 4)
    assert na4(history, teeth=20).value[-1] == pytest.approx(kurtosis * 1e4 / 25.75**2, rel=1e-9)
    assert na4(history, teeth=20, good_records=3).value[-1] == pytest.approx(kurtosis * 1e4, rel=1e-9)
    assert na4(history, teeth=20).value[0] == pytest.approx(kurtosis, rel=1e-9)


def test_fm0_and_sidebands_of_a_modulated_mesh() -> None:
    """(1 + m cos θ) cos zθ, m = 1/4: peak to peak 2 (1 + m) at most, sidebands m/2 each, σ² = 1/2 + m²/4."""
    x = (1.0 + 0.25 * np.cos(ANGLE)) * np.cos(64 * ANGLE) + 1e-6 * NOISE[:1024]
    found = gear_indicators(x, teeth=64)
    # trough half a tooth next to the crest: 1 + m cos(π/64)
    assert found.fm0 == pytest.approx(1.25 + 1.0 + 0.25 * np.cos(np.pi / 64), rel=1e-4)
    assert found.sideband_level_factor == pytest.approx(0.25 / sqrt(0.5 + 0.25**2 / 4), rel=1e-4)


def test_energy_of_an_impulse_and_of_a_sine() -> None:
    x = np.zeros(50)
    x[49] = 3.0
    np.testing.assert_array_equal(teager_kaiser_energy(x), 3.0 * x)
    np.testing.assert_allclose(
        teager_kaiser_energy(2.0 * np.cos(9 * ANGLE)), 4.0 * np.sin(9 * ANGLE[1]) ** 2, rtol=1e-9
    )


@pytest.mark.parametrize("growth", [1.0, 3.0])
@pytest.mark.parametrize("m", [1, 2, 10])
def test_na4_of_a_record_that_grew(growth: float, m: int) -> None:
    """m - 1 records and one c times as large: K c⁴/(((m - 1) + c²)/m)²; by the good ones K c⁴."""
    sine = np.sin(7 * ANGLE)
    records = [sine] * (m - 1) + [growth * sine]
    found = running_kurtosis(records)
    assert found.value[-1] == pytest.approx(1.5 * growth**4 / ((m - 1 + growth**2) / m) ** 2)
    assert found.variance[-1] == pytest.approx(0.5 * growth**2)
    if m > 1:
        star = running_kurtosis(records, good_records=m - 1)
        assert star.value[-1] == pytest.approx(1.5 * growth**4)
        np.testing.assert_allclose(star.reference, 0.5)


def test_envelope_keeps_amplitude_and_forgets_phase() -> None:
    """Modulation up to nine orders of a gear of 20 teeth, in amplitude and in phase."""
    envelope = 1.0 + 0.3 * np.cos(2 * ANGLE) + 0.1 * np.sin(4 * ANGLE)
    x = envelope * np.cos(40 * ANGLE + 1.0) + 2.0 * np.cos(20 * ANGLE)
    np.testing.assert_allclose(mesh_envelope(x, teeth=20, harmonic=2), envelope, atol=1e-12)
    np.testing.assert_allclose(mesh_envelope(x, teeth=20, half_width=0), 2.0, atol=1e-12)
    assert nb4([x, x], teeth=20, harmonic=2).value[1] == pytest.approx(standardised_moment(envelope, 4))


def test_records_without_meaning_are_refused() -> None:
    mesh = mesh_vibration(ANGLE, 20)
    for message, wrong in [
        ("residual signal is only round-off", lambda: gear_indicators(mesh, teeth=20)),
        ("residual signal is only round-off", lambda: na4([mesh], teeth=20)),
        ("average: is constant at 2", lambda: gear_indicators(np.full(64, 2.0), teeth=20)),
        ("has no harmonic of 21 teeth", lambda: gear_indicators(np.cos(5 * ANGLE), teeth=21)),
        ("1024 samples per revolution are too few for 512 teeth", lambda: gear_signals(mesh, teeth=512)),
        ("teeth: 3 .limit: a whole number >= 4", lambda: gear_signals(mesh, teeth=3)),
        ("every order is a mesh harmonic", lambda: gear_signals(NOISE[:16], teeth=[4, 6])),
        ("order: 5 .limit an even number", lambda: standardised_moment(mesh, 5)),
        ("records: none", lambda: running_kurtosis([])),
        ("good_records: 3 .limit 1 to 2", lambda: running_kurtosis([mesh, mesh], good_records=3)),
        ("record 1: is constant", lambda: running_kurtosis([mesh, np.ones(9)])),
        ("orders 991 to 1009 .limit 1 to below 512", lambda: mesh_envelope(mesh, teeth=20, harmonic=50)),
        ("is constant at 4", lambda: signal_indicators(np.full(9, 4.0))),
    ]:
        with pytest.raises(SignalError, match=message):
            wrong()
