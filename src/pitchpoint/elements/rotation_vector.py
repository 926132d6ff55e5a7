# SPDX-License-Identifier: Apache-2.0
"""Rotation vector of one frame relative to another: its rate, conjugate moment, and their derivatives.

A frame rotated by the angle t about the unit vector a has the rotation vector s = t a, t <= pi. A further
small rotation p (in the axes of the first frame) changes s by

    ds = B(s) p,  B p = p - s x p/2 + c s x (s x p),  c = (1 - (t/2) cot(t/2))/t^2

and for m conjugate to s the moment is B^T m, which differs in the sign of the middle term. O. A.
Bauchau, *Flexible Multibody Dynamics*, 2011, ch. 13 (the inverse of the tangent operator).
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.vectors import add, cross, dot, times

SMALL = 0.2
"""Angle below which series replace quotients of small numbers, with an error below 1e-13 [rad]."""


@kernel
def rotation_vector(A):
    """Rotation vector of an orthonormal matrix (three rows as tuples).

    From the quaternion, computed from its largest component, so that it is accurate up to t = pi.
    """
    x, y, z = A
    trace = x[0] + y[1] + z[2]
    if trace >= x[0] and trace >= y[1] and trace >= z[2]:
        w = 1.0 + trace
        v = (z[1] - y[2], x[2] - z[0], y[0] - x[1])
    elif x[0] >= y[1] and x[0] >= z[2]:
        w = z[1] - y[2]
        v = (1.0 + x[0] - y[1] - z[2], x[1] + y[0], z[0] + x[2])
    elif y[1] >= z[2]:
        w = x[2] - z[0]
        v = (x[1] + y[0], 1.0 + y[1] - x[0] - z[2], y[2] + z[1])
    else:
        w = y[0] - x[1]
        v = (z[0] + x[2], y[2] + z[1], 1.0 + z[2] - x[0] - y[1])
    if w < 0.0:
        w = -w
        v = times(-1.0, v)
    sine = math.sqrt(dot(v, v))
    if sine < 1e-8 * w:
        return times(2.0 / w, v)
    return times(2.0 * math.atan2(sine, w) / sine, v)


@kernel
def curl_factor(s):
    """The factor c(t) and its derivative by t over t."""
    t2 = dot(s, s)
    if t2 < SMALL * SMALL:
        c = 1.0 / 1209600.0 + t2 / 47900160.0
        c = 1.0 / 12.0 + t2 * (1.0 / 720.0 + t2 * (1.0 / 30240.0 + t2 * c))
        return c, 1.0 / 360.0 + t2 * (1.0 / 7560.0 + t2 * (1.0 / 201600.0 + t2 / 5987520.0))
    t = math.sqrt(t2)
    half = 0.5 * t
    cot = math.cos(half) / math.sin(half)
    c = (1.0 - half * cot) / t2
    fall = 0.5 * cot - 0.5 * half / (math.sin(half) * math.sin(half))
    return c, -(fall / t + 2.0 * c) / t2


@kernel
def by_turn(s, p, side):
    """B p (`side` -1: change of s for a rotation p) or B^T p (`side` 1: moment for p conjugate to s)."""
    c, slope = curl_factor(s)
    once = cross(s, p)
    return add(p, add(times(0.5 * side, once), times(c, cross(s, once))))


@kernel
def by_turn_change(s, ds, p, side):
    """Change of `by_turn` with s at constant p."""
    c, slope = curl_factor(s)
    once = cross(s, p)
    moved = cross(ds, p)
    found = add(times(0.5 * side, moved), times(slope * dot(s, ds), cross(s, once)))
    return add(found, times(c, add(cross(ds, once), cross(s, moved))))
