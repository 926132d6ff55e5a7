# SPDX-License-Identifier: Apache-2.0
"""Findings that a surer one explains: one true fault is named alone, two true faults are both named."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.diagnosis import Diagnosis, diagnose
from pitchpoint.analysis.explaining import ImpactLines
from pitchpoint.analysis.line_tests import fine_spectrum
from pitchpoint.analysis.remarks import Note, grouped
from pitchpoint.analysis.turning_parts import Bearing, TurningParts, train_parts

RATE, TURNS = 413.3, 150.0
INNER, BALL = 4.9477, 3.9839
"""Lines of a damaged inner ring; of a ball, 0.9 % from the first sideband of those of the inner ring."""


def _parts(**orders: float) -> TurningParts:
    named = {name.replace("_", " "): order for name, order in orders.items()}
    return train_parts([(21, 40)], [Bearing("left", {"cage": 0.3815} | named, "shaft 1")])


def _turned() -> np.ndarray:
    return np.arange(int(RATE * TURNS)) / RATE


def _knocks(
    turned: np.ndarray, order: float, *, carried: float = 0.0, depth: float = 0.0, late: float = 0.0
) -> np.ndarray:
    """Impacts that ring at order 130; size and phase change with what carries the damage through the load."""
    since = (turned * order + 0.3 + late * np.sin(2 * np.pi * carried * turned)) % 1 / order
    size = 1.0 + depth * (np.cos(2 * np.pi * carried * turned) + np.cos(4 * np.pi * carried * turned))
    return size * np.exp(-300 * since) * np.sin(2 * np.pi * 130 * since)


def _healthy(turned: np.ndarray, seed: int = 3) -> np.ndarray:
    mesh = np.cos(2 * np.pi * 21 * turned) + 0.5 * np.cos(2 * np.pi * 42 * turned)
    return mesh + 0.02 * np.random.default_rng(seed).standard_normal(turned.size)


def _named(found: Diagnosis) -> set[tuple[str, str]]:
    every = (*found.findings, *found.observations)
    return {(one.kind, one.shaft) for one in every if one.kind != "every order"}


def test_a_ball_is_not_named_for_the_sidebands_of_an_inner_ring() -> None:
    """Sidebands at 3.948 and 7.895 orders are harmonics of a ball that slips by 0.9 %."""
    turned = _turned()
    knocks = 2.0 * _knocks(turned, INNER, carried=1.0, depth=0.4)
    found = diagnose({"acc": _healthy(turned) + knocks}, RATE, _parts(inner_ring=INNER, rolling_element=BALL))
    assert _named(found) == {("bearing", "inner ring")}
    (ball,) = [e for e in found.evidence if e.shaft == "rolling element"]
    assert ball.probability < 0.01 and ball.explained == "inner ring of left" and not ball.found
    assert (
        "explained by inner ring of left, without whose lines it is not significant: "
        "rolling element of left in acc"
    ) in found.unreported


def test_a_ball_that_strikes_as_well_is_named_beside_the_inner_ring() -> None:
    """The cage alone is not named: its turns are those of the ball."""
    turned = _turned()
    knocks = 2.0 * _knocks(turned, INNER, carried=1.0, depth=0.4)
    knocks += 2.0 * _knocks(turned, BALL * 0.996, carried=0.3815, depth=0.4)
    found = diagnose({"acc": _healthy(turned) + knocks}, RATE, _parts(inner_ring=INNER, rolling_element=BALL))
    assert _named(found) == {("bearing", "inner ring"), ("bearing", "rolling element")}


def test_a_mesh_is_not_modulated_where_strikes_have_a_line() -> None:
    """Six strikes and a turn of the shaft are 20 orders and 0.3 lines of the record: next to a mesh at 21."""
    turned, order = _turned(), (19.0 + 0.3 / TURNS) / 6.0
    x = _healthy(turned) + 2.0 * _knocks(turned, order, carried=1.0, depth=0.4)
    x += 0.3 * np.cos(2 * np.pi * (6 * order + 1.0) * turned)
    found = diagnose({"acc": x}, RATE, _parts(inner_ring=order))
    assert _named(found) == {("bearing", "inner ring")}
    (sideband,) = [e for e in found.evidence if (e.kind, e.shaft) == ("sidebands", "shaft 1")]
    assert sideband.explained == "inner ring of left"
    assert sideband.order == 20.0 and sideband.probability < 0.01


def test_a_gear_out_of_true_is_named_beside_a_bearing() -> None:
    """Sidebands of the mesh where the strikes have no line."""
    turned = _turned()
    x = _healthy(turned) + 2.0 * _knocks(turned, INNER, carried=1.0, depth=0.4)
    x += 0.5 * np.cos(2 * np.pi * 20 * turned)
    found = diagnose({"acc": x}, RATE, _parts(inner_ring=INNER, rolling_element=BALL))
    assert _named(found) == {("bearing", "inner ring"), ("modulation", "shaft 1")}


def test_a_chipped_tooth_is_named_beside_a_bearing() -> None:
    turned = _turned()
    x = _healthy(turned) + 2.0 * _knocks(turned, INNER, carried=1.0, depth=0.4)
    x += 3.0 * np.exp(-((((turned * 21 / 40) % 1 - 0.5) / 0.003) ** 2))
    found = diagnose({"acc": x}, RATE, _parts(inner_ring=INNER, rolling_element=BALL))
    assert _named(found) == {("bearing", "inner ring"), ("local fault", "shaft 2")}


def test_a_ball_is_not_named_for_sidebands_that_are_stronger_than_the_strikes() -> None:
    """Impacts that come early and late, as with a shaft out of true, have lower sidebands above all else."""
    turned, inner, ball = _turned(), 4.6477, 3.68
    knocks = 2.0 * _knocks(turned, inner, carried=1.0, depth=0.4, late=-0.2)
    found = diagnose({"acc": _healthy(turned) + knocks}, RATE, _parts(inner_ring=inner, rolling_element=ball))
    sure = {e.shaft: e.probability for e in found.evidence}
    assert sure["rolling element"] < sure["inner ring"] < 1e-6
    assert ("bearing", "rolling element") not in _named(found) and ("bearing", "inner ring") in _named(found)
    knocks += 2.0 * _knocks(turned, ball * 0.996, carried=0.3815, depth=0.4)
    found = diagnose({"acc": _healthy(turned) + knocks}, RATE, _parts(inner_ring=inner, rolling_element=ball))
    assert {("bearing", "inner ring"), ("bearing", "rolling element")} <= _named(found)


@pytest.mark.parametrize(("apart", "named"), [(0.1, set()), (1.0, {("modulation", "shaft 1")})])
def test_a_mesh_is_not_modulated_where_balls_pass_beside_loud_lines(
    apart: float, named: set[tuple[str, str]]
) -> None:
    """A mesh at 21, five loud passages and one of another bearing: 0.1 lines from a sideband at 41."""
    turned, loud = _turned(), 3.57
    other = 41.0 - 21.0 - 5.0 * loud + apart / TURNS
    bearings = [
        Bearing("loud", {"outer ring": loud}, "shaft 1"),
        Bearing("other", {"outer ring": other}, "shaft 2"),
    ]
    passing = 1.0 + 0.4 * sum(np.cos(2 * np.pi * k * loud * turned) for k in range(1, 6))
    x = _healthy(turned) * passing + 0.04 * np.cos(2 * np.pi * 41.0 * turned)
    found = diagnose({"acc": x}, RATE, train_parts([(21, 40)], bearings))
    assert _named(found) == {("bearing", "outer ring")} | named
    (sideband,) = [e for e in found.evidence if (e.kind, e.shaft) == ("sidebands", "shaft 1")]
    assert sideband.order == 41.0 and sideband.probability < 1e-6
    assert sideband.explained == ("" if named else "outer ring of loud")


SLOW = 1.5193
"""Lines of an outer ring; those of another one, three times as quick, have every third of its lines."""


def _two_bearings(turned: np.ndarray, knocks: np.ndarray) -> set[tuple[str, str]]:
    bearings = [
        Bearing("slow", {"outer ring": SLOW}, "shaft 1"),
        Bearing("quick", {"outer ring": 3 * SLOW}, "shaft 1"),
    ]
    parts = train_parts([(21, 40)], bearings)
    found = diagnose({"acc": _healthy(turned) + knocks}, RATE, parts)
    return {(finding.shaft, *finding.gears) for finding in found.findings}


def test_strikes_three_times_as_quick_are_not_those_of_the_slow_bearing() -> None:
    """Passing balls of the healthy slow bearing make weak lines between, too weak for a finding."""
    turned = _turned()
    knocks = 1.0 * _knocks(turned, 3 * SLOW)
    assert _two_bearings(turned, knocks) == {("outer ring", "quick")}
    passing = 0.004 * sum(np.cos(2 * np.pi * SLOW * k * turned + k) for k in (1, 2, 4, 5))
    assert _two_bearings(turned, knocks * (1.0 + passing)) == {("outer ring", "quick")}


def test_lines_of_strikes_stand_at_all_their_products() -> None:
    """k f + j n and those about a mesh; neither lines of the shaft nor of the mesh alone."""
    strikes = ImpactLines(5.1, 1.0, np.array([21.0]))
    signal, envelope = (set(strikes.lines(30.0, envelope=which).round(6)) for which in (False, True))
    assert {5.1, 4.1, 13.2, 21 + 5.1 - 2, 21 - 2 * 5.1 + 1} <= signal <= envelope
    # the fourth harmonic and the mesh shake in time with their difference
    assert round(21 - 4 * 5.1, 6) in envelope - signal
    assert not {1.0, 2.0, 21.0, 20.0, 22.0} & envelope
    assert min(envelope) > 0.0 and max(envelope) < 30.0


def test_a_ball_turns_with_its_cage_and_may_strike_one_ring_harder() -> None:
    lines = set(ImpactLines(4.0, 0.4, np.empty(0), ball=True).lines(9.0, envelope=True).round(6))
    assert {0.4, 0.8, 2.0, 1.6, 4.0, 4.4, 6.0} <= lines


def test_lines_beside_strikes_are_no_larger_than_these() -> None:
    """Impacts at 5.1 with the turns of a shaft next to them; what lies on the strikes is their own."""
    turned = np.arange(int(RATE * TURNS)) / RATE
    strikes = ImpactLines(5.1, 1.0, np.empty(0))

    def beside(order: float, amplitude: float) -> bool:
        tones = 0.3 * np.cos(2 * np.pi * 5.1 * turned) + amplitude * np.cos(2 * np.pi * order * turned)
        return strikes.have_sideband(order, fine_spectrum(tones, RATE))

    assert beside(4.1, 0.2) and beside(10.2 - 3.0, 0.2)
    assert not beside(4.1, 0.4)
    assert not beside(4.1 + 1.0 / TURNS, 0.2) and not beside(10.2, 0.2)


def test_one_reason_is_told_once() -> None:
    notes = [Note("no test of {}: why", "a"), Note("whole"), Note("no test of {}: why", "b")]
    assert grouped([*notes, *notes]) == ["no test of a, b: why", "whole"]
