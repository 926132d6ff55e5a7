# SPDX-License-Identifier: Apache-2.0
"""What is reported when nothing is found although a test exceeds its limit; a line of two meshes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.analysis.diagnosis import Diagnosis, MeshLines
from pitchpoint.analysis.family_evidence import PARTLY
from pitchpoint.analysis.findings import Evidence, Finding
from pitchpoint.analysis.turning_parts import train_parts
from pitchpoint.report.diagnosis.over_angle import OverAngle
from pitchpoint.report.diagnosis.tooth_places import gear_turns, one_gear, place_sentence
from pitchpoint.report.diagnosis.words import (
    cells_of_test,
    nothing_found,
    observation,
    outcome,
    sentence,
    what_is_tested,
)


def _evidence(*, found: bool, explained: str = "", value: float = 9.0) -> Evidence:
    return Evidence("acc", "comb", "shaft 1", "", value, 3.0, 1e-9, 4.0, 0.1, 0, found, 0.01, explained)


@pytest.mark.parametrize(
    ("beyond", "words"),
    [
        (0, "none of 5 tests exceeds its limit"),
        (1, "1 of 5 tests exceeds its limit, but not in the pattern of damage"),
        (3, "3 of 5 tests exceed their limits, but not in the pattern of damage"),
    ],
)
def test_limits_that_are_exceeded_are_not_denied(beyond: int, words: str) -> None:
    evidence = tuple(_evidence(found=k < beyond, value=9.0 if k < beyond else 2.0) for k in range(5))
    assert nothing_found(Diagnosis((), (), evidence, {}, (), (), {}, 5, 0.01)) == f"nothing found: {words}"
    # what something explains has exceeded its limit as well; only some harmonics have not
    levels = [9.0 if k < beyond else 2.0 for k in range(5)]
    evidence = tuple(_evidence(found=False, explained="cage", value=level) for level in levels)
    assert nothing_found(Diagnosis((), (), evidence, {}, (), (), {}, 5, 0.01)) == f"nothing found: {words}"


def test_one_line_of_two_meshes_is_told_once() -> None:
    """Meshes at 32 and 16 orders of one shaft have their second sideband at 32.67 in common."""
    parts = train_parts([(32, 96), (48, 80)])
    rows = [
        Evidence("acc", "sidebands", "shaft 2", gear, 20.0, 11.0, 1e-9, 32.0 + 2.0 / 3.0, 0.1, 2, True, 0.01)
        for gear in ("Z2", "Z3")
    ]
    finding = Finding("local fault", "shaft 2", ("Z2", "Z3"), "acc", 1e-9)
    words = sentence(finding, Diagnosis((finding,), (), tuple(rows), {}, (), (), {}, 2, 0.01), parts, 30.0)
    assert words.count("980 Hz") == 1
    assert "sideband +2 of the mesh of Z2 and of that of Z3 (by noise alone" in words


@pytest.mark.parametrize(
    ("number", "words"),
    [
        (1, "sideband +1, is at 990 Hz in acc, 20 % of the largest mesh line; runout, eccentricity"),
        (-2, "sideband −2, is at 900 Hz in acc, 20 % of the largest mesh line; misalignment or an oval gear"),
        (-3, "sideband −3, is at 870 Hz in acc, 20 % of the largest mesh line; deviations that vary several"),
    ],
)
def test_the_cause_of_sidebands_follows_their_number(number: int, words: str) -> None:
    """A modulation once per turn has sidebands one shaft frequency from the mesh; 32 teeth at 30 Hz."""
    parts = train_parts([(32, 96)])
    row = Evidence(
        "acc", "sidebands", "shaft 1", "Z1", 20.0, 11.0, 1e-9, 32.0 + number, 0.1, number, True, 0.01
    )
    seen = Finding("modulation", "shaft 1", ("Z1",), "acc", 1e-9)
    lines = MeshLines("mesh 1", 32.0, np.array([0.5, 0.1]), True, ())
    found = Diagnosis((), (seen,), (row,), {"acc": (lines,)}, (), (), {}, 2, 0.01)
    text = observation(seen, found, parts, 30.0, "m/s^2")
    assert text.startswith("sidebands of the mesh of Z1 at multiples of the speed of shaft 1 (30 Hz): ")
    assert words in text and "once per turn" not in text


def test_the_word_bearing_is_not_repeated() -> None:
    parts = train_parts([(32, 96)])
    for name, words in (("A", "inner ring of bearing A, seen"), ("bearing", "inner ring of bearing, seen")):
        row = Evidence("acc", "bearing", "inner ring", name, 20.0, 15.0, 1e-9, 5.4, 0.0, 0, True, 0.01)
        finding = Finding("bearing", "inner ring", (name,), "acc", 1e-9)
        found = Diagnosis((finding,), (), (row,), {}, (), (), {}, 2, 0.01)
        assert words in sentence(finding, found, parts, 30.0)


def test_an_excluded_line_has_no_probability_by_noise() -> None:
    """The rule gives it the probability 1, which would contradict a value far above the limit."""
    row = replace(_evidence(found=False, explained="below 1 % of the rms"), probability=1.0)
    found = Diagnosis((), (), (row,), {}, (), (), {}, 1, 0.01)
    assert cells_of_test(row, found) == (
        "shaft 1",
        "all orders",
        "9.0 σ",
        "3.0 σ",
        "–",
        "below 1 % of the rms",
    )


def test_an_event_per_turn_is_told_with_its_highest_line() -> None:
    parts = train_parts([(11, 81), (12, 68)])
    row = Evidence("acc", "period", "shaft 2", "Z3", 5.8, 3.2, 1e-9, 11 / 81, 0.1, 0, True, 0.01)
    finding = Finding("local fault", "shaft 2", ("Z3",), "acc", 1e-9, level="Z3")
    found = Diagnosis((finding,), (), (row,), {}, (), (), {}, 9, 0.01)
    words = sentence(finding, found, parts, 12.0)
    assert "seen in acc as one event per turn (1.6296 Hz) with lines up to 39.111 Hz, 5.8 standard" in words
    assert outcome(row, found) == "found" and what_is_tested(row) == "period in the level of Z3"
    seen = replace(found, findings=(), observations=(replace(finding, kind="every order", gears=()),))
    words = observation(seen.observations[0], seen, parts, 12.0, "m/s^2")
    assert words.endswith("in acc; impacts at one angle of the turn are not visible")


def test_a_short_event_is_shared_evenly_between_the_gears_of_a_shaft() -> None:
    """A tenth of a pitch of Z3: both shares are stated, and no tooth is numbered."""
    parts = train_parts([(11, 81), (12, 68)])
    turned = np.arange(80_000) / 400.0
    x = 3.0 * ((turned * 11 / 81 + 0.3) % 1 < 0.1 / 12) + np.random.default_rng(1).standard_normal(
        turned.size
    )
    over = OverAngle({"acc": x}, 400.0, 10.0, 400.0)
    finding = Finding("local fault", "shaft 2", ("Z2", "Z3"), "acc", 1e-9)
    turns = gear_turns("acc", "shaft 2", over, parts)
    words = place_sentence(finding, turns, 0.01)
    for gear, share in (("Z2", "1.2"), ("Z3", "8.3")):
        assert f"within the angle of one tooth of {gear} ({share} % if spread evenly; by noise" in words
    assert words.endswith("; the event is too short to identify the gear")
    assert not one_gear(finding, turns) and "pitches" not in words
    # of the coarse gear alone, teeth are counted
    alone = replace(finding, gears=("Z3",)), turns[1:]
    assert one_gear(*alone) and "the tooth of 12 that meshes " in place_sentence(*alone, 0.01)


def test_every_test_above_its_limit_has_a_reason() -> None:
    """Found, observed, explained, or the rule that overrules it; nothing for a test below its limit."""
    comb, shared = _evidence(found=True), replace(_evidence(found=True), channel="other", shaft="shaft 2")
    rows = [
        _evidence(found=False, explained="outer ring of left"),
        _evidence(found=False, explained="below 1 % of the rms"),
        _evidence(found=False, explained=PARTLY),
        replace(_evidence(found=False), kind="bearing"),
        _evidence(found=False),
        replace(_evidence(found=False), value=2.0),
    ]
    shaft = Finding("local fault", "shaft 1", ("Z1",), "acc", 1e-9)
    every = Diagnosis((shaft,), (), (comb, shared, *rows), {}, (), (), {}, 8, 0.01)
    assert [outcome(row, every) for row in (comb, shared)] == ["found", "lines of a clearer part"]
    assert [outcome(row, every) for row in rows] == [
        "explained by outer ring of left",
        "below 1 % of the rms",
        "only some of its harmonics",
        "impacts not confirmed",
        "possible by noise",
        "",
    ]
    seen = replace(every, findings=(), observations=(replace(shaft, kind="every order"),))
    assert outcome(comb, seen) == "observed"
