# SPDX-License-Identifier: Apache-2.0
"""Stiffness of one tooth pair along its path of contact, and prescribed stiffness over the mesh phase.

Scalar kernels of the inner loop of the mesh element. Positions along the path are in base pitches from point
A (start of contact): a pair is in contact for 0 <= p <= eps_alpha, and its neighbours are at p - 1 and p +
1. Results are relative to c' for a pair and to the mean for a prescribed stiffness.

Source: Mauer, SIMPACK User Meeting (2006).
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel

#: Forms of a prescribed stiffness, the `form` argument of `phase_stiffness`.
FOURIER = 0
TABLE = 1
RECTANGULAR = 2


@kernel
def pair_shape(p, eps_alpha, S_R, L):
    """Stiffness of one pair relative to c' at the path position p.

    c/c' = (1 - (1 - S_R) zeta^2) * min(1, p/L, (eps_alpha - p)/L) with zeta = 2 p/eps_alpha - 1 in [-1, 1];
    zero outside the path, both ends inclusive (source: L. Mauer, SIMPACK User Meeting 2006, single-pair
    parabola with stiffness ratio; ramp of the tip-relief factor). p, eps_alpha and L in base pitches,
    L = T_R frac(eps_alpha); L = 0: no ramps, and a jump of S_R at A and E.

    >>> round(float(pair_shape(0.65, 1.3, 0.8, 0.0)), 12), round(float(pair_shape(0.0, 1.3, 0.8, 0.0)), 12)
    (1.0, 0.8)
    """
    if p < 0.0 or p > eps_alpha:
        return 0.0
    zeta = 2.0 * p / eps_alpha - 1.0
    c = 1.0 - (1.0 - S_R) * zeta * zeta
    reach = min(p, eps_alpha - p)
    if reach < L:
        c *= reach / L
    return c


@kernel
def pair_shape_rate(p, p_rate, eps_alpha, eps_rate, S_R, L, L_rate):
    """Time derivative of `pair_shape` for given rates of the position p, the path length and the ramp length.

    At a kink (end of a ramp) the value of the plateau side is returned; jumps at A and E (L = 0) are not
    included. Zero outside the path.

    >>> round(float(pair_shape_rate(0.325, 2.0, 1.3, 0.0, 0.8, 0.0, 0.0)), 12)
    0.615384615385
    """
    if p < 0.0 or p > eps_alpha:
        return 0.0
    zeta = 2.0 * p / eps_alpha - 1.0
    zeta_rate = 2.0 * (p_rate - p * eps_rate / eps_alpha) / eps_alpha
    rate = -2.0 * (1.0 - S_R) * zeta * zeta_rate
    return _with_ramp(p, p_rate, eps_alpha, eps_rate, L, L_rate, 1.0 - (1.0 - S_R) * zeta * zeta, rate)


@kernel
def _with_ramp(p, p_rate, eps_alpha, eps_rate, L, L_rate, c, rate):
    """Time derivative of c times the ramp; `rate` is that of c."""
    first = p < eps_alpha - p
    reach = p if first else eps_alpha - p
    if reach < L:
        reach_rate = p_rate if first else eps_rate - p_rate
        return rate * reach / L + c * (reach_rate - reach * L_rate / L) / L
    return rate


@kernel
def pair_table(p, eps_alpha, n, table, L):
    """Stiffness of one pair relative to c' from n values at equal steps from A to E, times the ramp.

    Linear interpolation; zero outside [0, eps_alpha]; n >= 2. The ramp is that of `pair_shape`.

    >>> import numpy as np
    >>> round(float(pair_table(0.3, 1.2, 3, np.array([0.6, 1.0, 0.8]), 0.0)), 12)
    0.8
    """
    if p < 0.0 or p > eps_alpha:
        return 0.0
    s = p / eps_alpha * (n - 1)
    i = min(int(s), n - 2)
    c = table[i] + (table[i + 1] - table[i]) * (s - i)
    reach = min(p, eps_alpha - p)
    if reach < L:
        c *= reach / L
    return c


@kernel
def pair_table_rate(p, p_rate, eps_alpha, eps_rate, n, table, L, L_rate):
    """Time derivative of `pair_table` for given rates of the position p, the path length and the ramp length.

    >>> import numpy as np
    >>> round(float(pair_table_rate(0.3, 2.0, 1.2, 0.0, 3, np.array([0.6, 1.0, 0.8]), 0.0, 0.0)), 12)
    1.333333333333
    """
    if p < 0.0 or p > eps_alpha:
        return 0.0
    s = p / eps_alpha * (n - 1)
    i = min(int(s), n - 2)
    step = table[i + 1] - table[i]
    rate = step * (n - 1) * (p_rate - p * eps_rate / eps_alpha) / eps_alpha
    return _with_ramp(p, p_rate, eps_alpha, eps_rate, L, L_rate, table[i] + step * (s - i), rate)


@kernel
def phase_stiffness(psi, form, n, cosine, sine):
    """Prescribed stiffness k(psi)/mean and its derivative by psi; period 1 in psi.

    The contents of the arrays depend on `form`:

    * FOURIER (0): 1 + sum_h cosine[h-1] cos(2 pi h psi) + sine[h-1] sin(2 pi h psi), h = 1..n. One sine and
      one cosine are evaluated; the harmonics follow by rotation, with an error of about n round-offs.
    * TABLE (1): cosine[0..n-1] are values at psi = i/n, periodic with linear interpolation; sine is not used.
    * RECTANGULAR (2): cosine = (first value, second value, duty); the first value applies for
      0 <= frac(psi) < duty; sine and n are not used.

    >>> import numpy as np
    >>> k, slope = phase_stiffness(0.25, 0, 1, np.array([-0.2]), np.array([0.1]))
    >>> round(float(k), 12), round(float(slope), 12)
    (1.1, 1.256637061436)
    """
    if form == 0 and n == 0:
        return 1.0, 0.0
    s = psi - math.floor(psi)
    if form == 0:
        w = 2.0 * math.pi
        c1 = math.cos(w * s)
        s1 = math.sin(w * s)
        ch = c1
        sh = s1
        value = 1.0
        slope = 0.0
        for h in range(n):
            value += cosine[h] * ch + sine[h] * sh
            slope += (h + 1) * w * (sine[h] * ch - cosine[h] * sh)
            c2 = ch * c1 - sh * s1
            sh = sh * c1 + ch * s1
            ch = c2
        return value, slope
    if form == 1:
        s *= n
        i = min(int(s), n - 1)
        j = i + 1 if i + 1 < n else 0
        step = cosine[j] - cosine[i]
        return cosine[i] + step * (s - i), step * n
    if s < cosine[2]:
        return cosine[0] + 0.0, 0.0
    return cosine[1] + 0.0, 0.0
