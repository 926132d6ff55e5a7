# SPDX-License-Identifier: Apache-2.0
"""The example `timing-train`: torques, mesh frequency, contact with and without scissor gears."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.formula.formula import Formula
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.support.scripts import script

FOLDER = Path(__file__).parents[2] / "examples" / "timing-train"


@pytest.fixture(scope="module")
def engine():
    """The script of the example."""
    return script(FOLDER / "torques.py")


def test_tables_are_those_of_the_script(engine):
    model = load_model(FOLDER / "idle.yaml")
    for load, name in (
        ("gas", "gas_idle.csv"),
        ("exhaust_springs", "exhaust.csv"),
        ("inlet_springs", "inlet.csv"),
    ):
        law, (angle, torque) = model.loads[load].torque, engine.TABLES[name]
        assert np.degrees(law.abscissa) == pytest.approx(angle)
        assert law.values == pytest.approx(torque, abs=6e-4)  # printed with three decimals


def test_mean_torques_are_the_work_of_a_cycle(engine):
    """Gas: the work of all cylinders over 4 pi, by the area of the indicator diagram; springs: zero."""
    theta = np.radians(np.arange(360.0, 1081.0, 0.1))
    volume = math.pi / 4.0 * engine.BORE**2 * engine.slider(theta)[0]
    work = sum(
        np.trapezoid(engine.pressure(theta, 1e5, 230.0 * h), volume) for h in engine.CYLINDERS.values()
    )
    angle, torque = engine.TABLES["gas_idle.csv"]
    # trapezoids of 1 deg
    assert np.trapezoid(torque, np.radians(angle)) == pytest.approx(work, rel=2e-3)
    for name in ("inlet.csv", "exhaust.csv"):
        angle, torque = engine.TABLES[name]
        assert np.trapezoid(torque, angle) / 90.0 == pytest.approx(0.0, abs=1e-9)


def test_spring_torque_is_the_slope_of_the_work(engine):
    """W = F_0 h + c h^2/2 of the exhaust valve of cylinder 1, alone between its largest lift and 30 deg."""
    angle, torque = engine.TABLES["exhaust.csv"]
    middle = 90.0 - (engine.EXHAUST / 2.0) % 90.0  # the camshaft turns clockwise
    at = np.radians(np.linspace(-20.0, 20.0, 4001))
    h = engine.LIFT * (1.0 - (at / engine.HALF) ** 2) ** 3
    slope = -np.gradient(engine.PRELOAD * h + 0.5 * engine.RATE * h**2, at)[1:-1]
    found = np.interp((np.degrees(at) + middle) % 90.0, angle, torque)[1:-1]
    assert found == pytest.approx(slope, abs=0.01)


def test_inertia_torques_are_the_orders_of_the_script(engine):
    """Formulas of the model against -1/2 dJ/dphi omega^2 of all masses; the rest are higher orders."""
    model = load_model(FOLDER / "rated.yaml")
    theta = np.linspace(0.0, math.tau, 3601)
    # cranks of cylinders 1 and 4, and of 2 and 3
    pistons = 2.0 * engine.PISTON * sum(engine.slider(theta + turn)[1] ** 2 for turn in (0.0, math.pi))
    wanted = -0.5 * np.gradient(pistons, theta)[1:-1]
    law = model.loads["pistons"].torque
    found = Formula.parse(law.text, law.variables)(np.zeros(3599), theta[1:-1], np.ones(3599))
    assert np.abs(found - wanted).max() < 0.065 * np.abs(wanted).max()
    for load, middle in (("inlet_valves", 35.0), ("exhaust_valves", 55.0)):
        law = model.loads[load].torque
        at = np.radians(middle + np.linspace(-90.0, 90.0, 1441))
        lobes = [engine.lift(at - math.radians(middle + 90.0 * k)) for k in range(-3, 4)]
        wanted = -engine.MASS * sum(slope * bend for _, slope, bend in lobes)
        found = Formula.parse(law.text, law.variables)(np.zeros(at.size), at, np.ones(at.size))
        assert np.abs(found - wanted).max() < 0.05 * np.abs(wanted).max()


def test_meshes_of_the_crank_gear_are_above_five_kilohertz():
    model = load_model(FOLDER / "rated.yaml")
    assert model.gears["crank"].number_of_teeth * model.scenarios["rated"].speed[
        "crankshaft"
    ] / math.tau == pytest.approx(5175.0)


def test_scissor_gears_keep_the_meshes_of_the_camshafts_in_contact():
    """80 ms at idle. The motion is not periodic: the share of contact loss differs by some per cent.

    The load of the camshafts alternates without scissor gears and hardly reverses with them; the oil pump is
    an idle gear with a steady drag torque, which has a rattle index in both cases.
    """
    shares, reversals = [], []
    for name in ("idle.yaml", "idle-scissor.yaml"):
        model = load_model(FOLDER / name).replace_all(
            {
                "scenarios.idle.duration": 0.08,
                "scenarios.idle.settle_time": 0.02,
                "scenarios.idle.sample_rate": 2e4,
            }
        )
        run = solve_time(compile_model(model, "idle"))
        shares.append(
            [run[f"contact_state[small_{cam}]"].attrs["contact_loss_share"] for cam in ("exhaust", "inlet")]
        )
        meshes = ("small_exhaust", "small_inlet", "crank_oil")
        states = [run[f"contact_state[{mesh}]"].attrs for mesh in meshes]
        reversals.append([state["load_reversal"] for state in states])
        assert [math.isnan(state["rattle_index"]) for state in states] == [name == "idle.yaml"] * 2 + [False]
    assert min(reversals[0][:2]) > 0.5
    assert max(reversals[0][2], *reversals[1]) < 0.02
    assert min(shares[0]) > 0.2
    assert max(shares[1]) < 0.1
