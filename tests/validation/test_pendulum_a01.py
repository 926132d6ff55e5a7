# SPDX-License-Identifier: Apache-2.0
"""Benchmark A01 of the IFToMM library: a mass on a rod in Cartesian coordinates, ten seconds.

Library of Computational Benchmark Problems, IFToMM Technical Committee for Multibody Dynamics, problem A01:
m = 1 kg, L = 1 m, g = 9.81 m/s^2, from x = -1, y = 0 at rest. The published point at t = 10 s follows from
elliptic functions; so does the period.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import ellipj, ellipk

from pitchpoint.core.status import OK
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.multistep import bdf
from tests.support.rod import GRAVITY, pendulum

PERIOD = 2.3678419475762
POINT = (-0.275087462576, -0.961419205099)
DURATION = 10.0


def closed_form(t):
    """Position at a time, from the angle to the lower rest: sin(a/2) = k sn(K - w t), k = sin 45 deg."""
    m = 0.5
    w = math.sqrt(GRAVITY)
    half = math.sqrt(m) * ellipj(ellipk(m) - w * t, m)[0]
    angle = 2.0 * math.asin(half)
    return np.array([-math.sin(angle), -math.cos(angle)])


def energy(state):
    return 0.5 * float(state.v @ state.v) + GRAVITY * state.q[1]


def test_the_published_numbers_are_those_of_the_closed_form():
    assert 4.0 * ellipk(0.5) / math.sqrt(GRAVITY) == pytest.approx(PERIOD, abs=5e-14)
    np.testing.assert_allclose(closed_form(DURATION), POINT, atol=1e-12)


def test_an_explicit_method():
    system, state = pendulum()
    run = runge_kutta.start_adaptive(system, state, rtol=1e-9, atol=1e-12, atol_rate=1e-9)
    assert run.advance_to(DURATION).status == OK
    np.testing.assert_allclose(run.state().q, POINT, atol=1e-11)


@pytest.mark.parametrize("form", bdf.FORMS)
@pytest.mark.parametrize("kind", ["gstiff", "wstiff", "dassl"])
def test_error_control(kind, form):
    """Position, energy, and the force of the rod, which is v^2/L - g y/L for a mass of one."""
    for rtol in (1e-6, 1e-8):
        system, state = pendulum()
        run = bdf.start(system, state, kind, form=form, rtol=rtol, atol=1e-2 * rtol)
        chunk = run.advance_to(DURATION)
        assert chunk.status == OK
        final = run.state()
        allowed = 4.43 * rtol * chunk.steps  # if all steps leave the tolerance of the highest speed over
        np.testing.assert_allclose(final.q, POINT, atol=allowed)
        assert abs(energy(final)) < 4.43 * allowed
        # nothing controls the force; in I3 a change of the step leaves a trace in it, of 29 N
        force = final.v @ final.v - GRAVITY * final.q[1]
        assert final.lam[0] == pytest.approx(force, abs=0.03 if form == "I3" else 10.0 * allowed)


@pytest.mark.parametrize("method", ["constant_bdf", "generalized_alpha"])
@pytest.mark.parametrize("form", ["I3", "SI2"])
def test_equal_steps_are_of_second_order(method, form):
    errors, energies = [], []
    for h in (2e-3, 1e-3):
        system, state = pendulum()
        if method == "constant_bdf":
            run = bdf.start(system, state, method, form=form, largest_step=h)
            assert run.advance_to(DURATION).status == OK
        else:
            run = generalized_alpha.start(system, state, h, form=form, tolerance=1e-15)
            assert run.advance(round(DURATION / h)).status == OK
        errors.append(np.abs(run.state().q - POINT).max())
        energies.append(abs(energy(run.state())))
    # 1200 steps in a period: the next terms are a few per cent
    assert math.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.15)
    assert math.log2(energies[0] / energies[1]) > 1.8
    assert errors[1] < 1e-3


def test_samples_within_steps_follow_the_closed_form():
    system, state = pendulum()
    run = bdf.start(system, state, "gstiff", rtol=1e-8, atol=1e-10)
    rows = run.advance_to(DURATION, sample=0.05).rows
    assert rows.shape[0] == 200
    x, y = (1 + system.layout.channel(f"displacement[{name}.z]") for name in ("slide", "mass"))
    expected = np.array([closed_form(t) for t in rows[:, 0]])
    np.testing.assert_allclose(rows[:, [x, y]], expected, atol=5e-6)
