# SPDX-License-Identifier: Apache-2.0
"""Error of a reduced system: natural frequencies, and compliance at the meshes, up to a frequency."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.solvers.constraints.free_directions import free_directions
from pitchpoint.solvers.eigen import undamped
from pitchpoint.solvers.element_tangents import inertial_stiffness
from pitchpoint.solvers.gear_trains import rigid_rotations
from pitchpoint.solvers.linear_system import SPARSE
from pitchpoint.solvers.modes.sparse import lowest_modes
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_names, mesh_record
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

POINTS = 25
"""Frequencies at which compliances are compared."""
FIRST = 50
"""Initial number of modes of a large system."""
STILL = 1e-4
"""Frequency over the limit up to which a mode counts as rigid: residual forces cause small frequencies."""
STEP = 2e-10
"""Finite-difference step of the travel of a mesh [m]."""


@dataclass(frozen=True)
class ReductionError:
    """Error of a reduced system about its operating point.

    Parameters
    ----------
    limit
        Highest frequency of interest [Hz].
    full, reduced
        Natural frequencies up to it [Hz], in the same order, without damping and gyroscopic terms, with the
        centrifugal stiffness of a steady rotation. 0 for rigid modes, up to `STILL` of the limit.
    frequency
        Largest relative difference of both; for a mode that is rigid in one of them only, relative to `STILL`
        of the limit.
    compliance
        Largest difference of the dynamic compliance of a mesh (travel of the gears per mesh force, with the
        mesh in contact) over the largest compliance, at frequencies up to the limit.
    coordinates
        Number of coordinates of both systems.
    """

    limit: float
    full: Array
    reduced: Array
    frequency: float
    compliance: float
    coordinates: tuple[int, int]

    def report(self) -> str:
        """Summary in one sentence."""
        full, reduced = self.coordinates
        return (
            f"{reduced} of {full} coordinates: natural frequencies up to {self.limit:.6g} Hz differ by up to "
            f"{100.0 * self.frequency:.2g} %, the compliance of the meshes by {100.0 * self.compliance:.2g} %"
        )


def compare(full: System, at: State, reduced: System, near: State, limit: float) -> ReductionError:
    """Compare a reduced system with the full one about one operating point."""
    turns = rigid_rotations(full)
    both = (full, at, turns), (reduced, near, _restricted(turns, full, reduced))
    least = STILL * limit
    found = [np.where(np.abs(f) <= least, 0.0, f) for f in (_frequencies(*b, 1.1 * limit) for b in both)]
    below = found[0][found[0] <= limit]
    own = found[1][: below.size]
    if below.size > own.size:
        off = np.array([np.inf])
    else:
        off = np.abs(own - below) / np.maximum(np.abs(below), least)
    one, two = (_compliances(s, x, limit) for s, x in ((full, at), (reduced, near)))
    size = np.abs(one).max(initial=0.0)
    compliance = float(np.abs(one - two).max(initial=0.0) / size) if size > 0.0 else 0.0
    sizes = (full.sizes["nd"], reduced.sizes["nd"])
    return ReductionError(limit, below, own, float(off.max(initial=0.0)), compliance, sizes)


def _restricted(turns: Array, full: System, reduced: System) -> Array:
    """Free rigid rotations of the full system in the retained spins, shape (r, nd).

    They cannot be determined from the reduced system, whose condensed parts couple bodies without an element.
    """
    found = np.zeros((len(turns), reduced.sizes["nd"]))
    number = {name: b for b, name in enumerate(full.layout.bodies)}
    old, new = full.program["body"], reduced.program["body"]
    for b, name in enumerate(reduced.layout.bodies):
        if name in number and new[b]["spin"] >= 0:
            found[:, new[b]["spin"]] = turns[:, old[number[name]]["spin"]]
    return found[np.abs(found).any(axis=1)]


def _frequencies(system: System, state: State, rigid: Array, limit: float) -> Array:
    """Natural frequencies [Hz] at the speeds of a state, ascending, at least up to a limit."""
    stopped = state.copy()
    stopped.v[:] = 0.0
    M, K = (evaluate.matrix(system, stopped, *f) for f in ((1.0, 0.0, 0.0), (0.0, 0.0, 1.0)))
    if state.v.any():
        K = K + inertial_stiffness(system, state, stopped, rigid)
    basis = free_directions(system, stopped)
    if not isinstance(basis, np.ndarray):
        count = FIRST
        while count < SPARSE * basis.shape[1]:
            omega = lowest_modes(M, K, basis, rigid, count)[0]
            if omega[-1] > 2.0 * np.pi * limit:
                return np.asarray(omega / (2.0 * np.pi))
            count *= 2
        basis = basis.toarray()
    omega, _ = undamped(M, K, basis, rigid)
    return np.asarray(omega / (2.0 * np.pi))


def _compliances(system: System, state: State, limit: float) -> NDArray[np.complex128]:
    """Travel of each mesh per mesh force, at frequencies up to a limit, shape (meshes, POINTS)."""
    Z = free_directions(system, state)
    M, D, K = (_along(Z, evaluate.matrix(system, state, *f)) for f in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
    loads = np.zeros((Z.shape[1], len(mesh_names(system))))
    for k in range(loads.shape[1]):
        record = mesh_record(system, k)
        kept, sides = float(record["u0"]), []
        for sign in (1.0, -1.0):
            record["u0"] = kept + sign * STEP
            sides.append((evaluate.residual(system, state), _force(system, state, k)))
        record["u0"] = kept
        change = sides[0][1] - sides[1][1]
        if change != 0.0:
            loads[:, k] = Z.T @ ((sides[0][0] - sides[1][0]) / change)
    found = np.zeros((loads.shape[1], POINTS), complex)
    for p, w in enumerate(2.0 * np.pi * limit * (np.arange(POINTS) + 0.5) / POINTS):
        answer = _solved(K + 1j * w * D - w * w * M, loads.astype(complex))
        found[:, p] = (loads * answer).sum(axis=0)
    return found


def _along(Z: Any, A: Array) -> Any:
    """Projection of a matrix onto the free directions; sparse if these are."""
    if isinstance(Z, np.ndarray):
        return Z.T @ A @ Z
    from scipy.sparse import csc_array

    return (Z.T @ csc_array(A) @ Z).tocsc()


def _solved(A: Any, b: NDArray[np.complex128]) -> NDArray[np.complex128]:
    if isinstance(A, np.ndarray):
        return np.asarray(np.linalg.solve(A, b), dtype=np.complex128)
    from scipy.sparse.linalg import splu

    return np.asarray(splu(A.tocsc()).solve(b))


def _force(system: System, state: State, k: int) -> float:
    """Force in a mesh [N]."""
    values = evaluate.observe(system, state)
    return float(values[system.layout.channel(f"mesh_force[{mesh_names(system)[k]}]")])
