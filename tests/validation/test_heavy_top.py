# SPDX-License-Identifier: Apache-2.0
"""Heavy top: a body on a spherical joint under gravity, against Euler's equations and steady precession.

Numbers of the heavy top of M. Arnold, O. Bruels, Convergence of the generalized-alpha scheme for
constrained mechanical systems, Multibody System Dynamics 18 (2007): 15 kg, centre 1 m from the fixed point,
0.46875 kg m^2 about the figure axis and 0.234375 kg m^2 across through the centre, 150 rad/s about the
figure axis and -4.61538 rad/s about the vertical, gravity 9.81 m/s^2. The figure axis is their second, ours
is the third of the body: (x, y, z) of the body are (z, x, y) there. It lies along y of the world at the
start, gravity along -z.

The reference is Euler's equations with quaternions, integrated by SciPy to 1e-13; it shares nothing with the
engine, whose turns start afresh from new charts. Steady precession needs no integration: a top whose axis is
theta off the vertical goes round at P if its spin w about the axis (all of it) satisfies

    m g l = I_3 w P - I_1 P^2 cos theta,

I_1 about the fixed point (moment = P x angular momentum).
"""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pitchpoint.core.status import OK
from pitchpoint.elements.gravity import gravity_records
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import SPHERICAL
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.multistep import bdf
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble

MASS, ACROSS, ALONG, G = 15.0, 0.234375, 0.46875, 9.81
ABOUT = np.diag([ACROSS + MASS, ACROSS + MASS, ALONG])
"""Inertia about the fixed point [kg m^2]."""
AXES = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
RATE = (-4.61538, 0.0, 150.0)
DURATION = 2.0


def top(axes, rate):
    """The top with its axes and angular velocity (in these axes) at the start."""
    body = Body(
        motion=SPHERICAL,
        axes=axes,
        mass=MASS,
        com=(0.0, 0.0, 1.0),
        inertia=np.diag([ACROSS, ACROSS, ALONG]),
        rate=tuple(rate),
        name="top",
    )
    return assemble([body], {"gravity": gravity_records([body], (0.0, 0.0, -G))})


def turned(p):
    """Rotation matrix of a quaternion (scalar first), whose length is divided out."""
    w, x, y, z = p / np.linalg.norm(p)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def euler(t, y):
    """Rates of quaternion and angular velocity (axes of the body)."""
    p, o = y[:4], y[4:]
    weight = turned(p).T @ AXES.T @ (0.0, 0.0, -MASS * G)
    moment = np.cross((0.0, 0.0, 1.0), weight)
    rate = np.concatenate([[-p[1:] @ o], p[0] * o + np.cross(p[1:], o)])
    return np.concatenate([0.5 * rate, np.linalg.solve(ABOUT, moment - np.cross(o, ABOUT @ o))])


@pytest.fixture(scope="module")
def reference():
    """Attitude (3, 3) and angular velocity (world) at a time."""

    @cache
    def at(t):
        y0 = [1.0, 0.0, 0.0, 0.0, *RATE]
        done = solve_ivp(euler, (0.0, t), y0, "DOP853", rtol=1e-13, atol=1e-13)
        S = AXES @ turned(done.y[:4, -1])
        return S, S @ done.y[4:, -1]

    return at


def attitude(system, state):
    evaluate.residual(system, state)
    fr = system.workspace.fr[1]
    return fr["S"].copy(), fr["tw"][3:].copy()


def energy(S, o):
    return 0.5 * o @ S @ ABOUT @ S.T @ o + MASS * G * S[2, 2]


def errors(system, state, reference):
    """Of the place of the centre [m], of the attitude [-] and of the energy [J]."""
    S, o = attitude(system, state)
    begun = energy(AXES, AXES @ RATE)
    return np.abs((S - reference[0])[:, 2]).max(), np.abs(S - reference[0]).max(), abs(energy(S, o) - begun)


def test_the_reference_keeps_energy_and_vertical_momentum(reference):
    S, o = reference(DURATION)
    assert energy(S, o) == pytest.approx(energy(AXES, AXES @ RATE), rel=1e-11)
    assert (S @ ABOUT @ S.T @ o)[2] == pytest.approx((AXES @ ABOUT @ RATE)[2], abs=1e-9)
    assert (S.T @ o)[2] == pytest.approx(150.0, abs=1e-9)


def test_an_explicit_method(reference):
    """300 rad of spin, each step known to 1e-11 of its rates: a hundred times the sum of what they leave."""
    system = top(AXES, RATE)
    run = runge_kutta.start_adaptive(system, system.initial_state(), rtol=1e-11, atol=1e-13, atol_rate=1e-11)
    assert run.advance_to(DURATION).status == OK
    place, turn, lost = errors(system, run.state(), reference(DURATION))
    assert place < 1e-9
    assert turn < 1e-8
    assert lost < 1e-7  # of 5400 J


def test_a_stiff_method(reference):
    """Each of 500 (900) steps leaves a part of rtol; speeds of 150 rad/s carry it on for 2 s."""
    for rtol in (1e-5, 1e-7):
        system = top(AXES, RATE)
        run = bdf.start(system, system.initial_state(), "wstiff", rtol=rtol)
        assert run.advance_to(DURATION).status == OK
        place, turn, lost = errors(system, run.state(), reference(DURATION))
        assert place < 20.0 * rtol
        assert turn < 40.0 * rtol
        assert lost < 5400.0 * 10.0 * rtol


def halved(method, n, duration, reference):
    """Errors of two runs of equal steps, n of them and twice as many."""
    found = []
    for steps in (n, 2 * n):
        system = top(AXES, RATE)
        h = duration / steps
        if method == "runge_kutta":
            run = runge_kutta.start_classical(system, system.initial_state(), h)
        elif method == "adams":
            run = runge_kutta.start_adams(system, system.initial_state(), h)
        else:
            run = generalized_alpha.start(system, system.initial_state(), h, tolerance=1e-15)
        assert run.advance(steps).status == OK
        found.append(errors(system, run.state(), reference(duration)))
    return found, run.state()


@pytest.mark.parametrize(
    ("method", "order"), [("generalized_alpha", 2.0), ("runge_kutta", 4.0), ("adams", 4.0)]
)
def test_the_order_of_equal_steps(method, order, reference):
    """Before the turns start afresh: where they do lies on the grid of the steps, no smooth function."""
    found, state = halved(method, 100, 0.1, reference)
    np.testing.assert_array_equal(state.charts[0], np.eye(3))
    for coarse, fine in zip(*found, strict=True):
        assert math.log2(coarse / fine) == pytest.approx(order, abs=0.25)


@pytest.mark.parametrize(("method", "most"), [("generalized_alpha", 5e-6), ("runge_kutta", 1e-10)])
def test_equal_steps_through_new_charts(method, most, reference):
    """0.0375 rad of spin in a step: its square, 1e-3, and fourth power, 2e-6, of the small nutation."""
    found, state = halved(method, 4000, DURATION, reference)
    assert np.abs(state.charts[0] - np.eye(3)).max() > 0.1
    assert max(found[1][:2]) < most


@pytest.mark.parametrize("theta", [math.radians(35.0), math.radians(120.0)])
def test_steady_precession_in_closed_form(theta):
    """The centre goes round on a circle; after 3 s at 4 rad/s the axis has turned twice."""
    P = 4.0
    w = (MASS * G + ABOUT[0, 0] * P**2 * math.cos(theta)) / (ALONG * P)
    n = np.array([math.sin(theta), 0.0, math.cos(theta)])
    axes = np.column_stack([np.cross([0.0, 1.0, 0.0], n), [0.0, 1.0, 0.0], n])
    omega = np.array([0.0, 0.0, P]) + (w - P * math.cos(theta)) * n
    system = top(axes, axes.T @ omega)
    run = runge_kutta.start_adaptive(system, system.initial_state(), rtol=1e-11, atol=1e-13, atol_rate=1e-11)
    for t in (0.5, 1.0, 2.0, 3.0):
        assert run.advance_to(t).status == OK
        S, o = attitude(system, run.state())
        circle = [math.sin(theta) * math.cos(P * t), math.sin(theta) * math.sin(P * t), math.cos(theta)]
        np.testing.assert_allclose(S[:, 2], circle, atol=1e-9)
        assert S[:, 2] @ o == pytest.approx(w, abs=1e-8)
