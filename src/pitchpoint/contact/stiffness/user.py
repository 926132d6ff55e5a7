# SPDX-License-Identifier: Apache-2.0
"""Mesh stiffness from a user-defined Python function of the mesh phase."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pitchpoint.contact.stiffness.description import PhaseStiffness, refuse
from pitchpoint.contact.stiffness.table import table
from pitchpoint.geometry.gear_pair import GearPair


def user(pair: GearPair | None, *, function: Callable[[float], float], points: int = 1024) -> PhaseStiffness:
    """Describe a mesh stiffness by a function k(psi) over one period.

    Parameters
    ----------
    pair
        The gear pair; not used.
    function
        Returns the stiffness along the base tangent [N/m] at a phase in [0, 1). It is called `points` times
        here and never during time integration.
    points
        Number of equal steps of the table that replaces the function. The error of the linear interpolation
        is at most max|k''|/(8 points^2); a jump is spread over one step.

    Raises
    ------
    ModelError
        If the function fails, or returns anything but positive finite numbers.

    Examples
    --------
    >>> law = user(None, function=lambda psi: 3.0e8 if psi < 0.5 else 2.0e8, points=100)
    >>> round(law.mean / 1e8, 9)
    2.5
    """
    try:
        values = np.array([float(function(i / points)) for i in range(points)])
    except Exception as error:
        raise refuse(
            "stiffness.function", f"failed: {error}", type(error).__name__, "none", "correct the function"
        ) from error
    return table(pair, values=values)
