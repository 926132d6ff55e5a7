# SPDX-License-Identifier: Apache-2.0
"""Flyball governor: two arms and two rods between a shaft and a sleeve, against Lagrange's equations.

A case of the IFToMM library, here with numbers of our own so that a closed form exists: the arms (length L,
ball of mass m at the end) hang at e from the axis of the shaft (inertia J), massless rods as long as the
upper part b of the arms hold the sleeve (mass M) below at the same e. With theta the angle of the arms to
the vertical, phi that of the shaft, z = -2 b cos theta the height of the sleeve, a spring k (z + z_0)^2 / 2
on the sleeve,

    2 T = (J + 2 m r^2) phi'^2 + (2 m L^2 + M (2 b sin theta)^2) theta'^2,      r = e + L sin theta
    V = -2 m g L cos theta + M g z + k (z + z_0)^2 / 2

Angular momentum (J + 2 m r^2) phi' is kept; steady motion at omega^2 2 m r L cos theta = dV/dtheta. The z
axis points up.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pitchpoint.core.status import OK
from pitchpoint.elements import spring_damper
from pitchpoint.elements.closure_rows import rod
from pitchpoint.elements.gravity import gravity_records
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.joints import PRISMATIC
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.multistep import bdf
from pitchpoint.system.system import assemble

J, BALL, SLEEVE, L, B, E, G = 0.02, 0.8, 1.2, 0.25, 0.12, 0.03, 9.81
STIFFNESS, REST = 600.0, 0.2
THETA = math.radians(35.0)
DURATION = 2.0


def arm(side, theta, **more):
    """Arm with a ball: hangs at e to one side, turns outwards with its spin."""
    z = np.array([0.0, -1.0, 0.0]) * side  # from down towards the side
    along = np.array([side * math.sin(theta), 0.0, -math.cos(theta)])
    axes = np.column_stack([along, np.cross(z, along), z])
    return Body(
        motion=TORSION,
        parent=1,
        position=(side * E, 0.0, 0.0),
        axes=axes,
        mass=BALL,
        com=(L, 0.0, 0.0),
        inertia=np.zeros((3, 3)),
        **more,
    )


def governor(theta, speed):
    """System and state: shaft, two arms, sleeve; two rods."""
    low = -2.0 * B * math.cos(theta)
    bodies = [
        Body(motion=TORSION, polar_inertia=J, mass=1.0, transverse_inertia=J, rate=(speed,), name="shaft"),
        arm(1.0, theta, name="right"),
        arm(-1.0, theta, name="left"),
        Body(
            motion=PRISMATIC,
            parent=1,
            position=(0.0, 0.0, low),
            mass=SLEEVE,
            inertia=np.zeros((3, 3)),
            name="sleeve",
        ),
    ]
    elbow = np.array([E + B * math.sin(theta), 0.0, -B * math.cos(theta)])
    rows = []
    for k, side in ((2, 1.0), (3, -1.0)):
        turned = elbow * (side, 1.0, 1.0)
        rows.append(rod(bodies, k, 4, turned, (side * E, 0.0, low), B))
    spring = np.zeros(1, spring_damper.RECORD)
    spring["i"], spring["j"], spring["k"] = 4, 1, STIFFNESS
    spring["free"], spring["p_j"] = 1.0 - REST, (0.0, 0.0, -1.0)
    banks = {"gravity": gravity_records(bodies, (0.0, 0.0, -G)), "spring_damper": spring}
    system = assemble(bodies, banks, {"closure": np.concatenate(rows)}, names={"closure": ["right", "left"]})
    found = assemble_state(system, keep_rates=[system.layout.coordinate("shaft.spin")])
    assert found.freedoms == 2
    return system, found.state


def potential(theta):
    """V and its derivative."""
    z = -2.0 * B * math.cos(theta)
    dz = 2.0 * B * math.sin(theta)
    V = -2.0 * BALL * G * L * math.cos(theta) + SLEEVE * G * z + 0.5 * STIFFNESS * (z + REST) ** 2
    return V, 2.0 * BALL * G * L * math.sin(theta) + (SLEEVE * G + STIFFNESS * (z + REST)) * dz


def steady(theta):
    """Speed at which the arms stay [rad/s]."""
    r = E + L * math.sin(theta)
    return math.sqrt(potential(theta)[1] / (2.0 * BALL * r * L * math.cos(theta)))


def lagrange(t, y):
    """Rates of theta, phi, theta', phi'."""
    theta, _, w, omega = y
    s, c = math.sin(theta), math.cos(theta)
    r = E + L * s
    inertia = 2.0 * BALL * L**2 + SLEEVE * (2.0 * B * s) ** 2
    swing = SLEEVE * 4.0 * B**2 * s * c * w**2
    bend = (2.0 * BALL * r * L * c * omega**2 - potential(theta)[1] - swing) / inertia
    turn = -4.0 * BALL * r * L * c * w * omega / (J + 2.0 * BALL * r**2)
    return w, omega, bend, turn


@pytest.fixture(scope="module")
def reference():
    """theta, phi, theta', phi' after the shaft was let go at 1.3 times the steady speed."""
    y0 = (THETA, 0.0, 0.0, 1.3 * steady(THETA))
    found = solve_ivp(lagrange, (0.0, DURATION), y0, "DOP853", rtol=1e-13, atol=1e-13)
    assert np.ptp(found.y[0]) > 0.1
    return found.y[:, -1]


def measured(system, state):
    """The same four, and by how much both arms differ."""
    at = system.layout.coordinate
    phi = state.q[at("shaft.spin")] + 2.0 * np.pi * state.turns[1]
    right, left = (state.q[at(f"{name}.spin")] for name in ("right", "left"))
    found = np.array([THETA + right, phi, state.v[at("right.spin")], state.v[at("shaft.spin")]])
    return found, abs(right - left)


def test_what_is_steady_stays():
    """For two seconds: an equilibrium about which small errors swing and do not grow."""
    system, state = governor(THETA, steady(THETA))
    run = runge_kutta.start_adaptive(system, state, rtol=1e-11, atol=1e-13, atol_rate=1e-11)
    assert run.advance_to(DURATION).status == OK
    found, apart = measured(system, run.state())
    np.testing.assert_allclose(found, [THETA, DURATION * steady(THETA), 0.0, steady(THETA)], atol=1e-9)
    assert apart < 1e-12


def test_an_explicit_method(reference):
    system, state = governor(THETA, 1.3 * steady(THETA))
    run = runge_kutta.start_adaptive(system, state, rtol=1e-11, atol=1e-13, atol_rate=1e-11)
    assert run.advance_to(DURATION).status == OK
    found, apart = measured(system, run.state())
    np.testing.assert_allclose(found, reference, atol=1e-10)
    assert apart < 1e-10


@pytest.mark.parametrize("form", bdf.FORMS)
@pytest.mark.parametrize("kind", ["gstiff", "wstiff", "dassl"])
def test_stiff_methods(kind, form, reference):
    """Nine hundred steps that leave a part of 1e-7 of 9 rad/s each, for 2 s."""
    system, state = governor(THETA, 1.3 * steady(THETA))
    run = bdf.start(system, state, kind, form=form, rtol=1e-7)
    assert run.advance_to(DURATION).status == OK
    found, apart = measured(system, run.state())
    np.testing.assert_allclose(found, reference, atol=5e-6)
    assert apart < 1e-9


def test_equal_steps_are_of_second_order(reference):
    errors = []
    for n in (2000, 4000):
        system, state = governor(THETA, 1.3 * steady(THETA))
        run = generalized_alpha.start(system, state, DURATION / n, tolerance=1e-15)
        assert run.advance(n).status == OK
        errors.append(np.abs(measured(system, run.state())[0] - reference))
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.2)
