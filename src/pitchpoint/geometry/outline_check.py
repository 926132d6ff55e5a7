# SPDX-License-Identifier: Apache-2.0
"""Checks of the points of a real tooth: one closed, simple pitch close to the nominal tooth of the gear.

Points are complex numbers x + iy [m] with the tooth on the +x axis. `index` and `part` identify the points of
the input in messages. A failed check raises an `OutlineError`.

Derivation: docs/theory/geometry.md, "Generation by the tool".
"""

from __future__ import annotations

import math
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
"""Maximum distance of a flank or tip from the nominal one in normal modules; beyond it is another gear."""
OFF_ROOT = 0.5
"""The same for the root circle, which varies more with the tool."""
UNCOVERED = 0.1
"""Share of the usable flank that points may omit at either end; the last deviation is extrapolated."""
MAX_POINTS = 2000
MIN_TOOTH, MIN_FLANK = 10, 5
# Distance from the tip in normal modules, and slope of deviation over roll length, that identify tip points.
_EDGE, _STEEP = 0.02, 5.0
# Share of a pitch by which the points of a tooth may extend into the next pitch.
_OVERLAP = 0.02


class OutlineError(GeometryError):
    """Error in the points of a tooth; `point` is the index of the point in the input `part`, from 0."""

    def __init__(self, part: str, point: int | None, message: str, **more: str | None) -> None:
        super().__init__(message, where=part if point is None else f"{part}[{point}]", **more)
        self.part, self.point = part, point


def plane_points(points: ArrayLike, part: str, least: int) -> tuple[ComplexArray, IntArray]:
    """Points as complex numbers without repetitions, and their indices in the input, shape (m,) each.

    Parameters
    ----------
    points
        Shape (n, 2) [m].
    part
        Name of the input.
    least
        Minimum number of points.

    Raises
    ------
    OutlineError
        If the points are not pairs of finite numbers, or their number is out of range.
    """
    xy = np.asarray(points, dtype=float)
    if xy.ndim != 2 or xy.shape[1] != 2:
        raise OutlineError(
            part,
            None,
            "are not points",
            value=f"shape {xy.shape}",
            limit="shape (n, 2)",
            remedy="give [x, y] pairs",
        )
    bad = np.nonzero(~np.isfinite(xy).all(axis=1))[0]
    if bad.size:
        raise OutlineError(part, int(bad[0]), "is not finite", value=f"{xy[bad[0]]}", remedy="correct it")
    plane = xy[:, 0] + 1j * xy[:, 1]
    index = np.arange(plane.size)
    if plane.size:
        new = np.append(True, np.abs(np.diff(plane)) > 1e-12 * np.abs(plane).max())
        plane, index = plane[new], index[new]
    if not least <= plane.size <= MAX_POINTS:
        raise OutlineError(
            part,
            None,
            "points are too few" if plane.size < least else "points are too many",
            value=f"{plane.size}",
            limit=f"{least} to {MAX_POINTS}",
            remedy="give more points" if plane.size < least else "omit points",
        )
    return plane, index


def one_pitch(
    gear: CylindricalGear, plane: ComplexArray, index: IntArray, part: str
) -> tuple[ComplexArray, IntArray]:
    """Points of exactly one pitch around the +x axis, without the closing point.

    Parameters
    ----------
    gear
        External or internal gear, whose generated tooth is the nominal one.
    plane
        Points of the tooth, counter-clockwise, shape (n,) [m].
    index
        Numbers of the points in the input, shape (n,).
    part
        Name of the input.

    Raises
    ------
    OutlineError
        If the points do not describe one pitch around the +x axis, or are not closed.
    """
    pitch = 2.0 * math.pi / abs(gear.z)
    angle = np.angle(plane)
    if not angle[0] < 0.0 < angle[-1]:
        raise OutlineError(
            part,
            int(index[0]),
            "begins and ends on the same side of the x axis",
            value=f"{math.degrees(angle[0]):.4g} deg",
            remedy="give one tooth from root to root that is on the +x axis, or its angle",
        )
    span = float(angle[-1] - angle[0])
    if span <= (1.0 + _OVERLAP) * pitch:
        # drop the closing point, or a small part of the next root
        own = int(np.nonzero(angle - angle[0] < (1.0 - 1e-6) * pitch)[0][-1]) + 1
        plane, index, span = plane[:own], index[:own], float(angle[own - 1] - angle[0])
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
            "is not closed: the radii at its start and end differ",
            value=f"{1e3 * step:.4g} mm",
            limit=f"{1e3 * OFF_INVOLUTE * gear.m_n:.4g} mm, {OFF_INVOLUTE:g} m_n",
            remedy="give the points from root to root",
        )
    return plane, index


def sides(plane: ComplexArray) -> tuple[IntArray, IntArray]:
    """Indices of the points of the right and the left side, root to tip; shapes add up to (n,)."""
    split = int(np.argmax(np.angle(plane) >= 0.0))
    return np.arange(split), np.arange(plane.size - 1, split - 1, -1)


def check_height(gear: CylindricalGear, plane: ComplexArray, index: IntArray, part: str) -> None:
    """Check that the tip and root circles agree with those of the gear.

    Parameters
    ----------
    gear
        External or internal gear, whose generated tooth is the nominal one.
    plane
        Points of the tooth, shape (n,) [m].
    index
        Numbers of the points in the input, shape (n,).
    part
        Name of the input.

    Raises
    ------
    OutlineError
        If the tip or root circle is not that of the gear.
    """
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
                limit=f"{2e3 * abs(nominal):.6g} mm and {2e3 * share * gear.m_n:.4g} mm next to it",
                remedy=f"check the unit, normal_module, number_of_teeth and {what}_diameter",
            )


def flank_part(gear: CylindricalGear, path: ComplexArray) -> slice:
    """Slice of the points of a side, root to tip, on the usable flank, with one point on or beyond each end.

    Parameters
    ----------
    gear
        External or internal gear, whose generated tooth is the nominal one.
    path
        Points of a left side, or of a right one mirrored, shape (n,) [m].
    """
    height = gear.sign * np.abs(path)
    slack = 1e-6 * gear.m_n
    tip = int(np.argmax(height >= min(0.5 * gear.d_Fa, float(height.max())) - slack))
    # the first point of the tip land is not a flank point if the edge before it is sharp and slightly below
    # the tip
    near = height >= min(0.5 * gear.d_Fa, float(height.max())) - _EDGE * gear.m_n
    length, missing = missing_material(gear, path)
    while (
        tip > 0
        and near[tip - 1]
        and _STEEP * abs(length[tip] - length[tip - 1]) < abs(missing[tip] - missing[tip - 1])
    ):
        tip -= 1
    low = np.nonzero(height[: tip + 1] <= max(0.5 * gear.d_Ff, float(height[: tip + 1].min())) + slack)[0]
    return slice(int(low[-1]), tip + 1)


def missing_material(gear: CylindricalGear, path: ComplexArray) -> tuple[FloatArray, FloatArray]:
    """Roll length and missing material at points of a left (or mirrored right) flank [m].

    Parameters
    ----------
    gear
        External or internal gear, whose generated tooth is the nominal one.
    path
        Points of a left flank, or of a right one mirrored, shape (n,) [m].

    Notes
    -----
    r_b (ψ(r) − ψ) along the transverse base tangent, see `ToothOutline.gap`.
    """
    r_b = abs(gear.r_b)
    xi = np.sqrt(np.maximum((np.abs(path) / r_b) ** 2 - 1.0, 0.0))
    nominal = gear.sign * (gear.psi_b - (xi - np.arctan(xi)))
    return r_b * xi, r_b * (nominal - np.angle(path))


def check_flank(gear: CylindricalGear, path: ComplexArray, index: IntArray, part: str) -> None:
    """Check that a left (or mirrored right) flank is monotonic in radius and close to the involute.

    Parameters
    ----------
    gear
        External or internal gear, whose generated tooth is the nominal one.
    path
        Points of the side, root to tip, shape (n,) [m].
    index
        Numbers of the points in the input, shape (n,).
    part
        Name of the input.

    Raises
    ------
    OutlineError
        If the radius is not monotonic, or the points are too few, off the involute of the gear, or cover too
        little of it.
    """
    part_of = flank_part(gear, path)
    path, index = path[part_of], index[part_of]
    step = np.diff(gear.sign * np.abs(path))
    back = np.nonzero(step <= 0.0)[0]
    if back.size:
        raise OutlineError(
            part,
            int(index[back[0] + 1]),
            "is the change of height to this point: the flank reverses towards the root",
            value=f"{1e3 * step[back[0]]:.4g} mm",
            limit="> 0 mm from root to tip",
            remedy="put the points in order from root to tip, or omit those that scatter",
        )
    if path.size < MIN_FLANK:
        raise OutlineError(
            part,
            int(index[0]) if index.size else None,
            "points lie on the usable flank",
            value=f"{path.size}",
            limit=f"at least {MIN_FLANK}",
            remedy="give more points; check the unit, normal_module and number_of_teeth",
        )
    length, missing = missing_material(gear, path)
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
