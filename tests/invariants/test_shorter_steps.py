# SPDX-License-Identifier: Apache-2.0
"""Shorter steps give smaller errors: convergence, momentum and energy of a machine that floats in space.

The machine is a tree whose mass matrix turns with it, without constraint rows and with one. Nothing acts from
outside, so momentum, its moment and energy stay. The reference is Dormand-Prince 8(5,3) with a tolerance of
1e-13, which keeps them to rounding.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.multistep import bdf
from tests.support.floating_carrier import floating_carrier, kept

DURATION = 0.01
ROUNDING = 2e-11
"""Error of rates [m/s] from which rounding of 1e5 steps counts."""

ALPHA = (2e-5, 1e-5, 5e-6, 2.5e-6, 1.25e-6, 1.25e-7)
EXPLICIT = (1e-4, 5e-5, 2.5e-5, 1.25e-5, 1.25e-6)
BDF = (2e-5, 1e-5, 5e-6, 2.5e-6)
"""Constant BDF differentiates positions: its shorter steps meet their rounding."""
BY_TOLERANCE, FORMS = ("gstiff", "wstiff", "dassl"), ("I3", "SI2", "SI1")
TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10)

EQUAL = [
    *(
        (geared, "generalized_alpha", form, 2, ALPHA)
        for geared, form in ((False, "I3"), (True, "I3"), (True, "SI2"))
    ),
    *((geared, method, "", 4, EXPLICIT) for geared in (False, True) for method in ("rk4", "adams")),
    *((geared, "constant_bdf", form, 2, BDF) for geared in (False, True) for form in FORMS),
]
CONTROLLED = [
    *((geared, kind, form) for geared in (False, True) for kind in BY_TOLERANCE for form in FORMS),
    *((geared, "runge_kutta", form) for geared in (False, True) for form in ("5", "8")),
]  # fmt: skip


@cache
def machine(geared):
    """System, state at the start, what it keeps, state at the end, weights of the coordinates."""
    system, state = floating_carrier(geared=geared)
    run = runge_kutta.start_adaptive(system, state, rtol=1e-13, atol=1e-17, atol_rate=1e-13)
    assert run.advance_to(DURATION).status == OK
    end = run.state()  # before anything else is loaded into the workspace
    return system, state, kept(system, state), end, system.workspace.arrays["weight"].copy()


def reached(geared, method, form, value):
    """Error of the rates, and changes of momentum, its moment and energy, these as shares."""
    system, state, before, end, weight = machine(geared)
    steps = round(DURATION / value)
    if method == "generalized_alpha":
        run = generalized_alpha.start(system, state, value, form=form)
    elif method in ("rk4", "adams"):
        run = (runge_kutta.start_adams if method == "adams" else runge_kutta.start_classical)(
            system, state, value
        )
    elif method == "constant_bdf":
        run = bdf.start(system, state, method, form=form, largest_step=value)
    elif method == "runge_kutta":
        run = runge_kutta.start_adaptive(
            system, state, rtol=value, atol=1e-4 * value, atol_rate=value, order=int(form)
        )
    else:
        run = bdf.start(system, state, method, form=form, rtol=value)
    done = run.advance(steps) if hasattr(run, "change_step") and run.h else run.advance_to(DURATION)
    assert done.status == OK
    found = run.state()
    momentum, moment, energy = (
        np.abs(now - then).max() for now, then in zip(kept(system, found), before, strict=True)
    )
    error = float(np.abs((found.v - end.v) * weight).max())
    return error, float(momentum), float(moment), float(energy) / before[2]


@pytest.mark.parametrize("geared", [False, True])
def test_the_reference_keeps_what_is_to_be_kept(geared):
    system, _, before, end, _ = machine(geared)
    for now, then in zip(kept(system, end), before, strict=True):
        assert np.abs(now - then).max() < 1e-13 * max(1.0, np.abs(then).max())


@pytest.mark.parametrize(("geared", "method", "form", "order", "steps"), EQUAL)
def test_equal_steps_converge_down_to_rounding(geared, method, form, order, steps):
    """Generalised alpha once left 1e-11 m at any step: 8e-3 kg m/s at 0.125 us, more than at 20 us."""
    errors = [reached(geared, method, form, h) for h in steps]
    for k in range(1, len(steps)):
        better = (steps[k - 1] / steps[k]) ** (order - 0.25)
        assert errors[k][0] <= max(errors[k - 1][0] / better, ROUNDING)
    # what is to be kept is missed by no more than the rates are: 5.8 kg in motion, radius 0.1 m, 200 J
    for error, momentum, moment, energy in errors:
        assert momentum <= 6.0 * error + ROUNDING
        assert moment <= 0.6 * error + ROUNDING
        assert energy <= 1.0 * error + ROUNDING


@pytest.mark.parametrize(("geared", "method", "form"), CONTROLLED)
def test_errors_follow_the_tolerance(geared, method, form):
    """A hundredth of the tolerance leaves a fifth of the error at most, and what is to be kept as well."""
    errors = [reached(geared, method, form, rtol) for rtol in TOLERANCES]
    for k in range(1, len(TOLERANCES)):
        assert errors[k][0] <= max(0.2 * errors[k - 1][0], ROUNDING)
    for error, momentum, moment, energy in errors:
        assert momentum <= 6.0 * error + ROUNDING
        assert moment <= 0.6 * error + ROUNDING
        assert energy <= 1.0 * error + ROUNDING
