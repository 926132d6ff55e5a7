# SPDX-License-Identifier: Apache-2.0
"""Synchronous average: what repeats stays, what does not falls at the rate that theory gives."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pitchpoint.analysis.gear_signals import gear_signals
from pitchpoint.analysis.indicators import standardised_moment
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.spectra import order_spectrum
from pitchpoint.analysis.synchronous_average import hunting_turns, shaft_ratio, synchronous_average
from pitchpoint.analysis.tacho import pulse_train, tacho_angle
from tests.support.gear_vibration import mesh_vibration, tooth_pulse

TURN = 2.0 * np.pi


def turns(n: float, per_turn: int = 512) -> np.ndarray:
    """Angle of n turns at equal steps."""
    return np.arange(round(n * per_turn) + 1) * (TURN / per_turn)


def rms(x: np.ndarray) -> float:
    return float(np.sqrt(np.mean(x**2)))


@settings(max_examples=40, deadline=None)
@given(
    st.integers(0, 2**31 - 1),
    st.floats(-50.0, 50.0),
    st.floats(1.05, 6.5),
    st.sampled_from([Fraction(1), Fraction(1, 3), Fraction(17, 38), Fraction(5, 2)]),
    st.sampled_from([64, 75, 128]),
)
def test_what_repeats_with_the_shaft_stays(
    seed: int, start: float, length: float, ratio: Fraction, samples: int
) -> None:
    """Any periodic signal up to order 20, wherever the record begins, whichever shaft is the reference."""
    rng = np.random.default_rng(seed)
    amplitude, phase = rng.normal(size=21), rng.uniform(0.0, TURN, 21)

    def signal(angle: np.ndarray) -> np.ndarray:
        return np.asarray(sum(amplitude[k] * np.cos(k * angle + phase[k]) for k in range(21)))

    angle = start + turns(length, 400) * (1.0 + 1e-7)
    mean = synchronous_average(signal(angle), angle / float(ratio), ratio=ratio, samples_per_turn=samples)
    assert mean.averages == int(length)
    assert mean.values.size == mean.angle.size == samples
    # cubic spline with 20 samples in the shortest period: 2e-4 of an amplitude, at the ends ten times that
    np.testing.assert_allclose(mean.values, signal(mean.angle), atol=3e-3 * np.abs(amplitude).sum())
    assert mean.scatter < 3e-3 * np.abs(amplitude).sum()


def test_orders_of_the_average_do_not_leak() -> None:
    """One period: order 17 is one line, its neighbours are as empty as the spline is right."""
    angle = turns(10.4, 500)
    mean = synchronous_average(np.cos(17 * angle + 0.3), angle, samples_per_turn=100)
    lines = order_spectrum(mean.values, 100, window_name="rectangular").amplitude
    assert lines[17] == pytest.approx(1.0, abs=1e-4)
    assert np.delete(lines, 17).max() < 1e-5


def test_clockwise_turns_count_forward() -> None:
    angle = turns(5.5)
    forward = synchronous_average(np.cos(3 * angle), angle)
    backward = synchronous_average(np.cos(3 * angle), -angle)
    np.testing.assert_array_equal(backward.values, forward.values)


def test_noise_falls_with_the_root_of_the_averages() -> None:
    """White noise of 512 samples per turn, a quarter of its band kept: rms σ/(2√N), within 3/√(2·128).

    The lines are those of the plain mean of all turns, times the response of the spline: 1 at samples and
    (23 cos(w/2) + cos(3w/2))/(8 (2 + cos w)) half-way between two (cubic cardinal spline).
    """
    angle = turns(1024)
    noise = np.random.default_rng(5).standard_normal(angle.size)
    for n in (4, 16, 64, 256, 1024):
        cut = slice(0, n * 512 + 1)
        mean = synchronous_average(noise[cut], angle[cut], samples_per_turn=128)
        assert mean.averages == n
        assert rms(mean.values) == pytest.approx(0.5 / np.sqrt(n), rel=3.0 / np.sqrt(2.0 * 128.0))
        plain = np.fft.rfft(noise[: n * 512].reshape(n, 512).mean(axis=0))[:64] / 512
        expected = plain * 0.5 * (1.0 + between(TURN * np.arange(64) / 512))
        # the ends of the record alone differ: a few samples of n turns
        np.testing.assert_allclose(np.fft.rfft(mean.values)[:64] / 128, expected, atol=2e-3 / n)
    # white noise through the spline at twice the rate, less the mean; the rms of n values scatters by 1/√(2n)
    kept = 0.5 * (1.0 + np.mean(between(TURN * (np.arange(1000) + 0.5) / 1000) ** 2))
    scatter = np.sqrt(kept * (1.0 - 1.0 / 1024))
    assert mean.scatter == pytest.approx(scatter, rel=3.0 / np.sqrt(2.0 * 1024 * 512))


def between(w: np.ndarray) -> np.ndarray:
    """Response of a cubic spline half-way between samples, w radians per sample."""
    return (23.0 * np.cos(0.5 * w) + np.cos(1.5 * w)) / (8.0 * (2.0 + np.cos(w)))


def test_fault_of_the_shaft_stays_and_of_its_mate_falls_with_the_root_of_the_averages() -> None:
    """Pair 17/38: a tooth of the wheel meets another tooth of the pinion each time, until all have met.

    N turns of the pinion hold n = 17 N/38 pulses of the wheel. Each is alone with 1/N of its height, so
    the mean square is n/N² of that of one pulse per turn: rms ∝ 1/√N. After 38 turns all 17 teeth have been
    hit alike and nothing but the mesh order is left.
    """
    angle = turns(39.0)
    pulse = tooth_pulse(angle * 17 / 38, 38, tooth=1)
    one = np.sqrt(3.0 / 16.0 / 17.0)
    for n in (7, 12, 21, 30, 38):
        cut = slice(0, n * 512 + 1)
        mean = synchronous_average(pulse[cut], angle[cut])
        # only turns that hold whole pulses: the last of them is over when the wheel has turned past it
        seen = np.count_nonzero(np.diff(np.sign(pulse[cut] - 0.5)) > 0)
        assert abs(seen - n * 17 / 38) < 1.0
        assert rms(mean.values) == pytest.approx(np.sqrt(seen) / n * one, rel=5e-3)
    left = gear_signals(mean.values, teeth=17, shaft_orders=0).residual
    assert rms(left) < 2e-4 * one
    assert hunting_turns(17, 38) == 38
    own = synchronous_average(tooth_pulse(angle, 17, tooth=4), angle)
    np.testing.assert_allclose(own.values, tooth_pulse(own.angle, 17, tooth=4), atol=2e-3)


def test_a_whole_ratio_keeps_the_fault_of_the_pinion_in_the_average_of_the_wheel() -> None:
    """32/96: each tooth of the pinion meets the same three teeth of the wheel for ever."""
    wheel = turns(40, 2048)
    pulse = tooth_pulse(3.0 * wheel, 32)
    mean = synchronous_average(pulse, wheel)
    np.testing.assert_allclose(mean.values, tooth_pulse(3.0 * mean.angle, 32), atol=3e-3)
    assert hunting_turns(96, 32) == 1


def test_faulty_tooth_in_noise_on_a_run_up_over_a_gear_chain() -> None:
    """PHM rig 32/96-48/80: fault on the 80-tooth wheel, tacho of ten pulses on the input shaft, 0 dB noise.

    The tooth that stands out in the difference signal is the faulty one, counted from the first pulse.
    """
    rate = 50_000.0
    t = np.arange(round(24.0 * rate)) / rate
    angle = TURN * (30.0 * t + 0.3 * t**2)
    output = angle / 5.0
    rng = np.random.default_rng(2)
    x = mesh_vibration(angle, 32, modulation=0.1) + mesh_vibration(output, 80, modulation=0.2)
    x += 0.8 * tooth_pulse(output, 80, tooth=23) * np.cos(120.0 * output)
    x += x.std() * rng.standard_normal(t.size)
    shaft = tacho_angle(pulse_train(angle, pulses_per_revolution=10), t, pulses_per_revolution=10)
    x = x[shaft.first_sample : shaft.first_sample + shaft.angle.size]
    ratio = shaft_ratio((32, 96), (48, 80))
    assert ratio == Fraction(1, 5)
    mean = synchronous_average(x, shaft.angle, ratio=ratio, samples_per_turn=1024)
    assert mean.averages == int((shaft.angle[-1] - shaft.angle[0]) / 5.0 / TURN)
    # the input shaft turns five times in a turn of the output: its mesh and sidebands stay in the average
    parts = gear_signals(mean.values, teeth=[80, 160])
    lines = np.fft.rfft(parts.difference)
    orders = np.arange(lines.size)
    lines[(orders % 160 <= 15) | (orders % 160 >= 145)] = 0.0
    left = np.fft.irfft(lines, 1024)
    first = np.mod(output[np.flatnonzero(t >= shaft.pulse_time[0])[0]], TURN)
    tooth = np.mod(mean.angle[np.argmax(np.abs(left))] + first, TURN) / (TURN / 80)
    assert 23.0 < tooth < 23.5
    assert standardised_moment(left, 4) > 6.0


@pytest.mark.parametrize(
    ("length", "settings_", "message"),
    [
        (0.99, {}, "covers 0.99 revolutions of the averaged shaft .limit 1 revolution."),
        (3.0, {"ratio": Fraction(1, 5)}, "covers 0.6 revolutions"),
        (3.0, {"ratio": 0.447}, "build it from tooth counts"),
        (3.0, {"ratio": Fraction(-1, 2)}, "ratio"),
        (3.0, {"samples_per_turn": 7}, "samples_per_turn: 7"),
    ],
)
def test_unsuitable_input_is_refused(length: float, settings_: dict, message: str) -> None:
    angle = turns(length)
    with pytest.raises(SignalError, match=message):
        synchronous_average(np.cos(angle), angle, **settings_)


def test_channels_of_different_records_are_refused() -> None:
    with pytest.raises(SignalError, match="513 and 512 samples"):
        synchronous_average(np.ones(513), turns(1)[:-1])
    with pytest.raises(SignalError, match="tooth count: 0"):
        shaft_ratio((17, 0))
