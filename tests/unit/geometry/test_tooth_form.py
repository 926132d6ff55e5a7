# SPDX-License-Identifier: Apache-2.0
"""The tooth profile against identities, the numeric envelope of the tool, and printed form diameters."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.mass_properties import section_integrals
from pitchpoint.geometry.rack import BasicRack
from pitchpoint.geometry.rack_fillet import RackFillet
from pitchpoint.geometry.tooth_form import REGIONS, gear_outline, tooth_form, tooth_profile

EXTERNAL = {
    "z24 helical": CylindricalGear(z=24, m_n=14e-3, beta=math.radians(10.0), x=0.48, b=0.36),
    "z17": CylindricalGear(z=17, m_n=1e-3, x=0.1),
    "z17 just undercut": CylindricalGear(z=17, m_n=1e-3),
    "z10 undercut": CylindricalGear(z=10, m_n=1e-3),
    "z8 undercut helical": CylindricalGear(z=8, m_n=1e-3, beta=0.35),
    "sharp tool": CylindricalGear(z=25, m_n=1e-3, rack=BasicRack(rho_fP_star=0.0)),
    "full rounding": CylindricalGear(z=20, m_n=1e-3, x=0.2, rack=BasicRack(rho_fP_star=1.0)),
    "thin teeth": CylindricalGear(z=30, m_n=2e-3, beta=-0.3, thickness_allowance=-2e-4),
    "large shift": CylindricalGear(z=20, m_n=1e-3, x=1.0),
    "own root": CylindricalGear(z=30, m_n=1e-3, root_diameter=27.2e-3),
}
INTERNAL = {
    "ring": CylindricalGear(z=-56, m_n=45e-3, x=-0.5013, rack=BasicRack(rho_fP_star=0.3)),
    "helical ring": CylindricalGear(z=-72, m_n=2e-3, beta=0.2),
    "tip inside the base circle": CylindricalGear(z=-30, m_n=1e-3),
}


def tool_distance(gear: CylindricalGear, fillet: RackFillet, r: float, delta: float) -> float:
    """Least value of the ellipse of the tool's rounding at a gear point over all positions; 0 = touched."""
    a, b = fillet.rho / fillet.cos_beta, fillet.rho
    point = r * np.exp(1j * (0.5 * math.pi - delta))

    def inside(turn: float) -> float:
        # The gear turned clockwise by `turn`, the rack rolled along without slip.
        here = point * np.exp(-1j * turn)
        across = (here.real - 0.5 * gear.d * turn - fillet.x_c / fillet.cos_beta) / a
        height = (here.imag - 0.5 * gear.d + fillet.depth_c) / b
        return across * across + height * height - 1.0

    grid = np.linspace(-1.5, 1.5, 601)
    best = grid[np.argmin([inside(t) for t in grid])]
    found = minimize_scalar(
        inside, bounds=(best - 0.005, best + 0.005), method="bounded", options={"xatol": 1e-12}
    )
    return float(found.fun)


@pytest.mark.parametrize("name", [n for n in EXTERNAL if n != "sharp tool"])
def test_every_fillet_point_is_touched_and_never_cut_by_the_tool(name: str) -> None:
    gear = EXTERNAL[name]
    form = tooth_form(gear)
    for theta in np.linspace(form.fillet.theta_root - 1e-9, form.theta_form, 9):
        r, delta = (float(v) for v in form.fillet.polar(theta))
        assert abs(tool_distance(gear, form.fillet, r, delta)) < 1e-9


@pytest.mark.parametrize("name", list(EXTERNAL))
def test_tool_flank_envelops_the_involute(name: str) -> None:
    gear = EXTERNAL[name]
    form = tooth_form(gear)
    normal = np.exp(-1j * gear.alpha_t)
    turn = np.linspace(-1.2, 1.2, 20001)
    for r in np.linspace(form.r_Ff, form.r_a, 7):
        delta = form.half_pitch_angle - float(form.involute_half_angle(r))
        here = r * np.exp(1j * (0.5 * math.pi - delta - turn)) - 0.5j * gear.d
        offset = here - 0.5 * gear.d * turn - 0.5 * gear.e_t
        distance = offset.real * normal.real + offset.imag * normal.imag
        # The endless straight line cuts the gear far away; where it touches, the distance has a minimum.
        lowest = (distance[1:-1] < distance[:-2]) & (distance[1:-1] <= distance[2:])
        assert np.abs(distance[1:-1][lowest]).min() < 2e-8 * abs(gear.d)


@pytest.mark.parametrize("gear", [*EXTERNAL.values(), *INTERNAL.values()], ids=[*EXTERNAL, *INTERNAL])
def test_identities_of_the_profile(gear: CylindricalGear) -> None:
    form = tooth_form(gear)
    r = 0.5 * abs(gear.d)
    if form.sign * form.r_Ff < form.sign * r < form.sign * form.r_a:
        assert 2.0 * r * float(form.involute_half_angle(r)) == pytest.approx(gear.s_t, rel=1e-13)
    assert float(form.fillet.polar(form.fillet.theta_root)[0]) == pytest.approx(
        0.5 * abs(gear.d_fE), rel=1e-14
    )
    assert 2.0 * form.r_Ff == pytest.approx(abs(gear.d_Ff), rel=1e-12)
    assert form.is_undercut == gear.undercut
    r_end, angle = form.fillet_polar(form.theta_form)
    assert float(r_end) == pytest.approx(form.r_Ff, rel=1e-13)
    assert float(angle) == pytest.approx(float(form.involute_half_angle(form.r_Ff)), abs=1e-13)


@pytest.mark.parametrize("gear", [*EXTERNAL.values(), *INTERNAL.values()], ids=[*EXTERNAL, *INTERNAL])
def test_fillet_touches_root_circle_and_involute(gear: CylindricalGear) -> None:
    form = tooth_form(gear)
    fillet, h = form.fillet, 1e-6 * (form.theta_form - form.fillet.theta_root)

    def slope(theta: float) -> float:
        (r0, a0), (r1, a1) = form.fillet_polar(theta - h), form.fillet_polar(theta + h)
        return math.atan2(float(r1 * a1 - r0 * a0), float(r1 - r0)) % math.pi

    if fillet.rho > 0.0:
        (r0, a0), (r1, a1) = form.fillet_polar(fillet.theta_root), form.fillet_polar(fillet.theta_root + h)
        assert abs(float(r1 - r0)) < 1e-5 * abs(float(a1 - a0)) * form.r_f
    if not form.is_undercut:
        # d(half angle)/dr of the involute is -sign tan(alpha)/r
        tan_alpha = math.sqrt((form.r_Ff / form.r_b) ** 2 - 1.0)
        r0, a0 = (float(v) for v in form.fillet_polar(form.theta_form - 2.0 * h))
        r1, a1 = (float(v) for v in form.fillet_polar(form.theta_form))
        assert (a1 - a0) * form.r_Ff / (r1 - r0) == pytest.approx(-form.sign * tan_alpha, abs=2e-4)


def test_undercut_begins_at_the_known_number_of_teeth() -> None:
    # z_min = 2 h_FfP* / sin^2 alpha_t of a spur gear without shift: 17.097 for the ISO 53 profile A
    assert tooth_form(CylindricalGear(z=17, m_n=1e-3)).is_undercut
    assert not tooth_form(CylindricalGear(z=18, m_n=1e-3)).is_undercut
    limit = CylindricalGear(z=12, m_n=1e-3).x_min
    assert tooth_form(CylindricalGear(z=12, m_n=1e-3, x=limit - 1e-4)).is_undercut
    assert not tooth_form(CylindricalGear(z=12, m_n=1e-3, x=limit + 1e-4)).is_undercut


def test_form_diameter_is_continuous_at_the_undercut_limit() -> None:
    limit = CylindricalGear(z=12, m_n=1e-3).x_min
    for step in (-1e-7, 1e-7):
        form = tooth_form(CylindricalGear(z=12, m_n=1e-3, x=limit + step))
        assert form.r_Ff == pytest.approx(form.r_b, rel=1e-6)


def test_printed_diameters_of_the_5mw_gearbox() -> None:
    """KISSsoft 03/2017, stage 3 and the ring of stage 1 (printed to 1 µm)."""
    for z, x, d_f, d_Ff in ((24, 0.4800, 319.623, 328.991), (95, 0.6691, 1334.252, 1341.487)):
        form = tooth_form(
            CylindricalGear(z=z, m_n=14e-3, beta=math.radians(10.0), x=x, tip_alteration=-0.938e-3)
        )
        assert 2e3 * form.r_f == pytest.approx(d_f, abs=2e-3)
        assert 2e3 * form.r_Ff == pytest.approx(d_Ff, abs=2e-3)


@pytest.mark.parametrize("gear", [*EXTERNAL.values(), *INTERNAL.values()], ids=[*EXTERNAL, *INTERNAL])
def test_polygon_converges_to_the_boundary_integrals(gear: CylindricalGear) -> None:
    exact = np.array(section_integrals(tooth_form(gear)))
    errors = []
    for n in (100, 400):
        x, y = gear_outline(gear, n).T
        cross = x[:-1] * y[1:] - x[1:] * y[:-1]
        squares = x[:-1] ** 2 + x[:-1] * x[1:] + x[1:] ** 2 + y[:-1] ** 2 + y[:-1] * y[1:] + y[1:] ** 2
        errors.append(np.array([cross.sum() / 2.0, (cross * squares).sum() / 12.0]) / exact - 1.0)
    assert np.abs(errors[1]).max() < 1e-5
    assert (np.abs(errors[1]) < 0.1 * np.abs(errors[0]) + 1e-9).all()


def test_outline_is_closed_counter_clockwise_and_periodic() -> None:
    gear = EXTERNAL["z17"]
    outline = gear_outline(gear, 12)
    assert (outline[0] == outline[-1]).all()
    n = (len(outline) - 1) // gear.z
    turn = 2.0 * math.pi / gear.z
    turned = outline[:n] @ np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]])
    assert np.allclose(turned, outline[n : 2 * n], atol=1e-15)


def test_profile_names_its_regions() -> None:
    profile = tooth_profile(EXTERNAL["z17"], 30)
    radius = np.hypot(*profile.points.T)
    for k, name in enumerate(REGIONS):
        low, high = sorted(0.5 * d for d in profile.diameters[name])
        inside = radius[profile.region == k]
        assert inside.size > 0
        assert inside.min() >= low * (1.0 - 1e-12)
        assert inside.max() <= high * (1.0 + 1e-12)
    assert len(tooth_profile(EXTERNAL["full rounding"], 30).points) < len(profile.points)


@pytest.mark.parametrize(
    ("gear", "where"),
    [
        (CylindricalGear(z=20, m_n=1e-3, x=2.2), "tip_diameter"),
        (CylindricalGear(z=20, m_n=1e-3, rack=BasicRack(h_fP_star=3.0)), "root_diameter"),
        (CylindricalGear(z=20, m_n=1e-3, tip_diameter=18.8e-3), "root_form_diameter"),
    ],
)
def test_impossible_teeth_are_refused(gear: CylindricalGear, where: str) -> None:
    with pytest.raises(GeometryError) as caught:
        tooth_form(gear)
    assert caught.value.problem.where == where


def test_too_few_points_are_refused() -> None:
    with pytest.raises(GeometryError, match="drawing_resolution"):
        gear_outline(EXTERNAL["z17"], 4)
