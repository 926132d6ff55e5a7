# SPDX-License-Identifier: Apache-2.0
"""Response to loaded transmission errors by mesh order: against time responses, and at its limits."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError, SolverError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.linear_system import linearise
from pitchpoint.solvers.mesh_excitation import mesh_excitation
from pitchpoint.solvers.mesh_response import find_mesh_response, solve_mesh_response
from pitchpoint.solvers.quasistatic.roll import roll_through, solve_quasistatic
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
  steady: {speed: {driver: SPEED rpm}, duration: LAST s, settle_time: 0.35 s, sample_rate: RATE Hz}
"""
OUTPUTS = ["bearing_force[left.fy]", "bearing_force[mount.fy]", "acceleration[housing.uy]"]


def by_time(speed: int, harmonics: int, box: str = BOX, outputs: list[str] = OUTPUTS[:2]):
    """Peak amplitudes of the mesh orders of bearing forces in a settled run, shape (harmonics, outputs).

    The slowest vibration, of the housing on its mount at 140 Hz with 4 % damping, decays to 1e-6 in 0.35 s.
    """
    mesh = Fraction(30 * speed, 60)
    periods = round(0.1 * float(mesh))
    rate, length = 64 * mesh, periods / mesh
    text = box.replace("SPEED", str(speed)).replace("RATE", str(float(rate)))
    model = loads_model(text.replace("LAST", str(0.35 + float(length))))
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


@pytest.mark.parametrize("speed", [500, pytest.param(800, marks=pytest.mark.study)])
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
    ("speed", "harmonics", "within"),
    [
        pytest.param(500, 3, 0.6, marks=pytest.mark.study),
        (800, 3, 0.6),
        pytest.param(1300, 3, 1.0, marks=pytest.mark.study),
        (3000, 1, 0.3),
    ],
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


PLAIN = """\
gears:
  p: {number_of_teeth: Z1, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0FIRST}
  w: {number_of_teeth: Z2, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0SECOND}
bodies: {pin: {gears: [p], inertia: 0.001 kg m^2}, whl: {gears: [w], inertia: 0.03 kg m^2}}
meshes:
  st: {gears: [p, w], stiffness: {law: constant, value: 3e8 N/m},
       transmission_error: {cosine: [1 um], sine: [0, 0.4 um]ORDERS}}
loads: {a: {body: pin, torque: 200 N m}, b: {body: whl, torque: balance}}
scenarios:
  s: {speed: {pin: 4000 rpm}, duration: 0.1 s}
  rest: {duration: 0.1 s}
  roll: {quasi_static: {mesh: st, points: 16, periods: 2}}
"""


def plain(first: str = "", second: str = "", orders: str = "", teeth: tuple[int, int] = (23, 71)):
    """A pair with an error of known mesh orders, and errors over the turns of its gears."""
    text = PLAIN.replace("FIRST", first).replace("SECOND", second).replace("ORDERS", orders)
    return compiled(text.replace("Z1", str(teeth[0])).replace("Z2", str(teeth[1])), "s")[1]


ECCENTRIC = ", faults: {e: {type: eccentricity, amount: 15 um, phase: 20 deg}}"


@pytest.mark.parametrize(
    ("first", "second", "orders", "teeth"),
    [
        (ECCENTRIC, "", "", (17, 40)),
        ("", ECCENTRIC, "", (17, 19)),
        ("", "", ", shaft1: {1: [5 um, 30 deg]}", (17, 40)),
        ("", "", ", shaft1: {1: [5 um, 30 deg]}, shaft2: {2: [3 um, 0 deg]}", (18, 24)),
        (ECCENTRIC, ECCENTRIC, "", (17, 19)),
    ],
)
def test_errors_over_a_turn_are_no_mesh_orders(first: str, second: str, orders: str, teeth: tuple[int, int]):
    """With constant stiffness the mean over all tooth pairs is the error of the mesh, 1 and 0.4 um.

    Within one period the errors over a turn rise by 6 um, whose ramp has orders of 1 um and more. They shift
    the phase of the mesh by 2 pi e/p_bt: at the start of the roll, 0.03 rad for 30 um,
    and 0.03^2 of 1 um in the mean.
    """
    errors = [
        mesh_excitation(system, "s", linearise(system, "s"), "st", 2, 16).error
        for system in (plain(first, second, orders, teeth), plain(teeth=teeth))
    ]
    assert np.abs(errors[1]) == pytest.approx([1e-6, 0.4e-6], rel=1e-3)
    assert np.abs(errors[0]) == pytest.approx(np.abs(errors[1]), abs=2e-9)
    assert np.abs(np.angle(errors[0] / errors[1])).max() < 2.0 * 0.03


def test_mean_over_the_tooth_pairs_is_that_of_the_hunting_period():
    """Run-out of both gears with teeth whose pairs come and go: 36 instead of 72 periods of a pair 18/24."""
    model, _ = compiled(
        PLAIN.replace("law: constant, value: 3e8 N/m", "law: din3990, tip_relief_factor: 0.5")
        .replace("FIRST", ", deviations: {runout: {amount: 8 um}}")
        .replace("SECOND", ", deviations: {runout: {amount: 6 um, phase: 50 deg}}")
        .replace("ORDERS", "")
        .replace("Z1", "18")
        .replace("Z2", "24")
    )
    system = compile_model(model, "s")
    found = mesh_excitation(system, "s", linearise(system, "s"), "st", 3, 16).error
    roll = roll_through(system, "s", 16, 72, mesh="st", others=False)
    curve = roll.rows[:-1, system.layout.channel("transmission_error[st]")].reshape(-1, 16)
    mean, one = (2.0 * np.fft.rfft(x)[1:4] / 16 for x in (curve.mean(axis=0), curve[0]))
    assert found == pytest.approx(mean, abs=3e-8)
    assert np.abs(one - mean).max() > 1e-7


def test_the_roll_has_the_direction_of_the_speed():
    """At rest a positive speed of either gear: both have opposite directions, and errors in reverse."""
    system = plain()
    one, two = (
        find_mesh_response(system, ["mesh_force[st]"], body, [100.0], "rest", harmonics=2).error
        for body in ("pin", "whl")
    )
    assert two == pytest.approx(one.conj(), rel=1e-6)


def test_a_short_roll_notes_the_period_of_the_errors():
    notes = solve_quasistatic(plain(ECCENTRIC), "roll").attrs["notes"]
    assert "the errors of the teeth of st repeat after 23 periods" in notes
    assert "repeat" not in solve_quasistatic(plain(), "roll").attrs["notes"]


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


def test_a_pair_without_load_is_no_excitation():
    """A loose gear that runs idle: its mesh has no order."""
    text = (
        "gears:\n"
        "  a: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}\n"
        "  b: {number_of_teeth: 40, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}\n"
        "  c: {number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}\n"
        "bodies:\n  one: {gears: [a], position: [0, 0, 0]}\n  two: {gears: [b]}\n  idler: {gears: [c]}\n"
        "meshes:\n  loaded: {gears: [a, b], damping: {ratio: 0.05}}\n"
        "  idle: {gears: [b, c], damping: {ratio: 0.05}, backlash: {circumferential: 0.1 mm}}\n"
        "loads:\n  in: {body: one, torque: 50 N m}\n  out: {body: two, torque: balance}\n"
        "scenarios: {run: {speed: {one: 1000 rpm}, duration: 1 ms}}\n"
    )
    found = find_mesh_response(
        compile_model(loads_model(text), "run"), ["mesh_force[loaded]"], "one", [100.0], "run"
    )
    assert set(found.meshes) == {"loaded"}
    assert "idle: without load, not an excitation" in found.notes
