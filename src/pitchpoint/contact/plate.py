# SPDX-License-Identifier: Apache-2.0
"""Rectangular plate as integration points for its contact with a plane."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.triangle_search import FACE, HEADER
from pitchpoint.contact.triangles import bounding_tree

CELLS = 8
"""Cells along each side; each has 2 x 2 Gauss points."""


def plate_points(sides: Sequence[float]) -> NDArray[np.float64]:
    """Integration points of a plate as the centroids of a packed surface (`triangles.TriangleSurface`).

    The weights sum to 1, so that a contact law is that of the whole plate. Gauss points of cells integrate a
    linear penetration and its moments exactly while the whole plate is in contact. The corners have no
    weight: they are the points with the smallest gap. Derivation: docs/theory/contacts.md, "Surfaces".

    Parameters
    ----------
    sides
        Lengths along x and y [m]; the plate is centred in the plane z = 0.

    Returns
    -------
    ndarray, shape (n,)
        Packed surface with faces that no function reads.

    Examples
    --------
    >>> packed = plate_points([0.08, 0.04])
    >>> points = packed[-4 * (4 * CELLS**2 + 4) :].reshape(-1, 4)
    >>> inertia = (points[:, 3:] * points[:, :2] ** 2).sum(axis=0)
    >>> round(float(points[:, 3].sum()), 12), (12 * inertia / [0.08**2, 0.04**2]).round(12).tolist()
    (1.0, [1.0, 1.0])
    """
    gauss, weight = np.polynomial.legendre.leggauss(2)
    along = ((np.arange(CELLS)[:, None] + 0.5 + 0.5 * gauss) / CELLS - 0.5).ravel()
    share = np.tile(0.5 * weight / CELLS, CELLS)
    x, y = (grid.ravel() for grid in np.meshgrid(sides[0] * along, sides[1] * along))
    inner = np.column_stack([x, y, np.zeros_like(x), np.outer(share, share).ravel()])
    signs = [(a, b) for a in (-0.5, 0.5) for b in (-0.5, 0.5)]
    corners = np.array([(a * sides[0], b * sides[1], 0.0, 0.0) for a, b in signs])
    points = np.concatenate([inner, corners])
    tree, order = bounding_tree(points[:, :3], points[:, :3])
    header = np.zeros(HEADER)
    header[1], header[2] = len(points), len(tree)
    unused = np.zeros(len(points) * FACE)  # a packed surface has a face for every centroid
    return np.concatenate([header, unused, tree.ravel(), points[order].ravel()])
