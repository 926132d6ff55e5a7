# SPDX-License-Identifier: Apache-2.0
"""Lines of bearings next to orders of a shaft that are wider than the resolution of the record."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from pitchpoint.analysis.bearing_tests import SLIP, _part
from pitchpoint.analysis.line_tests import fine_spectrum
from pitchpoint.analysis.turning_parts import train_parts

RATE, TURNS = 60.0, 250.0
PARTS = train_parts([(21, 63)])
"""Shafts of orders 1 and 1/3."""
BALL = 1.328
"""0.4 % below four thirds: with 0.7 % slip its third harmonic is three lines of the record from order 4."""


def _envelope(step: float, seed: int, bearing: float = 0.0) -> NDArray[np.float64]:
    """Impacts once per turn of the slower shaft, whose angle has a step [rad of the reference shaft]."""
    turned = np.arange(int(RATE * TURNS)) / RATE
    angle = 2 * np.pi * turned + step / (1 + np.exp(-(turned - 0.7 * TURNS) / 2.0))
    x = sum(np.cos(k * angle / 3 + k) for k in range(1, 60))
    x = x + bearing * sum(np.cos(2 * np.pi * k * BALL * 1.007 * turned + k) for k in (1, 2, 3))
    noise = 0.5 * np.random.default_rng(seed).standard_normal(turned.size)
    return np.asarray(x + noise, dtype=np.float64)


@pytest.mark.parametrize("seed", [1, 2, 3, 4])
@pytest.mark.parametrize("step", [0.0, 0.2, 0.4])
def test_a_wide_order_of_a_shaft_is_no_bearing(step: float, seed: int) -> None:
    """A step of 0.2 rad changes the phase of order 4 by 0.8 rad: its line is wide."""
    found = _part(fine_spectrum(_envelope(step, seed), RATE), BALL, PARTS, 0.5 * RATE, SLIP)
    assert found.probability > 0.01


@pytest.mark.parametrize("step", [0.0, 0.2, 0.4])
def test_a_bearing_next_to_wide_orders_is_found(step: float) -> None:
    found = _part(fine_spectrum(_envelope(step, 1, 0.5), RATE), BALL, PARTS, 0.5 * RATE, SLIP)
    assert found.probability < 1e-4
    assert found.order / BALL / 1.007 == pytest.approx(round(found.order / BALL), rel=1e-3)
