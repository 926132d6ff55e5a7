# SPDX-License-Identifier: Apache-2.0
"""Null space of many short rows, such as the linear relations between the spins of gear trains.

Every connected group of unknowns has a separate basis. Within a group each row eliminates one parameter from
the expressions of the unknowns: among those with a large coefficient the one used by the fewest unknowns, so
a train of n gears takes n log n operations.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

SAME = 1e-9
"""Coefficient over the sum of its terms that counts as zero."""
LARGE = 0.1
"""Coefficient over the largest of its row from which a parameter may be eliminated."""


Row = Mapping[int, float]
"""Factors by unknown."""


@dataclass(frozen=True)
class NullSpace:
    """Orthonormal basis of a null space by groups of unknowns.

    Parameters
    ----------
    groups
        Unknowns of every group and basis over them, shape (unknowns, freedoms).
    group_of, place_of
        Group of every unknown and its row in the basis of the group.
    """

    groups: tuple[tuple[tuple[int, ...], Array], ...]
    group_of: Mapping[int, int]
    place_of: Mapping[int, int]

    def row(self, unknown: int) -> Array:
        """Components of an unknown along the basis of its group."""
        return np.asarray(self.groups[self.group_of[unknown]][1][self.place_of[unknown]])

    def moves(self, unknown: int) -> bool:
        """Whether an unknown is free to change."""
        return float(np.linalg.norm(self.row(unknown))) > SAME


def null_space(rows: Sequence[Row], unknowns: Sequence[int]) -> NullSpace:
    """Compute the null space of sparse rows.

    Parameters
    ----------
    rows
        Rows without zeros, with any scaling.
    unknowns
        Names of the unknowns.

    Examples
    --------
    >>> found = null_space([{7: 1.0, 8: 1.0}], [7, 8, 9])
    >>> found.groups[0][0], found.groups[0][1].round(4).T
    ((7, 8), array([[-0.7071,  0.7071]]))
    >>> found.moves(9)
    True
    """
    expressions = _expressions(rows, unknowns)
    groups = []
    group_of, place_of = {}, {}
    for k, own in enumerate(connected(rows, unknowns)):
        parameters = {p: c for c, p in enumerate(sorted({p for v in own for p in expressions[v]}))}
        basis = np.zeros((len(own), len(parameters)))
        for place, v in enumerate(own):
            for p, factor in expressions[v].items():
                basis[place, parameters[p]] = factor
            group_of[v], place_of[v] = k, place
        groups.append((tuple(own), _orthonormal(basis)))
    return NullSpace(tuple(groups), group_of, place_of)


def _expressions(rows: Sequence[Row], unknowns: Sequence[int]) -> dict[int, dict[int, float]]:
    """Every unknown as a linear combination of parameters, which are independent unknowns."""
    found = {v: {v: 1.0} for v in unknowns}
    users = {v: {v} for v in unknowns}
    for row in rows:
        left: dict[int, float] = {}
        terms: dict[int, float] = {}
        for v, value in row.items():
            for p, factor in found[v].items():
                left[p] = left.get(p, 0.0) + value * factor
                terms[p] = terms.get(p, 0.0) + abs(value * factor)
        largest = max(terms.values(), default=0.0)
        left = {p: c for p, c in left.items() if abs(c) > SAME * largest}
        if not left:
            continue
        enough = LARGE * max(abs(c) for c in left.values())
        gone = min((p for p, c in left.items() if abs(c) >= enough), key=lambda p: (len(users[p]), -p))
        factors = {p: -c / left[gone] for p, c in left.items() if p != gone}
        for v in users[gone]:
            share = found[v].pop(gone)
            for p, factor in factors.items():
                found[v][p] = found[v].get(p, 0.0) + share * factor
                users[p].add(v)
        users[gone] = set()
    return found


def connected(rows: Sequence[Row], unknowns: Sequence[int]) -> list[list[int]]:
    """Groups of unknowns connected by rows, in the order of their first unknowns.

    Examples
    --------
    >>> connected([{1: 1.0, 3: 2.0}], [1, 2, 3])
    [[1, 3], [2]]
    """
    leader = {v: v for v in unknowns}

    def first(v: int) -> int:
        """Leader of the group of an unknown."""
        while leader[v] != v:
            leader[v] = leader[leader[v]]
            v = leader[v]
        return v

    for row in rows:
        one, *others = row
        for other in others:
            leader[first(other)] = first(one)
    found: dict[int, list[int]] = {}
    for v in unknowns:
        found.setdefault(first(v), []).append(v)
    return list(found.values())


def _orthonormal(basis: Array) -> Array:
    """Orthonormal columns of the same space; a single number keeps its sign."""
    if basis.shape[1] == 0 or basis.shape == (1, 1):
        return np.sign(basis)
    return np.asarray(np.linalg.qr(basis)[0])
