# SPDX-License-Identifier: Apache-2.0
"""Exact tooth of a gear, and points of its profile and outline for drawings and exports.

Frame: z axis = gear axis, tooth 0 on the +x axis, counter-clockwise positive. Lengths are positive, also for
internal gears; their outline is the boundary of the hole.

Source: ISO 21771. Derivation: docs/theory/geometry.md, "Generation by the tool".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.tip_edge import tip_edge
from pitchpoint.geometry.tooth_generation import ToothForm as ToothForm
from pitchpoint.geometry.tooth_generation import external_tooth_form, internal_tooth_form

if TYPE_CHECKING:
    from pitchpoint.geometry.cutter import CutterTeeth
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FloatArray = NDArray[np.float64]

REGIONS = ("root", "fillet", "involute", "tip")

# Distance from the highest and lowest point of an outline within which points are tip and root, in modules.
_LAND = 0.005


@dataclass(frozen=True)
class ToothProfile:
    """Points of one pitch of a gear, from the middle of a root to the middle of the next.

    Parameters
    ----------
    points
        Shape (n, 2) [m], transverse plane; tooth 0 on the +x axis, counter-clockwise.
    region
        Shape (n,): index into `REGIONS` of each point.
    diameters
        Region name → (diameter at its root end, at its tip end) [m], positive.
    is_undercut
        True if fillet and involute meet in a corner.
    """

    points: FloatArray
    region: NDArray[np.int8]
    diameters: dict[str, tuple[float, float]]
    is_undercut: bool


@lru_cache(maxsize=256)
def tooth_form(gear: CylindricalGear) -> ToothForm:
    """Exact tooth of a gear, from its thickness, its manufactured root diameter and its tool.

    Parameters
    ----------
    gear
        External or internal gear.

    Raises
    ------
    GeometryError
        If the tooth is not possible (see `pitchpoint.geometry.tooth_generation`).

    Notes
    -----
    The root diameter is `d_fE`, with the tool position that includes the thickness allowance. An internal
    gear without a cutter has a circular fillet with the root radius of the rack.
    """
    return _generated(gear, gear.cutter, z=abs(gear.z), beta=gear.beta, edge=tip_edge(gear))


@lru_cache(maxsize=256)
def virtual_tooth_form(gear: CylindricalGear) -> ToothForm:
    """Tooth of the virtual spur gear in the normal section, with sharp tip edges.

    Parameters
    ----------
    gear
        External or internal gear.

    Raises
    ------
    GeometryError
        As for `tooth_form`.

    Notes
    -----
    z_n = z/(cos² β_b cos β) teeth on the reference diameter d_n = d/cos² β_b, with the thickness and tool of
    the normal section and d_an − d_n = d_a − d, likewise at the root (ISO 6336-3:2006, 6.2). A pinion-type
    cutter has z_0/(cos² β_b cos β) teeth.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> form = virtual_tooth_form(CylindricalGear(z=24, m_n=14e-3, beta=math.radians(10.0)))
    >>> round(form.z, 3)                                                 # KISSsoft prints 25.037
    25.037
    """
    ratio = gear.z_n / gear.z
    cutter = None if gear.cutter is None else gear.cutter.virtual(ratio)
    wider = 0.5 * abs(gear.d) * math.tan(gear.beta_b) ** 2
    return _generated(gear, cutter, z=abs(gear.z_n), beta=0.0, wider=wider)


def _generated(
    gear: CylindricalGear, cutter: CutterTeeth | None, *, wider: float = 0.0, **others: Any
) -> ToothForm:
    """Tooth of a gear with root and tip on circles that are larger by `wider` [m]."""
    given: dict[str, Any] = {
        "m_n": gear.m_n,
        "alpha_n": gear.alpha_n,
        "s_n": gear.s_n,
        "r_f": 0.5 * gear.sign * gear.d_fE + wider,
        "r_a": 0.5 * gear.sign * gear.d_a + wider,
        "rho": gear.rack.rho_fP_star * gear.m_n,
        **others,
    }
    return internal_tooth_form(**given, cutter=cutter) if gear.is_internal else external_tooth_form(**given)


def root_radius(gear: CylindricalGear) -> float:
    """Root radius [m], positive: of the outline of the gear if it has one, else as generated."""
    return tooth_form(gear).r_f if gear.outline is None else gear.outline.root_radius(gear)


def tooth_profile(gear: CylindricalGear, n_flank: int = 40) -> ToothProfile:
    """Points of one pitch of a gear.

    Parameters
    ----------
    gear
        External or internal gear. The points of its `outline`, if it has one, are used unchanged.
    n_flank
        Points per flank (fillet and involute) of a generated tooth, at least 5; the arcs have a fifth of it,
        at least two. Chamfers and roundings of tip edges have points of their own, part of the tip.

    Returns
    -------
    ToothProfile
        From the middle of the root on the clockwise side, over the tooth, to just before the middle of the
        next root.

    Raises
    ------
    GeometryError
        If the tooth is not possible, or `n_flank` is too small.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> profile = tooth_profile(CylindricalGear(z=17, m_n=1e-3), 20)
    >>> profile.points.shape, REGIONS[profile.region[0]]
    ((51, 2), 'root')
    """
    if gear.outline is not None:
        return _given_profile(gear, gear.outline.plane)
    form = tooth_form(gear)
    r, half, n_fillet = form.flank(n_flank)
    n_arc = max(2, n_flank // 5)
    flank_region = np.where(np.arange(n_flank) < n_fillet, 1, 2)
    r_edge, half_edge = (np.empty(0), np.empty(0)) if form.edge is None else form.edge.drawn(n_flank)
    land = half[-1] if form.edge is None else form.tip_half_angle
    tip = np.concatenate([-half_edge, np.linspace(-land, land, n_arc + 2)[1:-1], half_edge[::-1]])
    n_tip = tip.size
    # A fully rounded root has no arc; its deepest point is part of the fillet.
    has_arc = form.half_pitch_angle - half[0] > 1e-9 * form.half_pitch_angle
    arc = np.linspace(form.half_pitch_angle, half[0], n_arc + 1)[:-1] if has_arc else np.empty(0)
    angle = np.concatenate([-arc, -half, tip, half[::-1], arc[:0:-1]])
    radius = np.concatenate(
        [
            np.full(arc.size, form.r_f),
            r,
            r_edge,
            np.full(n_arc, form.r_a),
            r_edge[::-1],
            r[::-1],
            np.full(arc[:0:-1].size, form.r_f),
        ]
    )
    region = np.concatenate(
        [np.zeros(arc.size), flank_region, np.full(n_tip, 3), flank_region[::-1], np.zeros(arc[:0:-1].size)]
    ).astype(np.int8)
    if not has_arc:
        angle, radius, region = angle[:-1], radius[:-1], region[:-1]
    d_f, d_Ff, d_Fa, d_a = 2.0 * form.r_f, 2.0 * form.r_Ff, 2.0 * form.r_Fa, 2.0 * form.r_a
    edge = d_a if form.edge is None else d_Fa
    diameters = {"root": (d_f, d_f), "fillet": (d_f, d_Ff), "involute": (d_Ff, d_Fa), "tip": (edge, d_a)}
    points = radius[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    return ToothProfile(points, region, diameters, form.is_undercut)


def _given_profile(gear: CylindricalGear, plane: NDArray[np.complex128]) -> ToothProfile:
    """Profile from the points of an outline, with regions assigned by height."""
    height = gear.sign * np.abs(plane)
    land = _LAND * gear.m_n
    region = np.full(plane.size, 2, dtype=np.int8)
    region[height < 0.5 * gear.d_Ff - 1e-6 * gear.m_n] = 1
    region[height <= height.min() + land] = 0
    region[height >= height.max() - land] = 3
    d_f, d_a = 2.0 * abs(float(height.min())), 2.0 * abs(float(height.max()))
    d_Ff, d_Fa = abs(gear.d_Ff), abs(gear.d_Fa)
    diameters = {"root": (d_f, d_f), "fillet": (d_f, d_Ff), "involute": (d_Ff, d_Fa), "tip": (d_a, d_a)}
    return ToothProfile(np.column_stack([plane.real, plane.imag]), region, diameters, gear.undercut)


def even_profile(gear: CylindricalGear, n_flank: int = 40) -> ToothProfile:
    """Profile with equal numbers of points on the left and right flanks, as required by triangulation.

    Parameters
    ----------
    gear
        External or internal gear. Its `outline`, if it has one, is resampled at equal arc lengths.
    n_flank
        Points per flank, at least 5.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> even_profile(CylindricalGear(z=17, m_n=1e-3), 20).points.shape
    (51, 2)
    """
    if gear.outline is None:
        return tooth_profile(gear, n_flank)
    profile = _given_profile(gear, gear.outline.plane)
    plane = np.append(gear.outline.plane, gear.outline.plane[0] * np.exp(2j * math.pi / abs(gear.z)))
    region = np.append(profile.region, profile.region[0])
    tip = np.nonzero(region == 3)[0]
    root = np.nonzero(region == 0)[0]
    right, left = root[root < tip[0]], root[root > tip[-1]]
    feet = (int(right[-1]) if right.size else 0, int(left[0]) if left.size else plane.size - 1)
    n_arc = max(2, n_flank // 5)
    has_arc = feet[0] > 0 and feet[1] < plane.size - 1
    if not has_arc:
        feet = (0, plane.size - 1)
    pieces = [
        _divided(plane[feet[0] : tip[0] + 1], n_flank),
        _divided(plane[tip[0] : tip[-1] + 1], n_arc + 2)[1:-1],
        _divided(plane[tip[-1] : feet[1] + 1], n_flank),
    ]
    regions = [1, 3, 1]
    if has_arc:
        pieces = [_divided(plane[: feet[0] + 1], n_arc + 1)[:-1], *pieces]
        pieces.append(_divided(plane[feet[1] :], n_arc + 1)[1:-1])
        regions = [0, *regions, 0]
    else:
        pieces[-1] = pieces[-1][:-1]
    points = np.concatenate(pieces)
    kinds = np.repeat(np.array(regions, dtype=np.int8), [p.size for p in pieces])
    return ToothProfile(
        np.column_stack([points.real, points.imag]), kinds, profile.diameters, profile.is_undercut
    )


def _divided(line: NDArray[np.complex128], n: int) -> NDArray[np.complex128]:
    """Resample a polyline at equal arc lengths, ends included."""
    length = np.append(0.0, np.cumsum(np.abs(np.diff(line))))
    at = np.linspace(0.0, length[-1], n)
    return np.asarray(np.interp(at, length, line.real) + 1j * np.interp(at, length, line.imag))


def gear_outline(gear: CylindricalGear, n_flank: int = 40, *, rotation: float = 0.0) -> FloatArray:
    """Closed outline of the whole gear in the transverse plane.

    Parameters
    ----------
    gear
        External or internal gear.
    n_flank
        Points per flank, at least 5.
    rotation
        Counter-clockwise rotation of the gear from "tooth 0 on the +x axis" [rad].

    Returns
    -------
    ndarray, shape (n, 2)
        Counter-clockwise polygon [m], last point equal to the first. For an internal gear it bounds the hole.

    Raises
    ------
    GeometryError
        If the tooth is not possible, or `n_flank` is too small.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> outline = gear_outline(CylindricalGear(z=17, m_n=1e-3), 20)
    >>> outline.shape, bool((outline[0] == outline[-1]).all())
    ((868, 2), True)
    """
    ring = around(tooth_profile(gear, n_flank), abs(gear.z), rotation)
    return np.column_stack([np.append(ring.real, ring.real[0]), np.append(ring.imag, ring.imag[0])])


def around(profile: ToothProfile, z: int, rotation: float = 0.0) -> NDArray[np.complex128]:
    """Points x + iy of all `z` teeth of one profile [m], shape (z n,).

    Parameters
    ----------
    profile
        Profile of one pitch.
    z
        Number of teeth, positive.
    rotation
        Counter-clockwise rotation of tooth 0 [rad].
    """
    teeth = rotation + 2.0 * math.pi / z * np.arange(z)
    points = profile.points
    turned = (points[:, 0] + 1j * points[:, 1])[None, :] * np.exp(1j * teeth)[:, None]
    return np.asarray(turned.ravel())
