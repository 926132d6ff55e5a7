# SPDX-License-Identifier: Apache-2.0
"""Tables inside compiled loops: linear and monotone cubic interpolation, value and slope together.

The cubic is the monotone one of Fritsch and Butland: no overshoot between the given points and a
continuous slope, which Newton's method wants. Either kind may be periodic. Outside a table that is not
periodic the end values are held.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import kernel


def monotone_slopes(
    x: NDArray[np.float64], y: NDArray[np.float64], period: float = 0.0
) -> NDArray[np.float64]:
    """Slopes at the points of a table that make the cubic between them monotone.

    Parameters
    ----------
    x
        Abscissae, strictly rising, shape (n,), n >= 2; for a periodic table all within one period.
    y
        Ordinates, shape (n,).
    period
        Period in x; 0 for a table that does not repeat.

    Returns
    -------
    ndarray
        dy/dx, shape (n,).

    Notes
    -----
    Weighted harmonic mean of the neighbouring secants, zero where they differ in sign [1]_; one-sided
    three-point formula at the ends, limited to keep the shape.

    References
    ----------
    .. [1] F. N. Fritsch, J. Butland, A method for constructing local monotone piecewise cubic
       interpolants, SIAM J. Sci. Stat. Comput. 5 (1984) 300-304.

    Examples
    --------
    >>> monotone_slopes(np.array([0.0, 1.0, 2.0]), np.array([0.0, 1.0, 4.0]))
    array([0. , 1.5, 4. ])
    """
    if period > 0.0:
        x = np.concatenate([[x[-1] - period], x, [x[0] + period]])
        y = np.concatenate([[y[-1]], y, [y[0]]])
    h = np.diff(x)
    secant = np.diff(y) / h
    if h.size == 1:
        return np.full(2, secant[0])
    slopes = np.zeros(x.size)
    left, right = secant[:-1], secant[1:]
    same = left * right > 0.0
    w1, w2 = 2.0 * h[1:] + h[:-1], h[1:] + 2.0 * h[:-1]
    weighted = w1 / np.where(same, left, 1.0) + w2 / np.where(same, right, 1.0)
    slopes[1:-1] = np.where(same, (w1 + w2) / weighted, 0.0)
    if period > 0.0:
        return slopes[1:-1]
    slopes[0] = _end_slope(h[0], h[1], secant[0], secant[1])
    slopes[-1] = _end_slope(h[-1], h[-2], secant[-1], secant[-2])
    return slopes


def _end_slope(h0: float, h1: float, s0: float, s1: float) -> float:
    """Three-point slope at an end, limited so that the first piece stays monotone."""
    slope = ((2.0 * h0 + h1) * s0 - h0 * s1) / (h0 + h1)
    if slope * s0 <= 0.0:
        return 0.0
    if s0 * s1 <= 0.0 and abs(slope) > 3.0 * abs(s0):
        return 3.0 * s0
    return slope


@kernel
def wrap(u, start, period):
    """Bring u into [start, start + period); unchanged without a period."""
    if period <= 0.0:
        return u
    w = (u - start) % period
    # the remainder of a tiny negative number rounds up to the period itself
    return start if w >= period else start + w


@kernel
def interval(x, n, u):
    """Index i of the last point with x[i] <= u; -1 before the first."""
    if not u >= x[0]:
        return -1
    low = 0
    high = n
    while high - low > 1:
        middle = (low + high) // 2
        if x[middle] <= u:
            low = middle
        else:
            high = middle
    return low


@kernel
def linear_table(x, y, n, period, u):
    """Piecewise linear table.

    Parameters
    ----------
    x, y
        Points; x strictly rising, within one period if there is one.
    n
        Number of points.
    period
        Period in x, or 0.
    u
        Where to look.

    Returns
    -------
    tuple
        Value and slope; NaN for u NaN.
    """
    if math.isnan(u):
        return u, u
    w = wrap(u, x[0], period)
    i = interval(x, n, w)
    if i < 0:
        return y[0], 0.0
    if i == n - 1:
        if period <= 0.0:
            return y[i], 0.0
        slope = (y[0] - y[i]) / (x[0] + period - x[i])
    else:
        slope = (y[i + 1] - y[i]) / (x[i + 1] - x[i])
    return y[i] + slope * (w - x[i]), slope


@kernel
def cubic_table(x, y, d, n, period, u):
    """Piecewise cubic Hermite table with given slopes d; otherwise as `linear_table`."""
    if math.isnan(u):
        return u, u
    w = wrap(u, x[0], period)
    i = interval(x, n, w)
    if i < 0:
        return y[0], 0.0
    if i == n - 1:
        if period <= 0.0:
            return y[i], 0.0
        h = x[0] + period - x[i]
        j = 0
    else:
        h = x[i + 1] - x[i]
        j = i + 1
    s = (w - x[i]) / h
    rise = y[j] - y[i]
    a = h * d[i]
    b = h * d[j]
    # Hermite form about the left point: y = yi + a s + (3 rise - 2a - b) s^2 + (a + b - 2 rise) s^3
    c2 = 3.0 * rise - 2.0 * a - b
    c3 = a + b - 2.0 * rise
    return y[i] + s * (a + s * (c2 + s * c3)), (a + s * (2.0 * c2 + 3.0 * s * c3)) / h
