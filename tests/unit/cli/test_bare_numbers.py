# SPDX-License-Identifier: Apache-2.0
"""Remarks on numbers without unit in `--set`, `--vary` and other options."""

from __future__ import annotations

from pathlib import Path

import click
import pytest

from pitchpoint.cli.main import run_command
from tests.support.cli_files import json_of, written

MODEL = """
parameters: {n: 3000 rpm}
gears:
  pinion: {number_of_teeth: 24, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  wheel: {number_of_teeth: 49, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies: {i: {gears: [pinion]}, o: {gears: [wheel]}}
meshes: {stage: {gears: [pinion, wheel], damper: {ratio: 0.05}}}
loads: {d: {body: i, torque: 4 N m}, b: {body: o, torque: balance}}
scenarios:
  s: {speed: {i: 300 rpm}, duration: 0.1 ms}
  t: {speed: {i: n}, duration: 0.1 ms}
"""
READ = "has no unit and is read as 300 rad/s = 2864.8 rpm; write 300 rpm, or 300 rad/s if that is meant"


@pytest.mark.parametrize("path", ["scenarios.s.speed.i", "parameters.n"])
def test_a_speed_of_set(path: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Once: in the list of `check`, and before the results of other commands."""
    file = written(tmp_path, MODEL)
    found = json_of(["check", file, "--set", f"{path}=300"], capsys)
    assert [m["where"] for m in found["messages"] if "no unit" in m["text"]] == [path]
    for command in (["check"], ["frequencies", "-s", "s"]):
        assert run_command([*command, file, "--set", f"{path}=300"]) == 0
        assert capsys.readouterr().err.count(f"warning: {path} (--set): 300 {READ}") == 1
        assert run_command([*command, file, "--set", f"{path}=300 rpm"]) == 0
        assert "no unit" not in capsys.readouterr().err


def test_speeds_of_vary(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, MODEL)
    for name, path in (("s", "scenarios.s.speed.i"), ("t", "parameters.n")):
        run_command(["run", file, "-s", name, "-o", str(tmp_path / "o.h5"), "--vary", f"{path}=300,100"])
        found = [line for line in capsys.readouterr().err.splitlines() if "no unit" in line]
        assert found == [
            f"warning: {path} (--vary): 300 {READ.replace(' rpm;', ' rpm, like 1 more of its values;')}"
        ]


def test_the_body_of_a_varied_speed_is_headed_by_its_key(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = written(tmp_path, MODEL)
    vary = ["--vary", "scenarios.s.speed.i=300 rpm", "--vary", "parameters.n=3000 rpm"]
    assert run_command(["run", file, "-s", "s", "-o", str(tmp_path / "o.h5"), *vary]) == 0
    head = next(line for line in capsys.readouterr().out.splitlines() if "maximum force" in line)
    assert head.split()[:2] == ["speed.i", "n"]


@pytest.mark.parametrize(
    ("command", "option", "value", "doubtful"),
    [
        ("campbell", "--speeds", "750..300", False),  # refused
        ("campbell", "--speeds", "0..300", True),
        ("campbell", "--speeds", "0..300 rpm", False),
        ("campbell", "--operating", "300", True),
        ("campbell", "--frequency", "0..2000", False),  # bare frequencies are meant in Hz
        ("frf", "--to-speed", "300", True),
        ("contact", "--speed", "300", True),
        ("contact-table", "--torque", "300", False),
        ("frequencies", "--speed", "i=300", True),
        ("diagnose", "--speed", "300", True),
        ("diagnose", "--speed", "300 Hz", False),
    ],
)
def test_speeds_of_options(
    command: str,
    option: str,
    value: str,
    doubtful: bool,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def stop(*_: object, **__: object) -> None:
        raise click.Abort

    file = written(tmp_path, MODEL)
    monkeypatch.setattr("pitchpoint.cli.reading.read_model", stop)
    monkeypatch.setattr("pitchpoint.report.diagnosis.request.diagnose_file", stop)
    run_command([command, file, option, value])
    found = [line for line in capsys.readouterr().err.splitlines() if "no unit" in line]
    name = f"{option} i" if value.startswith("i=") else option
    assert found == ([f"warning: {name}: 300 {READ}"] if doubtful else [])
