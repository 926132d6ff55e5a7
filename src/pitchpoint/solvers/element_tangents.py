# SPDX-License-Identifier: Apache-2.0
"""Tangents of single elements of any kind: the system is evaluated with all others switched off.

Forces and tangents of a system are sums over its elements, so what one adds is the difference between the
system with it alone and the system with none. Kinds keep their physics in their kernels and need not know.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.kind import FORCE, JOINT, MESH, TORQUE
from pitchpoint.elements.signal import set_constant
from pitchpoint.system import evaluate
from pitchpoint.system.link import TABLES, kind_of_row
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

NEGLIGIBLE = 1e-13
"""Entry of the mass matrix over the largest that counts as none."""


def without_friction(system: System, *, joints: bool = False) -> System:
    """Copy of the system with frictionless flanks, and on request frictionless joints.

    Sliding friction follows the normal force but acts across it: in a stiffness matrix it would feed energy
    into modes that real sliding does not.
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
    """The same system with its torques and forces at zero."""
    loads = {kind: system.records[kind].copy() for role in (TORQUE, FORCE) for kind in system.kinds(role)}
    for records in loads.values():
        for record in records:
            set_constant(record, 0.0)
    return system.with_params(loads)


@dataclass(frozen=True)
class Share:
    """A matrix that is zero but for a few rows and columns.

    Parameters
    ----------
    places
        Coordinates of the rows and columns, shape (m,).
    matrix
        The entries, shape (m, m).
    """

    places: NDArray[np.int64]
    matrix: Array

    def energy(self, shapes: Array) -> Array:
        """x^T A x of every row of `shapes`, shape (n,)."""
        x = shapes[:, self.places]
        return np.asarray(((x @ self.matrix) * x).sum(axis=1))


def share_of(whole: Array) -> Share:
    """Cut a dense matrix (nd, nd) down to the coordinates that it has entries for."""
    used = np.flatnonzero(np.any(whole != 0.0, axis=0) | np.any(whole != 0.0, axis=1))
    return Share(used, whole[np.ix_(used, used)].copy())


@contextmanager
def switched(system: System, on: Mapping[str, slice | NDArray[np.int64]]) -> Iterator[None]:
    """Evaluate a system with some records of some kinds alone; joints made of functions stay.

    Parameters
    ----------
    system
        The system; its address tables are changed while the context lasts.
    on
        Records that count, by name of kind; copies of them do their work where they are given by numbers.
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
    found = []
    for factors in ((0.0, 1.0, 0.0), (0.0, 0.0, 1.0)):
        parts = []
        for what in (on, {}):
            with switched(system, what):
                parts.append(evaluate.blocks(system, state, *factors))
        found.append(parts[0] - parts[1])
    return found[0], found[1]


def bare_blocks(system: System, state: State, cm: float, cd: float, ck: float) -> Array:
    """Blocks of the matrix of the bodies alone, without any element."""
    with switched(system, {}):
        return evaluate.blocks(system, state, cm, cd, ck)


def massive_kinds(system: System, state: State) -> tuple[str, ...]:
    """Kinds whose elements have inertia of their own."""
    bare = bare_blocks(system, state, 1.0, 0.0, 0.0)
    found = []
    for kind in system.records:
        with switched(system, {kind: slice(None)}):
            more = evaluate.blocks(system, state, 1.0, 0.0, 0.0) - bare
        if np.abs(more).max(initial=0.0) > NEGLIGIBLE * np.abs(bare).max(initial=0.0):
            found.append(kind)
    return tuple(found)


def inertial_stiffness(system: System, state: State, still: State) -> Array:
    """What steady rotation adds to the stiffness by inertia, bodies and massive elements (centrifugal)."""
    on = dict.fromkeys(massive_kinds(system, still), slice(None))
    with switched(system, on):
        turning = evaluate.matrix(system, state, 0.0, 0.0, 1.0)
        return turning - evaluate.matrix(system, still, 0.0, 0.0, 1.0)


def element_names(system: System, kind: str) -> tuple[str, ...]:
    """Names of all elements of a kind, as in the observations."""
    given = system.names.get(kind, ())
    return tuple(given[k] if k < len(given) else f"{kind}{k}" for k in range(system.records[kind].size))
