# SPDX-License-Identifier: Apache-2.0
"""Envelopes against closed forms and SciPy; kurtograms of noise, tones and impacts in a known band."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.envelope import band_envelope, envelope_spectrum
from pitchpoint.analysis.kurtogram import kurtogram
from pitchpoint.analysis.sampled import SignalError

TAU = 2.0 * np.pi
RATE = 20_000.0


def impacts(middle: float, decay: float, period: float, seconds: float = 4.0, seed: int = 0) -> np.ndarray:
    """Impacts that ring at a frequency, 20 dB of amplitude above noise at their peak, and a strong low
    tone."""
    t = np.arange(int(seconds * RATE)) / RATE
    since = t % period
    noise = np.random.default_rng(seed).normal(size=t.size)
    return 10.0 * np.exp(-decay * since) * np.sin(TAU * middle * since) + noise + 3.0 * np.sin(TAU * 80.0 * t)


@pytest.mark.parametrize("n", [1000, 1001])
def test_the_envelope_of_the_whole_signal_is_that_of_scipy(n: int) -> None:
    from scipy.signal import hilbert

    x = np.random.default_rng(n).normal(size=n)
    expected = np.abs(hilbert(x - x.mean()))
    np.testing.assert_allclose(band_envelope(x, 100.0).envelope, expected, atol=1e-12)


def test_squared_envelope_spectrum_of_impacts_shows_their_rate() -> None:
    """Impacts every 20 ms: lines at 50 Hz and multiples stand out of everything between them."""
    x = impacts(4200.0, 700.0, 0.02)
    low, high = 3680.0, 4720.0
    s = envelope_spectrum(x, RATE, band=(low, high), squared=True)
    step = round(50.0 / s.resolution)
    for k in (1, 2, 3):
        between = s.amplitude[k * step + 5 : (k + 1) * step - 5]
        assert s.amplitude[k * step] > 10.0 * between.max()
    # of the impacts alone, from the lines of one period: |x_a|^2 has the harmonics 2 sum X_m X*_(m-k)
    since = np.arange(400) / RATE
    lines = np.fft.rfft(10.0 * np.exp(-700.0 * since) * np.sin(TAU * 4200.0 * since)) * 2.0 / 400.0
    lines = lines[int(np.ceil(low / 50.0)) : int(np.floor(high / 50.0)) + 1]
    # noise adds 2 Re(x_a n*), power 2 * 3.1 * 0.21 over +-1040 Hz, in impacts, so in phase with the lines:
    # 2 sqrt(1.3/1040 * 1.5 * 0.25) = 0.043 in a line of the Hann window
    for k in (1, 2, 3):
        expected = 2.0 * abs(np.sum(lines[k:] * np.conj(lines[:-k])))
        assert s.amplitude[k * step] == pytest.approx(expected, abs=3.0 * 0.043)


def test_the_kurtogram_finds_the_band_of_the_impacts() -> None:
    for middle in (1800.0, 4200.0, 8100.0):
        k = kurtogram(impacts(middle, 700.0, 0.025), RATE)
        assert k.best_low <= middle <= k.best_high
        assert k.best_high - k.best_low <= 3400.0
        assert k.best_kurtosis > 30.0 * k.best_spread


def test_gaussian_noise_has_no_kurtosis_and_scatters_as_stated() -> None:
    """z-scores of all bands over seeds: mean 0, standard deviation 1, for bands of 200 samples and more.

    The mean of |c|^4 over the square of that of |c|^2 is 2 n/(n + 1) for n Gaussian samples, so that K is
    2/(n + 1) too low, up to 1/sqrt(200) = 0.07 of its spread 2/sqrt(n). The 64 bands of the finest level
    are independent: three standard deviations of mean and scatter of 640 values are 0.12 and 0.084.
    """
    scores = []
    for seed in range(10):
        k = kurtogram(np.random.default_rng(seed).normal(size=2**15), RATE)
        wide = k.spread < 2.0 / np.sqrt(200.0)
        scores.append((k.kurtosis / k.spread)[wide])
    z = np.concatenate(scores)
    assert -0.07 - 0.12 < z.mean() < 0.12
    assert z.std() == pytest.approx(1.0, abs=0.084)


@pytest.mark.parametrize("f", [80.3, 777.7, 1234.56, 1249.0, 1251.0, 9000.1])
def test_a_steady_tone_has_kurtosis_minus_one(f: float) -> None:
    """Also where it does not fit into the record, and near edges of bands: its ends make no impact."""
    t = np.arange(2**15) / RATE
    k = kurtogram(np.sin(TAU * f * t) + 0.01 * np.random.default_rng(0).normal(size=t.size), RATE)
    inside = 0.25 * (k.high - k.low)
    holds = (k.low + inside < f) & (k.high - inside > f)
    # noise of 40 dB less: K = -1 + 4 times its share in the power
    assert k.kurtosis[holds] == pytest.approx(-1.0, abs=0.002)
    assert k.best_kurtosis < 5.0 * k.best_spread


def test_bands_tile_the_spectrum_at_every_level() -> None:
    k = kurtogram(np.random.default_rng(0).normal(size=5000), 1000.0, levels=4)
    levels = sorted(set(k.level.round(9).tolist()))
    third = np.log2(3.0)
    assert levels == pytest.approx([0.0, 1.0, third, 2.0, 1.0 + third, 3.0, 2.0 + third, 4.0], abs=1e-8)
    for level in levels:
        rows = np.isclose(k.level, level)
        low, high = k.low[rows], k.high[rows]
        assert (low[0], high[-1]) == (0.0, 500.0)
        np.testing.assert_array_equal(low[1:], high[:-1])
        np.testing.assert_allclose(high - low, 500.0 / 2.0**level, atol=0.4)  # two lines


@pytest.mark.parametrize("share", [0.05, 0.2, 0.5])
def test_noise_that_comes_and_goes(share: float) -> None:
    """Gaussian noise that is on for a share q of the time: mean |c|^4 = 2 q, mean |c|^2 = q, K = 2/q - 2.

    K scatters by about 2/q/sqrt(q n) here, 1 % to 4 % of 2/q; three times that is allowed.
    """
    n = 200_000
    on = (np.arange(n) % 2000) < 2000 * share
    x = np.random.default_rng(2).normal(size=n) * on
    k = kurtogram(x, 1000.0, levels=1)
    assert k.kurtosis == pytest.approx(2.0 / share - 2.0, abs=6.0 / share / np.sqrt(0.25 * share * n))


def test_only_bands_inside_the_edges_are_candidates() -> None:
    x = impacts(4200.0, 700.0, 0.02)
    k = kurtogram(x, RATE, band=(5000.0, 10_000.0))
    assert k.best_low >= 4999.0


@pytest.mark.parametrize("seed", range(4))
def test_a_single_shock_has_no_effect_on_the_median_of_blocks(seed: int) -> None:
    """Impacts every 20 ms that ring at 4.2 kHz, and one 20 times larger at 8.1 kHz."""
    t = np.arange(int(4 * RATE)) / RATE
    since = np.maximum(t - 1.23 - 0.2 * seed, 0.0)
    x = impacts(4200.0, 700.0, 0.02, seed=seed)
    x += 200.0 * np.exp(-700.0 * since) * np.sin(TAU * 8100.0 * since)
    shock = kurtogram(x, RATE)
    assert shock.best_low > 7000.0
    train = kurtogram(x, RATE, blocks=8)
    assert train.best_low <= 4200.0 <= train.best_high < 8100.0
    assert train.best_kurtosis > 30.0 * train.best_spread


def test_the_median_of_blocks_of_noise_scatters_less_than_stated() -> None:
    """By the factor of the median of eight values to that of many, 0.9, and a correction of its mean.

    32 bands of the finest level are independent: three standard deviations of the mean of 320 values of a
    scatter of 0.9 are 0.15.
    """
    scores = []
    for seed in range(10):
        k = kurtogram(np.random.default_rng(seed).normal(size=2**15), RATE, blocks=8)
        scores.append((k.kurtosis / k.spread)[k.spread < 2.5 / np.sqrt(400.0)])
    z = np.concatenate(scores)
    assert abs(z.mean()) < 0.15
    assert 0.7 < z.std() < 1.0


def test_the_best_band_is_at_least_as_wide_as_requested() -> None:
    x = impacts(4200.0, 700.0, 0.02)
    free, wide = kurtogram(x, RATE), kurtogram(x, RATE, least_width=3000.0)
    assert free.best_high - free.best_low < 3000.0 <= wide.best_high - wide.best_low
    assert wide.best_low <= 4200.0 <= wide.best_high
    np.testing.assert_array_equal(free.kurtosis, wide.kurtosis)
    with pytest.raises(SignalError, match="contains no kurtogram band, at least 3000 Hz wide"):
        kurtogram(x, RATE, band=(4000.0, 6000.0), least_width=3000.0)


def test_whitening_removes_a_strong_tone_and_its_modulation() -> None:
    """Impacts 30 dB below a tone that is modulated at 33 Hz, every 20 ms on average with 1 % random slip.

    Impacts that repeat exactly would also be lines, and vanish.
    """
    rng = np.random.default_rng(0)
    t = np.arange(int(4 * RATE)) / RATE
    x = rng.normal(size=t.size) + 300.0 * (1.0 + 0.5 * np.cos(TAU * 33.0 * t)) * np.sin(TAU * 3000.0 * t)
    for when in np.cumsum(rng.normal(0.02, 0.0002, 195)):
        since = t[int(when * RATE) + 1 :][:150] - when
        x[int(when * RATE) + 1 :][:150] += 10.0 * np.exp(-700.0 * since) * np.sin(TAU * 4200.0 * since)
    found = {whiten: envelope_spectrum(x, RATE, squared=True, whiten=whiten) for whiten in (False, True)}
    top = {whiten: s.frequency[1 + np.argmax(s.amplitude[1:])] for whiten, s in found.items()}
    assert top[False] == pytest.approx(33.0, abs=0.3)
    assert top[True] == pytest.approx(50.0, abs=0.5)


def test_what_cannot_be_is_refused_in_words() -> None:
    x = np.random.default_rng(0).normal(size=1000)
    for call, words in (
        (lambda: band_envelope(x, 100.0, band=(40.0, 60.0)), r"band: 40 to 60 Hz \(limit 0 to 50 Hz"),
        (lambda: band_envelope(x, 100.0, band=(10.01, 10.02)), "contains no line"),
        (lambda: kurtogram(x, 100.0, levels=9), "levels: 9"),
        (lambda: kurtogram(x[:200], 100.0), r"has 200 samples \(limit 256\)"),
        (lambda: kurtogram(np.ones(1000), 100.0), "constant"),
        (lambda: kurtogram(x, 100.0, band=(1.0, 2.0)), "contains no kurtogram band"),
    ):
        with pytest.raises(SignalError, match=words):
            call()
