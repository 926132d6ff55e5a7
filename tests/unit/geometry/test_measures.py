# SPDX-License-Identifier: Apache-2.0
"""Tooth thickness, span and dimension over balls: identities between them, and what cannot be measured."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry import (
    CylindricalGear,
    ball_contact_diameter,
    chordal_thickness,
    dimension_over_balls,
    dimension_over_pins,
    helix_angle_at,
    ideal_ball_diameter,
    normal_space_width,
    normal_tooth_thickness,
    radial_dimension_over_ball,
    span,
    span_contact_diameter,
    span_tooth_count,
    transverse_tooth_thickness,
)

GEARS = [
    CylindricalGear(z=24, m_n=3e-3, x=0.3),
    CylindricalGear(z=25, m_n=3e-3, beta=0.4, x=-0.2),
    CylindricalGear.internal(z=61, m_n=3e-3, x=0.1),
    CylindricalGear.internal(z=60, m_n=3e-3, beta=-0.3, x=-0.3),
]
every_gear = pytest.mark.parametrize("gear", GEARS, ids=["spur", "helical", "internal", "internal helical"])


@every_gear
def test_tooth_and_space_fill_the_pitch_on_every_circle(gear):
    for d_y in (gear.d, gear.d_a, 0.5 * (gear.d + gear.d_a)):
        pitch = math.pi * d_y / gear.z * math.cos(helix_angle_at(gear, d_y))
        both = normal_tooth_thickness(gear, d_y) + normal_space_width(gear, d_y)
        assert both == pytest.approx(pitch, rel=1e-13)
    assert normal_tooth_thickness(gear, gear.d) == pytest.approx(gear.s_n, rel=1e-12)


@every_gear
def test_thickness_on_the_base_circle_is_its_half_angle(gear):
    assert transverse_tooth_thickness(gear, gear.d_b) == pytest.approx(gear.d_b * gear.psi_b, rel=1e-13)


@every_gear
def test_span_agrees_with_the_formula_of_the_standard(gear):
    k = span_tooth_count(gear)
    z, x = abs(gear.z), gear.x * gear.sign
    inv_t = math.tan(gear.alpha_t) - gear.alpha_t
    formula = gear.m_n * math.cos(gear.alpha_n) * ((k - 0.5) * math.pi + z * inv_t)
    formula += 2.0 * x * gear.m_n * math.sin(gear.alpha_n)
    assert span(gear, k) == pytest.approx(formula, rel=1e-12)
    inner, outer = sorted((abs(gear.d_a), abs(gear.d_f)))
    assert inner < abs(span_contact_diameter(gear, k)) < outer


@every_gear
def test_ideal_ball_touches_at_its_diameter(gear):
    D_M = ideal_ball_diameter(gear)
    assert ball_contact_diameter(gear, D_M) == pytest.approx(gear.d + 2 * gear.x * gear.m_n, rel=1e-10)


@every_gear
def test_ball_and_pin_measures_follow_from_the_radial_one(gear):
    D_M = 1.75 * gear.m_n
    radial = radial_dimension_over_ball(gear, D_M)
    assert dimension_over_pins(gear, D_M) >= dimension_over_balls(gear, D_M) or gear.is_internal
    if gear.z % 2 == 0:
        assert dimension_over_balls(gear, D_M) == pytest.approx(2.0 * radial, rel=1e-14)
    else:
        ball = -D_M if gear.is_internal else D_M
        across = (2.0 * radial - ball) * math.cos(0.5 * math.pi / gear.z) + ball
        assert dimension_over_balls(gear, D_M) == pytest.approx(across, rel=1e-14)


@every_gear
def test_thinner_teeth_shrink_external_and_widen_internal_measures(gear):
    thin = gear.replace(thickness_allowance=-50e-6)
    k = span_tooth_count(gear)
    change = span(thin, k) - span(gear, k)
    assert change == pytest.approx(-gear.sign * 50e-6 * math.cos(gear.alpha_n), rel=1e-9)
    assert (dimension_over_balls(thin, 5e-3) - dimension_over_balls(gear, 5e-3)) * gear.sign < 0.0


def test_chord_is_shorter_than_the_arc():
    gear = GEARS[1]
    chord, height = chordal_thickness(gear)
    assert gear.s_n * (1.0 - 0.01) < chord < gear.s_n
    assert height > 0.5 * (gear.d_a - gear.d)


def test_what_cannot_be_measured_is_refused():
    gear = GEARS[0]
    with pytest.raises(GeometryError, match="inside the base circle"):
        transverse_tooth_thickness(gear, 0.9 * gear.d_b)
    with pytest.raises(GeometryError, match="inside the base circle"):
        transverse_tooth_thickness(gear, -gear.d)
    for k in (0, 2.5, True):
        with pytest.raises(GeometryError, match="spanned"):
            span(gear, k)
    for ball in (0.0, math.nan):
        with pytest.raises(GeometryError, match="D_M"):
            dimension_over_balls(gear, ball)


@every_gear
def test_balls_that_miss_the_flanks_are_refused(gear):
    """Too small: on the root fillets, or deeper than the base circle. Too large: on the tips."""
    for factor, remedy in ((0.05, "larger"), (0.5, "larger"), (4.0, "smaller"), (10.0, "smaller")):
        with pytest.raises(GeometryError, match=f"usable flanks.*use a {remedy} ball"):
            dimension_over_balls(gear, factor * gear.m_n)
