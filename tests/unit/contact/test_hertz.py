# SPDX-License-Identifier: Apache-2.0
"""Hertzian line contact: the two limits of its stiffness, and the elastic half plane by integration."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.hertz import (
    line_approach,
    line_stiffness,
    plane_strain_compliance,
)

STEEL = plane_strain_compliance(206e9, 0.3)


def test_linear_stiffness_of_unequal_bodies():
    cast = plane_strain_compliance(118e9, 0.26)
    assert line_stiffness(STEEL, STEEL) == pytest.approx(math.pi * 206e9 / (4 * 0.91), rel=1e-14)
    assert line_stiffness(STEEL, cast) == line_stiffness(cast, STEEL) < line_stiffness(STEEL, STEEL)


def test_approach_is_the_strain_below_the_contact():
    """Integrate the plane-strain strain along the axis of a Hertzian pressure down to the depth h."""
    q, b_H, h, nu, E = 1.6e5, 1.0e-4, 4.0e-3, 0.3, 206e9
    p_0 = 2 * q / (math.pi * b_H)
    t = np.linspace(0.0, math.asinh(h / b_H), 20_001)
    z = b_H * np.sinh(t)
    root = np.sqrt(1 + (z / b_H) ** 2)
    sigma_z = -p_0 / root
    sigma_x = -p_0 * ((1 + 2 * (z / b_H) ** 2) / root - 2 * z / b_H)
    strain = (1 - nu**2) / E * (sigma_z - nu / (1 - nu) * sigma_x)
    expected = -np.trapezoid(strain * b_H * np.cosh(t), t)
    assert float(line_approach(q, h, b_H, STEEL, nu)) == pytest.approx(expected, rel=1e-3)
