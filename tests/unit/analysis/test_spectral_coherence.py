# SPDX-License-Identifier: Apache-2.0
"""Spectral coherence against its definition, modulated noise with a closed form, and stationary noise."""

from __future__ import annotations

import tracemalloc

import numpy as np
import pytest

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.spectra import window
from pitchpoint.analysis.spectral_coherence import SpectralCoherence, spectral_coherence

TAU = 2.0 * np.pi


def modulated(n: int, depth: float, frequency: float, seed: int = 0) -> np.ndarray:
    """White noise of unit variance whose amplitude is modulated."""
    noise = np.random.default_rng(seed).standard_normal(n)
    return (1.0 + depth * np.cos(TAU * frequency * np.arange(n))) * noise


def cyclic_periodogram(x: np.ndarray, length: int, hop: int, frames: int, alpha: float) -> np.ndarray:
    """Averaged cyclic periodogram by its definition, the coherence of X(f) and X(f - alpha), over f.

    Every window is transformed by explicit sums at the shifted frequencies.
    """
    w, m = window("hann", length), np.arange(length)
    carrier = np.arange(length // 2 + 1) / length
    at = hop * np.arange(frames)[:, None] + m
    one = (x[at] * w) @ np.exp(-1j * TAU * m[:, None] * carrier)
    two = (x[at] * w) @ np.exp(-1j * TAU * m[:, None] * (carrier - alpha))
    turn = np.exp(-1j * TAU * alpha * hop * np.arange(frames))[:, None]
    product = (one * two.conj() * turn).mean(axis=0)
    return np.abs(product) / np.sqrt((np.abs(one) ** 2).mean(axis=0) * (np.abs(two) ** 2).mean(axis=0))


def lines(found: SpectralCoherence, frequency: float) -> int:
    """Index of the nearest cyclic frequency."""
    return int(np.argmin(np.abs(found.cyclic_frequency - frequency)))


def test_it_is_the_averaged_cyclic_periodogram() -> None:
    """At the modulation, and as small elsewhere; both scatter by the standard deviation of noise, 0.03 here.

    Hops of 4 samples and 4608 frames: the modulation of 384 periods is a line of the transform.
    """
    n, length, hop, frames = 18_500, 64, 4, 4608
    alpha = 384.0 / (hop * frames)
    x = modulated(n, 0.6, alpha)
    found = spectral_coherence(x, 1.0, window_length=length)
    assert found.cyclic_frequency[0] == pytest.approx(1.0 / (hop * frames), rel=1e-12)
    middle = slice(3, -3)
    for frequency in (alpha, 2.0 * alpha, 3.3 * alpha):
        k = lines(found, frequency)
        slow = cyclic_periodogram(x - x.mean(), length, hop, frames, found.cyclic_frequency[k])[middle]
        fast = found.coherence[k, middle]
        scatter = found.threshold[k] / np.sqrt(-np.log(0.01))
        assert np.abs(fast - slow).max() < 3.5 * scatter
        assert np.abs(fast - slow).mean() < 0.9 * scatter
        assert abs(fast.mean() - slow.mean()) < 0.6 * scatter


@pytest.mark.parametrize("depth", [0.2, 0.5, 1.0])
def test_modulated_white_noise_has_its_closed_form(depth: float) -> None:
    """S(alpha) = m s² at the modulation, m²/4 s² at twice it; over S(0) = (1 + m²/2) s²."""
    hop, frames, alpha = 4, 12_500, 600.0 / (4 * 12_500)
    found = spectral_coherence(modulated(50_100, depth, alpha), 1.0, window_length=64)
    assert found.cyclic_frequency[0] == pytest.approx(1.0 / (hop * frames), rel=1e-12)
    scatter = found.threshold[lines(found, alpha)]
    power = 1.0 + 0.5 * depth**2
    for k, gain in ((lines(found, alpha), depth), (lines(found, 2.0 * alpha), 0.25 * depth**2)):
        # noise of variance s² adds to a coherence c: mean sqrt(c² + s²) about
        expected = np.hypot(gain / power, 0.5 * scatter)
        assert found.enhanced[k] == pytest.approx(expected, abs=0.5 * scatter)
    k = lines(found, alpha)
    assert found.correlation[k].mean() == pytest.approx(depth, rel=0.06)
    assert found.enhanced[k] > 5.0 * found.enhanced_threshold[k]
    assert found.density.mean() == pytest.approx(power, rel=0.03)


def test_thresholds_hold_for_stationary_noise() -> None:
    """One per cent of 60 000 values of each spectrum, with a standard error of 4 % of it."""
    above, total, points = np.zeros(2), 0, []
    for seed in range(6):
        x = np.random.default_rng(seed).standard_normal(100_000)
        found = spectral_coherence(x, 1.0, window_length=64, band=(0.2, 0.3))
        above += [
            np.sum(found.enhanced > found.enhanced_threshold),
            np.sum(found.improved > found.improved_threshold),
        ]
        total += found.enhanced.size
        points.append(np.mean(found.coherence[:, 10:-3] > found.threshold[:, None]))
    assert np.all(above / total < 0.0115)
    assert above[0] / total > 0.0075
    assert np.mean(points) == pytest.approx(0.01, rel=0.06)


def test_impacts_in_a_band_are_in_the_improved_spectrum() -> None:
    """Impacts with 1 % random slip that ring at 0.3 of the rate, 20 dB below noise in the lower half."""
    rng = np.random.default_rng(2)
    n, rate = 100_000, 0.011
    x = np.zeros(n)
    at = np.cumsum(rng.normal(1.0, 0.01, int(n * rate))) / rate
    for when in at[at < n - 60]:
        since = np.arange(int(when) + 1, int(when) + 60) - when
        x[int(when) + 1 : int(when) + 60] += np.exp(-0.1 * since) * np.sin(TAU * 0.3 * since)
    spectrum = np.fft.rfft(rng.standard_normal(n))
    spectrum[: n // 5] *= 30.0
    x += 0.7 * np.fft.irfft(spectrum, n)
    found = spectral_coherence(x, 1.0, window_length=128, band=(0.25, 0.35))
    k = int(np.argmax(found.improved))
    assert found.cyclic_frequency[k] % rate == pytest.approx(0.0, abs=0.01 * rate) or (
        rate - found.cyclic_frequency[k] % rate < 0.01 * rate
    )
    assert (
        found.improved[k] / found.improved_threshold[k]
        > 1.5 * found.enhanced[k] / found.enhanced_threshold[k]
    )


def test_long_records_need_bounded_memory() -> None:
    """Four times the length, the same memory; segments are averaged."""
    peaks, segments = [], []
    for n in (80_000, 320_000):
        x = modulated(n, 0.5, 0.012)
        tracemalloc.start()
        found = spectral_coherence(x, 1.0, window_length=64, segment=40_000)
        peaks.append(tracemalloc.get_traced_memory()[1] - 8 * n)
        tracemalloc.stop()
        segments.append(found.segments)
        assert abs(found.cyclic_frequency[np.argmax(found.enhanced)] - 0.012) < 5e-5
    assert segments == [2, 8]
    assert peaks[1] < 1.2 * peaks[0]


def test_what_cannot_be_is_refused_in_words() -> None:
    x = np.random.default_rng(0).standard_normal(5000)
    with pytest.raises(SignalError, match=r"highest_cyclic: 0\.4 Hz \(limit 0\.25 Hz"):
        spectral_coherence(x, 1.0, highest_cyclic=0.4)
    with pytest.raises(SignalError, match=r"values: 500 samples \(limit \d+\); use a longer record"):
        spectral_coherence(x[:500], 1.0)
    with pytest.raises(SignalError, match="are constant"):
        spectral_coherence(np.ones(5000), 1.0)
    with pytest.raises(SignalError, match="contains no line"):
        spectral_coherence(x, 1.0, band=(0.2001, 0.2002))
