# SPDX-License-Identifier: Apache-2.0
"""Taylor series of a motion whose accelerations are known a little later, too.

Methods that need the past of a side that they have never seen begin with it: the start of generalised-alpha
and multistep methods behind a jump of forces.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel

APART = 1.0 / 16.0
"""Distance of the points of the differences, over the step."""
DISAGREEMENT = 0.1
"""Change of a derivative from one estimate to the next, over its size, from which it is unreliable."""


@kernel
def forward_derivatives(now, soon, later, d):
    """First and second derivative at the first of three values at the distance d, of second and first order.

    Examples
    --------
    >>> forward_derivatives(1.0, 3.0, 9.0, 1.0)  # 1 + 2 t^2
    (0.0, 4.0)
    """
    one = soon - now
    second = (later - soon - one) / (d * d)
    return one / d - 0.5 * d * second, second


@kernel
def integral_on(value, s, slope, bend, change):
    """What becomes of a value by the time s if its derivatives are slope, bend and change.

    Examples
    --------
    >>> integral_on(1.0, 2.0, 3.0, 5.0, 6.0)  # 1 + 3 s + 5 s^2/2 + s^3
    25.0
    """
    return value + s * (slope + s * (bend / 2.0 + s * change / 6.0))


@kernel
def position_on(q, v, s, a, jerk, snap):
    """What becomes of a position with rate v by the time s; `integral_on` gives the rate."""
    return q + s * (v + s * (a / 2.0 + s * (jerk / 6.0 + s * snap / 24.0)))
