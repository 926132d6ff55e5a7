# SPDX-License-Identifier: Apache-2.0
"""Prescribed speeds as tables: every feature of the law is in them, whatever the duration."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import CompileError
from pitchpoint.model.components.law import FormulaLaw
from pitchpoint.system.rules import drive
from pitchpoint.system.rules.drive import speed_table, tabulate


def test_a_ripple_on_the_grid_of_the_first_table_is_seen():
    # 1 kHz over 20 s: all 20001 first points and all points between them lie in its zeros
    t, w = speed_table(FormulaLaw("100 + 0.05*sin(2*pi*1000*t)"), 20.0)
    assert t[0] == 0.0
    assert t[-1] == 20.0
    assert np.all(np.diff(t) > 0.0)
    at = np.random.default_rng(1).uniform(0.0, 20.0, 20000)
    law = 100.0 + 0.05 * np.sin(2 * np.pi * 1000.0 * at)
    assert np.max(np.abs(np.interp(at, t, w) - law)) < 1.1e-4


def test_kinks_cost_points_only_where_they_are():
    t, w = speed_table(FormulaLaw("100*min(t/0.0123, 1)"), 50.0)
    assert t.size < 21000
    at = np.linspace(0.0, 0.02, 7001)
    np.testing.assert_allclose(np.interp(at, t, w), 100.0 * np.minimum(at / 0.0123, 1.0), atol=2e-4)


@pytest.mark.parametrize("text", ["100", "0", "100*t"])
def test_straight_laws_keep_the_first_table(text):
    assert speed_table(FormulaLaw(text), 3.0)[0].size == drive.N_TABLE


def test_a_jump_is_refused_with_its_time():
    with pytest.raises(CompileError, match=r"jumps at t = 0\.300\d* s.*smoothstep"):
        tabulate(lambda t: np.where(t < 0.3001, 100.0, 120.0), 0.0, 1.0)


def test_what_no_table_can_hold_is_refused(monkeypatch):
    monkeypatch.setattr(drive, "MOST_POINTS", 100_000)
    with pytest.raises(CompileError, match="shorter duration, or the speed as a table"):
        speed_table(FormulaLaw("100 + 10*sin(2*pi*1000*t)"), 20.0)
