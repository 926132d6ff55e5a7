# SPDX-License-Identifier: Apache-2.0
"""Controlled machines from files: where they begin, what they do, their poles, what other analyses say."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.geometry.materials import LIBRARY
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.solvers.frequency_response import find_response
from pitchpoint.solvers.initial_state.start import Start, prepare_start
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.solvers.reduction.reduce import reduce_system
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.sweep.speed import run_sweep
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.mechanism_files import SLIDER_CRANK

PAIR = """\
gears:
  pinion: {number_of_teeth: 20, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  wheel: {number_of_teeth: 40, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
bodies:
  motor: {gears: [pinion], motion: torsion, inertia: 0.02 kg m^2}
  drum: {gears: [wheel], motion: torsion, inertia: 0.4 kg m^2}
meshes:
  stage: {gears: [pinion, wheel], stiffness: {law: constant, value: 4e8 N/m}, damper: {ratio: 0.05}}
sensors:
  speed: {type: joint, coordinate: motor, derivative: 1}
loads:
  load: {body: drum, torque: 40 N m}
scenarios:
  run: {speed: {motor: 100 rad/s}, duration: 50 ms, step: 0.1 ms, settle_time: 0 s}
  slow: {speed: {motor: 90 rad/s}, duration: 50 ms, step: 0.1 ms, settle_time: 0 s}
  assembled: {start: assembled, speed: {motor: 100 rad/s}, duration: 5 ms, step: 0.1 ms, settle_time: 0 s}
  up: {sweep: {body: motor, speed: [50 rad/s, 100 rad/s], points: 3}}
  roll: {quasi_static: {mesh: stage, points: 5}}
"""
ERROR = "blocks:\n  error: {type: sum, inputs: {speed: -1}, offset: 100 rad/s}\n"
PI = "  u: {type: pid, input: error, proportional: 2, integral: 10%s}\n"
DRIVE = "actuators:\n  drive: {type: torque, signal: u, bodies: [motor]}\n"

ROTOR = """\
bodies: {rotor: {motion: torsion, inertia: 0.5 kg m^2}}
sensors: {speed: {type: joint, coordinate: rotor, derivative: 1}}
blocks:
  error: {type: sum, inputs: {speed: -1}, offset: 3 rad/s}
"""
RUN = """\
scenarios:
  run: {{duration: {duration}, method: {method}, {keys}, settle_time: 0 s, sample_rate: 50 Hz}}
"""
J, KP, KI = 0.5, 4.0, 25.0


def begun(text, scenario="run"):
    """Start of a scenario, and the signals there by name."""
    system = compile_model(loads_model(text), scenario)
    start = prepare_start(system, system.scenario)
    row = evaluate.observe(start.system, start.state)
    seen = dict(zip((c.name for c in system.layout.channels), row, strict=True))
    return start, lambda name: seen[f"signal[{name}]"]


def go(system, scenario=None, **more):
    memory = Memory()
    done = run_time(system, scenario, sink=memory, **more)
    rows = np.concatenate(memory.rows)
    return done, np.concatenate(memory.times), lambda name: rows[:, system.layout.channel(name)]


def test_an_integral_begins_where_the_loads_balance():
    text = PAIR + ERROR + PI % "" + DRIVE
    start, signal = begun(text)
    assert signal("u") == pytest.approx(20.0, rel=1e-9)  # half the load, by the ratio of the teeth
    assert start.notes == ()
    done, _, channel = go(compile_model(loads_model(text), "run"))
    assert done.status == 1
    np.testing.assert_allclose(channel("speed[motor]"), 100.0, rtol=1e-9)


def test_integrals_share_a_load_and_a_balancing_torque_takes_it_alone():
    two = PAIR + ERROR + PI % "" + "  v: {type: integrator, input: error}\n"
    two += "  all: {type: sum, inputs: {u: 1, v: 1}}\n" + DRIVE.replace("signal: u", "signal: all")
    start, signal = begun(two)
    assert signal("all") == pytest.approx(20.0, rel=1e-9)
    assert start.notes == ()
    balanced = (PAIR + ERROR + PI % "" + DRIVE).replace("torque: 40 N m", "torque: balance")
    assert begun(balanced)[1]("u") == pytest.approx(0.0, abs=1e-9)


def test_an_integral_of_an_error_begins_at_its_start_value():
    start, signal = begun(PAIR + ERROR + PI % "" + DRIVE, "slow")
    assert signal("u") == pytest.approx(2.0 * 10.0, rel=1e-12)
    assert "signal[u.integral] has no steady state: it starts at 0" in start.notes[0]
    plain = PAIR + ERROR + "  u: {type: integrator, input: error, start: 7 N m}\n" + DRIVE
    start, signal = begun(plain, "slow")
    assert signal("u") == pytest.approx(7.0, rel=1e-12)
    assert "starts at 7" in start.notes[0]
    assert "net torque of -13 N m on motor" in " ".join(start.notes)


def test_limits_leave_what_they_do_not_let_through():
    start, signal = begun(PAIR + ERROR + PI % ", limits: [-5, 5]" + DRIVE)
    assert signal("u") <= 5.0
    assert "the loads do not balance" in start.notes[0]
    # far from the wanted speed the limit holds, and the integral has not wound up
    start, signal = begun(PAIR + ERROR + PI % ", limits: [-5, 5]" + DRIVE, "slow")
    assert signal("u") == 5.0
    assert signal("u.integral") == 0.0


@pytest.mark.parametrize("scenario", ["run", "assembled"])
def test_filters_begin_at_their_inputs(scenario):
    blocks = """\
blocks:
  f: {type: filter, input: speed, time_constant: 20 ms}
  g: {type: filter, input: f, time_constant: 20 ms, damping_ratio: 0.4}
  h: {type: transfer_function, input: speed, numerator: [1, 2, 3], denominator: [2, 5, 4]}
"""
    _, signal = begun(PAIR + blocks, scenario)
    assert signal("f") == pytest.approx(100.0, rel=1e-12)
    assert signal("g") == pytest.approx(100.0, rel=1e-12)
    assert signal("h") == pytest.approx(75.0, rel=1e-12)


def test_a_transfer_function_that_integrates_begins_at_rest():
    """s^2 + s has no rest under an input: its output starts at zero, and the machine starts all the same."""
    blocks = "blocks:\n  u: {type: transfer_function, input: speed, numerator: [1], denominator: [1, 1, 0]}\n"
    start, signal = begun(PAIR + blocks + DRIVE)
    assert signal("u") == 0.0
    assert start.notes[0] == "signal[u.x0] has no steady state: it starts at 0"


def test_a_servo_holds_a_weight():
    text = """\
gravity: [0, -9.81 m/s^2, 0]
bodies: {arm: {mass: 2 kg, center_of_mass: [0.5, 0, 0], inertia_tensor: [0.01, 0.06, 0.05, 0, 0, 0]}}
joints: {pivot: {type: revolute, bodies: [ground, arm], position: [0, 0, 0]}}
sensors: {angle: {type: joint, coordinate: pivot.spin}}
blocks:
  seen: {type: filter, input: angle, time_constant: 50 ms}
  error: {type: sum, inputs: {seen: -1}, offset: 0.8 rad}
  u: {type: pid, input: error, proportional: 40, integral: 30, derivative: 3, filter_time: 10 ms}
actuators: {motor: {type: torque, signal: u, bodies: [arm]}}
scenarios: {run: {duration: 20 ms, step: 0.1 ms, settle_time: 0 s}}
"""
    start, signal = begun(text)
    assert start.notes == ()
    # an equilibrium ends at 1e-9 of what acts, and rates of states have gains up to 1/(10 ms)
    assert signal("angle") == pytest.approx(0.8, abs=1e-7)
    assert signal("u") == pytest.approx(2.0 * 9.81 * 0.5 * np.cos(0.8), rel=1e-7)


def test_a_servo_in_a_mechanism_with_a_loop():
    """The torque that holds the crank is the slope of the potential energy over its angle."""
    text = "gravity: [0, -9.81 m/s^2, 0]\n" + SLIDER_CRANK
    text += """\
sensors: {angle: {type: joint, coordinate: main.spin}}
blocks:
  error: {type: sum, inputs: {angle: -1}, offset: 0.5 rad}
  u: {type: pid, input: error, proportional: 40, integral: 30}
actuators: {motor: {type: torque, signal: u, bodies: [crank]}}
scenarios: {run: {duration: 20 ms, step: 0.1 ms, settle_time: 0 s}}
"""
    start, signal = begun(text)
    wanted = 9.81 * (0.04 * np.cos(0.5) - 0.005 * np.sin(0.5) + 0.8 * 0.1 * (1.0 - 0.12 / 0.3) * np.cos(0.5))
    assert signal("angle") == pytest.approx(0.5, abs=1e-7)
    assert signal("u") == pytest.approx(wanted, rel=1e-6)
    done, _, channel = go(compile_model(loads_model(text), "run"))
    assert done.status == 1, done.sentence
    np.testing.assert_allclose(channel("signal[angle]"), 0.5, atol=1e-6)


def test_an_elastic_shaft_at_its_speed():
    """The drive takes the load from the start, and the twist of the shaft is T (l_1/I_1 + l_2/I_2)/G."""
    text = """\
shafts:
  input:
    sections: [{length: 60 mm, diameter: 40 mm}, {length: 120 mm, diameter: 50 mm}]
    material: steel
    position: [0, 0, 0]
    markers: {far: {position: [0, 0, 180 mm]}}
bearings:
  left: {body: input, position: [0, 0, 20 mm], stiffness: {radial: 2e8 N/m, axial: 1e8 N/m}}
  right: {body: input, position: [0, 0, 170 mm], stiffness: {radial: 2e8 N/m}}
sensors:
  twist: {type: frames, quantity: angle, ends: [input.far, input]}
  speed: {type: frames, quantity: angular_velocity, ends: [input.far, ground]}
blocks:
  error: {type: sum, inputs: {speed: -1}, offset: 100 rad/s}
  u: {type: pid, input: error, proportional: 2, integral: 20}
actuators: {motor: {type: torque, signal: u, bodies: [input]}}
loads: {load: {body: input, torque: -50 N m, position: [0, 0, 180 mm]}}
scenarios: {run: {speed: {input: 100 rad/s}, duration: 2 ms, step: 5 us, settle_time: 0 s}}
"""
    start, signal = begun(text)
    assert start.notes == ()
    assert signal("u") == pytest.approx(50.0, rel=1e-8)
    steel = LIBRARY["steel"]
    shear = steel.youngs_modulus / (2.0 * (1.0 + steel.poisson_ratio))
    polar = np.pi / 32.0 * np.array([0.04, 0.05]) ** 4
    assert signal("twist") == pytest.approx(-50.0 / shear * np.sum([0.06, 0.12] / polar), rel=1e-6)


def test_a_filter_of_a_sensed_load():
    """The force of the mesh is known after all others, its tangent is not, and rest is found all the same."""
    text = PAIR.replace("loads:\n", "  force: {type: observation, channel: 'mesh_force[stage]'}\nloads:\n")
    text += """\
blocks:
  calm: {type: filter, input: force, time_constant: 2 ms}
  back: {type: sum, inputs: {calm: 1 mm}}
"""
    start, signal = begun(text + DRIVE.replace("signal: u", "signal: back"))
    force = 40.0 / (0.06 * np.cos(np.radians(20.0)))
    assert signal("calm") == pytest.approx(force, rel=1e-8)
    assert signal("back") == pytest.approx(1e-3 * force, rel=1e-8)


def test_poles_and_response_of_a_speed_loop():
    text = ROTOR + f"  u: {{type: pid, input: error, proportional: {KP}, integral: {KI}}}\n"
    text += "actuators: {motor: {type: torque, signal: u, bodies: [rotor]}}\n"
    text += "scenarios: {run: {speed: {rotor: 3 rad/s}, duration: 1 s}}\n"
    system = compile_model(loads_model(text), "run")
    found = find_modes(system, "run")
    wanted = np.roots([J, KP, KI])
    assert found.state_eigenvalue[0] == pytest.approx(wanted[wanted.imag > 0.0][0], rel=1e-9)
    hertz = np.array([0.1, 1.0, 10.0])
    s = 2j * np.pi * hertz
    response = find_response(system, ["rotor.mz"], ["rotor.rz"], hertz, "run").response[:, 0, 0]
    np.testing.assert_allclose(response, 1.0 / (J * s**2 + KP * s + KI), rtol=1e-9)


METHODS = ["generalized_alpha", "rk4", "adams", "runge_kutta", "gstiff", "wstiff", "dassl", "constant_bdf"]


@pytest.mark.parametrize("method", METHODS)
def test_every_method_runs_a_speed_loop(method):
    """J e' + kp e + ki int e = 0 from e = 3 with an empty integral."""
    fine = method in ("generalized_alpha", "rk4", "adams", "constant_bdf")
    keys = "step: 0.5 ms" if fine else "tolerance: 1e-9"
    text = ROTOR + f"  u: {{type: pid, input: error, proportional: {KP}, integral: {KI}}}\n"
    text += "actuators: {motor: {type: torque, signal: u, bodies: [rotor]}}\n"
    text += RUN.format(duration="1 s", method=method, keys=keys)
    done, t, channel = go(compile_model(loads_model(text), "run"))
    assert done.status == 1, done.sentence
    a, b = KP / (2.0 * J), np.sqrt(KI / J - (KP / (2.0 * J)) ** 2)
    wanted = 3.0 * np.exp(-a * t) * (np.cos(b * t) - a / b * np.sin(b * t))
    # second order: (omega h)^2 of 3 rad/s with omega = 7 rad/s; the others ten times their tolerance
    most = {"generalized_alpha": 4e-5, "constant_bdf": 4e-5}.get(method, 1e-6)
    np.testing.assert_allclose(channel("signal[error]"), wanted, atol=most)


SAMPLED = """\
controllers:
  c: {type: pid, input: error, output: u, proportional: 4, integral: 25, period: 20 ms%s}
"""


@pytest.mark.parametrize("method", METHODS)
def test_every_method_calls_a_sampled_controller(method):
    fine = method in ("generalized_alpha", "rk4", "adams", "constant_bdf")
    keys = "step: 0.5 ms" if fine else "tolerance: 1e-9"
    text = ROTOR + SAMPLED % "" + "actuators: {motor: {type: torque, signal: u, bodies: [rotor]}}\n"
    text += RUN.format(duration="0.4 s", method=method, keys=keys)
    done, t, channel = go(compile_model(loads_model(text), "run"))
    assert done.status == 1, done.sentence
    speed, integral, wanted = 0.0, 0.0, [0.0]
    for _ in range(20):  # a constant torque over a period changes the speed by T u/J
        integral += 25.0 * 0.02 * (3.0 - speed)
        speed += 0.02 / J * (4.0 * (3.0 - speed) + integral)
        wanted.append(speed)
    np.testing.assert_allclose(t, 0.02 * np.arange(21), atol=1e-12)
    np.testing.assert_allclose(channel("signal[speed]"), wanted, atol=1e-7)


def test_a_driven_motion_without_dynamics():
    text = ROTOR + SAMPLED % "" + "actuators: {motor: {type: torque, signal: u, bodies: [rotor]}}\n"
    text += "scenarios:\n  run: {drive: {rotor: {speed: 2 rad/s}}, duration: 60 ms, step: 1 ms, "
    text += "method: kinematics}\n"
    done, _, channel = go(compile_model(loads_model(text), "run"))
    assert done.status == 1, done.sentence
    np.testing.assert_allclose(channel("signal[speed]"), 2.0, atol=1e-12)
    assert channel("signal[u]")[-1] == pytest.approx(4.0 + 25.0 * 0.02 * 3)


def test_what_other_analyses_cannot_take_in():
    sampled = PAIR + ERROR + SAMPLED % ", start: 20" + DRIVE
    system = compile_model(loads_model(sampled), "up")
    with pytest.raises(
        SolverError, match=r"a speed sweep cannot call sampled controllers \(controllers.c \(line \d+\)\)"
    ):
        run_sweep(system)
    with pytest.raises(SolverError, match=r"a slow roll cannot call sampled controllers"):
        roll_through(compile_model(loads_model(sampled), "roll"), "roll")
    with pytest.raises(SolverError, match=r"actuators.drive \(line \d+\) depends on signal\[speed\]"):
        roll_through(compile_model(loads_model(PAIR + ERROR + PI % "" + DRIVE), "roll"), "roll")
    modes = find_modes(compile_model(loads_model(sampled), "run"), "run")
    assert "sampled controllers (c) are not called here" in modes.notes[-1]


def test_a_reduced_system_keeps_its_controllers():
    text = PAIR + ERROR + SAMPLED % ", start: 20" + DRIVE
    text = text.replace(
        "drum: {gears: [wheel],",
        "disc: {motion: torsion, inertia: 0.1, position: [0, 0, 1]}\n  drum: {gears: [wheel],",
    )
    text = text.replace(
        "loads:", "couplings:\n  c: {bodies: [motor, disc], stiffness: {torsion: 1e5}}\nloads:"
    )
    system = compile_model(loads_model(text.replace("100 rad/s}\ncontr", "110 rad/s}\ncontr")), "run")
    reduced = reduce_system(system, "run", limit=200.0)
    assert [c.name for c in reduced.system.controllers] == ["c"]
    found = []
    for one, state in ((reduced.system, reduced.state), (reduced.full, reduced.full_state)):
        done, _, channel = go(one, system.scenario, start=Start(one, state))
        assert done.status == 1, done.sentence
        found.append(channel("signal[u]"))
    assert np.ptp(found[0]) > 1.0
    # the disc on its spring at 160 Hz and its shape up to 200 Hz are in both
    np.testing.assert_allclose(found[0], found[1], rtol=2e-3)
    heard = "  force: {type: observation, channel: 'mesh_force[stage]'}\nloads:\n"
    system = compile_model(loads_model(PAIR.replace("loads:\n", heard)), "run")
    with pytest.raises(SolverError, match=r"cannot include sensors.force \(line 11\), which senses a load"):
        reduce_system(system, "run", limit=200.0)


def test_a_roll_and_a_sweep_with_signals_that_they_can_take_in():
    seen = PAIR.replace("torque: 40 N m", "torque: balance") + ERROR
    seen += "  held: {type: sum, offset: 20 N m}\n"
    seen += DRIVE.replace("signal: u", "signal: held")
    rolled = roll_through(compile_model(loads_model(seen), "roll"), "roll")
    assert rolled.status == 1
    system = compile_model(loads_model(seen), "roll")
    torque = rolled.rows[:, system.layout.channel("torque[load]")]
    np.testing.assert_allclose(torque, 40.0, rtol=1e-9)
    swept = run_sweep(compile_model(loads_model(seen), "up"))
    assert swept.status == 1
    assert swept.points[0]["channels"]["signal[drive]"]["mean"] == pytest.approx(20.0)


def test_a_result_tells_a_changed_controller(tmp_path: Path):
    from pitchpoint.core.provenance import content_hash

    text = ROTOR + "controllers:\n"
    text += "  c: {type: python, function: 'c.py:f', inputs: [error], outputs: [u], period: 1 s}\n"
    text += "actuators: {motor: {type: torque, signal: u, bodies: [rotor]}}\n"
    (tmp_path / "m.yaml").write_text(text, encoding="utf-8")
    found = []
    for gain in ("1.0", "1.0", "2.0"):
        (tmp_path / "c.py").write_text(f"def f(t, x, s, p):\n    return {gain}\n", encoding="utf-8")
        found.append(content_hash(load_model(tmp_path / "m.yaml", allow_code=True)))
    assert found[0] == found[1] != found[2]
