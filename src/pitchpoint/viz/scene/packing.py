# SPDX-License-Identifier: Apache-2.0
"""Block of numbers of a scene: tables with invisible rounding, in the form that compresses best.

Numbers become multiples of a step. Differences from predecessors are passed to gzip, low and high bytes
separately: low bytes are noise, high bytes compress to almost nothing. Tables with correlated columns are
stored as the few columns from which they follow.
"""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Entry = dict[str, Any]

UNSEEN = 1.0 / 4094.0
"""Invisible fraction of the range of a track: a quarter of a pixel on a thousand pixels."""
LENGTH = 25e-9
"""Distance that is invisible even in views of micrometre gaps [m]."""
_TYPES = {"f8": "<f8", "f4": "<f4", "u4": "<u4", "u2": "<u2", "u1": "u1"}
_MIXED = 9
"""Maximum number of columns for the reduction to fewer ones."""
_TRIED = 200_000
"""Numbers of a table from which the best order of differences is found."""
_LEFT = 0.2
"""Share of the permitted error for the columns omitted from such a table."""


class Block:
    """Sequence of numbers; equal arrays are written once."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.known: dict[tuple[str, tuple[int, ...], bytes], Entry] = {}

    def put(self, values: ArrayLike, kind: str) -> Entry:
        """Header entry of an array, stored unchanged."""
        array = np.ascontiguousarray(values, dtype=_TYPES[kind])
        return self._add(kind, array.shape, array.tobytes())

    def put_steps(self, values: ArrayLike, step: ArrayLike, across: bool = False) -> Entry:
        """Header entry of a table of multiples of a step, including zero.

        Parameters
        ----------
        values
            Shape (n, ...).
        step
            One step, or one per index of the last axis; zero if all values are zero.
        across
            Whether neighbours along the last axis, not the first, are similar.
        """
        array = np.asarray(values, dtype=np.float64)
        each = array.shape[-1] if array.ndim > 1 else 1
        steps = np.array([_short(x) for x in np.broadcast_to(np.asarray(step, float), each)])
        levels = np.rint(array.reshape(-1, each) / np.where(steps > 0.0, steps, 1.0)).astype(np.int64)
        levels = levels.T if across else levels.reshape(len(array), -1)
        found = {**self._planes(levels, array.shape), "scale": steps.tolist()}
        return {**found, "across": True} if across else found

    def put_whole(self, values: ArrayLike) -> Entry:
        """Header entry of a table of integers."""
        array = np.asarray(values, dtype=np.int64)
        return self._planes(array.reshape(len(array), -1), array.shape)

    def put_track(self, values: ArrayLike, within: float) -> Entry:
        """Header entry of a table over time with a maximum error `within`.

        Parameters
        ----------
        values
            Shape (n,) or (n, k).
        within
            Maximum error of a number.
        """
        return self.put_tracks([np.asarray(values, dtype=np.float64)], within)[0]

    def put_tracks(self, tables: Sequence[Array], within: float) -> list[Entry]:
        """Header entries of several such tables, which may follow from the same columns.

        Parameters
        ----------
        tables
            Each of shape (n,) or (n, k).
        within
            As above, for all of them.
        """
        wide = [table.reshape(len(table), -1) for table in tables]
        bases = [_basis(table, within) for table in wide]
        if len(wide) > 1:
            common = _basis(np.concatenate(wide, axis=1), within)
            if 0 < len(common) < sum(len(basis) for basis in bases):
                return self._mixed(wide, common, within)
        return [self._track(*one, within) for one in zip(tables, wide, bases, strict=True)]

    def _track(self, given: Array, table: Array, basis: Array, error: float) -> Entry:
        """Header entry of a single table, with all axes except the first as columns."""
        low, high = table.min(axis=0), table.max(axis=0)
        if (high - low).max(initial=0.0) <= error:
            # constant: stored as one row
            return self.put((0.5 * (low + high)).reshape(1, *given.shape[1:]), "f8")
        if len(basis) < table.shape[1]:
            return self._mixed([table], basis, error)[0]
        return self.put_steps(given, 1.99 * error)

    def _mixed(self, tables: Sequence[Array], basis: Array, error: float) -> list[Entry]:
        """Tables as combinations of common columns."""
        together = np.concatenate(tables, axis=1)
        mean = together.mean(axis=0)
        digits = _digits(np.ptp(together, axis=0), error)
        rows = np.array([[_short(x, digits) for x in row] for row in basis]).reshape(len(basis), -1)
        mean = np.array([_short(x, _digits(mean, error)) for x in mean])
        step = 2.0 * (1.0 - _LEFT) * error / np.sqrt(max(1, len(rows)))
        stored = self.put_steps((together - mean) @ rows.T, step)
        found, at = [], 0
        for table in tables:
            part = slice(at, at + table.shape[1])
            found.append({**stored, "mix": rows[:, part].tolist(), "offset": mean[part].tolist()})
            at = part.stop
        return found

    def _planes(self, levels: NDArray[np.int64], shape: tuple[int, ...]) -> Entry:
        """Integers as byte planes of their differences of the order that compresses best."""
        few = levels[:, :: 1 + levels.size // _TRIED]
        order = min(
            range(min(3, max(1, len(levels)))), key=lambda order: len(zlib.compress(_bytes(few, order)[0], 6))
        )
        planes, count = _bytes(levels, order)
        found = self._add(f"planes {count} {order}", shape, planes)
        return {**found, "type": "planes", "bytes": count, "differences": order}

    def _add(self, kind: str, shape: tuple[int, ...], data: bytes) -> Entry:
        key = (kind, shape, data)
        if key not in self.known:
            self.data += b"\0" * (-len(self.data) % 8)
            self.known[key] = {"at": len(self.data), "type": kind, "shape": list(shape)}
            self.data += data
        return dict(self.known[key])


def unseen(values: Array, within: float) -> float:
    """Invisible error of a motion, also if magnified: a distance, or a fraction of the range if smaller."""
    way = float(np.ptp(values, axis=0).max(initial=0.0))
    return min(within, UNSEEN * way) if way > 0.0 else within


def _bytes(levels: NDArray[np.int64], order: int) -> tuple[bytes, int]:
    """Byte planes of the differences of some order, and their number."""
    zigzag = _differences(levels, order).T
    count = max(1, -(-int(zigzag.max(initial=0)).bit_length() // 8))
    return b"".join(((zigzag >> 8 * p) & 255).astype(np.uint8).tobytes() for p in range(count)), count


def _differences(levels: NDArray[np.int64], order: int) -> NDArray[np.int64]:
    """Differences from the first row, the previous row, or linear extrapolation; signs in the last bit."""
    found = levels.copy()
    if order == 0:
        found[1:] -= levels[0]
    else:
        found[1:] = np.diff(levels, axis=0)
        if order == 2:
            found[2:] = np.diff(levels, n=2, axis=0)
    return (found << 1) ^ (found >> 63)


def _basis(table: Array, error: float) -> Array:
    """Principal directions of a table as rows, the minimum number for a share of the error."""
    width = table.shape[1]
    if width > _MIXED or width == 1 or len(table) < 8 * width:
        return np.eye(width)
    moved = table - table.mean(axis=0)
    rows = np.linalg.svd(moved, full_matrices=False)[2]
    for count in range(width):
        left = moved - moved @ rows[:count].T @ rows[:count]
        if np.abs(left).max() <= _LEFT * error:
            return np.asarray(rows[:count])
    return np.eye(width)


def _digits(values: Array, error: float) -> int:
    """Digits that represent numbers of a magnitude within 1 % of the error."""
    return int(np.clip(np.ceil(np.log10(max(float(np.abs(values).max()), error) / error)) + 3, 4, 17))


def _short(value: float, digits: int = 4) -> float:
    """Number in short notation."""
    return float(f"{value:.{digits}g}")
