# SPDX-License-Identifier: Apache-2.0
"""Spatial slider-crank: crank about x, rod, slider along x; against a reduction to one freedom.

Numbers of E. J. Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems I (1989), 12.4, as used
in the IFToMM library: crank of 0.08 m about an axis along x through (0, 0.1, 0.12), rod of 0.3 m and 0.5
kg, slider of 2 kg on the x axis, crank 0.12 kg, start with the crank upright at 6 rad/s, gravity 9.81 m/s^2
along -z. The rod and the crank are slender here (their place in the reduction is then three point masses);
ball at the crank, universal joint at the slider. The frame is that of the source; the tree is cut at the
ball.

The slider is at x = sqrt(l^2 - y^2 - z^2), y and z of the crank pin (tests/support/one_freedom.py).
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.elements.closure_rows import cut_joint
from pitchpoint.elements.gravity import gravity_records
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.joints import PRISMATIC, SPHERICAL, UNIVERSAL
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.multistep import bdf
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.one_freedom import ROD, OneFreedom, along_rod

CRANK, LENGTH, PIVOT = 0.08, 0.3, np.array([0.0, 0.1, 0.12])
MASSES = {"crank": 0.12, "rod": 0.5, "slider": 2.0}
GRAVITY = np.array([0.0, 0.0, -9.81])
SPEED, DURATION = 6.0, 2.0


def pin(angle):
    """Crank pin; angle from upright about x."""
    return PIVOT + CRANK * np.array([0.0, -math.sin(angle), math.cos(angle)])


def places(angle):
    """Places of the seven masses: crank, rod, slider."""
    end = pin(angle)
    slider = np.array([math.sqrt(LENGTH**2 - end[1] ** 2 - end[2] ** 2), 0.0, 0.0])
    return np.concatenate([along_rod(PIVOT, end), along_rod(slider, end), [slider]])


@pytest.fixture(scope="module")
def reduced():
    masses = np.concatenate([MASSES["crank"] * ROD, MASSES["rod"] * ROD, [MASSES["slider"]]])
    return OneFreedom(masses, places, (-3.3, 3.3), GRAVITY, periodic=True)


def frame(z, x):
    """Axes with the third along z and the first near x."""
    z = np.asarray(z, float) / np.linalg.norm(z)
    x = x - (x @ z) * z
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(z, x), z])


def slender(mass, length, along):
    """Inertia about the middle of a slender rod along an axis."""
    tensor = np.eye(3) * mass * length**2 / 12.0
    tensor[along, along] = 0.0
    return tensor


def mechanism():
    """Crank on ground, slider on ground, rod on the slider by a universal joint; ball at the pin cut."""
    end = pin(0.0)
    slider = places(0.0)[-1]
    crank_axes = np.column_stack([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    bodies = [
        Body(
            motion=TORSION,
            position=PIVOT,
            axes=crank_axes,
            mass=MASSES["crank"],
            com=(0.0, 0.5 * CRANK, 0.0),
            inertia=slender(MASSES["crank"], CRANK, 1),
            rate=(SPEED,),
            name="crank",
        ),
        Body(
            motion=PRISMATIC,
            position=slider,
            axes=crank_axes,
            mass=MASSES["slider"],
            inertia=1e-4 * np.eye(3),
            name="slider",
        ),
        Body(
            motion=UNIVERSAL,
            parent=2,
            position=slider,
            axes=frame(end - slider, np.array([0.0, 1.0, 0.0])),
            mass=MASSES["rod"],
            com=(0.0, 0.0, 0.5 * LENGTH),
            inertia=slender(MASSES["rod"], LENGTH, 2),
            name="rod",
        ),
    ]
    rows, words = cut_joint(SPHERICAL, bodies, 3, 1, end, np.eye(3))
    names = {"closure": [f"ball {word}" for word in words]}
    system = assemble(bodies, {"gravity": gravity_records(bodies, GRAVITY)}, {"closure": rows}, names=names)
    found = assemble_state(system, keep=[0], keep_rates=[system.layout.coordinate("crank.spin")])
    assert found.freedoms == 1
    assert found.redundant == ()
    return system, found.state


def measured(system, state):
    """Angle of the crank with its turns, its rate, place and speed of the slider, energy."""
    d = system.layout.coordinate("crank.spin")
    evaluate.residual(system, state)
    fr = system.workspace.fr.copy()
    M = evaluate.matrix(system, state, 1.0, 0.0, 0.0)
    heights = [
        body.mass * (f["r"] + f["S"] @ body.center_of_mass())[2]
        for body, f in zip(system.bodies, fr[1:], strict=True)
    ]
    energy = 0.5 * state.v @ M @ state.v + 9.81 * sum(heights)
    return np.array(
        [
            state.q[d] + 2.0 * np.pi * state.turns[1],
            state.v[d],
            fr["r"][2][0],
            fr["tw"][2][0],
            energy,
        ]
    )


@pytest.fixture(scope="module")
def expected(reduced):
    """The same at the end by the reduction."""
    (angle,), (rate,) = reduced.motion(0.0, SPEED, [DURATION])
    slider = reduced.places(angle)[-1][0], reduced.places(angle, 1)[-1][0] * rate
    return np.array([angle, rate, *slider, sum(reduced.energy(angle, rate))])


@pytest.mark.study
def test_the_reduction_keeps_energy(reduced):
    (angles, rates) = reduced.motion(0.0, SPEED, np.linspace(0.1, DURATION, 20))
    energies = [sum(reduced.energy(u, w)) for u, w in zip(angles, rates, strict=True)]
    np.testing.assert_allclose(energies, sum(reduced.energy(0.0, SPEED)), atol=1e-11)
    assert angles[-1] > 6.0 * np.pi  # the crank goes round


def test_accelerations_at_the_start(reduced):
    system, state = mechanism()
    evaluate.prepare(system)
    evaluate.load(system, state)
    evaluate.check(system, evaluate.accelerations(system, 0.0))
    d = system.layout.coordinate("crank.spin")
    assert system.workspace.a[d] == pytest.approx(reduced.acceleration(0.0, SPEED), abs=1e-8)


@pytest.mark.study
def test_an_explicit_method(expected):
    """The tolerance of the steps is a hundred times finer."""
    system, state = mechanism()
    run = runge_kutta.start_adaptive(system, state, rtol=1e-11, atol=1e-13, atol_rate=1e-11)
    assert run.advance_to(DURATION).status == OK
    np.testing.assert_allclose(measured(system, run.state()), expected, atol=1e-8)


@pytest.mark.each_value
@pytest.mark.parametrize("form", bdf.FORMS)
@pytest.mark.parametrize("kind", ["gstiff", "wstiff", "dassl"])
def test_stiff_methods(kind, form, expected):
    """Two and four thousand steps; what is late by t has everything off by its rate times t.

    The error of a run falls with its tolerance, but for the steps that become more: a power of 0.75 allows
    for that. The factors are twice the largest error seen of nine methods, not a bound.
    """
    for rtol in (1e-7, 1e-9):
        system, state = mechanism()
        run = bdf.start(system, state, kind, form=form, rtol=rtol)
        assert run.advance_to(DURATION).status == OK
        off = np.abs(measured(system, run.state()) - expected)
        assert np.all(off < np.array([2e-4, 3e-3, 3e-6, 2e-4, 3e-6]) * (rtol / 1e-7) ** 0.75)


@pytest.mark.parametrize("form", ["I3", "SI2"])
def test_equal_steps_are_of_second_order(form, expected):
    errors = []
    for n in (2000, 4000):
        system, state = mechanism()
        run = generalized_alpha.start(system, state, DURATION / n, form=form, tolerance=1e-15)
        assert run.advance(n).status == OK
        errors.append(np.abs(measured(system, run.state()) - expected))
    coarse, fine = errors
    # angle, rate, place and speed; energy may pass through zero
    assert np.all(np.log2(coarse[:4] / fine[:4]) > 1.8)
    assert np.all(fine[:4] < 2e-3 * np.abs(expected[:4]))
