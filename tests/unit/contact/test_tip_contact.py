# SPDX-License-Identifier: Apache-2.0
"""Contact of tip edges: closed form against the distance of a point to an involute, found by root search."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass

import numpy as np
import pytest
from scipy.optimize import brentq

from pitchpoint.contact.tip_contact import (
    arc_less_sine,
    tip_gap,
    tip_gap_curvature,
    tip_gap_floor,
    tip_gap_from_mean,
)

pytestmark = pytest.mark.nojit

ROUND_OFF = 2e-16
"""Coordinates of 0.1 m have round-off of 1e-17 m; a distance sums up some ten of them [m]."""


def inv(cosine):
    """Involute function at an angle with this cosine."""
    return math.sqrt(1.0 - cosine * cosine) / cosine - math.acos(cosine)


@dataclass(frozen=True)
class Pair:
    """Spur gears of module 4 mm: signed teeth, centre distance, addenda in modules."""

    z1: int
    z2: int
    stretch: float = 1.0  # centre distance over the reference one
    addenda: tuple[float, float] = (1.0, 1.0)
    alpha_deg: float = 20.0

    m = 4e-3

    @property
    def base(self):
        cos = math.cos(math.radians(self.alpha_deg))
        return 0.5 * self.m * self.z1 * cos, 0.5 * self.m * self.z2 * cos

    @property
    def a(self):
        return 0.5 * self.m * (self.z1 + self.z2) * self.stretch

    @property
    def tips(self):
        return tuple(self.m * (0.5 * z + h) for z, h in zip((self.z1, self.z2), self.addenda, strict=True))

    @property
    def cos_sin(self):
        cos = sum(self.base) / self.a
        return cos, math.sqrt(1.0 - cos * cos)

    def rho(self, gear):
        """Length of roll at the tip, signed."""
        r, b = self.tips[gear], self.base[gear]
        return math.copysign(math.sqrt(r * r - b * b), b)

    def end(self, gear):
        """E (gear 1, 0) or A (gear 2, 1) from the pitch point."""
        cos, sin = self.cos_sin
        return (1.0 if gear == 0 else -1.0) * (self.rho(gear) - self.base[gear] * sin / cos)

    def arguments(self, gear, radius=0.0):
        """Those of the kernels after eta."""
        cos, sin = self.cos_sin
        return self.base[gear], self.base[1 - gear], self.rho(gear) - radius, sin / cos

    def law(self, gear, eta, radius=0.0):
        return tip_gap(eta, *self.arguments(gear, radius))


class Section:
    """Transverse section as complex numbers: gear 1 at 0, gear 2 at the signed centre distance."""

    def __init__(self, pair):
        cos, sin = pair.cos_sin
        self.pair, self.axes = pair, (0.0, pair.a)
        self.normal = complex(sin, cos)
        self.pitch_point = pair.base[0] / cos

    def flank(self, gear, xi):
        """Involute of a gear as a function of the angle of roll.

        From the position through the pitch point, the gear has turned until it crosses the line of action at
        xi; the crossing may lie beyond the base tangent point, where the other branch would pass.
        """
        b = abs(self.pair.base[gear])
        point = self.pitch_point - self.axes[gear]
        turned = (xi if gear == 0 else -xi) / self.pair.base[gear]
        start = cmath.phase(point) + inv(b / abs(point)) + turned
        return lambda u: self.axes[gear] + b * (1.0 + 1j * u) * cmath.exp(1j * (start - u))

    def penetration(self, point, gear, xi, radius=0.0):
        """Penetration of a circle about a point into the flank of `gear` at xi."""
        curve = self.flank(gear, xi)

        def along(u):
            """Component along the tangent of the flank; the tangent is b u times this direction."""
            foot = curve(u) - self.axes[gear]
            spoke = foot / complex(1.0, u)  # points to the contact of the base tangent
            return ((point - curve(u)) * spoke.conjugate()).real

        r, b = abs(point - self.axes[gear]), abs(self.pair.base[gear])
        here = math.sqrt(r * r / (b * b) - 1.0)
        u = brentq(along, max(0.0, here - 0.1), here + 0.1, xtol=1e-16, rtol=1e-15)
        off = point - curve(u)
        into = self.normal if gear == 1 else -self.normal
        return math.copysign(abs(off), (off * into.conjugate()).real) + radius, u * b


PAIRS = {
    "17/43": Pair(17, 43),
    "17/43 farther": Pair(17, 43, 1.015),
    "25/26 closer": Pair(25, 26, 0.985),
    "60/20": Pair(60, 20),
    "high contact ratio": Pair(35, 70, 1.0, (1.35, 1.35)),
    "25 deg": Pair(19, 41, 1.01, alpha_deg=25.0),
    "17/-60": Pair(17, -60, 1.0, (1.0, -0.2)),
    "24/-70 farther": Pair(24, -70, 1.02, (1.0, 0.6)),
    "40/-60 closer": Pair(40, -60, 0.97, (0.8, 0.5)),
}
GEARS = {"tip of gear 1 beyond E": 0, "tip of gear 2 before A": 1}


def tip_at(section, gear, xi, radius=0.0):
    """Tip edge, or centre of its rounding, of a gear whose flank is at xi, from the gear alone."""
    pair = section.pair
    curve, r, b = section.flank(gear, xi), abs(pair.tips[gear]), abs(pair.base[gear])
    u = math.sqrt(r * r / (b * b) - 1.0)
    edge = curve(u)
    if radius == 0.0:
        return edge
    spoke = (edge - section.axes[gear]) / complex(1.0, u)
    outwards = 1j * spoke / abs(spoke) * (1.0 if pair.base[gear] > 0.0 else -1.0)
    return edge - radius * outwards


@pytest.mark.parametrize("radius", [0.0, 0.2e-3])
@pytest.mark.parametrize("eta", [0.0, 1e-7, 3e-5, 0.4e-3, 2e-3, 4e-3])
@pytest.mark.parametrize("where", GEARS)
@pytest.mark.parametrize("name", PAIRS)
def test_penetration_is_the_distance_of_the_edge_to_the_flank(name, where, eta, radius):
    pair, gear = PAIRS[name], GEARS[where]
    section, x = Section(pair), 2.5e-5
    way = 1.0 if gear == 0 else -1.0
    own = pair.end(gear) + way * eta  # xi of the flank with the tip edge
    point = tip_at(section, gear, own, radius)
    found, foot = section.penetration(point, 1 - gear, own - way * x, radius)
    gap, _, _, roll, *_ = pair.law(gear, eta, radius)
    assert gap >= 0.0
    assert x - gap == pytest.approx(found, abs=ROUND_OFF)
    # from the edge or the centre of the rounding to the foot on the flank
    assert abs(roll + found - radius) == pytest.approx(foot, rel=1e-9)


@pytest.mark.parametrize("eta", [1e-9, 2e-5, 0.4e-3, 2e-3, 4e-3])
@pytest.mark.parametrize("where", GEARS)
@pytest.mark.parametrize("name", PAIRS)
def test_derivatives(name, where, eta):
    pair, gear = PAIRS[name], GEARS[where]
    r_1, r_2, L, tan_a = pair.arguments(gear)
    cos, sin = pair.cos_sin
    gap, by_eta, by_tan, _, roll_by_eta, roll_by_tan, by_eta_eta, _ = tip_gap(eta, r_1, r_2, L, tan_a)
    h = 1e-4 * eta
    before, after = (tip_gap(eta + d, r_1, r_2, L, tan_a) for d in (-h, h))
    size = abs(L) / (r_1 * r_1)
    assert by_eta == pytest.approx((after[0] - before[0]) / (2 * h), rel=1e-6, abs=1e-8 * size * eta)
    assert roll_by_eta == pytest.approx((after[3] - before[3]) / (2 * h), rel=1e-5, abs=1e-17 / h)
    assert by_eta_eta == pytest.approx((after[1] - before[1]) / (2 * h), rel=1e-5)
    h = 1e-6
    before, after = (tip_gap(eta, r_1, r_2, L, tan_a + d) for d in (-h, h))
    assert by_tan == pytest.approx((after[0] - before[0]) / (2 * h), rel=1e-5, abs=1e-17 / h)
    assert roll_by_tan == pytest.approx((after[3] - before[3]) / (2 * h), rel=1e-6)
    # by the centre distance, of which tan(alpha) is a function: the edge stays at eta
    h, R = 1e-7, r_1 + r_2
    tans = (math.sqrt((pair.a + d) ** 2 - R * R) / abs(R) for d in (-h, h))
    before, after = (tip_gap(eta, r_1, r_2, L, tan) for tan in tans)
    by_a = (after[0] - before[0]) / (2 * h)
    assert by_tan / (R * sin) == pytest.approx(by_a, rel=1e-4, abs=1e-17 / h)


@pytest.mark.parametrize("radius", [0.0, 0.2e-3])
@pytest.mark.parametrize("eta", [0.0, 3e-5, 0.4e-3, 2e-3])
@pytest.mark.parametrize("where", GEARS)
@pytest.mark.parametrize("name", PAIRS)
def test_edge_touches_where_both_flanks_are_half_the_gap_from_their_mean(name, where, eta, radius):
    """Rigid gears at a mean path position: with the flanks ahead and behind by G/2 the edge just touches."""
    pair, gear = PAIRS[name], GEARS[where]
    section, way = Section(pair), 1.0 if gear == 0 else -1.0
    gap, _, _, roll, *_, turned = tip_gap_from_mean(eta, *pair.arguments(gear, radius))
    mean = pair.end(gear) + way * eta
    point = tip_at(section, gear, mean + way * 0.5 * gap, radius)
    found, foot = section.penetration(point, 1 - gear, mean - way * 0.5 * gap, radius)
    assert found == pytest.approx(0.0, abs=ROUND_OFF + 1e-10 * gap)
    assert abs(roll - radius) == pytest.approx(foot, rel=1e-9)
    assert turned == pytest.approx(pair.law(gear, eta + 0.5 * gap, radius)[7], rel=1e-6)


@pytest.mark.parametrize("eta", [2e-5, 0.4e-3, 2e-3])
@pytest.mark.parametrize("where", GEARS)
@pytest.mark.parametrize("name", PAIRS)
def test_derivatives_by_the_mean(name, where, eta):
    """The roll by tan(alpha) is that before the Newton step, whose length is below 1e-6 of eta."""
    r_1, r_2, L, tan_a = PAIRS[name].arguments(GEARS[where])
    _, by_eta, by_tan, _, roll_by_eta, roll_by_tan, _ = tip_gap_from_mean(eta, r_1, r_2, L, tan_a)
    h = 1e-4 * eta
    before, after = (tip_gap_from_mean(eta + d, r_1, r_2, L, tan_a) for d in (-h, h))
    assert by_eta == pytest.approx((after[0] - before[0]) / (2 * h), rel=1e-6)
    assert roll_by_eta == pytest.approx((after[3] - before[3]) / (2 * h), rel=1e-5, abs=1e-17 / h)
    h = 1e-6
    before, after = (tip_gap_from_mean(eta, r_1, r_2, L, tan_a + d) for d in (-h, h))
    assert by_tan == pytest.approx((after[0] - before[0]) / (2 * h), rel=1e-5, abs=1e-17 / h)
    assert roll_by_tan == pytest.approx((after[3] - before[3]) / (2 * h), rel=1e-5)


@pytest.mark.parametrize("where", GEARS)
@pytest.mark.parametrize("name", PAIRS)
def test_gap_starts_as_a_parabola_without_cancellation(name, where):
    pair, gear = PAIRS[name], GEARS[where]
    given = pair.arguments(gear)
    curvature = tip_gap_curvature(*given)
    for eta in (1e-12, 1e-10, 1e-8):
        gap, by_eta, _, _, _, _, by_eta_eta, _ = tip_gap(eta, *given)
        assert gap == pytest.approx(0.5 * curvature * eta * eta, rel=1e-4)
        assert by_eta == pytest.approx(curvature * eta, rel=1e-4)
        assert by_eta_eta == pytest.approx(curvature, rel=1e-4)
    on_the_path = tip_gap(-1e-4, *given)
    assert on_the_path[:3] == (0.0, 0.0, 0.0)
    r_1, r_2, L, tan_a = given
    assert on_the_path[3] == pytest.approx((r_1 + r_2) * tan_a - L + 1e-4)


def test_turn_of_the_normal_is_that_of_both_gears():
    """On gear 1 the normal turns with its rotation and with that of the mate, by which the flank follows."""
    pair, eta, x = PAIRS["17/43"], 1.5e-3, 0.0
    section = Section(pair)
    own = pair.end(0) + eta
    point = tip_at(section, 0, own)
    _, foot = section.penetration(point, 1, own - x)
    curve, b2 = section.flank(1, own - x), pair.base[1]
    spoke = (curve(foot / b2) - section.axes[1]) / complex(1.0, foot / b2)
    normal = 1j * spoke / abs(spoke)  # out of gear 2
    clockwise = -cmath.phase(normal * -section.normal.conjugate())
    assert eta / pair.base[0] + clockwise == pytest.approx(pair.law(0, eta)[7], abs=1e-12)


def test_edge_below_the_base_circle_of_the_mate_has_no_contact():
    pair = Pair(12, 120)  # the tips of gear 2 reach beyond the base tangent of gear 1: interference
    assert pair.law(1, 1e-4) == (math.inf, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    assert tip_gap_from_mean(1e-4, *pair.arguments(1)) == (math.inf, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    assert tip_gap_curvature(*pair.arguments(1)) == math.inf
    assert math.isfinite(pair.law(0, 1e-4)[0])


def test_lower_bound():
    """G/eta^2 is not monotonic for all gears; the margin covers what is below its smaller end value."""
    rng, closest, tried = np.random.default_rng(5), math.inf, 0
    while tried < 300:
        z1, internal = int(rng.integers(6, 100)), rng.random() < 0.4
        z2 = -int(rng.integers(z1 + 6, 250)) if internal else int(rng.integers(6, 250))
        addenda = tuple(rng.uniform(-0.2, 1.6, 2))
        pair = Pair(z1, z2, rng.uniform(0.97, 1.06), addenda, rng.uniform(12.0, 30.0))
        gear, reach = int(rng.integers(2)), math.pi * 4e-3 * rng.uniform(0.05, 1.0)
        below_base = any(abs(r) < abs(b) for r, b in zip(pair.tips, pair.base, strict=True))
        if abs(sum(pair.base)) >= abs(pair.a) or below_base:
            continue
        given = pair.arguments(gear)
        q = tip_gap_floor(reach, *given)
        if not math.isfinite(q) or not math.isfinite(tip_gap(reach, *given)[0]):
            continue
        tried += 1
        for eta in reach * np.linspace(0.02, 1.0, 30):
            closest = min(closest, tip_gap(eta, *given)[0] / (q * eta * eta))
    assert 1.0 < closest < 1.26


def test_arc_less_sine():
    for x in (0.0, 1e-6, -0.3, 0.4999999, 0.5000001, 1.2):
        exact = sum((-1) ** k * x ** (2 * k + 3) / math.factorial(2 * k + 3) for k in range(14))
        assert arc_less_sine(x) == pytest.approx(exact, rel=3e-15)
