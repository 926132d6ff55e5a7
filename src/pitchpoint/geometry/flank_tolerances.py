# SPDX-License-Identifier: Apache-2.0
"""Tolerances of the pitch of cylindrical gears by flank tolerance class (ISO 1328-1:2013)."""

from __future__ import annotations

import math

CLASSES = range(1, 12)
"""Flank tolerance classes, 1 for the smallest tolerances."""


def single_pitch_tolerance(d: float, m_n: float, tolerance_class: int) -> float:
    """Single pitch tolerance f_pT.

    f_pT = (0.001 d + 0.4 m_n + 5) sqrt(2)^(A - 5) in micrometres with d and m_n in millimetres, not rounded.
    Source: ISO 1328-1:2013, 5.3.1. Range: 5 mm <= d <= 15 000 mm, 0.5 mm <= m_n <= 70 mm.

    Parameters
    ----------
    d
        Reference diameter [m].
    m_n
        Normal module [m].
    tolerance_class
        Flank tolerance class A, 1 to 11.

    Returns
    -------
    float
        Permitted magnitude of the single pitch deviation [m].

    Examples
    --------
    >>> [round(1e6 * single_pitch_tolerance(0.1, 0.004, a), 3) for a in (5, 7)]
    [6.7, 13.4]
    """
    micrometres = (d + 400.0 * m_n + 5.0) * math.sqrt(2.0) ** (tolerance_class - 5)
    return 1e-6 * micrometres
