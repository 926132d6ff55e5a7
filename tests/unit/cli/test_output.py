# SPDX-License-Identifier: Apache-2.0
"""JSON, tables and progress."""

from __future__ import annotations

import json
import math
import re

import numpy as np
import pytest

from pitchpoint.cli import output, planet_loads, progress, results
from pitchpoint.cli.columns import Column
from pitchpoint.core.progress import report_step


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
        (-1.2e-16, "angle", "0 deg"),  # of a direction
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


def test_shares_have_no_negative_zero(capsys: pytest.CaptureFixture[str]) -> None:
    loads = {
        "planets": ["a", "b"],
        "meshes": ["s-a", "s-b"],
        "mean_force": [-1e-6, 2.0],
        "share": [-4e-5, 1.0],
    }
    planet_loads.show_planets({"set": {**loads, "load_sharing_factor": 2.0}})
    printed = capsys.readouterr().out
    assert " 0.00 %" in printed and "-0.00 %" not in printed


def test_tables_keep_every_character_in_a_pipe(capsys: pytest.CaptureFixture[str]) -> None:
    output.table("T [b]", ["quantity", "[one]"], [["a [bold]", "1" * 60], [], ["b", "2"]], ["note [x]"])
    out = capsys.readouterr().out
    for text in ("T [b]", "a [bold]", "1" * 60, "[one]", "note [x]"):
        assert text in out


def printed(capsys: pytest.CaptureFixture[str]) -> list[str]:
    """Lines on stdout, without blank ones and rules."""
    return [line.strip() for line in capsys.readouterr().out.splitlines() if line.strip(" ─")]


def test_a_narrow_table_breaks_neither_numbers_nor_keys(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(output, "PIPE", 80)
    columns = ["channel", "mean", "alternating rms", "min", "max"]
    rows = [
        ["transmission_error[second]", "-58.948 µm", "0.91291 µm", "-60.735 µm", "-58.021 µm"],
        ["bearing_force[A1.mx]", "-1469.4 N m", "10.041 N m", "-1105.9 N m", "-1104.8 N m"],
    ]
    output.table("run", columns, rows)
    lines = printed(capsys)
    assert max(map(len, lines)) <= 80
    assert re.split(r"\s{2,}", lines[-1]) == rows[1]
    assert [word for word in lines[-3].split("  ") if word][0] == "transmission_error"
    assert lines[-2] == "[second]"
    assert sum("alternating" in line for line in lines) == 1


def test_a_share_stays_with_its_sign_of_per_cent(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(output, "PIPE", 60)
    name = "intermediate translation x 47 %, output translation x 21 %, intermediate rotation 12 %"
    output.table("modes", ["mode", "frequency", "damping ratio"], [[name, "1512.23 Hz", "3.216 %"]])
    lines = printed(capsys)
    assert max(map(len, lines)) <= 60
    assert "1512.23 Hz" in lines[2]
    assert "3.216 %" in lines[2]
    for share in ("47 %,", "21 %,", "12 %"):
        assert any(share in line for line in lines)


def test_columns_without_room_follow_below(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(output, "PIPE", 80)
    names = [f"gear{k}" for k in range(8)]
    output.table("T", ["", *names], [["polar inertia", *(f"{k}.1166e-05 kg m^2" for k in range(8))], []])
    lines = printed(capsys)
    assert lines[0] == "T"
    assert sum("polar inertia" in line for line in lines) == 3
    assert max(map(len, lines)) <= 80
    text = "\n".join(lines)
    assert all(f"{k}.1166e-05 kg m^2" in text for k in range(8))
    output.table("T", ["one", "two", *names], [["a", "b", *["1.23456789 N/(mm µm)"] * 8]], keys=2)
    lines = printed(capsys)
    assert sum(line.split()[:2] == ["a", "b"] for line in lines) == 3


def test_a_word_that_fits_nowhere_is_kept(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(output, "PIPE", 30)
    output.table("T", ["key", "value"], [["k" * 50, "v" * 40]])
    out = capsys.readouterr().out
    assert "k" * 50 in out
    assert "v" * 40 in out


def test_channels_that_are_zero_are_counted(capsys: pytest.CaptureFixture[str]) -> None:
    """A zero beside micrometres is told in micrometres."""
    nothing = {"unit": "N", "mean": 0.0, "rms": 0.0, "min": 0.0, "max": 0.0}
    channels = {f"bearing_force[left.{axis}]": nothing for axis in ("mx", "my", "mz")}
    channels["deflection[m]"] = {"unit": "m", "mean": 2e-6, "rms": 0.0, "min": 2e-6, "max": 2e-6}
    results.statistics_table("run", channels)
    lines = printed(capsys)
    assert lines[-1] == "zero throughout, not shown: 3 of bearing_force"
    assert lines[-2].split("  ")[-1].strip() == "2 µm"
    assert "0 µm" in lines[-2]
    assert sum("bearing_force" in line for line in lines) == 1


def test_speeds_of_channels_have_a_unit(capsys: pytest.CaptureFixture[str]) -> None:
    wind = {"unit": "m/s", "mean": 8.0, "rms": 0.5, "min": 7.0, "max": 9.0}
    results.statistics_table("run", {"hub_wind_speed[rotor]": wind})
    assert "8 m/s" in "\n".join(printed(capsys))


def test_zeros_of_a_table_have_one_unit(capsys: pytest.CaptureFixture[str]) -> None:
    channels = {
        f"bearing_force[{name}]": {"unit": "N", "mean": mean, "rms": 0.0, "min": 0.0, "max": mean}
        for name, mean in (("a", 2e4), ("b", 200.0))
    }
    results.statistics_table("run", channels)
    text = "\n".join(printed(capsys))
    assert "20 kN" in text and "200 N" in text
    assert text.count(" 0 N") == 4 and " 0 kN" not in text


def test_orders_and_names_that_begin_with_a_number_are_text() -> None:
    """Only texts are broken between words."""
    orders = Column("order", ["2× mesh st2", "24× rotor (torque motor)", "1st bending of mid"])
    assert orders.words
    assert not Column("speed", ["2 rpm", "-24.5 %", "1e3"]).words


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


@pytest.mark.parametrize(("last", "lines"), [(100.0, ["10 %", "25 %", "100 %"]), (60.0, ["10 %", "25 %"])])
def test_the_last_line_of_finished_work_is_100_per_cent(
    last: float,
    lines: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The end comes too soon after the line before; what is stopped on the way has no such line."""
    clock = Clock()
    monkeypatch.setattr(progress.time, "monotonic", clock.monotonic)
    with progress.ProgressDisplay("run", "steps") as display:
        for now, done in ((0.0, 0.0), (2.0, 10.0), (5.0, 25.0), (6.0, last)):
            clock.now = 100.0 + now
            display(done, 100.0)
    said = capsys.readouterr().err.splitlines()
    assert [line.split(": ")[1].split(",")[0] for line in said] == lines
    assert "0 s left" not in said[-1]


def test_what_comes_before_the_work_is_told_too(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Without a share, and in the same measure; the forecast counts from the first report on."""
    clock = Clock()
    monkeypatch.setattr(progress.time, "monotonic", clock.monotonic)
    with progress.ProgressDisplay("run steady", "steps") as display:
        for now in (1.0, 3.0, 4.0, 7.0):
            clock.now = 100.0 + now
            report_step(f"equilibrium, step {now:.0f}")
        for now, done in ((8.0, 0.0), (10.5, 250.0)):
            clock.now = 100.0 + now
            display(done, 1000.0)
    report_step("nobody listens any more")
    assert capsys.readouterr().err.splitlines() == [
        "run steady: equilibrium, step 3",
        "run steady: equilibrium, step 7",
        "run steady: 25 %, 100 steps/s, 8 s left",
    ]


@pytest.mark.parametrize("interactive", ["0", "1"])
def test_no_bar_where_nothing_moves(interactive: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """TTY_INTERACTIVE=0: pages of documentation record no bars."""
    clock = Clock()
    monkeypatch.setattr(progress.time, "monotonic", clock.monotonic)
    monkeypatch.setenv("TTY_INTERACTIVE", interactive)
    with progress.ProgressDisplay("run") as display:
        display._terminal = True
        clock.now += 4.0
        display(2.0, 8.0)
        assert display._bar.disable is (interactive == "0")


def test_terminals_show_it_beside_the_bar(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock()
    monkeypatch.setattr(progress.time, "monotonic", clock.monotonic)
    with progress.ProgressDisplay("run") as display:
        display._terminal = True
        clock.now += 4.0
        report_step("equilibrium, step 3")
        assert display._bar.tasks[0].fields["note"] == "equilibrium, step 3"
        assert display._bar.tasks[0].total is None
        clock.now += 1.0
        display(2.0, 8.0)
        clock.now += 1.0
        report_step("equilibrium, step 1")
        assert (display._bar.tasks[0].completed, display._bar.tasks[0].total) == (2.0, 8.0)


def test_quiet_progress_says_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    clock = Clock()
    monkeypatch.setattr(progress.time, "monotonic", clock.monotonic)
    display = progress.ProgressDisplay("run", quiet=True)
    clock.now += 100.0
    display(1.0, 2.0)
    display.aside("equilibrium, step 3")
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
        display(10.0, 10.0)
        assert display._bar.tasks[0].completed == 5.0
    assert display._bar.tasks[0].completed == 10.0
    assert display._bar.live.is_started is False
