# SPDX-License-Identifier: Apache-2.0
"""Rectangular-wave mesh stiffness: two alternating values, as the number of tooth pairs in contact changes.

Derivation: docs/theory/stiffness.md, "The mesh".
"""

from __future__ import annotations

import math

from pitchpoint.contact.stiffness.description import PhaseStiffness, positive, refuse
from pitchpoint.geometry.gear_pair import GearPair


def rectangular(
    pair: GearPair | None, *, high: float, low: float, duty: float | None = None
) -> PhaseStiffness:
    """Describe a mesh whose stiffness alternates between two values.

    Parameters
    ----------
    pair
        The gear pair; gives the contact ratio if `duty` is omitted.
    high, low
        Stiffness with the larger number of pairs in contact (from psi = 0) and for the rest of the period
        [N/m].
    duty
        Fraction of the period with `high`, in (0, 1); default frac(eps_alpha), the fraction with the larger
        number of pairs in contact.

    Raises
    ------
    ModelError
        If a stiffness is not positive, or the duty is missing or not inside (0, 1).

    Notes
    -----
    Rectangular wave of the Meissner equation; with high : low = 3 : 2, that of a camshaft drive study with
    alternately three and two pairs in contact. The mean is high duty + low (1 - duty).

    Examples
    --------
    >>> wave = rectangular(None, high=3.0e5, low=2.0e5, duty=0.5)
    >>> wave.mean, wave.ratio([0.2, 0.7]).tolist()
    (250000.0, [1.2, 0.8])
    """
    positive("stiffness.high", high, "N/m")
    positive("stiffness.low", low, "N/m")
    if duty is None:
        if pair is None:
            raise refuse(
                "stiffness.duty", "is not a duty cycle", duty, "0 to 1", "give the share of the high value"
            )
        duty = pair.eps_alpha - math.floor(pair.eps_alpha)
    if not 0.0 < duty < 1.0:
        raise refuse(
            "stiffness.duty", "is not a duty cycle", duty, "0 < duty < 1", "give the share of the high value"
        )
    mean = high * duty + low * (1.0 - duty)
    return PhaseStiffness(mean=mean, rectangular=(high / mean, low / mean, duty))
