# SPDX-License-Identifier: Apache-2.0
"""No command writes over its input or over a file that is not its own kind; it says so before it computes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core import kernel
from pitchpoint.io import write_lock
from pitchpoint.io.container import Header
from pitchpoint.io.reading import read_channel, read_header
from pitchpoint.io.writing import Channel, ResultWriter
from tests.support.cli_files import TORSION, written

TEXT = TORSION.replace("duration: 0.5 s", "duration: 1 ms") + "  roll: {quasi_static: {points: 2}}\n"
VARY = ["--vary", "meshes.stage.damper.ratio=0.05,0.1"]
COMMANDS = {
    "run": ["run", "FILE", "-s", "steady", "-o"],
    "roll": ["run", "FILE", "-s", "roll", "-o"],
    "cases": ["run", "FILE", "-s", "steady", *VARY, "-o"],
    "sweep": ["sweep", "FILE", "-o"],
    "swept cases": ["sweep", "FILE", *VARY, "-o"],
    "modes": ["modes", "FILE", "-o"],
    "report": ["report", "FILE", "-o"],
    "compare-solvers": ["compare-solvers", "FILE", "-s", "steady", "-o"],
    "gears": ["gears", "FILE", "--gear", "g1", "--export"],
}


@pytest.fixture
def nothing_compiles(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fail at once where a command begins to compute."""

    def fail(*_: object, **__: object) -> None:
        raise AssertionError("computed before the output was looked at")

    monkeypatch.setattr("pitchpoint.system.compile.compile_model", fail)
    monkeypatch.setattr("pitchpoint.report.collect.collect", fail)
    monkeypatch.setattr("pitchpoint.io.gear_export.gear_outline", fail)
    monkeypatch.setattr(kernel, "expect", fail)


def refused(command: list[str], words: str, capsys: pytest.CaptureFixture[str]) -> None:
    """The command ends with 2, a sentence and nothing on stdout."""
    assert run_command(command) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "Traceback" not in captured.err
    for part in ("error: output: ", words, "(limit ", "; name another file"):
        assert part in captured.err


@pytest.mark.usefixtures("nothing_compiles")
@pytest.mark.parametrize("name", COMMANDS)
def test_inputs_and_foreign_files_stay(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ending = ".svg" if name == "gears" else ".yaml"  # of an export, the ending names the format
    file = Path(written(tmp_path, TEXT, f"own{ending}"))
    other = Path(written(tmp_path, "mine: 1\n", f"other{ending}"))
    link = tmp_path / f"link{ending}"
    link.symlink_to(file)
    command = [str(file) if word == "FILE" else word for word in COMMANDS[name]]
    for target in (file, link):
        refused([*command, str(target)], "is read by the same command", capsys)
    refused([*command, str(other)], "exists and is not", capsys)
    assert file.read_text(encoding="utf-8") == TEXT
    assert other.read_text(encoding="utf-8") == "mine: 1\n"


def test_a_result_may_be_replaced_by_a_result_but_not_by_its_report(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, target = written(tmp_path, TEXT), tmp_path / "st.h5"
    for scenario in ("steady", "roll"):
        assert run_command(["run", file, "-s", scenario, "-o", str(target), "-q"]) == 0
        assert read_header(target)["scenario"] == scenario
    capsys.readouterr()
    before = target.read_bytes()
    refused(["report", str(target), "-o", str(target)], "is read by the same command", capsys)
    refused(["report", file, "-o", str(target)], "is not an HTML page", capsys)
    assert target.read_bytes() == before


@pytest.mark.skipif(write_lock.fcntl is None, reason="Windows has no advisory locks")
@pytest.mark.usefixtures("nothing_compiles")
@pytest.mark.parametrize("name", ["run", "roll", "cases", "sweep", "swept cases", "modes"])
def test_a_result_that_is_being_written_stays(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, target = written(tmp_path, TEXT), tmp_path / "r.h5"
    command = [file if word == "FILE" else word for word in COMMANDS[name]]
    with ResultWriter(target, Header("time"), [Channel("x", "m")]) as writer:  # locks know no processes
        writer.append(np.zeros(3), np.zeros((3, 1)))
        assert run_command([*command, str(target)]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "r.h5: cannot be written (another process holds it); wait until it is closed" in captured.err
    assert len(read_channel(target, "x")[0]) == 3


def test_the_name_chosen_without_an_option_is_looked_at_too(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    file = written(tmp_path, TEXT)
    Path("model-steady.h5").write_text("notes of mine", encoding="utf-8")
    refused(["run", file, "-s", "steady"], "model-steady.h5 exists and is not", capsys)
    page = written(tmp_path, TEXT, "model.html")  # a model file may be called as its page would be
    refused(["report", page], "is read by the same command", capsys)


def test_measured_teeth_are_inputs_of_an_export(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, points = written(tmp_path, TEXT), tmp_path / "tooth.csv"
    assert run_command(["gears", file, "--gear", "g1", "--export", str(points)]) == 0
    measured = TEXT.replace("g1: {", "g1: {tooth_profile: {tooth: tooth.csv}, ", 1)
    capsys.readouterr()
    command = ["gears", written(tmp_path, measured, "measured.yaml"), "--gear", "g1", "--export", str(points)]
    refused(command, "is read by the same command", capsys)


@pytest.mark.parametrize("name", COMMANDS)
def test_what_cannot_be_written_has_path_and_reason(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = written(tmp_path, TEXT.replace("points: 81", "points: 2"))
    target = str(Path(file) / "x.svg")  # a file is no folder
    command = [file if word == "FILE" else word for word in COMMANDS[name]]
    assert run_command([*command, target]) == 2
    err = capsys.readouterr().err
    assert f"{target}: cannot be written (" in err
    assert "Traceback" not in err
