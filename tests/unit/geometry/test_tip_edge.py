# SPDX-License-Identifier: Apache-2.0
"""Broken tip edges: closed forms against tangency, areas and volumes; effect on path and contact."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.tip_contact import tip_gap
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.clearance import clearances
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.flank_clearance import facing_flanks
from pitchpoint.geometry.flank_distance import Mounting
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.gear_sector import pitch_outline
from pitchpoint.geometry.mass_properties import section_integrals
from pitchpoint.geometry.modifications import FlankModifications, Relief, deviation, flank_range
from pitchpoint.geometry.outline_distance import TIP, gear_line
from pitchpoint.geometry.solid import gear_solid
from pitchpoint.geometry.tip_edge import tip_edge
from pitchpoint.geometry.tooth_curves import bernstein, pitch_curves
from pitchpoint.geometry.tooth_form import around, tooth_form, tooth_profile
from pitchpoint.geometry.tooth_outline import outline_from_flanks, outline_from_tooth
from tests.unit.geometry.test_flank_distance import turned_to

M = 3e-3
GEARS = {
    "external": dict(z=30, x=0.2),
    "helical": dict(z=21, beta=0.3),
    "few teeth": dict(z=12, x=0.4),
    "internal": dict(z=-60),
    "internal helical": dict(z=-71, beta=-0.2, x=-0.3),
}
EDGES = {"chamfer": {"tip_chamfer": 0.35e-3}, "rounding": {"tip_rounding": 0.4e-3}}
every_gear = pytest.mark.parametrize("name", GEARS)
every_edge = pytest.mark.parametrize("edge", EDGES)


def broken(name, edge=None):
    return CylindricalGear(m_n=M, b=0.02, **GEARS[name], **(EDGES[edge] if edge else {}))


@every_gear
def test_chamfer_by_its_drawing(name):
    """d_Fa = d_a - 2 h_K with signed diameters; a straight line at 45 deg to the centre line of the tooth."""
    gear, plain = broken(name, "chamfer"), broken(name)
    assert gear.d_Fa == pytest.approx(plain.d_a - 2.0 * 0.35e-3, rel=1e-14)
    assert gear.d_a == plain.d_a
    edge = tip_edge(gear)
    assert abs(edge.start) == pytest.approx(0.5 * abs(gear.d_Fa), rel=1e-14)
    assert abs(edge.end) == pytest.approx(0.5 * abs(gear.d_a), rel=1e-14)
    along = edge.end - edge.start
    assert gear.sign * along.real == pytest.approx(-along.imag, rel=1e-9)
    assert along.imag < 0.0
    # the flank begins there
    half = float(tooth_form(plain).involute_half_angle(0.5 * abs(gear.d_Fa)))
    assert math.atan2(edge.start.imag, edge.start.real) == pytest.approx(half, rel=1e-12)


@every_gear
def test_rounding_is_tangent_to_flank_and_tip_circle(name):
    gear, rho = broken(name, "rounding"), 0.4e-3
    edge, form = tip_edge(gear), tooth_form(broken(name))
    points, slopes = edge.points(np.linspace(0.0, 1.0, 201))
    r_Fa = 0.5 * abs(gear.d_Fa)
    # on the flank, with its tangent
    assert abs(points[0]) == pytest.approx(r_Fa, rel=1e-14)
    assert np.angle(points[0]) == pytest.approx(float(form.involute_half_angle(r_Fa)), abs=1e-13)
    h = 1e-7
    ahead, behind = ((r_Fa + d) * np.exp(1j * float(form.involute_half_angle(r_Fa + d))) for d in (h, -h))
    tangent = gear.sign * (ahead - behind)
    assert abs(np.angle(slopes[0] / tangent)) < 1e-6
    # at the tip circle, tangent to it
    assert abs(points[-1]) == pytest.approx(0.5 * abs(gear.d_a), rel=1e-14)
    assert abs((slopes[-1] * np.conj(points[-1])).real) < 1e-9 * abs(slopes[-1]) * abs(points[-1])
    # a circle of the given radius over the angle of the edge
    chords = np.diff(points)
    assert np.abs(chords).sum() == pytest.approx(rho * edge.arc, rel=1e-5)
    turns = np.angle(chords[1:] / chords[:-1])
    np.testing.assert_allclose(turns, turns[0], rtol=1e-6)
    np.testing.assert_allclose(slopes, np.gradient(points, 1.0 / 200.0, edge_order=2), rtol=1e-4)


@every_edge
@every_gear
def test_area_of_outline_curves_and_solid(name, edge):
    gear = broken(name, edge)
    area, polar = section_integrals(tooth_form(gear))
    sharp_area, sharp_polar = section_integrals(tooth_form(broken(name)))
    assert gear.sign * (area - sharp_area) < 0.0 and gear.sign * (polar - sharp_polar) < 0.0

    def of(ring):
        return 0.5 * float(np.sum((ring.conj() * np.roll(ring, -1)).imag))

    turn = np.exp(2j * math.pi / abs(gear.z) * np.arange(abs(gear.z)))[:, None]
    assert of(around(tooth_profile(gear, 2000), abs(gear.z))) == pytest.approx(area, rel=1e-6)
    curves = np.concatenate(
        [bernstein(c.size - 1, np.linspace(0.0, 1.0, 300)) @ c for c in pitch_curves(gear)]
    )
    assert of((curves[None] * turn).ravel()) == pytest.approx(area, rel=1e-6)
    outline = pitch_outline(gear, 1e-6)
    assert of((outline.points[None] * turn).ravel()) == pytest.approx(area, rel=5e-5)
    outside = 1.3 * abs(gear.d_f) if gear.is_internal else 0.0
    solid = gear_solid(gear, 120, 60 if gear.beta else None, bore_diameter=outside)
    volume = float(np.einsum("ij,ij->", solid[:, 0], np.cross(solid[:, 1], solid[:, 2]))) / 6.0
    ring = 0.0
    if gear.is_internal:
        rim = np.abs(solid[:, :, 0] + 1j * solid[:, :, 1]).max()
        assert rim == pytest.approx(0.5 * outside, rel=1e-6)
        ring = abs(volume) / gear.b + area  # area of the polygon of the rim
        assert 0.99 < ring / (math.pi * rim**2) < 1.0
    else:
        assert volume == pytest.approx(area * gear.b, rel=2e-5)


def test_inside_of_a_ring_is_smaller_by_the_corners():
    """What edges take off the solid of an internal gear is what they add to its hole."""
    volumes, areas = [], []
    for edge in (None, *EDGES):
        gear = broken("internal", edge)
        solid = gear_solid(gear, 400, bore_diameter=0.25)
        volumes.append(float(np.einsum("ij,ij->", solid[:, 0], np.cross(solid[:, 1], solid[:, 2]))) / 6.0)
        areas.append(section_integrals(tooth_form(gear))[0])
    for k in (1, 2):
        assert volumes[0] - volumes[k] == pytest.approx((areas[k] - areas[0]) * 0.02, rel=1e-2)


@every_edge
@every_gear
def test_edges_belong_to_the_tip(name, edge):
    gear = broken(name, edge)
    line = gear_line(gear)
    height = gear.sign * np.abs(line.pitch)
    assert np.all(line.part[height > 0.5 * gear.d_Fa + 1e-9 * M] == TIP)
    profile = tooth_profile(gear, 60)
    assert profile.diameters["involute"][1] == pytest.approx(abs(gear.d_Fa))
    assert profile.diameters["tip"] == pytest.approx((abs(gear.d_Fa), abs(gear.d_a)))
    r = np.hypot(*profile.points.T)
    assert np.all((profile.region == 3) == (gear.sign * r > 0.5 * gear.d_Fa + 1e-9 * M))


@every_gear
def test_largest_edges(name):
    """At the limit of the message no tip land is left, or no involute."""
    for key in ("tip_chamfer", "tip_rounding"):
        (problem,) = broken(name).replace(**{key: 4e-3}).problems("gears.a")
        assert problem.where == f"gears.a.{key}"
        assert str(problem).startswith(f"gears.a.{key}: 4.0000 mm is larger than the tip (limit ")
        most = 1e-3 * float(problem.limit.split(" mm")[0])
        inside, outside = (broken(name).replace(**{key: most * f}) for f in (0.999, 1.001))
        assert inside.problems() == []
        assert len(outside.problems()) == 1
        tight = inside.sign * (inside.d_Fa - inside.d_Ff) < 0.02 * M * inside.sign
        assert tooth_form(inside).tip_half_angle * 0.5 * abs(inside.d_a) < 0.01 * M or tight


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"tip_chamfer": -1e-6}, "tip_chamfer"),
        ({"tip_rounding": math.nan}, "tip_rounding"),
        ({"tip_chamfer": True}, "tip_chamfer"),
        ({"tip_rounding": math.inf}, "tip_rounding"),
        ({"tip_chamfer": 1e-4, "tip_rounding": 1e-4}, "cannot be combined with tip_chamfer"),
    ],
)
def test_impossible_sizes_are_refused(given, words):
    with pytest.raises(GeometryError, match=words):
        CylindricalGear(z=30, m_n=M, **given)


def test_a_size_of_zero_is_a_sharp_edge():
    sharp = CylindricalGear(z=30, m_n=M)
    zero = CylindricalGear(z=30, m_n=M, tip_chamfer=0.0, tip_rounding=0.0)
    assert zero.d_Fa == sharp.d_Fa
    np.testing.assert_array_equal(tooth_profile(zero).points, tooth_profile(sharp).points)


@every_edge
def test_path_of_contact_ends_at_the_tip_form_circles(edge):
    one, two = broken("external", edge), CylindricalGear(z=45, m_n=M, tip_chamfer=0.2e-3)
    pair = GearPair.from_profile_shifts(one, two)
    plain = GearPair(
        one.replace(tip_chamfer=None, tip_rounding=None), two.replace(tip_chamfer=None), pair.a_w
    )
    assert pair.T1E == pytest.approx(math.sqrt(one.d_Fa**2 - one.d_b**2) / 2.0, rel=1e-12)
    assert pair.d_Na1 == pytest.approx(one.d_Fa) and pair.d_Na2 == pytest.approx(two.d_Fa)
    assert pair.eps_alpha < plain.eps_alpha - 0.05
    assert pair.c_1 == plain.c_1  # tips reach as far as before
    # reliefs end where the involute ends
    assert flank_range(one)[1] == pytest.approx(pair.T1E)
    relieved = FlankModifications(tip_relief=Relief(amount=20e-6, length=2e-3))
    found = deviation(relieved, one, [pair.T1E, pair.T1E - 2e-3])
    np.testing.assert_allclose(found, [20e-6, 0.0], atol=1e-12)


@pytest.mark.parametrize("sides", ["tooth", "flanks"])
@every_edge
def test_teeth_from_points_have_the_edge_of_their_points(edge, sides):
    """The given edge only says where the involute ends; the points are used as they are."""
    gear = broken("external", edge)
    points = tooth_profile(gear, 200).points
    if sides == "tooth":
        outline = outline_from_tooth(gear, points)
    else:
        r, half, n = tooth_form(gear).flank(120)
        path = (r * np.exp(1j * half))[n:]
        outline = outline_from_flanks(gear, left=np.column_stack([path.real, path.imag]))
    assert abs(outline.gap(gear, "left", np.linspace(*flank_range(gear), 30))).max() < 1e-9
    ring = around(tooth_profile(gear.replace(outline=outline)), gear.z)
    area = 0.5 * float(np.sum((ring.conj() * np.roll(ring, -1)).imag))
    assert area == pytest.approx(section_integrals(tooth_form(gear))[0], rel=2e-5)


def test_broken_edges_leave_more_room_at_the_fillet():
    one, two = CylindricalGear(z=20, m_n=M, x=0.2), CylindricalGear(z=50, m_n=M)
    found = [
        clearances(GearPair.from_profile_shifts(one, two.replace(**extra)))["tip_2_fillet_1"].distance
        for extra in ({}, {"tip_chamfer": 0.2e-3}, {"tip_rounding": 0.3e-3})
    ]
    assert found[0] < found[1] and found[0] < found[2]


# --- contact of broken edges ----------------------------------------------------------------------------
@every_gear
def test_second_edge_of_a_chamfer_touches_after_the_normal_has_turned_to_it(name):
    """Until then the edge at d_Fa is deeper, then, after the angle of the chamfer on the mate, the other.

    Deflections of up to 50 µm turn the normal by less than 0.75 of that, also with 12 teeth: contact is at
    the first edge alone.
    """
    gear, edge = broken(name, "chamfer"), tip_edge(broken(name, "chamfer"))
    internal = gear.is_internal
    mate = CylindricalGear(z=20 if internal else 70, m_n=M, beta=gear.beta if internal else -gear.beta)
    pair = GearPair.from_profile_shifts(*((mate, gear) if internal else (gear, mate)))
    first = pair.T1T2 - pair.T1A if internal else pair.T1E
    before, after = 0, 0
    for eta in np.linspace(1e-5, 12e-3, 400):
        phi1 = turned_to(pair, pair.T1A - eta if internal else pair.T1E + eta)
        both = facing_flanks(Mounting(pair=pair, phi1=phi1), 0)
        here = both.swapped() if internal else both
        gap, _, _, roll, *_, turned = tip_gap(eta, gear.r_b, mate.r_b, first, math.tan(pair.alpha_wt))
        end = edge.end if here.own.side == "left" else edge.end.conjugate()
        end *= np.exp(2j * math.pi * here.own.tooth / abs(gear.z))
        corner = here.mounting.transfer(np.array([end.real, end.imag, 0.0]), here.gear)
        other = float(here.mate.distance(corner)[0]) / math.cos(gear.beta_b)
        if not math.isfinite(gap) or not math.isfinite(other):
            continue
        if turned < edge.arc:
            assert gap < other
            before += 1
        elif turned > edge.arc + abs(edge.end - edge.start) / abs(roll):
            assert other < gap
            after += 1
        assert gap > 0.05e-3 or turned < 0.75 * edge.arc
    assert before > 20
    assert after > 20 or name != "few teeth"


def test_contact_of_a_rounding_starts_with_its_radius():
    """Curvature jumps at E from the flank to the rounding; the gap stays smooth."""
    gear, mate = broken("external", "rounding"), CylindricalGear(z=70, m_n=M)
    pair = GearPair.from_profile_shifts(gear, mate)
    arguments = gear.r_b, mate.r_b, pair.T1E - 0.4e-3, math.tan(pair.alpha_wt)
    gap, by_eta, _, roll, *_, turned = tip_gap(1e-6, *arguments)
    assert gap < 1e-10 and by_eta < 1e-3 and turned < tip_edge(gear).arc
    assert roll - 0.4e-3 == pytest.approx(pair.T1T2 - pair.T1E, rel=1e-3)
