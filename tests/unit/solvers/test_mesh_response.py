# SPDX-License-Identifier: Apache-2.0
"""Response to loaded transmission errors by mesh order: against time responses, and at its limits."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError, SolverError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.mesh_response import find_mesh_response, solve_mesh_response
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.support.machines import STAGES, compiled

RPM = math.pi / 30.0
BOX = """\
gears:
  g1: {number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 45, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  housing: {motion: free, position: [0.05, 0, 0], mass: 20 kg, inertia: 0.2, transverse_inertia: 0.2}
  driver: {gears: [g1], position: [0, 0, 0], motion: planar, mass: 2 kg, inertia: 0.002 kg m^2}
  driven: {gears: [g2], motion: planar, mass: 4 kg, inertia: 0.01 kg m^2}
bearings:
  left: {body: driver, housing: housing, stiffness: {radial: 2e8}, damping: {radial: 2000}}
  right: {body: driven, housing: housing, stiffness: {radial: 2e8}, damping: {radial: 2000}}
  mount: {body: housing, stiffness: {radial: 2e7, axial: 2e7, tilt: 2e5, torsion: 2e5},
          damping: {radial: 2000, axial: 2000, tilt: 20, torsion: 20}}
meshes:
  stage: {gears: [g1, g2], stiffness: {law: din3990, tip_relief_factor: 0.5}, damping: {ratio: 0.05}}
loads:
  input: {body: driver, torque: 200 N m}
  output: {body: driven, torque: balance}
scenarios:
  steady: {speed: {driver: SPEED rpm}, duration: LAST s, settle_time: 0.8 s, sample_rate: RATE Hz}
"""
OUTPUTS = ["bearing_force[left.fy]", "bearing_force[mount.fy]", "acceleration[housing.uy]"]


def by_time(speed: int, harmonics: int, box: str = BOX, outputs: list[str] = OUTPUTS[:2]):
    """Peak amplitudes of the mesh orders of bearing forces in a settled run, shape (harmonics, outputs)."""
    mesh = Fraction(30 * speed, 60)
    periods = round(0.3 * float(mesh))
    rate, length = 64 * mesh, periods / mesh
    text = box.replace("SPEED", str(speed)).replace("RATE", str(float(rate)))
    model = loads_model(text.replace("LAST", str(0.8 + float(length))))
    found = solve_time(compile_model(model, "steady"))
    angle = 2.0 * np.pi * np.arange(64 * periods) / 64
    rows = np.array([found[name].values[-angle.size :] for name in outputs])
    assert found["contact_state[stage]"].attrs["contact_loss_share"] == 0.0
    return np.array(
        [np.abs(2.0 * np.mean(rows * np.exp(-1j * h * angle), axis=1)) for h in range(1, harmonics + 1)]
    )


@pytest.fixture(scope="module")
def box():
    """The machine, compiled."""
    text = BOX.replace("SPEED", "1000").replace("LAST", "1").replace("RATE", "10000")
    return compile_model(loads_model(text), "steady")


@pytest.mark.parametrize("speed", [500, 800])
def test_mesh_dampers_do_not_feel_the_deflection_of_the_teeth(speed: int):
    """The damper acts on the travel less the error of the flanks, d (u' - e'), across the radial direction.

    With the loaded error as that of the damper, the force of the first order along the line of centres
    is 6 dB too low at 500 rpm.
    """
    text = BOX.replace("damping: {ratio: 0.05}}", "damper: {ratio: 0.06}}")
    outputs = ["bearing_force[left.fx]", "bearing_force[left.fy]"]
    model = text.replace("SPEED", str(speed)).replace("LAST", "1").replace("RATE", "10000")
    system = compile_model(loads_model(model), "steady")
    chain = find_mesh_response(system, outputs, "driver", [speed * RPM], "steady", harmonics=1)
    run = by_time(speed, 1, text, outputs)
    assert np.abs(chain.response[0]) == pytest.approx(run, rel=0.03)


@pytest.mark.parametrize(
    ("speed", "harmonics", "within"), [(500, 3, 0.6), (800, 3, 0.6), (1300, 3, 1.0), (3000, 1, 0.3)]
)
def test_against_time_responses(box, speed: int, harmonics: int, within: float):
    """Bearing forces by mesh order, off and near the resonances.

    The first order is exact to 0.1 dB up to three times the speed of the lowest gear mode. At 3000 rpm the
    dynamic force at the first order is 10 % of the mean, and with the varying stiffness it excites the higher
    orders as much as their own transmission error: they are not compared.
    """
    chain = find_mesh_response(box, OUTPUTS, "driver", [speed * RPM], "steady", harmonics=harmonics)
    run = by_time(speed, harmonics)
    decibels = 20.0 * np.log10(np.abs(chain.response[0, :, :2]) / run)
    assert np.abs(decibels).max() < within, decibels
    assert np.abs(decibels[0]).max() < 0.3, decibels


def test_motion_of_the_housing(box):
    """Acceleration is -omega^2 times the displacement, in the unit m/s^2."""
    names = ["housing.uy", "velocity[housing.uy]", "acceleration[housing.uy]"]
    found = find_mesh_response(box, names, "driver", [700 * RPM], "steady", harmonics=2)
    omega = 2.0 * np.pi * found.frequency[0]
    assert omega == pytest.approx([700 * RPM * 30, 700 * RPM * 60], rel=1e-12)
    assert found.response[0, :, 1] == pytest.approx(1j * omega * found.response[0, :, 0], rel=1e-12)
    assert found.response[0, :, 2] == pytest.approx(-(omega**2) * found.response[0, :, 0], rel=1e-12)
    assert found.units == ("m", "m/s", "m/s^2")


def test_slow_gears_follow_the_loaded_error(box):
    """At vanishing speed the response of the travel is the transmission error of the slow roll."""
    found = find_mesh_response(
        box, ["transmission_error[stage]"], "driver", [0.2 * RPM], "steady", harmonics=3
    )
    assert found.response[0, :, 0] == pytest.approx(found.error, rel=1e-4)
    roll = roll_through(box, "stage", points=64)
    curve = roll.rows[:-1, box.layout.channel("transmission_error[stage]")]
    series = found.error @ np.exp(2j * np.pi * np.outer([1, 2, 3], np.arange(64) / 64))
    left = curve - curve.mean() - series.real
    assert np.abs(left).max() < 0.2 * np.ptp(curve)  # the harmonics above the third


def test_orders_of_two_stages():
    """Orders of the input: 21 teeth, and the second pinion with 19 teeth at the ratio 21/57."""
    _, system = compiled(STAGES)
    found = solve_mesh_response(system, ["mesh_force[second]"], "input", [20.0, 40.0], harmonics=2)
    assert found["order"].values == pytest.approx([21, 42, 7, 14], rel=1e-12)
    assert found["mesh"].values.tolist() == ["first", "first", "second", "second"]
    assert np.isfinite(found["amplitude"].values).all()


@pytest.mark.parametrize(
    ("outputs", "body", "speeds", "harmonics", "message"),
    [
        (["mesh_force[stage]"], "drivr", [1.0], 1, "no body is called 'drivr'"),
        (["mesh_force[stage]"], "driver", [0.0], 1, "a speed is zero"),
        (["mesh_force[stage]"], "driver", [1.0], 40, "limit 1 to 16"),
        (["mesh_force[stge]"], "driver", [1.0], 1, "no output is called 'mesh_force"),
    ],
)
def test_refused(box, outputs, body, speeds, harmonics, message):
    with pytest.raises((ModelError, SolverError), match=message.replace("[", r"\[")):
        find_mesh_response(box, outputs, body, speeds, "steady", harmonics=harmonics)
