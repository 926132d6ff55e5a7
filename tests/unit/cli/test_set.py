# SPDX-License-Identifier: Apache-2.0
"""`run --set`: another value of a key than that of the file."""

from __future__ import annotations

import json
from functools import partial

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.cli.vary import values_of
from pitchpoint.core.provenance import content_hash
from pitchpoint.io.reading import read_header
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.numbers import has_path
from pitchpoint.report.stored_model import stored_model

MODEL = """
title: pair
gears:
  pinion: {number_of_teeth: 20, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  wheel: {number_of_teeth: 40, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
bodies: {motor: {gears: [pinion]}, drum: {gears: [wheel]}}
meshes: {stage: {gears: [pinion, wheel], stiffness: {law: constant, value: 4e8 N/m}, damper: {ratio: 0.1}}}
loads: {motor: {body: motor, torque: balance}, drum: {body: drum, torque: 100 N m}}
scenarios: {steady: {speed: {motor: 600 rpm}, duration: 2 ms, step: 10 us}}
"""


@pytest.fixture
def run(tmp_path, capsys):
    def call(*options):
        file = tmp_path / "model.yaml"
        file.write_text(MODEL)
        code = run_command(["run", str(file), "-o", str(tmp_path / "out.h5"), *options])
        return code, *capsys.readouterr()

    return call


def mean_force(stdout):
    return json.loads(stdout)["channels"]["mesh_force[stage]"]["mean"]


def test_a_value_of_the_file_is_replaced(run):
    plain, doubled = (run("--json", *more)[1] for more in ((), ("--set", "loads.drum.torque=200 N m")))
    assert mean_force(doubled) == pytest.approx(2.0 * mean_force(plain), rel=1e-9)


def test_a_result_keeps_the_model_that_was_computed(run, tmp_path):
    """Whoever opens it alone, as `view` and `diagnose` do, sees the value that was set; else the file."""
    law = "meshes.stage.stiffness={law: din3990}"
    fault = "gears.pinion.faults.chip={type: broken_tooth, tooth: 3}"
    for more in ((), ("--set", law, "--set", fault)):
        assert run(*more)[0] == 0
        header = read_header(tmp_path / "out.h5")
        kept = stored_model(str(tmp_path / "out.h5"))
        assert content_hash(kept) == header["model_hash"]
        assert bool(kept.gears["pinion"].faults) == bool(more)
        assert (header["model_text"] == MODEL) == (not more)


def test_a_result_elsewhere_than_its_model_names_the_remedy(run, tmp_path, monkeypatch, capsys):
    """The files that a model names are in its directory."""
    assert run()[0] == 0
    text = MODEL + "winds: {gusty: {box: turbulence.bts}}\n"
    monkeypatch.setattr("pitchpoint.io.reading.read_header", lambda path: {"model_text": text})
    assert run_command(["view", str(tmp_path / "out.h5")]) == 2
    said = "'turbulence.bts' names a file that does not exist; keep the result in the directory of its model"
    assert said in capsys.readouterr().err


@pytest.mark.parametrize(
    "setting, said",
    [
        ("loads.drum.torque", "is not of the form PATH=VALUE"),
        ("loads.drum.tork=3 N m", "loads.drum.tork"),
        ("loads.drum.torque=3 kg", "loads.drum.torque"),
    ],
)
def test_wrong_settings_say_what_is_wrong(run, setting, said):
    code, _, told = run("--set", setting)
    assert code == 2 and said in told


def test_a_path_is_set_once(run):
    code, _, told = run("--set", "loads.drum.torque=1 N m", "--set", "loads.drum.torque=2 N m")
    assert code == 2 and "is set twice" in told


def test_names_with_an_equals_sign(run, monkeypatch):
    """A path ends where it leads to something; --set loads.a=b.torque=50 used to set `loads.a`."""
    named = MODEL.replace("drum: {body: drum", "a=b: {body: drum")
    monkeypatch.setitem(globals(), "MODEL", named)
    code, out, _ = run("--set", "loads.a=b.torque=50 N m", "--json", "-q")
    assert code == 0
    force = 50.0 / (40 * 3e-3 / 2.0 * np.cos(np.radians(20.0)))
    assert mean_force(out) == pytest.approx(force, rel=1e-3)
    assert values_of("loads.a=b.torque=1,2", partial(has_path, loads_model(named))) == (
        "loads.a=b.torque",
        [1, 2],
    )


PARAMETERS = """parameters: {load: {value: 100 N m, text: torque of the drum}, start: 600 rpm}
"""


@pytest.fixture
def with_parameters(tmp_path):
    file = tmp_path / "parameters.yaml"
    text = MODEL.replace("torque: 100 N m", "torque: load").replace("motor: 600 rpm", "motor: start")
    file.write_text(PARAMETERS + text)
    return file


def test_a_parameter_is_set_and_kept_in_the_result(with_parameters, tmp_path, capsys):
    out = str(tmp_path / "out.h5")
    forces = []
    for more in ((), ("--set", "parameters.load=200 N m")):
        assert run_command(["run", str(with_parameters), "-o", out, "--json", *more]) == 0
        forces.append(mean_force(capsys.readouterr().out))
    assert forces[1] == pytest.approx(2.0 * forces[0], rel=1e-9)
    kept = stored_model(out)
    assert kept.parameters["load"].value == "200 N m"
    assert kept.parameters["load"].text == "torque of the drum"
    assert kept.replace("parameters.load", 50.0).loads["drum"].torque.value == 50.0
    assert run_command(["run", str(with_parameters), "-o", out, "--set", "parameters.lod=200 N m"]) == 2
    assert "did you mean load?" in capsys.readouterr().err


def test_parameters_are_varied_tabled_and_reported(with_parameters, tmp_path, capsys):
    out = str(tmp_path / "cases.h5")
    vary = ["--vary", "parameters.load=50 N m,100 N m", "--vary", "parameters.start=300 rpm,600 rpm"]
    assert run_command(["run", str(with_parameters), "-o", out, "--json", *vary]) == 0
    found = json.loads(capsys.readouterr().out)["cases"]
    assert [case["numbers"]["parameters.load"] for case in found] == [50.0, 50.0, 100.0, 100.0]
    assert found[1]["numbers"]["parameters.start"] == pytest.approx(20.0 * np.pi)
    forces = [case["channels"]["mesh_force[stage]"]["mean"] for case in found]
    assert forces[2] == pytest.approx(2.0 * forces[0], rel=1e-9)
    page = tmp_path / "report.html"
    assert run_command(["report", str(with_parameters), out, "-o", str(page)]) == 0
    text = page.read_text(encoding="utf-8")
    assert "<td>torque of the drum</td>" in text and "<td>600 rpm</td>" in text
    assert ">load</th>" in text
