# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint export`: units by the command line, and what is refused."""

from __future__ import annotations

import zipfile

import pytest

from pitchpoint.cli.main import run_command
from tests.support.cli_files import json_of, written
from tests.support.fmu_models import PAIR, need_linker

ADAMS = PAIR.replace("METHOD", "adams")
CONTROLLED = ADAMS.replace(
    "scenarios:",
    """sensors:
  speed: {type: joint, coordinate: driver, derivative: 1}
controllers:
  loop: {type: python, function: "law.py:loop", inputs: [speed], outputs: [wanted], period: 1 ms, unit: N m}
actuators:
  motor: {type: torque, signal: wanted, bodies: [driver]}
scenarios:""",
)
LAW = ADAMS.replace("torque: 150 N m}\nscenarios", 'torque: {python: "law.py:brake"}}\nscenarios')
CODE = """
def loop(t, inputs, state, parameters):
    return [0.0]


def brake(t, x, p):
    return 150.0
"""


def test_a_unit_and_its_summary(tmp_path, capsys):
    need_linker()
    file, out = written(tmp_path, ADAMS), str(tmp_path / "new" / "a unit.fmu")
    found = json_of(["export", file, "--fmu", out], capsys)
    assert (found["fmi"], list(found["libraries"])) == ("3.0", ["x86_64-linux"])
    assert found["step"] == pytest.approx(1e-5)
    inputs = {v["name"]: v["start"] for v in found["variables"] if v["causality"] == "input"}
    assert inputs == {"loads.input.torque": 150.0, "loads.output.torque": 150.0}
    with zipfile.ZipFile(out) as archive:
        assert archive.namelist() == [
            "modelDescription.xml",
            "terminalsAndIcons/terminalsAndIcons.xml",
            "binaries/x86_64-linux/a_unit.so",
        ]
        first = archive.read("modelDescription.xml")
    # the same model gives the same file, and an older unit may be replaced
    again = json_of(["export", file, "--fmu", out], capsys)
    assert again["identifier"] == found["identifier"]
    with zipfile.ZipFile(out) as archive:
        assert archive.read("modelDescription.xml") == first


def test_the_printed_table(tmp_path, capsys):
    need_linker()
    file, out = written(tmp_path, ADAMS), str(tmp_path / "unit.fmu")
    parameter = "meshes.stage.backlash.normal"
    assert run_command(["export", file, "--fmu", out, "--fmi", "2", "--parameter", parameter]) == 0
    printed = capsys.readouterr().out
    assert "loads.input.torque" in printed and "150 N m" in printed and f"{parameter}   0.0001 m" in printed
    assert "FMI 2.0" in printed and "time step 10 µs" in printed


@pytest.mark.parametrize(
    "text, arguments, words",
    [
        (CONTROLLED, (), "controllers.loop: is a Python function"),
        (LAW, (), "loads.output (line 18): has a law in Python"),
        (
            ADAMS.replace("adams", "runge_kutta"),
            (),
            "runge_kutta cannot be exported (limit adams | rk4 | generalized_alpha); use adams",
        ),
        (ADAMS, ("--parameter", "gears.g1.nothing"), "gears.g1.nothing: is not a number of the model"),
        (ADAMS, ("--parameter", "gears.g1.number_of_teeth"), "gears.g1.number_of_teeth: "),
        (ADAMS, ("--platforms", "x86_64-beos"), "no library can be made for 'x86_64-beos'"),
        (ADAMS, ("--scenario", "sweep"), "no scenario 'sweep'"),
    ],
)
def test_what_cannot_be_exported_is_refused_by_name(text, arguments, words, tmp_path, capsys):
    need_linker()
    (tmp_path / "law.py").write_text(CODE, encoding="utf-8")
    out = tmp_path / "unit.fmu"
    code = run_command(["export", written(tmp_path, text), "--fmu", str(out), "--allow-code", *arguments])
    assert code == 2
    assert words in capsys.readouterr().err
    assert not out.exists()


def test_a_file_that_is_no_unit_is_not_overwritten(tmp_path, capsys):
    other = tmp_path / "unit.fmu"
    with zipfile.ZipFile(other, "w") as archive:
        archive.writestr("modelDescription.xml", "<fmiModelDescription/>")
    before = other.read_bytes()
    assert run_command(["export", written(tmp_path, ADAMS), "--fmu", str(other)]) == 2
    assert "is not an FMU of pitchpoint" in capsys.readouterr().err
    assert other.read_bytes() == before


def test_a_missing_linker_is_named(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("pitchpoint.io.fmu.linking.zig", lambda: "")
    monkeypatch.setenv("PATH", "")
    code = run_command(
        ["export", written(tmp_path, ADAMS), "--fmu", str(tmp_path / "u.fmu"), "--platforms", "x86_64-linux"]
    )
    assert code == 2
    assert "pip install 'pitchpoint[fmi]'" in capsys.readouterr().err
