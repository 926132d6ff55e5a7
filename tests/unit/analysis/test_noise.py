# SPDX-License-Identifier: Apache-2.0
"""Noise: level, seed, whiteness."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pitchpoint.analysis.noise import white_noise, with_white_noise
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.spectra import power_spectral_density

SIGNAL = 40.0 + 3.0 * np.sin(2.0 * np.pi * np.arange(200_000) / 80.0)


@pytest.mark.parametrize(("decibel", "ratio"), [(0.0, 1.0), (-5.0, 1.7782794), (20.0, 0.1), (-20.0, 10.0)])
def test_level_belongs_to_the_alternating_part(decibel: float, ratio: float) -> None:
    """rms of the sine 3/√2; the mean of 40 does not count. The estimate scatters by 1/√(2n) = 0.16 %."""
    noisy = with_white_noise(SIGNAL, signal_to_noise=decibel, seed=3)
    assert noisy.noise_deviation == pytest.approx(ratio * 3.0 / np.sqrt(2.0), rel=1e-7)
    assert noisy.noise.std() == pytest.approx(noisy.noise_deviation, rel=0.007)
    np.testing.assert_array_equal(noisy.values, SIGNAL + noisy.noise)


def test_noise_is_white_and_gaussian() -> None:
    noise = with_white_noise(SIGNAL, signal_to_noise=0.0, seed=3).noise
    density = power_spectral_density(noise, 1000.0, segment=1000).density[1:-1]
    # 399 half-overlapping Hann segments, correlated by (1/6)^2 in power (P. D. Welch, 1967): a line scatters
    # by 5.1 %; one line in 500 exceeds 4.75 deviations once in a thousand draws
    deviation = np.sqrt((1.0 + 2.0 / 36.0) / 399.0)
    ratio = density / (4.5 / 500.0)
    np.testing.assert_allclose(ratio, 1.0, atol=4.75 * deviation)
    # neighbours of a Hann window are correlated by (2/3)^2, next ones by (1/6)^2 in power: mean and deviation
    # of all lines are as uncertain as those of n/1.94 and n/1.40 independent ones
    assert np.mean(ratio) == pytest.approx(1.0, abs=3.0 * deviation * np.sqrt(1.94 / ratio.size))
    assert np.std(ratio) == pytest.approx(deviation, rel=3.0 * np.sqrt(1.40 / (2.0 * ratio.size)))
    assert abs(np.mean(noise)) < 4.0 * 2.12 / np.sqrt(noise.size)
    assert np.mean(noise**4) / np.mean(noise**2) ** 2 == pytest.approx(
        3.0, abs=4.0 * np.sqrt(24 / noise.size)
    )


@settings(max_examples=25)
@given(st.integers(0, 2**64), st.integers(0, 2**64), st.floats(-40.0, 40.0))
def test_seed_decides_everything(seed: int, other: int, decibel: float) -> None:
    x = SIGNAL[:500]
    first = with_white_noise(x, signal_to_noise=decibel, seed=seed)
    np.testing.assert_array_equal(
        with_white_noise(x, signal_to_noise=decibel, seed=seed).values, first.values
    )
    pair = with_white_noise(x, signal_to_noise=decibel, seed=[seed, 1])
    assert not np.array_equal(pair.noise, first.noise)
    if other != seed:
        assert not np.array_equal(with_white_noise(x, signal_to_noise=decibel, seed=other).noise, first.noise)
    # another level scales the same noise; a longer record continues where the shorter one ends
    louder = with_white_noise(x, signal_to_noise=decibel - 20.0, seed=seed)
    np.testing.assert_allclose(louder.noise, 10.0 * first.noise, rtol=1e-12)


def test_noise_alone_is_that_on_a_signal() -> None:
    noisy = with_white_noise(SIGNAL, signal_to_noise=7.0, seed=[5, 2])
    alone = white_noise(SIGNAL.size, deviation=noisy.noise_deviation, seed=[5, 2])
    np.testing.assert_array_equal(alone, noisy.noise)
    assert white_noise(0, deviation=1.0, seed=1).shape == (0,)
    for deviation, seed in ((-1.0, 1), (np.nan, 1), (1.0, -1), (1.0, True)):
        with pytest.raises(SignalError, match="deviation|seed"):
            white_noise(3, deviation=deviation, seed=seed)


def test_noise_is_that_of_the_named_generator() -> None:
    noisy = with_white_noise(SIGNAL, signal_to_noise=0.0, seed=11)
    numbers = np.random.Generator(np.random.PCG64(11)).standard_normal(SIGNAL.size)
    np.testing.assert_allclose(noisy.noise / noisy.noise_deviation, numbers, rtol=1e-12)


def test_what_has_no_level_or_no_seed_is_refused() -> None:
    with pytest.raises(SignalError, match="constant at 2"):
        with_white_noise(np.full(100, 2.0), signal_to_noise=0.0, seed=1)
    with pytest.raises(SignalError, match="signal_to_noise: inf"):
        with_white_noise(SIGNAL, signal_to_noise=float("inf"), seed=1)
    for seed in (-1, 0.5, None, True, [1, "a"]):
        with pytest.raises(SignalError, match="seed"):
            with_white_noise(SIGNAL, signal_to_noise=0.0, seed=seed)  # type: ignore[arg-type]
