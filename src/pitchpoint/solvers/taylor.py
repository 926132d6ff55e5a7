# SPDX-License-Identifier: Apache-2.0
"""Taylor series of a motion from accelerations at the present and at two slightly later times.

Start values of methods that need a history: generalised-alpha and multistep methods after a force jump.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel

APART = 1.0 / 16.0
"""Spacing of the finite differences, relative to the step."""
DISAGREEMENT = 0.1
"""Relative change of a derivative between two estimates above which it is unreliable."""


@kernel
def forward_derivatives(now, soon, later, d):
    """First and second derivative at the first of three values with spacing d; second and first order.

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
    """Value after the time s from its first, second and third derivative (slope, bend, change).

    Examples
    --------
    >>> integral_on(1.0, 2.0, 3.0, 5.0, 6.0)  # 1 + 3 s + 5 s^2/2 + s^3
    25.0
    """
    return value + s * (slope + s * (bend / 2.0 + s * change / 6.0))


@kernel
def position_on(q, v, s, a, jerk, snap):
    """Position after the time s from rate, acceleration and its derivatives; `integral_on` gives the rate."""
    return q + s * (v + s * (a / 2.0 + s * (jerk / 6.0 + s * snap / 24.0)))
