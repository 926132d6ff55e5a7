# SPDX-License-Identifier: Apache-2.0
"""Transmission error over the mesh phase with its kinks, from values and slopes at a few phases."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

BEHIND = 1.0 / 64.0
"""Distance of the second phase at each position, over the distance of positions."""


def kinks(values: Array, slopes: Array) -> Array:
    """Intersections of the tangents at neighbouring positions of a periodic curve.

    Parameters
    ----------
    values
        Values at equidistant positions, last axis of n positions.
    slopes
        Slopes there, per distance of positions, same shape.

    Returns
    -------
    ndarray
        Value at the intersection between each position and the next, NaN if there is none; same shape.

    Notes
    -----
    Where a relief begins or a pair leaves contact the curve has a kink; for piecewise linear curves it is
    exact. At a smooth maximum the intersection exceeds it by at most c h²/4, with half the second
    derivative c and the distance h of the positions.

    Examples
    --------
    A roof with its ridge of 1.0 between two of four positions:

    >>> kinks(np.array([0.25, 0.75, 0.75, 0.25]), np.array([0.5, 0.5, -0.5, -0.5]))[1]
    np.float64(1.0)
    """
    later, its_slopes = np.roll(values, -1, axis=-1), np.roll(slopes, -1, axis=-1)
    with np.errstate(divide="ignore", invalid="ignore"):
        place = (later - values - its_slopes) / (slopes - its_slopes)
    inside = (place > 0.0) & (place < 1.0)
    return np.where(inside, values + slopes * np.where(inside, place, 0.0), np.nan)


@dataclass(frozen=True)
class Curves:
    """Result of one analysis over the mesh phase.

    Parameters
    ----------
    points
        Approach of the flanks along the base tangent [m], shape (misalignments, torques, 2 positions): at the
        positions, then at the kinks behind each, NaN where there is none.
    pressure
        Maximum Hertzian pressure on the path of contact [Pa], shape (misalignments, torques, positions).
    edge
        Share of the load on tip edges [-], likewise.
    """

    points: Array
    pressure: Array
    edge: Array

    @classmethod
    def of(cls, approach: Array, pressure: Array, edge: Array) -> Curves:
        """Curves from values at all positions and then close behind them, last axis of 2 positions."""
        n = approach.shape[-1] // 2
        values = approach[..., :n]
        points = np.concatenate([values, kinks(values, (approach[..., n:] - values) / BEHIND)], axis=-1)
        return cls(points, pressure[..., :n], edge[..., :n])

    @property
    def approach(self) -> Array:
        """Approach of the flanks at the positions [m], shape (misalignments, torques, positions)."""
        return self.points[..., : self.points.shape[-1] // 2]

    @property
    def peak_to_peak(self) -> Array:
        """Peak-to-peak transmission error with its kinks [m], shape (misalignments, torques)."""
        return np.asarray(np.nanmax(self.points, axis=-1) - np.nanmin(self.points, axis=-1))
