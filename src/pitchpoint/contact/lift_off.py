# SPDX-License-Identifier: Apache-2.0
"""Boundary of the contact along a contact line: root of a function within a bracket.

Regula falsi with the Illinois modification: M. Dowell and P. Jarratt, A modified regula falsi method for
computing the root of an equation, BIT 11 (1971) 168-174.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel

MAX_STEPS = 60
"""Maximum number of steps of a search; about six are needed."""


@kernel
def secant(bracket):
    """Root of the straight line through both ends of a bracket (a, c, f_a, f_c, side).

    Examples
    --------
    >>> secant((0.0, 3.0, -1.0, 2.0, 0))
    1.0
    """
    a, c, f_a, f_c, _ = bracket
    return (a * f_c - c * f_a) / (f_c - f_a)


@kernel
def narrowed(bracket, z, f):
    """Bracket in which (z, f) replaces the end whose value has the same sign.

    `side` is the end replaced last, 1 for c and -1 for a. If the same end is replaced twice in a row, the
    value at the other end is halved, so that both ends converge.

    Examples
    --------
    >>> bracket = (0.0, 2.0, -2.0, 2.0, 0)  # f = z^2 - 2
    >>> for _ in range(9):
    ...     z = secant(bracket)
    ...     bracket = narrowed(bracket, z, z * z - 2.0)
    >>> round(z, 12)
    1.414213562373
    """
    a, c, f_a, f_c, side = bracket
    if (f > 0.0) == (f_c > 0.0):
        return a, z, 0.5 * f_a if side == 1 else f_a, f, 1
    return z, c, f, 0.5 * f_c if side == -1 else f_c, -1
