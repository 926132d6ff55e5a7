# SPDX-License-Identifier: Apache-2.0
"""Speed of run-ups without gears against closed-form laws; half the speed; impacts alone; refusals."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.speed_track import SpeedTrack, speed_track
from pitchpoint.report.diagnosis.varying_speed import at_varying_speed
from tests.support.motor_run_ups import LAWS, MOTOR, RATE, motor_record

LIMITS = {"up": (4.0, 60.0), "down": (8.0, 40.0), "fast": (6.0, 85.0), "wave": (8.0, 40.0)}


def error_of(track: SpeedTrack, law: str) -> np.ndarray:
    """Relative error of the speed of the frames that are not stated to be uncertain, shape (n,)."""
    path = track.path
    step = 1e-4
    true = (LAWS[law](path.time + step) - LAWS[law](path.time - step)) / (2 * step)
    sure = np.ones(path.time.size, dtype=bool)
    for start, end in track.hidden:
        sure &= (path.time < start) | (path.time > end)
    assert sure.mean() > 0.7
    return np.asarray((path.frequency / true - 1.0)[sure])


@pytest.mark.parametrize(
    ("law", "part"), [("up", ""), ("up", "outer ring"), ("fast", "inner ring"), ("wave", "rolling element")]
)
def test_the_speed_is_that_of_the_law(law: str, part: str) -> None:
    """Ranges include half of the speed and twice the speed."""
    x, _ = motor_record(law, part, seed=3)
    track = speed_track({"acc": x}, RATE, MOTOR, *LIMITS[law])
    error = np.abs(error_of(track, law))
    assert np.median(error) < 0.01
    assert np.quantile(error, 0.9) < 0.05
    assert track.motor and track.motor.impacts == (f"{part} of DE" if part else "")
    assert track.motor.orders[:2] == (1.0, 2.0)


def test_uncertain_times_have_a_length() -> None:
    """The lines of the first second are smeared: the speed doubles in it."""
    x, _ = motor_record("fast", "inner ring", seed=3)
    hidden = speed_track({"acc": x}, RATE, MOTOR, *LIMITS["fast"]).hidden
    assert hidden[0, 0] < 0.3 and hidden[0, 1] > 0.7
    assert np.all(hidden[:, 1] > hidden[:, 0])


def test_impacts_alone_fit_two_parts() -> None:
    """The orders of the rings have a ratio of 1.51; without shaft orders only the range excludes one."""
    x, _ = motor_record("slow", "outer ring", seed=3, shaft=0.0)
    with pytest.raises(SignalError, match="impacts of .* fit equally well"):
        speed_track({"acc": x}, RATE, MOTOR, 12.0, 48.0)
    over = at_varying_speed({"acc": x}, np.arange(x.size) / RATE, MOTOR, (22.0, 33.0), "motor")
    track = over.found.track if over.found else None
    assert track and track.motor and track.motor.impacts == "outer ring of DE" and track.motor.orders == ()
    assert np.median(np.abs(error_of(track, "slow"))) < 0.02
    assert over.tolerance > 0.01
    assert "it would be the" in over.doubt and "only the given range determines the speed" in over.doubt


@pytest.mark.parametrize("mains", [False, True])
def test_noise_and_mains_have_no_speed(mains: bool) -> None:
    x = np.random.default_rng(1014).standard_normal(60_000)
    if mains:
        t = np.arange(x.size) / RATE
        x += sum(0.5 * np.cos(2 * np.pi * f * t) for f in (50, 100, 150))
    with pytest.raises(SignalError, match="no shaft orders determine it within 600 to 1200 rpm: the level"):
        speed_track({"acc": x}, RATE, MOTOR, 10.0, 20.0)


def test_a_range_beyond_the_speed_is_refused() -> None:
    x, _ = motor_record("up", seed=5)
    with pytest.raises(SignalError, match="range|determine|fit equally well"):
        speed_track({"acc": x}, RATE, MOTOR, 30.0, 90.0)
