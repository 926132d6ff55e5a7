# SPDX-License-Identifier: Apache-2.0
"""Damping of two flanks by the oil film between them, and structural damping of flanks in contact.

The squeeze film damps the approach and the separation before the flanks touch, increasingly with decreasing
film height. Structural damping is a fraction of the elastic force against the motion.

Source: Adams Machinery, "Gear Pair (Advanced 3D Contact)". Derivation: docs/theory/flank_contact.md, "Damping
of the planes".
"""

from __future__ import annotations

import math

from pitchpoint.contact.friction import coulomb
from pitchpoint.core.kernel import kernel


@kernel
def film_force(x, w, rate, film, power):
    """Squeeze-film force of two flanks, and its derivatives by penetration and by its rate.

    Parameters
    ----------
    x
        Penetration of the flanks [m]; minus the gap.
    w
        Its rate, the squeeze velocity [m/s].
    rate
        Damping coefficient of flanks in contact [N s/m].
    film
        Film thickness h [m]: the film damps up to the gap 2 h.
    power
        Exponent of the film share b = 1 - gap/(2 h), > 0.

    Returns
    -------
    tuple
        Force rate w b^power for 0 < b < 1, rate w for b >= 1, 0 for b <= 0 [N]; derivatives by x and w

    Examples
    --------
    >>> [float(force) for force, _, _ in (film_force(-g, 0.1, 1e3, 1e-6, 2.0) for g in (0.0, 1e-6, 2e-6))]
    [100.0, 25.0, 0.0]
    """
    b = 1.0 + 0.5 * x / film
    if b <= 0.0:
        return 0.0, 0.0, 0.0
    if b >= 1.0:
        return rate * w, 0.0, rate
    share = math.exp(power * math.log(b))
    return rate * w * share, 0.5 * rate * w * power * share / (b * film), rate * share


@kernel
def structural_share(w, factor, speed):
    """Structural damping force over the elastic force at the rate w of the penetration, and its derivative.

    Parameters
    ----------
    w
        Rate of the penetration [m/s].
    factor
        Share of the elastic force, such as 0.01.
    speed
        Rate at which the full share is reached [m/s]; the sign is smooth in between.

    Examples
    --------
    >>> [round(float(structural_share(w, 0.01, 1e-3)[0]), 6) for w in (-1.0, 0.0, 5e-4, 1.0)]
    [-0.01, 0.0, 0.006875, 0.01]
    """
    sign, slope = coulomb(w, speed)
    return factor * sign, factor * slope
