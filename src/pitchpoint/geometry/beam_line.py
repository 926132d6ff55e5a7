# SPDX-License-Identifier: Apache-2.0
"""Curved and twisted axis of a beam over its length."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, eq=False, kw_only=True)
class BeamLine:
    """Axis of a beam and the axes of its sections, linear between the given positions.

    Parameters
    ----------
    position
        Positions from the first end, 0, to the second, 1, increasing, shape (n,).
    twist
        Rotation of the axes 1 and 2 about the beam axis, shape (n,) [rad]; empty for zero.
    offset_1, offset_2
        Position of the curved axis of the beam from the straight line between its ends, along the axes
        without twist, shape (n,) [m]; empty for zero.
    length
        Length of the line to which the table belongs [m]; 0: any.

    Examples
    --------
    >>> line = BeamLine(position=np.array([0.0, 1.0]), offset_1=np.array([0.0, 3.0]))
    >>> line.offset(np.array([0.5])).tolist()
    [[1.5, 0.0]]
    """

    position: FloatArray
    twist: FloatArray = ()  # type: ignore[assignment]
    offset_1: FloatArray = ()  # type: ignore[assignment]
    offset_2: FloatArray = ()  # type: ignore[assignment]
    length: float = 0.0

    def offset(self, at: FloatArray) -> FloatArray:
        """Curved axis of the beam from the straight line at positions, shape (m,) to (m, 2) [m]."""
        none = np.zeros(len(self.position))
        both = [values if len(values) else none for values in (self.offset_1, self.offset_2)]
        return np.stack([np.interp(at, self.position, values) for values in both], axis=1)

    def within(self, start: float, end: float) -> FloatArray:
        """Ends of a piece and the given positions between them, shape (m,).

        Parameters
        ----------
        start, end
            Ends of the piece, from 0 to 1.
        """
        inner = self.position[(self.position > start) & (self.position < end)]
        return np.asarray(np.r_[start, inner, end])

    def _position_problems(self) -> list[Message]:
        """Problem of the positions, if there is one."""
        x = self.position
        falling = np.flatnonzero(~(np.diff(x) > 0.0))
        if x.size < 2 or x[0] != 0.0 or x[-1] != 1.0:
            shown = f"{x.size} values" if x.size < 2 else f"{x[0]:g} to {x[-1]:g}"
            remedy = "give the places from the first end to the last"
            return [Message("position", "is not a list of increasing places", shown, "0 to 1", remedy)]
        if falling.size:
            k = int(falling[0]) + 1
            limit = f"> {x[k - 1]:g}"
            return [Message(f"position[{k}]", "does not increase", f"{x[k]:g}", limit, "sort the places")]
        return []
