# SPDX-License-Identifier: Apache-2.0
"""The example `ravigneaux`: the numbers of its page, by slow rolls in all gears."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.report.static_power import static_power
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model

FOLDER = Path(__file__).parents[2] / "examples" / "ravigneaux"
GEARS = {
    "first": ("slow_first", "small_sun", "carrier"),
    "second": ("slow_second", "small_sun", "large_sun"),
    "overdrive": ("slow_overdrive", "carrier", "large_sun"),
    "reverse": ("slow_reverse", "large_sun", "carrier"),
}


@pytest.fixture(scope="module")
def model():
    return load_model(FOLDER / "model.yaml")


@pytest.mark.parametrize("gear", GEARS)
def test_the_table_of_the_page(model, gear):
    scenario, driven, held = GEARS[gear]
    text = (FOLDER / "README.md").read_text("utf-8").replace("−", "-")
    row = next(line for line in text.splitlines() if line.startswith(f"| {gear} |"))
    cells = [cell.strip() for cell in row.strip("|").split("|")]
    assert cells[1:3] == [driven.replace("_", " "), held.replace("_", " ")]
    ratio, output, holding = (float(re.findall(r"-?\d+(?:\.\d+)?", cell)[-1]) for cell in cells[3:])
    system = compile_model(model, scenario)
    torques = {load.body: load.torque.value for load in system.model.loads.values() if load.body != "ring"}
    assert torques == {"small_sun": 0.0, "carrier": 0.0, "large_sun": 0.0} | {driven: 100.0}
    found = solve_equilibrium(system)
    assert float(found["torque[output]"]) == pytest.approx(output, abs=6e-3)
    assert float(found["torque[output]"]) == pytest.approx(-100.0 * ratio, abs=0.06)
    assert float(found["holding_torque"].sel(held=f"{held}.spin")) == pytest.approx(holding, abs=6e-3)


@pytest.mark.parametrize(
    ("scenario", "held", "ratio"), [("first", "carrier", 8 / 3), ("second", "large_sun", 14 / 9)]
)
def test_the_power_flow_of_check(model, scenario, held, ratio):
    """Members in `hold` are at rest."""
    flow = static_power(model, model.scenarios[scenario], scenario)
    speeds = {name: row["speed"] for name, row in flow["shafts"].items()}
    assert speeds[held] in (None, 0.0)
    assert speeds["small_sun"] / speeds["ring"] == pytest.approx(ratio, rel=1e-12)
    assert flow["power_in"] == pytest.approx(100.0 * 2000.0 * math.pi / 30.0, rel=1e-9)
    assert flow["power_out"] == pytest.approx(flow["power_in"], rel=1e-9)


def test_forces_and_angles_of_the_page(model):
    a, b, c = 45.0, 54.0, 36.0
    lead = math.acos((a**2 + b**2 - c**2) / (2.0 * a * b))
    assert model.planetary_stages["long"].places[0] == pytest.approx(lead, rel=1e-12)
    assert math.degrees(lead) == pytest.approx(41.41, abs=5e-3)
    found = solve_equilibrium(compile_model(model, "slow_first"))
    assert abs(float(found["mesh_force[short_2-long_2]"])) == pytest.approx(1313.8, abs=0.05)
    assert float(found["bearing_force[long_1-bearing.radial]"]) == pytest.approx(1762.0, abs=1.0)


def test_all_modes_have_a_kind(model):
    """Alike around the set: three coordinates of each planet and the rotation of suns and ring, as
    the carrier is held. The rest, twice as many coordinates of planets, are planet modes in pairs."""
    names = find_modes(compile_model(model, "first")).names
    kinds = [next((k for k in ("rotational", "planet mode") if k in name), name) for name in names]
    assert kinds[0] == "rigid rotation"
    assert (kinds.count("rotational"), kinds.count("planet mode")) == (2 * 3 + 3 - 1, 2 * 2 * 3)
