# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint check`: what will be simulated, with which defaults."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from tests.support.cli_files import ISO_EX1, TORSION, json_of, written


def test_says_what_will_be_simulated(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = json_of(["check", written(tmp_path, TORSION)], capsys)
    assert found["ok"] is True
    assert found["degrees_of_freedom"] == 2
    assert found["bodies"]["driven"]["degrees_of_freedom"] == ["spin"]
    assert found["bodies"]["driven"]["origin"] == pytest.approx([0.15, 0.0, 0.0])
    assert found["bodies"]["driver"]["polar_inertia"] == 0.0115
    assert found["meshes"]["stage"]["stiffness"] == "fourier"
    assert found["scenarios"] == {"steady": "time", "sweep": "sweep"}
    defaults = {entry["key"]: entry["value"] for entry in found["defaults"]}
    assert defaults["scenarios.steady.settle_time"] == "20 % of duration"
    assert defaults["gears.*.material"] == "steel"
    assert "gears.*.profile_shift_coefficient" not in defaults


def test_people_get_tables(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, TORSION)
    assert run_command(["check", file]) == 0
    captured = capsys.readouterr()
    for text in ("no problems", "2 degrees of freedom", "150 mm", "0.0115 kg m^2", "Defaults in effect"):
        assert text in captured.out
    assert captured.err == ""
    assert run_command(["check", file, "--quiet"]) == 0
    assert capsys.readouterr().out == ""


def test_gears_alone_are_a_model(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = json_of(["check", written(tmp_path, ISO_EX1)], capsys)
    assert found["bodies"] == {}
    assert found["meshes"]["stage"]["center_distance"] == 0.5


@pytest.mark.parametrize("text", ["gears: [", "\tgears: 1", "a: 1\na: 2", "gears: {g: 3}", ""])
def test_broken_files_exit_2(text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code = run_command(["check", written(tmp_path, text)])
    captured = capsys.readouterr()
    assert code == 2 or (text == "" and code == 0)
    assert "Traceback" not in captured.err


def test_unreadable_files_exit_2(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "model.yaml"
    path.write_bytes(b"title: \xff\xfe\x00")
    assert run_command(["check", str(path)]) == 2
    assert "UTF-8" in capsys.readouterr().err
    assert run_command(["check", str(tmp_path)]) == 2
