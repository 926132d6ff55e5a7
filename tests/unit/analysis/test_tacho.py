# SPDX-License-Identifier: Apache-2.0
"""Tacho: angles of known motions, pulses lost and doubled on purpose, channels without pulses."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pitchpoint.analysis.orders import order_map, tracked_spectrum
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.tacho import ShaftAngle, angle_channel, pulse_train, rising_edges, tacho_angle

RATE = 20_000.0
TIME = np.arange(40_000) / RATE
TURN = 2.0 * np.pi


def error_in_pulses(shaft: ShaftAngle, angle: np.ndarray, pulses: int) -> np.ndarray:
    """Angle by the tacho minus the true one, less the whole number of pulses before the first one."""
    true = angle[shaft.first_sample : shaft.first_sample + shaft.angle.size]
    error = (shaft.angle - true) * pulses / TURN
    return error - np.round(np.median(error))


def lose(train: np.ndarray, angle: np.ndarray, pulses: int, number: int) -> None:
    train[np.abs(angle * pulses / TURN - number - 0.25) < 0.3] = 0.0


def double(train: np.ndarray, angle: np.ndarray, pulses: int, number: int, at: float = 0.75) -> None:
    train[np.abs(angle * pulses / TURN - number - at) < 0.1] = 1.0


def test_edges_lie_between_samples() -> None:
    """A sine of 7 Hz rises through its middle at k/7 s; a straight line over 1/2000 s misses it by 4e-8 s."""
    t = np.arange(4000) / 2000.0
    edges = rising_edges(3.0 + 0.5 * np.sin(TURN * 7.0 * t), t)
    np.testing.assert_allclose(edges, np.arange(1, 14) / 7.0, atol=1e-6)


def test_noise_on_a_slow_edge_makes_no_second_pulse() -> None:
    t = np.arange(20_000) / 2000.0
    noise = 0.05 * np.random.default_rng(0).standard_normal(t.size)
    sine = np.sin(TURN * 7.0 * t)
    assert rising_edges(sine + noise, t).size == 69
    assert rising_edges(sine + noise, t, hysteresis=0.0).size > 69


MOTIONS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "steady": lambda t: TURN * 23.7 * t,
    "from rest": lambda t: TURN * 15.0 * (t + 0.001) ** 2,
    "to rest": lambda t: -TURN * 15.0 * (2.001 - t) ** 2,
    "jerk": lambda t: TURN * (3.0 * t + 6.0 * t**3),
}


@pytest.mark.parametrize("pulses", [1, 4, 60])
@pytest.mark.parametrize("motion", MOTIONS)
def test_angle_of_a_known_motion(motion: str, pulses: int) -> None:
    """Angles are right within what the shaft turns in 0.13 samples.

    A straight line through the samples of an edge behind a box filter misses it by up to 3/2 - √2 = 0.086
    samples; the spline swings half as far again at its ends.
    """
    angle = MOTIONS[motion](TIME)
    shaft = tacho_angle(pulse_train(angle, pulses_per_revolution=pulses), TIME, pulses_per_revolution=pulses)
    assert shaft.missing.size == shaft.doubled.size == 0
    sample = np.diff(angle).max() * pulses / TURN
    assert np.abs(error_in_pulses(shaft, angle, pulses)).max() < 0.13 * sample + 1e-3
    assert shaft.time[0] == TIME[shaft.first_sample]
    assert shaft.pulse_time.size == shaft.pulse_angle.size


def test_speed_is_that_of_the_shaft() -> None:
    angle = TURN * (5.0 * TIME + 4.0 * TIME**2)
    shaft = tacho_angle(pulse_train(angle, pulses_per_revolution=8), TIME, pulses_per_revolution=8)
    # edges jitter by 0.086 samples, pulses are 118 or more samples apart
    np.testing.assert_allclose(shaft.speed, TURN * (5.0 + 8.0 * shaft.time), rtol=4e-3)


@pytest.mark.parametrize("pulses", [1, 4, 17])
def test_lost_and_doubled_pulses_are_told_and_repaired(pulses: int) -> None:
    angle = TURN * (10.0 * TIME + 8.0 * TIME**2)
    train = pulse_train(angle, pulses_per_revolution=pulses)
    clean = tacho_angle(train, TIME, pulses_per_revolution=pulses)
    lose(train, angle, pulses, 11)
    lose(train, angle, pulses, 23)
    lose(train, angle, pulses, 24)
    double(train, angle, pulses, 31)
    shaft = tacho_angle(train, TIME, pulses_per_revolution=pulses)

    def time_of(number: float) -> float:
        return float(np.interp(number * TURN / pulses, angle, TIME))

    # where a pulse is missing its place is known to a small part of its interval
    np.testing.assert_allclose(shaft.missing, [time_of(k) for k in (11, 23, 24)], atol=0.1 * time_of(1))
    np.testing.assert_allclose(shaft.doubled, [time_of(31.65)], atol=1.0 / RATE)
    np.testing.assert_allclose(shaft.angle, clean.angle, atol=0.02 * TURN / pulses)


@settings(max_examples=40, deadline=None)
@given(
    st.integers(1, 20),
    st.floats(-0.4, 0.9),
    st.sets(st.integers(1, 9), max_size=3),
    st.sets(st.integers(1, 9), max_size=3),
    st.floats(0.62, 0.88),
)
def test_any_lost_and_doubled_pulses(
    pulses: int, ramp: float, lost: set[int], doubled: set[int], at: float
) -> None:
    """100 pulses at any constant acceleration; faults at multiples of ten pulses, no two in one place."""
    doubled -= lost
    angle = TURN * 100.0 / pulses * (TIME / 2.0 + ramp * (TIME / 2.0) ** 2) / (1.0 + ramp)
    train = pulse_train(angle, pulses_per_revolution=pulses)
    for k in lost:
        lose(train, angle, pulses, 10 * k)
    for k in doubled:
        double(train, angle, pulses, 10 * k, at)
    shaft = tacho_angle(train, TIME, pulses_per_revolution=pulses)
    assert (shaft.missing.size, shaft.doubled.size) == (len(lost), len(doubled))
    assert np.abs(error_in_pulses(shaft, angle, pulses)).max() < 0.01


def test_torsional_vibration_is_no_fault() -> None:
    """Speed ripple of 30 % once per turn, four pulses per turn."""
    angle = TURN * 20.0 * TIME
    angle = angle + 0.3 * np.sin(angle)
    shaft = tacho_angle(pulse_train(angle, pulses_per_revolution=4), TIME, pulses_per_revolution=4)
    assert shaft.missing.size == shaft.doubled.size == 0


@pytest.mark.parametrize(
    ("signal", "message"),
    [
        (np.full(40_000, 5.0), "constant at 5, it has no pulses"),
        (np.random.default_rng(0).standard_normal(40_000), "not an even train of pulses"),
        (np.sin(TURN * 1.0 * TIME), "has 1 pulses .limit 4."),
        (np.where(TIME < 1.0, np.sin(TURN * 30.0 * TIME**2), -1.0), None),
        (np.sin(TURN * 30.0 * (TIME - np.clip(TIME - 0.8, 0.0, 0.7))), "no pulse from 0.766667 s to 1.5 s"),
    ],
)
def test_channels_without_a_pulse_train(signal: np.ndarray, message: str | None) -> None:
    if message is None:  # a shaft that stops for good: the angle ends with the last pulse
        assert tacho_angle(signal, TIME, pulses_per_revolution=1).time[-1] < 1.0
        return
    with pytest.raises(SignalError, match=message):
        tacho_angle(signal, TIME, pulses_per_revolution=1)


def test_a_bouncing_contact_is_no_train() -> None:
    """Every pulse has a second edge a tenth of a pitch behind the first: which one is it?"""
    turns = 30.0 * TIME
    bouncing = ((np.mod(turns, 1.0) < 0.06) | (np.abs(np.mod(turns, 1.0) - 0.13) < 0.03)).astype(float)
    with pytest.raises(SignalError, match="not an even train of pulses"):
        tacho_angle(bouncing, TIME, pulses_per_revolution=1)


def test_wrong_settings_are_refused() -> None:
    sine = np.sin(TURN * 30.0 * TIME)
    with pytest.raises(SignalError, match="pulses_per_revolution: 0"):
        tacho_angle(sine, TIME, pulses_per_revolution=0)
    with pytest.raises(SignalError, match="hysteresis: 0.5"):
        rising_edges(sine, TIME, hysteresis=0.5)
    with pytest.raises(SignalError, match="more than half a pitch of 400 pulses"):
        pulse_train(TURN * 30.0 * TIME, pulses_per_revolution=400)
    with pytest.raises(SignalError, match="stops or reverses"):
        pulse_train(sine, pulses_per_revolution=1)


def test_angle_channel_wrapped_or_not() -> None:
    angle = TURN * (5.0 * TIME + 4.0 * TIME**2)
    plain, wrapped = angle_channel(angle, TIME), angle_channel(np.mod(angle, TURN), TIME)
    np.testing.assert_allclose(wrapped.angle, plain.angle, atol=1e-9)
    # differences of second order are exact for a parabola
    np.testing.assert_allclose(plain.speed, TURN * (5.0 + 8.0 * TIME), rtol=1e-7)
    assert plain.first_sample == 0 and plain.pulse_time.size == 0
    with pytest.raises(SignalError, match="does not rotate"):
        angle_channel(np.zeros(40_000), TIME)


def test_orders_of_a_run_up_from_its_tacho() -> None:
    """Order 12 of amplitude 2, speed from 5 to 21 turns per second, two pulses per turn."""
    angle = TURN * (5.0 * TIME + 4.0 * TIME**2)
    x = 2.0 * np.cos(12.0 * angle)
    shaft = tacho_angle(pulse_train(angle, pulses_per_revolution=2), TIME, pulses_per_revolution=2)
    x = x[shaft.first_sample : shaft.first_sample + shaft.angle.size]
    found = tracked_spectrum(x, shaft.angle, highest_order=30)
    top = int(np.argmax(found.amplitude))
    assert found.frequency[top] == pytest.approx(12.0, abs=1e-9)
    assert found.amplitude[top] == pytest.approx(2.0, rel=2e-3)
    m = order_map(x, shaft.angle, shaft.time, highest_order=30, revolutions=4)
    assert {float(m.order[k]) for k in m.amplitude.argmax(axis=1)} == {12.0}


def test_a_tacho_of_two_levels_gives_no_sidebands() -> None:
    """Read at 25.6 kHz, 371.4 pulses a second are late by anything up to a sample, 25 times a second anew:
    as an angle that is followed exactly, that would be sidebands 25 Hz next to a mesh line, 27 dB below it
    (modulation by a saw tooth of 39 us, 0.29 rad from end to end: first sideband 0.29/(2 pi))."""
    rate, speed = 25600.0, 37.1377
    time = np.arange(51200) / rate
    pulses = (np.mod(10.0 * speed * time, 1.0) < 0.5).astype(float)
    shaft = tacho_angle(pulses, time, pulses_per_revolution=10)
    x = np.cos(32.0 * TURN * speed * shaft.time)
    found = tracked_spectrum(x, shaft.angle, highest_order=40)
    beside = np.abs(np.abs(found.frequency - 32.0) - 25.0 / speed) < 0.1
    assert 20.0 * np.log10(found.amplitude[beside].max()) < -60.0
    # a shaft that really turns to and fro, by more than pulses are late, is followed nearer than one of them
    swing = 0.01 * np.sin(TURN * speed * time)
    pulses = (np.mod(10.0 * (speed * time + swing / TURN), 1.0) < 0.5).astype(float)
    shaft = tacho_angle(pulses, time, pulses_per_revolution=10)
    first = shaft.first_sample
    late = shaft.angle - (TURN * speed * time + swing)[first : first + shaft.angle.size]
    assert np.std(late) < TURN * speed / rate / 12**0.5 < 0.4 * np.std(swing)
