# SPDX-License-Identifier: Apache-2.0
"""Spherical involutes roll on each other, teeth never overlap; solids are closed and weigh what they must."""

from __future__ import annotations

import math
from math import radians

import numpy as np
import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.bevel.blank import bevel_blank, bevel_mass, revolved
from pitchpoint.geometry.bevel.cones import pitch_angles
from pitchpoint.geometry.bevel.gear import BevelGear
from pitchpoint.geometry.bevel.pair import BevelPair
from pitchpoint.geometry.bevel.sector import bevel_outline, bevel_sector, bevel_slices, bevel_solid
from pitchpoint.geometry.bevel.tooth import bevel_tooth, placed
from pitchpoint.geometry.solid_mass import solid_of_triangles
from pitchpoint.geometry.triangle_file import join_corners
from tests.support.bevel_teeth import angles_inside

PAIRS = {
    "miter": (20, 20, 90.0, 0.0, 0.0),
    "15/45": (15, 45, 90.0, 0.0, 0.25),
    "spiral": (17, 31, 90.0, 35.0, 0.2),
    "acute": (20, 30, 75.0, -30.0, 0.0),
    "obtuse": (23, 24, 110.0, 0.0, 0.0),
    "undercut": (12, 40, 60.0, 0.0, 0.0),
}


@pytest.fixture(params=PAIRS)
def pair(request):
    z1, z2, Sigma, beta, shift = PAIRS[request.param]
    angles = pitch_angles(z1, z2, radians(Sigma))
    one, two = (
        BevelGear.of_outer_module(
            z=z, m_et=3e-3, delta=delta, b=15e-3, beta_m=s * radians(beta), x_hm=s * shift
        )
        for z, delta, s in zip((z1, z2), angles, (1.0, -1.0), strict=True)
    )
    return BevelPair(one, two, radians(Sigma))


def frame_2(pair):
    """Axes of gear 2 in the frame of gear 1; the pitch ray is at the azimuth 0 of both."""
    s, d = pair.Sigma, pair.gear1.delta
    axis = np.array([math.sin(s), 0.0, math.cos(s)])
    ray = np.array([math.sin(d), 0.0, math.cos(d)])
    x = ray - (ray @ axis) * axis
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(axis, x), axis])


@pytest.mark.parametrize("angle", [0.0, 0.03, -0.05])
def test_flanks_touch_along_the_plane_of_action(pair, angle):
    """The points that both gears have on the contact line are one point, and its normal lies in the plane."""
    one, two = pair.gear1, pair.gear2
    turn2 = frame_2(pair)
    mate = pair.mate_angle(angle, 0.0, 0.0)
    s1 = math.sin(one.delta_b)
    still = math.atan2(math.tan(one.sigma_w), s1)
    normal = np.cross(
        [
            math.sin(one.delta_b) * math.cos(still),
            math.sin(one.delta_b) * math.sin(still),
            math.cos(one.delta_b),
        ],
        [math.sin(one.delta), 0.0, math.cos(one.delta)],
    )
    normal /= np.linalg.norm(normal)
    found = 0
    for tooth in range(-2, 3):
        for R in np.linspace(pair.R_i, pair.R_e, 4):
            a1 = angle + tooth * 2.0 * math.pi / one.z + one.spiral_rate * math.log(R / one.R_m)
            sigma = s1 * (still + one.psi_b - a1)
            if not pair.sigma_A < sigma < pair.sigma_E or sigma < 0.0 or sigma > pair.sigma_T:
                continue
            polar, half = bevel_tooth(one).involute(np.array([sigma]))
            turn = angle + tooth * 2.0 * math.pi / one.z
            here = placed(one, polar, turn - half, R)[0]
            assert abs(here @ normal) < 1e-15
            polar, half = bevel_tooth(two).involute(np.array([pair.sigma_T - sigma]))
            gaps = [
                np.linalg.norm(
                    turn2 @ placed(two, polar, mate + k * 2.0 * math.pi / two.z - half, R)[0] - here
                )
                for k in range(-3, 4)
            ]
            assert min(gaps) < 1e-12
            found += 1
    assert found >= 2


@pytest.mark.parametrize("angle", np.linspace(-0.15, 0.15, 7))
def test_teeth_never_overlap(pair, angle):
    """No point of gear 1 lies in gear 2, nor the other way; without backlash both flanks touch."""
    turn2 = frame_2(pair)
    mate = pair.mate_angle(angle, 0.0, 0.0)
    deepest = -1.0
    for gear, turn, other, other_turn, frame in (
        (pair.gear1, angle, pair.gear2, mate, turn2),
        (pair.gear2, mate, pair.gear1, angle, turn2.T),
    ):
        polar, half = bevel_tooth(gear).flank(161, 60)
        for R in (pair.R_i, pair.R_e):
            for k in range(-2, 3):
                for side in (-1.0, 1.0):
                    azimuth = turn + 2.0 * math.pi * k / gear.z + side * half
                    points = placed(gear, polar, azimuth, R) @ frame
                    deepest = max(deepest, angles_inside(other, other_turn, points).max())
    # with points this near to each other one of them is next to contact; on involutes the rest is round-off
    assert -1e-5 < deepest < 1e-9


def test_a_frustum_has_its_closed_form():
    r_1, r_2, h = 0.02, 0.05, 0.03
    volume, moment, _, polar = revolved([(0.0, 0.0), (r_1, 0.0), (r_2, h), (0.0, h)])
    assert volume == pytest.approx(math.pi * h / 3.0 * (r_1**2 + r_1 * r_2 + r_2**2), rel=1e-14)
    assert moment / volume == pytest.approx(
        h * (r_1**2 + 2.0 * r_1 * r_2 + 3.0 * r_2**2) / (4.0 * (r_1**2 + r_1 * r_2 + r_2**2)), rel=1e-14
    )
    assert polar == pytest.approx(math.pi / 10.0 * h * (r_2**5 - r_1**5) / (r_2 - r_1), rel=1e-14)


SOLIDS = {
    "straight": (BevelGear(z=20, m_mn=2.5e-3, delta=math.atan(0.5), b=0.02), {}),
    "spiral with a bore": (
        BevelGear(z=19, m_mn=2.5e-3, delta=1.1, b=0.01, beta_m=-0.6),
        {"bore_diameter": 0.015, "rim_thickness": 0.01},
    ),
    "undercut": (BevelGear(z=10, m_mn=2.5e-3, delta=0.3, b=0.02), {"bore_diameter": 0.005}),
    "full fillet": (BevelGear(z=17, m_mn=2.5e-3, delta=0.8, b=0.01, x_hm=0.6), {"bore_diameter": 0.005}),
}


@pytest.mark.parametrize("name", SOLIDS)
@pytest.mark.parametrize(("n_flank", "error", "parts"), [(10, 5e-6, 1e-2), (30, 5e-7, 1e-3)])
def test_solid_is_closed_and_has_mass_and_inertia_of_the_integrals(name, n_flank, error, parts):
    """Chords ten times `error` off surfaces that are 5 mm apart: that part of the volume, at most."""
    gear, blank = SOLIDS[name]
    exact = bevel_mass(gear, 1.0, **blank)
    corners = bevel_solid(gear, n_flank, error, **blank)
    _, triangles = join_corners(corners)
    edges = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    there, back = (np.unique(pairs, axis=0) for pairs in (edges, edges[:, ::-1]))
    assert len(there) == len(edges)
    assert np.array_equal(there, back)
    solid = solid_of_triangles(corners)
    assert solid.volume == pytest.approx(exact.mass, rel=parts)
    assert solid.center[2] == pytest.approx(exact.center, rel=parts)
    assert solid.moments[2] == pytest.approx(exact.polar_inertia, rel=parts)
    assert solid.moments[0] == pytest.approx(exact.transverse_inertia, rel=parts)
    assert np.abs(solid.center[:2]).max() < 1e-9


def test_a_body_that_does_not_fit_is_refused():
    gear = SOLIDS["straight"][0]
    with pytest.raises(GeometryError, match="bore_diameter"):
        bevel_blank(gear, 0.05, None)
    with pytest.raises(GeometryError, match="reaches beyond the axis"):
        bevel_blank(gear, 0.0, 0.5)


@pytest.mark.parametrize("beta", [0.0, 0.6])
def test_what_is_broken_off_a_tooth_has_the_volume_between_its_cone_distances(beta):
    """Slices at R are R^2 as large: (R_e^3 - R^3)/(R_e^3 - R_i^3) of a tooth. Faces of a break go straight
    from root to flank, ends of teeth are as round as their cone: 2e-4 of a tooth; spirals are cut between
    their slices, which moves 3e-3."""
    gear = BevelGear.of_outer_module(z=17, m_et=3e-3, delta=0.5, b=14e-3, beta_m=beta)
    outline, slices = bevel_outline(gear, 1e-6), bevel_slices(gear, 1e-6)

    def volume(whole):
        """Of the pyramids from the apex to the surface of one pitch [m^3]."""
        sector = bevel_sector(gear, outline, slices, bore_diameter=8e-3, whole=whole)
        a, b, c = np.moveaxis(sector.points[sector.triangles], 1, 0)
        return float(np.einsum("ni,ni->", a, np.cross(b, c))) / 6.0

    R_i, R_e = gear.R_i, gear.R_e
    full, gone = volume(None), volume((R_e, R_i))
    assert volume((R_i, R_e)) == pytest.approx(full, rel=1e-12)
    teeth = 2.0 * gear.m_mn * 14e-3 * 0.5 * math.pi * gear.m_mt
    assert 0.5 * teeth < full - gone < 1.5 * teeth
    for low, high in ((R_i, R_e - 5e-3), (R_i + 4e-3, R_e), (R_i + 3e-3, R_e - 6e-3)):
        share = (volume((low, high)) - gone) / (full - gone)
        expected = (high**3 - low**3) / (R_e**3 - R_i**3)
        assert share == pytest.approx(expected, abs=2e-4 if beta == 0.0 else 3e-3)
