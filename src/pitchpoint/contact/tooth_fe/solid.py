# SPDX-License-Identifier: Apache-2.0
"""Elements of one pitch of a gear as parts of a solid: section times width, with load cases.

Derivation: docs/theory/tooth_fe.md, "Twisted solid".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.tooth_fe.section_matrices import element_matrices
from pitchpoint.contact.tooth_fe.section_mesh import SectionMesh
from pitchpoint.contact.tooth_fe.substructure import Mesh, Part, condensed
from pitchpoint.contact.tooth_fe.width_basis import WidthBasis

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]


@dataclass(frozen=True)
class Freedoms:
    """Values of each node: components of the displacement times polynomials over the width.

    Parameters
    ----------
    components
        0 and 1 in the section, 2 along the axis; shape (d,).
    polynomials
        Number of the polynomial, shape (d,).
    """

    components: IntArray
    polynomials: IntArray


def freedoms(count: int, twisted: bool) -> list[Freedoms]:
    """Independent sets of values of a solid: one if it is twisted, else symmetric and antisymmetric to z = 0.

    Parameters
    ----------
    count
        Number of polynomials.
    twisted
        Whether the gear is helical.

    Examples
    --------
    >>> [f.components.size for f in freedoms(4, True) + freedoms(4, False)]
    [12, 6, 6]
    """
    components = np.repeat(np.arange(3), count)
    polynomials = np.tile(np.arange(count), 3)
    if twisted:
        return [Freedoms(components, polynomials)]
    parity = (polynomials + (components == 2)) % 2
    return [
        Freedoms(components[parity == k], polynomials[parity == k]) for k in (0, 1) if (parity == k).any()
    ]


PLANE_STRAIN = Freedoms(np.array([0, 1]), np.array([0, 0]))
"""Displacements in the section that do not depend on z."""


@dataclass(frozen=True)
class LoadCase:
    """Loads on one element.

    Parameters
    ----------
    element
        The element.
    columns
        Numbers of the load cases, shape (q,).
    values
        Loads on its nodes, shape (n, 3, polynomials, q).
    """

    element: int
    columns: IntArray
    values: FloatArray


@dataclass(frozen=True)
class Solid:
    """One pitch of a gear.

    Parameters
    ----------
    mesh
        Its section.
    z
        Number of teeth, positive.
    E, nu
        Young's modulus [Pa], Poisson's ratio.
    twist
        Rotation of the section per length [rad/m].
    rim, web
        Polynomials over the widths of teeth and rim, and of the web.
    """

    mesh: SectionMesh
    z: int
    E: float
    nu: float
    twist: float
    rim: WidthBasis
    web: WidthBasis | None = None

    @cached_property
    def matrices(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Energy matrices of all elements, see `element_matrices`; shape (m, 3 n, 3 n) each."""
        return element_matrices(self.mesh, self.E, self.nu, self.twist)

    @cached_property
    def axes(self) -> FloatArray:
        """Angles of the axes of the nodes [rad], shape (n,): radial and tangential on the borders."""
        angle = np.zeros(self.mesh.points.size)
        angle[self.mesh.clockwise], angle[self.mesh.counter] = -math.pi / self.z, math.pi / self.z
        return angle

    @cached_property
    def _on_rim(self) -> NDArray[np.bool_]:
        found = np.zeros(self.mesh.points.size, bool)
        found[self.mesh.elements[~self.mesh.web]] = True
        return found

    def condensed(
        self, elements: IntArray, free: Freedoms, fixed: IntArray, kept: IntArray, cases: list[LoadCase]
    ) -> Part:
        """Elements with their load cases, condensed to the kept nodes.

        Parameters
        ----------
        elements
            Numbers of the elements, shape (m,).
        free
            Values of each node.
        fixed
            Nodes without displacement.
        kept
            Nodes that are not eliminated.
        cases
            Load cases; those on other elements are ignored.
        """
        nodes = self.mesh.elements[elements].reshape(elements.size, -1)

        def leaf(k: int) -> Part:
            """Element number k of the group."""
            mine = [case for case in cases if case.element == elements[k]]
            return self._part(int(elements[k]), free, fixed, mine)

        return condensed(leaf, Mesh(nodes, self.mesh.grid[elements]), kept)

    def _part(self, element: int, free: Freedoms, fixed: IntArray, cases: list[LoadCase]) -> Part:
        """One element with its load cases."""
        c, p = free.components, free.polynomials
        is_web = self.web is not None and bool(self.mesh.web[element])
        basis = self.web if self.web is not None and is_web else self.rim
        nodes = self.mesh.elements[element].ravel()
        keep = np.flatnonzero(~np.isin(nodes, fixed))
        keep = keep[np.argsort(nodes[keep])]
        shape = (nodes.size, 3, nodes.size, 3)
        B, BC, C = (a[element].reshape(shape)[keep][:, c][:, :, keep][..., c] for a in self.matrices)
        unit, slope = np.eye(basis.count)[p][:, p], basis.slopes[p][:, p]
        curve = (basis.slopes.T @ basis.slopes)[p][:, p]
        mixed = BC * slope[:, None]
        K = B * unit[:, None] + mixed + mixed.transpose(2, 3, 0, 1) + C * curve[:, None]
        columns = np.concatenate([case.columns for case in cases]) if cases else np.empty(0, np.int64)
        R = np.zeros((keep.size, c.size, columns.size))
        if cases:
            R = np.concatenate([case.values[keep][:, c, p] for case in cases], axis=2)
            used = np.flatnonzero(np.abs(R).max(axis=(0, 1)) > 0.0)
            used = used[np.argsort(columns[used])]
            columns, R = columns[used], R[..., used]
        for k, node in enumerate(nodes[keep]):
            to = self._axes(node, is_web, free)
            if to is not None:
                K[k], R[k] = np.einsum("ab,anc->bnc", to, K[k]), to.T @ R[k]
                K[:, :, k] = K[:, :, k] @ to
        size = keep.size * c.size
        none = np.zeros((columns.size, columns.size))
        return Part(nodes[keep], K.reshape(size, size), columns, R.reshape(size, -1), none)

    def _axes(self, node: int, is_web: bool, free: Freedoms) -> FloatArray | None:
        """Values of a node in the axes and polynomials of an element by its shared ones, shape (d, d)."""
        c, p = free.components, free.polynomials
        angle = self.axes[node]
        restricted = is_web and self._on_rim[node]
        if angle == 0.0 and not restricted:
            return None
        turn = np.array(
            [
                [math.cos(angle), -math.sin(angle), 0.0],
                [math.sin(angle), math.cos(angle), 0.0],
                [0.0, 0.0, 1.0],
            ]
        )
        over = np.eye(self.rim.count)
        if restricted and self.web is not None:
            over = self.web.projection(self.rim)
        return np.asarray(turn[c][:, c] * over[p][:, p])
