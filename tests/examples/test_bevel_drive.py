# SPDX-License-Identifier: Apache-2.0
"""The example `bevel-drive`: what its README says of forces, losses and transmission errors."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.report.power_flow import power_flow
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

FOLDER = Path(__file__).parents[2] / "examples" / "bevel-drive"
BACKWARDS = {"loads.brake.torque": -150.0, "scenarios.steady.speed.motor": "-1500 rpm"}
RUNS = {"straight": ("straight", {}), "forwards": ("spiral", {}), "backwards": ("spiral", BACKWARDS)}


@pytest.fixture(scope="module")
def machines():
    return {name: load_model(FOLDER / f"{file}.yaml").replace_all(new) for name, (file, new) in RUNS.items()}


@pytest.fixture(scope="module")
def runs(machines):
    return {name: solve_time(compile_model(model, "steady")) for name, model in machines.items()}


def mean(run, channel):
    """Mean over the settled part."""
    return float(run[channel].values[run.sizes["time"] // 5 :].mean())


def test_forces_of_the_table(runs):
    table = {"straight": (1874, 287, 620), "forwards": (1867, 1572, 270), "backwards": (1887, -882, 1250)}
    for name, expected in table.items():
        found = [
            mean(runs[name], f"{c}[stage]") for c in ("circumferential_force", "axial_force_1", "axial_force")
        ]
        found[0] = abs(found[0])
        assert found == pytest.approx(expected, abs=5.0), name


def test_components_are_those_of_the_textbook(machines, runs):
    """Between A and E the rays of contact differ from the pitch ray, by which the parts swing: 3 % of F_t."""
    signs = {"straight": 0.0, "forwards": 1.0, "backwards": -1.0}
    for name, sign in signs.items():
        gear = machines[name].bevel_pairs["stage"].gear1
        F_t = abs(mean(runs[name], "circumferential_force[stage]"))
        tan, beta = math.tan(gear.alpha_n), abs(gear.beta_m)
        axial = tan * math.sin(gear.delta) + sign * math.sin(beta) * math.cos(gear.delta)
        radial = tan * math.cos(gear.delta) - sign * math.sin(beta) * math.sin(gear.delta)
        assert mean(runs[name], "axial_force_1[stage]") == pytest.approx(
            F_t * axial / math.cos(beta), abs=0.03 * F_t
        )
        assert mean(runs[name], "radial_force_1[stage]") == pytest.approx(
            F_t * radial / math.cos(beta), abs=0.03 * F_t
        )


def test_bearings_hold_what_the_mesh_pushes(runs):
    for name, run in runs.items():
        assert -mean(run, "bearing_force[pinion_a.fz]") == pytest.approx(
            mean(run, "axial_force_1[stage]"), abs=12.0
        ), name  # friction has an axial part of its own


def test_speeds_and_powers(machines, runs):
    for name, run in runs.items():
        ratio = mean(run, "speed[motor]") / mean(run, "speed[brake]")
        assert ratio == pytest.approx(-43.0 / 17.0, rel=1e-4)
        flow = power_flow(machines[name], run, 0.04)
        stage = next(link for link in flow.links if link.name == "stage")
        assert stage.losses["friction"] == pytest.approx(49.0, abs=5.0)
        put_in = max(link.given for link in flow.links)
        balance = sum(link.given for link in flow.links if link.start < 0)
        balance -= sum(link.taken for link in flow.links if link.end < 0)
        lost = sum(sum(link.losses.values()) for link in flow.links)
        stored = sum(block.stored for block in flow.blocks) + flow.elastic
        fed = sum(link.fed for link in flow.links)
        assert balance + fed == pytest.approx(lost + stored, abs=1e-4 * put_in), name
        # every block by itself too; with straight teeth the friction turns round between two samples
        assert max(abs(flow.left(k)) for k in range(len(flow.blocks))) < 5e-5 * put_in, name


def test_rolls(machines):
    for name, ripple in (("straight", 3.6e-6), ("forwards", 0.7e-6), ("backwards", 1.0e-6)):
        found = roll_through(compile_model(machines[name], "roll"), "roll")
        mesh = found.meshes["stage"]
        assert np.ptp(mesh.unloaded) < 1e-11
        system = compile_model(machines[name], "roll")
        te = found.rows[:, system.layout.channel("transmission_error[stage]")]
        assert np.ptp(te) == pytest.approx(ripple, abs=0.06e-6)


def test_the_load_sits_outside_the_mean_cone_distance_of_a_leaning_shaft(machines, runs):
    """On stiff bearings where a rigid turn puts it, but for friction (0.5 %) and rays beside p (0.3 %)."""
    gear = machines["straight"].bevel_pairs["stage"].gear2
    lever = 150.0 / mean(runs["straight"], "circumferential_force[stage]")
    assert 0.5 * gear.d_m == pytest.approx(74e-3, abs=5e-4) and 0.5 * gear.d_e == pytest.approx(
        86e-3, abs=5e-4
    )
    assert lever == pytest.approx(80e-3, abs=5e-4)
    stiff = machines["straight"].replace_all(
        {f"bearings.{b}.stiffness.radial": 1e11 for b in ("pinion_a", "pinion_b", "wheel_a", "wheel_b")}
    )
    run = solve_time(compile_model(stiff, "steady"))
    wide = (gear.b / gear.R_m) ** 2 / 12.0
    assert 150.0 / mean(run, "circumferential_force[stage]") == pytest.approx(
        0.5 * gear.d_m * (1 + wide), rel=1e-2
    )
