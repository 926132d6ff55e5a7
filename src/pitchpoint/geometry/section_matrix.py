# SPDX-License-Identifier: Apache-2.0
"""Stiffness and mass matrices of a section of a blade as properties of a beam about its principal axes.

Source of the matrices: Q. Wang, M. A. Sprague, J. Jonkman, N. Johnson, B. Jonkman, BeamDyn: a high-fidelity
wind turbine blade solver in the FAST modular framework, Wind Energy 20 (2017) 1439-1462.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]
_NEAR_ROUND = 1e-9
ROUND = 1e-3
"""Difference of the bending stiffnesses, relative to the larger one, below which a section has no axes of its
own along a beam."""


def section_properties(stiffness: ArrayLike, mass: ArrayLike) -> dict[str, float]:
    """Properties of a section about its principal axes, from its matrices about a reference point.

    The order of strains and forces is that of BeamDyn and windIO: along axes 1 and 2 and the beam, then
    rotations about them. With the elastic centre at (x, y): K_34 = E A y, K_35 = -E A x; bending is that
    about the elastic centre, torsion that about the shear centre (x_s, y_s), (K_16, K_26) = K_s (-y_s, x_s)
    with the shear stiffness K_s. The coupling of bending and torsion, K_46 and K_56, and of shear and bending
    are not properties of a beam of `BeamTable`.

    Parameters
    ----------
    stiffness, mass
        Symmetric matrices, shape (6, 6) [N, N m, N m²] and [kg/m, kg, kg m].

    Returns
    -------
    dict
        Columns of `BeamTable` except position and offsets; `twist` is the rotation of the principal axes,
        at most 45°.

    Raises
    ------
    ValueError
        If the stiffness is not positive definite, or the mass is negative.

    Examples
    --------
    >>> stiff = np.diag([1e8, 2e8, 5e9, 4e9, 1e9, 3e8])
    >>> stiff[2, 3] = stiff[3, 2] = 5e9 * 0.1  # elastic centre 0.1 m along axis 2
    >>> found = section_properties(stiff, np.diag([200.0, 200.0, 200.0, 50.0, 10.0, 60.0]))
    >>> found["elastic_2"], found["bending_1"] / 1e9, round(found["bending_2"] / 1e9, 9)
    (0.1, 1.0, 3.95)
    """
    K, M = (np.array(m, dtype=float) for m in (stiffness, mass))
    if not (np.isfinite(K).all() and np.isfinite(M).all()):
        raise ValueError("contains values that are not finite")
    K, M = 0.5 * (K + K.T), 0.5 * (M + M.T)
    if not (np.linalg.eigvalsh(_scaled(K)) > 0.0).all():
        raise ValueError("is not positive definite")
    if M[0, 0] < 0.0:
        raise ValueError("has a negative mass")
    axial = K[2, 2]
    elastic = np.array([-K[2, 4], K[2, 3]]) / axial
    one = K[4, 4] - axial * elastic[0] ** 2
    two = K[3, 3] - axial * elastic[1] ** 2
    product = -K[3, 4] - axial * elastic[0] * elastic[1]
    turn = _principal(one, two, product)
    c, s = math.cos(turn), math.sin(turn)
    rotation = np.array([[c, s], [-s, c]])  # components along the principal axes
    bending = rotation @ np.array([[one, product], [product, two]]) @ rotation.T
    shear = K[:2, :2]
    across = np.linalg.solve(shear, K[:2, 5])
    torsion = K[5, 5] - K[:2, 5] @ across
    shear_center = rotation @ np.array([across[1], -across[0]])
    along = rotation @ shear @ rotation.T
    m = M[0, 0]
    center = np.array([M[1, 5], -M[0, 5]]) / m if m > 0.0 else np.zeros(2)
    polar = M[5, 5] - m * float(center @ center)
    own, mass_center = rotation @ elastic, rotation @ center
    return {
        "mass": float(m),
        "bending_1": float(bending[0, 0]),
        "bending_2": float(bending[1, 1]),
        "torsion": float(torsion),
        "axial": float(axial),
        "twist": turn,
        "center_1": float(mass_center[0]),
        "center_2": float(mass_center[1]),
        "gyration": math.sqrt(max(polar, 0.0) / m) if m > 0.0 else 0.0,
        "elastic_1": float(own[0]),
        "elastic_2": float(own[1]),
        "shear_center_1": float(shear_center[0]),
        "shear_center_2": float(shear_center[1]),
        "shear_1": float(along[0, 0]),
        "shear_2": float(along[1, 1]),
    }


def continued(sections: Sequence[dict[str, float]]) -> list[dict[str, float]]:
    """Sections along a beam with axes that turn continuously from one to the next.

    Principal axes are known except for quarter turns, for which the columns of both axes are exchanged: each
    section has those nearest to the axes before it. Round sections (`ROUND`) have the axes of the section
    before them, at the beginning those of the first section that is not round.

    Parameters
    ----------
    sections
        Properties of `section_properties` along the beam.

    Examples
    --------
    >>> one = section_properties(np.diag([1.0, 2, 3, 4, 5, 6]), np.eye(6))
    >>> two = continued([one | {"twist": 0.77}, one | {"twist": -0.77}])[1]
    >>> round(two["twist"], 4), two["bending_1"], two["bending_2"], two["shear_1"]
    (0.8008, 4.0, 5.0, 2.0)
    """
    quarter = 0.5 * math.pi
    before = next((s["twist"] for s in sections if not _is_round(s)), 0.0)
    found = []
    for section in sections:
        turn = before - section["twist"]
        if not _is_round(section):
            turn = quarter * round(turn / quarter)
        before = section["twist"] + turn
        found.append(_turned(section, turn) if turn != 0.0 else section)
    return found


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


def _principal(one: float, two: float, product: float) -> float:
    """Rotation from the given to the nearest principal axes, from -45° to 45°; 0 for a round section."""
    if abs(product) <= _NEAR_ROUND * max(one, two):
        return 0.0
    if one == two:
        return math.copysign(0.25 * math.pi, product)
    return 0.5 * math.atan(2.0 * product / (one - two))


def _is_round(section: dict[str, float]) -> bool:
    """Whether both bending stiffnesses are nearly equal."""
    one, two = section["bending_1"], section["bending_2"]
    return abs(one - two) <= ROUND * max(one, two)


def _turned(section: dict[str, float], angle: float) -> dict[str, float]:
    """Section with its axes turned by a quarter, or a round section by any angle."""
    c, s = math.cos(angle), math.sin(angle)
    found = section | {"twist": section["twist"] + angle}
    for name in ("bending", "shear"):
        one, two = section[f"{name}_1"], section[f"{name}_2"]
        found[f"{name}_1"], found[f"{name}_2"] = c * c * one + s * s * two, s * s * one + c * c * two
    for name in ("center", "elastic", "shear_center"):
        one, two = section[f"{name}_1"], section[f"{name}_2"]
        found[f"{name}_1"], found[f"{name}_2"] = c * one + s * two, c * two - s * one
    return found


def _scaled(K: FloatArray) -> FloatArray:
    """Matrix with a diagonal of one, for a test that does not depend on units."""
    d = np.diag(K)
    if not (d > 0.0).all():
        return -np.eye(6)
    return K / np.sqrt(np.outer(d, d))
