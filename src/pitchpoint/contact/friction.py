# SPDX-License-Identifier: Apache-2.0
"""Regularised Coulomb friction, and static and dynamic friction based on it.

The sliding velocity of two flanks changes sign at the pitch point. An exact sign function would make the
force discontinuous there, and implicit integrators would fail to converge. Full friction is reached at the
regularisation velocity v_eps.

Derivation: docs/theory/contacts.md, "Friction".
"""

from __future__ import annotations

from pitchpoint.contact.damping import ramp
from pitchpoint.core.kernel import kernel


@kernel
def coulomb(v, v_eps):
    """Regularised sign of the sliding velocity v, and its derivative by v [s/m].

    t (3 - t^2)/2 with t = v/v_eps for |v| < v_eps (continuous slope), -1 or +1 otherwise; both velocities in
    m/s. v_eps = 0 gives the exact sign function, with 0 at v = 0. The friction force is mu F_n times this
    value, against the sliding.

    >>> s, slope = coulomb(0.5e-3, 1.0e-3)
    >>> round(float(s), 12), round(float(slope), 9)
    (0.6875, 1125.0)
    """
    if v >= v_eps:
        if v == 0.0:
            return 0.0, 0.0
        return 1.0, 0.0
    if v <= -v_eps:
        return -1.0, 0.0
    t = v / v_eps
    return 0.5 * t * (3.0 - t * t), 1.5 * (1.0 - t * t) / v_eps


@kernel
def static_dynamic(v, mu_s, mu_d, v_s, v_d):
    """Coefficient of friction at the sliding velocity v, with the sign of v, and its derivative by v [s/m].

    mu_s times `coulomb` up to the static velocity v_s, a cubic step from mu_s to mu_d between v_s and the
    dynamic velocity v_d, mu_d beyond; all velocities in m/s, v_d > v_s > 0. No true sticking: under a load
    below the static limit the contact creeps at less than v_s. Friction law of the impact force in multibody
    codes.

    >>> tuple(round(float(x), 9) for x in static_dynamic(5.5e-3, 0.1, 0.08, 1e-3, 10e-3))
    (0.09, -3.333333333)
    """
    sign, slope = coulomb(v, v_s)
    fall, steep = ramp(abs(v) - v_s, v_d - v_s)
    mu = mu_s + (mu_d - mu_s) * fall
    return mu * sign, mu * slope + (mu_d - mu_s) * steep * abs(sign)


@kernel
def friction_per_speed(v, mu_s, mu_d, v_s, v_d):
    """Factor c = mu/v [s/m] of a velocity vector with the `static_dynamic` mu at |v|, and c'/v [s^3/m^3].

    Finite at v = 0, so that friction in a plane, T = -N c v, needs no special case at rest.

    >>> tuple(round(float(x), 6) for x in friction_per_speed(0.0, 0.1, 0.08, 1e-3, 10e-3))
    (150.0, -100000000.0)
    """
    if v < v_s:
        return mu_s * (3.0 - (v / v_s) ** 2) / (2.0 * v_s), -mu_s / (v_s * v_s * v_s)
    mu, slope = static_dynamic(v, mu_s, mu_d, v_s, v_d)
    return mu / v, (slope - mu / v) / (v * v)
