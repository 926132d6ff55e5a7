# SPDX-License-Identifier: Apache-2.0
"""Legendre polynomials over the height of a tooth: projection of a compliance, and its fit.

Derivation: docs/theory/flank_compliance.md, "Height functions".
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial.legendre import legvander
from numpy.typing import NDArray

Array = NDArray[np.float64]

DIAGONAL = 10.0
"""Weight of a force observed at its own height, relative to all pairs of heights together."""
FLOOR = 0.1
"""Least compliance to which errors are relative, over the maximum."""


def dual(t: Array, order: int) -> Array:
    """Functions whose integrals with a function over −1 ≤ t ≤ 1 are its Legendre coefficients.

    Parameters
    ----------
    t
        Height coordinates, shape (n,).
    order
        Number of polynomials M.

    Returns
    -------
    ndarray, shape (n, M)
        (2 m + 1)/2 P_m(t).

    Examples
    --------
    >>> dual(np.array([0.5]), 2).tolist()
    [[0.5, 0.75]]
    """
    return np.asarray(legvander(t, order - 1) * (np.arange(order) + 0.5))


def fitted(t: Array, weights: Array, kernel: Array, order: int) -> Array:
    """Positive semidefinite coefficients C of a compliance, Σ P_m(t) C[m, n] P_n(t').

    Parameters
    ----------
    t, weights
        Gauss points and weights over −1 ≤ t ≤ 1, shape (n,).
    kernel
        Compliance between the heights, symmetric, shape (n, n).
    order
        Number of polynomials M.

    Returns
    -------
    ndarray, shape (M, M)

    Notes
    -----
    The compliance of a cantilever has a kink where both heights coincide, which a projection on few
    polynomials rounds off: it gives up to 10 % less (M = 4) where a force is observed at its own height, the
    case of most nodes. This is the least-squares fit of the errors relative to √(C(t, t) C(t', t')) with
    the weight 10 on t' = t; C(t, t) counts at least as a tenth of its maximum. If the fit is not positive
    definite, the weight is halved. Derivation: docs/theory/flank_compliance.md, "Height functions".

    Examples
    --------
    Stem of a cantilever in shear, C = min(1 + t, 1 + t') + 1:

    >>> from numpy.polynomial.legendre import leggauss
    >>> t, w = leggauss(20)
    >>> C = fitted(t, w, 2.0 + np.minimum(t[:, None], t), 4)
    >>> shape = legvander(np.array([-0.5, 0.0, 0.5]), 3)
    >>> np.einsum("im,mn,in->i", shape, C, shape).round(2).tolist()
    [1.5, 1.98, 2.5]
    """
    shape, diagonal = legvander(t, order - 1), np.diag(kernel)
    size = np.maximum(diagonal, FLOOR * diagonal.max())
    rows, columns = np.triu_indices(order)
    double = np.where(rows == columns, 0.5, 1.0)
    pairs = double * (
        shape[:, None, rows] * shape[None, :, columns] + shape[:, None, columns] * shape[None, :, rows]
    )
    scale = np.sqrt(np.outer(weights, weights) / np.outer(size, size))
    ends = 2.0 * double * shape[:, rows] * shape[:, columns]
    weight = DIAGONAL
    for _ in range(8):
        near = np.sqrt(weight * weights) / size
        left = np.concatenate([(pairs * scale[:, :, None]).reshape(-1, rows.size), ends * near[:, None]])
        right = np.concatenate([(kernel * scale).ravel(), diagonal * near])
        found = np.linalg.lstsq(left, right, rcond=None)[0]
        C = np.zeros((order, order))
        C[rows, columns] = found
        C[columns, rows] = found
        if np.linalg.eigvalsh(C)[0] > 0.0:
            return C
        weight *= 0.5
    part = dual(t, order) * weights[:, None]
    return np.asarray(part.T @ kernel @ part)


def congruence(before: Array, after: Array) -> Array:
    """Symmetric T nearest to the identity with T before T = after.

    Parameters
    ----------
    before, after
        Symmetric positive definite matrices, shape (M, M).

    Returns
    -------
    ndarray, shape (M, M)

    Notes
    -----
    Geometric mean of before⁻¹ and after (R. Bhatia, *Positive Definite Matrices*, 2007, ch. 4).

    Examples
    --------
    >>> congruence(np.diag([1.0, 4.0]), np.diag([4.0, 9.0])).round(12).tolist()
    [[2.0, 0.0], [0.0, 1.5]]
    """
    root = _power(before, 0.5)
    inverse = _power(before, -0.5)
    return np.asarray(inverse @ _power(root @ after @ root, 0.5) @ inverse)


def _power(matrix: Array, exponent: float) -> Array:
    values, vectors = np.linalg.eigh(0.5 * (matrix + matrix.T))
    return np.asarray((vectors * np.maximum(values, 0.0) ** exponent) @ vectors.T)
