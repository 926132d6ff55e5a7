# SPDX-License-Identifier: Apache-2.0
"""Rank-one correction of the tangent from the last step, for iterations that converge slowly.

The tangents of meshes hold the phase constant (docs/decisions/0006-frozen-phase-tangents.md). On the edge
of a flank that is partly in contact, the force changes as much by the phase as by the deflection, and
iterations with this tangent converge linearly or not at all. The last step s shows how the force really
changes: with y = R(q + s) - R(q) - K s the corrected tangent K + y (M s)^T/(s^T M s) maps s to it [1]_.

References
----------
.. [1] C. G. Broyden: A class of methods for solving nonlinear simultaneous equations, Mathematics of
   Computation 19 (1965) 577-593.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

Inverse = Callable[[Array], Array]
"""Function that solves A x = b."""

LEAST = 0.1
"""Change of the determinant by a correction, below which it is omitted: the stiffness would be negative."""


def corrected(inverse: Inverse, step: Array, missed: Array, mass: Any) -> Inverse:
    """Solution with the tangent corrected by a step, by the formula of Sherman and Morrison.

    Parameters
    ----------
    inverse
        Solution with the tangent, plus mass times a factor.
    step
        The step s, shape (n,).
    missed
        Change y of the residual that the tangent did not predict, shape (n,).
    mass
        Mass matrix, shape (n, n).

    Examples
    --------
    A spring with the tangent 2 and the true stiffness 5, after a step of 0.1:

    >>> solve = corrected(lambda b: b / 2.0, np.array([0.1]), np.array([0.3]), np.eye(1))
    >>> solve(np.array([10.0])).round(12).tolist()
    [2.0]
    """
    moved = mass @ step
    along = moved / float(step @ moved)
    shift = inverse(missed)
    change = 1.0 + float(along @ shift)
    if not change > LEAST:
        return inverse

    def solve(b: Array) -> Array:
        """Solution of the corrected system."""
        found = inverse(b)
        return found - shift * (float(along @ found) / change)

    return solve
