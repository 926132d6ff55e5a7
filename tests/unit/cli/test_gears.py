# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint gears` and `mesh` on files: numbers of ISO/TR 6336-30 example 1, signs, units, tables.

Source of the numbers: ISO/TR 6336-30, example 1, as quoted by two open re-implementations; recomputed in
closed form where the report prints fewer digits. Backlash: 2 (r_b1 + r_b2)(inv alpha_wt - inv alpha_w0) with
the given x.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.progress import silent
from pitchpoint.geometry.solid_file import read_solids
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.collect import collect
from tests.support.bevel_teeth import PAIR as BEVEL_PAIR
from tests.support.cli_files import ISO_EX1, TORSION, json_of, written
from tests.support.machines import pair

PINION = {
    "z": 17, "m_n": 8e-3, "alpha_n": math.radians(20), "alpha_t": math.radians(20.719712),
    "beta": math.radians(15.8), "beta_b": math.radians(14.824535), "x": 0.145, "d": 0.141340113,
    "d_b": 0.132198569, "d_a": 0.15966, "p_et": 0.024430238, "z_n": 18.9051,
}  # fmt: skip
WHEEL = {"z": 103, "d": 0.856354803, "d_b": 0.800967802, "d_a": 0.87235, "z_n": 114.5428}
STAGE = {
    "a_w": 0.5, "alpha_wt": math.radians(21.0661), "x_sum": 0.145222, "x_sum_given": 0.145,
    "d_w1": 0.141666667,
    "d_w2": 0.858333333, "d_Nf1": 0.13292069, "d_Nf2": 0.84522524, "g_alpha": 0.03784464,
    "eps_alpha": 1.54909,
    "eps_beta": 1.083369, "T1T2": 0.179722372, "j_bt": 1.25722e-6, "C_R": 1.0, "C_B": 0.9,
    "c_prime": 12.370472e9, "c_gamma_alpha": 17.46485e9,
}  # fmt: skip


def test_iso_example_1(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data = json_of(["gears", written(tmp_path, ISO_EX1)], capsys)
    for found, expected in (
        (data["gears"]["pinion"], PINION),
        (data["gears"]["wheel"], WHEEL),
        (data["meshes"]["stage"], STAGE),
    ):
        for name, value in expected.items():
            assert found[name] == pytest.approx(value, rel=1e-5), name
    for name in ("m_t", "d_f", "d_Ff", "s_n", "p_t", "mass"):
        assert data["gears"]["pinion"][name] > 0.0
    assert (data["gears"]["pinion"]["hand"], data["gears"]["wheel"]["hand"]) == ("left", "right")
    stage = data["meshes"]["stage"]
    assert stage["a_d"] == pytest.approx(8e-3 * 120 / 2 / math.cos(math.radians(15.8)), rel=1e-12)
    assert stage["eps_gamma"] == pytest.approx(stage["eps_alpha"] + stage["eps_beta"], rel=1e-12)
    assert stage["j_bn"] == pytest.approx(stage["j_bt"] * math.cos(math.radians(14.824535)), rel=1e-6)
    assert stage["j_wt"] == pytest.approx(stage["j_bt"] / math.cos(math.radians(21.0661)), rel=1e-6)


def test_backlash_of_the_file_counts(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    stage = json_of(["gears", written(tmp_path, TORSION)], capsys)["meshes"]["stage"]
    assert stage["j_bt"] == pytest.approx(1e-4, rel=1e-12)
    assert stage["j_wt"] == pytest.approx(1e-4 / math.cos(math.radians(20)), rel=1e-12)


def test_the_stiffness_in_force_is_listed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """c' = 14 N/(mm µm) of the file, and the mean of its parabola eps_alpha (1 - (1 - S_R)/3) c' b.

    The number of ISO 6336 follows under its own name. Laws of the whole mesh have a mean only; the mean of a
    law F = K u^1.5 has another unit, so there is none.
    """
    laws = {
        "{law: din3990, single_stiffness: 14 N/(mm µm)}": (14e9, 14e9 * 0.1 * STAGE["eps_alpha"] * 2.8 / 3.0),
        "{law: din3990}": (STAGE["c_prime"], STAGE["c_prime"] * 0.1 * STAGE["eps_alpha"] * 2.8 / 3.0),
        "{law: constant, value: 400 N/µm}": (None, 4e8),
        "{law: hertz}": (None, None),
    }
    for law, (single, mean) in laws.items():
        text = ISO_EX1.replace("{law: din3990, stiffness_ratio: 0.8, tip_relief_factor: 0.0}", law)
        assert law in text
        stage = json_of(["gears", written(tmp_path, text)], capsys)["meshes"]["stage"]
        assert stage["stiffness_law"] in law
        assert stage["c_prime_law"] == (single if single is None else pytest.approx(single, rel=1e-5)), law
        assert stage["mean_mesh_stiffness"] == (mean if mean is None else pytest.approx(mean, rel=1e-5)), law
        assert stage["c_prime"] == pytest.approx(STAGE["c_prime"], rel=1e-5)
    assert run_command(["gears", written(tmp_path, text.replace(law, next(iter(laws))))]) == 0
    assert "14 N/(mm µm)" in capsys.readouterr().out


def test_internal_gears_are_positive_outside(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = """
gears:
  planet: {number_of_teeth: 20, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 70, normal_module: 2 mm, face_width: 20 mm,
         profile_shift_coefficient: 0}
meshes:
  outer: {gears: [planet, ring]}
"""
    data = json_of(["gears", written(tmp_path, text)], capsys)
    ring, outer = data["gears"]["ring"], data["meshes"]["outer"]
    assert ring["type"] == "internal"
    assert ring["z"] == 70
    assert ring["d"] == pytest.approx(0.14, rel=1e-12)
    assert ring["d_a"] < ring["d"] < ring["d_f"]
    assert [outer["a_w"], outer["a_d"]] == pytest.approx([0.05, 0.05], rel=1e-9)
    assert outer["d_w2"] == pytest.approx(0.14, rel=1e-9)
    assert outer["c_1"] > 0.0
    assert outer["c_2"] > 0.0


def test_people_read_millimetres_and_degrees(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["gears", written(tmp_path, ISO_EX1)]) == 0
    captured = capsys.readouterr()
    for text in (
        "141.3401 mm",
        "15.8 deg",
        "12.3705 N/(mm µm)",
        "1.257216 µm",
        "stage: pinion / wheel",
        "span",
    ):
        assert text in captured.out
    assert captured.err == ""


def test_a_form_circle_that_ends_the_involute_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Internal pair of the KHK tables, whose pinion is undercut: the tip circles promise 1.6795."""
    common = "normal_module: 3 mm, face_width: 20 mm"
    file = written(
        tmp_path,
        f"gears:\n  a: {{number_of_teeth: 16, profile_shift_coefficient: 0, {common}}}\n"
        f"  b: {{number_of_teeth: 24, profile_shift_coefficient: -0.5, type: internal, {common}}}\n"
        "meshes: {m: {gears: [a, b], center_distance: 13.1683 mm}}\n",
    )
    assert run_command(["gears", file]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "tip of b reaches below the root form circle of a (undercut)" in said
    assert "contact ratio left is 1.645" in said


def test_only_one_gear(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, ISO_EX1)
    assert run_command(["gears", file, "--gear", "pinion"]) == 0
    assert "874.3773" not in capsys.readouterr().out
    assert run_command(["gears", file, "--gear", "pinoin"]) == 2
    assert "did you mean pinion?" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("ending", "begin"), [("dxf", b"999\n"), ("svg", b"<svg"), ("csv", b"x [mm]"), ("stl", b"")]
)
def test_drawings(ending: str, begin: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, target = written(tmp_path, ISO_EX1), tmp_path / f"pinion.{ending}"
    assert run_command(["gears", file, "--export", str(target), "--gear", "pinion"]) == 0
    assert str(target) in capsys.readouterr().out
    assert target.read_bytes().startswith(begin)
    assert target.stat().st_size > 1000


def test_drawings_need_a_gear_and_a_known_ending(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, ISO_EX1)
    assert run_command(["gears", file, "--export", str(tmp_path / "x.dxf")]) == 2
    assert "there are pinion, wheel" in capsys.readouterr().err
    assert run_command(["gears", file, "--export", str(tmp_path / "x.igs"), "--gear", "wheel"]) == 2
    assert ".dxf" in capsys.readouterr().err


def test_mesh_of_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    stage = json_of(["mesh", written(tmp_path, ISO_EX1)], capsys)["meshes"]["stage"]
    assert stage["mean"] == pytest.approx(1.549090097 * (1.0 - 0.2 / 3.0), rel=1e-8)
    assert stage["unit_stiffness"] == pytest.approx(1.2370472e9, rel=1e-6)
    assert stage["relative_to"] == "c' b"
    wave = json_of(["mesh", written(tmp_path, TORSION), "--points", "3"], capsys)["meshes"]["stage"]
    assert wave["relative_to"] == "the mean"
    assert wave["stiffness_ratio"] == pytest.approx([0.65, 1.15, 0.65])
    assert wave["unit_stiffness"] == 4.0e8


def test_a_power_of_the_deflection_has_no_stiffness_in_newtons_per_metre(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """K of a pair by Hertz is in N/m^1.5: shown as a ratio, and no slope in N/m is drawn over it."""
    text = pair("{law: hertz}")
    stage = json_of(["mesh", written(tmp_path, text)], capsys)["meshes"]["stage"]
    assert stage["unit_stiffness"] is None
    assert stage["relative_to"] == "K of one pair"
    assert stage["mean"] == pytest.approx(loads_model(text).pairs["stage"].eps_alpha, rel=1e-12)
    assert run_command(["mesh", written(tmp_path, text)]) == 0
    assert "N/µm" not in capsys.readouterr().out
    shown, _ = collect(loads_model(text), [], silent)
    assert shown.mesh_cycles["stage"].stiffness_unit == "K of one pair"
    assert np.size(shown.mesh_cycles["stage"].errors["without load"]) > 0
    assert np.size(shown.mesh_cycles["stage"].loaded_ratio) == 0


@pytest.mark.parametrize("command", ["gears", "mesh", "check"])
def test_every_problem_of_a_file_at_once(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = ISO_EX1.replace("number_of_teeth: 17", "number_of_teht: 17").replace("500 mm", "500 kg")
    assert run_command([command, written(tmp_path, text), "--json"]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "Traceback" not in captured.err
    for words in ("line 3", "number_of_teeth", "line 8", "'kg'"):
        assert words in captured.err


def test_an_exported_tooth_is_read_back(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Export, name the file in the model, and the gear has the same mass but for the chords of the points."""
    file = written(tmp_path, TORSION)
    before = json_of(["gears", file], capsys)["gears"]["g1"]
    target = str(tmp_path / "g1.csv")
    assert run_command(["gears", file, "--export", target, "--gear", "g1"]) == 0
    capsys.readouterr()
    again = written(tmp_path, TORSION.replace("g1: {", "g1: {tooth_profile: {tooth: g1.csv}, ", 1))
    after = json_of(["gears", again], capsys)["gears"]["g1"]
    assert after.pop("mass") == pytest.approx(before.pop("mass"), rel=1e-4)
    assert {k: v for k, v in after.items() if "inertia" not in k} == {
        k: v for k, v in before.items() if "inertia" not in k
    }
    for ending in ("svg", "dxf", "stl", "csv"):
        second = tmp_path / f"again.{ending}"
        assert run_command(["gears", again, "--export", str(second), "--gear", "g1"]) == 0
        assert second.stat().st_size > 1000


def test_bevel_gears_are_told_and_written_as_solids(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The solid weighs what the table tells; chords of 20 points a flank lack less than 0.3 % of it."""
    file = written(tmp_path, BEVEL_PAIR)
    data = json_of(["gears", file], capsys)
    pinion, stage = data["bevel_gears"]["pinion"], data["bevel_meshes"]["stage"]
    assert (pinion["z"], pinion["hand"], pinion["beta_m"]) == (17, "left", pytest.approx(math.radians(30.0)))
    assert stage["j_mn"] == pytest.approx(200e-6)
    assert stage["eps_gamma"] == pytest.approx(stage["eps_alpha"] + stage["eps_beta"])
    assert run_command(["gears", file]) == 0
    told = capsys.readouterr().out
    assert "pitch cone angle  delta" in told
    assert "Bevel pairs" in told
    target = tmp_path / "pinion.stl"
    assert run_command(["gears", file, "--gear", "pinion", "--export", str(target)]) == 0
    solid = read_solids(target, 1e-3).part(None)
    assert 7850.0 * solid.volume == pytest.approx(pinion["mass"], rel=3e-3)
    for bad in (["--export", str(tmp_path / "x.step")], ["--preview", str(tmp_path / "x.svg")]):
        assert run_command(["gears", file, "--gear", "pinion", *bad]) == 2
        assert "is a bevel gear" in capsys.readouterr().err
