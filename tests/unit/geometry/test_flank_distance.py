# SPDX-License-Identifier: Apache-2.0
"""Distance of flanks at any position: against surfaces made of thickness formulas and a numerical search."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import least_squares

from pitchpoint.contact.tip_contact import tip_gap
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.closest_points import RESOLUTION, closest_points
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.deviations import Deviations, FlankMap, Runout, separation
from pitchpoint.geometry.flank_distance import Facing, Mounting, flank_distance
from pitchpoint.geometry.flank_surface import Flank
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.modifications import EndRelief, FlankModifications, Relief, flank_range
from pitchpoint.geometry.tooth_thickness import transverse_tooth_thickness

M = 3e-3
FRONT, BACK = True, False


def make(z1=25, z2=60, beta=0.0, internal=False, widening=4e-5):
    one = CylindricalGear(z=z1, m_n=M, beta=beta, b=0.03, x=0.1)
    two = CylindricalGear(z=-z2 if internal else z2, m_n=M, beta=beta if internal else -beta, b=0.03)
    pair = GearPair.from_profile_shifts(one, two)
    return pair.at_center_distance(pair.a_w + widening)


PAIRS = {
    "spur": make(),
    "helical": make(beta=0.3),
    "left": make(beta=-0.25),
    "internal spur": make(z2=70, internal=True),
    "internal helical": make(z2=70, internal=True, beta=0.2),
}
TILTS = {"parallel": {}, "tilted": {"in_plane": 8e-3, "out_of_plane": -5e-3, "offset": 2e-3}}


def facing(pair, front=True, tooth=0, micro=(None, None), **mounting):
    """Flanks that face each other at the line of centres, of tooth `tooth` of gear 1."""
    internal = pair.is_internal
    mate = {
        (True, False): -1 - tooth,
        (False, False): -tooth,
        (True, True): tooth,
        (False, True): tooth - 1,
    }[front, internal]
    sides = ("left", "right" if internal else "left") if front else ("right", "left" if internal else "right")
    flanks = [
        Flank(gear=gear, side=side, tooth=k, **(extra or {}))
        for gear, side, k, extra in zip((pair.gear1, pair.gear2), sides, (tooth, mate), micro, strict=True)
    ]
    return Facing(mounting=Mounting(pair=pair, **mounting), own=flanks[0], mate=flanks[1])


def surface(flank, diameter, z):
    """Point of a flank from the tooth thickness on a cylinder and the lead, in the frame of the gear."""
    gear = flank.gear
    half = transverse_tooth_thickness(gear, diameter) / abs(diameter)
    lead = math.copysign(2.0 * math.pi / gear.p_z, gear.beta) * z  # p_z is infinite for spur gears
    angle = 2.0 * math.pi * flank.tooth / abs(gear.z) + (half if flank.side == "left" else -half) + lead
    return 0.5 * abs(diameter) * np.array([math.cos(angle), math.sin(angle), 0.0]) + np.array([0.0, 0.0, z])


def search(flank, point, roll, z):
    """Distance of a point to a flank, by least squares over diameter and width, in the frame of the gear."""
    gear, scale = flank.gear, 1e-3
    start = gear.sign * math.hypot(gear.d_b, 2.0 * roll)

    def away(v):
        """Vector from the flank to the point."""
        return point - surface(flank, start + scale * v[0], z + scale * v[1])

    best = least_squares(away, [0.0, 0.0], xtol=1e-15, ftol=1e-15, gtol=1e-15, x_scale="jac")
    return float(np.linalg.norm(best.fun)), start + scale * best.x[0], z + scale * best.x[1]


@pytest.mark.parametrize("tilt", TILTS)
@pytest.mark.parametrize("front", [FRONT, BACK])
@pytest.mark.parametrize("name", PAIRS)
def test_points_lie_on_the_tooth(name, front, tilt):
    both = facing(PAIRS[name], front, 1)
    for flank in (both.own, both.mate):
        roll, z = np.linspace(*flank.span, 5), np.linspace(-0.4, 0.4, 5) * flank.gear.b
        points, normals = flank.points(roll, z)
        for k in range(5):
            d = flank.gear.sign * math.hypot(flank.gear.d_b, 2.0 * roll[k])
            np.testing.assert_allclose(points[k], surface(flank, d, z[k]), atol=1e-16)
            h = 1e-6
            for step in ((h, 0.0), (0.0, h)):
                ahead, behind = (surface(flank, d + s * step[0], z[k] + s * step[1]) for s in (1, -1))
                assert abs(normals[k] @ (ahead - behind)) / (2.0 * h) < 1e-8
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0, rtol=1e-15)
        turning = normals[:, 1] * points[:, 0] - normals[:, 0] * points[:, 1]
        assert np.all(turning * (1.0 if flank.side == "left" else -1.0) > 0.0)


@pytest.mark.parametrize("tilt", TILTS)
@pytest.mark.parametrize("front", [FRONT, BACK])
@pytest.mark.parametrize("name", PAIRS)
def test_distance_is_that_of_a_search(name, front, tilt):
    """Points of the flank of gear 1 anywhere on it, and the other way round."""
    both = facing(PAIRS[name], front, 1, phi1=0.03, **TILTS[tilt])
    for here in (both, both.swapped()):
        low, high = here.own.span
        for share, width in ((0.3, -0.4), (0.55, 0.1), (0.8, 0.35)):
            roll, z = low + share * (high - low), width * here.own.gear.b
            found = flank_distance(here, roll, z)
            point = here.mounting.transfer(here.own.points(roll, z)[0], here.gear)
            size, diameter, foot = search(here.mate, point, float(found.mate_roll), float(found.mate_z))
            assert abs(float(found.distance)) == pytest.approx(size, abs=1e-12)
            assert 0.5 * math.sqrt(diameter**2 - here.mate.gear.d_b**2) == pytest.approx(
                float(found.mate_roll), abs=1e-8
            )
            assert foot == pytest.approx(float(found.mate_z), abs=1e-8)
            # positive outside the tooth
            _, normal = here.mate.points(found.mate_roll, found.mate_z)
            on_it = surface(here.mate, diameter, foot)
            assert float(found.distance) == pytest.approx(float(normal @ (point - on_it)), abs=1e-12)


@pytest.mark.parametrize("front", [FRONT, BACK])
@pytest.mark.parametrize("name", PAIRS)
def test_parallel_flanks_are_half_the_normal_backlash_apart(name, front):
    pair = PAIRS[name]
    for phi1, tooth in ((0.0, 0), (0.02, 0), (-0.03, 0), (0.01, 1)):
        found = closest_points(facing(pair, front, tooth, phi1=phi1), np.linspace(-0.3, 0.3, 7) * 0.03)
        touching = np.isfinite(found.distance)
        inside = touching & (found.own_roll > flank_range(pair.gear1)[0] + 1e-6)
        inside &= found.own_roll < flank_range(pair.gear1)[1] - 1e-6
        low, high = sorted(flank_range(pair.gear2))
        inside &= (found.mate_roll > low + 1e-6) & (found.mate_roll < high - 1e-6)
        np.testing.assert_allclose(found.distance[inside], 0.5 * pair.j_bn, atol=1e-16)
        assert np.all(found.distance[touching] >= 0.5 * pair.j_bn - 1e-16)
        if tooth == 0 and phi1 == 0.0:
            assert inside.any()


def turned_to(pair, roll):
    """Rotation of gear 1 at which the left flank of tooth 0 is on the line of action at a length of roll."""
    inv_w = math.tan(pair.alpha_wt) - pair.alpha_wt
    return (roll - pair.T1C) / pair.gear1.r_b - pair.gear1.psi_b + inv_w


@pytest.mark.parametrize("gear", [1, 2])
@pytest.mark.parametrize("name", PAIRS)
def test_tip_edges_beyond_the_path_of_contact(name, gear):
    """The point at the tip is off by the gap of `contact.tip_contact` along the base tangent."""
    pair = PAIRS[name]
    r = pair.gear1.r_b, pair.gear2.r_b
    tips = pair.T1E, pair.T1T2 - pair.T1A  # lengths of roll at the tips, signed
    eta = 1.5e-3
    at_end = pair.T1E + eta if gear == 1 else pair.T1A - eta - 0.5 * pair.j_bt
    phi1 = turned_to(pair, at_end)
    both = facing(pair, phi1=phi1)
    here = both if gear == 1 else both.swapped()
    found = flank_distance(here, abs(tips[gear - 1]), 0.0)
    gap, _, _, roll, *_ = tip_gap(eta, r[gear - 1], r[2 - gear], tips[gear - 1], math.tan(pair.alpha_wt))
    assert float(found.distance) == pytest.approx(
        math.cos(pair.gear1.beta_b) * (0.5 * pair.j_bt + gap), abs=1e-15
    )
    assert float(found.mate_roll) == pytest.approx(abs(roll - 0.5 * pair.j_bt - gap), abs=2e-5)


def test_spur_is_the_limit_of_helical():
    z = np.linspace(-0.4, 0.4, 5) * 0.03
    found = [closest_points(facing(make(beta=beta), phi1=0.01, **TILTS["tilted"]), z) for beta in (0.0, 1e-8)]
    np.testing.assert_allclose(found[1].distance, found[0].distance, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(found[1].own_roll, found[0].own_roll, rtol=0.0, atol=1e-7)


@pytest.mark.parametrize("tilt", TILTS)
@pytest.mark.parametrize("name", PAIRS)
def test_closest_points_are_minima(name, tilt):
    both = facing(PAIRS[name], phi1=0.01, **TILTS[tilt])
    for here in (both, both.swapped()):
        z = np.linspace(-0.4, 0.4, 5) * 0.03
        found = closest_points(here, z)
        low, high = here.own.span
        assert np.isfinite(found.distance).any()
        for k in np.flatnonzero(np.isfinite(found.distance)):
            every = flank_distance(here, np.linspace(low, high, 20001), np.full(20001, z[k]))
            fits = here.mate.covers(every.mate_roll, every.mate_z)
            least = every.distance[fits].min()
            assert found.distance[k] == pytest.approx(least, abs=1e-10)
            assert found.distance[k] <= least + 1e-15
            # the slope is zero, unless the point is at an edge of either flank
            edge = min(found.own_roll[k] - low, high - found.own_roll[k]) < 1e-9
            near = [found.mate_roll[k] - end for end in here.mate.span]
            near += [abs(found.mate_z[k]) - 0.5 * here.mate.gear.b]
            if edge or min(map(abs, near)) < 1e-9:
                continue
            h = 1e-5
            ahead, behind = (flank_distance(here, found.own_roll[k] + d, z[k]).distance for d in (h, -h))
            curvature = (ahead + behind - 2.0 * found.distance[k]) / (h * h)
            assert abs(ahead - behind) / (2.0 * h) / curvature < 1e-8
    assert RESOLUTION <= 1e-12


MODIFIED = FlankModifications(
    tip_relief=Relief(amount=15e-6, length=2.5e-3, shape="parabolic"),
    root_relief=Relief(amount=8e-6, length=2e-3),
    profile_crowning=4e-6,
    lead_crowning=6e-6,
    helix_slope=5e-6,
    end_relief=EndRelief(amount=7e-6, length=3e-3),
)


@pytest.mark.parametrize("front", [FRONT, BACK])
@pytest.mark.parametrize("name", PAIRS)
def test_micro_geometry_adds_up_along_the_normals(name, front):
    """On the line of action: half of the backlash and the gaps of both flanks, to second order."""
    pair = PAIRS[name]
    micro = ({"modifications": MODIFIED}, {"modifications": MODIFIED})
    plain, both = facing(pair, front, phi1=0.01), facing(pair, front, 0, micro, phi1=0.01)
    z = np.linspace(-0.3, 0.3, 7) * 0.03
    start = closest_points(plain, z)
    found = flank_distance(both, start.own_roll, z)
    cos = math.cos(pair.gear1.beta_b)
    sides = plain.own.side, plain.mate.side
    for k in np.flatnonzero(np.isfinite(start.distance)):
        gaps = [
            float(separation(gear, side, [at], [roll], modifications=MODIFIED)[0, 0, 0]) * cos
            for gear, side, at, roll in zip(
                (pair.gear1, pair.gear2),
                sides,
                (z[k], start.mate_z[k]),
                (start.own_roll[k], start.mate_roll[k]),
                strict=True,
            )
        ]
        assert found.distance[k] == pytest.approx(start.distance[k] + sum(gaps), abs=2e-9)
    least = closest_points(both, z)
    some = np.isfinite(least.distance) & np.isfinite(found.distance)
    assert some.any()
    assert np.all(least.distance[some] <= found.distance[some] + 1e-15)


def test_closest_point_at_the_start_of_a_linear_relief():
    """The distance has a corner there, found to the step of the differences."""
    pair = PAIRS["spur"]
    low, high = flank_range(pair.gear1)
    steep = FlankModifications(
        tip_relief=Relief(amount=50e-6, length=0.45 * (high - low)),
        root_relief=Relief(amount=50e-6, length=0.55 * (high - low)),
    )
    corner = low + 0.55 * (high - low)
    turned = turned_to(pair, corner + 0.1e-3)
    both = facing(pair, micro=({"modifications": steep}, None), phi1=turned)
    found = closest_points(both, [0.0])
    every = flank_distance(both, np.linspace(low, high, 200001), np.zeros(200001))
    fits = both.mate.covers(every.mate_roll, every.mate_z)
    assert found.distance[0] == pytest.approx(every.distance[fits].min(), abs=1e-10)
    assert found.own_roll[0] == pytest.approx(corner, abs=1e-8)


def test_deviations_of_single_teeth():
    pair = PAIRS["helical"]
    pitch = np.zeros(25)
    pitch[3], pitch[4] = 10e-6, -10e-6
    late = Deviations(
        pitch=pitch,
        runout=Runout(amount=20e-6, phase=0.4),
        flank_maps=[FlankMap(tooth=3, flank="left", values=[[0.0, 2e-6], [1e-6, 5e-6]])],
    )
    gear, cos = pair.gear1, math.cos(pair.gear1.beta_b)
    roll, z = np.array([0.012, 0.016]), np.array([-0.008, 0.011])
    expected = np.array(
        [separation(gear, "left", [b], [a], deviations=late)[:, 0, 0] for a, b in zip(roll, z, strict=True)]
    )
    for tooth in (3, 4, -1):
        gap = Flank(gear=gear, side="left", tooth=tooth, deviations=late).gap(roll, z)
        np.testing.assert_allclose(gap, expected[:, tooth] * cos, atol=2e-10)
    least = Flank(gear=gear, side="left", deviations=late, every_tooth=True).gap(roll, z)
    np.testing.assert_allclose(least, expected.min(axis=1) * cos, atol=2e-9)


def test_points_inside_the_base_cylinder_have_no_distance():
    pair = PAIRS["spur"]
    flank = Flank(gear=pair.gear1)
    distance, roll, _ = flank.distance(np.array([[0.9 * pair.gear1.r_b, 0.0, 0.0]]))
    assert np.isnan(distance[0])
    assert np.isnan(roll[0])


def test_unknown_sides_are_refused():
    with pytest.raises(GeometryError, match="side: 'top' is unknown"):
        Flank(gear=PAIRS["spur"].gear1, side="top")
