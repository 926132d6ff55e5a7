# SPDX-License-Identifier: Apache-2.0
"""Contents of a section through a gearbox as plain data: axes in the drawing plane with their parts [m]."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Piece:
    """Part of an axis in half section.

    Attributes
    ----------
    kind
        shaft, spindle (without data of its own), drum (connection of a ring gear), gear, teeth, pitch (line),
        inner, outer, element, linear, seat, pedestal (of a shaft without gears), held (of a fixed ring),
        plate, lining (of a clutch or brake), ground (of a brake), pin, flange, mass.
    line
        Corners as position along the axis and radius, shape (n, 2); closed except for pitch lines.
    name
        Name of a gear, bearing, coupling or body; empty for parts of one.
    words
        Second line of the label.
    sides
        Whether the upper and the lower half show it.
    """

    kind: str
    line: Array
    name: str = ""
    words: str = ""
    sides: tuple[bool, bool] = (True, True)


@dataclass(frozen=True, kw_only=True)
class SectionAxis:
    """An axis in the drawing plane.

    Attributes
    ----------
    origin
        Place of position 0 of the axis, shape (2,), y upwards [m].
    way, side
        Directions of the axis and of the upper half, unit vectors, shape (2,).
    pieces
        Its parts.
    name, words
        Names of its bodies, and their speeds and torques.
    """

    origin: Array
    way: Array
    side: Array
    pieces: Sequence[Piece]
    name: str = ""
    words: Sequence[str] = ()

    def at(self, line: Array, sign: float = 1.0) -> Array:
        """Points of the drawing plane for positions and radii of the upper (1) or lower (-1) half."""
        return self.origin + np.outer(line[:, 0], self.way) + sign * np.outer(line[:, 1], self.side)


@dataclass(frozen=True, kw_only=True)
class SectionLink:
    """A dimension between two axes, or a mesh whose gears are apart in the drawing.

    Attributes
    ----------
    start, end
        Points in the drawing plane, shape (2,) [m].
    words
        Its text.
    """

    start: Array
    end: Array
    words: str


@dataclass(frozen=True, kw_only=True)
class Section:
    """A gearbox in section.

    Attributes
    ----------
    title
        Title of the model.
    axes
        The axes.
    distances
        Centre distances.
    apart
        Meshes whose gears do not touch in the drawing plane.
    notes
        What is schematic.
    walls
        Cut walls of the housing: corners in the drawing plane, shape (n, 2) [m].
    """

    title: str
    axes: Sequence[SectionAxis]
    distances: Sequence[SectionLink] = ()
    apart: Sequence[SectionLink] = ()
    notes: Sequence[str] = ()
    walls: Sequence[Array] = ()
