# SPDX-License-Identifier: Apache-2.0
"""Numbers without unit that are rarely meant in SI units: a speed of 3000, a width of 20, an angle of 15."""

from __future__ import annotations

import math

LARGE = 1.0
"""Length [m] from which a number without unit rather is in millimetres."""


def is_doubtful(value: float, dimension: str) -> bool:
    """Whether a number without unit may be meant in rpm, millimetres or degrees.

    Speeds always: a number in rad/s has no typical size. Lengths from 1 m, where most parts are smaller.
    Angles beyond a turn, and whole numbers: 15 rad is rarely meant, in contrast to 0.26 rad.

    Parameters
    ----------
    value
        Number as written.
    dimension
        Dimension of its key.

    Examples
    --------
    >>> is_doubtful(3000, "angular_speed"), is_doubtful(0.02, "length"), is_doubtful(15, "angle")
    (True, False, True)
    """
    size = abs(value)
    if dimension == "angular_speed":
        return size > 0.0
    if dimension == "length":
        return size >= LARGE
    return dimension == "angle" and size > 0.0 and (size > 2.0 * math.pi or size == round(size))
