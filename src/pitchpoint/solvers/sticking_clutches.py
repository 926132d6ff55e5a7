# SPDX-License-Identifier: Apache-2.0
"""Sticking clutches in a linear system: bristles that do not yield are springs.

The deflection y of a bristle is the rate of a hidden coordinate c (`contact.bristle`). While it
sticks, y' = k w with the slip w, so that y = k times the angle of the slip: row c of M x'' + D x' + K x = 0,

    m c'' + e x' = 0   gives   c' = -e x/m = f x,

and column d of D acts as the stiffness d f. The hidden coordinate is no longer one of the system; this
is exact. A clutch that slips keeps its state.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.elements import registry
from pitchpoint.elements.kind import CLUTCH
from pitchpoint.solvers.element_tangents import element_names, share_of

if TYPE_CHECKING:
    from pitchpoint.solvers.linear_system import Linearised
    from pitchpoint.solvers.stiffness_parts import Array
    from pitchpoint.system.system import System

SAME = 1e-9
"""Rotation of a train over its largest one that counts as zero."""


def with_sticking_clutches(linear: Linearised) -> Linearised:
    """The linear system with a torsional stiffness in place of the state of every sticking clutch.

    Parameters
    ----------
    linear
        The system, in which all clutches have states.
    """
    found = {
        c: (kind, k, -linear.D[c] / linear.at_rest.M[c, c])
        for kind, k, c in _hidden(linear.system)
        if c in linear.states and linear.D[c, c] == 0.0  # it would be the rate of yielding
    }
    if not found:
        return linear
    parts, K = linear.at_rest, linear.K.copy()
    K_rest, D_rest, D = parts.K.copy(), parts.D.copy(), linear.D.copy()
    elements, kinds, bodies, shares = [*parts.elements], [*parts.kinds], [*parts.bodies], [*parts.shares]
    for c, (kind, k, follows) in found.items():
        more = np.outer(linear.D[:, c], follows)
        K += more
        K_rest += more
        for matrix in (D_rest, D):
            matrix[c], matrix[:, c] = 0.0, 0.0
        if not more.any():
            continue  # an open clutch
        record = linear.system.records[kind][k]
        label = f"{registry.find(kind).label_of(record)} {element_names(linear.system, kind)[k]}"
        elements.append(label)
        kinds.append(kind)
        bodies.append(np.array([int(record["i"]), int(record["j"])]))
        shares.append(share_of(more))
    followers = {c: follows for c, (_, _, follows) in found.items()}
    at_rest = replace(
        parts,
        D=D_rest,
        K=K_rest,
        elements=tuple(elements),
        kinds=tuple(kinds),
        bodies=np.array(bodies, np.int64).reshape(-1, 2),
        shares=tuple(shares),
    )
    slips = np.array([f for c, f in followers.items() if linear.D[:, c].any()]).reshape(-1, len(K))
    return replace(
        linear,
        at_rest=at_rest,
        D=D,
        K=K,
        rigid=_without_slip(linear.rigid, slips),
        states=tuple(s for s in linear.states if s not in found),
        followers=followers,
    )


def _hidden(system: System) -> list[tuple[str, int, int]]:
    """Kind, index and hidden coordinate of every clutch; a clutch without bristles has that of ground."""
    body = system.program["body"]
    return [
        (kind, k, int(body[int(record["k"])]["spin"]))
        for kind in system.kinds(CLUTCH)
        for k, record in enumerate(system.records[kind])
    ]


def _without_slip(rigid: Array, slips: Array) -> Array:
    """Rigid rotations in which no sticking clutch slips.

    Parameters
    ----------
    rigid
        Free rotations without the clutches, shape (r, nd).
    slips
        Slip of the clutches over the coordinates, shape (k, nd).
    """
    size = np.abs(rigid).max(axis=1, initial=0.0, keepdims=True)
    rigid = np.divide(rigid, size, out=np.zeros_like(rigid), where=size > 0.0)
    slip = rigid @ (slips / np.abs(slips).max(axis=1, initial=0.0, keepdims=True)).T
    moved = np.abs(slip).max(axis=1, initial=0.0) > SAME
    if not moved.any():
        return rigid
    _, sizes, basis = np.linalg.svd(slip[moved].T)
    free = basis[int(np.sum(sizes > SAME * sizes.max())) :]
    return np.vstack([rigid[~moved], free @ rigid[moved]])
