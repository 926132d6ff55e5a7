# SPDX-License-Identifier: Apache-2.0
"""The exact tooth as Bezier curves, from which CAD programs make smooth faces.

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
"""Points of a curve at parameters from 0 to 1."""

MOST_DEGREE = 7
"""Curves that need more are halved: programs differ in what they accept beyond."""
LEAST_TOLERANCE = 1e-9
"""Of a curve per length of its size; finer fits end in round-off."""
_ARC = 1e-9
"""Root arcs shorter than this share of a pitch are none: the root is fully rounded."""


def bernstein(degree: int, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bernstein polynomials of a degree at parameters from 0 to 1, shape (len(t), degree + 1).

    Parameters
    ----------
    degree
        At least 1.
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
    """Bezier curves in a row that follow a curve, of the lowest degree that is near enough.

    Parameters
    ----------
    curve
        Smooth curve.
    tolerance
        Largest distance between points of the same parameter, in the unit of the curve.

    Returns
    -------
    list of ndarray
        Control points of each, shape (degree + 1,); the first and last lie on the curve, neighbours share
        theirs.

    Notes
    -----
    Interpolation at Chebyshev points of the second kind, ends included, so that neighbours meet exactly.

    Examples
    --------
    >>> quarter = bezier_curves(lambda t: np.exp(0.5j * np.pi * t), 1e-6)
    >>> [p.size for p in quarter]
    [8]
    >>> bool(abs(bernstein(7, np.array([0.3])) @ quarter[0] - np.exp(0.15j * np.pi))[0] < 1e-6)
    True
    """
    for degree in range(1, MOST_DEGREE + 1):
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
    """Curves of one pitch: root, right fillet, right flank, tip, left flank, left fillet."""
    half, foot = form.half_pitch_angle, form.root_half_angle
    low, high = np.sqrt(np.maximum(np.array([form.r_Ff, form.r_Fa]) ** 2 / form.r_b**2 - 1.0, 0.0))
    tip = form.tip_half_angle

    def fillet(t: NDArray[np.float64]) -> ComplexArray:
        """Points of the fillet, 0 at the root and 1 at the flank, complex [m]."""
        r, angle = form.fillet_polar(form.fillet.theta_root + t * (form.theta_form - form.fillet.theta_root))
        return np.asarray(r * np.exp(1j * angle))

    def involute(t: NDArray[np.float64]) -> ComplexArray:
        """Points of the flank, 0 at its root end and 1 at its tip end, complex [m]."""
        roll = low + t * (high - low)
        angle = form.psi_b - form.sign * (roll - np.arctan(roll))
        return np.asarray(form.r_b * np.hypot(1.0, roll) * np.exp(1j * angle))

    def radial(t: NDArray[np.float64]) -> ComplexArray:
        """Points of the straight piece from the flank to the tip circle, complex [m]."""
        return np.asarray((form.r_Fa + t * (form.r_a - form.r_Fa)) * np.exp(1j * tip))

    left: list[Curve] = [fillet, involute]
    if form.is_internal and form.r_Fa > form.r_a:
        left.append(radial)  # inside the base circle the flank continues radially
    right: list[Curve] = [lambda t, c=c: c(t).conj() for c in left]  # type: ignore[misc]
    back: list[Curve] = [lambda t, c=c: c(1.0 - t) for c in reversed(left)]  # type: ignore[misc]
    root: list[Curve] = []
    if half - foot > _ARC * half:
        root = [lambda t: np.asarray(form.r_f * np.exp(1j * (foot - 2.0 * half + 2.0 * t * (half - foot))))]
    land: Curve = lambda t: np.asarray(form.r_a * np.exp(1j * tip * (2.0 * t - 1.0)))  # noqa: E731
    return [*root, *right, land, *back]


def pitch_curves(gear: CylindricalGear, tolerance: float = 1e-6) -> list[ComplexArray]:
    """Control points of the Bezier curves of one pitch of a gear, from a root over the tooth on the x axis.

    Parameters
    ----------
    gear
        External or internal gear without points of its own.
    tolerance
        Largest distance from the exact tooth, in modules.

    Returns
    -------
    list of ndarray
        Control points [m], shapes (degree + 1,), of successive curves, counter-clockwise, from the end of
        the left fillet of the tooth before to that of this tooth. The area they enclose differs from the
        exact one by about
        `tolerance` modules times the length of the outline at most.

    Raises
    ------
    GeometryError
        If the gear has no such tooth, or an outline of measured points.

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
            remedy="export STL instead, or leave tooth_profile out",
        )
    limit = max(tolerance, LEAST_TOLERANCE) * gear.m_n
    found = [poles for piece in _pieces(tooth_form(gear)) for poles in bezier_curves(piece, limit)]
    for before, after in zip(found[:-1], found[1:], strict=True):
        after[0] = before[-1]
    found[0][0] = found[-1][-1] * np.exp(-2j * math.pi / abs(gear.z))
    return found


def twist_curves(angle: float, tolerance: float = 1e-6) -> list[ComplexArray]:
    """Control points of exp(iφ) from φ = −angle/2 to angle/2 at equal steps of φ: a section along a helix.

    A point p of the section follows p times these curves at constant rise; each has shape (degree + 1,).

    Parameters
    ----------
    angle
        Twist over the face width [rad]; 0 gives one straight line.
    tolerance
        Largest distance of the unit circle.

    Examples
    --------
    >>> [p.size for p in twist_curves(0.1)], [p.size for p in twist_curves(0.0)]
    ([4], [2])
    """
    if angle == 0.0:
        return [np.ones(2, dtype=complex)]
    limit = max(tolerance, LEAST_TOLERANCE)
    return bezier_curves(lambda t: np.exp(1j * angle * (t - 0.5)), limit)
