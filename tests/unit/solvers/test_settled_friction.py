# SPDX-License-Identifier: Apache-2.0
"""Accelerations with forces that follow the loads of joints: where large forces cancel, and in a jam."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import JAMMED
from pitchpoint.elements import torque
from pitchpoint.elements.gravity import gravity_records
from pitchpoint.elements.signal import set_constant
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.time import solve_time
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.system import assemble
from tests.unit.elements.test_joint_friction import acceleration, friction, pendulum

SHOVEL = Path(__file__).parents[3] / "examples" / "shovel-gearbox" / "paper.yaml"
METHODS = ("generalized_alpha", "rk4", "runge_kutta", "adams", "gstiff")


def pendulum_and_disc(mu, radius):
    """The pendulum on a pin, and a disc on which torques of 1e6 N m cancel but for rounding."""
    one = pendulum(mu, radius)
    bodies = [*one.bodies, Body(polar_inertia=1e-3, name="disc")]
    row, pool = friction(bodies, 1, c_r=radius, mu=mu, v_eps=1e-3)
    loads = np.zeros(4, torque.RECORD)
    loads["i"] = 2
    for load, value in zip(loads, (0.1e6, 0.2e6, 0.7e6, -1e6), strict=True):
        set_constant(load, value)
    banks = {"gravity": gravity_records(bodies, (0, 0, -9.81)), "joint_friction": row, "torque": loads}
    return one, assemble(bodies, banks, pools={"joint_friction": pool})


@pytest.mark.nojit
@pytest.mark.parametrize(("angle", "rate"), [(0.9, 1.7), (0.0, 0.0)])
def test_friction_settles_beside_forces_that_cancel(angle, rate):
    """The disc does not touch the pendulum, whose acceleration alone `test_joint_friction` derives."""
    one, both = pendulum_and_disc(0.3, 0.08)
    alone, together = one.initial_state(), both.initial_state()
    for state in (alone, together):
        state.q[0], state.v[0] = angle, rate
    found = acceleration(both, together)
    assert found[0] == pytest.approx(acceleration(one, alone)[0], rel=1e-12, abs=1e-12)
    assert abs(found[1]) < 4 * 1e6 * 2.2e-16 / 1e-3


def test_a_jammed_mechanism_is_named():
    """A pin so thick that each pass multiplies its friction by mu r m l/(I + m l^2) = 1.4 does not settle."""
    system = pendulum(0.75, 1.36)
    state = system.initial_state()
    state.q[0], state.v[0] = 0.9, 1.7
    evaluate.prepare(system)
    evaluate.load(system, state)
    with pytest.raises(SolverError, match="jams") as failure:
        evaluate.check(system, evaluate.send_request(system.workspace, evaluate.ACCELERATE, 0.0))
    assert failure.value.status == JAMMED


def moving_axes(mu: float, method: str) -> str:
    gear = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    return (
        f"gears:\n  a: {{number_of_teeth: 30, {gear}}}\n  b: {{number_of_teeth: 45, {gear}}}\n"
        "bodies:\n  driver: {gears: [a], motion: planar, inertia: 0.002 kg m^2, mass: 2 kg}\n"
        "  driven: {gears: [b], inertia: 0.01 kg m^2, mass: 4 kg, position: [112.5 mm, 0, 0]}\n"
        "joints:\n  pin: {type: revolute, bodies: [ground, driven],\n"
        f"    friction: {{coefficient: {mu}, radius: 20 mm, slip_speed: 0.1 mm/s}}}}\n"
        "bearings:\n  one: {body: driver, stiffness: {radial: 2e8 N/m}, damping: {ratio: 0.02}}\n"
        "meshes:\n  stage: {gears: [a, b], stiffness: {law: constant, value: 4e8 N/m},\n"
        "    damper: {ratio: 0.05}}\n"
        "loads:\n  in: {body: driver, torque: 171.43 N m}\n  out: {body: driven, torque: balance}\n"
        f"scenarios:\n  run: {{speed: {{driver: 500 rpm}}, duration: 1 ms, step: 5 us, method: {method}}}\n"
    )


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("mu", [0.05, 0.0])
def test_joint_friction_runs_with_a_mesh_on_moving_axes(mu, method):
    """In steady running the pin carries the mesh force T/r_b and brakes with mu r of it.

    The pin turns against the driver, so its friction is positive; 1e-6: the balance of the start.
    """
    found = solve_time(compile_model(loads_model(moving_axes(mu, method)), "run"))
    force = 171.43 / (0.5 * 30 * 3e-3 * np.cos(np.radians(20.0)))
    np.testing.assert_allclose(found["mesh_force[stage]"].values, force, rtol=1e-6)
    np.testing.assert_allclose(found["friction_torque[pin]"].values, mu * 0.02 * force, rtol=1e-6)


@pytest.mark.parametrize("method", METHODS)
def test_load_sensors_do_not_stop_a_gearbox_with_mesh_friction(method):
    """At rated speed from the first instant; the joint of the output takes the force of its flanks.

    Friction, up to 0.1 of the normal force, acts at right angles to it.
    """
    text = SHOVEL.read_text()
    for old, new in (
        ("speed: {table: [[0 s, 0 rpm], [1 s, 740 rpm]]}", "speed: 740 rpm"),
        ("duration: 15 s", f"duration: 2 ms\n    method: {method}"),
        ("settle_time: 3 s", "settle_time: 0 s"),
        ("sample_rate: 2152 Hz", "sample_rate: 10 kHz"),
    ):
        assert old in text
        text = text.replace(old, new)
    found = solve_time(compile_model(loads_model(text), "rated"))
    sensed = np.array([found[f"signal[output_force_{k}]"].values for k in "xyz"])
    load = np.linalg.norm(sensed, axis=0)
    normal = found["normal_force[stage_3]"].values
    assert np.all(normal > 1e5)
    assert np.all((load >= normal * (1.0 - 1e-9)) & (load <= normal * np.hypot(1.0, 0.1)))
