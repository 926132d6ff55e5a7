# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint contact`: table, JSON, files, and what it refuses."""

from __future__ import annotations

import math
from pathlib import Path

import click
import numpy as np
import pytest

from pitchpoint.cli.contact_input import torque_of_loads
from pitchpoint.cli.main import run_command
from pitchpoint.core.status import DIVERGED
from pitchpoint.io.reading import open_result, read_header
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from tests.support.cli_files import TORSION, json_of, written

MODEL = """
title: FZG type C
gears:
  g1: {number_of_teeth: 16, normal_module: 4.5 mm, face_width: 14 mm, profile_shift_coefficient: 0.1817}
  g2: {number_of_teeth: 24, normal_module: 4.5 mm, face_width: 14 mm, profile_shift_coefficient: 0.1715}
bodies:
  a: {gears: [g1], motion: torsion}
  b: {gears: [g2], motion: torsion}
meshes:
  stage:
    gears: [g1, g2]
    center_distance: 91.5 mm
    contact: {level: rigid, stiffness: 233.8 N/um, planes: 7}
loads:
  input: {body: a, torque: -100 N m}
  more: {body: a, torque: -202 N m}
"""


@pytest.fixture
def file(tmp_path: Path) -> str:
    return written(tmp_path, MODEL)


def test_people_get_a_row_per_torque(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    options = ["-t", "0.1 kN m", "-t", "200 N m:400:3", "--positions", "8", "--misalignment", "5 um"]
    assert run_command(["contact", file, *options]) == 0
    text = capsys.readouterr().out
    rows = [line.split()[0] for line in text.splitlines() if " N m " in line]
    assert rows == ["100", "200", "300", "400"]
    for words in (
        "level rigid, 7 contact planes, stiffness 233.8 N/µm, exponent 1",
        "8 mesh phases, front flanks, misalignment 0.02046 deg",
        "K_Hβ",
        "TE p–p",
        "σ_F1",
        "root stress at 30 deg tangent",
    ):
        assert words in text


def test_quiet_runs_print_the_table_only(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["contact", file, "--positions", "8", "-q"]) == 0
    text = capsys.readouterr().out
    assert "302 N m" in text
    assert "level" not in text


def test_a_quiet_analysis_into_a_file_prints_nothing(
    file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """As of modes, frf and campbell: the file contains everything."""
    target = tmp_path / "contact.h5"
    assert run_command(["contact", file, "--positions", "8", "-q", "-o", str(target)]) == 0
    assert capsys.readouterr().out == ""
    assert target.exists()


def test_default_torque_is_that_of_the_loads_on_gear_1(
    file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its sign gives the flanks."""
    found = json_of(["contact", file, "--positions", "8"], capsys)
    assert found["torque"] == [302.0]
    assert found["options"]["flank"] == -1
    front = json_of(["contact", file, "--positions", "8", "--flank", "front"], capsys)
    assert front["options"]["flank"] == 1
    # equal flanks
    assert front["curves"]["transmission_error"] == pytest.approx(
        np.array(found["curves"]["transmission_error"]), rel=1e-9
    )
    # a load on the other gear acts through the ratio
    balanced = MODEL.replace("-100 N m", "balance").replace(
        "body: a, torque: -202 N m", "body: b, torque: -453 N m"
    )
    model = load_model(written(tmp_path, balanced, "c.yaml"))
    assert torque_of_loads(model, "stage") == pytest.approx(-302.0, rel=1e-12)
    formula = MODEL.replace("-202 N m", "10*t").replace("-100 N m", "balance")
    model = load_model(written(tmp_path, formula.replace("  more: {body: a, torque: 10*t}\n", ""), "b.yaml"))
    with pytest.raises(click.UsageError, match="no constant torque"):
        torque_of_loads(model, "stage")


def test_json_holds_numbers_and_curves(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    found = json_of(["contact", file, "-t", "302", "--positions", "16"], capsys)
    assert found["status"] == "finished"
    assert found["mesh"] == "stage"
    assert len(found["mesh_phase"]) == len(found["curves"]["mesh_stiffness"][0]) == 16
    assert len(found["plane"]) == len(found["load_over_width"][0]) == 7
    numbers = found["numbers"]
    error = np.array(found["curves"]["transmission_error"][0])
    assert numbers["transmission_error_pp"] == pytest.approx([np.ptp(error)])
    assert numbers["face_load_factor"] == pytest.approx([1.0])
    assert numbers["edge_pressure"] == [None]  # sharp tip edges
    assert numbers["root_stress_1"][0] > numbers["root_stress_2"][0] > 1e8
    assert len(numbers["transmission_error_orders"][0]) == 5


def test_a_result_file_holds_the_dataset(
    file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target, page = tmp_path / "c.h5", tmp_path / "c.html"
    options = ["-t", "302", "--positions", "8", "-o", str(target), "--picture", str(page)]
    found = json_of(["contact", file, *options], capsys)
    assert (found["output"], found["picture"]) == (str(target), str(page))
    with open_result(target) as data:
        assert dict(data.sizes) == {
            "torque": 1,
            "mesh_phase_position": 8,
            "tooth_pair": 2,
            "plane": 7,
            "gear": 2,
            "mark": 5,
        }
        assert data["transmission_error"].values.tolist() == found["curves"]["transmission_error"]
        assert data["line_load"].attrs["symbol"] == "w"
        assert data["mark"].values.tolist() == list("ABCDE")
    header = read_header(target)
    assert (header["kind"], header["status"]) == ("contact", "finished")
    assert header["options"] == found["options"]
    text = page.read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>")
    assert "FZG type C: tooth contact" in text


def test_a_page_by_its_extension(file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = tmp_path / "c.html"
    assert run_command(["contact", file, "--positions", "8", "--out", str(page)]) == 0
    assert "".join(capsys.readouterr().out.splitlines()).endswith(f"written to {page}")
    assert page.read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


def test_operating_conditions(file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target, page = tmp_path / "c.h5", tmp_path / "c.html"
    oil = ["--speed", "2000 rpm", "--friction", "0.05", "--viscosity", "20 mPa s"]
    files = ["-o", str(target), "--picture", str(page)]
    assert run_command(["contact", file, "--positions", "8", *oil, *files]) == 0
    text = capsys.readouterr().out
    for words in ("loss [%]", "flash", "film", "speed of gear 1 2000 rpm, friction 0.05, viscosity 20 mPa s"):
        assert words in text
    with open_result(target) as data:
        assert float(data["flash_temperature"].max()) > 0.0
        assert data["film_thickness"].attrs["units"] == "m"
    assert "Thickness of the oil film along the path of contact" in page.read_text(encoding="utf-8")
    assert read_header(target)["options"]["friction"] == 0.05


def test_friction_of_the_mesh(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = MODEL.replace("    center_distance", "    friction: {mu: 0.04}\n    center_distance")
    found = json_of(["contact", written(tmp_path, text), "--positions", "8"], capsys)
    numbers = found["numbers"]
    assert numbers["loss_share"][0] == pytest.approx(0.04 * numbers["loss_factor"][0])
    other = json_of(["contact", written(tmp_path, text), "--positions", "8", "--friction", "0.06"], capsys)
    assert other["options"]["friction"] == 0.06


def test_shafts_in_equilibrium(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Bearings on one side of the gear tilt it: the load moves to one end of the face."""
    text = MODEL.replace("motion: torsion", "motion: free").replace("-202 N m", "202 N m")
    text = text.replace("-100 N m}", "100 N m}\n  out: {body: b, torque: balance}")
    text += "bearings:\n"
    for body in "ab":
        for n, z in ((1, 20), (2, 70)):
            stiffness = "{radial: 2e8 N/m, axial: 1e8 N/m}"
            text += f"  {body}{n}: {{body: {body}, position: [0, 0, {z} mm], stiffness: {stiffness}}}\n"
    file = written(tmp_path, text)
    found = json_of(["contact", file, "--shafts", "--positions", "8"], capsys)
    assert found["torque"][0] == pytest.approx(302.0, rel=0.02)
    assert len(found["misalignment"]) == len(found["center_distance"]) == 8
    loads = np.array(found["load_over_width"][0])
    tilt = np.mean(found["misalignment"])
    assert np.all(np.diff(loads) * tilt < 0.0)
    assert found["numbers"]["face_load_factor"][0] > 1.05
    assert run_command(["contact", file, "--shafts", "--positions", "8"]) == 0
    assert "shafts in equilibrium, misalignment " in capsys.readouterr().out


def test_torques_before_a_failure_are_kept(
    file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    solve, calls = FlankStates.solve, []

    def failing(self: FlankStates, states: np.ndarray, keep_nodes: bool = False) -> np.ndarray | None:
        nodes = solve(self, states, keep_nodes)
        calls.append(states)
        if len(calls) == 2:
            states["status"][3] = DIVERGED
        return nodes

    monkeypatch.setattr(FlankStates, "solve", failing)
    target, page = tmp_path / "c.h5", tmp_path / "c.html"
    options = ["-t", "100", "-t", "200", "-t", "300", "--positions", "8", "-o", str(target)]
    options += ["--picture", str(page)]
    assert run_command(["contact", file, *options]) == 3
    captured = capsys.readouterr()
    assert "no contact state at 200 N m, mesh phase 0.3750" in captured.err
    assert f"partial results are in {target}" in captured.err
    assert "100 N m" in captured.out
    assert read_header(target)["status"] == "failed"
    assert 'role="note">failed: mesh stage: no contact state' in page.read_text(encoding="utf-8")
    with open_result(target) as data:
        assert data["torque"].values.tolist() == [100.0, 200.0]


def test_a_stop_before_the_first_torque(
    file: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def stop(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(FlankStates, "solve", stop)
    assert run_command(["contact", file, "--json"]) == 130
    assert '"torque": []' in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["-t", "3 kg"], "'kg' is not the unit of a torque"),
        (["-t", "-3"], "--torque"),
        (["-t", "3:4"], "is not a range FIRST:LAST:COUNT"),
        (["-t", "3:4:1"], "is not a range FIRST:LAST:COUNT"),
        (["-t", "3:4:9999"], "9999 torques (limit 500)"),
        (["--misalignment", "3"], "3 has no unit; write '3 um' or '3 deg'"),
        (["--misalignment", "3 kg"], "is neither a length nor an angle"),
        (["--misalignment", "1 rad"], "1 rad is too large (limit 5.73 deg, 1.4 mm over"),
        (["--misalignment", "-3 mm"], "-3 mm is too large"),
        (["--mesh", "stag"], "no mesh 'stag'; did you mean stage?"),
        (["--positions", "3"], "--positions"),
        (["--shafts", "-t", "3"], "--torque has no effect with --shafts"),
        (["--shafts", "--scenario", "x"], "no scenario 'x'"),
        (["--scenario", "x"], "--scenario requires --shafts"),
        (["--viscosity", "20 mPa s"], "--viscosity requires --speed"),
        (["--pressure-viscosity", "20 1/GPa", "--speed", "5 rpm"], "requires --viscosity"),
        (["--speed", "5 m"], "is not the unit of a rotational speed"),
        (["-o", "model.yaml"], "output"),
        (["-o", "a.h5", "--picture", "./a.h5"], "a.h5 is also the file of --"),
        (["-o", "a.html", "--picture", "b.html"], "a.html is a page, too; name a result file such as"),
    ],
)
def test_what_it_refuses(
    options: list[str],
    words: str,
    file: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run_command(["contact", file, *options]) == 2
    assert words in capsys.readouterr().err


def test_a_mesh_with_a_stiffness_law(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, TORSION)
    assert run_command(["contact", file]) == 2
    assert "no mesh has a contact of tooth surfaces; give the mesh one" in capsys.readouterr().err
    assert run_command(["contact", file, "--mesh", "stage"]) == 2
    assert "stage has a stiffness law; give the mesh one" in capsys.readouterr().err


def test_a_model_without_torque(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = MODEL[: MODEL.index("loads:")]
    assert run_command(["contact", written(tmp_path, text)]) == 2
    words = "the torque on gear 1 of stage (g1): the loads have no constant torque; give --torque"
    assert words in capsys.readouterr().err


def test_misalignment_as_length_and_as_angle(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    found = [
        json_of(["contact", file, "--positions", "4", "--misalignment", text], capsys)["numbers"]
        for text in ("14 um", "0.001 rad", "-14 um")
    ]
    assert found[0]["face_load_factor"] == found[1]["face_load_factor"]
    assert found[0]["face_load_factor"] == pytest.approx(found[2]["face_load_factor"], rel=1e-9)


def test_misalignment_of_the_housing(file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A tilt θ of back flanks in the plane of action: θ sin α_wt in that of the axes, -θ cos α_wt across."""
    alpha = load_model(file).pairs["stage"].alpha_wt
    tilts = f"in_plane: {1e-3 * math.sin(alpha)} rad, out_of_plane: {-1e-3 * math.cos(alpha)} rad"
    text = MODEL.replace("    contact:", f"    misalignment: {{{tilts}}}\n    contact:")
    tilted = json_of(["contact", written(tmp_path, text, "tilted.yaml"), "--positions", "4"], capsys)
    given = json_of(["contact", file, "--positions", "4", "--misalignment", "0.001 rad"], capsys)
    assert tilted["options"]["misalignment"] == pytest.approx(1e-3, rel=1e-12)
    factor = given["numbers"]["face_load_factor"]
    assert tilted["numbers"]["face_load_factor"] == pytest.approx(factor, rel=1e-9)
