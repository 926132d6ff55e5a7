# SPDX-License-Identifier: Apache-2.0
"""The example `planetary-set`: numbers of its page, and the closed form of its fixed sun.

Closed form: planets as springs in parallel, see `tests/validation/test_planet_load_sharing.py`, with the mean
stiffness of the meshes over their cycle. The stiffness of both meshes varies by a fifth and in phase, and the
mean of a quotient is not the quotient of the means: 5 % of the difference between the planets.
"""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

import pitchpoint
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

FOLDER = Path(__file__).parents[2] / "examples" / "planetary-set"
ROWS = {"1e6 N/m": "10⁶ N/m, floating", "1e10 N/m": "10¹⁰ N/m, fixed"}


@pytest.fixture(scope="module")
def model():
    return load_model(FOLDER / "model.yaml")


def rolled(model, spline, torque):
    """Loads of the planets in a slow roll, and its result."""
    changed = model.replace_all(
        {"bearings.spline.stiffness.radial": spline, "loads.motor.torque": f"{torque} N m"}
    )
    found = solve_quasistatic(compile_model(changed, "slow"))
    return pitchpoint.planet_loads(changed, found)["set"], found


@pytest.mark.parametrize(("column", "torque"), [(0, 300), (1, 600), (2, 1200)])
@pytest.mark.parametrize("spline", ROWS)
def test_the_factors_of_the_page(model, spline, column, torque):
    text = (FOLDER / "README.md").read_text("utf-8")
    line = next(line for line in text.splitlines() if ROWS[spline] in line)
    printed = [float(x) for x in re.findall(r"\d\.\d{3}", line)][column]
    assert rolled(model, spline, torque)[0].factor == pytest.approx(printed, abs=5e-4)


def test_the_fixed_sun_against_springs_in_parallel(model):
    loads, found = rolled(model, "1e10 N/m", 1200)
    k = [float(found[f"tangent_stiffness[{mesh}]"][:-1].mean()) for mesh in ("sun-planet_1", "planet_1-ring")]
    alpha = math.radians(20.0)
    k_pin = 1.0 / (1.0 / 8e8 + 1.0 / 1.5e9)
    each = 1.0 / (sum(1.0 / x for x in k) + 4.0 * math.cos(alpha) ** 2 / k_pin)
    shift = each * 2.0 * math.cos(alpha) * 30e-6
    mean = 1200.0 / (3.0 * 0.5 * 63e-3 * math.cos(alpha))
    assert loads.force[0] == pytest.approx(mean - 2.0 / 3.0 * shift, abs=0.05 * shift)
    assert loads.force[1:] == pytest.approx([mean + shift / 3.0] * 2, abs=0.05 * shift)


def test_planets_fit_in_phase(model):
    from pitchpoint.report.planets import stages_of_model

    straight = model.replace("planetary_stages.set.pin_errors.planet_1.tangential", 0.0)
    planets = stages_of_model(straight)["set"]["planets"].values()
    assert [row["phases"]["sun"] for row in planets] == pytest.approx([0.0] * 3, abs=1e-9)


@pytest.mark.parametrize("error", [0.0, 30e-6, 200e-6])
def test_phases_are_those_of_the_angles_of_the_pins(model, error):
    """z_s psi/2 pi and -z_r psi/2 pi, in `check` and `frequencies`; small errors change no type of motion."""
    from pitchpoint.report.frequencies import frequencies_of, turning_speeds
    from pitchpoint.report.planets import stages_of_model

    moved = model.replace("planetary_stages.set.pin_errors.planet_1.tangential", error)
    stage = stages_of_model(moved)["set"]
    sets = frequencies_of(moved, turning_speeds(moved, moved.scenarios["steady"].speed))["planet_sets"]
    (central,) = (entry["central"] for entry in sets.values())
    psi = 2.0 * math.pi * np.arange(3) / 3 - error / stage["center_distance"] * (np.arange(3) > 0)
    for side, gear, z in (("sun", "sun", 21), ("ring", "ring", -99)):
        turned = z * psi / (2.0 * math.pi)
        listed = [row["phases"][side] for row in stage["planets"].values()]
        assert listed == list(central[gear]["phases"].values())
        miss = np.array(listed) - turned
        assert miss - np.round(miss) == pytest.approx(np.zeros(3), abs=1e-5)
        assert central[gear]["excites"] == ["rotational"] * 3


def test_planets_on_needle_bearings_as_on_the_page():
    """Twice the tangential force 600 N m/3 at the working circle of 31.5 mm; radial forces cancel."""
    page = (FOLDER.parents[1] / "docs" / "planetary_stages.md").read_text("utf-8")
    bearings, pair = re.findall(r"```yaml\n(rolling_bearings:\n.*?)```", page, re.DOTALL)
    text = (FOLDER / "model.yaml").read_text("utf-8")
    text = re.sub(r"    (bearing: .*|pin_errors:|  planet_1: .*)\n", "", text)
    found = solve_equilibrium(compile_model(loads_model(text + bearings)))
    loads = [found[f"bearing_force[pin_{k}.radial]"].item() for k in (1, 2, 3)]
    assert loads == pytest.approx([2.0 * 200.0 / 31.5e-3] * 3, rel=1e-4)
    assert f"carries {loads[0] * 1e-3:.1f} kN at 600 N m" in page
    rows = re.sub(r"  pin_1:.*\n", pair.partition("\n")[2], bearings)
    found = solve_equilibrium(compile_model(loads_model(text + rows)))
    halves = [found[f"bearing_force[pin_1{side}.radial]"].item() for side in "ab"]
    assert halves[0] == pytest.approx(halves[1], rel=1e-9) and halves[0] < loads[0]


def test_the_elastic_carrier_winds_up():
    """Numbers of the page at 600 N m."""
    model = load_model(FOLDER / "elastic_carrier.yaml")
    begin = prepare_start(compile_model(model, "slow"), model.scenarios["slow"])
    evaluate.residual(begin.system, begin.state)
    frames = dict(zip(begin.system.layout.bodies, begin.system.workspace.fr, strict=True))
    text = (FOLDER / "README.md").read_text("utf-8")
    printed = {
        row.split("|")[1].strip(): float(row.split("|")[3])
        for row in text.splitlines()
        if row.endswith("µrad |")
    }
    turn = float(frames["output"]["phi"] - frames["journal"]["phi"])
    assert 1e6 * abs(turn) == pytest.approx(printed["wind-up between the walls"], abs=0.6)
    tilts = [float(np.hypot(*frames[f"planet_{k}"]["R"][:2, 2])) for k in (1, 2, 3)]
    assert 1e6 * np.mean(tilts) == pytest.approx(printed["tilt of the planet axes"], abs=1.0)
    found = solve_equilibrium(compile_model(model))
    assert pitchpoint.planet_loads(model, found)["set"].factor == pytest.approx(1.001, abs=1e-3)
