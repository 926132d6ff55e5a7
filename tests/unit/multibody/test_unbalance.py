# SPDX-License-Identifier: Apache-2.0
"""Unbalance: against the whirl of a Laval rotor, and against a small body that is bolted on."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements import bearing
from pitchpoint.multibody.bodies import FIXED, FREE, PLANAR, Body
from pitchpoint.multibody.unbalance import with_point_mass
from pitchpoint.solvers.implicit.generalized_alpha import start
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import frame

M, U, R, K, D, J = 5.0, 0.02, 0.1, 2e5, 100.0, 1e3


def laval():
    """Heavy disc of 5 kg on a soft, damped bearing with 2 g m of unbalance; its spin hardly changes."""
    rotor = Body(motion=PLANAR, mass=M, polar_inertia=J, transverse_inertia=J, name="rotor")
    record = np.zeros(1, bearing.RECORD)
    record["i"], record["B"] = 1, np.eye(3)
    record["K"][0, 0, 0] = record["K"][0, 1, 1] = K
    record["D"][0, 0, 0] = record["D"][0, 1, 1] = D
    return assemble([with_point_mass(rotor, U, (R, 0.0, 0.0))], {"bearing": record})


@pytest.mark.parametrize("speed", [100.0, 199.0, 400.0])
def test_whirl_of_a_laval_rotor(speed):
    """x + i y = u exp(i W t), u = U r W^2/(K - (M + U) W^2 + i W D), below, at and above the resonance."""
    system = laval()
    state = system.initial_state()
    u = U * R * speed**2 / (K - (M + U) * speed**2 + 1j * speed * D)
    state.q[:2] = u.real, u.imag
    state.v[:] = (1j * speed * u).real, (1j * speed * u).imag, speed
    h, n = 2.0 * np.pi / speed / 400.0, 800
    run = start(system, state, h, rho_inf=1.0)
    run.advance(n)
    end = run.state()
    # two turns; second order, 400 steps a turn: (W h)^2/12 = 2e-5 per radian; the spin of J changes by 1e-6
    assert end.q[0] + 1j * end.q[1] == pytest.approx(u * np.exp(1j * speed * n * h), abs=5e-4 * abs(u))


def test_a_point_mass_is_a_small_body_that_is_bolted_on():
    rng = np.random.default_rng(4)
    axes, place = frame(rng), rng.normal(size=3)
    rotor = Body(
        motion=FREE, axes=axes, mass=2.0, polar_inertia=0.3, transverse_inertia=0.2, center=0.1, name="rotor"
    )
    bolt = Body(
        motion=FIXED,
        parent=1,
        position=axes @ place,
        axes=axes,
        mass=0.4,
        inertia=np.zeros((3, 3)),
        name="bolt",
    )
    one, two = assemble([with_point_mass(rotor, 0.4, place)], {}), assemble([rotor, bolt], {})
    state = one.initial_state()
    state.q, state.v, state.a = 0.4 * rng.normal(size=6), rng.normal(size=6), rng.normal(size=6)
    np.testing.assert_allclose(
        evaluate.residual(one, state), evaluate.residual(two, _like(two, state)), rtol=1e-12
    )
    for a, b in zip(evaluate.linearize(one, state), evaluate.linearize(two, _like(two, state)), strict=True):
        np.testing.assert_allclose(a, b, rtol=1e-11, atol=1e-11)


def _like(system, state):
    """The same coordinates for a system with another number of bodies."""
    other = system.initial_state()
    other.q, other.v, other.a = state.q, state.v, state.a
    return other
