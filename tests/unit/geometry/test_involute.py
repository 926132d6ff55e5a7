# SPDX-License-Identifier: Apache-2.0
"""Involute function, its inverse, and the conversion from the normal to the transverse section."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry import (
    base_helix_angle,
    inv,
    inverse_inv,
    transverse_pressure_angle,
    working_pressure_angle,
)


@pytest.mark.parametrize("alpha", [1e-8, 1e-4, 0.0199, 0.0201, 0.3, 0.7, 1.2, 1.5, 1.5707])
def test_inverse_undoes_inv(alpha):
    # Near pi/2 the involute is so steep that the argument's own rounding is all that is left.
    assert inverse_inv(inv(alpha)) == pytest.approx(alpha, rel=1e-13)


def test_series_and_formula_meet():
    below, above = inv(0.02 * (1.0 - 1e-12)), inv(0.02)
    assert below == pytest.approx(above, rel=2e-11)


@pytest.mark.parametrize("value", [-1e-9, math.nan, math.inf])
def test_no_angle_has_such_an_involute(value):
    with pytest.raises(GeometryError):
        inverse_inv(value)


@pytest.mark.parametrize("alpha", [math.pi / 2, 2.0, math.nan, math.inf])
def test_no_involute_has_such_an_angle(alpha):
    with pytest.raises(GeometryError):
        inv(alpha)


def test_base_helix_angle_in_both_published_forms():
    alpha_n, beta = math.radians(20.0), math.radians(25.0)
    alpha_t = transverse_pressure_angle(alpha_n, beta)
    beta_b = base_helix_angle(alpha_n, beta)
    assert math.tan(beta_b) == pytest.approx(math.tan(beta) * math.cos(alpha_t), rel=1e-14)
    assert math.cos(alpha_n) * math.cos(beta) == pytest.approx(
        math.cos(alpha_t) * math.cos(beta_b), rel=1e-14
    )


def test_equal_tooth_numbers_have_no_working_pressure_angle():
    with pytest.raises(GeometryError, match="no pitch point"):
        working_pressure_angle(z_sum=0, alpha_n=0.35, x_sum=0.1)
