# SPDX-License-Identifier: Apache-2.0
"""Generated gears and pairs: identities of the geometry, and nothing but our own errors for any numbers."""

from __future__ import annotations

import dataclasses
import math
from functools import cached_property

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from pitchpoint.core.errors import PitchpointError
from pitchpoint.geometry import (
    BasicRack,
    CylindricalGear,
    GearPair,
    base_helix_angle,
    dimension_over_balls,
    ideal_ball_diameter,
    inv,
    inverse_inv,
    loss_factor_integral,
    profile_shift_for_center_distance,
    span,
    span_tooth_count,
    specific_sliding,
    tip_thickness,
    transverse_pressure_angle,
)

angles = st.floats(math.radians(14.0), math.radians(28.0))
helices = st.floats(math.radians(-40.0), math.radians(40.0))
shifts = st.floats(-0.2, 0.5)


@st.composite
def gears(draw):
    """A usual external gear."""
    return CylindricalGear(
        z=draw(st.integers(18, 120)),
        m_n=draw(st.floats(5e-4, 0.05)),
        alpha_n=draw(angles),
        beta=draw(helices),
        x=draw(shifts),
        b=draw(st.floats(1e-3, 0.5)),
        rack=BasicRack(h_aP_star=draw(st.floats(0.6, 1.1)), h_fP_star=1.4, rho_fP_star=0.2),
    )


@st.composite
def pairs(draw, internal=None):
    """A usual pair at or near its centre distance without backlash; external, internal, or (None) either."""
    first = draw(gears())
    inside = draw(st.booleans()) if internal is None else internal
    second = first.replace(
        z=-(first.z + draw(st.integers(12, 80))) if inside else draw(st.integers(18, 120)),
        x=draw(st.floats(-0.3, 0.02)) - first.x if inside else draw(shifts),
        beta=first.beta if inside else -first.beta,
    )
    pair = GearPair.from_profile_shifts(first, second)
    return pair.at_center_distance(pair.a_w + draw(st.floats(0.0, 0.02)) * first.m_n)


def quantities(thing):
    """Every public property of a gear or pair, or the error that says why there is none."""
    for name in dir(type(thing)):
        if not name.startswith("_") and isinstance(getattr(type(thing), name), property | cached_property):
            try:
                yield name, getattr(thing, name)
            except PitchpointError:
                yield name, None


@given(st.floats(1e-6, 1.55))
def test_inverse_involute(alpha):
    assert inverse_inv(inv(alpha)) == pytest.approx(alpha, rel=1e-12)


@given(angles, helices)
def test_normal_and_transverse_section_are_one_gear(alpha_n, beta):
    """The normal base pitch is the transverse one seen across the base helix, from either side."""
    alpha_t, beta_b = transverse_pressure_angle(alpha_n, beta), base_helix_angle(alpha_n, beta)
    normal = math.cos(alpha_n)
    assert math.cos(alpha_t) / math.cos(beta) * math.cos(beta_b) == pytest.approx(normal, rel=1e-13)
    assert math.tan(alpha_n) == pytest.approx(math.tan(alpha_t) * math.cos(beta), rel=1e-13)
    assert math.tan(beta_b) == pytest.approx(math.tan(beta) * math.cos(alpha_t), rel=1e-12, abs=1e-15)


@given(gears())
def test_mirrored_hand_changes_only_signs_of_helix_angles(gear):
    mirrored = gear.replace(beta=-gear.beta)
    for (name, a), (_, b) in zip(quantities(gear), quantities(mirrored), strict=True):
        if name == "beta_b":
            assert a == -b
        elif name != "hand":
            assert a == b


@given(gears(), st.floats(0.1, 10.0))
def test_everything_scales_with_the_module(gear, factor):
    scaled = gear.replace(m_n=factor * gear.m_n)
    assert scaled.d_Ff == pytest.approx(factor * gear.d_Ff, rel=1e-12)
    assert tip_thickness(scaled) == pytest.approx(factor * tip_thickness(gear), rel=1e-9, abs=1e-12)
    k = span_tooth_count(gear)
    assert span_tooth_count(scaled) == k
    assert span(scaled, k) == pytest.approx(factor * span(gear, k), rel=1e-12)


@given(gears())
def test_span_and_ball_measure_see_the_same_tooth(gear):
    """Solving the ball measure for the thickness gives back what the span measures."""
    D_M = ideal_ball_diameter(gear)
    assume(gear.d_Ff < gear.d + 2.0 * gear.x * gear.m_n)  # undercut may leave no flank there
    M = dimension_over_balls(gear, D_M) - D_M
    d_K = M if gear.z % 2 == 0 else M / math.cos(0.5 * math.pi / gear.z)
    from_ball = inv(math.acos(gear.d_b / d_K)) + math.pi / gear.z - D_M / (gear.d_b * math.cos(gear.beta_b))
    from_span = span(gear, 1) / (gear.d_b * math.cos(gear.beta_b))
    assert from_ball == pytest.approx(from_span, rel=1e-8)


@given(pairs(internal=False))
def test_swapping_the_gears_changes_nothing(pair):
    swapped = GearPair(pair.gear2, pair.gear1, pair.a_w)
    for name in ("alpha_wt", "x_sum", "g_alpha", "eps_alpha", "eps_beta", "l_min", "j_bt", "j_wt", "j_bn"):
        assert getattr(swapped, name) == pytest.approx(getattr(pair, name), rel=1e-9, abs=1e-12)
    for one, two in (
        ("d_w1", "d_w2"),
        ("d_Nf1", "d_Nf2"),
        ("d_Na1", "d_Na2"),
        ("c_1", "c_2"),
        ("g_a", "g_f"),
    ):
        assert getattr(swapped, one) == pytest.approx(getattr(pair, two), rel=1e-9, abs=1e-12)
    assume(pair.T1A > 0.0 and pair.T1E < pair.T1T2)
    ours, theirs = specific_sliding(pair), specific_sliding(swapped)
    assert (theirs.zeta_a1, theirs.zeta_f1) == (
        pytest.approx(ours.zeta_a2, rel=1e-6, abs=1e-9),
        pytest.approx(ours.zeta_f2, rel=1e-6, abs=1e-9),
    )
    assert loss_factor_integral(swapped) == pytest.approx(loss_factor_integral(pair), rel=1e-7)


@given(pairs())
def test_working_geometry_is_consistent(pair):
    assert pair.d_w1 + pair.d_w2 == pytest.approx(2.0 * pair.a_w, rel=1e-12)
    assert pair.d_w2 / pair.d_w1 == pytest.approx(pair.u, rel=1e-12)
    assert pair.T1C / (pair.T1T2 - pair.T1C) == pytest.approx(1.0 / pair.u, rel=1e-9)
    assert pair.g_f + pair.g_a == pytest.approx(pair.T1E - pair.T1A, rel=1e-12, abs=1e-15)


@given(pairs())
def test_backlash_slope(pair):
    """dj_bt/da = 2 sin alpha_wt, for external and internal pairs, with signed centre distances."""
    h = 1e-4 * pair.gear1.m_n
    slope = (pair.backlash(pair.a_w + h).j_bt - pair.backlash(pair.a_w - h).j_bt) / (2.0 * h)
    assert slope == pytest.approx(2.0 * math.sin(pair.alpha_wt), rel=1e-6)


@given(pairs())
def test_profile_shift_sum_round_trip(pair):
    g = pair.gear1
    x_sum = profile_shift_for_center_distance(
        z_sum=pair.z_sum, m_n=g.m_n, alpha_n=g.alpha_n, beta=g.beta, a_w=pair.a_w
    )
    assert x_sum == pytest.approx(pair.x_sum, rel=1e-9, abs=1e-12)
    tight = GearPair.from_profile_shifts(g.replace(x=g.x + x_sum - pair.x_sum_given), pair.gear2)
    assert tight.a_w == pytest.approx(pair.a_w, rel=1e-9)
    assert tight.j_bt == pytest.approx(0.0, abs=1e-12 * abs(pair.gear2.d))


@given(gears(), st.integers(12, 80))
def test_an_internal_gear_is_the_space_of_an_external_one(gear, more):
    """Same rack, same reference circle: the ring's tooth is the pinion's space, mirrored in the sign of x."""
    ring = gear.replace(z=-gear.z, x=-gear.x)
    assert (ring.d, ring.d_b) == (-gear.d, -gear.d_b)
    assert ring.s_n == pytest.approx(gear.e_n, rel=1e-12)
    assert ring.e_n == pytest.approx(gear.s_n, rel=1e-12)
    k = span_tooth_count(gear)
    assert span(ring, k) == pytest.approx(span(gear, k), rel=1e-12)


anything = st.one_of(
    st.floats(allow_nan=True, allow_infinity=True),
    st.floats(-3.0, 3.0),
    st.floats(1e-4, 0.2),
    st.integers(-200, 200),
    st.booleans(),
    st.none(),
)
counts = st.one_of(st.integers(-150, 150), st.sampled_from([0, 1, -1, 10**6, -(10**6), 10**9]))


def attempt(call):
    """The result of a call, or None if it says properly why there is none."""
    try:
        return call()
    except PitchpointError:
        return None


@given(counts, counts, st.lists(anything, min_size=17, max_size=17))
def test_only_our_own_errors_escape(z1, z2, numbers):
    """Arbitrary numbers anywhere: refused, or every property is a number or a GeometryError."""
    fields = [f.name for f in dataclasses.fields(CylindricalGear) if f.name not in ("z", "rack", "cutter")]
    made = []
    for z, values in ((z1, numbers[:8]), (z2, numbers[8:16])):
        kept = {name: v for name, v in zip(fields, values, strict=False) if v is not None}
        for trial in (kept, {k: v for k, v in kept.items() if k in ("x", "b", "m_n", "alpha_n")}):
            gear = attempt(lambda z=z, trial=trial: CylindricalGear(**{"z": z, "m_n": 3e-3, **trial}))
            if gear is not None:
                made.append(gear)
                dict(quantities(gear))
                assert all(p.value and p.limit and p.where for p in gear.problems())
                attempt(lambda gear=gear: tip_thickness(gear))
    for first in made[:2]:
        for second in made[-2:]:
            exact = attempt(lambda a=first, b=second: GearPair.from_profile_shifts(a, b))
            loose = attempt(lambda a=first, b=second: GearPair(a, b, numbers[16]))
            for pair in (exact, loose):
                if pair is not None:
                    dict(quantities(pair))
                    pair.problems()
                    pair.warnings()
                    attempt(lambda pair=pair: loss_factor_integral(pair))
                    attempt(lambda pair=pair: specific_sliding(pair))


@given(st.lists(anything, min_size=3, max_size=3))
def test_only_our_own_errors_escape_from_racks(numbers):
    attempt(lambda: BasicRack(h_aP_star=numbers[0], h_fP_star=numbers[1], rho_fP_star=numbers[2]))
