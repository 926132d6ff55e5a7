# SPDX-License-Identifier: Apache-2.0
"""Prescribed speeds in pieces: every feature of the law is in them, whatever the duration."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad

from pitchpoint.core.errors import CompileError
from pitchpoint.core.formula.formula import Formula
from pitchpoint.elements import drive, speed_profile
from pitchpoint.elements.signal import Pool
from pitchpoint.elements.speed_profile import fit_pieces, straight_pieces
from pitchpoint.model.components.law import FormulaLaw
from pitchpoint.system.rules.drive import speed_pieces as pieces_of


@pytest.mark.parametrize("amplitude", [0.05, 90.0])
def test_a_long_strong_ripple_on_the_grid_of_the_first_pieces_is_followed(amplitude):
    # 1 kHz over 60 s: all ends and middles of the first pieces lie in its zeros
    pieces = pieces_of(FormulaLaw(f"100 + {amplitude}*sin(2*pi*1000*t)"), 60.0)
    assert pieces.edges[0] == 0.0
    assert pieces.edges[-1] == 60.0
    assert np.all(np.diff(pieces.edges) > 0.0)
    at = np.random.default_rng(1).uniform(0.0, 60.0, 20000)
    law = 100.0 + amplitude * np.sin(2 * np.pi * 1000.0 * at)
    assert np.max(np.abs(pieces.speed(at) - law)) < 4e-7
    assert pieces.angles()[-1] == pytest.approx(6000.0, abs=1e-7)


def test_kinks_cost_pieces_only_where_they_are():
    pieces = pieces_of(FormulaLaw("100*min(t/0.0123, 1)"), 50.0)
    assert len(pieces.powers) < speed_profile.FIRST_PIECES + 100
    at = np.linspace(0.0, 0.02, 7001)
    np.testing.assert_allclose(pieces.speed(at), 100.0 * np.minimum(at / 0.0123, 1.0), atol=2e-7)


@pytest.mark.parametrize("text", ["100", "0", "100*t", "3 + t^4"])
def test_smooth_laws_keep_the_first_pieces(text):
    assert len(pieces_of(FormulaLaw(text), 3.0).powers) == speed_profile.FIRST_PIECES


def test_a_jump_is_refused_with_its_time():
    with pytest.raises(CompileError, match=r"jumps at t = 0\.300\d* s.*smoothstep"):
        fit_pieces(lambda t: np.where(t < 0.3001, 100.0, 120.0), 0.0, 1.0)


def test_what_no_pieces_can_hold_is_refused(monkeypatch):
    monkeypatch.setattr(speed_profile, "MAX_PIECES", 10_000)
    with pytest.raises(CompileError, match="shorter duration, or the speed as a table"):
        pieces_of(FormulaLaw("100 + 10*sin(2*pi*1000*t)"), 20.0)


@pytest.mark.parametrize(("begin", "end"), [(0.0, 2.0), (-1.0, 2.0), (0.5, 2.0), (-3.0, -1.0)])
@pytest.mark.parametrize("smooth", [False, True])
def test_angle_speed_and_acceleration_belong_together(begin, end, smooth):
    """Beyond the ends the speed stays; the angle is its integral from t = 0."""
    at = np.linspace(begin, end, 9)

    def law(t):
        return 5.0 + 3.0 * np.sin(2.0 * np.asarray(t))

    pieces = fit_pieces(law, begin, end, at) if smooth else straight_pieces(at, law(at))
    record, pool = np.zeros(1, drive.RECORD)[0], Pool()
    drive.set_speed_pieces(record, pool, pieces)
    record["angle"] = 0.25
    memory = pool.array()
    record["pool"] = memory.ctypes.data
    given = law if smooth else lambda t: np.interp(t, at, law(at))
    for t in (-4.0, -0.7, 0.0, 0.5, 0.77, 1.6, 2.0, 3.0):
        angle, speed, acceleration = drive.target(record, t)
        assert speed == pytest.approx(given(np.clip(t, begin, end)), abs=1e-8)
        whole = quad(lambda s: given(np.clip(s, begin, end)), 0.0, t, points=[*at, begin, end], limit=200)[0]
        assert angle == pytest.approx(0.25 + whole, abs=1e-7)
        inside = begin < t < end and not np.any(np.abs(at - t) < 1e-3)
        if inside:
            slope = (drive.target(record, t + 1e-6)[1] - drive.target(record, t - 1e-6)[1]) / 2e-6
            assert acceleration == pytest.approx(slope, abs=1e-5)
        elif not begin <= t <= end:
            assert acceleration == 0.0


@pytest.mark.parametrize("t", [0.0, 0.1234, 1000.0003])
def test_acceleration_of_an_angle_formula_at_any_time(t):
    record, pool = np.zeros(1, drive.RECORD)[0], Pool()
    drive.set_angle_formula(record, pool, Formula.parse("3*t + 0.01*sin(2*pi*500*t)", ("t",)))
    memory = pool.array()
    record["pool"] = memory.ctypes.data
    omega = 2.0 * np.pi * 500.0
    found = drive.target(record, t)
    assert found[1] == pytest.approx(3.0 + 0.01 * omega * np.cos(omega * t), abs=1e-6)
    assert found[2] == pytest.approx(-0.01 * omega**2 * np.sin(omega * t), abs=1e-6 * omega**2)
