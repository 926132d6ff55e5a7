# SPDX-License-Identifier: Apache-2.0
"""Approach under a given total force: closed forms, a scalar search around fixed approaches, random loads."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import brentq

from pitchpoint.contact.local_approach import N_NODE
from pitchpoint.contact.unilateral import solve_tangent, tangent_block
from pitchpoint.contact.unilateral_load import solve_load
from pitchpoint.contact.unilateral_work import LISTED, ContactWorkspace
from pitchpoint.core.kernel import plain
from pitchpoint.core.status import NOT_FINITE, OK, REFUSED
from tests.support.unilateral import KINDS, Problem, problem, random_problem, solve, with_nodes


def check(p: Problem, gap, weight, load, solved) -> None:
    """Conditions of contact at the approach, and the total force."""
    assert np.all(solved.status == OK)
    assert np.all(solved.f >= 0.0)
    assert solved.f @ weight == pytest.approx(load, rel=1e-11)
    x = weight * solved.approach[:, None] - gap
    w = p.gap(solved.f, x)
    limit = 2e-12 * x.max(axis=1) + 1e-15 * p.n * p.rounding(solved.f, x)
    limit = (limit + 1e-15 * np.abs(gap).max(axis=1))[
        :, None
    ]  # approaches are rounded at the size of the gaps
    assert np.all(w >= -limit)
    assert np.all(np.where(solved.f > 0.0, np.abs(w), 0.0) <= limit)


def springs(gap: np.ndarray, weight: np.ndarray, d: float, load: float) -> float:
    """Approach of uncoupled equal springs: sum of p (p X - g)/d over those with p X > g is the load."""
    order = np.argsort(gap / weight)
    g, p = gap[order], weight[order]
    for k in range(1, len(g) + 1):
        X = (load * d + p[:k] @ g[:k]) / (p[:k] @ p[:k])
        if k == len(g) or X * p[k] <= g[k]:
            break
    return X


@pytest.mark.nojit
def test_uncoupled_springs():
    rng = np.random.default_rng(0)
    p = problem(np.zeros((7, 7)), np.full(7, 2e-9))
    gap, weight = 1e-5 * rng.standard_normal((6, 7)), rng.uniform(0.5, 1.0, 7)
    load = 10.0 ** np.linspace(-6.0, 6.0, 6)
    solved = solve(p, gap, weight=weight, load=load)
    check(p, gap, weight, load, solved)
    expected = [springs(g, weight, 2e-9, F) for g, F in zip(gap, load, strict=True)]
    assert solved.approach == pytest.approx(expected, rel=1e-13)


@pytest.mark.parametrize("load", [1e-12, 1.0, 3e3, 1e6])
def test_search_around_fixed_approaches(load):
    """Root of the load over the approach with solutions at fixed penetrations; helical weight cos(beta_b)."""
    rng = np.random.default_rng(1)
    p, _ = random_problem("smooth", 9, True, rng)
    p = with_nodes(replace(p, C=p.C / p.C.max() * 1e-8, node=p.node.copy()))
    gap, weight = 1e-5 * rng.uniform(0.0, 1.0, 9), np.full(9, np.cos(0.3))
    gap -= gap.min()  # so that the approach is not rounded at the size of a gap
    solved = solve(p, gap, weight=weight, load=[load])
    check(p, gap[None], weight, load, solved)

    def missing(X):
        return solve(p, weight * X - gap).f[0] @ weight - load

    assert solved.approach[0] == pytest.approx(brentq(missing, 0.0, 1.0, xtol=1e-300, rtol=1e-14), rel=1e-10)


def batches(problems: int, loads: int, seed: int) -> tuple[int, int]:
    """Check random loads of all kinds, warm and from nothing; numbers of loads and of searches."""
    rng = np.random.default_rng(seed)
    done, searches = 0, 0
    for kind in KINDS:
        for hertzian in (False, True):
            for _ in range(problems):
                p, size = random_problem(kind, int(rng.integers(1, 40)), hertzian, rng)
                gap = size * (rng.standard_normal((loads, p.n)) + rng.standard_normal((loads, 1)))
                weight = np.ones(p.n) if rng.random() < 0.5 else rng.uniform(0.5, 1.0, p.n)
                softness = p.slope(np.full(p.n, 100.0)) + np.diag(p.C)
                load = size / np.median(softness) * 10.0 ** rng.uniform(-3.0, 2.0, loads)
                both = [solve(p, gap, weight=weight, load=load, warm=warm) for warm in (True, False)]
                for solved in both:
                    check(p, gap, weight, load, solved)
                    searches += solved.count("searches")
                condition = 0.0 if hertzian else np.linalg.cond(p.C + np.diag(p.d))
                limit = 1e-11 + 1e-15 * condition
                largest = both[0].f.max(axis=1, keepdims=True)
                assert np.all(np.abs(both[0].f - both[1].f) <= limit * largest)
                done += 2 * loads
    return done, searches


def test_random_loads():
    done, searches = batches(3, 100, seed=2)
    assert done == 9600
    assert searches > 0


@pytest.mark.study
def test_many_random_loads():
    done, searches = batches(100, 100, seed=3)
    assert done == 320_000
    assert searches > 0


@pytest.mark.nojit
def test_first_contact_and_tiny_loads():
    """Without load: first contact. A load too small to move the approach by its rounding is still carried."""
    rng = np.random.default_rng(4)
    p, _ = random_problem("none", 3, True, rng)
    gap, weight = np.array([3e-3, 1e-3, 2.5e-3]), np.array([1.0, 0.5, 1.0])
    solved = solve(p, np.array([gap, gap]), weight=weight, load=[0.0, 1e-12])
    assert solved.status.tolist() == [OK, OK]
    assert solved.approach == pytest.approx([2e-3, 2e-3], rel=1e-15)
    assert solved.f.tolist() == [[0.0, 0.0, 0.0], [0.0, 2e-12, 0.0]]


@pytest.mark.nojit
@pytest.mark.parametrize(
    ("gap", "weight", "load", "status"),
    [
        ([0.0, 1.0], [1.0, 1.0], -1.0, REFUSED),
        ([0.0, 1.0], [1.0, 0.0], 1.0, REFUSED),
        ([0.0, 1.0], [1.0, -1.0], 1.0, REFUSED),
        ([0.0, np.nan], [1.0, 1.0], 1.0, NOT_FINITE),
        ([0.0, np.inf], [1.0, 1.0], 1.0, NOT_FINITE),
        ([0.0, 1.0], [1.0, np.nan], 1.0, NOT_FINITE),
        ([0.0, 1.0], [1.0, 1.0], np.inf, NOT_FINITE),
        ([0.0, 1.0], [1.0, 1.0], np.nan, NOT_FINITE),
    ],
)
def test_wrong_values_have_a_status(gap, weight, load, status):
    p = problem(np.zeros((2, 2)), np.ones(2))
    solved = solve(p, np.array([gap]), weight=np.array(weight), load=[load])
    assert solved.status[0] == status
    assert not solved.f.any()
    assert solved.approach[0] == 0.0


@pytest.mark.nojit
def test_load_without_nodes():
    none = np.zeros(0)
    arrays = ContactWorkspace.of(0).arrays()
    assert plain(solve_load)(np.zeros((0, 0)), np.zeros((0, N_NODE)), none, none, 1.0, *arrays) == REFUSED


def test_stiffness_and_work_of_the_load():
    """dX/dF from the tangent matrix, and F dX = d(stored energy) by differences."""
    rng = np.random.default_rng(5)
    p, _ = random_problem("smooth", 12, True, rng)
    p = with_nodes(replace(p, C=p.C / p.C.max() * 1e-8, node=p.node.copy()))
    gap, weight = 1e-5 * np.linspace(-1.0, 1.0, 12) ** 2, rng.uniform(0.8, 1.0, 12)
    F, step = 2e3, 0.1
    sides = solve(p, np.array([gap, gap]), weight=weight, load=[F - step, F + step])
    rise = sides.approach[1] - sides.approach[0]
    solved = solve(p, gap, weight=weight, load=[F])
    state, on, v, U = solved.work.arrays()
    assert tangent_block(p.C, state, on, v, U) == OK
    m = int(state["m"])
    b = np.zeros(16)
    b[:m] = weight[on[LISTED, :m]]
    solve_tangent(state, v, U, b)
    stiffness = b[:m] @ weight[on[LISTED, :m]]
    assert 2.0 * step / rise == pytest.approx(stiffness, rel=1e-6)
    assert (sides.energy[1] - sides.energy[0]) / rise == pytest.approx(F, rel=1e-6)
