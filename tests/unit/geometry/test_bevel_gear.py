# SPDX-License-Identifier: Apache-2.0
"""Bevel gears: published sizes, identities of cones, the cylindrical limit, what is refused."""

from __future__ import annotations

import math
from math import radians

import numpy as np
import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.bevel.cones import pitch_angles, spherical_involute
from pitchpoint.geometry.bevel.gear import BevelGear
from pitchpoint.geometry.bevel.pair import BevelPair
from pitchpoint.geometry.bevel.tooth import bevel_tooth, placed
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.rack import BasicRack
from pitchpoint.geometry.tooth_form import tooth_form

SHALLOW = 1e-4
"""Cone angle of the cylindrical limit [rad]: its square is what may differ."""


def pair_of(z1=20, z2=40, Sigma=0.5 * math.pi, **sizes):
    """Pair with the same sizes of both gears, opposite hands and opposite shifts."""
    sizes = {"m_et": 3e-3, "b": 22e-3, **sizes}
    beta, shift = sizes.pop("beta_m", 0.0), sizes.pop("x_hm", 0.0)
    one, two = (
        BevelGear.of_outer_module(z=z, delta=delta, beta_m=s * beta, x_hm=s * shift, **sizes)
        for z, delta, s in zip((z1, z2), pitch_angles(z1, z2, Sigma), (1.0, -1.0), strict=True)
    )
    return BevelPair(one, two, Sigma)


def test_published_straight_pair():
    """KHK, Gear technical reference, standard straight bevel gears: m 3, 20/40 teeth, 90°, b 22.

    The tables give the numbers in millimetres and degrees with four or five digits behind the point.
    """
    pair = pair_of()
    one, two = pair.gear1, pair.gear2
    angles = {
        "delta": (26.56505, 63.43495),
        "theta_a": (2.56064, 2.56064),
        "theta_f": (3.19960, 3.19960),
        "delta_a": (29.12569, 65.99559),
        "delta_f": (23.36545, 60.23535),
    }
    lengths = {"d_e": (60.0, 120.0), "d_ae": (65.3666, 122.6833), "t_xo": (58.6584, 27.3167)}
    for name, values in angles.items():
        for gear, value in zip((one, two), values, strict=True):
            assert math.degrees(getattr(gear, name)) == pytest.approx(value, abs=5e-6)
    for name, values in lengths.items():
        for gear, value in zip((one, two), values, strict=True):
            assert 1e3 * getattr(gear, name) == pytest.approx(value, abs=5e-5)
    inner = [2e3 * g.R_i / math.cos(g.theta_a) * math.sin(g.delta_a) for g in (one, two)]
    assert inner == pytest.approx([43.9292, 82.4485], abs=5e-5)
    assert 1e3 * one.R_e == pytest.approx(67.08204, abs=5e-6)
    assert [one.z_v, two.z_v] == pytest.approx([22.3607, 89.4427], abs=5e-5)


def test_published_transverse_pressure_angle_of_a_spiral_gear():
    """KHK, Gear technical reference, spiral bevel gears: 20° normal, 35° spiral."""
    gear = BevelGear(z=20, m_mn=2e-3, delta=0.5, b=5e-3, beta_m=radians(35.0))
    assert math.degrees(gear.alpha_t) == pytest.approx(23.9568, abs=5e-5)


@pytest.mark.parametrize("Sigma", [40.0, 75.0, 90.0, 110.0])
@pytest.mark.parametrize("beta", [0.0, 35.0])
def test_both_base_cones_share_the_plane_of_action(Sigma, beta):
    """sin δ_b / z, the pressure angle at the pitch ray and the rolls agree for both gears."""
    pair = pair_of(17, 31, radians(Sigma), beta_m=radians(beta), b=12e-3)
    one, two = pair.gear1, pair.gear2
    assert one.delta + two.delta == pytest.approx(pair.Sigma, abs=1e-15)
    assert one.R_m == pytest.approx(two.R_m, rel=1e-15)
    assert one.sigma_p == pytest.approx(two.sigma_p, rel=1e-14)
    assert math.tan(one.beta_b) == pytest.approx(one.spiral_rate * math.sin(one.delta_b), abs=1e-15)
    assert one.beta_b == pytest.approx(-two.beta_b, abs=1e-15)
    for gear in (one, two):
        # plane of action and the axial plane of the pitch ray enclose 90° − α_t
        across = math.tan(gear.sigma_w) / math.sin(gear.delta_b)
        assert math.tan(gear.delta_b) == pytest.approx(math.tan(gear.delta) * math.cos(math.atan(across)))
        assert math.sin(gear.delta_b) == pytest.approx(math.sin(gear.delta) * math.cos(gear.alpha_t))
        assert math.cos(gear.delta) == pytest.approx(math.cos(gear.delta_b) * math.cos(gear.sigma_w))


@pytest.mark.parametrize(
    ("z", "beta", "x"),
    [(30, 0.0, 0.0), (20, 0.0, 0.3), (40, 0.0, 0.95), (10, 0.0, 0.0), (25, radians(20.0), 0.1)],
)
def test_a_narrow_cone_is_a_cylindrical_gear(z, beta, x):
    """With R → ∞ the tooth is that of ISO 21771: angles agree to the square of the cone angle.

    The round tip of the tool counts in the section across the cone, so helical fillets are no rack's.
    """
    flat = CylindricalGear(z=z, m_n=1.0, beta=beta, x=x, b=1.0)
    gear = BevelGear(z=z, m_mn=1.0, delta=SHALLOW, b=1.0, beta_m=beta, x_hm=x)
    tooth, form = bevel_tooth(gear), tooth_form(flat)
    assert 2.0 * gear.R_m * math.sin(gear.delta_a) == pytest.approx(flat.d_a, rel=1e-7)
    assert gear.beta_b == pytest.approx(flat.beta_b, rel=1e-12)
    assert gear.psi_b == pytest.approx(flat.psi_b, rel=1e-7)
    assert gear.half_angle_at(gear.delta_a) == pytest.approx(form.tip_half_angle, rel=1e-6)
    assert spherical_involute(gear.sigma_w, gear.delta_b) == pytest.approx(
        math.tan(flat.alpha_t) - flat.alpha_t, rel=1e-6
    )
    if beta == 0.0:
        polar, half = tooth.fillet(np.array([tooth.tau_form]))
        assert 2.0 * gear.R_m * math.sin(polar[0]) == pytest.approx(flat.d_Ff, rel=1e-7)
        assert tooth.undercut == flat.undercut
        assert tooth.root_half_angle == pytest.approx(form.root_half_angle, rel=1e-7)
        between = np.linspace(tooth.tau_root, tooth.tau_form, 9)
        polar, half = tooth.fillet(between)
        theta = np.linspace(form.fillet.theta_root, form.theta_form, 2000)
        radius, angle = form.fillet_polar(theta)
        order = np.argsort(radius)
        expected = np.interp(gear.R_m * np.sin(polar), radius[order], angle[order])
        # chords of the 2000 points lie within 1e-6 of the fillet but for its steep beginning
        assert np.abs(expected - half)[1:].max() < 2e-5


def test_fillets_go_on_where_the_tip_of_the_tool_is_centred_on_its_pitch_plane():
    """A dedendum of ρ_fP* puts the centre there, and the ray from the pitch ray to it has no direction."""
    gear = BevelGear(z=40, m_mn=2e-3, delta=0.7, b=0.01, x_hm=0.87)
    points = []
    for shift in (-1e-7, 0.0, 1e-7):
        tooth = bevel_tooth(gear.replace(x_hm=gear.x_hm + shift))
        points.append(np.stack(tooth.fillet(np.linspace(tooth.tau_root, tooth.tau_form, 5))))
    assert np.abs(points[1] - 0.5 * (points[0] + points[2])).max() < 1e-6


def test_contact_ratios_of_the_cylindrical_limit():
    rack = BasicRack(h_aP_star=1.0, h_fP_star=1.25)
    beta = radians(25.0)
    delta = pitch_angles(21, 34, 3e-4)
    gears = [
        BevelGear(z=z, m_mn=1.0, delta=d, b=10.0, beta_m=s * beta, rack=rack)
        for z, d, s in ((21, delta[0], 1.0), (34, delta[1], -1.0))
    ]
    flat = [CylindricalGear(z=z, m_n=1.0, beta=s * beta, b=10.0) for z, s in ((21, 1.0), (34, -1.0))]
    pair = BevelPair(*gears, 3e-4)
    reference = GearPair(*flat, 0.5 * (flat[0].d + flat[1].d))
    assert pair.eps_alpha == pytest.approx(reference.eps_alpha, rel=1e-6)
    assert pair.eps_beta == pytest.approx(reference.eps_beta, rel=1e-6)
    assert pair.j_mn == pytest.approx(reference.j_bn, abs=1e-9)


def test_teeth_are_logarithmic_spirals():
    """On every cone the teeth cross the rays at β_y, and scaling by λ is a turn by ln λ tan β_m / sin δ."""
    gear = BevelGear(z=20, m_mn=3e-3, delta=0.6, b=0.02, beta_m=radians(-35.0))
    polar, half = bevel_tooth(gear).flank(5, 4)
    step = 1.0 + 1e-7
    for at in (gear.R_i, gear.R_m, gear.R_e):
        here, next_ = placed(gear, polar, half, at), placed(gear, polar, half, at * step)
        along = (next_ - here) / (at * (step - 1.0))
        ray = here / at
        sideways = np.stack([-here[:, 1], here[:, 0], 0.0 * polar], axis=1)
        sideways /= np.linalg.norm(sideways, axis=1, keepdims=True)
        tangent = np.einsum("ij,ij->i", along, sideways) / np.einsum("ij,ij->i", along, ray)
        assert np.arctan(tangent) == pytest.approx([gear.beta_at(p) for p in polar], abs=1e-6)
    assert gear.beta_at(gear.delta) == pytest.approx(gear.beta_m)


def test_outer_and_mean_module_are_one_gear():
    one = BevelGear.of_outer_module(z=20, m_et=3e-3, delta=0.5, b=15e-3, beta_m=0.5)
    assert one.m_et == pytest.approx(3e-3, rel=1e-15)
    again = BevelGear(z=20, m_mn=one.m_mn, delta=0.5, b=15e-3, beta_m=0.5)
    assert again.R_e == pytest.approx(one.R_e, rel=1e-15)


@pytest.mark.parametrize(
    ("changes", "where"),
    [
        ({"z": 2}, "number_of_teeth"),
        ({"z": 20.5}, "number_of_teeth"),
        ({"delta": 1.6}, "pitch_cone_angle"),
        ({"m_mn": math.nan}, "mean_normal_module"),
        ({"b": 0.2}, "face_width"),
        ({"beta_m": 1.6}, "spiral_angle"),
    ],
)
def test_numbers_without_meaning_are_refused(changes, where):
    with pytest.raises(GeometryError) as caught:
        BevelGear(**{"z": 20, "m_mn": 3e-3, "delta": 0.5, "b": 0.02, **changes})
    assert caught.value.problem.where == where


@pytest.mark.parametrize(
    ("changes", "where"),
    [
        ({"x_hm": 1.0, "z": 12}, "profile_shift_coefficient"),
        ({"x_hm": 1.3}, "profile_shift_coefficient"),
        ({"rack": BasicRack(h_fP_star=2.4)}, "rack.dedendum"),
        ({"x_sm": -0.9}, "thickness_modification_coefficient"),
    ],
)
def test_gears_that_cannot_be_made_are_listed(changes, where):
    gear = BevelGear(**{"z": 20, "m_mn": 3e-3, "delta": 0.5, "b": 0.01, **changes})
    (told,) = gear.problems("gears.a")
    assert told.where == f"gears.a.{where}" and None not in (told.value, told.limit, told.remedy)


def test_the_deepest_tool_is_told_and_works():
    """A crown gear that ends in an edge: just above its depth the teeth of the tool are pointed."""
    gear = BevelGear(z=20, m_mn=3e-3, delta=0.5, b=0.01, x_hm=0.2)
    (told,) = gear.replace(rack=BasicRack(h_fP_star=2.4)).problems()
    assert "beyond the point of the tool" in told.text
    deepest = float(told.limit)
    for depth, works in ((deepest - 1e-3, True), (deepest + 1e-3, False)):
        problems = gear.replace(rack=BasicRack(h_fP_star=depth)).problems()
        assert ("rack.dedendum" not in [p.where for p in problems]) == works


def test_pairs_that_do_not_fit_are_listed():
    pair = pair_of(beta_m=0.5)
    assert pair.problems() == []
    same_hand = BevelPair(pair.gear1, pair.gear2.replace(beta_m=0.5), pair.Sigma)
    assert "opposite hands" in str(same_hand.problems("stage")[0])
    flatter = BevelPair(pair.gear1, pair.gear2.replace(beta_m=-0.4), pair.Sigma)
    assert "unequal spiral angles" in str(flatter.problems("stage")[0])
    steeper = BevelPair(pair.gear1, pair.gear2.replace(alpha_n=radians(25.0)), pair.Sigma)
    assert "pressure angles" in str(steeper.problems()[0])
    apart = BevelPair(pair.gear1, pair.gear2.replace(m_mn=1e-3, b=1e-3), pair.Sigma)
    assert "no face in common" in str(apart.problems()[0])
    short = BevelPair(
        *(g.replace(rack=BasicRack(h_aP_star=0.4)) for g in (pair.gear1, pair.gear2)), pair.Sigma
    )
    assert short.problems() == []
    under = pair_of(13, 40, b=5e-3)
    (told,) = under.warnings("", ("p", "w"))
    assert told.value == "tip of w" and told.text.endswith("root form cone of p (undercut)")
    low, start = (float(x.split()[0]) for x in told.limit.split(", contact would start at "))
    base = math.cos(under.gear1.delta_b)
    assert math.cos(radians(low)) == pytest.approx(base * math.cos(under.gear1.sigma_Ff), rel=1e-6)
    assert under.sigma_A < 0.0 and math.cos(radians(start)) == pytest.approx(base, rel=1e-6)
    usable = (under.sigma_E - under.gear1.sigma_Ff) / under.sigma_p
    assert f"contact ratio left is {usable:.4g}; " in told.remedy and usable < under.eps_alpha
    few = pair_of(7, 9, b=5e-3)
    assert any("beyond the base cone" in str(p) for p in few.problems())


@pytest.mark.parametrize(("z1", "z2", "Sigma"), [(20, 40, 180.0), (20, 40, 0.0), (10, 40, 150.0)])
def test_shaft_angles_without_external_cones_are_refused(z1, z2, Sigma):
    with pytest.raises(GeometryError) as caught:
        pitch_angles(z1, z2, radians(Sigma))
    assert caught.value.problem.where == "shaft_angle"


@pytest.mark.parametrize(
    ("changes", "key"),
    [
        ({"thickness_allowance": -10e-3}, "tooth_thickness_allowance"),
        ({"thickness_allowance": -2.5e-3}, "tooth_thickness_allowance"),
        ({"x_sm": 1.0}, "thickness_modification_coefficient"),
        ({"x_hm": 1.1}, "profile_shift_coefficient"),
    ],
)
def test_what_makes_teeth_too_thin_or_spaces_too_narrow_is_named(changes, key):
    gear = BevelGear(z=20, m_mn=2.5e-3, delta=0.5, b=15e-3).replace(**changes)
    (told,) = gear.problems() or gear.warnings()  # a thin tip can be made
    assert told.where == key and None not in (told.value, told.limit, told.remedy)
