# SPDX-License-Identifier: Apache-2.0
"""Surfaces of solids from CAD files, simplified for the scene."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.solid_file import STEP
from pitchpoint.geometry.triangle_file import join_corners, placed_triangles, read_triangles

if TYPE_CHECKING:
    from pitchpoint.model.components.solid import SolidReference

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

MAX_TRIANGLES = 50_000
"""Maximum number of triangles of a solid: more make a page large and slow without visible benefit."""
_CELLS, _COARSER = 512, 0.75
"""Initial number of grid cells along a solid for merging corners, and its reduction per attempt."""


def surface_of(reference: SolidReference) -> tuple[Array, Indices]:
    """Points [m] in the axes of the file, shape (n, 3), and triangles of the solid of a body.

    Parameters
    ----------
    reference
        The solid.

    Raises
    ------
    GeometryError
        If the file cannot be read.
    MissingDependencyError
        If it is a STEP file and OCC is not installed.
    """
    if Path(reference.file).suffix.lower() in STEP:
        from pitchpoint.geometry.step_triangles import step_triangles

        corners = step_triangles(reference.file, reference.solid().name)
    else:
        corners = placed_triangles(read_triangles(reference.file), reference.unit or 1.0)
    first, triangles = join_corners(corners)
    return fewer_triangles(corners.reshape(-1, 3)[first], triangles, MAX_TRIANGLES)


def fewer_triangles(points: Array, triangles: Indices, most: int) -> tuple[Array, Indices]:
    """A surface with at most so many triangles, none of which is new.

    Parameters
    ----------
    points, triangles
        Shapes (n, 3) and (m, 3).
    most
        Triangles that are not too many.

    Notes
    -----
    Corners in the same cell of a grid become one, in their middle [1]_; triangles that lose a corner by it
    go. The finest of some grids that suffices is taken: no point moves by more than a cell.

    References
    ----------
    .. [1] J. Rossignac, P. Borrel, Multi-resolution 3D approximations for rendering complex scenes, in
       Modeling in Computer Graphics, Springer, 1993, 455-465.
    """
    low = points.min(axis=0)
    size = float(np.ptp(points, axis=0).max())
    cells = float(_CELLS)
    found, kept = points, triangles
    while len(kept) > most:
        grid = np.floor((points - low) / size * cells).astype(np.int64)
        _, cell, count = np.unique(grid, axis=0, return_inverse=True, return_counts=True)
        cell = cell.reshape(-1)
        sums = [np.bincount(cell, points[:, axis]) for axis in range(3)]
        found = np.stack(sums, axis=1) / count[:, None]
        kept = cell[triangles]
        kept = kept[(kept[:, 0] != kept[:, 1]) & (kept[:, 1] != kept[:, 2]) & (kept[:, 2] != kept[:, 0])]
        cells *= _COARSER
    return found, kept
