# SPDX-License-Identifier: Apache-2.0
"""Exact tooth as Bezier curves, for smooth faces in CAD programs.

Frame as in `pitchpoint.geometry.tooth_form`; points of the transverse plane are complex numbers x + iy.

Derivation: docs/theory/geometry.md, "Generation by the tool".
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.tooth_form import tooth_form

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.geometry.tooth_generation import ToothForm

ComplexArray = NDArray[np.complex128]
Curve = Callable[[NDArray[np.float64]], ComplexArray]
"""Function that gives the points of a curve at parameters from 0 to 1."""

MAX_DEGREE = 7
"""Maximum degree, above which curves are halved: not all CAD programs accept higher degrees."""
MIN_TOLERANCE = 1e-9
"""Minimum tolerance relative to the size of a curve, limited by round-off."""
_ARC = 1e-9
"""Share of half a pitch below which a root arc is omitted: the root is fully rounded."""


def bernstein(degree: int, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bernstein polynomials of a degree at parameters from 0 to 1, shape (len(t), degree + 1).

    Parameters
    ----------
    degree
        Degree, at least 1.
    t
        Parameters.

    Examples
    --------
    >>> bernstein(2, np.array([0.5])).tolist()
    [[0.25, 0.5, 0.25]]
    """
    k = np.arange(degree + 1)
    binomial = np.array([math.comb(degree, i) for i in k], dtype=float)
    return np.asarray(binomial * t[:, None] ** k * (1.0 - t[:, None]) ** (degree - k))


def bezier_curves(curve: Curve, tolerance: float) -> list[ComplexArray]:
    """Approximate a curve by successive Bezier curves of the lowest sufficient degree.

    Parameters
    ----------
    curve
        Smooth curve.
    tolerance
        Maximum distance between points of the same parameter, in the unit of the curve.

    Returns
    -------
    list of ndarray
        Control points of each curve, shape (degree + 1,); the first and last are on the curve, adjacent
        curves share an end point.

    Notes
    -----
    Interpolation at Chebyshev points of the second kind, ends included, so that adjacent curves meet exactly.

    Examples
    --------
    >>> quarter = bezier_curves(lambda t: np.exp(0.5j * np.pi * t), 1e-6)
    >>> [p.size for p in quarter]
    [8]
    >>> bool(abs(bernstein(7, np.array([0.3])) @ quarter[0] - np.exp(0.15j * np.pi))[0] < 1e-6)
    True
    """
    for degree in range(1, MAX_DEGREE + 1):
        nodes = 0.5 - 0.5 * np.cos(np.pi * np.arange(degree + 1) / degree)
        poles = np.linalg.solve(bernstein(degree, nodes), curve(nodes))
        poles[[0, -1]] = curve(np.array([0.0, 1.0]))
        check = np.linspace(0.0, 1.0, 8 * degree + 1)
        if float(np.abs(bernstein(degree, check) @ poles - curve(check)).max()) <= tolerance:
            return [np.asarray(poles, dtype=np.complex128)]
    first = bezier_curves(lambda t: curve(0.5 * t), tolerance)
    second = bezier_curves(lambda t: curve(0.5 + 0.5 * t), tolerance)
    second[0][0] = first[-1][-1]
    return first + second


def _pieces(form: ToothForm) -> list[Curve]:
    """Exact curves of one pitch: root, right fillet, right flank, tip, left flank, left fillet."""
    half, foot = form.half_pitch_angle, form.root_half_angle
    low, high = np.sqrt(np.maximum(np.array([form.r_Ff, form.r_Fa]) ** 2 / form.r_b**2 - 1.0, 0.0))
    tip = form.tip_half_angle

    def fillet(t: NDArray[np.float64]) -> ComplexArray:
        """Points of the fillet, complex [m]; t = 0 at the root, 1 at the flank."""
        r, angle = form.fillet_polar(form.fillet.theta_root + t * (form.theta_form - form.fillet.theta_root))
        return np.asarray(r * np.exp(1j * angle))

    def involute(t: NDArray[np.float64]) -> ComplexArray:
        """Points of the involute, complex [m]; t = 0 at its root end, 1 at its tip end."""
        roll = low + t * (high - low)
        angle = form.psi_b - form.sign * (roll - np.arctan(roll))
        return np.asarray(form.r_b * np.hypot(1.0, roll) * np.exp(1j * angle))

    def radial(t: NDArray[np.float64]) -> ComplexArray:
        """Points of the radial line from the involute to the tip circle, complex [m]."""
        return np.asarray((form.r_Fa + t * (form.r_a - form.r_Fa)) * np.exp(1j * tip))

    left: list[Curve] = [fillet, involute]
    edge = form.edge
    if edge is not None:
        left.append(lambda t: edge.points(t)[0])
    elif form.is_internal and form.r_Fa > form.r_a:
        left.append(radial)  # inside the base circle the flank continues radially
    right: list[Curve] = [lambda t, c=c: c(t).conj() for c in left]  # type: ignore[misc]
    back: list[Curve] = [lambda t, c=c: c(1.0 - t) for c in reversed(left)]  # type: ignore[misc]
    root: list[Curve] = []
    if half - foot > _ARC * half:
        root = [lambda t: np.asarray(form.r_f * np.exp(1j * (foot - 2.0 * half + 2.0 * t * (half - foot))))]
    land: Curve = lambda t: np.asarray(form.r_a * np.exp(1j * tip * (2.0 * t - 1.0)))  # noqa: E731
    return [*root, *right, land, *back]


def pitch_curves(gear: CylindricalGear, tolerance: float = 1e-6) -> list[ComplexArray]:
    """Control points of the Bezier curves of one pitch of a gear, with the tooth on the x axis.

    Parameters
    ----------
    gear
        External or internal gear without an outline.
    tolerance
        Maximum distance from the exact tooth, in modules.

    Returns
    -------
    list of ndarray
        Control points [m], shapes (degree + 1,), of successive curves, counter-clockwise, from the end of the
        left fillet of the preceding tooth to that of this tooth. The error of the enclosed area is at most
        about `tolerance` modules times the length of the outline.

    Raises
    ------
    GeometryError
        If the tooth is not possible, or if the gear has an outline of measured points.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> curves = pitch_curves(CylindricalGear(z=17, m_n=1e-3))
    >>> turn = np.exp(2j * np.pi / 17)
    >>> bool(abs(curves[-1][-1] - curves[0][0] * turn) < 1e-15), max(p.size for p in curves) <= 8
    (True, True)
    """
    if gear.outline is not None:
        raise GeometryError(
            "are points, not curves, which would give one face for each",
            where="tooth_profile",
            value=f"{len(gear.outline.points)} points a tooth",
            remedy="export STL instead, or omit tooth_profile",
        )
    limit = max(tolerance, MIN_TOLERANCE) * gear.m_n
    found = [poles for piece in _pieces(tooth_form(gear)) for poles in bezier_curves(piece, limit)]
    for before, after in zip(found[:-1], found[1:], strict=True):
        after[0] = before[-1]
    found[0][0] = found[-1][-1] * np.exp(-2j * math.pi / abs(gear.z))
    return found


def twist_curves(angle: float, tolerance: float = 1e-6) -> list[ComplexArray]:
    """Control points of exp(iφ) for φ = −angle/2 to angle/2, parametrised by φ: the twist along a helix.

    A point p of the transverse section traces p times these curves at constant rise; each has shape
    (degree + 1,).

    Parameters
    ----------
    angle
        Twist over the face width [rad]; 0 gives one straight line.
    tolerance
        Maximum distance from the unit circle.

    Examples
    --------
    >>> [p.size for p in twist_curves(0.1)], [p.size for p in twist_curves(0.0)]
    ([4], [2])
    """
    if angle == 0.0:
        return [np.ones(2, dtype=complex)]
    limit = max(tolerance, MIN_TOLERANCE)
    return bezier_curves(lambda t: np.exp(1j * angle * (t - 0.5)), limit)
