# SPDX-License-Identifier: Apache-2.0
"""Tangents of single elements of any kind, by evaluation of the system with all others disabled.

Forces and tangents of a system are sums over its elements, so the contribution of one element is the
difference between the system with that element only and the system without elements. No element kind needs
code for this.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.kind import FORCE, JOINT, MESH, TORQUE
from pitchpoint.elements.signal import set_constant
from pitchpoint.solvers.eigen import symmetric
from pitchpoint.system import evaluate
from pitchpoint.system.link import TABLES, kind_of_row
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

NEGLIGIBLE = 1e-13
"""Entry of the mass matrix over the largest up to which it counts as zero."""
STILL = 1e-9
"""Speed over the highest speed up to which a rotation is at rest."""


def without_friction(system: System, *, joints: bool = False) -> System:
    """Copy of the system with frictionless flanks, and on request frictionless joints.

    Sliding friction depends on the normal force but acts perpendicular to it: in a stiffness matrix it would
    destabilise modes, which real sliding does not.
    """
    rough = [k for k in system.kinds(MESH) if system.records[k]["contact"]["mu"].any()]
    smooth = {kind: system.records[kind].copy() for kind in rough}
    for records in smooth.values():
        records["contact"]["mu"] = 0.0
    for kind in system.kinds(JOINT) if joints else ():
        smooth[kind] = system.records[kind].copy()
        smooth[kind]["mu"] = 0.0
    return system.with_params(smooth) if smooth else system


def without_loads(system: System) -> System:
    """Copy of the system with zero torques and forces."""
    loads = {kind: system.records[kind].copy() for role in (TORQUE, FORCE) for kind in system.kinds(role)}
    for records in loads.values():
        for record in records:
            set_constant(record, 0.0)
    return system.with_params(loads)


@dataclass(frozen=True)
class Share:
    """A matrix that is zero except for a few rows and columns.

    Parameters
    ----------
    places
        Coordinates of the non-zero rows and columns, shape (m,).
    matrix
        The entries, shape (m, m).
    """

    places: NDArray[np.int64]
    matrix: Array

    def energy(self, shapes: Array) -> Array:
        """x^T A x for every row x of `shapes`, shape (n,)."""
        x = shapes[:, self.places]
        return np.asarray(((x @ self.matrix) * x).sum(axis=1))


def share_of(whole: Array) -> Share:
    """Reduce a dense matrix (nd, nd) to the coordinates with non-zero entries."""
    used = np.flatnonzero(np.any(whole != 0.0, axis=0) | np.any(whole != 0.0, axis=1))
    return Share(used, whole[np.ix_(used, used)].copy())


@contextmanager
def switched(system: System, on: Mapping[str, slice | NDArray[np.int64]]) -> Iterator[None]:
    """Context in which only the given records are evaluated; function-driven joints are always included.

    Parameters
    ----------
    system
        The system; its address tables are changed within the context.
    on
        Records to evaluate, by name of kind; records given by index are evaluated on copies.
    """
    tables = system.workspace.tables
    kept = {name: table.copy() for name, table in tables.items()}
    banks = {kind: np.ascontiguousarray(system.records[kind][chosen]) for kind, chosen in on.items()}
    row = 0
    for name in TABLES:
        table = tables[name]
        for e in range(len(table)):
            kind = kind_of_row(system.records, row)
            row += 1
            if name == "guiding":
                continue
            bank = banks.get(kind, system.records[kind][:0])
            table[e, 1], table[e, 2] = bank.ctypes.data, bank.size
    try:
        yield
    finally:
        for name, table in tables.items():
            table[:] = kept[name]


def tangents(
    system: System, state: State, on: Mapping[str, slice | NDArray[np.int64]]
) -> tuple[Array, Array]:
    """Damping and stiffness matrix of some records, without the inertia of the bodies, as blocks."""
    return forces_and_tangents(system, state, on)[1:]


def forces_and_tangents(
    system: System, state: State, on: Mapping[str, slice | NDArray[np.int64]]
) -> tuple[Array, Array, Array]:
    """Generalised forces (nd,) of some records, and their `tangents`."""
    found = []
    for what in (on, {}):
        with switched(system, what):
            damping = evaluate.blocks(system, state, 0.0, 1.0, 0.0)
            stiffness = evaluate.blocks(system, state, 0.0, 0.0, 1.0)
            found.append((system.workspace.R.copy(), damping, stiffness))
    (own, damping, stiffness), (bare, bare_damping, bare_stiffness) = found
    return bare - own, damping - bare_damping, stiffness - bare_stiffness


def bare_blocks(system: System, state: State, cm: float, cd: float, ck: float) -> Array:
    """Blocks of the matrix of the bodies alone, without any element."""
    with switched(system, {}):
        return evaluate.blocks(system, state, cm, cd, ck)


def massive_kinds(system: System, state: State) -> tuple[str, ...]:
    """Kinds whose elements have inertia."""
    bare = bare_blocks(system, state, 1.0, 0.0, 0.0)
    found = []
    for kind in system.records:
        with switched(system, {kind: slice(None)}):
            more = evaluate.blocks(system, state, 1.0, 0.0, 0.0) - bare
        if np.abs(more).max(initial=0.0) > NEGLIGIBLE * np.abs(bare).max(initial=0.0):
            found.append(kind)
    return tuple(found)


def inertial_stiffness(system: System, state: State, still: State, rigid: Array) -> Array:
    """Centrifugal stiffness of a steady rotation, of bodies and massive elements; symmetric, shape (nd, nd).

    Parameters
    ----------
    system, state, still
        The system, the operating point, and the same position at rest.
    rigid
        Unconstrained rigid rotations, shape (r, nd). Those with a speed do no work against it: the
        centrifugal force of an unbalance passes through the axis and rotates with the body. The part of the
        tangent that rotates this force is not symmetric, and half of it would be a stiffness of the rotation.
        A pendulum on a rotor has no speed of its own, and this stiffness.
    """
    on = dict.fromkeys(massive_kinds(system, still), slice(None))
    with switched(system, on):
        turning = evaluate.matrix(system, state, 0.0, 0.0, 1.0)
        found = symmetric(turning - evaluate.matrix(system, still, 0.0, 0.0, 1.0))
    mass = evaluate.matrix(system, still, 1.0, 0.0, 0.0)
    weighted = rigid @ mass
    speeds = np.linalg.solve(weighted @ rigid.T, weighted @ state.v)
    turns = rigid[np.abs(speeds) > STILL * np.abs(speeds).max(initial=0.0)]
    if not len(turns):
        return found
    weighted = turns @ mass
    within = np.linalg.solve(weighted @ turns.T, weighted)
    out = found @ turns.T @ within
    return np.asarray(found - out - out.T + within.T @ (turns @ out))


def element_names(system: System, kind: str) -> tuple[str, ...]:
    """Names of all elements of a kind, as in the channels."""
    given = system.names.get(kind, ())
    return tuple(given[k] if k < len(given) else f"{kind}{k}" for k in range(system.records[kind].size))
