# SPDX-License-Identifier: Apache-2.0
"""Generalised symmetric eigenproblem without SciPy, whose import would double the time of a short command."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def symmetric_pencil(K: Array, M: Array) -> tuple[Array, Array]:
    """Solve K x = w M x: ascending w, shape (n,), and columns x with x^T M x = 1, shape (n, n).

    Parameters
    ----------
    K
        Symmetric matrix, shape (n, n).
    M
        Symmetric positive definite matrix, shape (n, n).

    Raises
    ------
    numpy.linalg.LinAlgError
        If M is not positive definite.

    References
    ----------
    .. [1] G. H. Golub, C. F. Van Loan: Matrix Computations, 4th ed., algorithm 8.7.1: M = L L^T reduces it to
    the
       standard eigenproblem of L^-1 K L^-T.

    Examples
    --------
    >>> symmetric_pencil(np.array([[2.0, 0.0], [0.0, 3.0]]), np.diag([4.0, 1.0]))[0].round(12)
    array([0.5, 3. ])
    """
    L = np.linalg.cholesky(M)
    half = np.linalg.solve(L, np.linalg.solve(L, K).T)
    values, vectors = np.linalg.eigh(0.5 * (half + half.T))
    return values, np.asarray(np.linalg.solve(L.T, vectors))
