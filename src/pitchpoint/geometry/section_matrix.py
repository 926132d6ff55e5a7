# SPDX-License-Identifier: Apache-2.0
"""Stiffness and mass matrices of a section of a beam: checks, and the mass as one or two lines.

Source of the matrices: Q. Wang, M. A. Sprague, J. Jonkman, N. Johnson, B. Jonkman, BeamDyn: a high-fidelity
wind turbine blade solver in the FAST modular framework, Wind Energy 20 (2017) 1439-1462.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]
ROUNDED = 1e-3
"""Error of an entry that is attributed to rounding, relative to the mean of its diagonal entries."""
DEFINITE = 1e-12
"""Least eigenvalue of a stiffness matrix with a diagonal of 1."""
SAME = 1e-6
"""Difference of both moments of inertia of a section, over their sum, below which they are equal."""
_FLAT = np.zeros((6, 6), dtype=bool)
_FLAT[[0, 0, 1, 1, 2, 2, 2, 3, 3, 4, 5], [0, 5, 1, 5, 2, 3, 4, 3, 4, 4, 5]] = True
_FLAT |= _FLAT.T


@dataclass(frozen=True)
class MassLine:
    """Part of the mass of a section.

    Parameters
    ----------
    mass
        Mass per length [kg/m].
    place
        Position along the axes 1 and 2 [m].
    second
        Moment of inertia about each of both axes through this position, over the mass [m²].
    """

    mass: float
    place: tuple[float, float]
    second: float


def check_stiffness(stiffness: ArrayLike) -> None:
    """Check that a stiffness matrix is finite, symmetric and positive definite.

    Parameters
    ----------
    stiffness
        Matrix, shape (6, 6) [N, N m, N m²].

    Raises
    ------
    ValueError
        With the reason.

    Examples
    --------
    >>> check_stiffness(np.diag([1.0, 1, 1, 1, 1, -1]))
    Traceback (most recent call last):
    ValueError: is not positive definite
    """
    K = _symmetric(stiffness)
    if not (np.diag(K) > 0.0).all():
        raise ValueError("is not positive definite")
    scale = np.sqrt(np.outer(np.diag(K), np.diag(K)))
    if not (np.linalg.eigvalsh(K / scale) > DEFINITE).all():
        raise ValueError("is not positive definite")


def check_inertia(inertia: ArrayLike) -> None:
    """Check that a mass matrix is symmetric and that of a flat section.

    Parameters
    ----------
    inertia
        Matrix, shape (6, 6) [kg/m, kg, kg m].

    Raises
    ------
    ValueError
        With the reason.

    Examples
    --------
    >>> check_inertia(np.diag([10.0, 10, 12, 1, 1, 2]))
    Traceback (most recent call last):
    ValueError: has several masses: 10, 10, 12 kg/m
    """
    M = _symmetric(inertia)
    m = M[0, 0]
    if m < 0.0:
        raise ValueError("has a negative mass")
    masses = np.diag(M)[:3]
    if np.ptp(masses) > ROUNDED * masses.max():
        raise ValueError(f"has several masses: {', '.join(f'{x:g}' for x in masses)} kg/m")
    scale = np.sqrt(np.maximum(np.outer(np.diag(M), np.diag(M)), 0.0))
    for i, j in zip(*np.nonzero(~_FLAT), strict=True):
        if abs(M[i, j]) > ROUNDED * max(scale[i, j], scale.max() * DEFINITE):
            raise ValueError(f"has the entry {i + 1}{j + 1}, which a flat section does not have")
    for one, two in (((0, 5), (2, 3)), ((1, 5), (2, 4))):
        if abs(M[one] + M[two]) > ROUNDED * max(scale[one], abs(M[one]), abs(M[two])):
            names = [f"{i + 1}{j + 1}" for i, j in (one, two)]
            raise ValueError(f"has two centres of mass: the entries {' and '.join(names)} are not opposite")
    polar = M[5, 5] - (M[0, 5] ** 2 + M[1, 5] ** 2) / m if m > 0.0 else M[5, 5]
    if polar < -ROUNDED * abs(M[5, 5]):
        raise ValueError("has a negative moment of inertia about its centre of mass")


def mass_lines(inertia: ArrayLike) -> list[MassLine]:
    """Mass of a section as one line, or as two if its moments of inertia about both axes are not equal.

    Two lines of half the mass at the distance d from the centre have the moments of inertia of the section:
    J_max - J_min = m d². The entry 66, the polar moment of inertia, is that of the lines; the entries 44, 45
    and 55 give the difference of both moments and its direction.

    Parameters
    ----------
    inertia
        Mass matrix of `check_inertia`, shape (6, 6) [kg/m, kg, kg m].

    Examples
    --------
    A plate along axis 2, with 12 kg/m, 48 kg m about axis 1 and nothing about axis 2:

    >>> [(part.mass, part.place) for part in mass_lines(np.diag([12.0, 12, 12, 48, 0, 48]))]
    [(6.0, (0.0, 2.0)), (6.0, (0.0, -2.0))]
    """
    M = _symmetric(inertia)
    m = float(M[0, 0])
    if m == 0.0:
        return [MassLine(0.0, (0.0, 0.0), 0.0)]
    x, y = float(M[1, 5]) / m, -float(M[0, 5]) / m
    polar = max(float(M[5, 5]) - m * (x * x + y * y), 0.0)
    product = -float(M[3, 4]) - m * x * y
    half = 0.5 * (float(M[4, 4]) - m * x * x - float(M[3, 3]) + m * y * y)
    apart = min(2.0 * math.hypot(half, product), polar)
    if apart <= SAME * polar:
        return [MassLine(m, (x, y), 0.5 * polar / m)]
    angle, d = 0.5 * math.atan2(product, half), math.sqrt(apart / m)
    c, s = d * _clean(math.cos(angle)), d * _clean(math.sin(angle))
    return [MassLine(0.5 * m, (x + k * c, y + k * s), 0.5 * (polar - apart) / m) for k in (1.0, -1.0)]


def polar_error(inertia: ArrayLike) -> float:
    """Difference of the polar moment of inertia of a mass matrix, shape (6, 6), from the sum of both others,
    relative."""
    M = np.asarray(inertia, dtype=float)
    return float(abs(M[3, 3] + M[4, 4] - M[5, 5]) / max(M[5, 5], M[3, 3] + M[4, 4], 1e-300))


def symmetric(upper: ArrayLike) -> FloatArray:
    """Symmetric matrix from its 21 values, row by row from the diagonal.

    Parameters
    ----------
    upper
        Values, shape (21,).

    Returns
    -------
    ndarray, shape (6, 6)
        The matrix.

    Examples
    --------
    >>> symmetric(range(21))[5].tolist()
    [5.0, 10.0, 14.0, 17.0, 19.0, 20.0]
    """
    out = np.zeros((6, 6))
    out[np.triu_indices(6)] = np.asarray(upper, dtype=float)
    return out + np.triu(out, 1).T


def _symmetric(matrix: ArrayLike) -> FloatArray:
    """Symmetric part of a matrix whose other part is rounding."""
    K = np.array(matrix, dtype=float)
    if not np.isfinite(K).all():
        raise ValueError("contains values that are not finite")
    scale = np.sqrt(np.abs(np.outer(np.diag(K), np.diag(K))))
    wrong = np.abs(K - K.T) > ROUNDED * np.maximum(scale, 1e-9 * np.abs(K).max())
    if wrong.any():
        i, j = (int(k[0]) for k in np.nonzero(wrong))
        raise ValueError(
            f"is not symmetric: the entries {i + 1}{j + 1} and {j + 1}{i + 1} are {K[i, j]:g} and {K[j, i]:g}"
        )
    return np.asarray(0.5 * (K + K.T))


def _clean(value: float) -> float:
    """Direction cosine without the rounding of a quarter turn."""
    return value if abs(value) > 1e-15 else 0.0
