# SPDX-License-Identifier: Apache-2.0
"""Legendre polynomials over the face width: the functions of z of all displacements and loads.

Derivation: docs/theory/tooth_fe.md, "Twisted solid".
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class WidthBasis:
    """Polynomials ψ_p that are orthonormal over a width symmetric to z = 0.

    Parameters
    ----------
    width
        Width [m].
    count
        Number of polynomials.
    """

    width: float
    count: int

    def values(self, z: FloatArray) -> FloatArray:
        """Polynomials at positions [m], shape (n, count) [m^-1/2].

        Parameters
        ----------
        z
            Positions from the middle of the width [m], shape (n,).

        Examples
        --------
        >>> WidthBasis(2.0, 2).values(np.array([1.0])).round(6).tolist()    # √(1/2), √(3/2)
        [[0.707107, 1.224745]]
        """
        return np.asarray(legendre.legvander(2.0 * z / self.width, self.count - 1) * self._norm)

    @property
    def _norm(self) -> FloatArray:
        return np.sqrt((2.0 * np.arange(self.count) + 1.0) / self.width)

    @cached_property
    def slopes(self) -> FloatArray:
        """Matrix S of dψ_p/dz = Σ_r ψ_r S_rp [1/m], shape (count, count)."""
        found = np.zeros((self.count, self.count))
        for p in range(1, self.count):
            found[:p, p] = legendre.legder(np.eye(self.count)[p])[:p]
        return np.asarray(2.0 / self.width * found * self._norm[None, :] / self._norm[:, None])

    def means(self, borders: FloatArray) -> FloatArray:
        """Means of the polynomials over slices, shape (n, count) [m^-1/2].

        Parameters
        ----------
        borders
            Borders of the slices [m], shape (n + 1,), increasing.

        Examples
        --------
        >>> WidthBasis(2.0, 2).means(np.array([-1.0, 0.0, 1.0])).round(6).tolist()
        [[0.707107, -0.612372], [0.707107, 0.612372]]
        """
        t = 2.0 * borders / self.width
        integrals = np.empty((t.size, self.count))
        for p in range(self.count):
            integrals[:, p] = legendre.legval(t, legendre.legint(np.eye(self.count)[p]))
        return np.asarray(np.diff(integrals, axis=0) / np.diff(t)[:, None] * self._norm)

    def projection(self, other: WidthBasis) -> FloatArray:
        """Coefficients in this basis of the polynomials of a wider one, shape (count, other.count).

        Parameters
        ----------
        other
            A basis with at most as many polynomials.
        """
        points, weights = legendre.leggauss(self.count)
        z = 0.5 * self.width * points
        return np.asarray((self.values(z).T * (0.5 * self.width * weights)) @ other.values(z))
