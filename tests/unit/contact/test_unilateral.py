# SPDX-License-Identifier: Apache-2.0
"""Unilateral contact of coupled nodes: independent solutions, and the properties of the only solution."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import lsq_linear, minimize

from pitchpoint.contact.local_approach import N_NODE, local_energy
from pitchpoint.contact.pivoting import pivot
from pitchpoint.contact.unilateral import solve_contact, solve_tangent, tangent_block
from pitchpoint.contact.unilateral_work import FORCE, LISTED, PENETRATION, ContactWorkspace
from pitchpoint.core.kernel import plain
from pitchpoint.core.status import NOT_FINITE, OK, SINGULAR
from tests.support.unilateral import (
    KINDS,
    Problem,
    Solved,
    enumerated,
    problem,
    random_problem,
    random_states,
    solve,
    with_nodes,
)

EXACT = 2e-12
"""Residual relative to the largest penetration: solutions end below 1e-12, which the check itself rounds."""

CYCLE = (
    np.array([[14.0, -12, -15, 7], [-12, 20, 22, 0], [-15, 22, 26, 0], [7, 0, 0, 10]]),
    np.array([1.0, 4.0, 6.0, 7.0]),
)
"""Matrix and penetrations for which exchanges of all infeasible nodes repeat; local compliance 1/64."""


def check(p: Problem, x: np.ndarray, solved: Solved) -> None:
    """Conditions of the solution, with the local approach in NumPy; they determine it."""
    f = solved.f
    assert np.all(solved.status == OK)
    assert np.all(f >= 0.0)
    w = p.gap(f, x)
    scale = np.maximum(x.max(axis=1), 0.0)
    limit = (EXACT * scale + 1e-15 * p.n * p.rounding(f, x))[:, None]
    assert np.all(w >= -limit)
    assert np.all(np.where(f > 0.0, np.abs(w), 0.0) <= limit)
    assert not f[scale == 0.0].any()


def smooth(n: int, rng: np.random.Generator) -> tuple[Problem, float]:
    """Problem like a flank: Hertzian nodes, coupling that decreases with the distance, 10 um."""
    p, _ = random_problem("smooth", n, True, rng)
    return with_nodes(replace(p, C=p.C / p.C.max() * 1e-8, node=p.node.copy())), 1e-5


# ---------------------------------------------------------------------------------- independent solutions


@pytest.mark.nojit
@pytest.mark.parametrize("hertzian", [False, True])
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("problems", [5, pytest.param(200, marks=pytest.mark.study)])
def test_small_problems_against_all_sets_of_nodes(kind, hertzian, problems):
    """Both solutions have residuals near 1e-13; forces amplify them by the condition of the problem."""
    rng = np.random.default_rng(KINDS.index(kind) + 100 * hertzian)
    for _ in range(problems):
        p, size = random_problem(kind, int(rng.integers(1, 8)), hertzian, rng)
        x = random_states(p.n, 3, size, rng)
        solved = solve(p, x)
        check(p, x, solved)
        for state, f in zip(x, solved.f, strict=True):
            if state.max() > 0.0:
                expected = enumerated(p, state)
                assert f == pytest.approx(expected, rel=0.0, abs=1e-11 * expected.max())


@pytest.mark.parametrize("kind", ["regular", "smooth"])
def test_linear_problems_against_bounded_least_squares(kind):
    """min |L^T f - L^-1 x|^2 over f >= 0 with A = L L^T."""
    rng = np.random.default_rng(3)
    for _ in range(20):
        p, size = random_problem(kind, int(rng.integers(10, 40)), False, rng)
        x = random_states(p.n, 1, size, rng)
        L = np.linalg.cholesky(p.C + np.diag(p.d))
        expected = lsq_linear(L.T, np.linalg.solve(L, x[0]), (0.0, np.inf), method="bvls", tol=1e-15).x
        # the condition number of A, up to 1e6, times the rounding of the square root
        assert solve(p, x).f[0] == pytest.approx(expected, abs=1e-8 * expected.max())


def objective(g, p, x, scales):
    """Function that the forces minimise, and its gradient; forces g in units of the first scale."""
    f = scales[0] * g
    psi = sum(plain(local_energy)(p.node, i, f[i]) for i in range(p.n))
    value = 0.5 * f @ p.C @ f + psi - x @ f
    return value / scales[1], (p.C @ f + p.approach(f) - x) * scales[0] / scales[1]


@pytest.mark.parametrize("n", [3, 30])
def test_energy_against_bounded_minimisation(n):
    """The solution minimises f.C f/2 + sum Psi - x.f; energies agree to second order of the error."""
    rng = np.random.default_rng(n)
    for _ in range(5):
        p, size = smooth(n, rng)
        x = size * (rng.standard_normal(n) + 0.5)
        scales = 100.0, 100.0 * size  # N, J
        found = minimize(
            objective,
            np.full(n, 0.5),
            args=(p, x, scales),
            jac=True,
            method="L-BFGS-B",
            bounds=[(0, None)] * n,
            options={"maxiter": 5000, "maxfun": 20000, "ftol": 0.0, "gtol": 1e-10},
        )
        solved = solve(p, x)
        assert -found.fun * scales[1] == pytest.approx(solved.energy[0], rel=1e-9)
        assert scales[0] * found.x == pytest.approx(solved.f[0], abs=1e-4 * solved.f.max())


# --------------------------------------------------------------------------------------------- many states


def batches(problems: int, states: int, seed: int) -> tuple[int, dict[str, int]]:
    """Check random states of all kinds, warm, and some from nothing; number of states, and counters."""
    rng = np.random.default_rng(seed)
    done, counts = 0, {"pivoted": 0, "blocks": 0, "singles": 0}
    for kind in KINDS:
        for hertzian in (False, True):
            for _ in range(problems):
                n = int(rng.integers(1, 25) if rng.random() < 0.9 else rng.integers(25, 90))
                p, size = random_problem(kind, n, hertzian, rng)
                x = random_states(n, states, size, rng)
                warm = solve(p, x)
                check(p, x, warm)
                part = slice(0, None, 10)
                cold = solve(p, x[part], warm=False)
                check(p, x[part], cold)
                # residuals of 1e-13; linear problems are solved to rounding times condition
                condition = np.linalg.cond(p.C + np.diag(p.d)) if not hertzian else 0.0
                limit = (1e-11 + 1e-15 * condition) * cold.f.max(axis=1, keepdims=True)
                assert np.all(np.abs(warm.f[part] - cold.f) <= limit)
                done += states
                for name in counts:
                    counts[name] += warm.count(name) + cold.count(name)
    return done, counts


def test_random_states():
    done, counts = batches(4, 300, seed=7)
    assert done == 19_200
    assert all(counts.values())


@pytest.mark.study
def test_a_million_random_states():
    done, counts = batches(126, 500, seed=8)
    assert done > 1_000_000
    assert all(counts.values())


@pytest.mark.nojit
def test_murty_ends_a_cycle_of_exchanges():
    C, x = CYCLE
    p = problem(C, np.full(4, 1.0 / 64.0))
    solved = solve(p, x)
    check(p, x[None], solved)
    assert solved.f[0] == pytest.approx(enumerated(p, x), rel=1e-13)
    assert solved.count("pivoted") == 1
    assert solved.count("blocks") > 0
    assert solved.count("singles") > 0


def test_no_exchanges_by_murty_for_flanks():
    """Coupling that decreases with the distance is solved by Newton's method alone."""
    rng = np.random.default_rng(5)
    for n in (5, 20, 55):
        p, size = smooth(n, rng)
        x = random_states(n, 1000, size, rng)
        solved = solve(p, x)
        check(p, x, solved)
        assert solved.count("pivoted") == 0
        assert solved.count("newton") < 12 * len(x)


# ------------------------------------------------------------------------------------- limits and failures


@pytest.mark.nojit
@pytest.mark.parametrize("hertzian", [False, True])
def test_limits(hertzian):
    """All apart, at zero, uncoupled, and all in contact."""
    rng = np.random.default_rng(2)
    p, size = random_problem("regular", 6, hertzian, rng)
    for x in (np.full(6, -size), np.zeros(6), np.array([0.0, -0.0, -size, 0.0, -size, -size])):
        solved = solve(p, x)
        assert solved.status[0] == OK
        assert not solved.f.any()
        assert solved.energy[0] == 0.0
    alone, _ = random_problem("none", 6, hertzian, rng)
    x = size * np.array([1.0, -1.0, 0.0, 1e-3, 1e-6, 1e-11])
    solved = solve(alone, x)
    check(alone, x[None], solved)
    assert (solved.f[0] > 0.0).tolist() == [True, False, False, True, True, True]
    x = p.C @ np.ones(6) * 1e3 + p.approach(np.full(6, 1e3))
    assert solve(p, x).f[0] == pytest.approx(1e3, rel=1e-11)


@pytest.mark.nojit
def test_no_nodes():
    work = ContactWorkspace.of(0)
    empty = np.zeros((0, 0)), np.zeros((0, N_NODE)), np.zeros(0)
    assert plain(solve_contact)(*empty, *work.arrays()) == OK
    assert work.state["m"][0] == 0


@pytest.mark.nojit
def test_node_within_rounding_of_contact_is_apart():
    p = problem(np.zeros((2, 2)), np.ones(2))
    assert solve(p, np.array([1.0, 1e-13])).f.tolist() == [[1.0, 0.0]]


@pytest.mark.nojit
def test_twins_share_the_force():
    """Twice the same node: C is singular, the local approach makes the solution unique."""
    rng = np.random.default_rng(1)
    p, size = random_problem("none", 1, True, rng)
    both = with_nodes(
        replace(
            p,
            C=np.full((2, 2), 1e-8),
            node=np.repeat(p.node, 2, axis=0),
            d=np.repeat(p.d, 2),
            length=np.repeat(p.length, 2),
            radius=np.repeat(p.radius, 2),
            depth=np.repeat(p.depth, 2, axis=1),
        )
    )
    solved = solve(both, np.full(2, size))
    assert solved.f[0, 0] == pytest.approx(solved.f[0, 1], rel=1e-12)
    check(both, np.full((1, 2), size), solved)


@pytest.mark.nojit
def test_singular_without_local_approach():
    p = problem(np.ones((2, 2)), np.zeros(2))
    solved = solve(p, np.array([[1.0, 2.0], [1.0, -1.0]]))
    assert solved.status.tolist() == [SINGULAR, OK]
    assert solved.f.tolist() == [[0.0, 0.0], [1.0, 0.0]]


@pytest.mark.nojit
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_numbers_that_are_not_finite(bad):
    """In penetrations, matrix or nodes, in contact or not; the next state is solved again."""
    rng = np.random.default_rng(4)
    p, size = smooth(4, rng)
    good = size * np.array([1.0, 0.5, -3.0, 0.2])
    expected = solve(p, good).f[0]
    work = ContactWorkspace.of(4)
    for i in range(4):
        x = good.copy()
        x[i] = bad
        solved = solve(p, np.array([good, x, good]), work=work)
        assert solved.status.tolist() == [OK, NOT_FINITE, OK]
        assert not solved.f[1].any()
        assert solved.f[2] == pytest.approx(expected, rel=1e-11)


@pytest.mark.nojit
@pytest.mark.parametrize("at", [(0, 0), (0, 1), (0, 2), (1, 0)])
def test_matrices_and_nodes_that_are_not_numbers(at):
    """Node 2 is apart: its overlap counts as well."""
    p, size = smooth(4, np.random.default_rng(4))
    x = size * np.array([1.0, 0.5, -3.0, 0.2])
    C, node = p.C.copy(), p.node.copy()
    C[at] = C[at[::-1]] = np.nan
    node[at] = np.nan
    for bad in (replace(p, C=C), replace(p, node=node)):
        solved = solve(bad, x)
        assert solved.status[0] == NOT_FINITE
        assert not solved.f.any()


def test_extreme_sizes():
    """Penetrations from far below the size of an atom to far beyond that of a gear."""
    rng = np.random.default_rng(6)
    p, _ = smooth(5, rng)
    direction = np.array([1.0, 0.3, -0.2, 0.7, 0.1])
    for size in (1e-40, 1e-20, 1e-12, 1e-3, 1e3, 1e9):
        x = size * direction
        check(p, x[None], solve(p, x))


# ---------------------------------------------------------------------------------------------- properties


@pytest.mark.parametrize("factor", [1e-3, 7.0])
def test_scaling(factor):
    """Linear: forces in proportion. Hertzian: if radii and depths grow with the penetrations, too."""
    rng = np.random.default_rng(8)
    for hertzian in (False, True):
        p, size = smooth(12, rng) if hertzian else random_problem("regular", 12, False, rng)
        x = random_states(12, 50, size, rng)
        x[:, 0] = np.abs(x[:, 0])
        scaled = replace(p, radius=factor * p.radius, depth=factor * p.depth, node=p.node.copy())
        large = solve(with_nodes(scaled), factor * x)
        small = solve(p, x)
        assert large.f / factor == pytest.approx(small.f, abs=1e-11 * small.f.max())
        assert large.energy / factor**2 == pytest.approx(small.energy, rel=1e-10)


def test_forces_are_monotone_in_the_penetrations():
    """(f(x) - f(y)).(x - y) >= 0, for any pair of states."""
    rng = np.random.default_rng(9)
    for kind in KINDS:
        for hertzian in (False, True):
            p, size = random_problem(kind, 10, hertzian, rng)
            x = random_states(10, 200, size, rng)
            f = solve(p, x).f
            step_f, step_x = np.diff(f, axis=0), np.diff(x, axis=0)
            product = (step_f * step_x).sum(axis=1)
            assert np.all(product >= -1e-11 * (np.abs(step_f) * np.abs(step_x)).sum(axis=1))


def test_forces_are_the_gradient_of_the_energy():
    """Central differences, across changes of the set of nodes as well: the energy is continuously
    differentiable, and its curvature is bounded."""
    rng = np.random.default_rng(10)
    p, size = smooth(8, rng)
    step = 1e-4 * size
    for _ in range(30):
        x = size * (rng.standard_normal(8) + 0.3)
        direction = rng.standard_normal(8)
        sides = solve(p, np.array([x + step * direction, x - step * direction]))
        slope = (sides.energy[0] - sides.energy[1]) / (2.0 * step)
        f = solve(p, x).f[0]
        change = np.abs(sides.f[0] - sides.f[1]) @ np.abs(direction)
        assert slope == pytest.approx(f @ direction, abs=0.02 * change + 1e-9 * f.max())


def test_energy_is_convex_and_starts_at_zero():
    rng = np.random.default_rng(11)
    p, size = smooth(6, rng)
    one, two = random_states(6, 100, size, rng), random_states(6, 100, size, rng)
    energies = [solve(p, x).energy for x in (one, two, 0.5 * (one + two))]
    assert np.all(energies[2] <= 0.5 * (energies[0] + energies[1]) * (1.0 + 1e-12) + 1e-30)
    assert np.all(energies[0] >= 0.0)


@pytest.mark.parametrize("stale", [True, False])
def test_tangent_is_the_derivative_of_the_forces(stale):
    """Exact after `tangent_block`; without it the factor of the last iterations, near by in this sequence."""
    rng = np.random.default_rng(12)
    p, size = smooth(9, rng)
    x = size * np.array([1.0, 0.8, 0.9, 0.7, -0.5, 1.1, 0.6, -0.4, 0.9])
    sequence = np.array([x * (1.0 + 1e-3 * k) for k in range(-5, 1)])
    solved = solve(p, sequence)
    state, on, v, U = solved.work.arrays()
    if not stale:
        assert tangent_block(p.C, state, on, v, U) == OK
        assert tangent_block(p.C, state, on, v, U) == OK
    m, direction = int(state["m"]), rng.standard_normal(9)
    b = np.zeros(16)
    b[:m] = direction[on[LISTED, :m]]
    solve_tangent(state, v, U, b)
    by_force = np.zeros(9)
    by_force[on[LISTED, :m]] = b[:m]
    step = 1e-5 * size
    sides = solve(p, np.array([x + step * direction, x - step * direction])).f
    found = (sides[0] - sides[1]) / (2.0 * step)
    assert by_force == pytest.approx(found, abs=(2e-2 if stale else 1e-7) * np.abs(found).max())


@pytest.mark.nojit
def test_tangent_is_exact_after_pivoting():
    """Pivoting ends with a factor of its last but one forces, whatever the factor before it was."""
    p, size = smooth(6, np.random.default_rng(13))
    x = size * np.array([1.0, 0.8, -0.4, 0.9, 0.7, -0.5])
    state, on, v, U = solve(p, x).work.arrays()
    assert tangent_block(p.C, state, on, v, U) == OK
    v[PENETRATION, :6] *= 1.0 + 1e-7
    assert plain(pivot)(p.C, p.node, 6, size, state, on, v, U) == OK
    assert tangent_block(p.C, state, on, v, U) == OK
    m = int(state["m"])
    inside = on[LISTED, :m]
    K = p.C[np.ix_(inside, inside)] + np.diag(p.slope(v[FORCE, :6])[inside])
    b = np.zeros(8)
    b[:m] = 1.0
    solve_tangent(state, v, U, b)
    assert b[:m] == pytest.approx(np.linalg.solve(K, np.ones(m)), rel=1e-12)
