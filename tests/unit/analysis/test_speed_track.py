# SPDX-License-Identifier: Apache-2.0
"""Angle of records at varying speed against closed-form phases; refusals."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.speed_track import speed_track
from pitchpoint.analysis.tooth_numbers import sideband_teeth
from pitchpoint.analysis.turning_parts import Shaft, TurningParts, train_parts
from pitchpoint.report.diagnosis.over_angle import over_angle

Array = NDArray[np.float64]
RATE = 8000.0
TIME: Array = np.arange(80_000) / RATE
PAIR = train_parts([(20, 31)])
# revolutions in closed form
LAWS: dict[str, Callable[[Array], Array]] = {
    "up": lambda t: 10.0 * t + t**2,
    "down": lambda t: 30.0 * t - t**2,
    "steady": lambda t: 21.3 * t,
    "wave": lambda t: 20.0 * t - 9.0 * 7.0 / (2 * np.pi) * np.cos(2 * np.pi * t / 7.0),
}


def record(turns: Array, level: float, seed: int = 3, modulation: float = 0.1) -> Array:
    """Three mesh harmonics, modulated by both shafts, and noise this far below them [dB]."""
    angle = 2 * np.pi * turns
    x = sum(a * np.cos(20 * k * angle + k) for k, a in ((1, 1.0), (2, 0.5), (3, 0.3)))
    x = x * (1 + modulation * np.cos(angle) + modulation * np.cos(angle * 20 / 31))
    noise = np.random.default_rng(seed).standard_normal(turns.size)
    return np.asarray(x / np.std(x) * 10 ** (level / 20) + noise)


@pytest.mark.each_value
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize(("level", "limit"), [(20.0, 0.001), (0.0, 0.005), (-10.0, 0.02)])
def test_the_angle_agrees_with_the_closed_form(law: str, level: float, limit: float) -> None:
    """Noise in the band of the lines causes 0.1, 1 and 4 mrad; the window adds that of the ends."""
    turns = LAWS[law](TIME)
    found = speed_track({"acc": record(turns, level)}, RATE, PAIR, 10.0, 30.0)
    error = found.angle - 2 * np.pi * turns
    assert np.std(error) < limit
    assert found.orders[0] in (20.0, 40.0, 60.0)
    assert found.path.score > found.path.rival


def test_a_resonance_shifts_the_angle_by_its_phase_only() -> None:
    """A mesh line that crosses a resonance changes its phase by π: π/20 rad of the shaft at most."""
    from scipy.signal import lfilter

    turns = LAWS["up"](TIME)
    natural, damping = 2 * np.pi * 400.0 / RATE, 0.03
    poles = np.exp(-damping * natural) * np.array([2 * np.cos(natural), 0.0])
    x = lfilter([1.0], [1.0, -poles[0], np.exp(-2 * damping * natural)], record(turns, 20.0))
    found = speed_track({"acc": x}, RATE, PAIR, 10.0, 30.0)
    error = found.angle - 2 * np.pi * turns
    assert np.ptp(error[4000:-4000]) < np.pi / 20


@pytest.mark.parametrize("seed", range(4))
def test_noise_is_refused(seed: int) -> None:
    x = np.random.default_rng(seed).standard_normal(TIME.size // 2)
    with pytest.raises(SignalError, match="determine it within 600 to 1800 rpm"):
        speed_track({"acc": x}, RATE, PAIR, 10.0, 30.0)


@pytest.mark.parametrize(
    ("low", "high", "samples", "rate", "words"),
    [
        (30.0, 10.0, 80_000, RATE, "low below high"),
        (15.0, 30.0, 80_000, RATE, "leaves the range"),
        (36.0, 60.0, 80_000, RATE, "range|determine"),
        (10.0, 30.0, 2000, RATE, "too short"),
        (10.0, 30.0, 80_000, 1000.0, "sample rate: 1000 Hz"),
        (0.0, 30.0, 80_000, RATE, "low: 0"),
    ],
)
def test_bad_input_is_refused(low: float, high: float, samples: int, rate: float, words: str) -> None:
    x = record(LAWS["up"](TIME), 10.0)[:samples]
    with pytest.raises(SignalError, match=words):
        speed_track({"acc": x}, rate, PAIR, low, high)


def test_no_channel_is_refused() -> None:
    with pytest.raises(SignalError, match="no channel"):
        speed_track({}, RATE, PAIR, 10.0, 30.0)


def test_wrong_tooth_numbers_leave_the_range() -> None:
    """13 instead of 20 teeth: the speed would be 923 to 2770 rpm."""
    x = record(LAWS["up"](TIME), 10.0)
    with pytest.raises(SignalError, match="leaves the range"):
        speed_track({"acc": x}, RATE, train_parts([(13, 31)]), 10.0, 30.0)


@pytest.mark.parametrize("teeth", [(21, 31), (20, 31)])
def test_sidebands_show_the_number_of_teeth(teeth: tuple[int, int]) -> None:
    x = {"acc": record(LAWS["up"](TIME), 10.0)}
    parts = train_parts([teeth])
    over = over_angle(x, TIME, speed_track(x, RATE, parts, 10.0, 30.0).angle)
    found = sideband_teeth(over.signals, over.samples_per_turn, parts)
    assert [row.found for row in found] == [20, 31]


def test_a_machine_without_gears() -> None:
    """Harmonics of one shaft."""
    from fractions import Fraction

    turns = LAWS["up"](TIME)
    x = sum(np.cos(2 * np.pi * k * turns + k) / k for k in range(1, 9))
    x = x + 0.3 * np.random.default_rng(1).standard_normal(TIME.size)
    found = speed_track({"acc": x}, RATE, TurningParts((Shaft("motor", Fraction(1)),)), 10.0, 30.0)
    error = found.angle - 2 * np.pi * turns
    assert np.std(error) < 0.05


def test_the_result_does_not_depend_on_scale_and_order_of_channels() -> None:
    turns = LAWS["up"](TIME)
    a, b = record(turns, 0.0, 1), record(turns, 0.0, 2)
    one = speed_track({"a": a, "b": b}, RATE, PAIR, 10.0, 30.0)
    two = speed_track({"b": 1e3 * b, "a": 1e3 * a}, RATE, PAIR, 10.0, 30.0)
    np.testing.assert_allclose(one.angle, two.angle, atol=1e-9)
