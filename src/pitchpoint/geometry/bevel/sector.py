# SPDX-License-Identifier: Apache-2.0
"""Triangulated surface of one pitch of a bevel gear, and closed triangulated solid of the whole gear.

Flank points are chosen by the chord error at the outer end, where the tooth is largest. Gear frame: apex at
the origin, z axis into the gear, tooth 0 on the x axis.

Derivation: docs/theory/bevel_gears.md, "Solid and mass".
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.bevel.blank import BevelBlank, bevel_blank
from pitchpoint.geometry.bevel.tooth import at_cone, bevel_tooth, placed
from pitchpoint.geometry.gear_sector import DENSE, MAX_SLICES, ROUND, Pieces, Sector, thinned
from pitchpoint.geometry.triangle_file import join_corners

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel.gear import BevelGear

FloatArray = NDArray[np.float64]
_FINE_SLICES = 400
"""Maximum number of slices of a solid."""
_TURN = math.radians(5.0)
"""Maximum twist between two levels of the bore wall."""


@dataclass(frozen=True)
class BevelOutline:
    """Points of one pitch, counter-clockwise from the middle of a root.

    Parameters
    ----------
    region
        0 root, 1 flank with its fillet, 3 tip; shape (n,).
    polar, azimuth
        Angles of the points at mid-face [rad], shape (n,); tooth 0 at azimuth 0.
    """

    region: NDArray[np.int8]
    polar: FloatArray
    azimuth: FloatArray


def bevel_outline(
    gear: BevelGear,
    error: float,
    resolution: int | None = None,
    elsewhere: float | None = None,
    ends: float | None = None,
) -> BevelOutline:
    """Outline of one pitch with the fewest points that keep the chord error below a limit.

    Parameters
    ----------
    gear
        The gear.
    error
        Maximum chord error of the flanks at the outer end [m].
    resolution
        Number of points per flank, at least 5; replaces the limit of the chord error.
    elsewhere
        Maximum chord error of fillets, tips and roots, which are not in contact [m]; None: `error`.
    ends
        Maximum chord error of the round end faces of the teeth [m]; None: as the tip.

    Notes
    -----
    The chord error is measured on the back cone developed into a plane, which preserves lengths.

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> gear = BevelGear(z=20, m_mn=2.5e-3, delta=math.atan(0.5), b=0.02)
    >>> [bevel_outline(gear, error).polar.size for error in (20e-6, 1e-6)]
    [32, 131]
    """
    tooth, off = bevel_tooth(gear), error if elsewhere is None else elsewhere
    if resolution is None:
        polar, half = tooth.flank(DENSE, DENSE // 2)
        unrolled = gear.R_e * (math.tan(gear.delta) + np.tan(polar - gear.delta))
        flat = unrolled * np.exp(-1j * half * math.cos(gear.delta))
        n = DENSE // 2
        kept = np.concatenate([thinned(flat[: n + 1], off), n + thinned(flat[n:], error)])
        kept = np.unique(np.append(kept, n + DENSE // 2))
    else:
        fillet = max(2, resolution // 3)
        polar, half = tooth.flank(max(3, resolution - fillet), fillet)
        kept = np.arange(polar.size)
    polar, half = polar[kept], half[kept]

    def arc(low: float, high: float, cone: float) -> FloatArray:
        """Azimuths from `low` to `high` whose chords are within the limit of a cone."""
        radius = gear.R_e * math.sin(cone)
        step = 2.0 * math.acos(max(-1.0, 1.0 - off / radius))
        return np.linspace(low, high, max(1, math.ceil((high - low) / step)) + 1)

    end = math.pi / gear.z
    # with full rounding the first point is the last point of the previous pitch
    root = arc(-end, -half[0], gear.delta_f)[:-1] if half[0] < end - 1e-12 else np.zeros(0)
    across = arc(-half[-1], half[-1], gear.delta_a).size
    if ends is not None:
        step = 2.0 * math.acos(1.0 - ends / (gear.R_e * math.sin(gear.delta_a)))
        across = math.ceil(2.0 * float(half.max()) / step) + 1
    land = np.linspace(-half[-1], half[-1], max(3, across))[1:-1]
    last = -root[:0:-1]
    left = half[::-1] if root.size else half[:0:-1]
    parts = (root, -half, land, left, last)
    region = np.repeat(np.array([0, 1, 3, 1, 0], np.int8), [p.size for p in parts])
    cones = np.concatenate(
        [
            np.full(root.size, gear.delta_f),
            polar,
            np.full(land.size, gear.delta_a),
            polar[::-1][: left.size],
            np.full(last.size, gear.delta_f),
        ]
    )
    return BevelOutline(region, cones, np.concatenate(parts))


def bevel_slices(gear: BevelGear, error: float, most: int = MAX_SLICES) -> FloatArray:
    """Cone distances [m] of the slices of a tooth, from R_i to R_e, shape (n,).

    Parameters
    ----------
    gear
        The gear.
    error
        Maximum chord error of the spiral on the tip cone [m].
    most
        Maximum number of slices.

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> bevel_slices(BevelGear(z=20, m_mn=2.5e-3, delta=math.atan(0.5), b=0.02), 1e-6).size
    2
    """
    if gear.beta_m == 0.0:
        return np.array([gear.R_i, gear.R_e])
    count = 2
    while count < most:
        at = np.geomspace(gear.R_i, gear.R_e, 2 * count + 1)
        line = placed(gear, np.full(at.size, gear.delta_a), np.zeros(at.size), at)
        chord = line[2::2] - line[:-2:2]
        off = np.cross(line[1::2] - line[:-2:2], chord)
        if (np.linalg.norm(off, axis=1) / np.linalg.norm(chord, axis=1)).max() <= error:
            break
        count += 2
    return np.geomspace(gear.R_i, gear.R_e, count + 1)


def bevel_sector(
    gear: BevelGear,
    outline: BevelOutline,
    slices: FloatArray,
    *,
    bore_diameter: float = 0.0,
    rim_thickness: float | None = None,
    corners: int = ROUND,
    whole: tuple[float, float] | None = None,
) -> Sector:
    """Surface of the pitch of tooth 0; z copies rotated by 2πk/z about the axis form the closed gear.

    Parameters
    ----------
    gear
        The gear.
    outline
        Points of the pitch.
    slices
        Cone distances from R_i to R_e [m], shape (n,).
    bore_diameter, rim_thickness
        Size of the blank, as in `pitchpoint.geometry.bevel.blank.bevel_blank` [m].
    corners
        Minimum number of corners of the circles of the blank.
    whole
        Cone distances between which the tooth is complete [m]; outside it is broken off at its root.
        None: complete.

    Raises
    ------
    GeometryError
        If the tooth or the blank is not possible.
    """
    blank = bevel_blank(gear, bore_diameter, rim_thickness)
    made = Pieces()
    polar = np.append(outline.polar, outline.polar[0])
    azimuth = np.append(outline.azimuth, outline.azimuth[0] + 2.0 * math.pi / gear.z)
    root = np.full(polar.size, gear.delta_f)
    places = _places(slices, whole)
    cones = [polar if stands else root for _, stands in places]
    rings = [
        made.put(placed(gear, cone, azimuth, at_cone(gear, cone, R)))
        for (R, _), cone in zip(places, cones, strict=True)
    ]
    for low, high in zip(rings, rings[1:], strict=False):
        made.quads(low, high)
    ends = [_end(made, gear, replace(outline, polar=cones[k][:-1]), rings[k], places[k][0]) for k in (-1, 0)]
    at = ends[0][1]
    # the back cone continues from the teeth to the rim and is part of the toothed surface
    teeth = len(made.faces) + 1
    around = np.linspace(at[0], at[-1], max(1, math.ceil(corners / gear.z)) + 1)
    _close(made, gear, [line for line, _ in ends], (at, around), blank)
    return made.sector(teeth, False)


def _places(slices: FloatArray, whole: tuple[float, float] | None) -> list[tuple[float, bool]]:
    """Cone distances of the rings of a tooth, each with True if complete there; two rings per fracture."""
    low, high = whole or (slices[0], slices[-1])
    if low >= high:
        return [(float(R), False) for R in slices]
    found = [(float(R), False) for R in slices if R < low]
    found += [(low, False)] if found else []
    found += [(float(R), True) for R in np.unique([low, *slices[(slices > low) & (slices < high)], high])]
    beyond = [(float(R), False) for R in slices if R > high]
    return found + ([(high, False), *beyond] if beyond else [])


def _end(
    made: Pieces, gear: BevelGear, outline: BevelOutline, ring: NDArray[np.int64], R: float
) -> tuple[NDArray[np.int64], FloatArray]:
    """Add the end face of a tooth; point numbers of the root line across it, and their azimuths."""
    first = int(np.argmax(outline.region != 0))
    m, land = (int((outline.region == k).sum()) for k in (1, 3))
    m = (m + 1) // 2  # with full rounding the last point is the first of the next pitch
    last = first + 2 * m + land - 1
    share = np.linspace(-1.0, 1.0, land + 2)[1:-1]
    rows = []
    for j in range(m - 1):
        polar, half = outline.polar[first + j], abs(outline.azimuth[first + j])
        inner = made.put(placed(gear, polar, half * share, at_cone(gear, polar, R)))
        rows.append(np.concatenate([ring[[first + j]], inner, ring[[last - j]]]))
    rows.append(ring[first + m - 1 : last - m + 2])
    for low, high in zip(rows, rows[1:], strict=False):
        made.quads(*((high, low) if R > gear.R_m else (low, high)))
    half = abs(float(outline.azimuth[first]))
    azimuth = np.append(outline.azimuth, outline.azimuth[0] + 2.0 * math.pi / gear.z)
    at = np.concatenate([azimuth[: first + 1], half * share, azimuth[last:]])
    return np.concatenate([ring[:first], rows[0], ring[last + 1 :]]), at


def _close(
    made: Pieces,
    gear: BevelGear,
    ends: list[NDArray[np.int64]],
    azimuths: tuple[FloatArray, FloatArray],
    blank: BevelBlank,
) -> None:
    """Add the blank, from the root line at the heel around to the root line at the toe.

    `azimuths` holds those of both root lines and those of the circles, at mid-face.
    """
    at, around = azimuths
    turns = [
        gear.spiral_rate * math.log(R / (gear.R_m * math.cos(gear.theta_f))) for R in (gear.R_e, gear.R_i)
    ]
    heel, toe = ends
    radius, top, bottom = blank.bore, blank.back[1], blank.toe[1]

    def ring(r: float, z: float, turn: float) -> NDArray[np.int64]:
        """Add a circular arc of points about the axis; their numbers."""
        return made.add(np.asarray(r * np.exp(1j * around), np.complex128), z, turn)

    rear = ring(*blank.back, turns[0])
    made.zip(heel, at, rear, around)
    if radius == 0.0:
        for line, height in ((rear, top), (toe[::-1], bottom)):
            centre = made.add(np.zeros(1, complex), height, 0.0)
            made.faces.append(np.stack([line[:-1], line[1:], np.full(line.size - 1, centre[0])], axis=1))
        return
    upper, lower = ring(radius, top, turns[0]), ring(radius, bottom, turns[1])
    made.zip(rear, around, upper, around)
    made.zip(lower, around, toe, at)
    share = np.linspace(0.0, 1.0, max(1, math.ceil(abs(turns[0] - turns[1]) / _TURN)) + 1)[1:-1]
    walls = [upper]
    walls += [
        ring(radius, top + s * (bottom - top), turns[0] + s * (turns[1] - turns[0])) for s in share.tolist()
    ]
    walls.append(lower)
    for high, low in zip(walls, walls[1:], strict=False):
        made.quads(high, low)


def bevel_solid(
    gear: BevelGear,
    n_flank: int = 20,
    error: float | None = None,
    *,
    bore_diameter: float = 0.0,
    rim_thickness: float | None = None,
) -> FloatArray:
    """Closed triangulated surface of a bevel gear.

    Parameters
    ----------
    gear
        The gear.
    n_flank
        Points per flank, at least 5.
    error
        Maximum chord error along a spiral tooth [m]; that of arcs across is ten times as large. None: a
        thousandth of the module.
    bore_diameter, rim_thickness
        Size of the blank, as in `pitchpoint.geometry.bevel.blank.bevel_blank` [m].

    Returns
    -------
    ndarray, shape (n, 3, 3)
        Triangles, corners counter-clockwise seen from outside [m].

    Raises
    ------
    GeometryError
        If the tooth or the blank is not possible.

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> bevel_solid(BevelGear(z=20, m_mn=2.5e-3, delta=math.atan(0.5), b=0.02), 10).shape
    (4320, 3, 3)
    """
    fine = 1e-3 * gear.m_mn if error is None else error
    sector = bevel_sector(
        gear,
        bevel_outline(gear, 10.0 * fine, n_flank, ends=10.0 * fine),
        bevel_slices(gear, fine, _FINE_SLICES),
        bore_diameter=bore_diameter,
        rim_thickness=rim_thickness,
        corners=max(ROUND, math.ceil(math.pi / math.acos(1.0 - 10.0 * fine / gear.R_e))),
    )
    corners = sector.points[sector.triangles]
    turn = 2.0 * math.pi / gear.z * np.arange(gear.z)
    c, s, o, one = np.cos(turn), np.sin(turn), 0.0 * turn, 1.0 + 0.0 * turn
    turned = np.array([[c, -s, o], [s, c, o], [o, o, one]])
    whole = np.einsum("ijk,abj->kabi", turned, corners).reshape(-1, 3, 3)
    # merge coincident corners of adjacent pitches, so that the surface is closed in files too
    first, triangles = join_corners(whole)
    return np.asarray(whole.reshape(-1, 3)[first][triangles])
