# SPDX-License-Identifier: Apache-2.0
"""JSON, tables and progress."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from pitchpoint.cli import output, progress


def test_json_is_strict_and_plain(capsys: pytest.CaptureFixture[str]) -> None:
    data = {
        "a": np.array([1.0, math.nan]),
        "b": np.float64(2.0),
        "c": np.int64(3),
        "d": (math.inf, None, True),
    }
    output.emit_json(data)
    assert json.loads(capsys.readouterr().out) == {
        "a": [1.0, None],
        "b": 2.0,
        "c": 3,
        "d": [None, None, True],
    }


@pytest.mark.parametrize(
    ("value", "dimension", "expected"),
    [
        (0.1, "length", "100 mm"),
        (math.radians(15.8), "angle", "15.8 deg"),
        (12.370472e9, "stiffness_per_width", "12.37047 N/(mm µm)"),
        (2.0 * math.pi * 25.0, "angular_speed", "1500 rpm"),
        (None, "length", "–"),
        (math.nan, "length", "–"),
        (True, "dimensionless", "yes"),
        ("left", "dimensionless", "left"),
    ],
)
def test_people_see_the_units_they_use(value: object, dimension: str, expected: str) -> None:
    assert output.shown(value, dimension) == expected


def test_tables_keep_every_character_in_a_pipe(capsys: pytest.CaptureFixture[str]) -> None:
    output.table("T [b]", ["quantity", "[one]"], [["a [bold]", "1" * 60], [], ["b", "2"]], ["note [x]"])
    out = capsys.readouterr().out
    for text in ("T [b]", "a [bold]", "1" * 60, "[one]", "note [x]"):
        assert text in out


class Clock:
    """A clock that only moves when told to."""

    def __init__(self) -> None:
        self.now = 100.0

    def monotonic(self) -> float:
        """Give the time."""
        return self.now


def test_progress_is_silent_for_two_seconds_then_a_line_every_few(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    clock = Clock()
    monkeypatch.setattr(progress.time, "monotonic", clock.monotonic)
    with progress.ProgressDisplay("run steady", "steps") as display:
        for k in range(100):
            clock.now = 100.0 + 0.1 * k
            display(10.0 * k, 2000.0, "t = 1 s" if k > 60 else "")
    captured = capsys.readouterr()
    assert captured.out == ""
    lines = captured.err.splitlines()
    assert lines == [
        "run steady: 10 %, 100 steps/s, 18 s left",
        "run steady: 25 %, 100 steps/s, 15 s left",
        "run steady: 40 %, 100 steps/s, 12 s left, t = 1 s",
    ]


def test_quiet_progress_says_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    clock = Clock()
    monkeypatch.setattr(progress.time, "monotonic", clock.monotonic)
    display = progress.ProgressDisplay("run", quiet=True)
    clock.now += 100.0
    display(1.0, 2.0)
    assert capsys.readouterr().err == ""


def test_terminals_get_a_bar(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    clock = Clock()
    monkeypatch.setattr(progress.time, "monotonic", clock.monotonic)
    with progress.ProgressDisplay("sweep", "points") as display:
        display._terminal = True
        clock.now += 4.0
        display(0.0, 10.0)
        clock.now += 5.0
        display(5.0, 10.0)
        assert display._bar.tasks[0].completed == 5.0
        assert display._bar.tasks[0].fields["rate"] == "1 points/s"
        assert display._bar.tasks[0].fields["remaining"] == "5 s left"
    assert display._bar.live.is_started is False
