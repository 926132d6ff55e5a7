# SPDX-License-Identifier: Apache-2.0
"""Impacts of an idle gear in `run`, its file, the table of `--vary`, speed sweeps and the report."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.case_store import read_cases
from pitchpoint.io.contact_numbers import RATTLE
from pitchpoint.io.results import open_result
from tests.support.cli_files import json_of, written

IDLE = """\
gears:
  driver: {number_of_teeth: 20, normal_module: 2 mm, face_width: 10 mm, profile_shift_coefficient: 0}
  idle: {number_of_teeth: 40, normal_module: 2 mm, face_width: 10 mm, profile_shift_coefficient: 0}
bodies:
  input: {gears: [driver], inertia: 1e-3 kg m^2}
  output: {gears: [idle], inertia: 2e-4 kg m^2}
meshes:
  stage: {gears: [driver, idle], backlash: {base_tangent: 0.1 mm}, stiffness: {law: constant, value: 1e8 N/m},
          damping: {ratio: 0.05, s_0: 0.001 um}}
loads:
  drag: {body: output, torque: 0.2 N m}
scenarios:
  idle:
    drive: {input: {speed: 750 rpm, ripple: {firing: {order: 2, fluctuation: 60 %}}}}
    duration: 0.16 s
    settle_time: 0.08 s
    step: 20 us
    sample_rate: 5 kHz
  speeds:
    drive: {input: {ripple: {firing: {order: 2, fluctuation: 60 %}}}}
    sweep: {body: input, speed: [600 rpm, 900 rpm], points: 2, direction: up, settle_periods: 40,
            measure_periods: 40}
"""
FLUCTUATION = "scenarios.idle.drive.input.ripple.firing.fluctuation"


def test_a_run_prints_and_stores_the_impacts(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, target = written(tmp_path, IDLE), tmp_path / "idle.h5"
    assert run_command(["run", file, "-s", "idle", "-o", str(target)]) == 0
    printed = capsys.readouterr().out
    assert "rattle" in printed and "closing" in printed and " front" in printed
    found = json_of(["run", file, "-s", "idle", "-o", str(target)], capsys)["channels"][
        "contact_state[stage]"
    ]
    assert found["front_impacts"] > 0
    with open_result(target) as data:
        # J i alpha / T; T is the mean torque on the idle gear: drag and change of the angular momentum
        begin, end = data["speed[output]"].sel(time=[0.08, 0.16], method="nearest").values
        by_hand = 2e-4 * 0.5 * 0.6 * (750 * math.pi / 30) ** 2 / (0.2 - 2e-4 * (end - begin) / 0.08)
        assert found["rattle_index"] == pytest.approx(by_hand, rel=1e-5)
        for name, _, _ in RATTLE:
            assert data["contact_state[stage]"].attrs[name] == pytest.approx(found[name], rel=1e-12)
    page = tmp_path / "idle.html"
    assert run_command(["report", file, str(target), "-o", str(page), "--quiet"]) == 0
    assert f"{1e3 * found['closing_speed_max']:.4g} mm/s" in page.read_text(encoding="utf-8")


def test_cases_have_numbers_of_the_contact(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The quiet case has zeros, the loud one what a single run has; the file is read back as the results."""
    file, target = written(tmp_path, IDLE), tmp_path / "cases.h5"
    command = ["run", file, "-s", "idle", "--vary", f"{FLUCTUATION}=1 %,60 %", "-o", str(target)]
    cases = json_of(command, capsys)["cases"]
    quiet, loud = (case["channels"]["contact_state[stage]"] for case in cases)
    assert (quiet["impact_rate"], quiet["closing_speed_max"], quiet["contact_loss_share"]) == (0.0, 0.0, 0.0)
    assert loud["impact_rate"] > 20.0
    stored = read_cases(target)
    for case, numbers in zip(stored, (quiet, loud), strict=True):
        for name, _, _ in RATTLE:
            assert case["channels"]["contact_state[stage]"][name] == pytest.approx(numbers[name], rel=1e-6)
    with open_result(target) as data:
        assert data["impact_rate[stage]"].attrs["units"] == "1/s"
        assert data["impact_rate[stage]"].dims == ("case",)
    assert run_command(command) == 0
    printed = capsys.readouterr().out
    assert "rattle index" in printed and f"{loud['rattle_index']:.3f}" in printed
    page = tmp_path / "cases.html"
    assert run_command(["report", file, str(target), "-o", str(page), "--quiet"]) == 0
    assert "rattle index" in page.read_text(encoding="utf-8")


def test_points_of_a_sweep_have_impacts(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The acceleration grows with the square of the speed: 0.6 and 1.1 of the drag torque."""
    text = IDLE.replace("60 %", "20 %")
    target = tmp_path / "sweep.h5"
    found = json_of(["sweep", written(tmp_path, text), "-o", str(target)], capsys)
    slow, fast = found["points"]
    assert slow["impact_rate"] == 0.0
    assert fast["closing_speed_max"] >= 0.0
    with open_result(target) as data:
        values = data["closing_speed_max[stage]"].values[0]
        assert values == pytest.approx([p["closing_speed_max"] for p in found["points"]], rel=1e-6)
