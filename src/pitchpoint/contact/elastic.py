# SPDX-License-Identifier: Apache-2.0
"""Elastic force over deflection: power law, series compliance, reduced stiffness at low load, energies.

Source: ISO 6336-1 for low loads. Derivation: docs/theory/stiffness.md, "One pair of teeth".
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel

_STEPS = 60
"""Maximum number of Newton steps; about five are needed."""


@kernel
def power_force(x, k, power):
    """Force k x^power and its derivative by x, for x > 0; power 1.5: Hertzian point contact.

    >>> force, tangent = power_force(4.0, 2.0, 1.5)
    >>> float(force), float(tangent)
    (16.0, 6.0)
    """
    if power == 1.0:
        return k * x, k
    if power == 1.5:  # several times faster than a power
        slope = k * math.sqrt(x)
    else:
        slope = k * x ** (power - 1.0)
    return slope * x, power * slope


@kernel
def power_energy(x, k, power):
    """Energy of `power_force` at x > 0, k x^(power + 1)/(power + 1) [J].

    >>> round(float(power_energy(4.0, 2.0, 1.5)), 12)
    25.6
    """
    return power_force(x, k, power)[0] * x / (power + 1.0)


@kernel
def low_load(load, limit):
    """Low-load factors on the force and on its tangent, for the line load c' delta without softening.

    In ISO 6336-1 the stiffness decreases as c' (w/w_0)^0.25 for a specific load w below w_0. In terms of the
    deflection, w = q^(4/3) w_0^(-1/3) with q = c' delta: the force is q times (q/w_0)^(1/3), its derivative
    by the deflection c' times 4/3 of that. load = q and limit = w_0 in N/m; limit 0 or q >= limit: (1, 1).

    >>> force, tangent = low_load(0.125e5, 1.0e5)
    >>> round(float(force), 12), round(float(tangent), 12)
    (0.5, 0.666666666667)
    """
    if load >= limit:
        return 1.0, 1.0
    if load <= 0.0:
        return 0.0, 0.0
    factor = (load / limit) ** (1.0 / 3.0)
    return factor, 4.0 / 3.0 * factor


@kernel
def stored_energy(x, k, power, limit):
    """Energy of a spring k x^power [N] at the deflection x [m], and its derivative by k at constant x.

    Below the force `limit` [N] a linear spring softens as in `low_load` (force proportional to x^(4/3));
    limit 0: no softening.

    >>> energy, slope = stored_energy(2.0, 3.0, 1.0, 0.0)
    >>> float(energy), float(slope)
    (6.0, 2.0)
    """
    if power != 1.0:
        slope = power_energy(x, 1.0, power)
        return k * slope, slope
    q = k * x
    if limit <= 0.0:
        return 0.5 * q * x, 0.5 * x * x
    if q < limit:
        energy = low_load(q, limit)[0] * q * x * (3.0 / 7.0)
        return energy, 4.0 / 3.0 * energy / k
    return 0.5 * q * x - limit * limit / (14.0 * k), 0.5 * x * x + limit * limit / (14.0 * k * k)


@kernel
def series_overlap(x, k, power, soft):
    """Overlap u of a contact k u^power in series with a compliance `soft` [m/N]; total deflection x > 0 [m].

    Root of u + soft k u^power = x for any power >= 1: with t = u/x, t + A t^power = 1 and A = soft k
    x^(power - 1). The left side increases and is convex, so Newton's method decreases monotonically from
    min(1, A^(-1/power)) to the only root, in about five steps.

    >>> u = series_overlap(5.0, 2.0, 1.5, 1.0 / 16.0)  # 16 N at the overlap 4, 1 m in the compliance
    >>> round(float(u), 12)
    4.0
    """
    if power == 1.0:
        return x / (1.0 + soft * k)
    A = soft * power_force(x, k, power)[0] / x
    t = 1.0 if A <= 1.0 else A ** (-1.0 / power)
    for _ in range(_STEPS):
        f, slope = power_force(t, A, power)
        step = (t + f - 1.0) / (1.0 + slope)
        t -= step
        if step <= 1e-16 * t:
            break
    return t * x


@kernel
def series_energy(x, u, k, power, soft, limit):
    """Energy of a contact with series compliance, and its derivatives by k and by `soft` at constant x.

    u is the overlap at x. A linear contact and its series compliance may soften at low load as in
    `stored_energy`.

    >>> energy, by_k, by_soft = series_energy(5.0, 4.0, 2.0, 1.5, 1.0 / 16.0, 0.0)
    >>> round(float(energy), 12), round(float(by_k), 12), float(by_soft)
    (33.6, 12.8, -128.0)
    """
    if power == 1.0:
        share = u / x
        energy, slope = stored_energy(x, k * share, power, limit)
        slope *= share * share
        return energy, slope, -slope * k * k
    slope = power_energy(u, 1.0, power)
    f = power_force(u, k, power)[0]
    return k * slope + 0.5 * soft * f * f, slope, -0.5 * f * f
