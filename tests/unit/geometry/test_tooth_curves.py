# SPDX-License-Identifier: Apache-2.0
"""Bezier curves of teeth: on the exact tooth, closed, and as near as asked."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.mass_properties import section_integrals
from pitchpoint.geometry.rack import BasicRack
from pitchpoint.geometry.tooth_curves import MAX_DEGREE, bernstein, bezier_curves, pitch_curves, twist_curves
from pitchpoint.geometry.tooth_form import tooth_form, tooth_profile
from pitchpoint.geometry.tooth_outline import outline_from_tooth

GEARS = {
    "spur": CylindricalGear(z=23, m_n=2e-3),
    "helical": CylindricalGear(z=11, m_n=16e-3, x=0.4, beta=0.28),
    "undercut": CylindricalGear(z=8, m_n=1e-3),
    "full rounding": CylindricalGear(z=20, m_n=1e-3, x=0.2, rack=BasicRack(rho_fP_star=1.0)),
    "ring": CylindricalGear(z=-56, m_n=1e-3, x=-0.5, beta=0.3),
    "tip inside the base circle": CylindricalGear(z=-30, m_n=1e-3),
}


def points(curves, n=200):
    """Points of curves in a row, without the last one."""
    t = np.linspace(0.0, 1.0, n, endpoint=False)
    return np.concatenate([bernstein(c.size - 1, t) @ c for c in curves])


@pytest.mark.parametrize("gear", GEARS.values(), ids=GEARS)
def test_area_and_polar_moment_are_those_of_the_exact_tooth(gear):
    """By polygons of the curves; their second-order error is taken off by halving the step."""
    exact = section_integrals(tooth_form(gear))

    def sums(n):
        one = points(pitch_curves(gear, 1e-7), n)
        a = one
        b = np.append(one[1:], one[0] * np.exp(2j * math.pi / abs(gear.z)))
        twice = (a.conj() * b).imag
        second = (abs(a) ** 2 + abs(b) ** 2 + (a.conj() * b).real) / 6.0
        return abs(gear.z) * np.array([0.5 * twice.sum(), 0.5 * (twice * second).sum()])

    coarse, fine = sums(200), sums(400)
    assert (4.0 * fine - coarse) / 3.0 == pytest.approx(exact, rel=1e-8)


@pytest.mark.parametrize("gear", GEARS.values(), ids=GEARS)
@pytest.mark.parametrize("tolerance", [1e-4, 1e-6])
def test_points_of_the_profile_lie_on_the_curves(gear, tolerance):
    curves = pitch_curves(gear, tolerance)
    assert max(c.size for c in curves) <= MAX_DEGREE + 1
    line = points(curves, 400)
    line = np.append(line, line * np.exp(2j * math.pi / abs(gear.z)))  # the profile ends amid the next root
    xy = tooth_profile(gear, 60).points
    step = np.abs(np.diff(line)).max()
    for p in (xy[:, 0] + 1j * xy[:, 1])[1:]:
        k = int(np.argmin(abs(line - p)))
        k = min(max(k, 1), line.size - 2)
        # distance from the two chords at the nearest point, which lie within step^2/8 of their radius
        gaps = []
        for a, b in ((line[k - 1], line[k]), (line[k], line[k + 1])):
            share = min(1.0, max(0.0, ((p - a) / (b - a)).real))
            gaps.append(abs(p - a - share * (b - a)))
        assert min(gaps) <= tolerance * gear.m_n + step**2 / (0.2 * gear.m_n)


def test_twist_follows_the_circle_at_equal_steps():
    for angle in (0.07, -1.2, 4.0):
        curves = twist_curves(angle, 1e-8)
        t = np.linspace(0.0, 1.0, 50)
        found = np.concatenate([bernstein(c.size - 1, t) @ c for c in curves])
        height = np.concatenate([(k + t) / len(curves) for k in range(len(curves))])
        assert abs(found - np.exp(1j * angle * (height - 0.5))).max() < 1.1e-8


def test_a_straight_line_needs_two_points():
    assert [p.size for p in bezier_curves(lambda t: t + 2j * t, 1e-12)] == [2]


def test_measured_points_are_refused():
    gear = GEARS["spur"]
    measured = gear.replace(outline=outline_from_tooth(gear, tooth_profile(gear, 40).points))
    with pytest.raises(GeometryError, match="export STL instead"):
        pitch_curves(measured)
