# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint mass`, the same table in `check`, and exports of solids by `gears`."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.geometry.shaft_solid import shaft_mass_properties
from pitchpoint.geometry.solid_file import read_solids
from tests.support.cli_files import TORSION, json_of, written
from tests.support.occ import needs_occ

SHAFT = """
title: a shaft with a wheel
gears:
  wheel: {number_of_teeth: 23, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
shafts:
  axle:
    sections: [{length: 100 mm, diameter: 20 mm}, {length: 50 mm, diameter: 30 mm, bore: 10 mm}]
    gears: {wheel: 50 mm}
    position: [0, 0, 0]
"""
SECTIONS = [(0.1, 0.02, 0.0), (0.05, 0.03, 0.01)]


def test_mass_of_a_plain_model_is_that_of_its_geometry(tmp_path: Path, capsys) -> None:
    found = json_of(["mass", written(tmp_path, SHAFT)], capsys)["masses"]
    assert [(e["part"], e["name"]) for e in found] == [("gear", "wheel"), ("shaft", "axle")]
    axle = found[1]["sources"]["effective"]
    exact = shaft_mass_properties(SECTIONS, 7830.0)
    assert axle["mass"] == pytest.approx(exact.mass, rel=1e-12)
    assert axle["transverse_inertia"] == pytest.approx(exact.transverse_inertia, rel=1e-12)
    assert axle["center"] == pytest.approx([0.0, 0.0, exact.center])


def test_exported_solids_come_back_as_solids_of_the_model(tmp_path: Path, capsys) -> None:
    file = written(tmp_path, SHAFT)
    for what, name in (("--gear", "wheel"), ("--shaft", "axle")):
        assert run_command(["gears", file, what, name, "--export", str(tmp_path / f"{name}.stl")]) == 0
    text = SHAFT.replace(
        "coefficient: 0}", "coefficient: 0, solid: {file: wheel.stl, unit: 1 mm}, mass: 300 g}"
    )
    text = text.replace("    gears: {wh", "    solid: {file: axle.stl, unit: 1 mm}\n    gears: {wh")
    file = written(tmp_path, text)
    capsys.readouterr()
    found = json_of(["mass", file], capsys)["masses"]
    wheel, axle = found
    # polygons of 20 points a flank and of 180 corners
    assert abs(wheel["sources"]["solid"]["mass"] / wheel["sources"]["geometry"]["mass"] - 1.0) < 1e-3
    assert axle["differences"]["geometry"]["mass"] == pytest.approx(2.03e-4, rel=1e-2)
    assert json_of(["check", file], capsys)["masses"] == found
    assert run_command(["mass", file]) == 0
    out = capsys.readouterr().out
    for word in (
        "gear wheel",
        "geometry",
        "solid",
        "given",
        "effective",
        "300 g",
        "shaft axle",
        "+0.02031 %",
    ):
        assert word in out, word
    assert "wheel.stl in units of 1 mm, 7830 kg/m^3" in out
    assert run_command(["check", file]) == 0
    assert "Masses from several sources" in capsys.readouterr().out


def test_check_is_silent_where_there_is_only_one_way(tmp_path: Path, capsys) -> None:
    assert json_of(["check", written(tmp_path, SHAFT)], capsys)["masses"] == []
    assert run_command(["check", written(tmp_path, SHAFT)]) == 0
    assert "Masses known" not in capsys.readouterr().out


def test_given_inertia_of_a_body_stands_beside_that_of_its_gears(tmp_path: Path, capsys) -> None:
    found = json_of(["mass", written(tmp_path, TORSION)], capsys)["masses"]
    driver = next(e for e in found if e["name"] == "driver")
    assert list(driver["sources"]) == ["gears", "given", "effective"]
    assert driver["sources"]["given"]["polar_inertia"] == 0.0115


@pytest.mark.parametrize(
    "arguments, said",
    [
        (["--shaft", "axle"], "requires --export"),
        (["--shaft", "axel", "--export", "a.stl"], "did you mean axle?"),
        (["--shaft", "axle", "--export", "a.svg"], "has no solid extension; use .stl, .step, .stp"),
        (["--shaft", "axle", "--gear", "wheel", "--export", "a.stl"], "cannot be combined with --gear"),
    ],
)
def test_what_cannot_be_exported_is_said(tmp_path: Path, capsys, arguments, said) -> None:
    assert run_command(["gears", written(tmp_path, SHAFT), *arguments]) == 2
    assert said in " ".join(capsys.readouterr().err.split())


def test_a_solid_that_is_read_is_not_written_over(tmp_path: Path, capsys) -> None:
    file = written(tmp_path, SHAFT)
    target = str(tmp_path / "wheel.stl")
    assert run_command(["gears", file, "--gear", "wheel", "--export", target]) == 0
    file = written(
        tmp_path, SHAFT.replace("coefficient: 0}", "coefficient: 0, solid: {file: wheel.stl, unit: 1 mm}}")
    )
    assert run_command(["gears", file, "--gear", "wheel", "--export", target]) == 2
    assert "is read by the same command" in capsys.readouterr().err


def test_without_occ_step_is_refused_with_the_name_of_the_extra(tmp_path: Path, capsys, monkeypatch) -> None:
    import sys

    monkeypatch.setitem(sys.modules, "OCP.Message", None)
    target = tmp_path / "wheel.step"
    assert run_command(["gears", written(tmp_path, SHAFT), "--export", str(target)]) == 2
    assert "pip install 'pitchpoint[cad]'" in capsys.readouterr().err
    assert not target.exists()


@needs_occ
def test_step_files_come_from_the_command_line(tmp_path: Path, capsys) -> None:
    file = written(tmp_path, SHAFT)
    for what, name in (("--gear", "wheel"), ("--shaft", "axle")):
        assert run_command(["gears", file, what, name, "--export", str(tmp_path / f"{name}.stp")]) == 0
    assert read_solids(tmp_path / "wheel.stp").part("wheel").volume > 0.0
    axle = read_solids(tmp_path / "axle.stp").part("axle")
    assert axle.volume == pytest.approx(shaft_mass_properties(SECTIONS, 1.0).mass, rel=1e-12)
    assert capsys.readouterr().out.count("written to") == 2
