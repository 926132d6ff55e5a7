# SPDX-License-Identifier: Apache-2.0
"""Spalls on races and rolling elements of a bearing: loss of approach of a passing element.

Each row of the fault table is one spall of one surface, its middle at the angle a. Angle of element k from
the middle, about the axis of rotation:

    outer race      fixed to the outer ring; with element k at the azimuth psi_k: psi_k - a
    inner race      rotates with the inner ring by T: psi_k - T - a
    element         rotates with its element relative to the cage, by -s T, s = (d_m/(2 D)) (1 - (D/d_m)^2
                    cos^2(alpha)) in pure rolling: -s T + a; one row for its passage over either race

The loss rises from zero at either edge to the depth of the drop by 6 t^5 - 15 t^4 + 10 t^3, where t is the
fraction of the ramp, and is constant in between: twice continuously differentiable. It depends on the bodies
through T alone; its slope over T is a torque on the rings: an element that climbs out of a spall brakes them.
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
"""Values of one fault: surface, element, angle of the middle, half length, ramp [rad], drop [m]."""


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
    """Loss of approach of element k at the azimuth psi, first and second derivative by the rotation T.

    `share` is the ratio of cage rotation to T; `spun` is the angle of the elements relative to the cage with
    its derivative by T.
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
    """Cosine and sine of the azimuth of element k with uneven spacing in the cage, and its offset."""
    by = view(b["pool"] + 8 * b["spacing"], b["n"], F8)[k]
    x = math.cos(by)
    y = math.sin(by)
    return c * x - s * y, s * x + c * y, by
