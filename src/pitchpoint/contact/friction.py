# SPDX-License-Identifier: Apache-2.0
"""Friction between flanks: the smooth sign function that Coulomb's law needs near zero sliding.

At the pitch point the sliding velocity changes its sign; a true sign function would make the force jump there
and stop every implicit integrator. The regularisation velocity v_eps sets where full friction is reached.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel


@kernel
def coulomb(v, v_eps):
    """Smooth sign of the sliding velocity v, and its derivative by v [s/m].

    t (3 - t^2)/2 with t = v/v_eps inside |v| < v_eps (value and slope continuous), -1 or +1 outside; both
    velocities in m/s. v_eps = 0 gives the true sign function, with 0 at v = 0. Friction force = mu F_n times
    this, against the sliding.

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
