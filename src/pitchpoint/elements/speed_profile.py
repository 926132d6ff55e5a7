# SPDX-License-Identifier: Apache-2.0
"""Speed over time as piecewise polynomials, accurate to nine digits for any duration.

The speed is interpolated at Chebyshev points on every piece, and pieces are halved until the error is small
enough. A smooth ripple needs two pieces of degree eight per period, where linear interpolation would need
thousands of points; the angle is the exact integral of the pieces.

Source: L. N. Trefethen, Approximation Theory and Approximation Practice, 2013, chapters 2 and 8.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import CompileError

Array = NDArray[np.float64]

DEGREE = 8
FIRST_PIECES = 2000
"""Initial number of pieces: a pulse of 1/10000 of the duration contains at least one sample point."""
MAX_PIECES = 1_000_000
"""Maximum number of pieces (about 100 MB)."""
MAX_SPLITS = 34
"""Maximum number of halvings of an initial piece: sufficient for a kink, not for a jump."""
RELATIVE, ABSOLUTE = 1e-9, 1e-12
"""Tolerances of the fit: relative to the maximum speed, and [rad/s]."""


class SpeedPieces(NamedTuple):
    """Speed over time as piecewise polynomials.

    Parameters
    ----------
    edges
        Ends of the pieces [s], shape (n + 1,), increasing.
    powers
        Coefficients of 1, x, x^2 ... of the speed [rad/s], x from -1 to 1 over a piece; shape
        (n, degree + 1).
    """

    edges: Array
    powers: Array

    def angles(self) -> Array:
        """Angle at the edges [rad], shape (n + 1,), 0 at t = 0 (constant speed beyond the ends)."""
        order = np.arange(1, self.powers.shape[1] + 1)
        # x^k/k from -1 to 1: twice 1/k for odd k
        turned = np.diff(self.edges) * (self.powers[:, ::2] / order[::2]).sum(axis=1)
        found = np.concatenate([[0.0], np.cumsum(turned)])
        if self.edges[0] >= 0.0:
            return np.asarray(found + self.speed(self.edges[0]) * self.edges[0])
        if self.edges[-1] <= 0.0:
            return np.asarray(found - found[-1] + self.speed(self.edges[-1]) * self.edges[-1])
        k = int(np.searchsorted(self.edges, 0.0, side="right")) - 1
        half = 0.5 * (self.edges[k + 1] - self.edges[k])
        x = -self.edges[k] / half - 1.0
        part = half * float((self.powers[k] / order * (x**order - (-1.0) ** order)).sum())
        return np.asarray(found - found[k] - part)

    def speed(self, t: ArrayLike) -> Array:
        """Speed at times [rad/s], shape of t."""
        at = np.clip(np.asarray(t, float), self.edges[0], self.edges[-1])
        k = np.clip(np.searchsorted(self.edges, at, side="right") - 1, 0, len(self.powers) - 1)
        x = 2.0 * (at - self.edges[k]) / (self.edges[k + 1] - self.edges[k]) - 1.0
        return np.asarray(
            np.polynomial.polynomial.polyval(x, np.moveaxis(self.powers[k], -1, 0), tensor=False)
        )


def straight_pieces(times: ArrayLike, speeds: ArrayLike) -> SpeedPieces:
    """Pieces of a speed table with linear interpolation.

    Parameters
    ----------
    times, speeds
        Points of the table [s], [rad/s], shape (n,) each, n >= 2, times increasing.
    """
    t, w = np.asarray(times, float), np.asarray(speeds, float)
    if t.ndim != 1 or t.shape != w.shape or t.size < 2 or np.any(np.diff(t) <= 0.0):
        raise ValueError("a speed table needs at least two points with increasing time")
    return SpeedPieces(t, 0.5 * np.stack([w[1:] + w[:-1], w[1:] - w[:-1]], axis=1))


def fit_pieces(
    speed: Callable[[Array], Array], begin: float, end: float, bends: ArrayLike = ()
) -> SpeedPieces:
    """Fit piecewise polynomials to a speed function.

    Parameters
    ----------
    speed
        Speed [rad/s] at times [s], both of shape (n,).
    begin, end
        Range of the pieces [s].
    bends
        Known times of kinks of the speed; they become edges.

    Raises
    ------
    CompileError
        If the speed jumps, or needs more than `MAX_PIECES`.

    Examples
    --------
    >>> pieces = fit_pieces(lambda t: np.minimum(10.0 * t, 7.0), 0.0, 1.0)
    >>> bool(abs(pieces.speed(0.70001) - 7.0) < 1e-8)
    True
    >>> float(pieces.angles()[-1].round(9))  # 0.7 s at half of 7 rad/s, 0.3 s at 7 rad/s
    4.55
    """
    nodes = -np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)
    between = -np.cos(np.pi * (np.arange(DEGREE) + 0.5) / DEGREE)
    to_powers = np.linalg.inv(np.vander(nodes, increasing=True)).T
    edges = np.unique(np.concatenate([np.linspace(begin, end, FIRST_PIECES + 1), np.asarray(bends, float)]))
    low, high = edges[:-1], edges[1:]
    kept: list[tuple[Array, Array]] = []
    greatest, count = 0.0, 0
    for _ in range(MAX_SPLITS + 1):
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        values = []
        for x in (nodes, between):
            at = (middle[:, None] + half[:, None] * x).ravel()
            values.append(speed(at).reshape(len(low), -1))
        greatest = max(greatest, *(float(np.abs(v).max()) for v in values))
        powers = values[0] @ to_powers
        left = np.abs(powers @ np.vander(between, DEGREE + 1, increasing=True).T - values[1]).max(axis=1)
        bad = ~(left <= RELATIVE * greatest + ABSOLUTE)
        kept.append((low[~bad], powers[~bad]))
        count += len(low)
        if not bad.any():
            starts = np.concatenate([k[0] for k in kept])
            order = np.argsort(starts)
            return SpeedPieces(np.append(starts[order], end), np.concatenate([k[1] for k in kept])[order])
        if count > MAX_PIECES:
            raise CompileError(
                f"a prescribed speed varies too fast from {begin:g} s to {end:g} s (limit {MAX_PIECES} "
                "polynomials); give a shorter duration, or the speed as a table"
            )
        middle = middle[bad]
        low, high = np.concatenate([low[bad], middle]), np.concatenate([middle, high[bad]])
    raise CompileError(
        f"a prescribed speed jumps at t = {low[0]:.6g} s, which requires an infinite torque; "
        "use ramp or smoothstep, or give the speed as a table"
    )
