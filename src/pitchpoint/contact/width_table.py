# SPDX-License-Identifier: Apache-2.0
"""Width integral of a pair stiffness that is given as a table along the path of contact.

The same idea as `width_integral`, with the nodes of the table as further kinks: between two of them the
stiffness is linear times a linear ramp, so the three-point rule stays exact for the tabulated law.

Derivation: docs/theory/stiffness.md, "The mesh".
"""

from __future__ import annotations

from pitchpoint.contact.pair_shape import pair_table, pair_table_slope
from pitchpoint.contact.width_integral import NODE, PARALLEL, gauss_moments
from pitchpoint.core.kernel import kernel


@kernel
def table_piece(p_lo, p_hi, p0, lam, eps_alpha, n, table, L, order):
    """Moments over the piece of the face on which p runs from p_lo to p_hi, for a table of n values.

    >>> import numpy as np
    >>> tuple(round(float(x), 9) for x in table_piece(0.0, 1.0, 0.5, 1.0, 1.0, 2, np.ones(2), 0.0, 0))
    (1.0, 0.0, 0.083333333)
    """
    z_lo = (p_lo - p0) / lam
    z_hi = (p_hi - p0) / lam
    m = 0.5 * (p_lo + p_hi)
    d = NODE * 0.5 * (p_hi - p_lo)
    if order == 0:
        lo = pair_table(m - d, eps_alpha, n, table, L)
        mid = pair_table(m, eps_alpha, n, table, L)
        hi = pair_table(m + d, eps_alpha, n, table, L)
    else:
        lo = pair_table_slope(m - d, eps_alpha, n, table, L)
        mid = pair_table_slope(m, eps_alpha, n, table, L)
        hi = pair_table_slope(m + d, eps_alpha, n, table, L)
    if lam > 0.0:
        return gauss_moments(z_lo, z_hi, lo, mid, hi)
    return gauss_moments(z_hi, z_lo, hi, mid, lo)


@kernel
def table_pair_moments(p0, lam, b, eps_alpha, n, table, L, order):
    """Integrals over z in [-b/2, b/2] of c(p0 + lam z)/c' z^k, k = 0, 1, 2, for one tabulated pair.

    Units and `order` as in `width_integral.pair_moments`. The walk goes from kink to kink in p: table nodes
    and the two ends of the ramp.

    >>> import numpy as np
    >>> line = table_pair_moments(0.65, 4.0, 0.1, 1.3, 3, np.array([0.8, 1.0, 0.8]), 0.0, 0)
    >>> round(float(line[0]), 9)
    0.096923077
    """
    if abs(lam) * b < PARALLEL:
        if order == 0:
            c = b * pair_table(p0, eps_alpha, n, table, L)
        else:
            c = b * pair_table_slope(p0, eps_alpha, n, table, L)
        return c, 0.0, c * b * b / 12.0
    spread = 0.5 * abs(lam) * b
    p = max(0.0, p0 - spread)
    end = min(eps_alpha, p0 + spread)
    step = eps_alpha / (n - 1)
    i = int(p / step) + 1
    k0 = 0.0
    k1 = 0.0
    k2 = 0.0
    while p < end:
        stop = min(end, i * step) if i < n - 1 else end
        if p < L < stop:
            stop = L
        elif p < 0.5 * eps_alpha < stop:
            stop = 0.5 * eps_alpha
        elif p < eps_alpha - L < stop:
            stop = eps_alpha - L
        else:
            i += 1
        if stop > p:
            s0, s1, s2 = table_piece(p, stop, p0, lam, eps_alpha, n, table, L, order)
            k0 += s0
            k1 += s1
            k2 += s2
            p = stop
    if order == 1 and L <= 0.0:
        z_A = -p0 / lam
        z_E = (eps_alpha - p0) / lam
        if abs(z_A) < 0.5 * b:
            rate = table[0] / abs(lam)
            k0 += rate
            k1 += rate * z_A
            k2 += rate * z_A * z_A
        if abs(z_E) < 0.5 * b:
            rate = table[n - 1] / abs(lam)
            k0 -= rate
            k1 -= rate * z_E
            k2 -= rate * z_E * z_E
    return k0, k1, k2
