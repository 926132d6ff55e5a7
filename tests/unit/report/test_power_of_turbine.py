# SPDX-License-Identifier: Apache-2.0
"""Power flow of a wind turbine: from the air to the generator, with elastic blades and tower."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import simpson
from scipy.spatial.transform import Rotation

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.report.damping_losses import damping_loss
from pitchpoint.report.external_torques import external_torques
from pitchpoint.report.power_flow import power_flow
from pitchpoint.report.stored_energy import Deflections
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from pitchpoint.viz.power_flow import OUTSIDE
from tests.support.rotors import FOLDER

FREE = """\
bodies:
  box: {mass: 2 kg, inertia_tensor: [1, 1, 1, 0, 0, 0], motion: free}
  other: {mass: 1 kg, inertia_tensor: [1, 1, 1, 0, 0, 0], position: [1, 0, 0]}
joints:
  loose: {type: free, bodies: [ground, other]}
bushings:
  mount:
    ends: [other, ground]
    stiffness: {radial: 3e3 N/m, axial: 5e3 N/m, tilt: 70 N m/rad, torsion: 90 N m/rad}
    damping: {radial: 4 N s/m, axial: 4 N s/m, tilt: 0.5 N m s/rad, torsion: 0.8 N m s/rad}
scenarios:
  s: {duration: 1 s, step: 1 ms}
"""


@pytest.fixture(scope="module")
def turbine():
    """Rotor of the NREL 5 MW turbine that speeds up in the wind, blades and tower with few beam elements."""
    model = load_model(FOLDER.parent / "model.yaml").replace_all(
        {
            **{f"beams.blade_{k}.pieces": 4 for k in (1, 2, 3)},
            "beams.tower.pieces": 3,
            "winds.steady.speed": 8.5,
            "scenarios.production.duration": 4.0,
            "scenarios.production.step": 0.005,
            "scenarios.production.sample_rate": 200.0,
            "scenarios.production.settle_time": 0.0,
        }
    )
    result = solve_time(compile_model(model, "production"))
    flow = power_flow(model, result)
    assert flow is not None
    return flow, result


def test_power_goes_from_the_wind_to_the_generator(turbine):
    """Each end as an integral of the channels."""
    flow, result = turbine
    time = result["time"].values
    mean = lambda values: float(simpson(values, x=time)) / (time[-1] - time[0])  # noqa: E731
    ends = {link.name: link for link in flow.links if OUTSIDE in (link.start, link.end)}
    assert ends["rotor"].kind == "wind"
    assert flow.blocks[ends["rotor"].end].name == "hub"
    assert ends["rotor"].given == pytest.approx(mean(result["aerodynamic_power[rotor]"].values), rel=1e-5)
    out = ends["generator_torque"]
    assert (flow.blocks[out.start].name, out.end) == ("generator", OUTSIDE)
    work = -mean(result["signal[generator_torque]"].values * result["speed[generator]"].values)
    assert out.taken == pytest.approx(work, rel=1e-5)


def test_the_balance_of_the_turbine_closes(turbine):
    """12 % of the power accelerate rotor and generator. The rest is the motion of nacelle and hub with the
    tower, their weight, and the step: it halves with the step."""
    flow, result = turbine
    speed, deflection = result["speed[hub]"].values, flow.elastic
    known = 3.87e7 + 5.0e6  # rotor and generator about the axis, NREL/TP-500-38060
    motion = 0.5 * known * (speed[-1] ** 2 - speed[0] ** 2) / float(result["time"][-1])
    assert motion > 0.1 * flow.put_in
    assert flow.stored - deflection == pytest.approx(motion, rel=0.1), "blades are deflected and vibrate, too"
    assert 0.0 < flow.damped < 1e-3 * flow.put_in
    assert abs(flow.remainder) < 1e-3 * flow.put_in
    assert flow.unfollowed == ["gravity"]


def test_torques_without_a_run_are_unknown_in_the_wind():
    """The torque of the air is not zero: it depends on the motion of the blades."""
    model = load_model(FOLDER.parent / "model.yaml")
    found, _, _ = external_torques(model, model.scenarios["production"], {})
    wind = next(each for each in found if each.name == ("wind_rotors", "rotor"))
    assert (wind.body, wind.torque) == ("hub", None)


def swing(amplitude: float, turn: float, rate: float):
    """Channels of a free body that swings along z and about x."""
    time = np.linspace(0.0, 2.0 * np.pi / rate, 401)
    tilt = np.zeros((time.size, 3))
    tilt[:, 0] = turn * np.sin(rate * time)
    quaternion = Rotation.from_rotvec(tilt).as_quat()
    known = {f"attitude[other.{c}]": quaternion[:, k] for k, c in enumerate("xyzw")}
    known["displacement[other.z]"] = amplitude * np.sin(rate * time)
    return time, known


def test_energy_and_loss_of_the_springs_of_a_free_body():
    """k a²/2 in each direction and c a² w²/2 on average, for a rotation by 0.4 rad."""
    system = compile_model(loads_model(FREE), "s")
    a, turn, rate = 0.02, 0.4, 7.0
    time, known = swing(a, turn, rate)
    at = lambda rows: lambda name: known.get(name, np.zeros(time.size))[rows]  # noqa: E731
    deflected = Deflections(system, at([0, 100]))
    assert deflected.known
    found = deflected.change({"bushing": slice(None)})
    assert found == pytest.approx(0.5 * 5e3 * a**2 + 0.5 * 70.0 * turn**2, rel=1e-9)
    lost = damping_loss(system, at(slice(None)), time, {"bushing": np.array([0])})
    assert lost == pytest.approx(0.5 * rate**2 * (4.0 * a**2 + 0.5 * turn**2), rel=2e-4)


@pytest.mark.parametrize("turn", [0.4, 1.2])
def test_springs_of_bodies_that_tumble_are_unknown(turn):
    system = compile_model(loads_model(FREE), "s")
    _, known = swing(0.0, turn, 1.0)
    deflected = Deflections(system, lambda name: known.get(name, np.zeros(401))[[0, 100]])
    assert deflected.known is (turn < 1.0)
