# SPDX-License-Identifier: Apache-2.0
"""Stiffness of one tooth pair as a table along its path of contact."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.contact.stiffness.description import PairShape, positive
from pitchpoint.geometry.gear_pair import GearPair


def pair_table(
    pair: GearPair | None, *, single_stiffness: float, values: ArrayLike, tip_relief_factor: float = 0.0
) -> PairShape:
    """Describe a pair by its stiffness at equally spaced points of the path of contact.

    Parameters
    ----------
    pair
        The gear pair; not used.
    single_stiffness
        Single stiffness c' per unit face width [N/m^2].
    values
        Stiffness relative to c' at n points from A to E, both included, shape (n,), n >= 2; linear
        interpolation.
    tip_relief_factor
        Length of the ramps at A and E over frac(eps_alpha), T_R, in [0, 1].

    Raises
    ------
    ModelError
        If c' is not positive and finite, or the table is invalid.

    Examples
    --------
    >>> pair_table(None, single_stiffness=14e9, values=[0.8, 1.0, 0.8]).table.tolist()
    [0.8, 1.0, 0.8]
    """
    positive("stiffness.single_stiffness", single_stiffness, "N/m^2")
    return PairShape(c_prime=single_stiffness, T_R=tip_relief_factor, table=np.array(values))
