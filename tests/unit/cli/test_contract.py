# SPDX-License-Identifier: Apache-2.0
"""The JSON that outside programs rely on, field by field, on the two model files of the contract."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pitchpoint.analysis.statistics import signal_statistics
from pitchpoint.cli.main import run_command
from pitchpoint.io.reading import read_channel
from tests.support.cli_files import ISO_EX1, TORSION, json_of, written

GEAR = "z m_n m_t alpha_n alpha_t beta beta_b x d d_b d_a d_f d_Ff s_n p_t p_et mass".split()
MESH = (
    "a_d a_w alpha_wt x_sum x_sum_given d_w1 d_w2 d_Nf1 d_Nf2 g_alpha eps_alpha eps_beta eps_gamma "
    "c_prime c_gamma_alpha C_R C_B j_bt j_wt j_bn"
).split()
CYCLE = {"phase", "stiffness_ratio", "mean", "peak_to_peak"}
STATISTICS = {"unit", "mean", "rms", "min", "max"}
CHANNELS = {"transmission_error": "m", "deflection": "m", "mesh_force": "N"}


def numbers(row: dict[str, Any], names: list[str]) -> None:
    """Every name is there and a finite number."""
    for name in names:
        assert isinstance(row[name], int | float), name
        assert math.isfinite(row[name]), name


@pytest.mark.parametrize("text", [ISO_EX1, TORSION], ids=["iso", "torsion"])
def test_gears_and_mesh(text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, text)
    data = json_of(["gears", file], capsys)
    assert set(data) == {"gears", "meshes", "bevel_gears", "bevel_meshes"}
    for gear in data["gears"].values():
        numbers(gear, GEAR)
        assert gear["d"] == pytest.approx(gear["z"] * gear["m_t"], rel=1e-12)
        assert gear["d_b"] == pytest.approx(gear["d"] * math.cos(gear["alpha_t"]), rel=1e-12)
    for mesh in data["meshes"].values():
        numbers(mesh, MESH)
        assert mesh["eps_gamma"] == pytest.approx(mesh["eps_alpha"] + mesh["eps_beta"], rel=1e-12)
    cycles = json_of(["mesh", file], capsys)["meshes"]
    assert set(cycles) == set(data["meshes"])
    for cycle in cycles.values():
        assert set(cycle) >= CYCLE
        assert len(cycle["phase"]) == len(cycle["stiffness_ratio"])
        sampled = max(cycle["stiffness_ratio"]) - min(cycle["stiffness_ratio"])
        assert cycle["peak_to_peak"] >= sampled - 1e-12


def test_mesh_without_a_file(capsys: pytest.CaptureFixture[str]) -> None:
    """MS-OVERLAP: at these ratios one pair or two carry; the extremes are those of the formula."""
    options = "--eps-alpha 1.3 --eps-beta 0.85 --stiffness-ratio 0.8 --tip-relief-factor 0".split()
    (found,) = json_of(["mesh", *options], capsys)["meshes"].values()
    assert set(found) >= CYCLE
    # mean of 1 - (1 - S_R) zeta^2 over the way, times its length
    assert found["mean"] == pytest.approx(1.3 * (1.0 - 0.2 / 3.0), rel=1e-9)
    spur = json_of(["mesh", *options[:2], "--eps-beta", "0", *options[4:]], capsys)["meshes"]
    assert next(iter(spur.values()))["peak_to_peak"] > found["peak_to_peak"] > 0.0


def test_run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "out.h5"
    file = written(tmp_path, TORSION)
    found = json_of(["run", file, "--scenario", "steady", "-o", str(target)], capsys)
    assert set(found) >= {"status", "steps", "wall_s", "channels"}
    assert found["status"] == "finished"
    for name, unit in CHANNELS.items():
        row = found["channels"][f"{name}[stage]"]
        assert set(row) == STATISTICS
        assert row["unit"] == unit
        # rms is that of the alternating part, over the window that begins at 20 % of the duration
        t, values = read_channel(target, f"{name}[stage]")
        stored = signal_statistics(values[t >= 0.1].astype(float), t[t >= 0.1])
        for key, tolerance in (("mean", 1e-3), ("rms", 2e-2), ("min", 0.03), ("max", 0.03)):
            assert row[key] == pytest.approx(getattr(stored, key), rel=tolerance), (name, key)
        assert row["rms"] < row["max"] - row["min"]
    # u_bt and u_bt - e differ by e, whose mean over whole periods is zero
    te, deflection = (found["channels"][f"{n}[stage]"] for n in ("transmission_error", "deflection"))
    assert te["mean"] == pytest.approx(deflection["mean"], abs=2e-9)
    t, u = read_channel(target, "transmission_error[stage]")
    _, d = read_channel(target, "deflection[stage]")
    _, psi = read_channel(target, "mesh_phase[stage]")
    e = 1e-6 * np.cos(2 * np.pi * psi) + 0.5e-6 * np.cos(4 * np.pi * psi)
    assert u - d == pytest.approx(e, abs=3e-11)


def test_sweep(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = TORSION.replace("points: 81", "points: 21").replace("[1000 Hz, 5000 Hz]", "[1500 Hz, 2500 Hz]")
    found = json_of(
        ["sweep", written(tmp_path, text), "--scenario", "sweep", "-o", str(tmp_path / "out.h5")], capsys
    )
    assert len(found["points"]) == 42
    for point in found["points"]:
        assert point["direction"] in ("up", "down")
        numbers(point, ["speed", "mesh_frequency", "contact_loss_share", "back_contact_share"])
        assert all(set(point[name]) == STATISTICS for name in CHANNELS)
    jumps = {d: [j["mesh_frequency"] for j in found["jumps"] if j["direction"] == d] for d in ("up", "down")}
    assert max(jumps["up"]) > max(jumps["down"])  # the branch bends to the left: hysteresis


def test_internal_gears_are_positive(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = """
gears:
  planet: {number_of_teeth: 20, normal_module: 2 mm, helix_angle: 10 deg, hand: left, face_width: 20 mm,
           profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 70, normal_module: 2 mm, helix_angle: 10 deg, hand: left,
         face_width: 20 mm, profile_shift_coefficient: 0}
meshes:
  outer: {gears: [planet, ring]}
"""
    data = json_of(["gears", written(tmp_path, text)], capsys)
    ring, outer = data["gears"]["ring"], data["meshes"]["outer"]
    numbers(ring, GEAR)
    numbers(outer, MESH)
    for name in ("z", "d", "d_b", "d_a", "d_f", "d_Ff", "s_n", "p_t", "mass"):
        assert ring[name] > 0, name
    for name in ("a_d", "a_w", "d_w1", "d_w2", "d_Nf1", "d_Nf2", "eps_alpha", "j_bt"):
        assert outer[name] > 0, name


def test_nothing_but_json_on_stdout_of_the_installed_script(tmp_path: Path) -> None:
    text = TORSION.replace("duration: 0.5 s", "duration: 0.01 s")
    code = "from pitchpoint.cli.main import main; main()"
    command = [sys.executable, "-c", code, "run", written(tmp_path, text), "-s", "steady", "--json"]
    done = subprocess.run(
        [*command, "-o", str(tmp_path / "out.h5")], capture_output=True, text=True, check=True
    )
    assert json.loads(done.stdout)["status"] == "finished"
    bad = written(tmp_path, text.replace("150 mm", "150 kg"), "bad.yaml")
    failed = subprocess.run([*command[:4], bad, "--json"], capture_output=True, text=True, check=False)
    assert (failed.returncode, failed.stdout) == (2, "")
    assert "line 11" in failed.stderr


def test_both_files_pass_the_check(tmp_path: Path) -> None:
    for text in (ISO_EX1, TORSION):
        assert run_command(["check", written(tmp_path, text)]) == 0
