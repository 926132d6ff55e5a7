# SPDX-License-Identifier: Apache-2.0
"""Springs, dampers and Maxwell elements along a line: potential, tangents, balance, closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.formula.formula import Formula
from pitchpoint.core.status import NOT_FINITE
from pitchpoint.elements import maxwell, spring_damper
from pitchpoint.elements import signal as sig
from pitchpoint.elements.gravity import gravity_records
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FLOATING, PRISMATIC
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.explicit.runge_kutta import start_classical
from pitchpoint.solvers.implicit.generalized_alpha import start
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.forces import (
    ENDS,
    along,
    check_balance,
    check_matrices,
    mechanism,
    moved_world,
    moving,
    power,
    wrenches,
)


def spring(rng, i, j, **numbers):
    record = np.zeros(1, spring_damper.RECORD)
    record["i"], record["j"] = i, j
    record["p_i"], record["p_j"] = 0.2 * rng.normal(size=(2, 3))
    for name, value in numbers.items():
        record[name] = value
    return record


def length(system, record, state):
    """Distance of both points and their velocity of approach, from the frames alone."""
    wrenches(system, state)
    ends = []
    for end in "ij":
        f = system.workspace.fr[int(record[end][0])]
        S = np.eye(3) if record[end][0] == 0 else f["S"]
        ends.append(f["r"] + S @ record["p_" + end][0])
    return np.linalg.norm(ends[0] - ends[1])


@pytest.mark.nojit
@pytest.mark.parametrize(("i", "j"), ENDS)
def test_spring_and_damper_anywhere_in_a_tree(i, j):
    rng = np.random.default_rng(10 * i + j)
    record = spring(rng, i, j, free=0.3, k=50.0, d=3.0)
    system = assemble(mechanism(rng), {"spring_damper": record})
    state = moving(system, rng)
    check_matrices(system, state)
    check_balance(system, state)
    # power = -d(k x^2 / 2)/dt - d w^2
    h = 1e-4
    near, far = (length(system, record, along(system, state, s * h)) for s in (-1.0, 1.0))
    x, rate = length(system, record, state) - 0.3, (far - near) / (2.0 * h)
    assert power(system, state) == pytest.approx(-50.0 * x * rate - 3.0 * rate**2, rel=1e-6)


@pytest.mark.parametrize("form", ["table", "formula", "both"])
def test_laws_of_elongation_and_rate(form):
    rng = np.random.default_rng(3)
    record, pool, law = spring(rng, 2, 3, free=0.2), sig.Pool(), None
    if form == "table":
        sig.set_table(record[0], pool, [-1.0, 0.0, 5.0], [-80.0, 0.0, 900.0], sig.OVER_ANGLE)
        expected = lambda x, w: 180.0 * x if x > 0.0 else 80.0 * x  # noqa: E731
    elif form == "formula":
        sig.set_formula(
            record[0], pool, Formula.parse("40*angle^3 + 5*speed*angle^2", ("t", "angle", "speed"))
        )
        expected = lambda x, w: 40.0 * x**3 + 5.0 * w * x * x  # noqa: E731
    else:
        sig.set_law(record[0], pool, (30.0,), sig.OVER_BOTH)
        law = lambda t, x, p: p[0] * x + 2.0 * p[1] * x * x  # noqa: E731
        expected = lambda x, w: 30.0 * x + 2.0 * w * x * x  # noqa: E731
    system = assemble(
        mechanism(rng),
        {"spring_damper": record},
        pools={"spring_damper": pool.array()},
        laws={"spring_damper": [law]},
    )
    state = moving(system, rng)
    check_matrices(system, state)
    h = 1e-5
    near, far = (length(system, record, along(system, state, s * h)) for s in (-1.0, 1.0))
    x, rate = length(system, record, state) - 0.2, (far - near) / (2.0 * h)
    found = evaluate.observe(system, state)
    assert found[system.layout.channel("tension[spring_damper0]")] == pytest.approx(
        expected(x, rate), rel=1e-8
    )
    assert found[system.layout.channel("elongation[spring_damper0]")] == pytest.approx(x)


def test_a_spring_moves_with_the_world():
    rng = np.random.default_rng(6)
    bodies = mechanism(rng)
    record = spring(rng, 3, 0, free=0.2, k=70.0, d=2.0)
    one = assemble(bodies, {"spring_damper": record})
    state = moving(one, rng)
    moved, turn, shift = moved_world(bodies, rng)
    other = record.copy()
    other["p_j"] = turn @ record["p_j"][0] + shift
    two = assemble(moved, {"spring_damper": other})
    np.testing.assert_allclose(evaluate.residual(two, state), evaluate.residual(one, state), atol=1e-12)


@pytest.mark.nojit
@pytest.mark.parametrize("free", [0.0, 0.1])
def test_points_that_coincide_divide_by_nothing(free):
    """Free length zero is a spring in all directions; otherwise the force has no direction and is zero."""
    body = Body(motion=FLOATING, mass=1.0, inertia=np.eye(3))
    record = np.zeros(1, spring_damper.RECORD)
    record["i"], record["k"], record["d"], record["free"] = 1, 50.0, 1.0, free
    system = assemble([body], {"spring_damper": record})
    state = system.initial_state()
    assert not np.any(evaluate.residual(system, state))
    state.v[0] = 1.0
    assert np.all(np.isfinite(evaluate.residual(system, state)))
    K = evaluate.linearize(system, state)[2]
    assert np.all(np.isfinite(K))
    if free == 0.0:
        np.testing.assert_allclose(np.diag(K)[:3], 50.0)


def test_a_law_without_a_number_is_reported():
    rng = np.random.default_rng(6)
    record, pool = spring(rng, 3, 0, free=0.2), sig.Pool()
    sig.set_law(record[0], pool, (), sig.OVER_ANGLE)
    system = assemble(
        mechanism(rng),
        {"spring_damper": record},
        pools={"spring_damper": pool.array()},
        laws={"spring_damper": [lambda t, x, p: float("nan")]},
    )
    with pytest.raises(Exception, match="spring damper 1") as caught:
        evaluate.residual(system, system.initial_state())
    assert caught.value.status == NOT_FINITE


def series(i, j, k, stiffness, damping):
    record = np.zeros(1, maxwell.RECORD)
    record["i"], record["j"], record["k"] = i, j, k
    record["stiffness"], record["damping"] = stiffness, damping
    return record


@pytest.mark.nojit
@pytest.mark.parametrize(("i", "j"), ENDS)
def test_maxwell_elements_anywhere_in_a_tree(i, j):
    rng = np.random.default_rng(20 * i + j)
    record = series(i, j, 5, 50.0, 3.0)
    record["p_i"], record["p_j"] = 0.2 * rng.normal(size=(2, 3))
    system = assemble(mechanism(rng, states=1), {"maxwell": record})
    state = moving(system, rng)
    check_matrices(system, state)
    check_balance(system, state)
    # power = -d(T^2/2k)/dt - T^2/d: spring and damper carry the same tension
    tension, c, k = state.v[system.spin("state0")], 3.0, 50.0
    change = wrenches(system, state)[5, 3:] @ system.workspace.fr[5]["R"][:, 2]
    assert power(system, state) == pytest.approx(-tension * change / k - tension**2 / c, rel=1e-10)


def test_relaxation_against_the_closed_form():
    """A mass between a wall and a Maxwell element: cubic characteristic polynomial, exact modal sum."""
    m, k, c = 2.0, 800.0, 30.0
    bodies = [
        Body(motion=PRISMATIC, position=(0.0, 0.0, 1.0), mass=m, inertia=np.eye(3), name="mass"),
        Body(polar_inertia=1.0, name="state0"),
    ]
    system = assemble(bodies, {"maxwell": series(1, 0, 2, k, c)})
    state = system.initial_state()
    state.v[0] = 0.5
    h, n = 1e-4, 5000
    run = start(system, state, h, rho_inf=1.0)
    run.advance(n)
    # z' = v, v' = -T/m, T' = k (v - T/c)
    A = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, -1.0 / m], [0.0, k, -k / c]])
    values, modes = np.linalg.eig(A)
    z, v, T = ((modes * np.exp(values * n * h)) @ np.linalg.solve(modes, [0.0, 0.5, 0.0])).real
    end = run.state()
    # second order: (omega h)^2/12 times the number of radians is below 1e-5
    np.testing.assert_allclose([end.q[0], end.v[0], end.v[1]], [z, v, T], rtol=2e-5)


def test_a_standard_linear_solid_in_equilibrium_modes_and_explicit_steps():
    """Weight on a spring, a damper and a Maxwell element: at rest the latter carries nothing.

    About the rest position m z'' + d z' + k z + T = 0, T' = K (z' - T/c): a cubic with three roots.
    """
    m, k, d, K, c, g = 2.0, 100.0, 3.0, 500.0, 20.0, 9.81
    bodies = [
        Body(motion=PRISMATIC, position=(0.0, 0.0, 1.0), mass=m, inertia=np.eye(3), name="mass"),
        Body(polar_inertia=1.0, name="state0"),
    ]
    record = np.zeros(1, spring_damper.RECORD)
    record["i"], record["k"], record["d"], record["free"] = 1, k, d, 1.5
    banks = {
        "spring_damper": record,
        "maxwell": series(1, 0, 2, K, c),
        "gravity": gravity_records(bodies[:1], (0.0, 0.0, -g)),
    }
    system = assemble(bodies, banks)
    rest = find_equilibrium(system).state
    np.testing.assert_allclose(rest.q, [0.5 - m * g / k, 0.0], atol=1e-12)
    M, D, stiff = evaluate.linearize(system, rest)
    A = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, stiff), -np.linalg.solve(M, D)]])
    cubic = [1.0, K / c + d / m, (k + K) / m + K * d / (c * m), k * K / (c * m)]
    wanted = np.append(np.roots(cubic), 0.0)  # the integral of the state is free
    np.testing.assert_allclose(np.sort_complex(np.linalg.eigvals(A)), np.sort_complex(wanted), atol=1e-9)
    state = rest.copy()
    state.v[0] = 0.1
    run = start_classical(system, state, 1e-3)
    run.advance(500)
    B = np.array([[0.0, 1.0, 0.0], [-k / m, -d / m, -1.0 / m], [0.0, K, -K / c]])
    values, modes = np.linalg.eig(B)
    z, v, T = ((modes * np.exp(values * 0.5)) @ np.linalg.solve(modes, [0.0, 0.1, 0.0])).real
    end = run.state()
    # fourth order: (15 rad/s * 1e-3 s)^4 = 5e-8
    np.testing.assert_allclose([end.q[0] - rest.q[0], end.v[0], end.v[1]], [z, v, T], rtol=1e-7, atol=1e-10)
