# SPDX-License-Identifier: Apache-2.0
"""Mesh stiffness as a table over the mesh phase."""

from __future__ import annotations

from numpy.typing import ArrayLike

from pitchpoint.contact.stiffness.description import PhaseStiffness, frozen_array, require_positive
from pitchpoint.geometry.gear_pair import GearPair


def table(pair: GearPair | None, *, values: ArrayLike) -> PhaseStiffness:
    """Describe a mesh stiffness by its values at equal steps of the mesh phase.

    Parameters
    ----------
    pair
        The gear pair; not used.
    values
        Stiffness along the base tangent [N/m], shape (n,), at psi = i/n, n >= 2; periodic with linear
        interpolation.

    Raises
    ------
    ModelError
        If a value is not positive and finite.

    Examples
    --------
    >>> law = table(None, values=[3.0e8, 5.0e8])
    >>> law.mean, law.ratio([0.25, 0.75]).tolist()
    (400000000.0, [1.0, 1.0])
    """
    array = frozen_array("stiffness.values", values, 2)
    mean = float(array.mean())  # also the integral mean of the periodic linear interpolation
    return require_positive("stiffness.values", PhaseStiffness(mean=mean, table=array / mean))
