# SPDX-License-Identifier: Apache-2.0
"""Constant mesh stiffness, independent of the mesh phase."""

from __future__ import annotations

from pitchpoint.contact.stiffness.description import PhaseStiffness
from pitchpoint.geometry.gear_pair import GearPair


def constant(pair: GearPair | None, *, mean: float) -> PhaseStiffness:
    """Describe a mesh of constant stiffness.

    Parameters
    ----------
    pair
        The gear pair; not used.
    mean
        Mesh stiffness along the base tangent [N/m].

    Examples
    --------
    >>> constant(None, mean=1.0e5).ratio([0.0, 0.3]).tolist()
    [1.0, 1.0]
    """
    return PhaseStiffness(mean=mean)
