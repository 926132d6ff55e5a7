# SPDX-License-Identifier: Apache-2.0
"""`--set` of commands that evaluate a model."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
import pytest

from pitchpoint.cli.main import pitchpoint as group
from pitchpoint.cli.main import run_command
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
