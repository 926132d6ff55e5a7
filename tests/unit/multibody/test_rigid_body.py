# SPDX-License-Identifier: Apache-2.0
"""Rigid-body mechanics against closed forms: conservation, gyroscopic frequencies, linearisation."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.multibody.bodies import FREE, PLANAR, TORSION, Body
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import bearings, couplings, differences, frame, positive, rotor, torques


def momentum(system):
    """Energy, angular momentum about the world origin and momentum of a single free body."""
    w = system.workspace
    f, o = w.fr[1], system.program["body"][1]
    n = f["R"][:, 2]
    v, omega = f["tw"][:3], f["tw"][3:]
    c = o["c_z"] * n
    v_c = v + np.cross(omega, c)
    spin = o["i_t"] * omega + (o["i_p"] - o["i_t"]) * (n @ omega) * n
    energy = 0.5 * o["mass"] * v_c @ v_c + 0.5 * omega @ spin
    return energy, spin + np.cross(f["r"] + c, o["mass"] * v_c), o["mass"] * v_c


def flying(seed=3):
    rng = np.random.default_rng(seed)
    body = Body(
        motion=FREE,
        axes=frame(rng),
        mass=2.0,
        polar_inertia=0.3,
        transverse_inertia=0.2,
        center=0.1,
        name="a",
    )
    system = assemble([body], {})
    state = system.initial_state()
    state.v[:] = [0.3, -0.2, 0.1, 0.5, 0.4, 20.0]
    state.q[3:5] = [0.1, -0.2]
    return system, state


def test_free_flight_keeps_energy_and_both_momenta():
    system, state = flying()
    run = runge_kutta.start_adaptive(system, state, rtol=1e-11, atol=1e-12, atol_rate=1e-11)
    before = momentum(system)
    assert run.advance_to(0.1).status == OK
    evaluate.residual(system, run.state())
    for a, b in zip(before, momentum(system), strict=True):
        np.testing.assert_allclose(b, a, rtol=1e-8, atol=1e-9)


def test_implicit_method_keeps_the_energy_of_free_flight_to_its_order():
    errors = []
    for h in (2e-4, 1e-4):
        system, state = flying()
        run = generalized_alpha.start(system, state, h, rho_inf=1.0)
        before = momentum(system)[0]
        assert run.advance(round(0.1 / h)).status == OK
        evaluate.residual(system, run.state())
        errors.append(abs(momentum(system)[0] - before) / before)
    assert errors[1] < 1e-5
    assert errors[1] < 0.35 * errors[0]


@pytest.mark.nojit
@pytest.mark.parametrize("speed", [0.0, 50.0, 500.0])
def test_gyroscopic_whirl_frequencies_are_those_of_the_closed_form(speed):
    # i_t w^2 -+ i_p speed w - k = 0: forward and backward whirl of a rotor on a tilting spring
    k, i_p, i_t = 4000.0, 0.3, 0.2
    system = rotor(k, i_p=i_p, i_t=i_t)
    state = system.initial_state()
    state.v[5] = speed
    M, D, K = evaluate.linearize(system, state)
    tilt = slice(3, 5)
    M, D, K = M[tilt, tilt], D[tilt, tilt], K[tilt, tilt]
    A = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]])
    found = np.sort(np.unique(np.round(np.abs(np.linalg.eigvals(A).imag), 7)))
    half = i_p * speed / (2.0 * i_t)
    root = np.sqrt(half**2 + k / i_t)
    np.testing.assert_allclose(found, sorted({round(root - half, 7), round(root + half, 7)}), rtol=1e-6)


def test_free_spinning_rotor_nutates_with_the_ratio_of_its_inertias():
    system = rotor(0.0, i_p=0.3, i_t=0.2)
    state = system.initial_state()
    state.v[3], state.v[5] = 1e-3, 100.0
    run = generalized_alpha.start(system, state, 1e-5, rho_inf=1.0)
    chunk = run.advance(20000, every=10)
    assert chunk.status == OK
    names = [c.name for c in system.layout.channels]
    x = chunk.rows[:, 1 + names.index("displacement[rotor.rx]")]
    t = chunk.rows[:, 0]
    x = x - x.mean()
    up = np.flatnonzero((x[:-1] < 0.0) & (x[1:] >= 0.0))
    times = t[up] - x[up] * (t[up + 1] - t[up]) / (x[up + 1] - x[up])
    omega = 2.0 * np.pi * (times.size - 1) / (times[-1] - times[0])
    assert omega == pytest.approx(0.3 * 100.0 / 0.2, rel=1e-4)


def machine(seed=1):
    rng = np.random.default_rng(seed)

    def body(motion, name):
        return Body(
            motion=motion,
            axes=frame(rng),
            position=rng.normal(size=3),
            mass=2.0,
            polar_inertia=0.3,
            transverse_inertia=0.2,
            center=0.11,
            name=name,
        )

    bodies = [body(FREE, "a"), body(FREE, "b"), body(TORSION, "c"), body(PLANAR, "d")]
    records = bearings([(i, 0, positive(rng), 0.1 * positive(rng)) for i in (1, 2, 4)])
    records["K"][:, 5, :] = records["K"][:, :, 5] = 0.0
    records["zi"], records["zj"] = 0.13, 0.05
    records["u0"] = 0.1 * rng.normal(size=(3, 6))
    for record in records:
        record["B"] = frame(rng)
    links = couplings([(3, 4, 30.0, 0.3, 0.0)])
    system = assemble(
        bodies, {"bearing": records, "coupling": links, "torque": torques([(1, 3.0), (3, 2.0)])}
    )
    state = system.initial_state()
    n = system.sizes["nd"]
    state.q, state.v, state.a = 0.3 * rng.normal(size=n), rng.normal(size=n), rng.normal(size=n)
    return system, state


@pytest.mark.nojit
@pytest.mark.parametrize(("key", "which"), [("a", 0), ("v", 1), ("q", 2)])
def test_exact_matrices_are_the_derivatives_of_the_residual(key, which):
    # anywhere, not only at equilibrium: large tilts, rates and accelerations
    system, state = machine()
    found = evaluate.linearize(system, state)[which]
    expected = differences(system, state, key)
    assert np.abs(found - expected).max() < 1e-8 * np.abs(expected).max()
