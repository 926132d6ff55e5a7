# SPDX-License-Identifier: Apache-2.0
"""Speed from the lines of a record: lines of the mains are not evidence for the speed of a shaft."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from pitchpoint.analysis.line_tests import fine_spectrum
from pitchpoint.analysis.speed_search import FoundSpeed, speed_from_lines
from pitchpoint.analysis.turning_parts import Shaft, TurningParts
from pitchpoint.report.diagnosis.steady_speed import at_speed

RATE = 10_000.0
MOTOR = TurningParts((Shaft("motor", Fraction(1)),))
MAINS = {50.0: (50.0, 100.0, 150.0, 200.0), 60.0: (60.0, 120.0, 180.0, 240.0)}


def record(*lines: float) -> np.ndarray:
    """Lines of an amplitude of 1 [Hz] in white noise with an rms of 1."""
    t = np.arange(100_000) / RATE
    noise = np.random.default_rng(1).standard_normal(t.size)
    return np.asarray(sum(np.cos(2 * np.pi * f * t + f) for f in lines) + noise)


def found(nominal: float, *lines: float) -> FoundSpeed:
    """Speed near a nominal one [Hz]."""
    return speed_from_lines([fine_spectrum(record(*lines), RATE)], MOTOR, nominal, 0.02)


@pytest.mark.parametrize(("mains", "rpm"), [(60.0, 1780), (60.0, 3560), (50.0, 1480), (50.0, 2950)])
def test_lines_of_the_mains_are_not_those_of_a_shaft(mains: float, rpm: float) -> None:
    speed = found(rpm / 60.0, *MAINS[mains])
    assert speed.what == "" and speed.tolerance > 0.0
    assert set(MAINS[mains][:3]) <= set(speed.mains)


@pytest.mark.parametrize("slip", [0.003, 0.01, 0.02])
def test_an_induction_motor_next_to_louder_mains(slip: float) -> None:
    turns = 30.0 * (1.0 - slip)
    speed = found(29.6, *MAINS[60.0], *(k * turns for k in (1, 2, 3, 4)))
    assert speed.what == "shaft"
    assert speed.frequency == pytest.approx(turns, rel=2e-4)


def test_multiples_of_one_harmonic_are_those_of_a_faster_shaft() -> None:
    assert found(29.2, *(2 * k * 29.2 for k in (1, 2, 3, 4))).what == ""
    assert found(29.2, *(k * 29.2 for k in (2, 3, 4))).what == "shaft"


def test_the_remark_names_the_lines_and_the_option() -> None:
    over = at_speed({"acc": record(*MAINS[60.0])}, RATE, MOTOR, 1780.0 / 60.0, 0.02)
    said = " ".join(over.remarks)
    assert "within ±2 % of" in said and "bearings" not in said
    assert "60 Hz, 120 Hz, 180 Hz" in said and "--speed 1500rpm±0%" in said
