# SPDX-License-Identifier: Apache-2.0
"""Loads given as tables: what they are between their points, beyond them and turn after turn."""

from __future__ import annotations

import math

import pytest

from pitchpoint.elements.signal import signal
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.system.rules.load import load_banks
from tests.support.machines import SPARE


def at(table: str, over: str, *, t: float = 0.0, angle: float = 0.0, turns: int = 0):
    """Value and slope over the angle of the table of one load."""
    body = "bodies: {b: {motion: torsion, inertia: 1 kg m^2}}\n"
    load = f"loads: {{l: {{body: b, torque: {{table: {table}, over: {over}}}}}}}\n"
    bank = load_banks(loads_model(SPARE + body + load))[0]
    assert bank.pool is not None
    bank.records["pool"] = bank.pool.ctypes.data
    return signal(bank.records[0], t, angle, turns, 0.0, 1)[:2]


@pytest.mark.parametrize("turns", [0, 3, -2])
@pytest.mark.parametrize(
    ("angle", "value", "slope"),
    [(0.125, 1.5, 4.0), (0.25, 2.0, 4.0), (0.75, 2.0, -4.0), (1.5, 3.0, -4.0), (-1.5, 3.0, -4.0)],
)
def test_a_table_over_angle_repeats_from_its_first_angle(angle, value, slope, turns):
    """Period 1 rad from 1 to 2 rad: at -1.5 rad stands what stands at 1.5 rad, whatever is before 1 rad."""
    moved = angle - 2.0 * math.pi * turns
    found = at("[[1, 1 N m], [1.5, 3 N m], [2, 1 N m]]", "angle", angle=moved, turns=turns)
    if value == 3.0:
        assert found[0] == pytest.approx(value, abs=1e-12)
    else:
        assert found == pytest.approx((value, slope), abs=1e-12)


@pytest.mark.parametrize("turns", [0, 5])
def test_a_table_over_a_turn_that_begins_elsewhere(turns):
    table = "[[90 deg, 10 N m], [180 deg, 20 N m], [450 deg, 10 N m]]"
    assert at(table, "angle", angle=math.pi / 4, turns=turns)[0] == pytest.approx(20 - 10 * 225 / 270)
    assert at(table, "angle", angle=3 * math.pi / 4, turns=turns)[0] == pytest.approx(15.0)


def test_a_table_over_time_is_constant_beyond_its_ends():
    table = "[[1 s, 1 N m], [2 s, 3 N m]]"
    assert [at(table, "time", t=t)[0] for t in (0.0, 1.5, 7.0)] == [1.0, 2.0, 3.0]
