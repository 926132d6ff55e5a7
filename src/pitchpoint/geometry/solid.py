# SPDX-License-Identifier: Apache-2.0
"""Closed triangulated solid of a cylindrical gear: exact section, twisted along the face width, with blank.

Derivation: docs/theory/geometry.md, "Generation by the tool".
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.mass_properties import RIM_OF_RING
from pitchpoint.geometry.tooth_form import around, even_profile, root_radius

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

_TWIST_STEP = math.radians(0.5)


def _quads(first: FloatArray, second: FloatArray) -> FloatArray:
    """Triangles between two closed rings of vertices, shape (2 n, 3, 3)."""
    a, b = first, np.roll(first, -1, axis=0)
    c, d = np.roll(second, -1, axis=0), second
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def _fan(ring: FloatArray, z: float) -> FloatArray:
    """Triangles from a closed ring to the axis at the height z, oriented along the ring."""
    centre = np.broadcast_to(np.array([0.0, 0.0, z]), ring.shape)
    return np.stack([ring, np.roll(ring, -1, axis=0), centre], axis=1)


def tooth_cell(region: NDArray[np.int8], n_foot: int, is_internal: bool) -> tuple[IntArray, IntArray]:
    """Triangulation of the tooth section of one even profile, and its root points, as point indices.

    Corresponding points of both flanks bound a strip, so undercut teeth need no special case.

    Parameters
    ----------
    region
        Regions of the points as in `pitchpoint.geometry.tooth_form.even_profile`, shape (n_point,).
    n_foot
        Points on the straight line between the feet of the tooth; their indices are -1, -2, ...
    is_internal
        Whether the gear is internal.

    Returns
    -------
    ndarray, shape (n, 3)
        Triangles, counter-clockwise.
    ndarray
        Root points of the pitch, counter-clockwise.
    """
    n_cell = region.size
    n_tip = int((region == 3).sum())
    start = int(np.argmax(region != 0))
    n = int(np.argmax(region == 3)) - start
    right = start + np.arange(n)
    # with full rounding the last left point is the first right point of the next tooth
    left = start + 2 * n + n_tip - 1 - np.arange(n)
    foot = np.concatenate([right[:1], -1 - np.arange(n_foot), left[:1]])
    last = n - 2 if is_internal else n - 1
    arc = np.arange(right[-1], left[-1] + 1)

    def fan(apex: int, line: IntArray) -> IntArray:
        """Triangles from one point to all segments of a line, shape (n - 1, 3)."""
        return np.stack([np.full(line.size - 1, apex), line[:-1], line[1:]], axis=1)

    strips = [
        fan(right[1], foot)[:, ::-1],
        np.array([[left[0], right[1], left[1]]]),
        np.stack([right[1:last], right[2 : last + 1], left[2 : last + 1]], axis=1),
        np.stack([right[1:last], left[2 : last + 1], left[1:last]], axis=1),
    ]
    if is_internal:
        # the tip arc of an internal tooth curves into the tooth: no strip may cross it
        strips += [fan(right[-2], arc), np.array([[right[-2], left[-1], left[-2]]])]
    else:
        strips.append(fan(arc[0], arc[1:]))
    root = np.concatenate([np.arange(start), foot[:-1], np.arange(left[0], n_cell)])
    return np.concatenate(strips), root


def _all_teeth(cell: IntArray, n_cell: int, z: int, n_foot: int) -> IntArray:
    """Repeat point indices of the first pitch for all teeth; negative ones are stored after the outline."""
    n_all = n_cell * z
    tooth = np.arange(z).reshape((z,) + (1,) * cell.ndim)
    return np.where(cell < 0, n_all + n_foot * tooth - 1 - cell, (cell + n_cell * tooth) % n_all)


def blank_section(
    gear: CylindricalGear, bore: float, rim: float | None, web: float | None
) -> tuple[list[tuple[float, float]], bool]:
    """Upper half of the blank section from the root inwards as (radius, z), and whether there is a bore.

    Parameters
    ----------
    gear
        The gear.
    bore
        Radius of the bore, for internal gears the outer radius [m]; 0 if not given.
    rim, web
        Thickness of rim and web [m]; None for a full disc.

    Raises
    ------
    GeometryError
        If the bore does not fit the gear.
    """
    half, r_f = 0.5 * gear.b, root_radius(gear)
    if gear.is_internal:
        outer = bore if bore > 0.0 else r_f + (RIM_OF_RING * gear.m_n if rim is None else rim)
        if not r_f < outer < math.inf:
            raise GeometryError(
                "does not reach around the teeth", where="bore_diameter", value=f"{2e3 * outer:.6g} mm"
            )
        return [(outer, half)], True
    # straight lines connect the feet of the teeth; the blank must be inside these
    limit = r_f * math.cos(math.pi / gear.z)
    if not 0.0 <= bore < limit:
        raise GeometryError(
            "does not fit the gear",
            where="bore_diameter",
            value=f"{2e3 * bore:.6g} mm",
            limit=f"{2e3 * limit:.6g} mm",
        )
    inner = bore if rim is None else max(bore, min(r_f - rim, limit))
    section = []
    if web is not None and inner > bore and web != gear.b:
        section = [(inner, half), (inner, 0.5 * web)]
    if bore > 0.0:
        section.append((bore, section[-1][1] if section else half))
    return section, bore > 0.0


def gear_solid(
    gear: CylindricalGear,
    n_flank: int = 20,
    n_slices: int | None = None,
    *,
    bore_diameter: float = 0.0,
    rim_thickness: float | None = None,
    web_thickness: float | None = None,
) -> FloatArray:
    """Closed triangulated surface of a gear.

    Parameters
    ----------
    gear
        External or internal gear; β > 0 rotates the section counter-clockwise towards +z.
    n_flank
        Points per flank, at least 5.
    n_slices
        Slices along the face width; None = 1 for spur gears, one per 0.5° of twist for helical ones.
    bore_diameter, rim_thickness, web_thickness
        Size of the blank, as in `pitchpoint.geometry.mass_properties.gear_mass_properties` [m].

    Returns
    -------
    ndarray, shape (n, 3, 3)
        Triangles, corners counter-clockwise seen from outside [m]; axis z, middle plane z = 0.

    Raises
    ------
    GeometryError
        If the tooth or the blank is not possible.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear_solid(CylindricalGear(z=17, m_n=1e-3, b=0.01), 10).shape
    (1836, 3, 3)
    """
    beta = gear.beta
    twist_rate = 2.0 * math.tan(beta) / abs(gear.d)
    if n_slices is None:
        n_slices = max(1, math.ceil(abs(twist_rate * gear.b) / _TWIST_STEP)) if beta != 0.0 else 1
    if n_slices < 1:
        raise GeometryError("slices are too few", where="n_slices", value=f"{n_slices}", limit="at least 1")
    profile = even_profile(gear, n_flank)
    flat = around(profile, abs(gear.z))
    n_outline, z, n_foot = flat.size, abs(gear.z), max(2, n_flank // 4)
    cell = tooth_cell(profile.region, n_foot, gear.is_internal)
    teeth, root = (_all_teeth(part, profile.region.size, z, n_foot) for part in cell)
    teeth, root = teeth.reshape(-1, 3), root.ravel()
    start = int(np.argmax(profile.region != 0))
    last = flat[start + 2 * n_flank + int((profile.region == 3).sum()) - 1]
    foot = flat[start] + (last - flat[start]) * np.arange(1, n_foot + 1) / (n_foot + 1.0)
    flat = np.append(flat, foot[None, :] * np.exp(2j * math.pi / z * np.arange(z))[:, None])

    def lift(points: NDArray[np.complex128], z: float, level: float) -> FloatArray:
        """Ring at the height z with the rotation of the section at the height `level`."""
        turned = points * np.exp(1j * twist_rate * level)
        return np.column_stack([turned.real, turned.imag, np.full(points.size, z)])

    levels = np.linspace(-0.5 * gear.b, 0.5 * gear.b, n_slices + 1)
    rings = [lift(flat, z, z) for z in levels]
    faces = [_quads(low[:n_outline], high[:n_outline]) for low, high in zip(rings, rings[1:], strict=False)]
    faces += [rings[-1][teeth], rings[0][teeth][:, ::-1]]

    upper, is_open = blank_section(gear, 0.5 * bore_diameter, rim_thickness, web_thickness)
    direction = flat[root] / np.abs(flat[root])
    top, bottom = [rings[-1][root]], [rings[0][root]]
    for radius, height in upper:
        top.append(lift(direction * radius, height, levels[-1]))
        bottom.append(lift(direction * radius, -height, levels[0]))
    faces += [_quads(a, b) for a, b in zip(top, top[1:], strict=False)]
    faces += [_quads(b, a) for a, b in zip(bottom, bottom[1:], strict=False)]
    end = upper[-1][1] if upper else 0.5 * gear.b
    if is_open:
        radius = upper[-1][0]
        share = np.linspace(1.0, -1.0, n_slices + 1)
        wall = [lift(direction * radius, end * t, levels[-1] * t) for t in share]
        faces += [_quads(a, b) for a, b in zip(wall, wall[1:], strict=False)]
    else:
        faces += [_fan(top[-1], end), _fan(bottom[-1], -end)[:, ::-1]]
    solid = np.concatenate(faces)
    return solid[:, ::-1] if gear.is_internal else solid
