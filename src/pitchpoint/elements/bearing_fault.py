# SPDX-License-Identifier: Apache-2.0
"""Spalls on the races and elements of a rolling bearing: approach that an element loses over them.

Every row of faults is one spall of one surface. All angles are about the axis of rotation:

    outer race      fixed to the outer ring; element k at the azimuth psi_k is psi_k - a off its middle
    inner race      rotates with the inner ring by T: psi_k - T - a
    element         turns with its element against the cage, by -s T, s = (d_m/(2 D)) (1 - (D/d_m)^2
                    cos^2(alpha)) with pure rolling: -s T + a; one row for its way over either race

The loss grows from zero at either edge to the drop by 6 t^5 - 15 t^4 + 10 t^3, t the share of the ramp, and
stays there in between: two times continuously differentiable. It depends on the bodies through T alone, so
its slope over T turns the rings: an element that climbs out of a spall brakes them.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel, view
from pitchpoint.multibody.channels import F8

TWO_PI = 6.283185307179586

OUTER = 0.0
INNER = 1.0
ELEMENT = 2.0
COLUMNS = 6
"""Numbers of one fault: place, element, angle of the middle, half of the length, ramp [rad], drop [m]."""


@kernel
def spall_shape(angle, half, ramp, drop):
    """Loss of approach [m] at an angle from the middle of a spall [rad], first and second derivative."""
    inside = half - abs(angle)
    if inside <= 0.0:
        return 0.0, 0.0, 0.0
    if inside >= ramp:
        return drop, 0.0, 0.0
    t = inside / ramp
    u = 1.0 - t
    slope = 30.0 * drop / ramp * t * t * u * u
    bend = 60.0 * drop / (ramp * ramp) * t * u * (u - t)
    side = -1.0 if angle > 0.0 else 1.0
    return drop * t * t * t * (10.0 + t * (6.0 * t - 15.0)), side * slope, bend


@kernel
def lost_approach(b, k, psi, share, spun):
    """Loss of approach of element k at the azimuth psi, first and second derivative over the turn T.

    `share` of the turn is that of the cage; `spun` holds the angle of the elements against the cage and its
    derivative over T.
    """
    n = b["n_faults"]
    rows = view(b["pool"] + 8 * b["faults"], (n, COLUMNS), F8)
    lost = 0.0
    slope = 0.0
    bend = 0.0
    for r in range(n):
        place = rows[r, 0]
        if place == OUTER:
            angle = psi
            per_turn = share
        elif place == INNER:
            angle = psi - b["x"][5]
            per_turn = share - 1.0
        elif rows[r, 1] == k:
            angle, per_turn = spun
        else:
            continue
        angle -= rows[r, 2]
        angle -= TWO_PI * math.floor(angle / TWO_PI + 0.5)
        h, dh, ddh = spall_shape(angle, rows[r, 3], rows[r, 4], rows[r, 5])
        lost += h
        slope += dh * per_turn
        bend += ddh * per_turn * per_turn
    return lost, slope, bend


@kernel
def shifted(b, k, c, s):
    """Cosine and sine of the azimuth of element k where the cage does not space the elements evenly."""
    by = view(b["pool"] + 8 * b["spacing"], b["n"], F8)[k]
    x = math.cos(by)
    y = math.sin(by)
    return c * x - s * y, s * x + c * y, by
