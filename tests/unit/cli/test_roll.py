# SPDX-License-Identifier: Apache-2.0
"""`run` of a slow roll: JSON, table and file."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.reading import open_result, read_header
from tests.support.cli_files import TORSION, json_of, written
from tests.support.machines import STAGES

ROLL = TORSION + "  roll: {quasi_static: {points: 40}}\n"


def test_json_and_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "roll.h5"
    found = json_of(["run", written(tmp_path, ROLL), "-s", "roll", "-o", str(target)], capsys)
    assert (found["status"], found["steps"], found["mesh"]) == ("finished", 41, "stage")
    stage = found["meshes"]["stage"]
    psi = np.array(stage["mesh_phase"])
    # gap/2 + e + T/(r_b k), in the phase of the loaded flank
    k = 4e8 * (
        1 - 0.2 * np.cos(2 * np.pi * psi) - 0.1 * np.cos(4 * np.pi * psi) - 0.05 * np.cos(6 * np.pi * psi)
    )
    e = 1e-6 * np.cos(2 * np.pi * psi) + 0.5e-6 * np.cos(4 * np.pi * psi)
    r_b = 0.075 * np.cos(np.radians(20))
    assert stage["transmission_error"] == pytest.approx(50e-6 + e + 150.0 / r_b / k, abs=1e-12)
    assert stage["tangent_stiffness"] == pytest.approx(k, rel=1e-9)
    assert stage["mean_stiffness"] == pytest.approx(4e8, rel=1e-5)
    row = found["channels"]["mesh_force[stage]"]
    assert row["mean"] == pytest.approx(150.0 / r_b, rel=1e-9)
    with open_result(target) as data:
        assert data["transmission_error[stage]"].dims == ("mesh_phase_position",)
        assert data["transmission_error[stage]"].values == pytest.approx(stage["transmission_error"])
        assert data["transmission_error[stage]"].attrs["symbol"] == "u_bt"
    assert read_header(target)["kind"] == "quasi_static"
    assert read_header(target)["notes"] == "; ".join(found["notes"])
    assert run_command(["report", str(target)]) == 0
    assert '<section id="roll"' in target.with_suffix(".html").read_text()


def test_table_for_people(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["run", written(tmp_path, ROLL), "-s", "roll", "-o", str(tmp_path / "r.h5")]) == 0
    out = capsys.readouterr().out
    assert "stage: mesh force, mean" in out
    assert "400 N/µm" in out
    assert "41 points in" in out


def test_table_of_the_bearings(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Statics of a supported pair: its bearing carries F_bt, and the table contains the bearing."""
    text = ROLL.replace("[g1], motion: torsion,", "[g1], motion: planar, mass: 3 kg,")
    text += "bearings:\n  left: {body: driver, stiffness: {radial: 1e9 N/m}}\n"
    assert run_command(["run", written(tmp_path, text), "-s", "roll", "-o", str(tmp_path / "r.h5")]) == 0
    out = capsys.readouterr().out
    line = next(line for line in out.splitlines() if "bearing_force[left.radial]" in line)
    # T/r_b of 150 N m
    assert line.split()[1:3] == ["2128.4", "N"]
    assert "torque[output]" in out


def test_interruption_keeps_the_points(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from pitchpoint.cli import progress

    def interrupt(self: object, done: float, total: float, note: str = "") -> None:
        if done == 7:
            raise KeyboardInterrupt

    monkeypatch.setattr(progress.ProgressDisplay, "__call__", interrupt)
    target = tmp_path / "roll.h5"
    assert run_command(["run", written(tmp_path, ROLL), "-s", "roll", "-o", str(target), "--json"]) == 130
    assert json.loads(capsys.readouterr().out)["steps"] == 7
    assert read_header(target)["status"] == "interrupted"
    with open_result(target) as data:
        assert data.sizes["mesh_phase_position"] == 7


def test_no_equilibrium_exits_3(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "law.py").write_text("def torque(t, x, p):\n    return float('nan')\n")
    text = ROLL.replace("output: {body: driven, torque: 150 N m}", "output: {body: driven, torque: "
                        "{python: 'law.py:torque'}}")  # fmt: skip
    assert run_command(["run", written(tmp_path, text), "-s", "roll", "--allow-code", "--json"]) == 3
    captured = capsys.readouterr()
    found = json.loads(captured.out)
    assert (found["status"], found["steps"], found["meshes"]) == ("failed", 0, {})
    assert "not a number" in captured.err


TRAIN = STAGES + "scenarios: {roll: {quasi_static: {mesh: first, points: 30, periods: 1}}}\n"


def test_partial_cycles_are_told_in_table_json_and_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    note = "mesh second repeats after 3 periods of first, and its peak to peak is that of 1"
    file, target = written(tmp_path, TRAIN), tmp_path / "roll.h5"
    found = json_of(["run", file, "-o", str(target)], capsys)
    assert found["notes"] == [note]
    assert [mesh["repeats_after_periods"] for mesh in found["meshes"].values()] == [1, 3]
    assert read_header(target)["notes"] == note
    assert run_command(["run", file, "-o", str(target)]) == 0
    out = capsys.readouterr().out
    assert "second, 1 of 3 periods: mesh force" in out
    assert "first: mesh force" in out
    assert f"note: {note}" in out


def test_cases_of_a_roll_show_what_a_single_roll_shows(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, out = written(tmp_path, TRAIN), ["-o", str(tmp_path / "out.h5")]
    assert run_command(["run", file, *out]) == 0
    single = [line.split("  ")[-1].strip() for line in capsys.readouterr().out.splitlines()]
    assert run_command(["run", file, *out, "--vary", "loads.motor.torque=30 N m,60 N m"]) == 0
    text = capsys.readouterr().out
    for name in ("transmission error, mean", "peak to peak", "without load, mean", "mesh stiffness, mean"):
        assert name in text
    for mesh, numbers in (("first", single[4:10]), ("second", single[10:16])):
        row = next(line for line in text.splitlines() if line.split()[:4] == ["60", "N", "m", mesh])
        assert [cell for cell in numbers if cell not in row] == []
    assert "note: cases 0 and 1: mesh second repeats after 3 periods of first" in text


@pytest.mark.parametrize("option", ["--step=5 us", "--decimate=2", "--jobs=2"])
def test_options_without_effect_on_a_roll_are_refused(
    option: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run_command(["run", written(tmp_path, ROLL), "-s", "roll", option]) == 2
    assert f"{option.partition('=')[0]} has no effect" in capsys.readouterr().err
    assert list(tmp_path.glob("*.h5")) == []


def test_a_roll_that_nothing_loads_says_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = ROLL.replace("output: {body: driven, torque: 150 N m}", "output: {body: driven, torque: 0 N m}")
    assert run_command(["run", written(tmp_path, text), "-s", "roll", "-o", str(tmp_path / "r.h5")]) == 0
    out = capsys.readouterr().out
    assert "note: mesh stage carries no load, and 150 N m on driver are balanced by holding torques" in out
    assert "speed" not in out
    assert "0 mm" not in out
