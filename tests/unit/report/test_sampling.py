# SPDX-License-Identifier: Apache-2.0
"""Samples that show meshes as false lines are reported by `check`, `run`, `analyse` and reports."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.model import Model
from pitchpoint.report.sampling import coarse_scenarios

EXAMPLES = Path(__file__).parents[3] / "examples"
PAIR = """\
gears:
  g1: {number_of_teeth: 24, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 49, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  input: {gears: [g1], inertia: 2e-3 kg m^2}
  output: {gears: [g2], inertia: 4e-3 kg m^2}
meshes:
  stage: {gears: [g1, g2], stiffness: {law: constant, value: 3e8 N/m}, damper: {ratio: 0.1}}
loads:
  drive: {body: input, torque: 100 N m}
  brake: {body: output, torque: balance}
scenarios:
  steady: {speed: {input: 3000 rpm}, duration: 10 ms, sample_rate: RATE}
"""
RUN_UP = "drive: {input: {speed: {table: [[0 s, -300 rpm], [4 ms, -3000 rpm], [10 ms, -600 rpm]]}}}"
FALSE = "appear as false lines at lower frequencies (aliasing)"


def pair(rate: str, motion: str = "speed: {input: 3000 rpm}") -> Model:
    text = PAIR.replace("RATE", rate).replace("speed: {input: 3000 rpm}", motion)
    return loads_model(text)


@pytest.mark.parametrize("motion", ["speed: {input: 3000 rpm}", RUN_UP])
def test_mesh_frequency_at_the_highest_speed(motion):
    # 24 teeth at 50 Hz: 1200 Hz; three harmonics of it with 2.56 samples per period: 9216 Hz
    for rate, coarse in (("2.4 kHz", True), ("2.5 kHz", False), ("1 kHz", True)):
        found = coarse_scenarios(pair(rate, motion))
        assert bool(found) == coarse
        assert all(FALSE in one and "9220 Hz or more" in one and "1200 Hz" in one for one in found)
    assert found[0].where == "scenarios.steady.sample_rate" and found[0].line == 13
    assert found[0].kind == "remark"


def test_run_says_what_check_says():
    for motion in ("speed: {input: 3000 rpm}", RUN_UP):
        model = pair("1 kHz", motion)
        data = pp.solve_time(pp.compile_model(model, "steady"))
        assert data.attrs["notes"].count(FALSE) == 1 and "mesh frequency of stage reaches 1" in data.notes
    fine = pp.solve_time(pp.compile_model(pair("20 kHz"), "steady"))
    assert FALSE not in fine.attrs["notes"]


def test_machine_that_runs_up_under_its_loads():
    # from rest, 100 N m on 2e-3 + 4e-3 (24/49)^2 kg m^2: 338 rad/s after 10 ms, a mesh frequency of 1291 Hz
    text = PAIR.replace("RATE", "1 kHz").replace("torque: balance", "torque: 0 N m")
    model = loads_model(text.replace("speed: {input: 3000 rpm}", "start: assembled"))
    assert coarse_scenarios(model) == ()  # only the run gives its speed
    data = pp.solve_time(pp.compile_model(model, "steady"))
    assert data.attrs["notes"].count(FALSE) == 1 and "reaches 129" in data.notes


def test_meshes_of_planets_and_of_bevel_gears():
    # 21 teeth, sun at 25 Hz relative to the carrier at 25/(1 + 99/21) Hz: 433.1 Hz
    model = pp.load_model(EXAMPLES / "planetary-set/model.yaml")
    for rate, count in ((866.0, 1), (867.0, 0)):
        assert len(coarse_scenarios(model.replace("scenarios.steady.sample_rate", f"{rate} Hz"))) == count
    bevel = pp.load_model(EXAMPLES / "bevel-drive/spiral.yaml")  # 17 teeth at 25 Hz: 425 Hz
    for rate, count in ((849.0, 1), (851.0, 0)):
        assert len(coarse_scenarios(bevel.replace("scenarios.steady.sample_rate", f"{rate} Hz"))) == count


def test_commands(tmp_path, capsys):
    file, result = tmp_path / "pair.yaml", tmp_path / "coarse.h5"
    file.write_text(PAIR.replace("RATE", "1 kHz"))
    assert run_command(["check", str(file), "--json"]) == 0
    printed = capsys.readouterr()
    assert sum(FALSE in one["text"] for one in json.loads(printed.out)["messages"]) == 1
    assert run_command(["run", str(file), "-o", str(result)]) == 0
    assert capsys.readouterr().out.replace("\n", " ").count(FALSE) == 1
    channel = ["--channel", "mesh_force[stage]"]
    assert run_command(["analyse", str(result), "amplitude_spectrum", *channel, "--json"]) == 0
    notes = json.loads(capsys.readouterr().out)["notes"]
    assert sum(FALSE in note for note in notes) == 1
    page = tmp_path / "page.html"
    assert run_command(["report", str(file), str(result), "-o", str(page)]) == 0
    assert page.read_text().count(FALSE) == 1
    capsys.readouterr()
    thin = tmp_path / "thin.h5"
    every = ["--set", "scenarios.steady.sample_rate=100 kHz", "--decimate", "100"]
    assert run_command(["run", str(file), *every, "-o", str(thin), "--json"]) == 0
    assert any(FALSE in note for note in json.loads(capsys.readouterr().out)["notes"])
