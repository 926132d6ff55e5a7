# SPDX-License-Identifier: Apache-2.0
"""Mesh load factors and bearing forces in the tables of `--vary` and of sweeps."""

from __future__ import annotations

import math

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.case_store import read_cases
from pitchpoint.io.reading import open_result
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.sweep.cases import cases_dataset, grid, run_cases
from pitchpoint.sweep.speed import sweep_speed
from pitchpoint.system.compile import compile_model
from tests.support.cli_files import json_of, written
from tests.support.planet_stages import PIN_BEARING, stage_file

PATH = "planetary_stages.set.pin_errors.planet_1.tangential"
NAME = "load_sharing_factor[set]"
BACKLASH = "stiffness: {law: constant, value: 5e8 N/m}, damper: {ratio: 0.05}, backlash: {normal: 0.4 mm}"
FILE = stage_file(
    f"planets: 3\nmotion: planar\nbearing: {{{PIN_BEARING}, damping: {{ratio: 0.03}}}}\n"
    "pin_errors: {planet_1: {tangential: 10 um}}"
) + (
    "  swept: {sweep: {body: sun, speed: [900 rpm, 1000 rpm], points: 2, direction: up, settle_periods: 2, "
    "measure_periods: 2}}\n"
)


def factor(point):
    """Largest mean force of the sun meshes over their mean."""
    forces = [point["channels"][f"mesh_force[sun-planet_{k}]"]["mean"] for k in (1, 2, 3)]
    return max(map(abs, forces)) / abs(math.fsum(forces) / 3.0)


def test_factors_of_cases_are_single_numbers(tmp_path, capsys):
    target = tmp_path / "cases.h5"
    command = [
        "run",
        written(tmp_path, FILE),
        "-s",
        "slow",
        "--vary",
        f"{PATH}=0 um,40 um",
        "-o",
        str(target),
    ]
    cases = json_of(command, capsys)["cases"]
    wanted = [factor(case) for case in cases]
    assert wanted[0] == pytest.approx(1.0, abs=1e-6)
    assert wanted[1] > 1.01
    with open_result(target) as data:
        assert data[NAME].dims == ("case",)
        assert data[NAME].values.tolist() == pytest.approx(wanted, rel=1e-12)
    kept = read_cases(target)
    assert [case["channels"][NAME] for case in kept] == [case["channels"][NAME] for case in cases]


@pytest.mark.parametrize("error", [4e-6, -4e-6])
def test_the_factor_of_a_pin_error_is_that_of_springs(error):
    """Fixed axes, rigid pins, equal stiffness k of both meshes of every planet.

    A planet balances its two meshes, which act in line: force k/2 per travel at the sun. A pin that is ahead
    by e takes 2 e cos(alpha) of this travel, so planet 1 carries T/(3 r_b) - 2/3 k e cos(alpha), the others
    T/(3 r_b) + 1/3 k e cos(alpha).
    """
    model = loads_model(
        stage_file(f"planets: 3\npin_errors: {{planet_1: {{tangential: {error} m}}}}", mesh=BACKLASH)
    )
    (case,) = run_cases(model, [{"loads.motor.torque": "600 N m"}], "slow", jobs=1)
    cosine = math.cos(math.radians(20.0))
    part = 5e8 * error * cosine / (600.0 / (3.0 * 31.5e-3 * cosine)) / 3.0
    assert case.channels[NAME]["mean"] == pytest.approx(max(1.0 - 2.0 * part, 1.0 + part), rel=1e-4)


def test_bearing_forces_of_cases_are_printed(tmp_path, capsys):
    target = tmp_path / "cases.h5"
    file = written(tmp_path, FILE)
    assert run_command(["run", file, "-s", "slow", "--vary", f"{PATH}=0 um,40 um", "-o", str(target)]) == 0
    shown = capsys.readouterr().out
    table = shown[shown.index("bearing forces") :]
    assert "maximum radial planet_1-bearing" in " ".join(table.split())
    channels = read_cases(target)[1]["channels"]
    largest = channels["bearing_force[planet_2-bearing.radial]"]["max"]
    assert f"{largest * 1e-3:.5g} kN" in table


def test_factors_of_a_sweep_are_in_table_file_and_dataset(tmp_path, capsys):
    target = tmp_path / "sweep.h5"
    file = written(tmp_path, FILE)
    found = json_of(["sweep", file, "-s", "swept", "-o", str(target)], capsys)
    values = [point[NAME] for point in found["points"]]
    with open_result(target) as data:
        assert data[NAME].dims == ("direction", "mesh_frequency")
        assert data[NAME].values[0].tolist() == pytest.approx(values, rel=1e-12)
        means = [data[f"mesh_force[sun-planet_{k}]"].sel(statistic="mean").values[0] for k in (1, 2, 3)]
    expected = [max(map(abs, each)) * 3.0 / abs(math.fsum(each)) for each in zip(*means, strict=True)]
    assert values == pytest.approx(expected, rel=1e-12)
    assert run_command(["sweep", file, "-s", "swept", "-o", str(tmp_path / "again.h5")]) == 0
    assert "maximum K_γ set" in " ".join(capsys.readouterr().out.split())
    model = loads_model(FILE)
    assert sweep_speed(compile_model(model, "swept"))[NAME].values[0] == pytest.approx(values, rel=1e-9)


def test_factors_of_varied_sweeps(tmp_path):
    model = loads_model(FILE)
    results = run_cases(model, grid({PATH: ["0 um", "40 um"]}), "swept", jobs=1)
    table = cases_dataset(results)[NAME]
    assert table.dims == ("case", "direction", "point")
    assert table.values[0] == pytest.approx(1.0, abs=1e-6)
    assert table.values[1].min() > 1.01


def test_a_report_has_the_load_sharing_of_runs_and_rolls(tmp_path, capsys):
    file, pages = written(tmp_path, FILE), []
    for scenario in ("steady", "slow"):
        result, page = tmp_path / f"{scenario}.h5", tmp_path / f"{scenario}.html"
        found = json_of(["run", file, "-s", scenario, "-o", str(result)], capsys)["planet_loads"]["set"]
        assert run_command(["report", file, str(result), "-o", str(page)]) == 0
        capsys.readouterr()
        pages.append(page.read_text("utf-8"))
        assert f"mesh load factor K<sub>γ</sub> = {found['load_sharing_factor']:.4f}" in pages[-1]
        assert f"{100.0 * found['share'][1]:.2f}" in pages[-1]
    assert "Load sharing of the planets" in pages[0]


def test_a_planet_behind_by_its_pin_error_is_told_as_such():
    """A pin that is 100 µm ahead has no load; loads on both sides would not change it."""
    text = stage_file("planets: 3\npin_errors: {planet_1: {tangential: 100 um}}", mesh=BACKLASH)
    found = roll_through(compile_model(loads_model(text), "slow"))
    (words,) = [str(note) for note in found.notes if "carries no load" in str(note)]
    assert words.startswith("planet_1 carries no load: errors of the pins and the clearance of sun-planet_1")
    assert "both sides" not in words
