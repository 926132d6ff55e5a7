# SPDX-License-Identifier: Apache-2.0
"""Random contact problems, batches of them in compiled loops, and independent solutions in plain NumPy."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.local_approach import N_NODE, PAIR_MATERIAL, D, set_node
from pitchpoint.contact.unilateral import solve_contact
from pitchpoint.contact.unilateral_work import CONTACT_STATE, FORCE, N_VECTOR, ContactWorkspace, forget
from pitchpoint.core.kernel import invoke, kernel, view

Array = NDArray[np.float64]
F8, I8 = np.dtype("f8"), np.dtype("i8")

#: One batch: arrays by address.
BATCH = np.dtype(
    [(name, "i8") for name in ("n", "w", "warm", "C", "node", "x", "f", "status", "state", "on", "v", "U")],
    align=True,
)


@kernel
def batch_entry(ctl, rec, n):
    """Solve n states in sequence: warm from the one before, or each from nothing."""
    b = view(ctl, 1, BATCH)[0]
    size, w = b["n"], b["w"]
    C = view(b["C"], (size, size), F8)
    node = view(b["node"], (size, N_NODE), F8)
    x = view(b["x"], (n, size), F8)
    f = view(b["f"], (n, size), F8)
    status = view(b["status"], n, I8)
    state = view(b["state"], 1, CONTACT_STATE)[0]
    on = view(b["on"], (2, w), I8)
    v = view(b["v"], (N_VECTOR, w), F8)
    U = view(b["U"], (w, w), F8)
    for k in range(n):
        if b["warm"] == 0:
            forget(size, state, v)
        status[k] = solve_contact(C, node, x[k], state, on, v, U)
        for i in range(size):
            f[k, i] = v[FORCE, i]
    return 1


@dataclass(frozen=True)
class Problem:
    """Compliance matrix and nodes, with the values of the nodes for the formula in NumPy."""

    C: Array
    node: Array
    d: Array
    length: Array
    radius: Array
    depth: Array
    bodies: tuple[tuple[float, float], tuple[float, float]]

    @property
    def n(self) -> int:
        """Number of nodes."""
        return len(self.C)

    def approach(self, f: Array) -> Array:
        """Formula of the local approach, for forces with nodes in the last axis; odd in the force."""
        total = self.d * f
        if not self.length.any():
            return total
        c = [(1.0 - nu * nu) / E for E, nu in self.bodies]
        q = np.abs(f) / self.length
        b = np.sqrt(4.0 * q * self.radius * sum(c) / math.pi)
        b = np.maximum(b, 1e-120)
        for k in (0, 1):
            t, nu = self.depth[k], self.bodies[k][1]
            bracket = np.arcsinh(t / b) - nu / (1.0 - nu) * t / (np.sqrt(t * t + b * b) + t)
            total = total + 2.0 * c[k] / math.pi * np.sign(f) * q * bracket
        return total

    def slope(self, f: Array) -> Array:
        """Derivative of the approach, by a complex step of each node."""
        if not self.length.any():
            return self.d + 0.0 * f
        c = [(1.0 - nu * nu) / E for E, nu in self.bodies]
        b = np.sqrt(4.0 * np.abs(f) / self.length * self.radius * sum(c) / math.pi)
        b = np.maximum(b, 1e-120)
        total = self.d
        for k in (0, 1):
            t, nu = self.depth[k], self.bodies[k][1]
            bracket = np.arcsinh(t / b) - 0.5 / (1.0 - nu) * t / np.sqrt(t * t + b * b)
            total = total + 2.0 * c[k] / math.pi / self.length * bracket
        return total


def problem(C: Array, d: Array, rng: np.random.Generator | None = None) -> Problem:
    """Problem of a matrix and linear local compliances; with a generator, Hertzian nodes of random size."""
    n = len(C)
    node = np.zeros((n, N_NODE))
    node[:, D] = d
    length, radius, depth = np.zeros(n), np.ones(n), np.ones((2, n))
    bodies = (206e9, 0.3), (206e9, 0.3)
    if rng is not None:
        bodies = (206e9, 0.3), (float(rng.choice([206e9, 110e9])), float(rng.uniform(0.2, 0.4)))
        length, radius = rng.uniform(0.2e-3, 3e-3, n), 10.0 ** rng.uniform(-3.0, -1.0, n)
        depth = rng.uniform(0.5e-3, 5e-3, (2, n))
        material = np.zeros(1, PAIR_MATERIAL)[0]
        material["c"] = [(1.0 - nu * nu) / E for E, nu in bodies]
        material["kappa"] = [nu / (1.0 - nu) for _, nu in bodies]
        for i in range(n):
            set_node(node, i, length[i], radius[i], (depth[0, i], depth[1, i]), material, d[i])
    return Problem(np.ascontiguousarray(C), node, np.asarray(d, float), length, radius, depth, bodies)


def solve_batch(
    p: Problem, x: Array, warm: bool = True, work: ContactWorkspace | None = None
) -> tuple[Array, NDArray[np.int64], ContactWorkspace]:
    """Forces and statuses of states (rows of x), and the workspace."""
    x = np.ascontiguousarray(x)
    f, status = np.zeros_like(x), np.zeros(len(x), np.int64)
    work = work or ContactWorkspace.of(p.n)
    b = np.zeros(1, BATCH)
    b["n"], b["w"], b["warm"] = p.n, work.U.shape[0], warm
    arrays = {"C": p.C, "node": p.node, "x": x, "f": f, "status": status}
    arrays |= {name: getattr(work, name) for name in ("state", "on", "v", "U")}
    for name, array in arrays.items():
        b[name] = array.ctypes.data
    invoke(batch_entry, b.ctypes.data, 0, len(x))
    return f, status, work
