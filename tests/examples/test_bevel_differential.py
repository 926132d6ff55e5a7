# SPDX-License-Identifier: Apache-2.0
"""The differential of the example `bevel-drive`: bevel planets on a carrier between two gears on one axis."""

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.frequencies import frequencies_of
from pitchpoint.report.power_flow import power_flow
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

FILE = (Path(__file__).parents[2] / "examples" / "bevel-drive" / "differential.yaml").read_text("utf-8")


@pytest.fixture(scope="module")
def model():
    return loads_model(FILE)


def test_the_wheels_turn_as_the_cage_on_the_mean(model):
    speeds = model.start_speeds("bend")
    assert speeds["two"] == pytest.approx(70.0, rel=1e-12)
    # about its pin, seen from outside: z/z_p times the difference of a wheel and the cage
    assert speeds["up"] == pytest.approx(-16.0 / 10.0 * (70.0 - 60.0), rel=1e-12)
    assert speeds["down"] == pytest.approx(speeds["up"], rel=1e-12)


def test_the_torque_of_the_cage_is_shared_equally(model):
    """Both wheels get half of it, and each mesh a quarter of it over the base radius."""
    found = solve_equilibrium(compile_model(model))
    assert float(found["torque[engine]"]) == pytest.approx(120.0, rel=1e-9)
    pair = model.bevel_pairs["lu"]
    r_b = pair.R_m * math.sin(pair.gear1.delta_b)
    forces = [abs(float(found[f"mesh_force[{m}]"])) for m in ("lu", "ru", "ld", "rd")]
    assert forces == pytest.approx([30.0 / r_b] * 4, rel=1e-6)


def test_a_bend_over_many_turns_of_the_cage(model):
    """Almost three turns of the cage: teeth go on, whatever whole turns the planes of the axes have made;
    speeds and forces stay, and the power of the cage arrives at both wheels."""
    run = solve_time(compile_model(model, "bend"))
    late = slice(run.sizes["time"] // 5, None)
    assert float(run["angle[cage]"][-1]) == pytest.approx(18.0, rel=1e-3)
    for name, speed in (("one", 50.0), ("two", 70.0), ("cage", 60.0), ("up", -16.0)):
        assert float(run[f"speed[{name}]"].values[late].mean()) == pytest.approx(speed, rel=2e-3), name
    pair = model.bevel_pairs["lu"]
    r_b = pair.R_m * math.sin(pair.gear1.delta_b)
    for mesh in ("lu", "ru", "ld", "rd"):
        force = np.abs(run[f"mesh_force[{mesh}]"].values[late])
        assert force == pytest.approx(30.0 / r_b, rel=1e-3)
    flow = power_flow(model, run, 0.1)
    taken = {link.name: link for link in flow.links}
    assert taken["engine"].taken == pytest.approx(120.0 * 60.0, rel=1e-3)
    assert taken["wheel_1"].given == pytest.approx(60.0 * 50.0, rel=1e-3)
    names = [block.name for block in flow.blocks]
    on = dict.fromkeys(names, 0.0)
    for link in flow.links:
        for block, power in ((link.start, -link.given), (link.end, link.taken)):
            if block >= 0:
                on[names[block]] += power
    for block in flow.blocks:
        assert on[block.name] == pytest.approx(block.stored, abs=5.0), block.name


def test_teeth_meet_as_often_as_wheels_turn_against_the_cage(model):
    found = frequencies_of(model, model.start_speeds("bend"))["meshes"]
    for mesh in ("lu", "ru", "ld", "rd"):
        assert found[mesh]["frequency"] == pytest.approx(16.0 * 10.0 / math.tau, rel=1e-9)
        assert found[mesh]["carrier"] == "cage"


def test_a_carrier_about_another_axis_is_refused():
    text = FILE.replace(
        "cage: {motion: torsion", "cage: {axes: {z: [0, 1, 0], x: [1, 0, 0]}, motion: torsion"
    )
    with pytest.raises(ModelError, match="none of which rotates about the axis of the other"):
        loads_model(text)
