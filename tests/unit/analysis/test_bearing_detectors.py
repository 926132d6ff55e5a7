# SPDX-License-Identifier: Apache-2.0
"""Detectors of bearing damage: impacts that repeat exactly, and machines without damage."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from pitchpoint.analysis.bearing_detectors import TONES, PartLevels, part_levels
from pitchpoint.analysis.turning_parts import Bearing, Shaft, TurningParts

RATE, TURNS = 400, 150
ORDERS = {"outer ring": 3.5848, "inner ring": 5.4152, "rolling element": 4.714, "cage": 0.39828}
PARTS = TurningParts((Shaft("rotor", Fraction(1)),), (), (Bearing("left", ORDERS, "rotor"),))


def levels(values: np.ndarray) -> dict[str, PartLevels]:
    """Levels by part."""
    found, _ = part_levels(values, RATE, PARTS, tolerance=0.0, slip=0.01, false_alarm=0.01)
    return {one.part: one for one in found}


def impacts(slip: float, rng: np.random.Generator) -> np.ndarray:
    """Impacts of the outer ring that ring at order 110, intervals with a relative deviation, in noise."""
    at = np.cumsum(rng.normal(1.0, slip, int(TURNS * ORDERS["outer ring"]))) / ORDERS["outer ring"]
    x = rng.standard_normal(RATE * TURNS)
    for when in at[at < TURNS - 1]:
        first = int(when * RATE) + 1
        since = np.arange(first, first + 120) / RATE - when
        x[first : first + 120] += 8.0 * np.exp(-25.0 * since) * np.sin(220.0 * np.pi * since)
    return x


def test_impacts_without_slip_are_found_by_the_squared_envelope() -> None:
    """They are tones, which all other detectors remove; with 1 % of random slip these find them."""
    rng = np.random.default_rng(3)
    exact, slipping = levels(impacts(0.0, rng)), levels(impacts(0.01, rng))
    assert [part for part, one in exact.items() if one.named] == ["outer ring"]
    assert exact["outer ring"].by == (TONES,)
    assert [part for part, one in slipping.items() if one.named] == ["outer ring"]
    assert set(slipping["outer ring"].by) > {TONES}


def test_tones_of_a_sound_machine_have_no_family() -> None:
    """Twenty orders of the shaft, thirty multiples of a belt at 0.37 and tones of mains: no part is named."""
    rng = np.random.default_rng(4)
    turned = np.arange(RATE * TURNS) / RATE
    orders = [*range(1, 21), *(0.37 * k for k in range(1, 31)), *(2.07 * k for k in range(1, 7))]
    x = rng.standard_normal(turned.size)
    x += sum(
        rng.uniform(0.2, 2.0) * np.cos(2.0 * np.pi * order * turned + rng.uniform(0.0, 6.3))
        for order in orders
    )
    assert not any(one.named for one in levels(x).values())
