# SPDX-License-Identifier: Apache-2.0
"""Findings that a surer one explains: one true fault is named alone, two true faults are both named."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.diagnosis import Diagnosis, diagnose
from pitchpoint.analysis.explaining import Strikes
from pitchpoint.analysis.remarks import Note, grouped
from pitchpoint.analysis.turning_parts import Bearing, TurningParts, train_parts

RATE, TURNS = 413.3, 150.0
INNER, BALL = 4.9477, 3.9839
"""Strikes of a damaged inner ring; of a ball, 0.9 % from the first sideband of those of the inner ring."""


def _parts(**orders: float) -> TurningParts:
    named = {name.replace("_", " "): order for name, order in orders.items()}
    return train_parts([(21, 40)], [Bearing("left", {"cage": 0.3815} | named, "shaft 1")])


def _turned() -> np.ndarray:
    return np.arange(int(RATE * TURNS)) / RATE


def _knocks(turned: np.ndarray, order: float, *, carried: float = 0.0, depth: float = 0.0) -> np.ndarray:
    """Strikes that ring at order 130; their size changes with what carries the damage through the load."""
    since = (turned * order + 0.3) % 1 / order
    size = 1.0 + depth * (np.cos(2 * np.pi * carried * turned) + np.cos(4 * np.pi * carried * turned))
    return size * np.exp(-60 * since) * np.sin(2 * np.pi * 130 * since)


def _healthy(turned: np.ndarray, seed: int = 3) -> np.ndarray:
    mesh = np.cos(2 * np.pi * 21 * turned) + 0.5 * np.cos(2 * np.pi * 42 * turned)
    return mesh + 0.4 * np.random.default_rng(seed).standard_normal(turned.size)


def _named(found: Diagnosis) -> set[tuple[str, str]]:
    return {(finding.kind, finding.shaft) for finding in found.findings}


def test_a_ball_is_not_named_for_the_sidebands_of_an_inner_ring() -> None:
    """Sidebands at 3.948 and 7.895 orders are harmonics of a ball that slips by 0.9 %."""
    turned = _turned()
    knocks = 2.0 * _knocks(turned, INNER, carried=1.0, depth=0.8)
    found = diagnose({"acc": _healthy(turned) + knocks}, RATE, _parts(inner_ring=INNER, rolling_element=BALL))
    assert _named(found) == {("bearing", "inner ring")}
    (ball,) = [e for e in found.evidence if e.shaft == "rolling element"]
    assert ball.probability < 0.01 and ball.explained == "inner ring of left" and not ball.found
    assert (
        "explained by inner ring of left, without whose lines nothing of it stands out: "
        "rolling element of left in acc"
    ) in found.untested


@pytest.mark.parametrize("slip", [0.0, 0.004])
def test_a_ball_that_strikes_as_well_is_named_beside_the_inner_ring(slip: float) -> None:
    turned = _turned()
    knocks = 2.0 * _knocks(turned, INNER, carried=1.0, depth=0.8)
    knocks += 2.0 * _knocks(turned, BALL * (1.0 - slip), carried=0.3815, depth=0.4)
    found = diagnose({"acc": _healthy(turned) + knocks}, RATE, _parts(inner_ring=INNER, rolling_element=BALL))
    assert _named(found) == {("bearing", "inner ring"), ("bearing", "rolling element")}


def _beside_a_mesh(turned: np.ndarray) -> np.ndarray:
    """Strikes of 3.6 orders with a line 0.3 lines of the record from the sideband at 20 orders."""
    order = (20.0 + 0.3 / TURNS) / 6.0
    return 0.8 * _knocks(turned, order) + 0.5 * np.cos(2 * np.pi * 6 * order * turned)


def test_a_sideband_is_not_named_for_a_harmonic_of_strikes() -> None:
    """No harmonic of strikes of 3.3336 orders but each sixth comes near to an order of the shaft."""
    turned = _turned()
    parts = _parts(outer_ring=(20.0 + 0.3 / TURNS) / 6.0)
    found = diagnose({"acc": _healthy(turned) + 2 * _beside_a_mesh(turned)}, RATE, parts)
    assert _named(found) == {("bearing", "outer ring")}


@pytest.mark.parametrize("side", [-1, 2])
def test_a_gear_out_of_true_is_named_beside_a_bearing(side: int) -> None:
    """Sidebands of the mesh where the strikes have no line."""
    turned = _turned()
    x = _healthy(turned) + 2.0 * _knocks(turned, INNER, carried=1.0, depth=0.8)
    x += 0.5 * np.cos(2 * np.pi * (21 + side) * turned)
    found = diagnose({"acc": x}, RATE, _parts(inner_ring=INNER, rolling_element=BALL))
    assert _named(found) == {("bearing", "inner ring"), ("modulation", "shaft 1")}


def test_a_chipped_tooth_is_named_beside_a_bearing() -> None:
    turned = _turned()
    x = _healthy(turned) + 2.0 * _knocks(turned, INNER, carried=1.0, depth=0.8)
    x += 3.0 * np.exp(-((((turned * 21 / 40) % 1 - 0.5) / 0.003) ** 2))
    found = diagnose({"acc": x}, RATE, _parts(inner_ring=INNER, rolling_element=BALL))
    assert _named(found) == {("bearing", "inner ring"), ("local fault", "shaft 2")}


def test_lines_of_strikes_stand_at_all_their_products() -> None:
    """k f + j n and those about a mesh; neither lines of the shaft nor of the mesh alone."""
    place, causes = Strikes(5.1, 1.0, np.array([21.0])).lines(30.0)
    listed = {round(float(p), 6): c for p, c in zip(place, causes, strict=True)}
    assert listed[5.1] == 1 and listed[4.1] == 2 and listed[13.2] == 5
    assert listed[21 + 5.1 - 2] == 103
    assert not {1.0, 2.0, 21.0, 20.0, 22.0} & set(listed)
    assert place.min() > 0.0 and place.max() < 30.0


def test_one_reason_is_told_once() -> None:
    notes = [Note("no test of {}: why", "a"), Note("whole"), Note("no test of {}: why", "b")]
    assert grouped([*notes, *notes]) == ["no test of a, b: why", "whole"]
