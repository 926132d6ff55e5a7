# SPDX-License-Identifier: Apache-2.0
"""Condensed linear parts: forces by matrices, tangents against differences, whole turns, free rotation."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.elements import linear_part
from pitchpoint.multibody.bodies import FREE, TORSION, Body
from pitchpoint.solvers.gear_trains import free_spins
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import differences, positive

pytestmark = pytest.mark.nojit

SPINS = np.array([0.0] * 5 + [1.0] + [0.0] * 5 + [1.0] + [0.0])


def matrices(rng):
    """Mass, damping, stiffness of two shafts and one modal coordinate; turning together costs nothing."""
    M, D, K = (positive(rng, 13) for _ in range(3))
    P = np.eye(13) - np.outer(SPINS, SPINS) / 2.0
    K = P @ K @ P
    K[12, :12] = K[:12, 12] = 0.0
    return M, D, K


def part(rng):
    """System, matrices and the operating point."""
    bodies = [
        Body(motion=FREE, mass=2.0, polar_inertia=0.3, transverse_inertia=0.2, name="a"),
        Body(motion=FREE, mass=1.0, polar_inertia=0.2, transverse_inertia=0.15, name="b"),
        Body(motion=TORSION, polar_inertia=1.0, name="mode"),
    ]
    M, D, K = matrices(rng)
    x0, v0, f0 = 0.01 * rng.normal(size=(3, 13))
    rows: dict[str, list] = {"linear_part": [], "linear_modes": []}
    cuts = [slice(0, 6), slice(6, 12), slice(12, 13)]
    for i, at in enumerate(cuts, start=1):
        for j, by in enumerate(cuts, start=1):
            row = np.zeros(1, linear_part.RECORD)
            r = row[0]
            n, m = at.stop - at.start, by.stop - by.start
            r["i"], r["j"] = i, j
            r["M"][:n, :m], r["D"][:n, :m], r["K"][:n, :m] = M[at, by], D[at, by], K[at, by]
            r["x0"][:m], r["v0"][:m] = x0[by], v0[by]
            if i == j:
                r["f0"][:n] = f0[at]
            if i < 3 and j < 3:
                r["relative"], r["spin0"] = 1, x0[at.stop - 1]
            rows["linear_part" if max(i, j) < 3 else "linear_modes"].append(row)
    system = assemble(bodies, {kind: np.concatenate(r) for kind, r in rows.items()})
    order = [
        system.layout.coordinate(f"{b}.{c}") for b in "ab" for c in ("x", "y", "z", "alpha", "beta", "spin")
    ]
    order.append(system.layout.coordinate("mode.spin"))
    return system, (M, D, K), (x0, v0, f0), order


def test_forces_are_those_of_the_matrices():
    """At rest in space the bodies add their masses, which the translations show."""
    rng = np.random.default_rng(3)
    system, (M, D, K), (x0, v0, f0), order = part(rng)
    state = system.initial_state()
    state.q[order] = q = 0.02 * rng.normal(size=13)
    state.a[order] = a = rng.normal(size=13)
    found = evaluate.residual(system, state)[order]
    expected = f0 + M @ a - D @ v0 + K @ (q - x0)
    assert found[:3] == pytest.approx(expected[:3] + 2.0 * a[:3], rel=1e-12)
    assert found[12] == pytest.approx(expected[12] + a[12], rel=1e-12)


def test_tangents_are_derivatives():
    rng = np.random.default_rng(4)
    system, _, _, order = part(rng)
    state = system.initial_state()
    state.q[order] = 0.1 * rng.normal(size=13)
    state.v[order] = rng.normal(size=13)
    for key, exact in zip("avq", evaluate.linearize(system, state), strict=True):
        assert exact == pytest.approx(differences(system, state, key), abs=2e-7)


def test_turning_together_changes_nothing():
    rng = np.random.default_rng(5)
    system, _, _, order = part(rng)
    state = system.initial_state()
    state.q[order] = 0.02 * rng.normal(size=13)
    expected = evaluate.residual(system, state)
    state.turns[1:3] += 100_000
    assert evaluate.residual(system, state).tobytes() == expected.tobytes()
    state.turns[1] += 1
    assert np.abs(evaluate.residual(system, state) - expected).max() > 0.1
    state.turns[1] -= 1
    state.q[[system.spin("a"), system.spin("b")]] += 0.7 * math.pi
    assert evaluate.residual(system, state) == pytest.approx(expected, abs=1e-12)


def test_what_it_joins_turns_together():
    assert len(free_spins(part(np.random.default_rng(6))[0])) == 2  # both shafts as one, and the coordinate
