# SPDX-License-Identifier: Apache-2.0
"""Share of the states of force elements in the eigenvalues of a linear system.

With the right and left eigenvector r and l of an eigenvalue, the participation factor of the unknown k is
p_k = l_k r_k / sum(l r) [1]_. Scaling an unknown, as by another unit, multiplies r_k and divides l_k. The sum
over the states does not change with other coordinates of the mechanism either; over all eigenvalues it sums
up to the number of states.

References
----------
.. [1] I. J. Perez-Arriaga, G. C. Verghese, F. C. Schweppe: Selective modal analysis with applications to
   electric power systems, Part I, IEEE Transactions on Power Apparatus and Systems PAS-101 (1982) 3117-3125.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

OWN = 0.2
"""Least share of the states in an eigenvalue that is listed as one of theirs. In a speed control with an
integrator states and speed have a half each, of a wind turbine a quarter and three quarters."""
SAME, ZERO = 1e-6, 1e-12
"""Relative distance of eigenvalues that are taken together, and eigenvalue over the largest that is zero."""


def state_shares(values: Complex, right: Complex, left: Complex, states: slice) -> Array:
    """Share of the states in each eigenvalue, between 0 and 1.

    With the sums a over the states and b over the other unknowns, a + b = 1, the share is
    |a| / (|a| + |b|): above one half if the real part of a is.

    Parameters
    ----------
    values
        Eigenvalues, shape (n,).
    right
        Right eigenvectors as columns, shape (N, n).
    left
        Left eigenvectors as columns, shape (N, n), times the matrix B of a pencil A - lambda B.
    states
        Rows of the states.

    Returns
    -------
    ndarray, shape (n,)

    Examples
    --------
    A speed control with an integrator, J w' = -k_p w - i, i' = k_i w, whose states have any unit:

    >>> for unit in (1.0, 1e3):
    ...     A = np.array([[-2.0, -1.0 / unit], [5.0 * unit, 0.0]])
    ...     values, right = np.linalg.eig(A)
    ...     print(state_shares(values, right, np.linalg.inv(right).T, slice(1, 2)).round(6))
    [0.5 0.5]
    [0.5 0.5]
    """
    distance = np.abs(values[:, None] - values)
    size = np.abs(values)
    near = distance <= np.maximum(SAME * size, ZERO * size.max(initial=0.0))
    own = np.zeros(right.shape[0], bool)
    own[states] = True
    found = np.zeros(len(values))
    for k, group in enumerate(near):
        members = np.flatnonzero(group)
        w = left[:, k]
        if members.size > 1:  # multiple eigenvalues: the left vector that is normal to the other right ones
            mix = np.linalg.pinv(left[:, members].T @ right[:, members])
            w = left[:, members] @ mix[members.searchsorted(k)]
        products = w * right[:, k]
        a, b = abs(products[own].sum()), abs(products[~own].sum())
        found[k] = a / (a + b) if a + b > 0.0 else 0.0
    return found
