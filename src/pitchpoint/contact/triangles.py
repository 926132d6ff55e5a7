# SPDX-License-Identifier: Apache-2.0
"""Triangle surfaces as data: faces with neighbours, centroids with areas, bounding-box trees of both.

A surface is packed into one float array: header (8 numbers), face tree, faces, centroid tree, centroids with
face areas, nodes, and neighbours of each node. A centroid represents its face only, so that the area on one
side of a sharp edge never acts on the other side. Trees are traversed without a stack: boxes are stored
depth first, each with the index of the next box if it is skipped.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.contact.triangle_search import FACE, HEADER, NODE
from pitchpoint.geometry.triangle_file import join_corners

LEAF = 4
"""Maximum number of items in a leaf of a tree."""

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]


def bounding_tree(low: FloatArray, high: FloatArray) -> tuple[FloatArray, IntArray]:
    """Bounding-box tree of items, split at the median along the longest side.

    Parameters
    ----------
    low, high
        Bounding boxes of the items [m], shape (n, 3).

    Returns
    -------
    ndarray, shape (m, 9)
        Low and high corner of each box, next box if its branch is skipped, first item and number of items
        (0 in inner nodes).
    ndarray, shape (n,)
        Order of the items in the leaves.

    Examples
    --------
    >>> x = np.arange(8.0)[:, None] * np.ones(3)
    >>> tree, order = bounding_tree(x, x)
    >>> tree[:, 6:].astype(int).tolist()
    [[3, 0, 0], [2, 0, 4], [3, 4, 4]]
    """
    boxes: list[list[float]] = []
    order: list[int] = []

    def grow(members: IntArray) -> None:
        """Add the box of the given items and, unless it is a leaf, those of its two halves."""
        at = len(boxes)
        lo, hi = low[members].min(axis=0), high[members].max(axis=0)
        boxes.append([*lo, *hi, 0.0, float(len(order)), 0.0])
        if members.size <= LEAF:
            order.extend(members.tolist())
            boxes[at][8] = members.size
        else:
            middle = low[members] + high[members]
            axis = int(np.argmax(np.ptp(middle, axis=0)))
            line = members[np.argsort(middle[:, axis], kind="stable")]
            grow(line[: line.size // 2])
            grow(line[line.size // 2 :])
        boxes[at][6] = len(boxes)

    grow(np.arange(len(low)))
    return np.array(boxes), np.array(order)


@dataclass(frozen=True)
class TriangleSurface:
    """Triangle mesh of a surface.

    Parameters
    ----------
    vertices
        Positions [m], shape (n, 3).
    faces
        Vertex indices of each triangle, counter-clockwise seen from outside, shape (m, 3).
    """

    vertices: FloatArray
    faces: IntArray

    @classmethod
    def from_triangles(cls, triangles: ArrayLike, tolerance: float = 1e-9) -> TriangleSurface:
        """Build a surface from separate triangles by merging coincident corners.

        Parameters
        ----------
        triangles
            Corners [m], shape (m, 3, 3), as returned by `geometry.solid.gear_solid`.
        tolerance
            Distance below which corners are merged, relative to the size of the surface.
        """
        corners = np.asarray(triangles, float).reshape(-1, 3)
        first, faces = join_corners(corners, tolerance)
        kept = (faces != np.roll(faces, 1, axis=1)).all(axis=1)  # drop degenerate triangles
        return cls(corners[first], faces[kept])

    def normals(self) -> tuple[FloatArray, FloatArray]:
        """Unit normals, shape (m, 3), and areas [m^2], shape (m,), of the faces.

        Raises
        ------
        ValueError
            If a triangle has no area.
        """
        a, b, c = (self.vertices[self.faces[:, k]] for k in range(3))
        across = np.cross(b - a, c - a)
        size = np.linalg.norm(across, axis=1)
        if np.any(size <= 0.0):
            raise ValueError(f"triangle {int(np.argmin(size))} has no area")
        return across / size[:, None], 0.5 * size

    def size(self) -> float:
        """Longest side of the bounding box [m]."""
        return float(np.ptp(self.vertices, axis=0).max())

    def is_closed(self) -> bool:
        """Whether every edge has a triangle on both sides."""
        one, two = self.faces.ravel(), np.roll(self.faces, -1, axis=1).ravel()
        many = len(self.vertices)
        return bool(np.isin(two * many + one, one * many + two).all())

    def packed(self) -> FloatArray:
        """The surface as one float array for the kernels, shape (n,).

        Raises
        ------
        ValueError
            If a triangle has no area, an edge has more than two triangles, or two adjacent triangles have
            opposite orientations.
        """
        normals, areas = self.normals()
        other = self._across()
        corner = self.vertices[self.faces]
        tree, order = bounding_tree(corner.min(axis=1), corner.max(axis=1))
        middle = corner.mean(axis=1)
        point_tree, point_order = bounding_tree(middle, middle)
        points = np.column_stack([middle, areas])[point_order]
        nodes, neighbours = self._nodes(normals, areas)
        faces = np.zeros((order.size, FACE))
        faces[:, :9], faces[:, 9:12] = corner[order].reshape(-1, 9), normals[order]
        owned = np.full(len(nodes), -1)
        rank = np.empty(order.size, np.int64)
        rank[order] = np.arange(order.size)
        for row, face in enumerate(order):
            for k in range(3):
                vertex, (across, opposite) = self.faces[face, k], other[face, k]
                faces[row, 12 + k] = vertex
                if owned[vertex] < 0:
                    owned[vertex], faces[row, 15 + k] = row, 1.0
                both = normals[face] + (normals[across] if across >= 0 else 0.0)
                faces[row, 18 + 3 * k : 21 + 3 * k] = both
                faces[row, 27 + k] = 1.0 if across < 0 or row < rank[across] else 0.0
                faces[row, 30 + k] = opposite
        header = np.zeros(HEADER)
        header[:5] = len(tree), len(faces), len(point_tree), len(nodes), neighbours.size
        parts = (header, tree, faces, point_tree, points, nodes, neighbours)
        return np.concatenate([np.asarray(part, float).ravel() for part in parts])

    def _across(self) -> NDArray[np.int64]:
        """Face across edge (k, k + 1) of each face and its far corner, shape (m, 3, 2); -1 at a border."""
        found = np.full((*self.faces.shape, 2), -1)
        edges: dict[tuple[int, int], tuple[int, int]] = {}
        for face, corners in enumerate(self.faces.tolist()):
            for k in range(3):
                edge = corners[k], corners[(k + 1) % 3]
                if edge in edges:
                    raise ValueError(f"triangles {edges[edge][0]} and {face} walk one edge the same way")
                edges[edge] = face, k
        for (a, b), (face, k) in edges.items():
            if (b, a) in edges:
                across, side = edges[b, a]
                found[face, k] = across, self.faces[across, (side + 2) % 3]
        return found

    def _nodes(self, normals: FloatArray, areas: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Nodes with angle-weighted normals, and the list of their neighbours."""
        nodes = np.zeros((len(self.vertices), NODE))
        nodes[:, :3] = self.vertices
        corner = self.vertices[self.faces]
        for k in range(3):
            one, two = (corner[:, (k + m) % 3] - corner[:, k] for m in (1, 2))
            angle = np.arctan2(2.0 * areas, np.einsum("ij,ij->i", one, two))
            np.add.at(nodes[:, 3:6], self.faces[:, k], normals * angle[:, None])
        pairs = np.concatenate([self.faces[:, [k, (k + 1) % 3]] for k in range(3)])
        pairs = np.unique(np.concatenate([pairs, pairs[:, ::-1]]), axis=0)
        nodes[:, 6] = np.searchsorted(pairs[:, 0], np.arange(len(nodes)))
        nodes[:, 7] = np.bincount(pairs[:, 0], minlength=len(nodes))
        return nodes, pairs[:, 1].astype(float)
