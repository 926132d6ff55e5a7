# SPDX-License-Identifier: Apache-2.0
"""Ring of equal sectors, of which a few neighbouring ones have load cases.

Derivation: docs/theory/tooth_fe.md, "Ring".
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pitchpoint.contact.tooth_fe.substructure import IntArray, Part, eliminated, joined


def between(sector: Part, first: int, second: int) -> Part:
    """Sector whose clockwise border has the nodes of border `first`, the other one those of border `second`.

    Parameters
    ----------
    sector
        Condensed to its two borders, clockwise nodes first.
    first, second
        Numbers of the borders.

    Examples
    --------
    One value on each border, springs between them and to ground, a force on the counter-clockwise border:

    >>> K, R = np.array([[2.0, -1.0], [-1.0, 2.0]]), np.array([[0.0], [1.0]])
    >>> sector = Part(np.array([0, 1]), K, np.array([0]), R, np.zeros((1, 1)))
    >>> between(sector, 1, 0).R.tolist()
    [[1.0], [0.0]]
    """
    n = sector.nodes.size // 2
    d = sector.values
    nodes = np.concatenate([first * n + np.arange(n), second * n + np.arange(n)])
    if second > first:
        return replace(sector, nodes=nodes)
    rows = np.argsort(nodes)
    dofs = (rows[:, None] * d + np.arange(d)).ravel()
    return replace(sector, nodes=nodes[rows], K=sector.K[np.ix_(dofs, dofs)], R=sector.R[dofs])


def with_loads(sector: Part, chosen: IntArray, numbers: IntArray) -> Part:
    """Sector with some of its load cases.

    Parameters
    ----------
    sector
        One sector.
    chosen
        Indices into its load cases, shape (q,).
    numbers
        New numbers of these load cases, shape (q,), ascending.

    Examples
    --------
    One value on each border, springs between them and to ground, a force on the counter-clockwise border:

    >>> K, R = np.array([[2.0, -1.0], [-1.0, 2.0]]), np.array([[0.0], [1.0]])
    >>> sector = Part(np.array([0, 1]), K, np.array([0]), R, np.zeros((1, 1)))
    >>> with_loads(sector, np.array([0]), np.array([7])).columns.tolist()
    [7]
    """
    return replace(
        sector, columns=numbers, R=sector.R[:, chosen], compliance=sector.compliance[np.ix_(chosen, chosen)]
    )


def series(a: Part, b: Part) -> Part:
    """Two neighbouring sectors as one, condensed to their outer borders.

    Parameters
    ----------
    a, b
        The sectors, counter-clockwise.

    Examples
    --------
    One value on each border, springs between them and to ground, a force on the counter-clockwise border:

    >>> K, R = np.array([[2.0, -1.0], [-1.0, 2.0]]), np.array([[0.0], [1.0]])
    >>> sector = Part(np.array([0, 1]), K, np.array([0]), R, np.zeros((1, 1)))
    >>> sector = with_loads(sector, np.empty(0, np.int64), np.empty(0, np.int64))
    >>> series(sector, sector).K.tolist()
    [[1.75, -0.25], [-0.25, 1.75]]
    """
    n = a.nodes.size // 2
    both = joined(between(a, 0, 1), between(b, 1, 2))
    return between(eliminated(both, np.arange(n, 2 * n)), 0, 1)


def arc(sector: Part, count: int) -> Part:
    """Several equal sectors without loads, condensed to their outer borders.

    Parameters
    ----------
    sector
        One sector.
    count
        Number of sectors, at least 1.

    Examples
    --------
    One value on each border, springs between them and to ground, a force on the counter-clockwise border:

    >>> K, R = np.array([[2.0, -1.0], [-1.0, 2.0]]), np.array([[0.0], [1.0]])
    >>> sector = Part(np.array([0, 1]), K, np.array([0]), R, np.zeros((1, 1)))
    >>> arc(sector, 2).K.tolist()
    [[1.75, -0.25], [-0.25, 1.75]]
    """
    none = np.empty(0, np.int64)
    single = with_loads(sector, none, none)
    if count == 1:
        return single
    half = arc(single, count // 2)
    double = series(half, half)
    return series(double, single) if count % 2 else double


def ring(sectors: list[Part], z: int) -> Part:
    """Closed ring of `z` sectors, condensed to its load cases.

    Parameters
    ----------
    sectors
        Neighbouring sectors counter-clockwise with different load cases; the others equal the first one.
    z
        Number of sectors, larger than the number of the given ones.

    Examples
    --------
    All borders move by 1/2: a spring of stiffness 2 to ground for each of them, forces everywhere. One force
    alone moves its own border by less:

    >>> K, R = np.array([[2.0, -1.0], [-1.0, 2.0]]), np.array([[0.0], [1.0]])
    >>> sector = Part(np.array([0, 1]), K, np.array([0]), R, np.zeros((1, 1)))
    >>> sectors = [with_loads(sector, np.array([0]), np.array([k])) for k in range(3)]
    >>> [round(float(c), 4) for c in ring(sectors, 4).compliance[0]]
    [0.2917, 0.0833, 0.0417]
    """
    found = sectors[0]
    for sector in sectors[1:]:
        found = series(found, sector)
    rest = arc(sectors[0], z - len(sectors))
    closed = joined(between(found, 0, 1), between(rest, 1, 0))
    return eliminated(closed, closed.nodes)
