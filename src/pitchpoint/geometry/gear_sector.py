# SPDX-License-Identifier: Apache-2.0
"""Triangulated surface of one pitch of a cylindrical gear; rotated copies form the whole gear.

Flank points are chosen by the chord error. Teeth may lack material on their flanks and may be broken off
below their tips.

Derivation: docs/theory/geometry.md, "Generation by the tool".
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.solid import blank_section, tooth_cell
from pitchpoint.geometry.tooth_form import even_profile

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
Gap = Callable[[str, float, FloatArray], FloatArray]
"""Gap of a flank along the base tangent [m] as a function of (flank, height z [m], roll lengths [m])."""

DENSE = 241
"""Flank points from which the outline is chosen; their own chord error is 0.25 µm for m_n = 40 mm."""
MAX_SLICES = 32
ROUND = 48
"""Minimum number of corners of a drawn bore; the number of teeth if that is larger."""


@dataclass(frozen=True)
class Sector:
    """Triangulated surface of one pitch.

    Parameters
    ----------
    points, triangles
        Shape (n, 3) [m]; shape (m, 3), counter-clockwise seen from outside.
    blank
        Index of the first triangle of the blank; the triangles before it are the tooth and its root.
    """

    points: FloatArray
    triangles: IntArray
    blank: int

    def part(self, first: int, last: int) -> tuple[FloatArray, IntArray]:
        """Points, shape (n, 3) [m], and triangles, shape (m, 3), of a range of triangles."""
        used, faces = np.unique(self.triangles[first:last], return_inverse=True)
        return self.points[used], faces.reshape(-1, 3)


def thinned(line: NDArray[np.complex128], error: float) -> IntArray:
    """Indices of the points of a simplified line whose chord error is at most `error`.

    The ends are always included.

    Parameters
    ----------
    line
        Points x + iy, shape (n,).
    error
        Maximum distance of an omitted point from its chord, in the unit of the points.

    Examples
    --------
    >>> circle = np.exp(1j * np.linspace(0.0, np.pi / 2, 91))
    >>> kept = thinned(circle, 0.01)
    >>> kept.tolist()[::8], bool(1.0 - np.cos(0.5 * np.radians(np.diff(kept).max())) < 0.01)
    ([0, 90], True)
    """
    kept, open_pieces = {0, line.size - 1}, [(0, line.size - 1)]
    while open_pieces:
        a, b = open_pieces.pop()
        if b - a < 2:
            continue
        chord = line[b] - line[a]
        size = abs(chord)
        inner = line[a + 1 : b] - line[a]
        off = np.abs((inner * np.conj(chord)).imag) / size if size > 0.0 else np.abs(inner)
        if off.max() > error:
            middle = a + 1 + int(np.argmax(off))
            kept.add(middle)
            open_pieces += [(a, middle), (middle, b)]
    return np.array(sorted(kept), np.int64)


@dataclass(frozen=True)
class Outline:
    """Points of one pitch, counter-clockwise from the middle of a root.

    Parameters
    ----------
    region
        0 root, 1 flank with its fillet, 3 tip; shape (n,).
    points
        x + iy [m], shape (n,); tooth 0 on the x axis.
    """

    region: NDArray[np.int8]
    points: NDArray[np.complex128]

    def flank(self, side: str) -> IntArray:
        """Indices of the points of a flank from root to tip, shape (n,); right is the clockwise flank."""
        found = np.flatnonzero(self.region == 1)
        tip = int(np.argmax(self.region == 3))
        return found[found < tip] if side == "right" else found[found > tip][::-1]


def pitch_outline(
    gear: CylindricalGear, error: float, resolution: int | None = None, elsewhere: float | None = None
) -> Outline:
    """Outline of one pitch with the fewest points that keep the chord error below a limit.

    Parameters
    ----------
    gear
        External or internal gear.
    error
        Maximum chord error of the flanks [m].
    resolution
        Number of points per flank, at least 5; replaces the limit of the chord error.
    elsewhere
        Maximum chord error of fillets, tips and roots, which are not in contact [m]; None: `error`.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=17, m_n=1e-3)
    >>> [pitch_outline(gear, error).points.size for error in (20e-6, 1e-6)]
    [22, 74]
    """
    profile = even_profile(gear, DENSE if resolution is None else resolution)
    plane = profile.points[:, 0] + 1j * profile.points[:, 1]
    region, n_cell = profile.region, plane.size
    plane = np.append(plane, plane[0] * np.exp(2j * math.pi / abs(gear.z)))
    start, tip = int(np.argmax(region != 0)), np.flatnonzero(region == 3)
    n = int(tip[0]) - start
    right = np.arange(start, start + n)
    left = start + 2 * n + tip.size - 1 - np.arange(n)
    land = np.arange(right[-1], left[-1] + 1)
    before, after = np.arange(start + 1), np.arange(left[0], n_cell + 1)
    if resolution is None:
        form = int(np.argmax(region[right] == 2)) or n // 2
        off = error if elsewhere is None else elsewhere
        fillet, flank = thinned(plane[right[: form + 1]], off), form + thinned(plane[right[form:]], error)
        chosen = np.unique(np.concatenate([fillet, flank, [(form + n) // 2]]))
        right, left = right[chosen], left[chosen]
        land, before, after = (line[thinned(plane[line], off)] for line in (land, before, after))
    land = land[1:-1] if land.size > 2 else tip[[tip.size // 2]]
    # with full rounding the last point is the first of the next pitch
    parts = (before[:-1], right, land, left[::-1][left[::-1] < n_cell], after[1:-1])
    found = np.repeat(np.array([0, 1, 3, 1, 0], np.int8), [part.size for part in parts])
    return Outline(found, plane[np.concatenate(parts)])


def slices_for(gear: CylindricalGear, error: float) -> FloatArray:
    """Heights z [m] of the sections of a tooth, from -b/2 to b/2, shape (n,).

    Parameters
    ----------
    gear
        The gear.
    error
        Maximum chord error of the tip helix [m].

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> slices_for(CylindricalGear(z=17, m_n=1e-3, b=0.01), 1e-6).tolist()
    [-0.005, 0.005]
    """
    twist = abs(2.0 * math.tan(gear.beta) / gear.d * gear.b)
    step = math.sqrt(8.0 * error / (0.5 * abs(gear.d_a)))
    count = max(1, math.ceil(twist / step))
    # an even number of slices includes the middle plane
    count = min(MAX_SLICES, count + count % 2) if count > 1 else 1
    return np.linspace(-0.5, 0.5, count + 1) * gear.b


def gear_sector(
    gear: CylindricalGear,
    outline: Outline,
    sections: Sequence[tuple[float, float | None]],
    *,
    gap: Gap | None = None,
    bore_diameter: float = 0.0,
    rim_thickness: float | None = None,
    web_thickness: float | None = None,
) -> Sector:
    """Surface of the pitch of tooth 0; z copies rotated by 2 pi k/z about the axis form the closed gear.

    Parameters
    ----------
    gear
        External or internal gear; middle plane z = 0.
    outline
        Points of the pitch.
    sections
        Heights from -b/2 to b/2 [m], each with the radius at which the tooth ends [m], None for a complete
        tooth. Two sections at one height form a step.
    gap
        Missing material of the flanks.
    bore_diameter, rim_thickness, web_thickness
        Size of the blank, as in `pitchpoint.geometry.mass_properties.gear_mass_properties` [m].

    Raises
    ------
    GeometryError
        If the tooth or the blank is not possible.
    """
    made = Pieces()
    rate = 2.0 * math.tan(gear.beta) / abs(gear.d)
    next_pitch = np.exp(2j * math.pi / abs(gear.z))
    rings = []
    for z, limit in sections:
        plane = outline.points if gap is None else _thinner(gear, outline, z, gap)
        plane = plane if limit is None else _ended(outline, plane, limit, gear.is_internal)
        rings.append(made.add(np.append(plane, plane[0] * next_pitch), z, rate * z))
    for low, high in zip(rings, rings[1:], strict=False):
        made.quads(low, high)
    strips, root = tooth_cell(outline.region, 0, gear.is_internal)
    root = np.append(root, outline.region.size)
    made.faces += [rings[-1][strips], rings[0][strips][:, ::-1]]
    pieces = len(made.faces)

    upper, is_open = blank_section(gear, 0.5 * bore_diameter, rim_thickness, web_thickness)
    angle = np.angle(np.append(outline.points, outline.points[0] * next_pitch)[root[:-1]])
    angle = np.append(angle, angle[0] + 2.0 * math.pi / abs(gear.z))
    around = np.linspace(angle[0], angle[-1], max(1, math.ceil(ROUND / abs(gear.z))) + 1)
    twist, end = rate * 0.5 * gear.b, 0.5 * gear.b
    top, bottom, at = rings[-1][root], rings[0][root], angle
    for radius, end in upper:
        inner = np.asarray(radius * np.exp(1j * around), np.complex128)
        new_top, new_bottom = made.add(inner, end, twist), made.add(inner, -end, -twist)
        made.zip(top, at, new_top, around)
        made.zip(new_bottom, around, bottom, at)
        top, bottom, at = new_top, new_bottom, around
    if is_open:
        levels = np.linspace(1.0, -1.0, max(1, math.ceil(abs(2.0 * twist) / math.radians(5.0))) + 1)[1:-1]
        inner = np.asarray(upper[-1][0] * np.exp(1j * around), np.complex128)
        walls = [top, *(made.add(inner, end * s, twist * s) for s in levels), bottom]
        for high, low in zip(walls, walls[1:], strict=False):
            made.quads(high, low)
    else:
        for ring, height in ((top, end), (bottom[::-1], -end)):
            centre = made.add(np.zeros(1, complex), height, 0.0)
            made.faces.append(np.stack([ring[:-1], ring[1:], np.full(ring.size - 1, centre[0])], axis=1))
    return made.sector(pieces, gear.is_internal)


class Pieces:
    """Builder of a triangulated surface from points and faces."""

    def __init__(self) -> None:
        self.points: list[FloatArray] = []
        self.faces: list[IntArray] = []
        self.count = 0

    def add(self, plane: NDArray[np.complex128], z: float, turn: float) -> IntArray:
        """Add points x + iy, shape (n,), at height z, rotated by `turn` about the axis; their indices."""
        turned = plane * np.exp(1j * turn)
        return self.put(np.column_stack([turned.real, turned.imag, np.full(plane.size, z)]))

    def put(self, points: FloatArray) -> IntArray:
        """Add points, shape (n, 3) [m]; their indices."""
        self.points.append(points)
        self.count += len(points)
        return np.arange(self.count - len(points), self.count)

    def quads(self, first: IntArray, second: IntArray) -> None:
        """Add triangles between two lines with equal numbers of points; indices, shapes (n,)."""
        a, b, c, d = first[:-1], first[1:], second[1:], second[:-1]
        self.faces += [np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]

    def zip(self, first: IntArray, at: FloatArray, second: IntArray, other: FloatArray) -> None:
        """Add triangles between two parallel lines of points, shapes (n,) and (m,), by their coordinates."""
        i = j = 0
        found = []
        while i < first.size - 1 or j < second.size - 1:
            # advance on the line whose next segment has the smaller midpoint
            mine = 0.5 * (at[i] + at[i + 1]) if i < first.size - 1 else math.inf
            theirs = 0.5 * (other[j] + other[j + 1]) if j < second.size - 1 else math.inf
            if mine <= theirs:
                found.append((first[i], first[i + 1], second[j]))
                i += 1
            else:
                found.append((first[i], second[j + 1], second[j]))
                j += 1
        self.faces.append(np.array(found, np.int64))

    def sector(self, blank: int, flipped: bool) -> Sector:
        """Sector without degenerate triangles; `blank` is the index of the first face list of the blank."""
        points, faces = np.concatenate(self.points), np.concatenate(self.faces)
        a, b, c = (points[faces[:, k]] for k in range(3))
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        kept = area > 1e-12 * area.max()
        first = int(kept[: sum(len(face) for face in self.faces[:blank])].sum())
        used, faces = np.unique(faces[kept], return_inverse=True)
        faces = faces.reshape(-1, 3)
        return Sector(points[used], faces[:, ::-1] if flipped else faces, first)


def _thinner(gear: CylindricalGear, outline: Outline, z: float, gap: Gap) -> NDArray[np.complex128]:
    """Points of a section with a gap on its flanks: involutes rotated by the gap over r_b."""
    r_b, plane = 0.5 * abs(gear.d_b), outline.points.copy()
    form = 0.5 * abs(gear.d_Ff)
    for side, towards in (("right", 1.0), ("left", -1.0)):
        ids = outline.flank(side)
        r = np.abs(plane[ids])
        lacks = gap(side, z, np.sqrt(np.maximum(r**2 - r_b**2, 0.0)))
        # in the fillet the gap decreases linearly to zero at the root
        foot = r[0]
        share = np.clip((r - foot) / (form - foot), 0.0, 1.0) if form != foot else np.ones(r.size)
        half = np.abs(np.angle(plane[ids]))
        turn = np.minimum(lacks * share / r_b, half)
        plane[ids] *= np.exp(1j * towards * turn)
    return plane


def _ended(
    outline: Outline, plane: NDArray[np.complex128], limit: float, is_internal: bool
) -> NDArray[np.complex128]:
    """Points of a section whose tooth is cut off at a radius; points beyond it are moved to the cut."""
    out = -1.0 if is_internal else 1.0
    ends = []
    for side in ("right", "left"):
        ids = outline.flank(side)
        height = out * np.abs(plane[ids])
        share = np.interp(out * limit, height, np.arange(ids.size))
        ends.append((share, np.interp(share, np.arange(ids.size), plane[ids])))
    (low, first), (high, last) = ends
    right, left = outline.flank("right"), outline.flank("left")
    a, b = int(right[0]) + math.ceil(low), int(left[0]) - math.ceil(high)
    found = plane.copy()
    if b > a:
        found[a : b + 1] = first + (last - first) * np.linspace(0.0, 1.0, b - a + 1)
    return found
