# SPDX-License-Identifier: Apache-2.0
"""Bodies that float in a clearance, in equilibrium, while other coordinates are still unbalanced.

A floating direction has no stiffness: a residual force f moves it by f/(mu m) with the mass factor mu. As mu
falls, residual forces far below the tolerance move a body so far that the forces of other coordinates change
(the common face width of a shaft that moves along its axis, for instance), and the iteration stagnates. The
force in the floating directions is therefore separated, F x with the filter

    F = (mu M (K + mu M)^-1)^n

which is 1 for stiffness k << mu m and (mu m/k)^n for k >> mu m. If every component of F R is within the
tolerance, these directions are in equilibrium as they are, and only the rest of R is to be balanced.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

ORDER = 4
"""Order n of the filter."""


def floating_force(force: Array, mass: Any, mu: float, inverse: Callable[[Array], Array]) -> Array:
    """Part of a force that acts in directions with a stiffness far below the mass times `mu`.

    Parameters
    ----------
    force
        Force, shape (n,).
    mass
        Mass matrix, shape (n, n).
    mu
        Mass factor [1/s^2].
    inverse
        Function that solves (K + mu M) x = b.

    Examples
    --------
    A free mass and one on a spring with k/m = 100 mu:

    >>> floating_force(np.ones(2), np.eye(2), 1.0, lambda b: b / np.array([1.0, 101.0])).round(8)
    array([1.e+00, 1.e-08])
    """
    for _ in range(ORDER):
        force = mu * (mass @ inverse(force))
    return force


def balanced_drift(
    force: Array, mass: Any, mu: float, inverse: Callable[[Array], Array], allowed: Array
) -> Array | None:
    """The `floating_force` if every component is within `allowed`, else None; other arguments as there."""
    found = floating_force(force, mass, mu, inverse)
    return found if bool((np.abs(found) <= allowed).all()) else None
