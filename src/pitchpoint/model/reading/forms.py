# SPDX-License-Identifier: Apache-2.0
"""Readers of special values: gears of a body, speeds by name, matrices, orders."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from pitchpoint.model.keys import BAD, Key, Place
from pitchpoint.model.origin import Source
from pitchpoint.model.reading import signals
from pitchpoint.model.show import shown

if TYPE_CHECKING:
    from pitchpoint.model.reading.reader import Reader


ROUNDED = 1e-3
"""Negative eigenvalue of a scaled matrix that is attributed to rounded entries."""


def gears(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a list of gear names or a mapping of names to axial positions."""
    if isinstance(data, Mapping):
        axial = Key("quantity", key.meaning, dimension="length")
        return signals.mapping(reader, axial, data, path, type(reader).number)
    found = reader.names(key, data, path)
    if found is BAD:
        return BAD
    twice = sorted({n for n in found if found.count(n) > 1})
    if twice:
        return reader.problem(path, f"names {', '.join(twice)} twice", remedy="name each gear once")
    return dict.fromkeys(found, 0.0)


def speeds(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a mapping of names to quantities."""
    speeds = signals.mapping(reader, key, data, path, type(reader).number, "names", "write {BODY: 1500 rpm}")
    if speeds is BAD:
        return BAD
    written = {(*path, str(n)): Source(v, frozenset()) for n, v in data.items() if isinstance(v, str)}
    reader.sources |= written  # each with its unit
    return speeds


def matrix(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a symmetric 6x6 matrix of SI numbers."""
    six = "six rows of six numbers in SI units"
    row = Key("quantities", "", dimension="dimensionless", length=(6, 6), sample=six)
    rows = reader.sequence(row, data, path, lambda k, entry, at: signals.values(reader, k, entry, at))
    if rows is BAD:
        return BAD
    size = max(abs(v) for r in rows for v in r)
    for i in range(6):
        for j in range(i):
            if abs(rows[i][j] - rows[j][i]) > 1e-9 * size:
                remedy = f"entries [{i}][{j}] and [{j}][{i}] must agree"
                return reader.problem(path, "is not symmetric", remedy=remedy)
    least = _least_eigenvalue(rows)
    if least < -ROUNDED:
        return reader.problem(
            path,
            "is not positive semidefinite: one of its eigenvalues is negative",
            remedy="correct the signs, or the off-diagonal entries",
        )
    return rows


def matrices(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a list of symmetric 6x6 matrices of SI numbers."""
    return reader.sequence(key, data, path, lambda k, entry, at: matrix(reader, k, entry, at))


def _least_eigenvalue(rows: Sequence[Sequence[float]]) -> float:
    """Smallest eigenvalue of a symmetric matrix with its diagonal scaled to 1: it mixes N/m and N m/rad."""
    import numpy as np

    matrix = np.array(rows)
    size = np.abs(matrix.diagonal())
    scale = np.sqrt(np.where(size > 0.0, size, max(float(np.max(np.abs(matrix))), 1e-300)))
    return float(np.linalg.eigvalsh(matrix / np.outer(scale, scale))[0])


def orders(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a mapping of orders to [amplitude, phase]."""
    if not isinstance(data, Mapping):
        return reader.problem(path, "is not a mapping", value=shown(data), remedy="write {1: [20 um, 0 deg]}")
    whole = Key("integer", "", minimum=1, maximum=10**6)
    length, angle = Key("quantity", "", dimension="length"), Key("quantity", "", dimension="angle")
    out = []
    for order, pair in data.items():
        at = (*path, str(order))
        n = reader.whole(whole, int(order) if str(order).isdecimal() and len(str(order)) < 9 else order, at)
        if not isinstance(pair, list | tuple) or len(pair) != 2:
            reader.problem(at, "is not [amplitude, phase]", value=shown(pair), remedy="write [20 um, 0 deg]")
            continue
        found = (n, reader.number(length, pair[0], (*at, 0)), reader.number(angle, pair[1], (*at, 1)))
        if BAD not in found:
            out.append(found)
    return tuple(out)
