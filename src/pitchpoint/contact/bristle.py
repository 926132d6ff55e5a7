# SPDX-License-Identifier: Apache-2.0
"""Dry friction with sticking: Stribeck curve and elastoplastic bristle model.

All values are per unit of capacity (friction force or torque at fast sliding). Sliding speeds are in m/s for
points and in rad/s for discs.

Source: Stribeck, Z. VDI 46 (1902); Dupont, Hayward, Armstrong, Altpeter, IEEE Trans. Autom. Control 47
(2002).
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel


@kernel
def stribeck(v, ratio, v_s):
    """Friction at steady sliding relative to fast sliding, and its derivative with respect to v.

    1 + (ratio - 1) exp(-(v/v_s)^2), with the ratio of static to dynamic friction and the Stribeck speed v_s;
    v_s = 0: dynamic friction at any sliding speed. R. Stribeck, Z. VDI 46 (1902); curve of Bo and Pavelescu,
    Wear 82 (1982).

    >>> value, slope = stribeck(0.01, 1.5, 0.01)
    >>> round(float(value), 6), round(float(slope), 6)
    (1.18394, -36.787944)
    """
    if v_s <= 0.0 or ratio == 1.0:
        return 1.0, 0.0
    x = v / v_s
    rise = (ratio - 1.0) * math.exp(-x * x)
    return 1.0 + rise, -2.0 * x / v_s * rise


@kernel
def yielding(y, v, limit, onset):
    """Plastic fraction alpha of a bristle at deflection y and sliding speed v; derivatives by y and limit.

    0 up to the deflection `onset` (< limit), 1 beyond `limit`, half a sine wave in between; 0 while the
    bristle unloads. P. Dupont, V. Hayward, B. Armstrong, F. Altpeter, "Single state elastoplastic friction
    models", IEEE Trans. Autom. Control 47 (2002).

    >>> tuple(round(float(x), 6) for x in yielding(0.85, 1.0, 1.0, 0.7))
    (0.5, 5.235988, -2.617994)
    >>> tuple(float(x) for x in yielding(0.85, -1.0, 1.0, 0.7))
    (0.0, 0.0, 0.0)
    """
    size = abs(y)
    if size <= onset or y * v < 0.0:
        return 0.0, 0.0, 0.0
    if size >= limit:
        return 1.0, 0.0, 0.0
    span = limit - onset
    x = (size - onset) / span
    rise = 0.5 * math.pi * math.cos(math.pi * (x - 0.5)) / span
    return 0.5 + 0.5 * math.sin(math.pi * (x - 0.5)), (rise if y > 0.0 else -rise), -rise * x


@kernel
def bristle_rate(y, v, steady, slope, stiffness, onset):
    """Rate of the bristle deflection y in units of the capacity, and its derivatives by y and v.

    y' = stiffness v (1 - alpha |y| / g): stiffness is the slope of friction over sliding distance before
    slip, g the `steady` friction at this speed with derivative `slope`, alpha from `yielding`. Below `onset`
    the bristle is an elastic spring without creep.

    >>> tuple(abs(round(float(x), 6)) for x in bristle_rate(0.5, 1e-3, 1.0, 0.0, 1e4, 0.7))
    (10.0, 0.0, 10000.0)
    >>> round(float(bristle_rate(1.2, 1e-3, 1.2, 0.0, 1e4, 0.7)[0]), 9)
    0.0
    """
    alpha, by_y, by_limit = yielding(y, v, steady, onset)
    sign = 1.0 if v >= 0.0 else -1.0
    part = sign * y / steady
    rate = stiffness * v * (1.0 - alpha * part)
    over_y = -stiffness * v * (by_y * part + alpha * sign / steady)
    over_v = stiffness * (1.0 - alpha * part)
    over_v -= stiffness * v * slope * (by_limit - alpha / steady) * part
    return rate, over_y, over_v
