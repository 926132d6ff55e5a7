# SPDX-License-Identifier: Apache-2.0
"""Real tooth of a gear as points: outline, and gap of its flanks to the nominal involute.

Frame as in `pitchpoint.geometry.tooth_form`: the tooth is on the +x axis, its left flank has y > 0.

Derivation: docs/theory/geometry.md, "Micro-geometry, deviations, damage".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.geometry.outline_check import (
    MIN_FLANK,
    MIN_TOOTH,
    check_flank,
    check_height,
    flank_part,
    missing_material,
    one_pitch,
    plane_points,
    sides,
)
from pitchpoint.geometry.outline_check import (
    OutlineError as OutlineError,
)
from pitchpoint.geometry.outline_order import check_path, check_simple
from pitchpoint.geometry.tooth_form import tooth_form

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FloatArray = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]

_NOMINAL_POINTS = 200


@dataclass(frozen=True)
class ToothOutline:
    """Outline of one pitch of a gear; all teeth are equal.

    Parameters
    ----------
    points
        (x, y) [m] in the transverse plane, counter-clockwise from a point in the root over the tooth on the
        +x axis to just before the same point of the next root. Use `outline_from_tooth` or
        `outline_from_flanks`, which check that the points fit the gear.
    """

    points: tuple[tuple[float, float], ...]

    @cached_property
    def plane(self) -> ComplexArray:
        """The points as complex numbers x + iy [m], shape (n,)."""
        xy = np.array(self.points)
        return np.asarray(xy[:, 0] + 1j * xy[:, 1])

    def root_radius(self, gear: CylindricalGear) -> float:
        """Radius of the deepest point [m], positive."""
        return abs(float((gear.sign * np.abs(self.plane)).min()))

    def section(self, z: int, radius: float = math.inf) -> tuple[float, float]:
        """Area [m²] and polar second moment [m⁴] inside the outline of a gear with `z` teeth and a circle.

        Parameters
        ----------
        z
            Number of teeth.
        radius
            Radius of the circle about the axis [m]; infinite: all of the region inside the outline.

        Notes
        -----
        A = ½ ∮ r² dθ and I_p = ¼ ∮ r⁴ dθ with r linear in θ between the points: exact on circles, elsewhere
        with an error of second order in the point spacing. Outside the circle, r is replaced by its radius.

        Examples
        --------
        >>> square = ToothOutline(((1.0, -1.0), (1.0, 1.0)))
        >>> [round(v, 3) for v in square.section(4)]    # between points r stays √2: a circle
        [6.283, 6.283]
        >>> [round(v, 3) for v in square.section(4, 1.0)]
        [3.142, 1.571]
        """
        closed = np.append(self.plane, self.plane[0] * np.exp(2j * math.pi / z))
        r, turn = np.abs(closed), np.angle(closed[1:] / closed[:-1])
        cross = np.flatnonzero((r[1:] - radius) * (r[:-1] - radius) < 0.0)
        if cross.size:  # divided where they cross the circle
            part = (radius - r[cross]) / (r[cross + 1] - r[cross])
            turn, whole = np.insert(turn, cross, turn[cross] * part), turn[cross]
            turn[cross + np.arange(1, cross.size + 1)] = whole * (1.0 - part)
            r = np.insert(r, cross + 1, radius)
        a, b = np.minimum(r[:-1], radius), np.minimum(r[1:], radius)
        area = float(np.sum(turn * (a * a + a * b + b * b))) / 6.0
        polar = float(np.sum(turn * (a**4 + a**3 * b + a * a * b * b + a * b**3 + b**4))) / 20.0
        return z * area, z * polar

    def gap(self, gear: CylindricalGear, flank: str, roll: ArrayLike) -> FloatArray:
        """Missing material of a flank relative to the nominal involute, along the transverse base tangent.

        Parameters
        ----------
        gear
            The gear, whose involute is the nominal one.
        flank
            "left" or "right".
        roll
            Roll lengths [m], shape (n,).

        Returns
        -------
        ndarray, shape (n,)
            Gap [m], positive for missing material. Linear between the points, constant beyond them.

        Notes
        -----
        A point at the radius r with the half tooth angle ψ is on an involute of the base circle rotated by
        ψ − ψ(r) relative to the nominal one; their distance is r_b (ψ(r) − ψ) along the tangents of the base
        circle. A deviation of the tooth thickness is included.
        """
        right, left = sides(self.plane)
        path = self.plane[left] if flank == "left" else self.plane[right].conj()
        length, missing = missing_material(gear, path[flank_part(gear, path)])
        order = np.argsort(length)
        return np.interp(np.asarray(roll, dtype=float), length[order], missing[order])


def outline_from_tooth(gear: CylindricalGear, points: ArrayLike, part: str = "tooth") -> ToothOutline:
    """Outline from the points of one tooth, root to root.

    Parameters
    ----------
    gear
        The gear of the tooth, without an outline.
    points
        Shape (n, 2) [m], in order over the tooth on the +x axis, in either direction; the closing point of
        the pitch is optional.
    part
        Name for messages.

    Raises
    ------
    OutlineError
        If the points are not a closed, simple outline of one pitch, or are off the nominal tooth by more than
        `OFF_INVOLUTE` (flank, tip) or `OFF_ROOT` (root).

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_profile
    >>> gear = CylindricalGear(z=17, m_n=1e-3)
    >>> outline = outline_from_tooth(gear, tooth_profile(gear, 40).points)
    >>> len(outline.points), bool(abs(outline.gap(gear, "left", [2.5e-3, 4e-3])).max() < 1e-15)
    (103, True)
    """
    plane, index = plane_points(points, part, MIN_TOOTH)
    if np.angle(plane[-1]) < np.angle(plane[0]):
        plane, index = plane[::-1], index[::-1]
    plane, index = one_pitch(gear, plane, index, part)
    right, left = sides(plane)
    angle = np.angle(plane)
    back = index[1:][(angle[1:] < 0.0) & (angle[:-1] >= 0.0)]
    if back.size:
        raise OutlineError(
            part,
            int(back[0]),
            "crosses the centre line of the tooth again",
            remedy="put the points in order",
        )
    check_height(gear, plane, index, part)
    for side, mirrored in ((right, plane[right].conj()), (left, plane[left])):
        check_flank(gear, mirrored, index[side], part)
    check_path(plane, index, part)
    check_simple(gear, plane, index, part)
    return ToothOutline(tuple((float(w.real), float(w.imag)) for w in plane))


def outline_from_flanks(
    gear: CylindricalGear, left: ArrayLike | None = None, right: ArrayLike | None = None
) -> ToothOutline:
    """Outline with one or both flanks from points, the rest as generated.

    Parameters
    ----------
    gear
        The gear of the flanks, without an outline.
    left, right
        Points of the flank, shape (n, 2) [m], from root to tip or back, on their side of the tooth on the +x
        axis; None = the nominal flank. Beyond its ends a flank continues as the nominal one, rotated by the
        deviation there.

    Raises
    ------
    OutlineError
        If a flank has too few points, is not monotonic in radius, crosses or runs back along itself, omits
        too much of the usable flank or is too far off the nominal one.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> gear = CylindricalGear(z=17, m_n=1e-3)
    >>> r, half, n = tooth_form(gear).flank(60)
    >>> thin = r[n:] * np.exp(1j * (half[n:] - 1e-3))
    >>> outline = outline_from_flanks(gear, left=np.column_stack([thin.real, thin.imag]))
    >>> [round(1e6 * abs(float(outline.gap(gear, f, [3e-3])[0])), 3) for f in ("left", "right")]
    [7.987, 0.0]
    """
    form = tooth_form(gear)
    halves = []
    for part, points in (("right", right), ("left", left)):
        r, half, _ = form.flank(_NOMINAL_POINTS)
        path = r * np.exp(1j * half)
        if form.edge is not None:
            r, half = form.edge.drawn(_NOMINAL_POINTS)
            path = np.append(path, r * np.exp(1j * half))
        if points is not None:
            read, index = plane_points(points, part, MIN_FLANK)
            read = read.conj() if part == "right" else read
            if read.imag.mean() < 0.0:
                raise OutlineError(
                    part,
                    int(index[0]),
                    "lies on the other side of the tooth",
                    remedy=f"the {part} flank has y {'>' if part == 'left' else '<'} 0 with the tooth on +x",
                )
            if gear.sign * (abs(read[-1]) - abs(read[0])) < 0.0:
                read, index = read[::-1], index[::-1]
            check_flank(gear, read, index, part)
            check_path(read, index, part)
            path = _continued(gear, path, read)
        halves.append(path)
    edge = form.half_pitch_angle
    n_arc = _NOMINAL_POINTS // 5
    clockwise, counter = halves
    angles = [
        np.linspace(-edge, -np.angle(clockwise[0]), n_arc + 1)[:-1],
        np.linspace(-np.angle(clockwise[-1]), np.angle(counter[-1]), n_arc + 2)[1:-1],
        np.linspace(np.angle(counter[0]), edge, n_arc + 1)[1:-1],
    ]
    radii = (abs(clockwise[0]), abs(counter[-1]), abs(counter[0]))
    root, tip, next_root = (r * np.exp(1j * a) for r, a in zip(radii, angles, strict=True))
    plane = np.concatenate([root, clockwise.conj(), tip, counter[::-1], next_root])
    plane = plane[np.append(True, np.abs(np.diff(plane)) > 1e-12 * form.r_b)]
    closing = plane[0] * np.exp(2j * edge)
    plane = plane[:-1] if abs(plane[-1] - closing) < 1e-9 * form.r_b else plane
    check_simple(gear, plane, None, "left" if right is None else "right")
    return ToothOutline(tuple((float(w.real), float(w.imag)) for w in plane))


def _continued(gear: CylindricalGear, nominal: ComplexArray, read: ComplexArray) -> ComplexArray:
    """Flank from root to tip circle: the given points, continued without a step by the nominal flank."""
    height = gear.sign * np.abs(nominal)
    _, missing = missing_material(gear, read)
    turn = missing / abs(gear.r_b)
    below = nominal[height < gear.sign * abs(read[0]) - 1e-6 * gear.m_n] * np.exp(-1j * turn[0])
    above = nominal[height > gear.sign * abs(read[-1]) + 1e-6 * gear.m_n] * np.exp(-1j * turn[-1])
    edge = math.pi / abs(gear.z)
    below = np.abs(below) * np.exp(1j * np.minimum(np.angle(below), edge))
    return np.concatenate([below, read, above])
