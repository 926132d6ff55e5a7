# SPDX-License-Identifier: Apache-2.0
"""`--set` of commands that evaluate a model."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import click
import pytest

from pitchpoint.cli.main import pitchpoint as group
from pitchpoint.cli.main import run_command
from pitchpoint.core.provenance import content_hash
from pitchpoint.core.status import OK
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.sweep.cases import REFUSED
from tests.support.cli_files import json_of, written

PAIR = """
title: pair
parameters: {width: 20 mm}
gears:
  pinion: {number_of_teeth: 24, normal_module: 2 mm, face_width: width, profile_shift_coefficient: 0}
  wheel: {number_of_teeth: 49, normal_module: 2 mm, face_width: width, profile_shift_coefficient: 0}
bodies:
  input: {gears: [pinion]}
  output: {gears: [wheel]}
meshes: {stage: {gears: [pinion, wheel]}}
loads: {drive: {body: input, torque: 100 N m}, brake: {body: output, torque: balance}}
"""


def changed(command: list[str], setting: str, folder: Path, capsys: Any) -> tuple[Any, Any]:
    """JSON of a command without and with a setting."""
    name, *options = command
    file = written(folder, PAIR)
    return tuple(json_of([name, file, *options, *more], capsys) for more in ([], ["--set", setting]))  # type: ignore[return-value]


def test_gears_mass_and_mesh_use_a_parameter(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Twice the width has twice the mass and stiffness."""
    before, after = changed(["gears"], "parameters.width=40 mm", tmp_path, capsys)
    assert after["gears"]["pinion"]["b"] == pytest.approx(2 * before["gears"]["pinion"]["b"])
    before, after = changed(["check"], "parameters.width=40 mm", tmp_path, capsys)
    assert after["bodies"]["input"]["mass"] == pytest.approx(2 * before["bodies"]["input"]["mass"])


def test_frequencies_use_a_number_of_teeth(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    speed = ["frequencies", "--speed", "input=600 rpm"]
    before, after = changed(speed, "gears.pinion.number_of_teeth=25", tmp_path, capsys)
    assert (before["meshes"]["stage"]["frequency"], after["meshes"]["stage"]["frequency"]) == (
        pytest.approx(240.0),
        pytest.approx(250.0),
    )


def test_a_key_that_does_not_exist_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, PAIR)
    assert run_command(["gears", file, "--set", "gears.pinon.face_width=3 mm"]) == 2
    assert "gears.pinon" in capsys.readouterr().err
    assert run_command(["gears", file, "--set", "gears.pinion.face_width"]) == 2
    assert "is not of the form PATH=VALUE" in capsys.readouterr().err


def test_values_do_not_remain_for_the_next_command(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before, after = changed(["gears"], "parameters.width=40 mm", tmp_path, capsys)
    assert before != after
    assert json_of(["gears", written(tmp_path, PAIR)], capsys) == before


def test_commands_that_evaluate_a_model_have_it() -> None:
    """Not those that write to the model or to a table used by it."""
    context = click.Context(group)
    having = {
        name
        for name in group.list_commands(context)
        for option in group.get_command(context, name).params  # type: ignore[union-attr]
        if "--set" in option.opts
    }
    assert {"check", "gears", "mesh", "modes", "campbell", "frf", "frequencies", "contact"} <= having
    assert {"mass", "clearance", "reduce", "run", "sweep", "compare-solvers"} <= having
    assert having.isdisjoint({"relief", "contact-table", "new", "schema"})


WRONG = """
parameters: {gap: 72.5 mm}
gears:
  pinion: {number_of_teeth: 24, normal_module: 2 N, face_width: 20 mm, profile_shift_coefficient: 0.2}
  wheel: {number_of_teeth: 49, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  input: {gears: [pinion], inertia: 2.0e-3 kg m^2}
  output: {gears: [wheel], inertia: 4.0e-3 kg m^2}
meshes: {stage: {gears: [pinion, wheel], center_distance: gap}}
loads: {drive: {body: input, torque: 100 N m}, brake: {body: output, torque: balance}}
scenarios: {roll: {speed: {input: 100 rpm}, quasi_static: {mesh: stage, points: 4}}}
"""
MODULE = "gears.pinion.normal_module=2 mm"


def test_a_wrong_value_of_the_file_is_replaced(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A value that cannot be read, and one that does not fit the others, also as a bare parameter."""
    file = written(tmp_path, WRONG)
    assert run_command(["check", file, "--set", MODULE]) == 2
    assert "meshes.stage.center_distance (line 9): -0.4000 mm is the tip" in capsys.readouterr().err
    assert run_command(["check", file, "--set", MODULE, "--set", "meshes.stage.center_distance=72.4 mm"]) == 2
    assert "meshes.stage.center_distance (--set): -0.5000 mm is the tip" in capsys.readouterr().err
    for gap in ("meshes.stage.center_distance=73.5 mm", "parameters.gap=73.5 mm", "parameters.gap=0.0735"):
        found = json_of(["check", file, "--set", MODULE, "--set", gap], capsys)
        assert found["meshes"]["stage"]["center_distance"] == pytest.approx(0.0735)


@pytest.mark.parametrize("text", [PAIR, WRONG])
@pytest.mark.parametrize(
    ("setting", "said"),
    [
        (
            "meshes.stage.center_distance=72.4 kg",
            "meshes.stage.center_distance (--set): '72.4 kg': 'kg' is not",
        ),
        ("meshes.stage.friktion.mu=0.1", "meshes.stage.friktion (--set): is an unknown key; did you mean"),
        ("gears.pinon.face_width=3 mm", "gears.pinon (--set): does not exist; "),
        ("gear.pinion.face_width=3 mm", "gear (--set): is an unknown key; did you mean gears?"),
        ("loads.drive.torque.value=3", "(--set): "),
    ],
)
def test_a_wrong_value_names_its_option(
    text: str, setting: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """For a file that is right and for one that is wrong elsewhere, whose problems keep their lines."""
    assert run_command(["check", written(tmp_path, text), "--set", setting]) == 2
    told = capsys.readouterr().err
    assert said in told
    if text is WRONG:
        assert "gears.pinion.normal_module (line 4): '2 N'" in told


def test_the_law_is_that_of_replace() -> None:
    """A repaired file is the same model as the right file with the same value."""
    values = {"gears.pinion.normal_module": "2 mm", "parameters.gap": 0.0735}
    right = loads_model(WRONG.replace("2 N", "2 mm").replace("72.5", "73.6"))
    repaired = loads_model(WRONG, changes=values)
    assert content_hash(repaired) == content_hash(right.replace_all(values))
    assert repaired.parameters["gap"].value == "0.0735 m" and repaired.changed


def test_varied_values_repair_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Invalid cases get a status; if all are invalid, all problems are listed."""
    file = written(tmp_path, WRONG)
    run = ["run", file, "-o", str(tmp_path / "o.h5"), "--set", MODULE, "--json", "--vary"]
    run_command([*run, "parameters.gap=72.5 mm,73.5 mm"])
    assert [c["status_code"] for c in json.loads(capsys.readouterr().out)["cases"]] == [REFUSED, OK]
    assert run_command([*run, "meshes.stage.center_distance=72.4 mm,72.5 mm"]) == 2
    told = capsys.readouterr().err
    assert "(--vary): -0.5000 mm" in told and "(--vary): -0.4000 mm" in told


def test_a_key_of_a_missing_component_is_set(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Other keys have their defaults; a key below a number says how to write the whole value."""
    file = written(tmp_path, PAIR)
    json_of(["check", file, "--set", "meshes.stage.friction.mu=0.06"], capsys)
    model = loads_model(PAIR)
    assert model.replace("meshes.stage.friction.mu", 0.06) == model.replace(
        "meshes.stage.friction", {"mu": 0.06}
    )
    assert run_command(["check", file, "--set", "gears.wheel.face_width.left=3 mm"]) == 2
    assert (
        "replace the whole value above it: gears.wheel.face_width='{left: 3 mm}'" in capsys.readouterr().err
    )


def test_a_remark_on_a_value_names_its_option(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Of a right and of a repaired file."""
    more = PAIR + "scenarios: {s: {speed: {input: 300 rpm}, duration: 0.1 s}}"
    for text in (more, more.replace("300 rpm", "300 kg")):
        found = json_of(["check", written(tmp_path, text), "--set", "scenarios.s.speed.input=300"], capsys)
        bare = [m for m in found["messages"] if "no unit" in m["text"]]
        assert [(m["where"], m["file"], m["line"]) for m in bare] == [
            ("scenarios.s.speed.input", "--set", None)
        ]
