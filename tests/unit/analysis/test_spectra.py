# SPDX-License-Identifier: Apache-2.0
"""Spectra against closed forms and against SciPy as an independent implementation."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.analysis.sampled import SignalError, sample_rate_of
from pitchpoint.analysis.spectra import (
    WINDOWS,
    amplitude_spectrum,
    largest_peaks,
    order_spectrum,
    power_spectral_density,
    window,
)


@given(st.integers(4, 400), st.integers(0, 2**31 - 1))
def test_parseval(n: int, seed: int) -> None:
    """mean² + Σ A²/2 is the mean square, for even and odd records."""
    x = np.random.default_rng(seed).normal(size=n) + 3.0
    s = amplitude_spectrum(x, 100.0, window_name="rectangular")
    squares = 0.5 * s.amplitude[1:] ** 2
    if n % 2 == 0:
        squares[-1] *= 2.0
    assert s.amplitude[0] ** 2 + squares.sum() == pytest.approx(np.mean(x**2), rel=1e-12)


@pytest.mark.parametrize("name", WINDOWS)
def test_amplitude_of_a_sine_on_a_line_is_exact(name: str) -> None:
    t = np.arange(2048) / 1024.0
    s = amplitude_spectrum(7.0 + 2.5 * np.sin(2 * np.pi * 64.0 * t + 0.3), 1024.0, window_name=name)
    k = round(64.0 / s.resolution)
    assert s.amplitude[k] == pytest.approx(2.5, rel=1e-9)
    assert s.amplitude[0] == pytest.approx(7.0, rel=1e-12)


def test_flattop_reads_between_lines() -> None:
    """Worst case of a flat-top window, half-way between two lines: below 0.1 %."""
    t = np.arange(1024) / 1024.0
    s = amplitude_spectrum(np.sin(2 * np.pi * 100.5 * t), 1024.0, window_name="flattop")
    assert s.amplitude.max() == pytest.approx(1.0, abs=1.2e-3)


@pytest.mark.parametrize("name", WINDOWS)
def test_windows_are_those_of_scipy(name: str) -> None:
    from scipy.signal import get_window

    reference = get_window("boxcar" if name == "rectangular" else name, 64, fftbins=True)
    np.testing.assert_allclose(window(name, 64), reference, atol=1e-12)


def test_density_is_that_of_scipy() -> None:
    from scipy.signal import welch

    x = np.random.default_rng(1).normal(size=5000)
    ours = power_spectral_density(x, 200.0, segment=500)
    f, reference = welch(x - x.mean(), 200.0, nperseg=500, noverlap=250, detrend=False)
    np.testing.assert_allclose(ours.frequency, f)
    np.testing.assert_allclose(ours.density, reference, rtol=1e-10)
    assert ours.n_segments == 19


def test_noise_bandwidth_of_hann() -> None:
    """1.5 lines, Harris 1978, table 1."""
    s = amplitude_spectrum(np.ones(1000), 1000.0)
    assert s.noise_bandwidth == pytest.approx(1.5 * s.resolution, rel=1e-12)


def test_order_spectrum_counts_teeth() -> None:
    angle = 2 * np.pi * np.arange(100 * 20) / 100
    s = order_spectrum(np.cos(17 * angle) + 0.2 * np.cos(34 * angle), 100)
    assert [round(f, 9) for f, _ in largest_peaks(s, 2)] == [17.0, 34.0]


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ([1.0, float("nan"), 1.0, 1.0], "sample 1"),
        ([[1.0], [2.0]], "dimensions"),
        ([1.0], "samples"),
        (["a", "b"], "numbers"),
    ],
)
def test_bad_signals_are_refused_in_words(values: object, words: str) -> None:
    with pytest.raises(SignalError, match=words):
        amplitude_spectrum(values, 10.0)  # type: ignore[arg-type]


def test_bad_settings_are_refused() -> None:
    with pytest.raises(SignalError, match="window"):
        amplitude_spectrum(np.ones(8), 1.0, window_name="kaiser")
    with pytest.raises(SignalError, match="sample_rate"):
        amplitude_spectrum(np.ones(8), 0.0)
    with pytest.raises(SignalError, match="segment"):
        power_spectral_density(np.ones(8), 1.0, segment=9)
    with pytest.raises(SignalError, match="uniformly"):
        sample_rate_of([0.0, 1.0, 2.5])


def test_late_time_axes_count_as_uniform() -> None:
    """A time axis far from zero carries fewer digits per step, and is uniform all the same."""
    assert sample_rate_of(1e4 + np.arange(1000) * 1e-5) == pytest.approx(1e5, rel=1e-6)
