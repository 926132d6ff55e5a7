# SPDX-License-Identifier: Apache-2.0
"""Local approach: strain on the axis by quadrature, limits."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad

from pitchpoint.contact.compliance.local import LineContact, line_contact
from pitchpoint.contact.hertz import half_width, line_approach

BODIES = LineContact((206e9, 118e9), (0.3, 0.24))
DEPTHS = (0.9e-3, 1.4e-3)
R = 2.1e-3


def approach(q, radius=R, depths=DEPTHS):
    return line_contact(q, radius, depths, BODIES)


def test_narrow_contacts_have_the_usual_formula():
    q = 1e3
    width = half_width(q, R, *BODIES.compliances)
    usual = sum(
        line_approach(q, t, width, c, nu)
        for t, c, nu in zip(DEPTHS, BODIES.compliances, BODIES.poisson, strict=True)
    )
    assert float(approach(q)) == pytest.approx(float(usual), rel=1e-4)


def test_approach_by_the_strain_on_the_axis():
    """Strain below the middle of a Hertzian pressure (Johnson, 4.46), integrated over the depth."""
    q, E, nu = 3e5, 206e9, 0.3
    bodies = LineContact((E, E), (nu, nu))
    b = float(half_width(q, R, *bodies.compliances))
    p_0 = 2.0 * q / (math.pi * b)

    def strain(z):
        root = math.hypot(b, z)
        sigma_x = -p_0 / b * ((b * b + 2.0 * z * z) / root - 2.0 * z)
        sigma_z = -p_0 * b / root
        return ((1.0 - nu * nu) * sigma_z - nu * (1.0 + nu) * sigma_x) / E

    t = 0.8e-3
    integral = quad(strain, 0.0, t, epsrel=1e-12)[0]
    found = line_contact(q, R, (t, t), bodies)
    assert 0.5 * float(found) == pytest.approx(-integral, rel=1e-9)


def test_no_load():
    found = line_contact(np.array([0.0, 1e5]), R, DEPTHS, BODIES)
    assert found[0] == 0.0
    assert found[1] == approach(1e5)
