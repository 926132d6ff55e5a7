# SPDX-License-Identifier: Apache-2.0
"""One pitch of a gear: its copies close the surface, their volume is known, flanks are involutes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_sector import gear_sector, pitch_outline, slices_for, thinned
from pitchpoint.geometry.mass_properties import gear_mass_properties
from pitchpoint.geometry.triangle_file import join_corners

GEARS = {
    "helical with a bore": (CylindricalGear(z=23, m_n=3e-3, b=0.03, beta=0.26), {"bore_diameter": 0.02}),
    "rim and web": (
        CylindricalGear(z=60, m_n=3e-3, b=0.03),
        {"bore_diameter": 0.02, "rim_thickness": 0.01, "web_thickness": 0.008},
    ),
    "internal": (CylindricalGear(z=-60, m_n=2e-3, b=0.02), {}),
    "undercut disc": (CylindricalGear(z=12, m_n=1e-3, b=0.01), {}),
    "full fillet": (CylindricalGear(z=17, m_n=1e-3, b=0.01, x=0.6), {}),
}


def whole(sector, z):
    """Corners of all triangles of a gear, shape (n, 3, 3)."""
    corners = sector.points[sector.triangles]
    angle = 2.0 * math.pi / z * np.arange(z)
    c, s, o, one = np.cos(angle), np.sin(angle), 0.0 * angle, 1.0 + 0.0 * angle
    turned = np.array([[c, -s, o], [s, c, o], [o, o, one]])
    return np.einsum("ijk,abj->kabi", turned, corners).reshape(-1, 3, 3)


def volume(corners):
    return np.einsum("ni,ni->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6.0


@pytest.fixture(params=GEARS)
def gear(request):
    return GEARS[request.param]


@pytest.mark.parametrize("error", [0.04, 0.004, 2e-4])
def test_copies_of_a_pitch_close_the_surface(gear, error):
    """Every edge is run through once in either direction."""
    shape, blank = gear
    error *= shape.m_n
    sections = [(float(z), None) for z in slices_for(shape, error)]
    sector = gear_sector(shape, pitch_outline(shape, error), sections, **blank)
    _, triangles = join_corners(whole(sector, abs(shape.z)))
    edges = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    one_way = set(map(tuple, edges.tolist()))
    assert len(one_way) == len(edges)
    assert {(b, a) for a, b in one_way} == one_way


def test_volume_of_a_fine_gear_is_the_closed_form(gear):
    """Bores and rims are polygons of n corners: (n/2 pi) sin(2 pi/n) of their circles; the rest are teeth
    whose chords omit some 1e-4 of a module, and straight pieces of helices."""
    shape, blank = gear
    error = 1e-4 * shape.m_n
    sections = [(float(z), None) for z in slices_for(shape, error)]
    found = volume(whole(gear_sector(shape, pitch_outline(shape, error), sections, **blank), abs(shape.z)))
    z = abs(shape.z)
    n = z * max(1, math.ceil(48 / z))
    lost = 1.0 - n / (2.0 * math.pi) * math.sin(2.0 * math.pi / n)
    exact = gear_mass_properties(shape, 1.0, **blank).mass
    bore, rim, web = (blank.get(f"{key}") for key in ("bore_diameter", "rim_thickness", "web_thickness"))
    missing = 0.0
    if shape.is_internal:
        from pitchpoint.geometry.solid import blank_section

        missing = math.pi * blank_section(shape, 0.0, None, None)[0][0][0] ** 2 * shape.b
    elif bore:
        missing = -math.pi / 4.0 * bore**2 * (web or shape.b)
        if web:
            inner = 0.5 * abs(shape.d_f) - rim
            missing -= math.pi * inner**2 * (shape.b - web)
    assert found == pytest.approx(exact - lost * missing, rel=2e-4)


def test_points_of_flanks_lie_on_the_involute(gear):
    """Half the angle of a tooth at a radius: s_t/d + inv(alpha_t) - inv(arccos(r_b/r)), after ISO 21771."""
    shape, _ = gear
    outline = pitch_outline(shape, 1e-4 * shape.m_n)
    r_b = 0.5 * abs(shape.d_b)
    involute = lambda a: math.tan(a) - a  # noqa: E731
    s_t = shape.s_n / math.cos(shape.beta)
    for side, towards in (("right", -1.0), ("left", 1.0)):
        plane = outline.points[outline.flank(side)]
        low, high = sorted((0.5 * abs(shape.d_Ff), 0.5 * abs(shape.d_Fa)))
        on_flank = plane[(np.abs(plane) > low * (1 + 1e-9)) & (np.abs(plane) < high * (1 - 1e-9))]
        assert len(on_flank) >= 5
        for point in on_flank:
            alpha = math.acos(r_b / abs(point))
            half = s_t / abs(shape.d) + shape.sign * (involute(shape.alpha_t) - involute(alpha))
            assert towards * np.angle(point) == pytest.approx(half, abs=1e-9)


def test_chords_stay_within_what_is_asked(gear):
    """Of 2000 points of the exact outline none is further from its chord."""
    shape, _ = gear
    fine = pitch_outline(shape, 0.0, 2000)
    for error in (0.04 * shape.m_n, 1e-3 * shape.m_n):
        coarse = pitch_outline(shape, error)
        for side in ("right", "left"):
            line, exact = coarse.points[coarse.flank(side)], fine.points[fine.flank(side)]
            start, along = line[:-1, None], np.diff(line)[:, None]
            share = np.clip(((exact - start) * along.conj()).real / np.abs(along) ** 2, 0.0, 1.0)
            off = np.abs(start + share * along - exact).min(axis=0)
            assert off.max() < 1.05 * error + 1e-4 * shape.m_n


def test_thinned_keeps_the_ends_of_a_loop():
    """First and last point in one place: the chord has no direction, distances count."""
    loop = np.exp(2j * np.pi * np.linspace(0.0, 1.0, 65))
    kept = thinned(loop, 0.1)
    assert kept[0] == 0 and kept[-1] == 64 and 5 <= kept.size < 20


def test_a_tooth_that_ends_lower_is_closed_and_lower():
    shape = CylindricalGear(z=23, m_n=3e-3, b=0.03)
    outline = pitch_outline(shape, 1e-5)
    sound = [(-0.015, None), (0.015, None)]
    limit = 0.5 * shape.d_a - 2e-3
    step = [(-0.015, limit), (-0.005 - 1e-8, limit), (-0.005 + 1e-8, None), (0.015, None)]
    full, broken = (gear_sector(shape, outline, s) for s in (sound, step))
    start = broken.points[broken.points[:, 2] < -0.0051]
    assert np.hypot(start[:, 0], start[:, 1]).max() < limit + 1e-9
    # area of the tooth above the limit, from the outline, over the width that is missing
    tip = outline.points[np.abs(outline.points) > limit]
    ends = [
        np.interp(limit, np.abs(outline.points[i]), outline.points[i])
        for i in map(outline.flank, ("right", "left"))
    ]
    ring = np.concatenate([[ends[0]], tip, [ends[1]]])
    area = 0.5 * (ring.conj() * np.roll(ring, -1)).imag.sum()
    gone = 23 * (volume(full.points[full.triangles]) - volume(broken.points[broken.triangles])) / 23
    assert gone == pytest.approx(area * 0.01, rel=1e-3)
