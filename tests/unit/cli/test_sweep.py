# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint sweep`: the contract of its JSON, and the file it leaves."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.reading import open_result, read_header
from pitchpoint.io.sweep_store import read_sweep
from pitchpoint.io.yaml_model import load_model
from pitchpoint.sweep.speed import plan_sweep
from pitchpoint.system.compile import compile_model
from tests.support.cli_files import TORSION, json_of, written

SMALL = TORSION.replace("points: 81", "points: 4").replace(
    "settle_periods: 200, measure_periods: 50", "settle_periods: 5, measure_periods: 5"
)


def test_contract(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, target = written(tmp_path, SMALL), tmp_path / "sweep.h5"
    found = json_of(["sweep", file, "--scenario", "sweep", "-o", str(target)], capsys)
    assert found["status"] == "finished"
    order = [(p["direction"], round(p["mesh_frequency"])) for p in found["points"]]
    up = [1000, 2333, 3667, 5000]
    assert order == [("up", f) for f in up] + [("down", f) for f in reversed(up)]
    for point in found["points"]:
        assert point["speed"] == pytest.approx(2.0 * 3.141592653589793 * point["mesh_frequency"] / 50)
        for name, unit in (("transmission_error", "m"), ("deflection", "m"), ("mesh_force", "N")):
            row = point[name]
            assert row["unit"] == unit
            assert row["min"] <= row["mean"] <= row["max"]
        assert 0.0 <= point["contact_loss_share"] <= 1.0
        assert 0.0 <= point["back_contact_share"] <= 1.0
    for jump in found["jumps"]:
        assert set(jump) == {"direction", "mesh_frequency"}
    kept = read_sweep(target)
    assert kept["jumps"] == found["jumps"]
    for one, two in zip(kept["points"], found["points"], strict=True):
        assert one["deflection"] == two["deflection"]
        assert one["contact_loss_share"] == two["contact_loss_share"]
        assert one["mesh_frequency"] == pytest.approx(two["mesh_frequency"])


def test_the_file_has_all_channels(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Bearings of a second machine part over speed: mean, rms, least and greatest at every point."""
    text = SMALL.replace("motion: torsion, inertia: 0.0115", "motion: planar, mass: 3 kg, inertia: 0.0115")
    text = text.replace("loads:", "bearings:\n  left: {body: driver, stiffness: {radial: 2e8 N/m}}\n"
                        "  right: {body: driven, stiffness: {radial: 2e8 N/m}}\nloads:")  # fmt: skip
    target = tmp_path / "sweep.h5"
    found = json_of(["sweep", written(tmp_path, text), "-o", str(target)], capsys)
    with open_result(target) as data:
        force = data["bearing_force[left.fy]"]
        assert force.dims == ("direction", "mesh_frequency", "statistic")
        assert (force.attrs["units"], force.attrs["symbol"]) == ("N", "F_B")
        assert np.isfinite(force.values).all()
        low, mean, high = (force.sel(statistic=s).values for s in ("min", "mean", "max"))
        assert np.all(low < mean)
        assert np.all(mean < high)
        assert "displacement[driver.x]" in data
        mesh = data["deflection[stage]"].sel(direction="up", statistic="rms").values
        assert mesh == pytest.approx([p["deflection"]["rms"] for p in found["points"][:4]], rel=1e-15)
    assert read_sweep(target)["mesh"] == "stage"


def test_people_get_a_table(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run_command(["sweep", written(tmp_path, SMALL.replace("both", "up"))]) == 0
    out = capsys.readouterr().out
    assert "sweep, mesh stage" in out
    for text in (
        "up, 1000 Hz to 5000 Hz",
        "mesh frequency",
        "maximum rms of deflection",
        "jumps at",
        "4 points in",
        "model-sweep.h5",
    ):
        assert text in out


def test_speeds_of_the_scenario_are_speeds_of_the_table(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = SMALL.replace("mesh_frequency: [1000 Hz, 5000 Hz]", "speed: [1200 rpm, 6000 rpm]")
    assert run_command(["sweep", written(tmp_path, text), "-o", str(tmp_path / "s.h5")]) == 0
    out = capsys.readouterr().out
    for words in ("speed of driver", "up, 1200 rpm to 6000 rpm", "down, 6000 rpm to 1200 rpm"):
        assert words in out
    assert "Hz" not in out


def test_ctrl_c_keeps_the_finished_points(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from pitchpoint.cli import progress

    def interrupt(self: object, done: float, total: float, note: str = "") -> None:
        if done == 3:
            raise KeyboardInterrupt

    monkeypatch.setattr(progress.ProgressDisplay, "__call__", interrupt)
    file, target = written(tmp_path, SMALL), tmp_path / "sweep.h5"
    assert run_command(["sweep", file, "-o", str(target), "--json"]) == 130
    captured = capsys.readouterr()
    assert json.loads(captured.out)["status"] == "interrupted"
    assert len(json.loads(captured.out)["points"]) == len(read_sweep(target)["points"]) == 3
    assert read_header(target)["status"] == "interrupted"


def test_plan_by_speed(tmp_path: Path) -> None:
    text = SMALL.replace("mesh_frequency: [1000 Hz, 5000 Hz]", "speed: [600 rpm, 1200 rpm]")
    model = load_model(written(tmp_path, text))
    plan = plan_sweep(compile_model(model, "sweep"), model.scenarios["sweep"])
    assert (plan.mesh, plan.directions) == ("stage", ("up", "down"))
    assert plan.speeds * 60 / (2 * np.pi) == pytest.approx([600, 800, 1000, 1200])
    assert plan.frequencies == pytest.approx([500, 2000 / 3, 2500 / 3, 1000])
