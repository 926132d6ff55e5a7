# SPDX-License-Identifier: Apache-2.0
"""Forces that jump at instants: order of the methods with fixed steps, constraints, stiff parts."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

import pitchpoint as pp
from pitchpoint.solvers import sampled_control
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory

PERIOD = 0.05
FORCES = (3.0, -5.0, 8.0, 1.0, -7.0, 4.0, 0.0, 9.0, -2.0, 6.0)
LAW = f"""
def law(t, inputs, state, parameters):
    forces = {FORCES}
    return forces[min(round(t / {PERIOD}), {len(FORCES) - 1})]
"""
CONTROL = """
controllers:
  loop: {type: python, function: "law.py:law", inputs: [angle], outputs: [u], period: 50 ms, unit: N m}
"""
SCENARIO = """
scenarios:
  run: {{start: assembled, duration: 0.5 s, step: {step} s, settle_time: 0 s, sample_rate: 20 Hz,
    method: {method}}}
"""
OSCILLATOR = """
bodies: {rotor: {motion: torsion, inertia: 1 kg m^2}}
torsion_springs: {shaft: {bodies: [rotor], stiffness: 900 N m/rad, damping: 6 N m s/rad}}
sensors: {angle: {type: joint, coordinate: rotor}}
actuators: {motor: {type: torque, signal: u, bodies: [rotor]}}
"""
PENDULUM = """
gravity: [0, -9.81, 0]
bodies:
  upper: {position: [0, 0, 0], mass: 2 kg, center_of_mass: [0.3, 0, 0],
    inertia_tensor: [1, 1, 0.05, 0, 0, 0]}
  lower: {position: [0.6, 0, 0], mass: 1 kg, center_of_mass: [0.25, 0, 0],
    inertia_tensor: [1, 1, 0.02, 0, 0, 0]}
joints:
  shoulder: {type: revolute, bodies: [ground, upper]}
  elbow: {type: revolute, bodies: [upper, lower]}
ratios: {train: {terms: {elbow.spin: 1, shoulder.spin: 1.5}}}
sensors: {angle: {type: joint, coordinate: shoulder.spin}}
actuators: {motor: {type: torque, signal: u, bodies: [upper]}}
"""
STIFF = """
bodies:
  wheel: {motion: torsion, inertia: 1 kg m^2}
  root: {motion: torsion, inertia: 1e-4 kg m^2, position: [0, 0, 0]}
torsion_springs: {shaft: {bodies: [root, wheel], stiffness: 1e6 N m/rad}}
sensors: {angle: {type: joint, coordinate: wheel}, other: {type: joint, coordinate: root}}
actuators: {motor: {type: torque, signal: u, bodies: [root]}}
"""
STEPS = PERIOD / 2.0 ** np.arange(3, 7)


def go(folder: Path, text: str, step: float, method: str = "generalized_alpha", *signals: str):
    """Run with the forces; returns its summary and the signals at the instants, before the jumps."""
    (folder / "law.py").write_text(LAW)
    (folder / "model.yaml").write_text(text + CONTROL + SCENARIO.format(step=step, method=method))
    system = pp.compile_model(pp.load_model(folder / "model.yaml", allow_code=True), "run")
    memory = Memory()
    done = run_time(system, sink=memory)
    assert done.status == 1, done.sentence
    columns = [system.layout.channel(f"signal[{name}]") for name in signals or ("angle",)]
    return done, np.concatenate(memory.rows)[:, columns]


@pytest.mark.parametrize(
    ("method", "order"), [("generalized_alpha", 2), ("constant_bdf", 2), ("rk4", 4), ("adams", 4)]
)
def test_an_oscillator_against_its_closed_form(tmp_path, method, order):
    step = expm(np.array([[0.0, 1.0, 0.0], [-900.0, -6.0, 1.0], [0.0, 0.0, 0.0]]) * PERIOD)
    state, angles = np.zeros(2), [0.0]
    for force in FORCES:
        state = (step @ [*state, force])[:2]
        angles.append(state[0])
    errors = [np.abs(go(tmp_path, OSCILLATOR, h, method)[1][:, 0] - angles).max() for h in STEPS]
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    np.testing.assert_allclose(orders, order, atol=0.1 * order)
    assert errors[-1] < 1.5e-3 * max(np.abs(angles))


def test_without_correction_the_force_is_half_a_step_late(tmp_path, monkeypatch):
    """The closed form with all forces half a step later: what a method that ignores the jump computes."""
    monkeypatch.setattr(sampled_control, "continue_after_jump", lambda run, change: 1)
    h = STEPS[-1]
    late = expm(np.array([[0.0, 1.0, 0.0], [-900.0, -6.0, 1.0], [0.0, 0.0, 0.0]]) * 0.5 * h)
    rest = expm(np.array([[0.0, 1.0, 0.0], [-900.0, -6.0, 1.0], [0.0, 0.0, 0.0]]) * (PERIOD - 0.5 * h))
    state, angles, before = np.zeros(2), [0.0], FORCES[0]
    for force in FORCES:
        state = (rest @ [*(late @ [*state, before])[:2], force])[:2]
        angles.append(state[0])
        before = force
    found = go(tmp_path, OSCILLATOR, h)[1][:, 0]
    assert np.abs(found - angles).max() < 2e-3 * max(np.abs(angles))


def pendulum():
    """Angles of the double pendulum with coupled joints, and the torque of the coupling at the elbow."""
    k, weights = 1.0 * 0.6 * 0.25, 9.81 * np.array([2.0 * 0.3 + 1.0 * 0.6, 1.0 * 0.25])
    lower, upper = 0.02 + 0.25**2, 0.05 + 2.0 * 0.3**2 + 0.6**2
    along = np.array([1.0, -1.5])

    def balance(q, w, torque):
        c, s = k * np.cos(q[1]), k * np.sin(q[1])
        mass = np.array([[upper + lower + 2.0 * c, lower + c], [lower + c, lower]])
        pull = weights[1] * np.cos(q[0] + q[1])
        first = torque + s * w[1] * (2.0 * w[0] + w[1]) - weights[0] * np.cos(q[0]) - pull
        return mass, np.array([first, -s * w[0] ** 2 - pull])

    def slope(t, y, torque):
        mass, force = balance(along * y[0], along * y[1], torque)
        return [y[1], (along @ force) / (along @ mass @ along)]

    y, angles = np.zeros(2), [0.0]
    for force in FORCES:
        y = solve_ivp(slope, (0.0, PERIOD), y, "DOP853", args=(force,), rtol=1e-12, atol=1e-13).y[:, -1]
        angles.append(y[0])
    mass, force = balance(along * y[0], along * y[1], FORCES[-1])
    return np.array(angles), (mass @ (along * slope(0.0, y, FORCES[-1])[1]) - force)[1]


@pytest.mark.parametrize("form", ["I3", "SI2"])
def test_constraints_and_a_mass_matrix_that_turns(tmp_path, form):
    """Second order of positions and multipliers, with matrices that are reused over several steps."""
    angles, torque = pendulum()
    errors = []
    for h in STEPS:
        done, found = go(tmp_path, PENDULUM, h, f"generalized_alpha, form: {form}")
        errors.append((np.abs(found[:, 0] - angles).max(), abs(torque + done.state.lam[0])))
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    np.testing.assert_allclose(orders, 2.0, atol=0.05)
    assert errors[-1][0] < 1e-5 * np.ptp(angles) and errors[-1][1] < 2e-4 * abs(torque)


def test_stiff_parts_follow_without_swinging(tmp_path):
    """An inertia with 16 kHz at 12.5 ms per step: the twist remains near its static value.

    The wheel moves as a rigid body, by twice integrated forces. A restart would give the small inertia the
    acceleration u/J, and twist the shaft by several thousand times the static value.
    """
    speed, angle, angles = 0.0, 0.0, [0.0]
    for force in FORCES:
        a = force / 1.0001
        angle, speed = angle + speed * PERIOD + 0.5 * a * PERIOD**2, speed + a * PERIOD
        angles.append(angle)
    _, found = go(tmp_path, STIFF, 0.0125, "generalized_alpha", "angle", "other")
    np.testing.assert_allclose(found[:, 0], angles, atol=2e-5 * max(np.abs(angles)))
    assert np.abs(found[:, 1] - found[:, 0]).max() < 3.0 * max(np.abs(FORCES)) / 1e6
