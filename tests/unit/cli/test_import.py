# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint import`: a model file from a REXS file, with a list of what was taken and what stands in."""

from __future__ import annotations

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.yaml_model import load_model
from tests.support.cli_files import json_of
from tests.support.rexs_files import GEARBOX


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "unit.rexs"
    path.write_text(GEARBOX, encoding="utf-8")
    return path


def test_a_model_file_is_written_and_runs(file, tmp_path, capsys):
    target = tmp_path / "unit.yaml"
    assert run_command(["import", str(file), "-o", str(target)]) == 0
    out = capsys.readouterr().out
    for text in (
        "missing, with the default",
        "meshes.cylindrical_stage_13.damping",
        "ratio 0.05",
        "written to",
        "-s steady",
    ):
        assert text in out
    text = target.read_text()
    assert text.startswith(
        "# model written by pitchpoint\n# imported from unit.rexs (REXS 1.4, a program 1)\n"
    )
    assert "#   meshes.cylindrical_stage_13.damping: ratio 0.05 (REXS has no damping)" in text
    assert list(load_model(target).scenarios) == ["slow", "steady"]
    found = json_of(["modes", str(target)], capsys)
    assert max(mode["frequency"] for mode in found["modes"]) > 100.0
    assert run_command(["import", str(file), "-o", str(target), "-q"]) == 0  # its own file may be replaced
    assert run_command(["import", str(file), "-o", str(file)]) == 2
    assert "is read by the same command" in capsys.readouterr().err


def test_json_has_every_entry(file, capsys):
    found = json_of(["import", str(file)], capsys)
    assert (found["version"], found["load_case"], found["output"]) == ("1.4", 1, None)
    assert found["items"][0].keys() == {"kind", "component", "attribute", "value", "target", "reason"}
    taken = [item for item in found["items"] if item["attribute"] == "face_width"]
    assert [item["value"] for item in taken] == ["20 mm", "18 mm"]


def test_load_cases_are_selected_by_number(file, capsys):
    found = json_of(["import", str(file), "--load-case", "2"], capsys)
    torque = [item for item in found["items"] if item["attribute"] == "torque_around_u_axis"]
    assert torque[0]["value"] == "-40 N m"
    assert run_command(["import", str(file), "--load-case", "7"]) == 2
    assert "--load-case: 7 does not exist (limit load cases: 1, 2)" in capsys.readouterr().err
