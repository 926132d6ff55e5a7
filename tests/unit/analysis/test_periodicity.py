# SPDX-License-Identifier: Apache-2.0
"""Periods of repeated impacts: rates of false alarms under noise, and what is not a fault."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from pitchpoint.analysis.comb_chance import CLIP, chance_of_comb, limited_sum_chance
from pitchpoint.analysis.combs import comb_lines, record_for_combs
from pitchpoint.analysis.periodicity import find_period, period_evidence
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.tones import fourier, multiples, without_tones
from tests.support.bearing_signal import MESHES, RATE, TURN, bearing_force, noisy


def impacts(period: float, seed: int, *, rate: float = 200.0, duration: float = 30.0, strength: float = 4.0):
    """Short pulses once per period in white noise of rms 1."""
    t = np.arange(round(rate * duration)) / rate
    pulse = np.exp(-((np.mod(t - 0.3 * period, period) / 0.03) ** 2))
    return strength * pulse + np.random.default_rng(seed).normal(size=t.size)


# ------------------------------------------------------------------------------------------- the statistics


def test_fourier_sums_are_those_of_the_transform() -> None:
    x = np.random.default_rng(0).normal(size=1234)
    k = np.arange(0, 617, 7)
    phase = np.exp(2j * np.pi * k / 1234 * 0.5 * 1233)
    np.testing.assert_allclose(fourier(x, k / 1234), np.fft.rfft(x)[k] * phase, atol=1e-9)


def test_tones_are_taken_out_whether_they_fit_the_record_or_not() -> None:
    t = np.arange(5000) / 1000.0
    f = np.array([3.251, 20.0988, 135.6667, 135.9])
    x = 40.0 + np.cos(2 * np.pi * np.outer(t, f) + np.arange(4)) @ [1.0, 3.0, 0.2, 5.0]
    # 135.67 and 135.9 Hz are 1.2 lines apart: the equations lose some digits
    assert np.abs(without_tones(x, 1000.0, f)).max() < 1e-9
    other = np.cos(2 * np.pi * 57.3 * t)
    np.testing.assert_allclose(without_tones(x + other, 1000.0, f), other, atol=0.02)


def test_multiples_that_coincide_count_once() -> None:
    assert multiples([2.0, 3.0], 12.0, 0.1).tolist() == [2.0, 3.0, 4.0, 6.0, 8.0, 9.0, 10.0, 12.0]
    assert multiples([], 12.0, 0.1).size == 0


@pytest.mark.parametrize("groups", [((1, 3), (1, 3), (1, 3)), ((3, 9), (3, 9), (1, 2)), ((4, 4), (2, 3))])
def test_chances_of_limited_sums_are_those_of_drawn_ones(groups) -> None:
    """Lines that share the measure of their noise, drawn 400 000 times; 4 standard errors of the counts."""
    rng = np.random.default_rng(5)
    n = 400_000
    total = np.zeros(n)
    for size, shared in groups:
        noise = rng.gamma(shared, 1.0 / shared, size=n)
        ratio = rng.exponential(size=(size, n)) / noise
        total += np.minimum(shared * np.log1p(ratio / shared), CLIP).sum(axis=0)
    for level in (0.5, 0.1, 0.01, 0.001):
        value = float(np.quantile(total, 1.0 - level))
        found = limited_sum_chance(value, groups)
        assert found == pytest.approx(level, rel=0.02 + 4.0 / np.sqrt(n * level))


@pytest.mark.parametrize("turns", [2.0, 3.6, 4.43, 9.7, 40.0])
def test_chances_of_lines_are_uniform_under_noise(turns: float) -> None:
    """The F test of single lines, and all of them joined: 300 records of noise, Kolmogorov and Smirnov."""
    single, joined = [], []
    for seed in range(300):
        x = np.random.default_rng([seed, 7]).normal(size=2000)
        record = record_for_combs(x, 100.0, 0.45 * 100.0, [])
        comb = comb_lines(record, 20.0 / turns, 10)
        single.append(comb.p_value[:: max(1, comb.orders.size // 3)])
        joined.append(chance_of_comb(comb))
    assert stats.kstest(np.concatenate(single), "uniform").pvalue > 1e-3
    assert stats.kstest(joined, "uniform").pvalue > 1e-3


def test_given_periods_in_noise_are_never_too_likely() -> None:
    """Chances at most as small as they say: 400 healthy bearing forces, 3 standard errors."""
    p = np.array(
        [
            period_evidence(noisy(bearing_force(), -5.0, seed), RATE, [TURN, 2.1], known=MESHES).p_value
            for seed in range(200)
        ]
    )
    for level in (0.5, 0.2, 0.05):
        assert (p <= level).mean() <= level + 3.0 * np.sqrt(level / p.size)


# ------------------------------------------------------------------------------------- what is not a fault


def test_a_mesh_is_no_fault_although_a_turn_holds_it_eleven_times() -> None:
    """Without any noise, the healthy force repeats after a turn to round-off, and still nothing is found."""
    force = bearing_force()
    turn = round(TURN * RATE)
    assert np.corrcoef(force[:-turn], force[turn:])[0, 1] > 0.9
    assert not find_period(force, RATE, 1.0, 5.0, known=MESHES).found
    assert not find_period(force, RATE, 1.0, 5.0).found
    assert period_evidence(force, RATE, [TURN], known=MESHES).p_value[0] > 0.05


def test_an_unknown_mesh_with_all_its_harmonics_is_no_longer_period() -> None:
    """Twenty equal harmonics of 3.251 Hz, not declared: between one and five seconds nothing repeats."""
    t = np.arange(6456) / RATE
    mesh = np.cos(2 * np.pi * np.outer(t, MESHES[0] * np.arange(1, 21)) + np.arange(20)).sum(axis=1)
    for seed in range(5):
        assert not find_period(noisy(mesh, 0.0, seed), RATE, 1.0, 5.0).found


def test_unbalance_and_a_bent_shaft_are_no_impacts() -> None:
    """Orders 1 and 2 of the shaft stand far above the noise; of impacts there is no trace."""
    t = np.arange(6456) / RATE
    shaft = np.cos(2 * np.pi * t / TURN) + 0.7 * np.cos(4 * np.pi * t / TURN + 1.0)
    for seed in range(5):
        evidence = period_evidence(noisy(5.0 * shaft, 0.0, seed), RATE, [TURN], known=MESHES)
        assert evidence.p_value[0] > 1e-3


def test_drift_and_constant_signals_are_no_periods() -> None:
    slope = np.linspace(0.0, 50.0, 6456)
    for seed in range(5):
        assert not find_period(noisy(bearing_force(), 0.0, seed) + slope, RATE, 1.0, 5.0, known=MESHES).found
    assert not find_period(np.full(6456, 380e3), RATE, 1.0, 5.0).found


@pytest.mark.parametrize("smoothing", [0.9, 0.99])
def test_coloured_noise_is_no_period(smoothing: float) -> None:
    """First-order filtered noise falls by 40 dB over the lines; the chances hold as for white noise."""
    from scipy.signal import lfilter

    p = []
    for seed in range(60):
        noise = lfilter([1.0], [1.0, -smoothing], np.random.default_rng([seed, 3]).normal(size=6456))
        p.append(find_period(noise, RATE, 1.0, 5.0, harmonics=10).p_value)
    assert np.mean(np.array(p) <= 0.1) <= 0.1
    assert min(p) > 1e-3


# ------------------------------------------------------------------------------------------- what is found


@pytest.mark.parametrize("period", [1.234, 2.345, 4.9, 10.0])
def test_periods_are_found_and_not_their_parts_or_multiples(period: float) -> None:
    """Sharp pulses have more lines than are looked at: every part of the period looks as strong."""
    found = find_period(impacts(period, 1, strength=12.0), 200.0, 0.4, 12.0)
    assert found.found
    assert found.turns == int(30.0 / period)
    assert found.period == pytest.approx(period, abs=4.0 * found.deviation)
    assert found.deviation < 2e-3 * period


@pytest.mark.parametrize(
    ("records", "low", "high", "bias"),
    [(12, 0.42, 1.65, 0.95), pytest.param(60, 0.6, 1.35, 0.45, marks=pytest.mark.study)],
)
def test_the_deviation_is_that_of_the_errors(records: int, low: float, high: float, bias: float) -> None:
    """Rms of error by stated deviation near 1 (chi-square, 0.1 % on either side), and no bias."""
    errors = []
    for seed in range(records):
        found = find_period(noisy(bearing_force(1.5), -3.0, seed), RATE, 2.0, 5.0, known=MESHES)
        assert found.found
        errors.append((found.period - TURN) / found.deviation)
    assert low < np.sqrt(np.mean(np.square(errors))) < high
    assert abs(np.mean(errors)) < bias


def test_the_period_without_noise_is_exact_between_samples() -> None:
    """4.43 turns and no whole number of samples per turn; what is left is the dip's content at mesh lines."""
    found = find_period(bearing_force(1.5), RATE, 1.0, 5.0, known=MESHES)
    assert found.period == pytest.approx(TURN, rel=3e-5)


def test_periods_may_be_turns() -> None:
    """Samples per revolution in place of the rate: the period of a mate with 38 teeth is 38/17 turns."""
    turns = np.arange(64 * 60) / 64.0
    pulse = 3.0 * np.exp(-((np.mod(turns, 38 / 17) / 0.05) ** 2))
    x = pulse + np.cos(2 * np.pi * 17 * turns) + np.random.default_rng(0).normal(size=turns.size)
    found = find_period(x, 64.0, 0.7, 10.0, known=[17.0])
    assert found.period == pytest.approx(38 / 17, rel=2e-3)


def test_given_periods_may_be_uncertain() -> None:
    x = impacts(2.345, 1)
    exact, off, near = (
        period_evidence(x, 200.0, [T], tolerance=tolerance)
        for T, tolerance in ((2.345, 0.0), (2.345 * 1.02, 0.0), (2.345 * 1.02, 0.025))
    )
    assert exact.p_value[0] < 1e-9
    assert off.p_value[0] > 0.01
    assert near.p_value[0] < 1e-6
    assert near.period[0] == pytest.approx(2.345, rel=2e-3)


def test_what_cannot_be_said_is_not_a_number() -> None:
    evidence = period_evidence(noisy(bearing_force(), 0.0, 0), RATE, [TURN, 11.07, 0.008], known=MESHES)
    assert evidence.turns.tolist() == [4, 1, 1875]
    assert np.isfinite(evidence.p_value).tolist() == [True, False, False]
    assert evidence.lines[2] == 1


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ({"longest": 8.0}, "half the record"),
        ({"shortest": 6.0}, "rising order"),
        ({"harmonics": 2}, r"harmonics: 2 \(limit 3 or more\)"),
        ({"known": [-3.0]}, "known frequency: -3.0"),
        ({"highest_frequency": 0.0}, "highest_frequency: 0.0"),
        ({"false_alarm": 0.0}, "false_alarm"),
        ({"shortest": np.nan}, "shortest"),
    ],
)
def test_bad_input_is_named(more, says: str) -> None:
    limits = {"shortest": 1.0, "longest": 5.0, **more}
    with pytest.raises(SignalError, match=says):
        find_period(bearing_force(), RATE, limits.pop("shortest"), limits.pop("longest"), **limits)
