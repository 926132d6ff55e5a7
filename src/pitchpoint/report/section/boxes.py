# SPDX-License-Identifier: Apache-2.0
"""Rectangles of an axis in half section: positions along the axis and radii."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def box_line(low: float, high: float, inner: float, outer: float) -> Array:
    """Corners of a rectangle: positions from low to high, radii from inner to outer [m]."""
    return np.array([(low, inner), (high, inner), (high, outer), (low, outer)])


def span_line(start: float, length: float, inner: float, outer: float) -> Array:
    """Corners of a rectangle from a position over a length of either sign [m]."""
    return box_line(min(start, start + length), max(start, start + length), inner, outer)


def extent(pieces: Sequence[Any]) -> tuple[float, float]:
    """Ends of some pieces along the axis [m]."""
    ends = np.concatenate([piece.line[:, 0] for piece in pieces])
    return float(ends.min()), float(ends.max())
