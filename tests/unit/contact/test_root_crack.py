# SPDX-License-Identifier: Apache-2.0
"""Compliance of root cracks against integrals over the drawn tooth."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.stiffness.root_crack import (
    crack_compliance,
    crack_depth,
    largest_crack,
    root_half_thickness,
)
from pitchpoint.contact.stiffness.tooth_compliance import tooth_compliance
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry import CylindricalGear
from pitchpoint.geometry.tooth_form import tooth_form, tooth_profile

E, NU = 206e9, 0.3
STEEL = dict(beta=0.0, E=E, nu=NU)
ANGLE = math.radians(70.0)


def drawn(gear, n=40000):
    """Height over the root and half thickness of one flank, points of the outline from root to tip."""
    profile = tooth_profile(gear, n)
    flank = (profile.points[:, 1] > 0.0) & np.isin(profile.region, (1, 2))
    x, y = profile.points[flank].T[:, ::-1]
    return gear.sign * (x - x[0]), y


@pytest.mark.parametrize("internal", [False, True])
@pytest.mark.parametrize("share", [0.1, 0.5, 0.95])
@pytest.mark.parametrize("angle", [45.0, 90.0])
@pytest.mark.parametrize("beta", [0.0, 0.3])
def test_against_integrals_over_the_drawn_tooth(internal, share, angle, beta):
    """Bending and shear of the reduced sections, trapezoidal rule on the outline: 1e-4 of it are left."""
    gear = CylindricalGear(z=-70 if internal else 40, m_n=3e-3)
    form = tooth_form(gear)
    angle = math.radians(angle)
    depth = share * largest_crack(form, angle)
    height, half = drawn(gear)
    h_c = half[0] - depth * math.sin(angle)
    assert half[0] == pytest.approx(root_half_thickness(form), rel=1e-6)
    r_b, cb = form.r_b, math.cos(beta) ** 2
    radius = np.linspace(0.5 * abs(gear.d_Ff), 0.5 * abs(gear.d_Fa), 5)[1:-1]
    rho = np.sqrt(radius**2 - r_b**2)
    found = crack_compliance(form, rho, np.array([depth]), angle=angle, beta=beta, E=E, nu=NU)[0]
    for roll, r, added in zip(rho / r_b, radius, found, strict=True):
        here = int(
            np.argmin(abs(np.hypot(height * gear.sign + form.r_f * math.cos(form.root_half_angle), half) - r))
        )
        x_c, at = half[here], height[here]
        # the force is tangent to the base circle: its lean against the normal of the centre line
        lean = math.atan(roll) - gear.sign * math.asin(x_c / r)
        eta, x = height[: here + 1], half[: here + 1]
        arm = math.cos(lean) * (at - eta) - x_c * math.sin(lean) * cb
        bending = arm * arm * (12.0 / (x + h_c) ** 3 - 12.0 / (2.0 * x) ** 3) / (E * cb * cb)
        shear = 1.2 * math.cos(lean) ** 2 * (1.0 / (x + h_c) - 0.5 / x) * 2.0 * (1.0 + NU) / (E * cb)
        expected = np.trapezoid(np.where(x > h_c, bending + shear, 0.0), eta)
        assert added == pytest.approx(expected, rel=1e-4)


def test_a_deeper_crack_is_softer_and_none_adds_nothing():
    form = tooth_form(CylindricalGear(z=62, m_n=2e-3))
    rho = np.linspace(0.017, 0.0265, 9)
    depth = np.linspace(0.0, 1.0, 6) * largest_crack(form, ANGLE)
    added = crack_compliance(form, rho, depth, angle=ANGLE, **STEEL)
    assert not added[0].any()
    assert (np.diff(added, axis=0) > 0.0).all()
    assert (np.diff(added[1:], axis=1) > 0.0).all()
    whole = tooth_compliance(form, rho, bore=0.035, body="load_line", **STEEL)
    # half of the thickness bends eight times as much, less what lies above the limit line
    assert 7.0 < added[-1, -1] / whole.bending[-1] < 8.0
    assert added[:, ::-1] == pytest.approx(crack_compliance(form, rho[::-1], depth, angle=ANGLE, **STEEL))


def test_beyond_the_centre_line_there_is_no_formula():
    form = tooth_form(CylindricalGear(z=62, m_n=2e-3))
    most = largest_crack(form, ANGLE)
    crack_compliance(form, np.array([0.02, 0.025]), np.array([most]), angle=ANGLE, **STEEL)
    with pytest.raises(GeometryError, match="centre line"):
        crack_compliance(form, np.array([0.02, 0.025]), np.array([1.01 * most]), angle=ANGLE, **STEEL)


@pytest.mark.parametrize("at", ["start", "end"])
def test_depth_along_the_face(at):
    z = np.linspace(-0.01, 0.01, 5)
    assert (crack_depth(z, 1e-3, None, 0.02, at) == 1e-3).all()
    found = crack_depth(z, 1e-3, 0.01, 0.02, at)
    expected = 1e-3 * np.sqrt([1.0, 0.5, 0.0, 0.0, 0.0])
    assert found == pytest.approx(expected if at == "start" else expected[::-1])
