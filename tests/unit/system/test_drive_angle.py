# SPDX-License-Identifier: Apache-2.0
"""A body may be held at an angle: a prescribed angle that is a plain value."""

from __future__ import annotations

import math

import pytest

from pitchpoint.elements import drive
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.system.rules.drive import drive_bank
from tests.support.model_files import TORSIONAL_PAIR

STEADY = "steady: {speed: {driver: 1500 rpm}, duration: 0.5 s, sample_rate: 100 kHz}"


@pytest.mark.parametrize("angle", ["30 deg", "-0.5", "0"])
def test_a_constant_angle_stays_where_it_is(angle: str) -> None:
    model = loads_model(
        TORSIONAL_PAIR.replace(STEADY, f"steady: {{drive: {{driver: {{angle: {angle}}}}}, duration: 1 s}}")
    )
    bank = drive_bank(model, model.scenarios["steady"])
    assert bank.pool is not None
    bank.records["pool"] = bank.pool.ctypes.data
    expected = math.radians(30.0) if "deg" in angle else float(angle)
    for t in (0.0, 0.3, 7.0):
        assert drive.target(bank.records[0], t)[:3] == pytest.approx((expected, 0.0, 0.0), abs=1e-15)


@pytest.mark.parametrize("first", [0.0, 1.0])
def test_a_table_of_angles_is_passed_through(first: float) -> None:
    table = f"{{table: [[{first} s, 0.5], [{first + 1.0} s, 0.6], [{first + 2.0} s, 0.75]]}}"
    model = loads_model(
        TORSIONAL_PAIR.replace(STEADY, f"steady: {{drive: {{driver: {{angle: {table}}}}}, duration: 3 s}}")
    )
    bank = drive_bank(model, model.scenarios["steady"])
    assert bank.pool is not None
    bank.records["pool"] = bank.pool.ctypes.data
    for t, angle in ((first, 0.5), (first + 1.0, 0.6), (first + 2.0, 0.75)):
        assert drive.target(bank.records[0], t)[0] == pytest.approx(angle, abs=1e-12)
