# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint rexs`: differences between two gear units, and a model as a REXS file."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.rexs.importing import import_rexs
from pitchpoint.io.rexs.reading import read_rexs
from tests.support.cli_files import json_of
from tests.support.rexs_files import GEARBOX, as_json

CHANGED = (
    GEARBOX.replace('id="face_width" unit="mm">20', 'id="face_width" unit="mm">22')
    .replace('id="torque_around_u_axis" unit="N m">40', 'id="torque_around_u_axis" unit="N m">45')
    .replace('<relation id="7" type="assembly"><ref id="3"', '<relation id="7" type="assembly"><ref id="4"')
)


@pytest.fixture
def files(tmp_path):
    paths = [tmp_path / name for name in ("a.rexs", "b.rexsj", "c.rexs")]
    for path, text in zip(paths, (GEARBOX, as_json(GEARBOX), CHANGED), strict=True):
        path.write_text(text, encoding="utf-8")
    return [str(path) for path in paths]


def test_equal_gear_units(files, capsys):
    assert run_command(["rexs", "diff", files[0], files[1]]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "A: a.rexs: REXS 1.4 by a program 1, 20 components"
    assert lines[-1] == "no differences"
    found = json_of(["rexs", "diff", files[0], files[1]], capsys)
    assert (found["equal"], found["differences"]) == (True, [])


def test_differences_are_listed_by_kind(files, capsys):
    assert run_command(["rexs", "diff", files[1], files[2], "-q"]) == 0
    out = capsys.readouterr().out
    for text in ("moved", "changed", "load case 1", "pinion of cylindrical_stage 13", "face width", "+5 N m"):
        assert text in out
    assert out.rstrip().endswith("3 differences: 1 moved, 2 changed")
    found = json_of(["rexs", "diff", files[1], files[2]], capsys)
    moved, width, torque = found["differences"]
    assert moved["kind"] == "moved"
    assert (width["attribute"], width["si_a"], width["si_b"]) == ("face_width", 0.02, 0.022)
    assert (torque["load_case"], torque["si_b"]) == ("1", 45.0)


def test_a_file_that_is_not_rexs_is_refused(files, tmp_path, capsys):
    other = tmp_path / "x.rexs"
    other.write_text("gears:\n", encoding="utf-8")
    assert run_command(["rexs", "diff", files[0], str(other)]) == 2
    assert "is not a REXS file" in capsys.readouterr().err


@pytest.fixture
def model(files, tmp_path):
    target = tmp_path / "unit.yaml"
    assert run_command(["import", files[0], "-o", str(target), "-q"]) == 0
    return str(target)


def test_a_model_is_written_with_its_mesh_stiffness(model, tmp_path, capsys):
    target = tmp_path / "new.rexsz"
    capsys.readouterr()
    assert run_command(["rexs", "write", model, "-o", str(target)]) == 0
    out = capsys.readouterr().out
    assert "REXS has no damping" in out
    assert out.rstrip().endswith(f"written to {target}: REXS 2.0.0, 24 components, 2 load cases")
    (stage,) = read_rexs(target).of_type("cylindrical_stage")
    curve = stage.get("meshing_stiffness_characteristic")
    found = json_of(["mesh", model], capsys)["meshes"]["cylindrical_stage_13"]
    unit = found["unit_stiffness"]
    assert (len(curve), curve[0]) == (65, pytest.approx(curve[-1]))
    assert min(curve) >= found["minimum"] * unit * (1 - 1e-9)
    assert sum(curve[:-1]) / 64 == pytest.approx(found["mean"] * unit, rel=1e-3)
    numbers = json_of(["gears", model], capsys)["meshes"]["cylindrical_stage_13"]
    c_gamma = stage.get("mean_mesh_stiffness_for_transverse_load_iso_6336_2006")
    assert c_gamma == pytest.approx(numbers["c_gamma_alpha"])
    assert run_command(["rexs", "diff", str(target), model]) == 0
    assert capsys.readouterr().out.rstrip().endswith("no differences")
    assert run_command(["rexs", "write", model, "-o", str(target), "-q"]) == 0  # its own file may be replaced


def test_results_of_a_run_are_values_of_a_load_case(model, tmp_path, capsys):
    """In equilibrium the forces of all bearings of a shaft and of its mesh add up to zero."""
    result, target = tmp_path / "slow.h5", tmp_path / "new.rexsj"
    assert run_command(["run", model, "-s", "slow", "-o", str(result), "-q"]) == 0
    assert run_command(["rexs", "write", model, "-o", str(target), "--result", str(result), "-q"]) == 0
    found = read_rexs(target)
    steady, backwards, slow = found.load_spectra[0].cases
    assert len(backwards.components) == 3
    (shaft,) = [c.id for c in found.of_type("shaft") if c.name == "shaft_3"]
    assert steady.components[shaft]["rotational_speed"].value == pytest.approx(157.0796, rel=1e-6)
    assert shaft not in slow.components
    (stage,) = found.of_type("cylindrical_stage")
    tangential = slow.components[stage.id]["nominal_tangential_force_at_base_diameter"].value
    base = import_rexs(target).model.gears["cylindrical_gear_7"].geometry.d_b / 2
    assert tangential * base == pytest.approx(40.0, rel=0.02)
    axial = radial = 0.0
    for bearing in (
        i for i, values in slow.components.items() if "force_acting_on_inner_component_u" in values
    ):
        (side,) = found.related("side", assembly=bearing)
        if side.roles["inner_part"] == shaft:
            values = slow.components[bearing]
            axial += values["force_acting_on_inner_component_u"].value
            radial += values["force_acting_on_inner_component_v"].value
    geometry = import_rexs(target).model.gears["cylindrical_gear_7"].geometry
    assert abs(axial) == pytest.approx(tangential * abs(math.tan(geometry.beta_b)), rel=0.02)
    assert abs(radial) <= tangential * 1.02
    capsys.readouterr()
    twice = ["--result", str(result)] * 2
    assert run_command(["rexs", "write", model, "-o", str(target), *twice]) == 2
    assert "has two results" in capsys.readouterr().err


def test_the_result_of_another_version_of_the_model_is_refused(model, tmp_path, capsys):
    result = tmp_path / "slow.h5"
    assert run_command(["run", model, "-s", "slow", "-o", str(result), "-q"]) == 0
    other = tmp_path / "other.yaml"
    text = Path(model).read_text(encoding="utf-8")
    other.write_text(text.replace("torque: 40 N m", "torque: 41 N m"), encoding="utf-8")
    capsys.readouterr()
    command = ["rexs", "write", str(other), "-o", str(tmp_path / "x.rexs"), "--result", str(result)]
    assert run_command(command) == 2
    assert "is the result of another version of the model" in capsys.readouterr().err


def test_wrong_endings_and_foreign_files_are_refused(model, tmp_path, capsys):
    assert run_command(["rexs", "write", model, "-o", str(tmp_path / "x.txt")]) == 2
    assert "has none of the endings .rexs" in capsys.readouterr().err
    other = tmp_path / "x.rexs"
    other.write_text(GEARBOX, encoding="utf-8")
    assert run_command(["rexs", "write", model, "-o", str(other)]) == 2
    assert "exists and is not a REXS file of pitchpoint" in capsys.readouterr().err
