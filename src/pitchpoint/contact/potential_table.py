# SPDX-License-Identifier: Apache-2.0
"""Elastic potential of the tooth pairs of one flank, read from a table over the position of the gears.

Coordinates: mesh phase s (period 1), approach x along the base tangent [m], misalignment kappa in the plane
of action [rad], centre distance a [m]. A tensor-product cubic spline V (C2, periodic in s) represents the
root of the potential: U = V^2/2 where V > 0, otherwise U = 0. Contact begins at V = 0, where U grows like the
square of the approach beyond it and the force V grad V is continuous. Forces are exact derivatives of one
function: they do no work on a closed path.

Outside the range V continues linearly from its edge, so the force continues linearly in the approach, and the
potential remains C1 and conservative; the result states the axes concerned. Below the lowest tabulated
approach there is no contact. On an axis with one point V is linear, or constant, about that point.

The table is one array: sizes and offsets, one block per axis, the coefficients of V in the order s, kappa, a,
x, and the ratios of further quantities to the force V V_x at the tabulated points in the order s, kappa, a,
x, quantity. `contact.potential_fit` writes it.

Source: C. de Boor, A Practical Guide to Splines, Springer (2001), chapters IX and XVII.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel

QUANTITIES, AXES, VALUES, RATIOS, HEAD = 0, 1, 5, 6, 7
"""Head: number of further quantities; offsets of the axes, of the coefficients, of the ratios; length."""
PHASE, APPROACH, MISALIGNMENT, CENTRE = 0, 1, 2, 3
"""Numbers of the axes."""
COEFFICIENTS, CELLS, LOW, HIGH, SCALE, BUCKETS, POINTS, EDGES = 0, 1, 2, 3, 4, 5, 6, 7
"""Block of an axis: number of coefficients and of cells, range, buckets per unit, number of buckets and of
points; then the edges of the cells, the first cell of each bucket, 16 numbers per cell, the points. The 16
numbers are the coefficients of the four B-splines in powers of the distance from the left edge."""

MAX_QUANTITIES = 40
"""Maximum number of further quantities of a table."""

BEYOND_APPROACH, BEYOND_MISALIGNMENT, BEYOND_CENTRE = 1, 2, 4
"""Bits of the axes outside whose range a state is; NaN counts as outside."""


@kernel
def potential(table, s, x, kappa, a):
    """Potential [J], its derivatives by s, x, kappa, a, then xx, x kappa, kappa kappa, and a flag.

    The force along the base tangent is the derivative by x, the tilting moment that by kappa. The flag is a
    sum of `BEYOND_APPROACH`, `BEYOND_MISALIGNMENT` and `BEYOND_CENTRE`, 0 inside the range.

    >>> from pitchpoint.contact.potential_fit import PotentialTable
    >>> table = PotentialTable.of_spring(2.0e8, 1.0e-5, 5.0e-5).packed  # from 10 to 50 micrometres
    >>> U, _, force, _, _, stiffness, _, _, beyond = potential(table, 0.3, 3.0e-5, 0.0, 0.0)
    >>> round(float(U), 9), round(float(force), 6), round(float(stiffness), 3), int(beyond)
    (0.04, 4000.0, 200000000.0, 0)
    """
    o_s = int(table[AXES + PHASE])
    o_x = int(table[AXES + APPROACH])
    o_k = int(table[AXES + MISALIGNMENT])
    o_a = int(table[AXES + CENTRE])
    beyond = 0
    if not x <= table[o_x + HIGH]:
        beyond += BEYOND_APPROACH
    if not (table[o_k + LOW] <= kappa <= table[o_k + HIGH]):
        beyond += BEYOND_MISALIGNMENT
    if not (table[o_a + LOW] <= a <= table[o_a + HIGH]):
        beyond += BEYOND_CENTRE
    if x < table[o_x + LOW]:
        return 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, beyond
    i_s, b_s, d_s = _slopes(table, o_s, _phase(s))
    i_x, b_x, d_x, e_x = _curvatures(table, o_x, x)
    i_k, b_k, d_k, e_k = _curvatures(table, o_k, kappa)
    i_a, b_a, d_a = _slopes(table, o_a, a)
    n_x = int(table[o_x + COEFFICIENTS])
    n_k = int(table[o_k + COEFFICIENTS])
    n_a = int(table[o_a + COEFFICIENTS])
    width_k = min(n_k, 4)
    width_a = min(n_a, 4)
    V = V_s = V_x = V_k = V_a = V_xx = V_xk = V_kk = 0.0
    for i in range(4):
        v = v_x = v_k = v_a = v_xx = v_xk = v_kk = 0.0  # contracted over kappa, a, x
        for j in range(width_k):
            row = int(table[VALUES]) + (((i_s + i) * n_k + i_k + j) * n_a + i_a) * n_x + i_x
            p0 = p1 = p2 = p3 = q0 = q1 = q2 = q3 = 0.0  # contracted over a: value, slope
            for m in range(width_a):
                b = _entry(b_a, m)
                d = _entry(d_a, m)
                p0 += b * table[row]
                p1 += b * table[row + 1]
                p2 += b * table[row + 2]
                p3 += b * table[row + 3]
                q0 += d * table[row]
                q1 += d * table[row + 1]
                q2 += d * table[row + 2]
                q3 += d * table[row + 3]
                row += n_x
            w = b_x[0] * p0 + b_x[1] * p1 + b_x[2] * p2 + b_x[3] * p3
            w_x = d_x[0] * p0 + d_x[1] * p1 + d_x[2] * p2 + d_x[3] * p3
            b = _entry(b_k, j)
            d = _entry(d_k, j)
            v += b * w
            v_k += d * w
            v_kk += _entry(e_k, j) * w
            v_x += b * w_x
            v_xk += d * w_x
            v_xx += b * (e_x[0] * p0 + e_x[1] * p1 + e_x[2] * p2 + e_x[3] * p3)
            v_a += b * (b_x[0] * q0 + b_x[1] * q1 + b_x[2] * q2 + b_x[3] * q3)
        b = _entry(b_s, i)
        V += b * v
        V_s += _entry(d_s, i) * v
        V_x += b * v_x
        V_k += b * v_k
        V_a += b * v_a
        V_xx += b * v_xx
        V_xk += b * v_xk
        V_kk += b * v_kk
    if V <= 0.0:
        return 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, beyond
    xx = V_x * V_x + V * V_xx
    xk = V_x * V_k + V * V_xk
    kk = V_k * V_k + V * V_kk
    return 0.5 * V * V, V * V_s, V * V_x, V * V_k, V * V_a, xx, xk, kk, beyond


@kernel
def force_ratios(table, s, x, kappa, a, out):
    """Ratios of the further quantities to the force V V_x, and their slopes by x and kappa, shape (3, n).

    Interpolation is linear between the tabulated points of all axes, so that a ratio remains between the
    tabulated ones, and constant outside the range. `out` may be shorter than the quantities of the table.

    >>> import numpy as np
    >>> from pitchpoint.contact.potential_fit import PotentialTable
    >>> table = PotentialTable.of_spring(2.0e8, 1.0e-5, 5.0e-5, lever=0.03).packed
    >>> out = np.zeros((3, 1))
    >>> force_ratios(table, 0.3, 3.0e-5, 0.0, 0.0, out)
    >>> bool(np.allclose(out[:, 0], [0.03, 0.0, 0.0]))
    True
    """
    size = int(table[QUANTITIES])
    n = min(size, out.shape[1])
    value = out[0]
    by_x = out[1]
    by_k = out[2]
    i_s, t_s, _ = _between(table, int(table[AXES + PHASE]), _phase(s))
    i_x, t_x, h_x = _between(table, int(table[AXES + APPROACH]), x)
    i_k, t_k, h_k = _between(table, int(table[AXES + MISALIGNMENT]), kappa)
    i_a, t_a, _ = _between(table, int(table[AXES + CENTRE]), a)
    n_x = int(table[int(table[AXES + APPROACH]) + POINTS])
    n_k = int(table[int(table[AXES + MISALIGNMENT]) + POINTS])
    n_a = int(table[int(table[AXES + CENTRE]) + POINTS])
    for q in range(n):
        value[q] = 0.0
        by_x[q] = 0.0
        by_k[q] = 0.0
    for corner in range(16):
        k_s = corner & 1
        k_x = corner >> 1 & 1
        k_k = corner >> 2 & 1
        k_a = corner >> 3
        weight = (t_s if k_s else 1.0 - t_s) * (t_a if k_a else 1.0 - t_a)
        # also beyond the last point of an axis
        if weight == 0.0 or (k_x and h_x == 0.0) or (k_k and h_k == 0.0):
            continue
        of_x = t_x if k_x else 1.0 - t_x
        of_k = t_k if k_k else 1.0 - t_k
        row = (((i_s + k_s) * n_k + i_k + k_k) * n_a + i_a + k_a) * n_x + i_x + k_x
        first = int(table[RATIOS]) + row * size
        w = weight * of_x * of_k
        w_x = weight * of_k * (h_x if k_x else -h_x)
        w_k = weight * of_x * (h_k if k_k else -h_k)
        for q in range(n):
            ratio = table[first + q]
            value[q] += w * ratio
            by_x[q] += w_x * ratio
            by_k[q] += w_k * ratio


@kernel(inline=True)
def _entry(four, k):
    """Entry k of four numbers. Indices of tuples could raise exceptions, which need the interpreter."""
    if k == 0:
        return four[0]
    if k == 1:
        return four[1]
    return four[2] if k == 2 else four[3]


@kernel(inline=True)
def _phase(s):
    """Fraction of the phase; NaN if it is not finite."""
    return s - math.floor(s) if abs(s) < math.inf else math.nan


@kernel(inline=True)
def _cell(table, o, x):
    """Cell of an axis that contains x, the nearest one outside the range."""
    n = int(table[o + CELLS])
    if not x > table[o + LOW]:
        return 0
    if x >= table[o + HIGH]:
        return n - 1
    buckets = int(table[o + BUCKETS])
    bucket = min(int((x - table[o + LOW]) * table[o + SCALE]), buckets - 1)
    cell = int(table[o + EDGES + n + 1 + bucket])
    while cell < n - 1 and x >= table[o + EDGES + cell + 1]:
        cell += 1
    return cell


@kernel(inline=True)
def _place(table, o, x):
    """Cell, distance from its left edge, distance outside the range, and place of its B-splines."""
    cell = _cell(table, o, x)
    inside = min(max(table[o + LOW], x), table[o + HIGH])
    n = int(table[o + CELLS])
    p = o + EDGES + n + 1 + int(table[o + BUCKETS]) + 16 * cell
    return cell, inside - table[o + EDGES + cell], x - inside, p


@kernel
def _slopes(table, o, x):
    """First coefficient and the four B-splines at x, with first derivatives; linear outside the range."""
    if table[o + CELLS] == 0.0:
        return 0, (1.0, x - table[o + EDGES + 1], 0.0, 0.0), (0.0, 1.0, 0.0, 0.0)
    cell, t, out, p = _place(table, o, x)
    b0, d0 = _cubic(table, p, t, out)
    b1, d1 = _cubic(table, p + 1, t, out)
    b2, d2 = _cubic(table, p + 2, t, out)
    b3, d3 = _cubic(table, p + 3, t, out)
    return cell, (b0, b1, b2, b3), (d0, d1, d2, d3)


@kernel
def _curvatures(table, o, x):
    """First coefficient and the four B-splines at x, with both derivatives; linear outside the range."""
    if table[o + CELLS] == 0.0:
        nothing = (0.0, 0.0, 0.0, 0.0)
        return 0, (1.0, x - table[o + EDGES + 1], 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), nothing
    cell, t, out, p = _place(table, o, x)
    b0, d0 = _cubic(table, p, t, out)
    b1, d1 = _cubic(table, p + 1, t, out)
    b2, d2 = _cubic(table, p + 2, t, out)
    b3, d3 = _cubic(table, p + 3, t, out)
    if out != 0.0:
        return cell, (b0, b1, b2, b3), (d0, d1, d2, d3), (0.0, 0.0, 0.0, 0.0)
    e0 = 2.0 * table[p + 8] + 6.0 * t * table[p + 12]
    e1 = 2.0 * table[p + 9] + 6.0 * t * table[p + 13]
    e2 = 2.0 * table[p + 10] + 6.0 * t * table[p + 14]
    e3 = 2.0 * table[p + 11] + 6.0 * t * table[p + 15]
    return cell, (b0, b1, b2, b3), (d0, d1, d2, d3), (e0, e1, e2, e3)


@kernel(inline=True)
def _cubic(table, p, t, out):
    """Value and slope of a cubic, every fourth number from p; `out` continues its tangent."""
    c1 = table[p + 4]
    c2 = table[p + 8]
    c3 = table[p + 12]
    slope = c1 + t * (2.0 * c2 + 3.0 * t * c3)
    return table[p] + t * (c1 + t * (c2 + t * c3)) + out * slope, slope


@kernel(inline=True)
def _between(table, o, x):
    """Tabulated point below x, the share of the next one, and its slope; 0 outside the range."""
    n = int(table[o + POINTS])
    cells = int(table[o + CELLS])
    if cells == 0:
        return 0, 0.0, 0.0
    p = o + EDGES + cells + 1 + int(table[o + BUCKETS]) + 16 * cells
    if not x > table[p]:
        return 0, 0.0, 0.0
    if x >= table[p + n - 1]:
        return n - 1, 0.0, 0.0
    i = min(int((x - table[p]) / (table[p + n - 1] - table[p]) * (n - 1)), n - 2)
    while i > 0 and x < table[p + i]:
        i -= 1
    while i < n - 2 and x >= table[p + i + 1]:
        i += 1
    slope = 1.0 / (table[p + i + 1] - table[p + i])
    return i, (x - table[p + i]) * slope, slope
