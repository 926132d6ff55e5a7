# SPDX-License-Identifier: Apache-2.0
"""Condensation of one part: static shapes and fixed-interface modes, stored as linear elements."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.elements import coupling, linear_hold, linear_modes, linear_part
from pitchpoint.multibody.bodies import GENERAL, TORSION, Body
from pitchpoint.solvers.eigen import symmetric, undamped
from pitchpoint.solvers.reduction.condensable import coordinates_of
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]
Rows = dict[str, list[NDArray[np.void]]]

PART, HOLD, MODES = linear_part.KIND.name, linear_hold.KIND.name, linear_modes.KIND.name
TWIST = coupling.KIND.name
"""Element kinds of condensed parts."""

TURNS = 1e-7
"""Stiffness against a rotation of a whole shaft, over the largest, up to which it is rounding."""
NOTHING = 1e-13
"""Entry of a matrix over the largest up to which it counts as zero."""


@dataclass(frozen=True)
class Linear:
    """Mass, damping and stiffness matrix and residual of the condensed parts, over all coordinates."""

    M: Array
    D: Array
    K: Array
    f: Array


@dataclass(frozen=True)
class Part:
    """A condensed part: its coordinates (the first `outer` are retained), shapes, and coordinates by body."""

    places: NDArray[np.int64]
    T: Array
    outer: int
    blocks: tuple[tuple[int, NDArray[np.int64]], ...]


@dataclass(frozen=True)
class Shapes:
    """Shapes (columns over outer and inner coordinates), and fixed-interface frequencies [rad/s]."""

    places: list[int]
    outer: int
    T: Array
    omega: Array


def condense(
    system: System,
    state: State,
    whole: Linear,
    sides: tuple[list[int], list[int]],
    limit: float,
    name: str,
    number: dict[int, int],
    bodies: list[Body],
    rows: Rows,
) -> Part:
    """Condense one part: append its modal bodies and its records.

    Parameters
    ----------
    system, state
        The full system and its operating point.
    whole
        Matrices of the condensed parts.
    sides
        Retained and condensed bodies of the part.
    limit
        Frequency up to which fixed-interface modes are retained [Hz].
    name
        Name of the part.
    number
        New indices of the retained bodies.
    bodies, rows
        Bodies and records of the reduced system, to which the part is appended.
    """
    ends, inner = sides
    shapes = _shapes(whole, coordinates_of(system, ends), coordinates_of(system, inner), limit)
    n, omega = shapes.outer, shapes.omega
    inside = np.ix_(shapes.places, shapes.places)
    m, d, stiff = (shapes.T.T @ A[inside] @ shapes.T for A in (whole.M, whole.D, whole.K))
    force = shapes.T.T @ whole.f[shapes.places]
    groups = _turning_groups(system, state, ends, shapes, stiff)
    first = len(bodies) + 1
    for j, w in enumerate(omega):
        # unit inertia with a coupling to ground as its spring
        bodies.append(Body(motion=TORSION, polar_inertia=1.0, name=f"{name}.mode{j + 1}"))
        row = np.zeros(1, coupling.RECORD)
        row["i"], row["k"] = first + j, w * w
        rows[TWIST].append(row)
        m[n + j, n + j] -= 1.0
        stiff[n + j, n + j] -= w * w
    stiff[n:, :n] = 0.0  # static shapes do not stress the fixed modes
    own = shapes.places[:n]
    blocks = [
        (number[b], np.array([own.index(c) for c in coordinates_of(system, [b])], np.int64)) for b in ends
    ]
    blocks += [(first + j, np.array([n + j])) for j in range(omega.size)]
    least = [NOTHING * np.abs(A).max(initial=0.0) for A in (m, d, stiff)]
    for one, (i, at) in enumerate(blocks):
        for two, (j, by) in enumerate(blocks):
            cut = [A[np.ix_(at, by)] for A in (m, d, stiff)]
            nothing = all(np.abs(c).max(initial=0.0) <= s for c, s in zip(cut, least, strict=True))
            if not at.size or not by.size or (one != two and nothing):
                continue
            row = np.zeros(1, linear_part.RECORD)
            r = row[0]
            r["i"], r["j"] = i, j
            for field, c in zip("MDK", cut, strict=True):
                r[field][: at.size, : by.size] = c
            if one == two:
                r["f0"][: at.size] = force[at]
            if two < len(ends):
                together = one < len(ends) and groups[one] == groups[two] >= 0
                _refer(r, system, state, ends[two], ends[one] if together else 0)
            rows[_kind(system, ends, (one, two), groups, cut[2])].append(row)
    return Part(np.array(shapes.places, np.int64), shapes.T, n, tuple(blocks))


def _shapes(whole: Linear, outer: list[int], hidden: list[int], limit: float) -> Shapes:
    """Static shapes of the outer coordinates, and modes with the outer coordinates fixed."""
    phi, omega = np.zeros((len(hidden), 0)), np.zeros(0)
    static: Array = np.zeros((len(hidden), len(outer)))
    if hidden:
        k = symmetric(whole.K[np.ix_(hidden, hidden)])
        static = np.asarray(-np.linalg.solve(k, symmetric(whole.K)[np.ix_(hidden, outer)]))
        M = whole.M[np.ix_(hidden, hidden)]
        found, modes = undamped(M, k, np.eye(len(hidden)), np.zeros((0, len(hidden))))
        low = int(np.sum(found < 2.0 * np.pi * limit))
        omega, phi = found[:low], modes[:low].T
    n = len(outer)
    T = np.block([[np.eye(n), np.zeros((n, omega.size))], [static, phi]])
    return Shapes([*outer, *hidden], n, T, omega)


def _is_round(system: System, b: int) -> bool:
    return bool(system.program["body"][b]["joint"] != GENERAL)


def _turning_groups(
    system: System, state: State, ends: Sequence[int], shapes: Shapes, stiff: Array
) -> list[int]:
    """Groups of round bodies of a part that rotate together freely: group of every end.

    -1: the body is constrained or has no spin. Rounding of the stiffness of free rotations is removed.

    Raises
    ------
    SolverError
        If bodies rotate at the operating point although they are constrained.
    """
    body = system.program["body"]
    groups = [-1] * len(ends)
    least = TURNS * np.abs(stiff).max(initial=0.0)
    own = {
        e: shapes.places.index(int(body[b]["spin"]))
        for e, b in enumerate(ends)
        if _is_round(system, b) and body[b]["spin"] >= 0
    }
    for first in own:
        if groups[first] >= 0:
            continue
        group, new = {first}, {first}
        while new:
            new = {e for e in own if any(abs(stiff[own[e], own[g]]) > least for g in new)} - group
            group |= new
        turning = np.zeros(len(stiff))
        turning[[own[e] for e in group]] = 1.0
        left = stiff @ turning
        if np.abs(left).max(initial=0.0) <= least:
            stiff -= np.outer(left, turning) / turning.sum()  # remove rounding: the rotation is free
            for e in group:
                groups[e] = first
        elif np.any(state.v[[shapes.places[own[e]] for e in group]]):
            names = ", ".join(system.layout.bodies[ends[e]] for e in sorted(group))
            why = "their axes are not parallel, or springs constrain them"
            raise SolverError(f"{names} cannot rotate together freely: {why}; keep one of them", INCONSISTENT)
    return groups


def _kind(
    system: System, ends: Sequence[int], pair: tuple[int, int], groups: list[int], diagonal: Array
) -> str:
    """Element kind of a block, by its constraint of the rotation of the bodies."""
    one, two = pair
    if one >= len(ends) or two >= len(ends):
        return MODES
    place = int(system.program["body"][ends[one]]["spin"]) - int(system.program["body"][ends[one]]["dof"])
    if one == two and place >= 0 and groups[one] < 0 and diagonal[place, place] > 0.0:
        return HOLD
    return PART if groups[one] == groups[two] >= 0 else MODES


def damp_across(D: Array, state: State, parts: Sequence[Part], rows: list[NDArray[np.void]]) -> None:
    """Append records of the damping between parts, such as that of modal damping ratios."""
    for p in parts:
        for q in parts:
            whole = D[np.ix_(p.places, q.places)]
            if p is q or not whole.any():
                continue
            d = p.T.T @ whole @ q.T
            rates = np.concatenate([state.v[q.places[: q.outer]], np.zeros(q.T.shape[1] - q.outer)])
            for i, at in p.blocks:
                for j, by in q.blocks:
                    if not at.size or not by.size:
                        continue
                    row = np.zeros(1, linear_part.RECORD)
                    row["i"], row["j"] = i, j
                    row["D"][0, : at.size, : by.size] = d[np.ix_(at, by)]
                    row["v0"][0, : by.size] = rates[by]
                    rows.append(row)


def _refer(record: np.void, system: System, state: State, j: int, i: int) -> None:
    """Store the operating point of body j in a record; if i is given, its spin is relative to that of i."""
    body = system.program["body"]
    dof, n = int(body[j]["dof"]), int(body[j]["n"])
    record["x0"][:n], record["v0"][:n] = state.q[dof : dof + n], state.v[dof : dof + n]
    spin = int(body[j]["spin"])
    if spin >= 0:
        record["x0"][spin - dof] += 2.0 * np.pi * state.turns[j]
    if i and spin >= 0:
        record["relative"] = 1
        record["spin0"] = state.q[body[i]["spin"]] + 2.0 * np.pi * state.turns[i]
