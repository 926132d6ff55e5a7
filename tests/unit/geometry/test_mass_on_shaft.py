# SPDX-License-Identifier: Apache-2.0
"""Part of a gear outside its shaft: sums of cylinders and teeth integrated over the radius."""

from __future__ import annotations

import math
from dataclasses import astuple

import numpy as np
import pytest
from scipy.integrate import quad

from pitchpoint.geometry.bevel.blank import bevel_blank, bevel_mass, revolved, toothed
from pitchpoint.geometry.bevel.gear import BevelGear
from pitchpoint.geometry.bevel.tooth import bevel_tooth
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.mass_properties import gear_mass_properties
from pitchpoint.geometry.tooth_form import tooth_form, tooth_profile
from pitchpoint.geometry.tooth_outline import outline_from_tooth

RHO = 7800.0
GEAR = CylindricalGear(z=40, m_n=3e-3, beta=0.2, b=0.03)
RING = CylindricalGear(z=-60, m_n=3e-3, b=0.03)
BEVEL = BevelGear.of_outer_module(z=20, m_et=3e-3, delta=math.atan(0.5), b=22e-3)
PIECE = (-1.0, 1.0, 0.05, 0.0)


def cylinder(d: float, low: float, high: float, bore: float = 0.0) -> np.ndarray:
    """Volume and its integrals of z, z^2 and r^2."""
    area, length = math.pi / 4.0 * (d**2 - bore**2), high - low
    return np.array(
        [
            area * length,
            area * (high**2 - low**2) / 2.0,
            area * (high**3 - low**3) / 3.0,
            area * length * (d**2 + bore**2) / 8.0,
        ]
    )


def integrals(found, density: float = RHO) -> np.ndarray:
    """Volume and its integrals of z, z^2 and r^2 from mass, centre and central moments."""
    volume = found.mass / density
    return np.array(
        [
            volume,
            volume * found.center,
            (found.transverse_inertia - 0.5 * found.polar_inertia) / density + volume * found.center**2,
            found.polar_inertia / density,
        ]
    )


def agree(found, wanted: np.ndarray, rel: float = 1e-12) -> None:
    size = abs(wanted[0]) ** (1.0 / 3.0)
    scale = abs(wanted[0]) * size ** np.array([0.0, 1.0, 2.0, 2.0])
    np.testing.assert_allclose(integrals(found) / scale, wanted / scale, rtol=rel, atol=rel)


@pytest.mark.parametrize(
    "shaft",
    [
        [(-1.0, 1.0, 0.05, 0.0)],
        [(-1.0, 1.0, 0.05, 0.02)],  # the hole of the shaft stays open
        [(-0.1, -0.005, 0.04, 0.0), (-0.005, 0.2, 0.07, 0.0)],  # a step under the gear
        [(-0.1, 0.004, 0.05, 0.0)],  # partly beyond the end
        [(-0.1, -0.02, 0.09, 0.0), (-0.02, 0.1, 0.03, 0.0)],  # a collar beside it
    ],
    ids=["through", "hollow", "stepped", "end", "collar"],
)
def test_a_gear_on_a_shaft_is_the_gear_less_cylinders(shaft) -> None:
    half = 0.5 * GEAR.b
    less = [cylinder(d, max(a, -half), min(b, half)) for a, b, d, _ in shaft if max(a, -half) < min(b, half)]
    whole = integrals(gear_mass_properties(GEAR, RHO))
    agree(gear_mass_properties(GEAR, RHO, shaft=shaft), whole - sum(less))
    ends = np.linspace(0.0, 1.0, 8)
    pieces = [
        (a + (b - a) * s, a + (b - a) * t, d, h)
        for a, b, d, h in shaft
        for s, t in zip(ends[:-1], ends[1:], strict=True)
    ]
    agree(gear_mass_properties(GEAR, RHO, shaft=pieces), whole - sum(less))


def test_a_bore_of_the_size_of_the_shaft_is_the_same_and_a_larger_one_leaves_a_gap() -> None:
    for bore, d in ((0.05, 0.05), (0.06, 0.05), (0.06, 0.06)):
        bored = gear_mass_properties(GEAR, RHO, bore_diameter=bore)
        for given in (bore, 0.0) if bore == d else (bore,):
            seated = gear_mass_properties(GEAR, RHO, bore_diameter=given, shaft=[(-1.0, 1.0, d, 0.0)])
            assert astuple(seated) == pytest.approx(astuple(bored), rel=1e-12)
    tight = gear_mass_properties(GEAR, RHO, bore_diameter=0.04, shaft=[PIECE])
    wanted = astuple(gear_mass_properties(GEAR, RHO, shaft=[PIECE]))
    assert astuple(tight) == pytest.approx(wanted, rel=1e-12)


@pytest.mark.parametrize("d", [0.05, 0.09])
def test_rim_and_web_on_a_shaft(d: float) -> None:
    """Root diameter 115.0 mm, rim 10 mm thick: the web ends at 95 mm; the web is 8 mm thick."""
    size = {"rim_thickness": 10e-3, "web_thickness": 8e-3}
    whole = integrals(gear_mass_properties(GEAR, RHO, **size))
    agree(
        gear_mass_properties(GEAR, RHO, **size, shaft=[(-1.0, 1.0, d, 0.0)]), whole - cylinder(d, -4e-3, 4e-3)
    )
    inner = GEAR.d_fE - 20e-3
    wide = gear_mass_properties(GEAR, RHO, **size, shaft=[(-1.0, 1.0, inner + 6e-3, 0.0)])
    rim = cylinder(inner + 6e-3, -0.015, 0.015, inner)
    agree(wide, whole - cylinder(inner, -4e-3, 4e-3) - rim)


@pytest.mark.parametrize("measured", [False, True])
def test_a_shaft_in_the_teeth_leaves_their_outer_part(measured: bool) -> None:
    form, gear = tooth_form(GEAR), GEAR
    if measured:
        gear = GEAR.replace(outline=outline_from_tooth(GEAR, tooth_profile(GEAR, 600).points))
    r = form.r_Ff + 0.6 * (form.r_a - form.r_Ff)

    def width(x: float) -> float:
        return 2.0 * GEAR.z * float(form.involute_half_angle(x)) * x

    area = quad(width, r, form.r_a, epsabs=1e-14)[0]
    polar = quad(lambda x: width(x) * x * x, r, form.r_a, epsabs=1e-16)[0]
    found = gear_mass_properties(gear, RHO, shaft=[(-1.0, 1.0, 2.0 * r, 0.0)])
    assert found.mass == pytest.approx(RHO * area * GEAR.b, rel=2e-6)
    assert found.polar_inertia == pytest.approx(RHO * polar * GEAR.b, rel=2e-6)
    assert found.transverse_inertia == pytest.approx(
        0.5 * found.polar_inertia + found.mass * GEAR.b**2 / 12.0, rel=1e-12
    )
    just = gear_mass_properties(gear, RHO, shaft=[(-1.0, 1.0, 2.0 * form.r_f * (1.0 - 1e-9), 0.0)])
    over = gear_mass_properties(gear, RHO, shaft=[(-1.0, 1.0, 2.0 * form.r_f * (1.0 + 1e-9), 0.0)])
    assert over.mass == pytest.approx(just.mass, rel=1e-5)  # points of the fillet


@pytest.mark.parametrize("d", [0.126, 0.2])
def test_a_gear_inside_its_shaft_adds_nothing(d: float) -> None:
    assert GEAR.d_a < 0.1286 < 0.2
    found = gear_mass_properties(GEAR, RHO, shaft=[(-1.0, 1.0, max(d, GEAR.d_a), 0.0)])
    assert astuple(found) == (0.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize("profile", ["mean_cylinder", "reference_cylinder"])
def test_cylinders_for_teeth_on_a_shaft(profile: str) -> None:
    d = GEAR.d if profile == "reference_cylinder" else 0.5 * (GEAR.d_a + GEAR.d_f)
    found = gear_mass_properties(
        GEAR, RHO, profile=profile, shaft=[(-1.0, 0.0, 0.05, 0.0), (0.0, 1.0, 0.12, 0.0)]
    )
    agree(found, cylinder(d, -0.015, 0.015) - cylinder(0.05, -0.015, 0.0) - cylinder(0.12, 0.0, 0.015))


def test_an_internal_gear_loses_only_what_is_in_the_wall_of_its_shaft() -> None:
    """Root diameter 187.5 mm, outside 210 mm: a cup of 200/240 mm overlaps 5 mm of the ring."""
    whole = integrals(gear_mass_properties(RING, RHO, bore_diameter=0.21))
    free = gear_mass_properties(RING, RHO, bore_diameter=0.21, shaft=[(-1.0, 1.0, 0.05, 0.0)])
    agree(free, whole)
    for wall in (0.24, 0.206):
        found = gear_mass_properties(RING, RHO, bore_diameter=0.21, shaft=[(-0.1, 0.005, wall, 0.2)])
        agree(found, whole - cylinder(min(wall, 0.21), -0.015, 0.005, 0.2))


def test_a_bevel_gear_on_a_shaft() -> None:
    """The blank of this gear reaches from 35.3 mm to 64.7 mm from the apex."""
    blank = bevel_blank(BEVEL, 0.0, None)
    low, high = blank.toe[1], blank.back[1]
    whole = integrals(bevel_mass(BEVEL, RHO))
    for shaft in (
        [(-1.0, 1.0, 0.02, 0.0)],
        [(-1.0, 0.05, 0.02, 0.01), (0.05, 1.0, 0.012, 0.0)],
        [(0.04, 1.0, 0.02, 0.0)],
        [(-1.0, 0.03, 0.2, 0.0), (0.03, 1.0, 0.01, 0.0)],
    ):
        less = [cylinder(d, max(a, low), min(b, high)) for a, b, d, _ in shaft if max(a, low) < min(b, high)]
        agree(bevel_mass(BEVEL, RHO, shaft=shaft), whole - sum(less), 1e-11)
    bored = bevel_mass(BEVEL, RHO, bore_diameter=0.02)
    assert astuple(bevel_mass(BEVEL, RHO, shaft=[(0.0, 1.0, 0.02, 0.0)])) == pytest.approx(astuple(bored))
    assert bevel_mass(BEVEL, RHO, shaft=[(0.0, 1.0, 0.2, 0.0)]).mass == 0.0


def test_a_thick_shaft_through_a_bevel_gear() -> None:
    """All of the gear against the sum over a fine grid of radii and heights, with the angle of the teeth."""
    cone, tooth = BEVEL.delta, bevel_tooth(BEVEL)
    r, outer = 0.018, 0.036
    assert bevel_blank(BEVEL, 0.0, None).toe[0] < r
    polar = np.concatenate(
        [
            np.column_stack(tooth.fillet(np.linspace(tooth.tau_root, tooth.tau_form, 2000))),
            np.column_stack(tooth.involute(np.linspace(tooth.sigma_form, BEVEL.sigma_a, 2000))),
        ]
    )
    n = 1200
    angle = np.linspace(polar[0, 0], polar[-1, 0], n + 1)
    angle = 0.5 * (angle[1:] + angle[:-1])
    half = np.interp(angle, polar[:, 0], polar[:, 1])
    shares = (np.arange(n) + 0.5) / n
    length = (BEVEL.R_e - BEVEL.R_i) / np.cos(angle - cone)
    R = BEVEL.R_i / np.cos(angle - cone) + shares[:, None] * length
    radius, height = R * np.sin(angle), R * np.cos(angle)
    cell = 2.0 * BEVEL.z * half * np.sin(angle) * R**2 * length / n * (polar[-1, 0] - polar[0, 0]) / n
    assert float(cell.sum()) == pytest.approx(toothed(BEVEL)[0], rel=1e-4)
    inside = cell * ((radius < r) & (height < 0.05))
    assert 0.0 < inside.sum() < 0.5 * cell.sum()
    found = toothed(BEVEL, (-1.0, 0.05, outer, 0.0))
    terms = (np.ones_like(R), height, height**2, radius**2)
    np.testing.assert_allclose(found, [float((inside * t).sum()) for t in terms], rtol=2e-3)
    toe, heel, back, _, _ = bevel_blank(BEVEL, 0.0, None).corners
    slope = (heel[0] - toe[0]) / (heel[1] - toe[1])
    neck = toe[1] + (r - toe[0]) / slope  # where the root cone leaves the shaft
    assert neck < 0.05 < back[1]
    frustum = revolved([(0.0, toe[1]), toe, (r, neck), (0.0, neck)][::-1])
    less = abs(frustum) + cylinder(outer, neck, 0.05) + found
    whole = integrals(bevel_mass(BEVEL, RHO))
    agree(bevel_mass(BEVEL, RHO, shaft=[(-1.0, 0.05, outer, 0.0)]), whole - less, 1e-11)
