# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint diagnose FOLDER`: one row per file; channels of one record; vibration severity of the files."""

from __future__ import annotations

import csv
import json
import math
import re
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.report.diagnosis import many
from tests.support.cli_files import json_of
from tests.support.rig_records import rig_file

TRAIN = ["--train", "32/95", "--speed", "10Hz"]


@pytest.fixture(scope="module")
def records(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A broken pinion, a sound one, a file without samples, and a text about them."""
    folder = tmp_path_factory.mktemp("rig")
    for name, fault in (("run10.csv", 2.0), ("run9.csv", 0.0)):
        Path(rig_file(folder, fault)).rename(folder / name)
    (folder / "empty.csv").write_text("time [s],acc [m/s^2]\n", encoding="utf-8")
    (folder / "notes.md").write_text("three runs\n", encoding="utf-8")
    return folder


@pytest.fixture
def folder(records: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(records, tmp_path / "rig"))


def diagnosed(folder: Path, *more: str) -> int:
    return run_command(["diagnose", str(folder), *TRAIN, *more])


def without_time(data: Any) -> Any:
    """Rows of a table without the time of each diagnosis, which differs between runs."""
    return [{key: value for key, value in row.items() if not key.startswith("time")} for row in data]


def test_a_table_has_a_row_for_each_file(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code = diagnosed(folder, "-o", str(folder / "table.csv"))
    assert code == 3  # one file is not diagnosed
    shown = capsys.readouterr().out
    assert shown.index("empty.csv") < shown.index("run9.csv") < shown.index("run10.csv")
    assert "local fault on Z1" in shown and "not diagnosed: " in shown
    assert ": notes.md" in shown
    with (folder / "table.csv").open(encoding="utf-8") as file:
        failed, sound, broken = csv.DictReader(file)
    assert (sound["verdict"], broken["verdict"]) == ("nothing found", "local fault on Z1")
    assert float(broken["value"]) > float(broken["limit"])
    assert float(broken["speed [rpm]"]) == pytest.approx(600.0, rel=1e-3)
    assert broken["channel"] == "acc" and float(broken["time [s]"]) >= 0.0
    assert failed["verdict"] == "not diagnosed" and failed["sentences"] and not failed["value"]
    # a second run omits the table and gives the same numbers
    assert diagnosed(folder, "-o", str(folder / "table.json"), "-q") == 3
    again = json.loads((folder / "table.json").read_text(encoding="utf-8"))
    assert again["omitted"] == ["notes.md", "table.csv"]
    assert diagnosed(folder, "-o", str(folder / "table.json"), "-q") == 3
    twice = json.loads((folder / "table.json").read_text(encoding="utf-8"))
    assert without_time(again["files"]) == without_time(twice["files"])
    assert again["files"][2]["frequency"] == pytest.approx(10.0, rel=1e-3)


def test_files_that_are_no_records_are_skipped_and_broken_ones_are_rows(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "run10.csv").unlink()
    (folder / "note.txt").write_text("bearing changed on 3 May\nnew oil\n", encoding="utf-8")
    (folder / "tool.bin").write_bytes(b"\x7fELF" + bytes(range(256)))
    shutil.copy(folder / "run9.csv", folder / "run9.dat")  # numbers with an unusual ending
    (folder / "broken.mat").write_bytes(b"MATLAB 5.0 MAT-file" + bytes(200))
    assert diagnosed(folder, "--json") == 3
    found = json.loads(capsys.readouterr().out)
    rows = {row["file"]: row for row in found["files"]}
    assert {name: row["failed"] for name, row in rows.items()} == {
        "broken.mat": True,
        "empty.csv": True,
        "run9.csv": False,
        "run9.dat": False,
    }
    assert found["omitted"] == ["note.txt", "notes.md", "tool.bin"]
    # a speed that is not known has no tolerance
    assert rows["broken.mat"]["tolerance"] is None and rows["run9.csv"]["tolerance"] == 0.0
    assert diagnosed(folder) == 3
    assert "3 files are not records, omitted: note.txt, notes.md, tool.bin" in capsys.readouterr().out


def test_all_files_diagnosed_is_success(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "empty.csv").unlink()
    found = json_of(["diagnose", str(folder), *TRAIN], capsys)
    assert [row["verdict"] for row in found["files"]] == ["nothing found", "local fault on Z1"]
    assert found["failed"] == 0


def test_the_page_has_the_sentences_of_each_file(folder: Path) -> None:
    page = folder.parent / "table.html"
    assert diagnosed(folder, "-o", str(page)) == 3
    text = page.read_text(encoding="utf-8")
    assert text.index(">Files</h2>") < text.index(">Results</h2>")
    assert text.count("<h3>") == 2 and "not diagnosed: " in text
    assert "a local fault on gear Z1 (shaft 1, 9.9999 Hz)" in text


def test_an_option_that_is_wrong_for_all_files_is_one_error(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "empty.csv").unlink()
    assert run_command(["diagnose", str(folder), "--train", "32-95", "--speed", "10Hz"]) == 2
    said = capsys.readouterr()
    assert said.err.count("is not a pair of tooth counts") == 1 and not said.out


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (["run9.csv"], "is a folder; give one folder, or files"),
        (["-o", "table.txt"], "is not a table"),
        (["--all-channels", "-c", "acc"], "--all-channels and --channel both choose channels"),
    ],
)
def test_unsuitable_arguments(
    folder: Path, capsys: pytest.CaptureFixture[str], more: list[str], words: str
) -> None:
    given = [str(folder / one) if one.endswith(("csv", "txt")) else one for one in more]
    assert diagnosed(folder, *given) == 2
    assert words in capsys.readouterr().err


def test_a_folder_without_records(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "README").write_text("nothing yet", encoding="utf-8")
    assert diagnosed(tmp_path) == 2
    assert "has no measured file or result" in capsys.readouterr().err


def test_one_channel_files_of_a_folder_are_joined(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "empty.csv").unlink()
    found = json_of(["diagnose", str(folder), *TRAIN, "--join"], capsys)
    (finding,) = found["findings"]
    assert finding["channel"] == "run10"
    assert [row["channel"] for row in finding["levels"]] == ["run10", "run9"]
    assert run_command(["diagnose", str(folder / "run9.csv"), *TRAIN, "--join"]) == 2
    assert "--join requires a folder" in capsys.readouterr().err


@pytest.mark.parametrize(("name", "error"), [("run9", KeyboardInterrupt()), ("run9", ZeroDivisionError("x"))])
def test_an_interruption_keeps_the_rows_so_far_and_a_bug_all_others(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch, name: str, error: BaseException
) -> None:
    """Rows of empty.csv, run9.csv and run10.csv, in this order."""
    own = many.diagnose_file

    def stops(request: Any) -> Any:
        """Fails at one of the files."""
        if name in request.file:
            raise error
        return own(request)

    monkeypatch.setattr(many, "diagnose_file", stops)
    stopped = isinstance(error, KeyboardInterrupt)
    for ending in ("csv", "json", "html"):
        assert diagnosed(folder, "-o", str(folder.parent / f"part.{ending}")) == (130 if stopped else 3)
    said = capsys.readouterr()
    assert ("interrupted after 1 of 3 files; the others are not in the table" in said.out) == stopped
    assert said.err.count("interrupted") == 3 * stopped
    lines = (folder.parent / "part.csv").read_text(encoding="utf-8").splitlines()
    rows = list(csv.DictReader(lines))
    assert [row["file"] for row in rows] == ["empty.csv", "run9.csv", "run10.csv"][: 1 if stopped else 3]
    found = json.loads((folder.parent / "part.json").read_text(encoding="utf-8"))
    assert found["interrupted"] == stopped and found["not_reached"] == 2 * stopped
    page = (folder.parent / "part.html").read_text(encoding="utf-8")
    assert ("interrupted after 1 of 3 files" in page) == stopped
    if not stopped:
        assert rows[1]["sentences"] == "internal error: ZeroDivisionError: x; diagnose this file alone"
        assert rows[2]["verdict"] == "local fault on Z1"


def test_an_interruption_at_the_first_file_writes_nothing(folder: Path, monkeypatch) -> None:
    def stops(request: Any) -> Any:
        """Interrupted at once."""
        raise KeyboardInterrupt

    monkeypatch.setattr(many, "diagnose_file", stops)
    assert diagnosed(folder, "-o", str(folder / "part.csv")) == 130
    assert not (folder / "part.csv").exists()


@pytest.mark.parametrize(("group", "zone"), [("2 rigid", "B"), ("small", "C")])
def test_severity_is_the_velocity_of_the_lines(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], group: str, zone: str
) -> None:
    """Mesh lines of 6 and 2.4 m/s² at 320 and 640 Hz: 6/(2π 320 √2) sqrt(1 + 0.2²) = 2.15 mm/s.

    Zone B of machines on rigid supports is from 1.4 to 2.8 mm/s, zone C of small ones from 1.8 to 4.5 mm/s.
    Tolerance: noise of 0.1 m/s² in 2500 Hz has 0.1/(2π) sqrt((1/2 - 1/1000)/2500) = 0.23 mm/s; 1 % in all.
    """
    time = np.arange(10_000) / 5000.0
    x = np.cos(2 * np.pi * 320 * time) + 0.4 * np.cos(2 * np.pi * 640 * time)
    x += np.random.default_rng(3).standard_normal(time.size) / 60.0
    file = str(tmp_path / "rig.csv")
    np.savetxt(file, np.c_[time, x], delimiter=",", header="time [s],acc", comments="", fmt="%.8g")
    arguments = ["diagnose", file, *TRAIN, "--unit", "a*=6 m/s^2", "--machine-group", group]
    found = json_of(arguments, capsys)
    (row,) = found["severity"]
    expected = 6.0 / (2.0 * math.pi * 320.0 * math.sqrt(2.0)) * math.hypot(1.0, 0.2)
    assert row["velocity"] == pytest.approx(expected, rel=0.015)
    assert row["band"] == [2.0, 1000.0]  # the second shaft is slower than 600 rpm
    assert row["zone"] == zone
    bad = [one for one in found["findings"] if one["kind"] == "severity"]
    assert len(bad) == (zone in "CD")
    assert run_command(arguments) == 0
    shown = capsys.readouterr().out
    standard = "ISO 10816-1 class I" if group == "small" else "ISO 20816-3 group 2, rigid"
    assert f"vibration severity in acc: 2.2 mm/s rms (2 to 1000 Hz), zone {zone} of {standard}" in shown
    assert ("not acceptable for long-term operation" in shown) == bool(bad)


def test_an_unknown_machine_group_or_unit_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = rig_file(tmp_path, 0.0)
    assert run_command(["diagnose", file, *TRAIN, "--machine-group", "2 rigit"]) == 2
    assert "no group '2 rigit'; did you mean 2 rigid?" in capsys.readouterr().err
    assert run_command(["diagnose", file, *TRAIN, "--unit", "ac=m/s^2"]) == 2
    assert "--unit: no channel ac; did you mean acc?" in capsys.readouterr().err
    assert run_command(["diagnose", file, *TRAIN, "--unit", "acc=V", "--machine-group", "small"]) == 0
    assert "no channel of a housing is an acceleration or velocity" in capsys.readouterr().out


def test_pages_of_machines_without_gears_do_not_mention_them(tmp_path: Path) -> None:
    time = np.arange(40_000) / 5000.0
    noise = np.random.default_rng(5).standard_normal(time.size)
    heads = "time [s],acc [m/s^2]"
    np.savetxt(tmp_path / "fan.csv", np.c_[time, noise], delimiter=",", header=heads, comments="")
    page = tmp_path / "fan.html"
    machine = ["--speed", "25Hz", "--shaft", "fan=1/2", "--bearing", "left:6205@fan", "-o", str(page)]
    assert run_command(["diagnose", str(tmp_path / "fan.csv"), *machine]) == 0
    text = re.sub(r"<(script|style).*?</\1>", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    assert "nothing found" in text.lower()
    assert not re.findall(r"\b(?:mesh|meshes|gears?|tooth|teeth)\b", text)
