# SPDX-License-Identifier: Apache-2.0
"""Flank gaps of a mesh from the wear in a model."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.stiffness.description import Description, PairShape
from pitchpoint.contact.wear import wear_pattern
from pitchpoint.geometry.modifications import base_tangent
from pitchpoint.model.components.tooth_faults import Wear
from pitchpoint.system.rules.separation import Worn

if TYPE_CHECKING:
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.model.components.gear import Gear

Array = NDArray[np.float64]


def worn_flanks(
    pair: GearPair, stiffness: Description, gears: Sequence[Gear], offsets: tuple[float, float]
) -> tuple[Worn, Worn]:
    """Gaps due to wear on the flanks of both gears in one mesh; None for a gear without wear.

    Parameters
    ----------
    pair
        The gear pair at its working centre distance.
    stiffness
        Stiffness description, which determines the load sharing.
    gears
        Gear 1 and gear 2.
    offsets
        Positions of the middle of the common face width relative to the mid-faces of both gears [m].
    """
    first, second = (_worn(pair, stiffness, gears[k], k, offsets[k]) for k in range(2))
    return first, second


def _worn(pair: GearPair, stiffness: Description, gear: Gear, number: int, offset: float) -> Worn:
    faults = [fault for fault in gear.faults.values() if isinstance(fault, Wear)]
    if not faults or not isinstance(stiffness, PairShape):
        return None

    def gap(front: int, flank: str, z: Array, roll: Array) -> Array:
        """Total wear of a flank along the base tangent [m]."""
        helix = math.tan(pair.gear1.beta_b) / pair.p_et * (1.0 if front == 0 else -1.0)
        pattern = wear_pattern(pair, stiffness, gear=number + 1, z=z - offset, roll=roll, helix=helix)
        depth = np.zeros_like(pattern)
        for fault in faults:
            if fault.flank in (flank, "both"):
                depth += fault.severity * _scale(fault, pattern, pair, number) * pattern
        return base_tangent(depth, gear.geometry)

    return gap


def _scale(fault: Wear, pattern: Array, pair: GearPair, number: int) -> float:
    """Scale of the wear pattern: from the given maximum depth, or k N F/b with F/b = T/(r_b b)."""
    if fault.depth is not None:
        return fault.depth / float(pattern.max())
    assert fault.coefficient is not None and fault.cycles is not None and fault.torque is not None
    r_b = 0.5 * abs((pair.gear1, pair.gear2)[number].d_b)
    return fault.coefficient * fault.cycles * fault.torque / (r_b * pair.b_w)
