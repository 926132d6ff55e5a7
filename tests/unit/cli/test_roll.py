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
    assert '<section id="roll">' in target.with_suffix(".html").read_text()


def test_table_for_people(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["run", written(tmp_path, ROLL), "-s", "roll", "-o", str(tmp_path / "r.h5")]) == 0
    out = capsys.readouterr().out
    assert "stage: mesh force, mean" in out
    assert "400 N/µm" in out
    assert "41 points in" in out


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
