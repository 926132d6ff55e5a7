# SPDX-License-Identifier: Apache-2.0
"""Random contact problems, batches of them in compiled loops, and an independent solution in plain NumPy."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.local_approach import N_NODE, PAIR_MATERIAL, D, set_node
from pitchpoint.contact.unilateral import contact_energy, solve_contact
from pitchpoint.contact.unilateral_load import solve_load
from pitchpoint.contact.unilateral_work import CONTACT_STATE, FORCE, N_VECTOR, ContactWorkspace, forget
from pitchpoint.core.kernel import invoke, kernel, view

Array = NDArray[np.float64]
F8, I8 = np.dtype("f8"), np.dtype("i8")

_ARRAYS = ("C", "node", "x", "weight", "load", "f", "approach", "energy", "status", "state", "on", "v", "U")

#: One batch: sizes, whether each state starts from the one before, and addresses; weight 0: no loads.
BATCH = np.dtype([(name, "i8") for name in ("n", "w", "warm", *_ARRAYS)], align=True)


@kernel
def batch_entry(ctl, rec, n):
    """Solve n states in sequence; x are penetrations, or gaps if there are loads."""
    b = view(ctl, 1, BATCH)[0]
    size, w = b["n"], b["w"]
    C = view(b["C"], (size, size), F8)
    node = view(b["node"], (size, N_NODE), F8)
    x = view(b["x"], (n, size), F8)
    weight = view(b["weight"], size, F8)
    load = view(b["load"], n, F8)
    f = view(b["f"], (n, size), F8)
    approach = view(b["approach"], n, F8)
    energy = view(b["energy"], n, F8)
    status = view(b["status"], n, I8)
    state = view(b["state"], 1, CONTACT_STATE)[0]
    on = view(b["on"], (2, w), I8)
    v = view(b["v"], (N_VECTOR, w), F8)
    U = view(b["U"], (w, w), F8)
    for k in range(n):
        if b["warm"] == 0:
            forget(size, state, v)
        if b["weight"] == 0:
            status[k] = solve_contact(C, node, x[k], state, on, v, U)
        else:
            status[k] = solve_load(C, node, x[k], weight, load[k], state, on, v, U)
            approach[k] = state["approach"]
        energy[k] = contact_energy(node, state, on, v)
        for i in range(size):
            f[k, i] = v[FORCE, i]
    return 1


@dataclass(frozen=True)
class Problem:
    """Compliance matrix and nodes, and the values of the nodes for the formulas in NumPy."""

    C: Array
    node: Array
    d: Array
    length: Array
    radius: Array
    depth: Array
    bodies: tuple[tuple[float, float], tuple[float, float]]
    hertzian: bool

    @property
    def n(self) -> int:
        """Number of nodes."""
        return len(self.C)

    def _terms(self, f: Array):
        """2 c/pi, depth, nu/(1 - nu) of both bodies, and the half width."""
        c = [(1.0 - nu * nu) / E for E, nu in self.bodies]
        width = np.sqrt(4.0 * np.abs(f) / self.length * self.radius * sum(c) / math.pi)
        for k in (0, 1):
            nu = self.bodies[k][1]
            yield 2.0 * c[k] / math.pi, self.depth[k], nu / (1.0 - nu), np.maximum(width, 1e-130)

    def approach(self, f: Array) -> Array:
        """Local approach by the formula, nodes in the last axis."""
        total = self.d * f
        if self.hertzian:
            for a, t, kappa, b in self._terms(f):
                bracket = np.arcsinh(t / b) - kappa * t / (np.hypot(t, b) + t)
                total = total + a * f / self.length * bracket
        return total

    def slope(self, f: Array) -> Array:
        """Its derivative."""
        total = self.d + 0.0 * f
        if self.hertzian:
            for a, t, kappa, b in self._terms(f):
                total = total + a / self.length * (
                    np.arcsinh(t / b) - 0.5 * (1.0 + kappa) * t / np.hypot(t, b)
                )
        return total

    def gap(self, f: Array, x: Array) -> Array:
        """Gaps w = C f + h(f) - x, states in rows."""
        return f @ self.C + self.approach(f) - x

    def rounding(self, f: Array, x: Array) -> Array:
        """Largest absolute term of each gap: what rounding errors are proportional to."""
        return np.maximum((np.abs(f) @ np.abs(self.C)).max(axis=1), np.abs(x).max(axis=1))


def problem(C: Array, d: Array, rng: np.random.Generator | None = None) -> Problem:
    """Problem of a matrix and linear local compliances; with a generator, Hertzian nodes of random sizes."""
    n = len(C)
    node = np.zeros((n, N_NODE))
    node[:, D] = d
    length, radius, depth = np.ones(n), np.ones(n), np.ones((2, n))
    bodies = (206e9, 0.3), (206e9, 0.3)
    if rng is not None:
        bodies = (206e9, 0.3), (float(rng.choice([206e9, 110e9])), float(rng.uniform(0.2, 0.4)))
        length, radius = rng.uniform(0.2e-3, 3e-3, n), 10.0 ** rng.uniform(-3.0, -1.0, n)
        depth = rng.uniform(0.5e-3, 5e-3, (2, n))
    return with_nodes(
        Problem(np.ascontiguousarray(C), node, np.array(d), length, radius, depth, bodies, rng is not None)
    )


def with_nodes(p: Problem) -> Problem:
    """The problem with its nodes set from its values."""
    if p.hertzian:
        material = np.zeros(1, PAIR_MATERIAL)[0]
        material["c"] = [(1.0 - nu * nu) / E for E, nu in p.bodies]
        material["kappa"] = [nu / (1.0 - nu) for _, nu in p.bodies]
        for i in range(p.n):
            set_node(p.node, i, p.length[i], p.radius[i], (p.depth[0, i], p.depth[1, i]), material, p.d[i])
    return p


@dataclass(frozen=True)
class Solved:
    """Results of a batch, states in rows."""

    f: Array
    approach: Array
    energy: Array
    status: NDArray[np.int64]
    work: ContactWorkspace

    def count(self, name: str) -> int:
        """Counter of the solver."""
        return int(self.work.state[name][0])


def solve(
    p: Problem,
    x: Array,
    *,
    warm: bool = True,
    load: Array | None = None,
    weight: Array | None = None,
    work: ContactWorkspace | None = None,
) -> Solved:
    """Forces of states with the penetrations x; with loads, x are gaps."""
    x = np.ascontiguousarray(np.atleast_2d(x), dtype=float)
    many, work = len(x), work or ContactWorkspace.of(p.n)
    solved = Solved(np.zeros_like(x), np.zeros(many), np.zeros(many), np.zeros(many, np.int64), work)
    load = np.zeros(many) if load is None else np.array(load, dtype=float)
    arrays = {"C": p.C, "node": p.node, "x": x, "load": load, **vars(solved), **vars(work)}
    if weight is not None:
        arrays["weight"] = np.array(weight, dtype=float)
    b = np.zeros(1, BATCH)
    b["n"], b["w"], b["warm"] = p.n, work.U.shape[0], warm
    for name in _ARRAYS:
        if name in arrays:
            b[name] = arrays[name].ctypes.data
    invoke(batch_entry, b.ctypes.data, 0, many)
    return solved


# --------------------------------------------------------------------------------------- random problems

KINDS = ("regular", "ill", "low rank", "twins", "scaled", "smooth", "none", "rank one")


def matrix(kind: str, n: int, rng: np.random.Generator) -> Array:
    """Symmetric positive semidefinite matrix of a kind."""
    A = rng.standard_normal((n, n))
    if kind == "regular":
        return A @ A.T
    if kind == "ill":  # condition number up to 1e8
        Q = np.linalg.qr(A)[0]
        return Q * np.logspace(0.0, -rng.uniform(2.0, 8.0), n) @ Q.T
    if kind == "low rank":
        return A[:, : max(1, n // 3)] @ A[:, : max(1, n // 3)].T
    if kind == "twins":  # some nodes twice
        chosen = rng.integers(0, max(1, n // 2), n)
        return (A @ A.T)[np.ix_(chosen, chosen)]
    if kind == "scaled":  # stiffness ratios up to 1e12
        scale = 10.0 ** rng.uniform(-3.0, 3.0, n)
        return A @ A.T * np.outer(scale, scale)
    if kind == "smooth":  # as a flank: positive, decreasing with the distance
        z = np.sort(rng.uniform(0.0, 1.0, n))
        return np.exp(-np.abs(z[:, None] - z) / 10.0 ** rng.uniform(-2.0, 1.0))
    return np.outer(A[0] ** 2, A[0] ** 2) if kind == "rank one" else np.zeros((n, n))


def random_problem(kind: str, n: int, hertzian: bool, rng: np.random.Generator) -> tuple[Problem, float]:
    """Problem of a kind and the size of its penetrations: that of flanks if Hertzian, else 1."""
    C = matrix(kind, n, rng)
    if not hertzian:
        return problem(C, 10.0 ** rng.uniform(-4.0, 0.0, n)), 1.0
    d = np.zeros(n) if rng.random() < 0.5 else 10.0 ** rng.uniform(-11.0, -9.0, n)
    return problem(C * 10.0 ** rng.uniform(-10.0, -8.0), d, rng), 10.0 ** rng.uniform(-9.0, -4.0)


def random_states(n: int, many: int, size: float, rng: np.random.Generator) -> Array:
    """Penetrations: all apart, all in contact and everything between; a third of the sets of any size."""
    x = size * (rng.standard_normal((many, n)) + rng.uniform(-2.0, 2.0, (many, 1)))
    return x * 10.0 ** rng.uniform(-6.0, 0.0, (many, 1)) if rng.random() < 0.3 else x


# ----------------------------------------------------------------------------------- independent solution


def enumerated(p: Problem, x: Array) -> Array:
    """Forces by Newton's method over linear problems, each solved by trying all sets of nodes.

    Every set in contact is solved with a dense solver; the one without tension and overlap is taken.
    """
    sets = np.array(list(product((False, True), repeat=p.n)))
    both = sets[:, :, None] & sets[:, None, :]
    f = np.zeros(p.n)
    for _ in range(60):
        slope = p.slope(f)
        M = p.C + np.diag(slope)
        target = x - p.approach(f) + slope * f
        inside = np.where(both, M, np.eye(p.n))
        forces = np.linalg.solve(inside, np.where(sets, target, 0.0)[:, :, None])[:, :, 0]
        wrong = np.where(sets, -forces * np.diag(M), target - forces @ M).max(axis=1)
        new = np.maximum(forces[np.argmin(wrong)], 0.0)
        change = np.abs(new - f).max()
        f = new
        if change <= 1e-14 * f.max():
            return f
    raise AssertionError("no convergence")
