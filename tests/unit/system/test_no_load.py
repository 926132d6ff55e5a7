# SPDX-License-Identifier: Apache-2.0
"""Meshes without load have no load shares, contacts and stiffness from the rounding of their positions."""

from __future__ import annotations

import math

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.reading import open_result
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.planets import load_sharing
from pitchpoint.solvers.contact_counts import CONTACT_NUMBERS
from pitchpoint.solvers.time import run_time, solve_time
from pitchpoint.system.compile import compile_model
from pitchpoint.system.no_load import least_forces, rounding_force, unloaded_meshes
from pitchpoint.system.planet_loads import loads_of_planets, mesh_load_factor
from pitchpoint.viz.quantities import stored_contact
from pitchpoint.viz.report.planets import planet_table
from tests.support.cli_files import json_of, written
from tests.support.planet_stages import stage_file


def held_sun():
    """The load acts on the sun, which is held: no mesh carries it."""
    text = stage_file("planets: 4").replace(
        "steady: {speed: {sun: 1000 rpm}, duration: 5 ms, settle_time: 2 ms}",
        "held: {hold: [sun], speed: {carrier: 60 rpm}, duration: 20 ms, step: 0.1 ms}",
    )
    return text.replace("  brake: {body: carrier, torque: balance}\n", "")


def test_the_limit_is_the_rounding_of_a_turn():
    """Spacing of numbers about 1 times the arc of a turn, 2.2e-16 2 pi 0.09 m, times b E."""
    found = least_forces(loads_model(stage_file()), 0.0)
    arcs = {"sun-planet_1": 0.5 * 3e-3 * (21 + 39), "planet_1-ring": 0.5 * 3e-3 * (39 + 99)}
    for mesh, radii in arcs.items():
        assert found[mesh] == pytest.approx(2.0**-52 * math.tau * radii * 0.04 * 2.1e11, rel=1e-9)
    # far below the weight of a grain of sand, 0.1 mN
    assert max(found.values()) < 1e-5
    assert least_forces(loads_model(stage_file()), 1e6)["sun-planet_1"] == pytest.approx(1e-4)
    assert rounding_force(0.0, 0.04) == 0.0


def test_shares_need_a_load():
    model = loads_model(stage_file())
    names = [f"mesh_force[sun-planet_{k}]" for k in (1, 2, 3)]
    for forces, factor in (
        ((3e-8, -1e-8, 1e-8), None),
        ((1000.0, -400.0, -600.0 + 1e-9), None),  # stressed against each other by pin errors
        ((1200.0, 900.0, 900.0), 1.2),
        ((1.2e-2, 0.9e-2, 0.9e-2), 1.2),
    ):
        loads = loads_of_planets(model, lambda c, f=forces: dict(zip(names, f, strict=True)).get(c, 0.0))[
            "set"
        ]
        assert loads.factor == (factor if factor is None else pytest.approx(factor))
        assert all(math.isnan(share) == (factor is None) for share in loads.share)
    assert mesh_load_factor([1.0, 1.0], least=1.0) is None


def test_a_stage_whose_sun_is_held(tmp_path, capsys):
    """Forces of 1e-8 N between contact and separation: no factor, no impacts, in table, file and report."""
    model = loads_model(held_sun())
    run = run_time(compile_model(model, "held"))
    forces = [run.channels[f"mesh_force[{mesh}]"] for mesh in model.every_mesh]
    assert max(abs(row[key]) for row in forces for key in ("min", "max")) < 1e-6
    assert unloaded_meshes(model, run.channels) == set(model.every_mesh)
    for mesh in model.every_mesh:
        row = run.channels[f"contact_state[{mesh}]"]
        if row["share_zero"] < 1.0:
            assert all(math.isnan(row[key]) for key in CONTACT_NUMBERS)
    target = tmp_path / "held.h5"
    assert run_command(["run", written(tmp_path, held_sun()), "-s", "held", "-o", str(target)]) == 0
    out = capsys.readouterr().out
    assert "set: no load on the planets, no mesh load factor K_γ" in out
    assert "impacts" not in out
    assert "e-0" not in out.partition("torque")[0]
    with open_result(target) as data:
        assert not any(
            (found := stored_contact(data[f"contact_state[{mesh}]"].attrs)) and found["front_impacts"]
            for mesh in model.every_mesh
        )
        loads = load_sharing(model, data)
    assert loads["set"]["load_sharing_factor"] is None
    assert "no load on the planets" in planet_table(loads)


def test_a_slow_roll_of_a_planet_without_load(tmp_path, capsys):
    """A pin 60 µm ahead: the other two planets carry; planet 1 rests between its flanks."""
    text = stage_file("planets: 3\npin_errors: {planet_1: {tangential: 60 um}}", torque=300.0)
    text = text.replace("damper: {ratio: 0.05}", "damper: {ratio: 0.05}, backlash: {normal: 0.4 mm}")
    file = written(tmp_path, text)
    found = json_of(["run", file, "-s", "slow", "-o", str(tmp_path / "a.h5")], capsys)["meshes"]
    assert found["sun-planet_1"]["mean_stiffness"] is None
    assert found["sun-planet_2"]["mean_stiffness"] == pytest.approx(5e8)
    assert run_command(["run", file, "-s", "slow", "-o", str(tmp_path / "b.h5")]) == 0
    lines = capsys.readouterr().out.splitlines()
    first = next(k for k, line in enumerate(lines) if "sun-planet_1: mesh force, mean" in line)
    assert lines[first].split()[-2:] == ["no", "load"]
    assert lines[first + 5].split()[-1] == "–"


GRAVITY = "gravity: [0, -9.81, 0]\n"


@pytest.mark.parametrize(
    ("gravity", "motion", "turns", "noted"),
    [
        (GRAVITY, "planar", 0.3, True),
        (GRAVITY, "planar", 1.0, False),
        (GRAVITY, "torsion", 0.3, False),  # bodies that only rotate
        ("gravity: [0, 0, -9.81]\n", "planar", 0.3, False),  # along the axis
        ("", "planar", 0.3, False),
    ],
)
def test_a_window_of_part_of_a_turn_is_noted(gravity, motion, turns, noted):
    more = f"planets: 3\nmotion: {motion}" + (
        "\nbearing: {stiffness: {radial: 5e8 N/m}, damping: {ratio: 0.1}}" if motion == "planar" else ""
    )
    speed, window = 1200.0, 0.05  # 1 turn of the carrier in 50 ms
    text = gravity + stage_file(more).replace(
        "{speed: {sun: 1000 rpm}, duration: 5 ms, settle_time: 2 ms}",
        f"{{speed: {{carrier: {speed * turns} rpm}}, duration: {window} s, settle_time: 0 s, step: 50 us}}",
    )
    notes = solve_time(compile_model(loads_model(text), "steady")).attrs["notes"]
    assert ("K_γ depend on the window" in notes) == noted
