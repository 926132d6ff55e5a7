# SPDX-License-Identifier: Apache-2.0
"""Centre distances at which a pair is possible if the profile shift of one gear follows the distance.

The tooth of this gear fills the space of its mate at every distance (ISO 21771, zero backlash); too large a
distance leaves a pointed tooth or no space, too small a distance no involute above the root fillet.
"""

from __future__ import annotations

from itertools import count
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.bisection import bisect

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.geometry.gear_pair import GearPair

STEP = 0.05
"""Step of the profile shift coefficient in the search."""
FURTHEST = 60
"""Steps on both sides of zero within which a possible pair is sought."""


def possible_distances(
    gear1: CylindricalGear, gear2: CylindricalGear, follows: int
) -> tuple[float, float] | None:
    """Least and largest centre distance [m] of possible pairs; None if there is no possible pair.

    Parameters
    ----------
    gear1, gear2
        The gears.
    follows
        0 or 1: the gear whose profile shift follows the centre distance; its `x` does not count.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear, mate = CylindricalGear(z=20, m_n=3e-3), CylindricalGear(z=50, m_n=3e-3)
    >>> low, high = possible_distances(gear, mate, 0)
    >>> round(1e3 * low, 2), round(1e3 * high, 2)
    (102.73, 108.31)
    """
    gears = gear1, gear2

    def pair_at(x: float) -> GearPair | None:
        """Pair at a profile shift of the gear that follows; None if it is impossible."""
        from pitchpoint.geometry.gear_pair import GearPair

        one, two = (gear.replace(x=x) if k == follows else gear for k, gear in enumerate(gears))
        try:
            pair = GearPair.from_profile_shifts(one, two)
            return None if pair.problems() else pair
        except GeometryError:
            return None

    def spare(x: float) -> float:
        """1 for a possible pair, else -1."""
        return -1.0 if pair_at(x) is None else 1.0

    nearest = sorted(range(-FURTHEST, FURTHEST + 1), key=abs)
    middle = next((STEP * k for k in nearest if spare(STEP * k) > 0.0), None)
    if middle is None:
        return None
    ends = []
    for step in (-STEP, STEP):
        last = next(middle + k * step for k in count(1) if spare(middle + k * step) < 0.0)
        ends.append(bisect(spare, last - step, last))
    distances = sorted(abs(pair.a_w) for x in ends if (pair := pair_at(x)) is not None)
    return distances[0], distances[-1]
