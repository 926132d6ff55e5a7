# SPDX-License-Identifier: Apache-2.0
"""The tooth of a gear as points: its outline, and what its flanks lack against the nominal involute.

Frame as in `pitchpoint.geometry.tooth_form`: the tooth stands on the +x axis, its left flank has y > 0.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.modifications import flank_range
from pitchpoint.geometry.tooth_form import tooth_form

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FloatArray = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]
IntArray = NDArray[np.int64]

OFF_INVOLUTE = 0.2
"""Largest distance of a flank or tip from the nominal one, in normal modules; beyond it is another gear."""
OFF_ROOT = 0.5
"""The same for the root circle, which tools set more freely."""
UNCOVERED = 0.1
"""Share of the usable flank that points may leave out at either end; the last deviation goes on there."""
MOST_POINTS = 2000
_LEAST_TOOTH, _LEAST_FLANK = 10, 5
_NOMINAL_POINTS = 200


class OutlineError(GeometryError):
    """A tooth that cannot belong to its gear; `point` counts the points of the offending `part` from 0."""

    def __init__(self, part: str, point: int | None, message: str, **more: str | None) -> None:
        super().__init__(message, where=part if point is None else f"{part}[{point}]", **more)
        self.part, self.point = part, point


@dataclass(frozen=True)
class ToothOutline:
    """Outline of one pitch of a gear; all teeth are alike.

    Parameters
    ----------
    points
        (x, y) [m] in the transverse plane, counter-clockwise from a place in the root over the tooth on the
        +x axis to just before the same place of the next root. Make them with `outline_from_tooth` or
        `outline_from_flanks`, which check that they fit the gear.
    """

    points: tuple[tuple[float, float], ...]

    @cached_property
    def plane(self) -> ComplexArray:
        """The points as complex numbers x + iy [m]."""
        xy = np.array(self.points)
        return np.asarray(xy[:, 0] + 1j * xy[:, 1])

    def root_radius(self, gear: CylindricalGear) -> float:
        """Radius of the deepest point [m], positive."""
        return abs(float((gear.sign * np.abs(self.plane)).min()))

    def section(self, z: int) -> tuple[float, float]:
        """Area [m²] and polar second moment [m⁴] inside the outline of a gear with `z` teeth.

        Notes
        -----
        A = ½ ∮ r² dθ and I_p = ¼ ∮ r⁴ dθ with r linear in θ between the points: exact on circles, of second
        order in the distance of the points elsewhere.

        Examples
        --------
        >>> square = ToothOutline(((1.0, -1.0), (1.0, 1.0)))
        >>> [round(v, 3) for v in square.section(4)]    # between points r stays √2: a circle
        [6.283, 6.283]
        """
        closed = np.append(self.plane, self.plane[0] * np.exp(2j * math.pi / z))
        a, b = np.abs(closed[:-1]), np.abs(closed[1:])
        turn = np.angle(closed[1:] / closed[:-1])
        area = float(np.sum(turn * (a * a + a * b + b * b))) / 6.0
        polar = float(np.sum(turn * (a**4 + a**3 * b + a * a * b * b + a * b**3 + b**4))) / 20.0
        return z * area, z * polar

    def gap(self, gear: CylindricalGear, flank: str, roll: ArrayLike) -> FloatArray:
        """Material missing on a flank against the nominal involute, along the transverse base tangent.

        Parameters
        ----------
        gear
            The gear, whose involute is the nominal one.
        flank
            "left" or "right".
        roll
            Lengths of roll [m], shape (n,).

        Returns
        -------
        ndarray, shape (n,)
            [m], positive = gap. Linear between the points, constant beyond them.

        Notes
        -----
        A point at the radius r with the half tooth angle ψ lies on the involute of the base circle that is
        turned by ψ − ψ(r) against the nominal one; both are r_b (ψ(r) − ψ) apart along their common
        tangents of the base circle. A wrong tooth thickness counts like any other deviation.
        """
        right, left = _sides(self.plane)
        path = self.plane[left] if flank == "left" else self.plane[right].conj()
        length, missing = _missing(gear, path[_flank_part(gear, path)])
        order = np.argsort(length)
        return np.interp(np.asarray(roll, dtype=float), length[order], missing[order])


def outline_from_tooth(gear: CylindricalGear, points: ArrayLike, part: str = "tooth") -> ToothOutline:
    """Outline from the points of one tooth, root to root.

    Parameters
    ----------
    gear
        The gear to which the tooth belongs, without an outline of its own.
    points
        Shape (n, 2) [m], in order over the tooth on the +x axis, either way round; the point that closes the
        pitch may be there or not.
    part
        Name for messages.

    Raises
    ------
    OutlineError
        If the points are no closed, simple outline of one pitch, or lie off the nominal tooth by more than
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
    plane, index = _plane(points, part, _LEAST_TOOTH)
    if np.angle(plane[-1]) < np.angle(plane[0]):
        plane, index = plane[::-1], index[::-1]
    plane, index = _one_pitch(gear, plane, index, part)
    right, left = _sides(plane)
    angle = np.angle(plane)
    back = index[1:][(angle[1:] < 0.0) & (angle[:-1] >= 0.0)]
    if back.size:
        raise OutlineError(
            part, int(back[0]), "goes back over the centre line of the tooth", remedy="put the points in order"
        )
    _check_height(gear, plane, index, part)
    for side, mirrored in ((right, plane[right].conj()), (left, plane[left])):
        _check_flank(gear, mirrored, index[side], part)
    _check_simple(gear, plane, index, part)
    return ToothOutline(tuple((float(w.real), float(w.imag)) for w in plane))


def outline_from_flanks(
    gear: CylindricalGear, left: ArrayLike | None = None, right: ArrayLike | None = None
) -> ToothOutline:
    """Outline with one or both flanks from points and everything else as generated.

    Parameters
    ----------
    gear
        The gear to which the flanks belong, without an outline of its own.
    left, right
        Points of the flank, shape (n, 2) [m], from root to tip or back, on their side of the tooth on the +x
        axis; None = the nominal flank. Beyond its ends a flank goes on nominal, turned by the deviation there.

    Raises
    ------
    OutlineError
        If a flank has too few points, does not rise steadily, leaves out too much of the usable flank or lies
        too far from the nominal one.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> gear = CylindricalGear(z=17, m_n=1e-3)
    >>> r, half, n = tooth_form(gear).flank(60)
    >>> thin = r[n:] * np.exp(1j * (half[n:] - 1e-3))
    >>> outline = outline_from_flanks(gear, left=np.column_stack([thin.real, thin.imag]))
    >>> [round(1e6 * float(outline.gap(gear, f, [3e-3])[0]), 3) for f in ("left", "right")]
    [7.987, 0.0]
    """
    form = tooth_form(gear)
    halves = []
    for part, points in (("right", right), ("left", left)):
        r, half, _ = form.flank(_NOMINAL_POINTS)
        path = r * np.exp(1j * half)
        if points is not None:
            read, index = _plane(points, part, _LEAST_FLANK)
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
            _check_flank(gear, read, index, part)
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
    _check_simple(gear, plane, None, "left" if right is None else "right")
    return ToothOutline(tuple((float(w.real), float(w.imag)) for w in plane))


def _continued(gear: CylindricalGear, nominal: ComplexArray, read: ComplexArray) -> ComplexArray:
    """A flank from root to tip circle: points in the middle, nominal below and above, joined without a step."""
    height = gear.sign * np.abs(nominal)
    _, missing = _missing(gear, read)
    turn = missing / abs(gear.r_b)
    below = nominal[height < gear.sign * abs(read[0]) - 1e-6 * gear.m_n] * np.exp(-1j * turn[0])
    above = nominal[height > gear.sign * abs(read[-1]) + 1e-6 * gear.m_n] * np.exp(-1j * turn[-1])
    edge = math.pi / abs(gear.z)
    below = np.abs(below) * np.exp(1j * np.minimum(np.angle(below), edge))
    return np.concatenate([below, read, above])


def _plane(points: ArrayLike, part: str, least: int) -> tuple[ComplexArray, IntArray]:
    """Points without repetitions, and their numbers in the input."""
    xy = np.asarray(points, dtype=float)
    if xy.ndim != 2 or xy.shape[1] != 2:
        raise OutlineError(part, None, "are no points", value=f"shape {xy.shape}", limit="shape (n, 2)")
    bad = np.nonzero(~np.isfinite(xy).all(axis=1))[0]
    if bad.size:
        raise OutlineError(part, int(bad[0]), "is not finite", value=f"{xy[bad[0]]}")
    plane = xy[:, 0] + 1j * xy[:, 1]
    index = np.arange(plane.size)
    if plane.size:
        new = np.append(True, np.abs(np.diff(plane)) > 1e-12 * np.abs(plane).max())
        plane, index = plane[new], index[new]
    if not least <= plane.size <= MOST_POINTS:
        raise OutlineError(
            part,
            None,
            "points do not describe it" if plane.size < least else "points are more than one tooth needs",
            value=f"{plane.size}",
            limit=f"{least} to {MOST_POINTS}",
        )
    return plane, index


def _one_pitch(
    gear: CylindricalGear, plane: ComplexArray, index: IntArray, part: str
) -> tuple[ComplexArray, IntArray]:
    """The points without the one that closes the pitch; refuses what is no pitch around the +x axis."""
    pitch = 2.0 * math.pi / abs(gear.z)
    angle = np.angle(plane)
    if not angle[0] < 0.0 < angle[-1]:
        raise OutlineError(
            part,
            int(index[0]),
            "begins and ends on the same side of the x axis",
            value=f"{math.degrees(angle[0]):.4g} deg",
            remedy="give one tooth from root to root that stands on the +x axis, or its angle",
        )
    span = float(angle[-1] - angle[0])
    if abs(span - pitch) <= 1e-6 * pitch:
        plane, index, span = plane[:-1], index[:-1], float(angle[-2] - angle[0])
    if not 0.75 * pitch <= span < pitch:
        raise OutlineError(
            part,
            int(index[-1]),
            "spans the wrong angle for one tooth",
            value=f"{math.degrees(span):.6g} deg",
            limit=f"{math.degrees(0.75 * pitch):.6g} to {math.degrees(pitch):.6g} deg, a pitch of this gear",
            remedy="give the points of one tooth from root to root; check number_of_teeth",
        )
    step = abs(abs(plane[-1]) - abs(plane[0]))
    if step > OFF_INVOLUTE * gear.m_n:
        raise OutlineError(
            part,
            int(index[-1]),
            "is not closed: it ends off the radius where it begins",
            value=f"{1e3 * step:.4g} mm",
            limit=f"{1e3 * OFF_INVOLUTE * gear.m_n:.4g} mm, {OFF_INVOLUTE:g} m_n",
            remedy="give the points from root to root",
        )
    return plane, index


def _sides(plane: ComplexArray) -> tuple[IntArray, IntArray]:
    """Numbers of the points of the right and of the left side, both from root to tip."""
    split = int(np.argmax(np.angle(plane) >= 0.0))
    return np.arange(split), np.arange(plane.size - 1, split - 1, -1)


def _check_height(gear: CylindricalGear, plane: ComplexArray, index: IntArray, part: str) -> None:
    """Tip and root circles are about those of the gear."""
    height = gear.sign * np.abs(plane)
    r_f = gear.sign * tooth_form(gear).r_f
    for what, at, nominal, share in (
        ("tip", int(height.argmax()), 0.5 * gear.d_a, OFF_INVOLUTE),
        ("root", int(height.argmin()), r_f, OFF_ROOT),
    ):
        if abs(height[at] - nominal) > share * gear.m_n:
            raise OutlineError(
                part,
                int(index[at]),
                f"is the {what} diameter of another gear",
                value=f"{2e3 * abs(height[at]):.6g} mm",
                limit=f"{2e3 * abs(nominal):.6g} mm and {2e3 * share * gear.m_n:.4g} mm beside it",
                remedy=f"check the unit, normal_module, number_of_teeth and {what}_diameter",
            )


def _flank_part(gear: CylindricalGear, path: ComplexArray) -> slice:
    """The points of a side, root to tip, that belong to the usable flank; at its ends one beyond or on it."""
    height = gear.sign * np.abs(path)
    slack = 1e-6 * gear.m_n
    tip = int(np.argmax(height >= min(0.5 * gear.d_Fa, float(height.max())) - slack))
    low = np.nonzero(height[: tip + 1] <= max(0.5 * gear.d_Ff, float(height[: tip + 1].min())) + slack)[0]
    return slice(int(low[-1]), tip + 1)


def _missing(gear: CylindricalGear, path: ComplexArray) -> tuple[FloatArray, FloatArray]:
    """Length of roll and missing material of points of a left (or mirrored right) flank [m]."""
    r_b = abs(gear.r_b)
    xi = np.sqrt(np.maximum((np.abs(path) / r_b) ** 2 - 1.0, 0.0))
    nominal = gear.sign * (gear.psi_b - (xi - np.arctan(xi)))
    return r_b * xi, r_b * (nominal - np.angle(path))


def _check_flank(gear: CylindricalGear, path: ComplexArray, index: IntArray, part: str) -> None:
    """A left (or mirrored right) side rises steadily over the usable flank and keeps near the involute."""
    part_of = _flank_part(gear, path)
    path, index = path[part_of], index[part_of]
    back = np.nonzero(np.diff(gear.sign * np.abs(path)) <= 0.0)[0]
    if back.size:
        raise OutlineError(
            part,
            int(index[back[0] + 1]),
            "turns back towards the root on the flank",
            remedy="put the points in order from root to tip",
        )
    if path.size < _LEAST_FLANK:
        raise OutlineError(
            part,
            int(index[0]) if index.size else None,
            "points lie on the usable flank",
            value=f"{path.size}",
            limit=f"at least {_LEAST_FLANK}",
            remedy="give more points; check the unit, normal_module and number_of_teeth",
        )
    length, missing = _missing(gear, path)
    root, tip = flank_range(gear)
    inside = (length >= min(root, tip)) & (length <= max(root, tip))
    worst = int(np.argmax(np.where(inside, np.abs(missing), 0.0)))
    limit = OFF_INVOLUTE * gear.m_n
    if inside[worst] and abs(missing[worst]) > limit:
        raise OutlineError(
            part,
            int(index[worst]),
            "lies off the nominal involute: this is the flank of another gear",
            value=f"{1e3 * abs(missing[worst]):.4g} mm",
            limit=f"{1e3 * limit:.4g} mm, {OFF_INVOLUTE:g} m_n",
            remedy="check the unit, the tooth data, its thickness and the angle of the tooth",
        )
    shares = (length[0] - root) / (tip - root), (tip - length[-1]) / (tip - root)
    for end, share, diameter in ((0, shares[0], gear.d_Ff), (-1, shares[1], gear.d_Fa)):
        if share > UNCOVERED:
            raise OutlineError(
                part,
                int(index[end]),
                f"ends before the {'root' if end == 0 else 'tip'} form diameter {1e3 * abs(diameter):.6g} mm",
                value=f"{100.0 * share:.3g} % of the roll",
                limit=f"{100.0 * UNCOVERED:g} %",
                remedy="give more of the flank, or the tip and root diameters of this tooth",
            )


def _check_simple(gear: CylindricalGear, plane: ComplexArray, index: IntArray | None, part: str) -> None:
    """The outline crosses neither itself nor that of the next tooth."""
    turn = np.exp(2j * math.pi / abs(gear.z))
    chain = np.concatenate([plane, plane * turn, plane[:1] * turn * turn])
    a, b = chain[:-1], chain[1:]
    for first in range(0, plane.size, 64):
        p, q = (side[first : first + 64][: plane.size - first, None] for side in (a, b))
        apart = ((q - p).conj() * (a - p)).imag * ((q - p).conj() * (b - p)).imag < 0.0
        apart &= ((b - a).conj() * (p - a)).imag * ((b - a).conj() * (q - a)).imag < 0.0
        found = np.argwhere(apart)
        if found.size:
            at = first + int(found[0, 0])
            raise OutlineError(
                part,
                None if index is None else int(index[at]),
                "crosses itself or the next tooth",
                remedy="put the points in order along the outline",
            )
