# SPDX-License-Identifier: Apache-2.0
"""Tacho channels are told from vibration by their levels and edges."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.pulse_trains import is_pulse_train

RATE = 5000.0
TIME = np.arange(20_000) / RATE
NOISE = np.random.default_rng(1).standard_normal(TIME.size)
TURNED = 10.0 * TIME + 0.8 * TIME**2


def ringing(turned, damping):
    """Impacts once a turn that ring and decay."""
    since = turned % 1.0
    return np.exp(-damping * since) * np.sin(2.0 * np.pi * 90.0 * since)


def lobe(turned, place):
    """What an inductive pickup gives of one tooth a turn, without the other sign."""
    return np.exp(-(((turned % 1.0 - place) / 0.02) ** 2))


@pytest.mark.parametrize(
    "pulses",
    [
        ((4.0 * TURNED) % 1.0 < 0.5).astype(float),
        5.0 * (TURNED % 1.0 < 0.05) - 2.0,
        (TURNED % 1.0 < 0.1) + 0.02 * NOISE,
        np.clip(20.0 * np.sin(2.0 * np.pi * TURNED), -1.0, 1.0),
        lobe(TURNED, 0.3) + 0.02 * NOISE,
        -lobe(2.0 * TURNED, 0.3),
        (1.0 + 0.02 * TURNED) * (lobe(TURNED, 0.3) - lobe(TURNED, 0.36)) + 0.02 * NOISE,
    ],
)
def test_pulses_in_a_run_up_are_recognised(pulses):
    assert is_pulse_train(pulses, TIME)


@pytest.mark.parametrize(
    "vibration",
    [
        np.sin(2.0 * np.pi * 20.0 * TURNED),
        NOISE,
        ringing(TURNED, 30.0),
        np.abs(ringing(TURNED, 30.0)),
        ringing(TURNED, 3.0) + 0.1 * NOISE,
        np.sin(2.0 * np.pi * 20.0 * TURNED) * (1.0 + 0.5 * np.sin(2.0 * np.pi * TURNED)),
        ringing(TURNED, 90.0) + 0.02 * NOISE,
        np.where(NOISE > 3.0, 5.0, 0.0) + 0.1 * NOISE,
        lobe(TURNED, 0.3) * np.cos(2.0 * np.pi * 60.0 * TURNED),
        np.zeros(TIME.size),
    ],
)
def test_vibration_is_not(vibration):
    assert not is_pulse_train(vibration, TIME)
