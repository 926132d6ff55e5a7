# SPDX-License-Identifier: Apache-2.0
"""The detectors of bearing damage, each against its published case.

Frame: cyclic frequencies and carriers over the sample rate, orders over the shaft speed; no signs are
compared. A number of the literature is quoted only where it follows from the definition in the paper, so
that this file can derive it. The period of a broken tooth from a wavelet level is in
`test_seed_shovel_period.py`, the wavelet levels themselves in `test_fd_wavelet.py`, detectors of gears in
`test_published_gear_detectors.py`.

Motor records: Case Western Reserve University, Bearing Data Center, 12 kHz, drive end 6205-2RS JEM. Which of
them standard means diagnose: W. A. Smith, R. B. Randall, Rolling element bearing diagnostics using the Case
Western Reserve University data: a benchmark study, Mechanical Systems and Signal Processing 64-65, 2015,
100-131; inner rings, and outer rings with 0.007 and 0.021 in.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from scipy.io import loadmat

from pitchpoint.analysis.cepstrum import cepstral_whitening
from pitchpoint.analysis.envelope import band_envelope, envelope_spectrum
from pitchpoint.analysis.kurtogram import kurtogram
from pitchpoint.analysis.line_prominence import line_prominence, order_prominence
from pitchpoint.analysis.line_tests import line_probability
from pitchpoint.analysis.spectral_coherence import spectral_coherence
from tests.support.measured_sets import MotorRecord, motor_records, needs_measured

TAU = 2.0 * np.pi
RINGS = {"outer ring": 3.5848, "inner ring": 5.4152}
RATE = 12_000.0


def modulated_noise(n: int, depth: float, frequency: float, seed: int) -> np.ndarray:
    """White noise of unit variance with the amplitude 1 + m cos."""
    noise = np.random.default_rng(seed).standard_normal(n)
    return (1.0 + depth * np.cos(TAU * frequency * np.arange(n))) * noise


# ---- cepstrum pre-whitening and squared envelope -------------------------------------------------


def test_whitened_lines_have_equal_amplitudes_and_a_tone_no_weight() -> None:
    """P. Borghesani et al., Mechanical Systems and Signal Processing 36(2), 2013, 370-384.

    The real cepstrum is set to zero: all n/2 lines have the same power, and a tone, here 99.99 % of the
    power, has one of them. Tolerance: rounding.
    """
    n = 4096
    x = 100.0 * np.sqrt(2.0) * np.cos(TAU * 512 / n * np.arange(n))
    x += np.random.default_rng(1).standard_normal(n)
    power = np.abs(np.fft.rfft(cepstral_whitening(x).values))[1:-1] ** 2
    share = power[511] / power.sum()
    assert share == pytest.approx(1.0 / (n / 2 - 1), rel=1e-9)
    assert power.max() == pytest.approx(power.min(), rel=1e-9)


@pytest.mark.parametrize("depth", [0.3, 0.6, 1.0])
def test_squared_envelope_is_the_integral_of_the_spectral_correlation(depth: float) -> None:
    """R. B. Randall, J. Antoni, S. Chobsaard, Mechanical Systems and Signal Processing 15(5), 2001, 945-962.

    The integral of the spectral correlation over the carriers is the line of the squared envelope: for white
    noise with the amplitude 1 + m cos, m and m²/4 over 1 + m²/2, twice in the one-sided spectrum of the
    envelope. The analytic signal has positive carriers f and f - α only, the share 1 - 2α/f_s of all.
    Tolerance: four standard deviations of a line of the squared envelope of n samples, 2 sqrt(2/n) over the
    mean of 2 (1 + m²/2), whose noise is modulated as well, (1 + m)² at most.
    """
    n, alpha = 400_000, 0.01
    spectrum = envelope_spectrum(
        modulated_noise(n, depth, alpha, 3), 1.0, squared=True, window_name="rectangular"
    )
    lines = spectrum.amplitude[[round(alpha * n), round(2 * alpha * n)]] / spectrum.mean
    power = 1.0 + 0.5 * depth**2
    noise = 4.0 * np.sqrt(2.0 / n) * (1.0 + depth) ** 2 / power
    first, second = (1.0 - 2.0 * k * alpha for k in (1, 2))
    assert lines[0] == pytest.approx(2.0 * depth / power * first, abs=noise)
    assert lines[1] == pytest.approx(0.5 * depth**2 / power * second, abs=noise)


# ---- spectral coherence --------------------------------------------------------------------------


@pytest.mark.parametrize("duty", [0.1, 0.25, 0.5])
def test_coherence_of_noise_that_is_switched_on_and_off(duty: float) -> None:
    """J. Antoni, Mechanical Systems and Signal Processing 21(2), 2007, 597-630; fast estimator: J. Antoni,
    G. Xin, N. Hamzaoui, ibid. 92, 2017, 248-277.

    The coherence of modulated white noise is the Fourier coefficient of the power over its mean: of noise
    that is present in a share d of every period |sin(πkd)/(πkd)| at the harmonic k, at all carriers. The mean
    square over the carriers has that of the noise in addition. The modulation is a line of the transform over
    the frames. Tolerance: the window of 64 samples averages over 2.6 bursts at most, 1 %; four standard
    deviations of the mean of 7 independent carriers.
    """
    n, length = 200_000, 64
    noise = np.random.default_rng(4).standard_normal(n)
    alpha = on_the_grid(n, length, 1 / 1600)
    x = noise * (np.arange(n) * alpha % 1.0 < duty)
    found = spectral_coherence(x, 1.0, window_length=length, highest_cyclic=0.02)
    for k in (1, 2, 3):
        row = int(np.argmin(np.abs(found.cyclic_frequency - k * alpha)))
        sigma = float(found.threshold[row]) / np.sqrt(-np.log(0.01))
        square = float(np.mean(found.coherence[row, 3:-3] ** 2)) - sigma**2
        expected = float(np.sinc(k * duty)) ** 2
        spread = 4.0 * sigma * np.sqrt((2.0 * expected + sigma**2) / 7.0)
        assert square == pytest.approx(expected, abs=0.01 * expected + spread)


def on_the_grid(n: int, length: int, frequency: float) -> float:
    """Cyclic frequency of the estimate that is nearest to a given one."""
    grid = spectral_coherence(np.ones(n) + np.arange(n) % 2, 1.0, window_length=length, highest_cyclic=0.02)
    return float(grid.cyclic_frequency[np.argmin(np.abs(grid.cyclic_frequency - frequency))])


def test_coherence_does_not_depend_on_the_path_but_the_correlation_does() -> None:
    """J. Antoni, Mechanical Systems and Signal Processing 21(2), 2007, 597-630: S(α, f) of filtered modulated
    noise is H(f) H*(f - α) m σ²/f_s, the coherence that of the unfiltered noise, m/(1 + m²/2).

    The modulation is slow compared with the impulse response. Tolerance: four standard deviations of a mean
    over 7 independent carriers, which the threshold of one carrier states.
    """
    n, depth, length = 200_000, 0.5, 64
    alpha = on_the_grid(n, length, 1 / 1600)
    x = modulated_noise(n, depth, alpha, 5)
    y = np.convolve(x, [1.0, 0.8, 0.3], mode="same")
    plain, heard = (spectral_coherence(v, 1.0, window_length=length, highest_cyclic=0.02) for v in (x, y))
    row = int(np.argmin(np.abs(heard.cyclic_frequency - alpha)))
    sigma = float(heard.threshold[row]) / np.sqrt(-np.log(0.01) * 7.0)
    gain = np.abs(np.fft.fft([1.0, 0.8, 0.3], length))[: length // 2 + 1]
    inside = slice(4, -4)
    correlation = float(np.mean(heard.correlation[row, inside] / gain[inside] ** 2))
    enhanced = float(heard.enhanced[row])
    assert enhanced == pytest.approx(depth / (1.0 + 0.5 * depth**2), abs=4.0 * sigma)
    assert enhanced == pytest.approx(float(plain.enhanced[row]), abs=4.0 * sigma)
    assert correlation == pytest.approx(depth, abs=4.0 * sigma)


# ---- spectral kurtosis ---------------------------------------------------------------------------


@pytest.mark.parametrize("ratio", [0.0, 0.5, 2.0])
def test_spectral_kurtosis_in_noise(ratio: float) -> None:
    """J. Antoni, Mechanical Systems and Signal Processing 20(2), 2006, 282-307: additive stationary noise of
    the noise-to-signal ratio ρ divides the spectral kurtosis by (1 + ρ)².

    The signal is noise that is present in a share d of the time, whose complex envelope has 2/d - 2.
    Tolerance: the length of the window in which the kurtosis is counted contains 80 periods; 8 % of the sum
    2 + K, which is the scatter of the mean fourth power of 20 000 values in bursts, and of the edges.
    """
    n, duty = 262_144, 0.2
    rng = np.random.default_rng(6)
    on = np.arange(n) % 2048 < duty * 2048
    x = rng.standard_normal(n) * on / np.sqrt(duty) + np.sqrt(ratio) * rng.standard_normal(n)
    found = kurtogram(x, 1.0, levels=2)
    kurtosis = float(np.mean(found.kurtosis[found.level == 2.0]))
    expected = (2.0 / duty - 2.0) / (1.0 + ratio) ** 2
    assert kurtosis == pytest.approx(expected, abs=0.08 * (2.0 + expected))


def test_spectral_kurtosis_of_stationary_noise_and_of_a_harmonic() -> None:
    """The same paper: 0 for a stationary Gaussian process, -1 for a harmonic. Tolerance: four standard
    deviations 2/√m for noise; 1e-3 for the window that is removed from the tone."""
    n = 65_536
    quiet = kurtogram(np.random.default_rng(7).standard_normal(n), 1.0, levels=3)
    assert quiet.kurtosis[0] == pytest.approx(0.0, abs=4.0 * quiet.spread[0])
    tone = kurtogram(np.cos(TAU * 0.1 * np.arange(n)), 1.0, levels=3)
    inside = (tone.low < 0.1) & (tone.high > 0.1)
    worst = float(np.abs(tone.kurtosis[inside] + 1.0).max())
    assert -1.0 + worst == pytest.approx(-1.0, abs=1e-3)


def test_tiling_in_halves_and_thirds() -> None:
    """J. Antoni, Mechanical Systems and Signal Processing 21(1), 2007, 108-124: 2^k bands at the level k,
    3·2^k at the level k + log2(3), each of the width f_s/2 over 2^level. Tolerance: one line of the
    spectrum."""
    found = kurtogram(np.random.default_rng(8).standard_normal(16_384), 2.0, levels=4)
    for level in np.unique(found.level):
        count = round(2.0**level)
        inside = found.level == level
        assert inside.sum() == count
        widest = float(np.max(found.high[inside] - found.low[inside]))
        assert widest == pytest.approx(1.0 / count, abs=1.0 / 8192)


def test_a_single_shock_and_impacts_that_repeat() -> None:
    """A share d of the record with noise has a kurtosis of 2/d - 2 whether it is one burst or many (Antoni
    2006): a single burst of 1 % at one frequency wins against bursts of 10 % at another. The median of
    eight blocks leaves the latter, with 2/0.1 - 2 = 18, or 2 mean(p²)/mean(p)² - 2 with the power p of bursts
    whose ends are blurred by the filter of a quarter of the sample rate. Tolerance: of n Gaussian samples
    K + 2 scatters by 1/√n of itself; a block has 16 bursts of 205/4 samples of this bandwidth, and the median
    of eight values scatters by 1.25/√8 of one: 1.5 %, 0.31; three times that."""
    n = 262_144
    rng, t = np.random.default_rng(9), np.arange(n)
    shock = 30.0 * rng.standard_normal(n) * (np.abs(t - n // 3) < n // 200)
    bursts = rng.standard_normal(n) * (t % 2048 < 205)
    low, high = (np.fft.rfft(v) for v in (bursts, shock))
    half = low.size // 2
    x = np.fft.irfft(np.concatenate([low[:half], high[half:]]), n)
    assert kurtogram(x, 2.0, levels=1).best_low > 0.499
    robust = kurtogram(x, 2.0, levels=1, blocks=8)
    assert robust.best_high <= 0.501
    response = np.zeros(n, dtype=complex)
    response[: n // 4] = 1.0
    spread = np.abs(np.fft.ifft(response)) ** 2
    p = np.fft.irfft(np.fft.rfft((t % 2048 < 205).astype(float)) * np.fft.rfft(spread), n)
    expected = 2.0 * np.mean(p**2) / np.mean(p) ** 2 - 2.0
    assert 17.0 < expected < 18.0
    assert robust.best_kurtosis == pytest.approx(expected, abs=3.0 * 0.31)


# ---- lines above the running median --------------------------------------------------------------


def test_level_of_a_tone_above_noise() -> None:
    """F. J. Harris, Proceedings of the IEEE 66(1), 1978, 51-83, Table I: the Hann window has a noise
    bandwidth of 1.50 lines and loses 1.42 dB between two lines. A tone of the power A²/2 in white noise of
    the variance σ² has A² n/(4·1.5 σ²) times the mean power of the lines, and the median is ln 2 of the
    mean.

    Frame: an order of a shaft; mean of 40 records. The lines of the tone are three of the 128 of the
    median, which rises by 0.2 dB. Tolerance: four standard deviations of a mean whose single levels scatter
    by 0.65 dB, those of the same noise at and between lines by 0.3 dB.
    """
    per_turn, turns = 64, 500
    n, levels = per_turn * turns, {0.0: [], 0.5: []}
    for offset, found in levels.items():
        order = 7.0 + offset / turns
        tone = 0.5 * np.cos(TAU * order * np.arange(n) / per_turn)
        for seed in range(40):
            one = order_prominence(tone + np.random.default_rng(seed).standard_normal(n), per_turn)
            found.append(one.prominence[np.abs(one.frequency - order) <= 1.001 / turns].max())
    level, between = (float(np.mean(found)) for found in levels.values())
    expected = 10.0 * np.log10(0.25 * n / 6.0 / np.log(2.0)) - 0.2
    assert level == pytest.approx(expected, abs=4.0 * 0.65 / np.sqrt(40))
    loss = level - between
    assert loss == pytest.approx(1.42, abs=4.0 * 0.3 / np.sqrt(40))


def test_false_alarms_of_ordered_statistics() -> None:
    """H. Rohling, IEEE Transactions on Aerospace and Electronic Systems 19(4), 1983, 608-621: a noise line
    exceeds T times the k-th smallest of M others with Π (M - i)/(M - i + T), i < k.

    Frame: `line_probability` counts with k = 12 of M = 16 for lines of shafts; the running median of 64
    lines has k = M/2 of at least 32 independent ones, as those two apart are, and with M = ∞ 2^-T remains.
    Tolerance: four standard deviations of the counts.
    """
    rng = np.random.default_rng(11)
    drawn = rng.exponential(size=(200_000, 17))
    rate = float(np.mean(drawn[:, 0] > 4.0 * np.partition(drawn[:, 1:], 11, axis=1)[:, 11]))
    i = np.arange(12)
    exact = float(np.prod((16 - i) / (16 - i + 4.0)))
    assert rate == pytest.approx(exact, abs=4.0 * np.sqrt(exact / 200_000))
    assert line_probability(4.0, 16, 12) == pytest.approx(exact, rel=1e-12)

    ratio, half = 10.0, np.arange(16)
    few, many = float(np.prod((32 - half) / (32 - half + ratio))), 2.0**-ratio
    counts = [line_prominence(rng.standard_normal(8192), 1.0, width=64 / 8192).prominence for _ in range(100)]
    rate = float(np.mean(np.concatenate(counts) > 10.0))
    assert many - 4.0 * np.sqrt(many / 4e5) < rate < few + 4.0 * np.sqrt(few / 4e5)


# ---- measured bearings ---------------------------------------------------------------------------


def signal_of(record: MotorRecord) -> tuple[np.ndarray, float]:
    """Vibration at the drive end and measured speed [Hz]."""
    data = loadmat(record.file)
    (rpm,) = (float(v.item()) for k, v in data.items() if k.endswith("RPM"))
    return data[record.channel].ravel(), rpm / 60.0


@pytest.fixture(scope="module")
def motors() -> list[tuple[MotorRecord, np.ndarray, float]]:
    """Records of the motor with damaged rings, and the healthy one."""
    return [(one, *signal_of(one)) for one in motor_records() if one.diagnosable or not one.part]


def within_slip(speed: float) -> Iterator[tuple[str, np.ndarray]]:
    """Fault frequencies of the rings within 1 % of slip [Hz]."""
    for ring, order in RINGS.items():
        yield ring, order * speed * np.linspace(0.99, 1.01, 201)


@needs_measured
def test_squared_envelope_of_whitened_motors(motors) -> None:
    """Smith and Randall 2015, cepstrum pre-whitening and squared envelope spectrum: lines of the damaged
    ring.

    First three harmonics above the running median. Limits, not fitted: the damaged ring is at least
    20 dB above it, the sound one at least 10 dB lower in the mean, the healthy motor below 10 dB.
    """
    for record, x, speed in motors:
        square = band_envelope(x, RATE, whiten=True).envelope ** 2
        found = line_prominence(square, RATE, highest=700.0)
        levels = {
            ring: max(
                np.mean([found.prominence[round(k * f / found.resolution) - 2] for k in (1, 2, 3)])
                for f in fs
            )
            for ring, fs in within_slip(speed)
        }
        if record.part:
            own = levels.pop(record.part)
            (other,) = levels.values()
            assert own > 20.0 and own > other + 10.0, (record.file.name, own, other)
        else:
            assert max(levels.values()) < 10.0


@needs_measured
def test_enhanced_envelope_spectrum_of_motors(motors) -> None:
    """The enhanced envelope spectrum of Antoni, Xin and Hamzaoui 2017 on the records that Smith and Randall
    call diagnosable, over the threshold of stationary noise and within 1 % of slip.

    Limits: 10 dB between the damaged ring and the other one, a factor of five between a damaged ring and
    those of the healthy motor.
    """
    own, healthy = [], []
    for record, x, speed in motors:
        found = spectral_coherence(x, RATE, highest_cyclic=400.0)
        over = found.enhanced / found.enhanced_threshold
        ratio = {
            ring: float(over[(found.cyclic_frequency >= fs[0]) & (found.cyclic_frequency <= fs[-1])].max())
            for ring, fs in within_slip(speed)
        }
        if record.part:
            own.append(ratio.pop(record.part))
            assert own[-1] > 10.0**0.5 * max(ratio.values()), record.file.name
        else:
            healthy += ratio.values()
    assert len(own) == 10 and min(own) > 5.0 * max(healthy)


@needs_measured
def test_kurtogram_of_motors(motors) -> None:
    """A kurtogram with bands of at least three fault frequencies and the median of eight blocks: every
    damaged ring is more impulsive than the healthy motor, by a factor of five."""
    best = {
        record.file.stem: kurtogram(x, RATE, least_width=3 * 5.4152 * speed, blocks=8).best_kurtosis
        for record, x, speed in motors
    }
    healthy = best.pop("normal_0")
    assert len(best) == 10 and min(best.values()) > 5.0 * healthy
