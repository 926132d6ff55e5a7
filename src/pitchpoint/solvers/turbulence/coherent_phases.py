# SPDX-License-Identifier: Apache-2.0
"""Random Fourier coefficients with the coherence exp(-c r) on a regular grid.

Veers (1988) multiplies independent random phases by a square root of the coherence matrix, its Cholesky
factor. On a regular grid this matrix is a part of a periodic one, whose square root is a Fourier transform
(Dietrich and Newsam 1997): exact as well, at a cost of n log n and not n³. The period must be so long that no
eigenvalue is negative. Where the Cholesky factor is cheaper, for small grids at low frequencies, it is used.

References
----------
P. S. Veers, Three-dimensional wind simulation, Sandia report SAND88-0152, 1988.
C. R. Dietrich, G. N. Newsam, Fast and exact simulation of stationary Gaussian processes through circulant
embedding of the covariance matrix, SIAM J. Sci. Comput. 18, 1997.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

_PERIOD = 6.0
"""Half a period times c above which no eigenvalue was negative; verified for every matrix."""
_NEGATIVE = 1e-12
"""Sum of negative eigenvalues that counts as rounding, relative to the trace."""
_FFT_COST = 25.0
"""Operations of a Fourier transform per point and binary digit of their number, with random numbers."""
_BATCH = 1 << 21
"""Points of one batch of transforms: 32 MB."""


def coherent_coefficients(
    decay: Array, points: tuple[int, int], spacing: tuple[float, float], rng: np.random.Generator
) -> Complex:
    """Coefficients of unit mean square with coherence exp(-c r) between the points of a grid.

    Parameters
    ----------
    decay
        c of every frequency [1/m], shape (n_f,); infinite without coherence.
    points, spacing
        Number of points along y and z, and their distances [m].
    rng
        Source of random numbers; frequencies take theirs in order.

    Returns
    -------
    ndarray
        Shape (n_f, n_z, n_y).
    """
    n_y, n_z = points
    found = np.empty((decay.size, n_z, n_y), np.complex128)
    periods = [_period(float(c), points, spacing) for c in decay]
    k = 0
    while k < decay.size:
        period = periods[k]
        if period is None:
            found[k] = _by_cholesky(float(decay[k]), points, spacing, rng)
            k += 1
            continue
        size = max(1, _BATCH // (period[0] * period[1]))
        end = k + 1
        while end < decay.size and periods[end] == period and end - k < size:
            end += 1
        found[k:end] = _by_transform(decay[k:end], points, spacing, period, rng)
        k = end
    return found


def independent_coefficients(n_f: int, points: tuple[int, int], rng: np.random.Generator) -> Complex:
    """Coefficients of absolute value 1 without coherence, shape (n_f, n_z, n_y).

    Parameters
    ----------
    n_f
        Number of frequencies.
    points
        Number of points along y and z.
    rng
        Source of random numbers.
    """
    return _phases((n_f, points[1], points[0]), rng)


def _phases(shape: tuple[int, ...], rng: np.random.Generator) -> Complex:
    angle = 2.0 * np.pi * rng.random(shape)
    found = np.empty(shape, np.complex128)
    np.cos(angle, out=found.real)
    np.sin(angle, out=found.imag)
    return found


def _period(c: float, points: tuple[int, int], spacing: tuple[float, float]) -> tuple[int, int] | None:
    """Points per period along y and z; None where the Cholesky factor is cheaper."""
    n = [
        _smooth(max(2 * p - 2, math.ceil(2.0 * _PERIOD / (c * d)), 1)) if p > 1 else 1
        for p, d in zip(points, spacing, strict=True)
    ]
    number, period = points[0] * points[1], n[0] * n[1]
    if number**3 / 3.0 < _FFT_COST * period * math.log2(period + 1):
        return None
    return n[0], n[1]


def _smooth(n: int) -> int:
    """Next even number with the factors 2, 3 and 5 only."""
    n += n % 2
    while True:
        rest = n
        for factor in (2, 3, 5):
            while rest % factor == 0:
                rest //= factor
        if rest == 1:
            return n
        n += 2


def _distances(points: tuple[int, int], spacing: tuple[float, float]) -> Array:
    """Distances on a periodic grid from its first point [m], shape (n_z, n_y)."""
    y, z = (np.minimum(np.arange(n), n - np.arange(n)) * d for n, d in zip(points, spacing, strict=True))
    return np.hypot(z[:, None], y[None, :])


def _by_transform(
    decay: Array,
    points: tuple[int, int],
    spacing: tuple[float, float],
    period: tuple[int, int],
    rng: np.random.Generator,
) -> Complex:
    """Coefficients by the periodic matrix."""
    r = _distances(period, spacing)
    eigenvalues = np.fft.fft2(np.exp(-decay[:, None, None] * r)).real
    phases = _phases(eigenvalues.shape, rng)
    negative = -np.minimum(eigenvalues, 0.0).sum(axis=(1, 2))
    root = np.sqrt(np.maximum(eigenvalues, 0.0) / r.size)
    whole = np.fft.fft2(root * phases)
    found = whole[:, : points[1], : points[0]]
    for k in np.flatnonzero(negative > _NEGATIVE * r.size):
        found[k] = _by_cholesky(float(decay[k]), points, spacing, rng)
    return found


def _by_cholesky(
    c: float, points: tuple[int, int], spacing: tuple[float, float], rng: np.random.Generator
) -> Complex:
    """Coefficients by the Cholesky factor of the coherence matrix."""
    y, z = (np.arange(n) * d for n, d in zip(points, spacing, strict=True))
    at_z, at_y = (a.ravel() for a in np.meshgrid(z, y, indexing="ij"))
    r = np.hypot(at_y[:, None] - at_y, at_z[:, None] - at_z)
    factor = np.linalg.cholesky(np.exp(-c * r))
    return np.asarray((factor @ _phases((r.shape[0],), rng)).reshape(points[1], points[0]))
