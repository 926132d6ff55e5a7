# SPDX-License-Identifier: Apache-2.0
"""Where a controlled pendulum rests: conditions of equilibrium written down by hand."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from pitchpoint.elements import gravity
from pitchpoint.elements.signals.net import SignalNet
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.system import evaluate
from pitchpoint.system.signals import assemble_controlled

WEIGHT, ARM = 2.0 * 9.81, 0.5


def pendulum(ki, time_constant=0.05, limits=None):
    """Arm about a horizontal axis with a PID law of its filtered angle, to be held at 0.8 rad."""
    axes = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    inertia = np.diag([0.01, 0.06, 0.05])
    body = Body(motion=TORSION, axes=axes, mass=2.0, com=(ARM, 0.0, 0.0), inertia=inertia, name="arm")
    net = SignalNet([body])
    net.joint_sensor("angle", 1, "spin")
    net.low_pass("seen", "angle", time_constant)
    net.linear("error", {"seen": -1.0}, 0.8)
    net.pid("u", "error", kp=40.0, ki=ki, kd=3.0, filter_time=0.01, limits=limits)
    net.torque("motor", "u", 1)
    record = np.zeros(1, gravity.RECORD)
    record["i"], record["weight"], record["com"] = 1, (0.0, 0.0, -WEIGHT), (ARM, 0.0, 0.0)
    return assemble_controlled(net, {"gravity": record})


@pytest.mark.parametrize("limits", [None, (-100.0, 100.0)])
def test_an_integral_leaves_no_error(limits):
    system = pendulum(30.0, limits=limits)
    state = find_equilibrium(system, tolerance=1e-12).state
    load = WEIGHT * ARM * np.cos(0.8)
    assert state.q[system.spin("arm")] == pytest.approx(0.8, abs=1e-10)
    assert state.v[system.spin("state.seen")] == pytest.approx(0.8, abs=1e-10)
    assert abs(state.v[system.spin("state.u.integral")]) == pytest.approx(load, rel=1e-9)
    # two rates vanish only as the residual does: their gains are 30 and 1/0.01
    np.testing.assert_allclose(evaluate.residual(system, state), 0.0, atol=1e-8)


def test_without_one_the_load_leaves_an_error():
    system = pendulum(0.0)
    angle = find_equilibrium(system, tolerance=1e-12).state.q[system.spin("arm")]
    sign = np.sign(0.8 - angle)
    wanted = brentq(lambda a: 40.0 * (0.8 - a) - sign * WEIGHT * ARM * np.cos(a), -1.0, 2.0, xtol=1e-14)
    assert angle == pytest.approx(wanted, abs=1e-9)
