# SPDX-License-Identifier: Apache-2.0
"""Oil film of Dowson and Higginson, flash temperature of Blok: closed forms and their limits."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

from pitchpoint.contact.film_thickness import film_thickness
from pitchpoint.contact.flash_temperature import SEMI_ELLIPTIC, STEEL, flash_temperature
from pitchpoint.contact.hertz import plane_strain_compliance

SOFT = 2.0 * plane_strain_compliance(206e9, 0.3)


def test_film_in_dimensionless_form():
    E, R = 2.0 / SOFT, 0.013
    U, G, W = 3e-11, 5000.0, 4e-5
    h = film_thickness(W * E * R, R, U * E * R / 0.03, SOFT, 0.03, G / E)
    assert float(h) / R == pytest.approx(2.65 * U**0.7 * G**0.54 / W**0.13, rel=1e-12)


def test_film_over_arrays():
    found = film_thickness([1e5, 2e5], 0.01, [[1.0], [2.0]], SOFT, 0.02, 20e-9)
    assert found.shape == (2, 2)
    assert found[1, 0] / found[0, 0] == pytest.approx(2.0**0.7)
    assert found[0, 1] / found[0, 0] == pytest.approx(2.0**-0.13)
    assert film_thickness(1e5, 0.01, 0.0, SOFT, 0.02, 20e-9) == 0.0


def test_factor_of_a_semi_elliptic_heat_source():
    """A half-space passes under the heat flux: T(x) = ∫ q(s)/√(x - s) ds/(√π B √v). With s = x - u²."""

    def rise(x):
        return quad(lambda u: 2.0 * math.sqrt(max(1.0 - (x - u * u) ** 2, 0.0)), 0.0, math.sqrt(x + 1.0))[0]

    most = -minimize_scalar(lambda x: -rise(x), bounds=(0.0, 1.0), method="bounded").fun
    assert pytest.approx(2.0 / math.pi**1.5 * most, rel=1e-6) == SEMI_ELLIPTIC
    # with the whole width 2 b_H in the formula the factor is Blok's 1.11
    assert SEMI_ELLIPTIC * math.sqrt(2.0) == pytest.approx(1.11, abs=5e-3)


def test_flash_temperature_divides_the_heat():
    """Equal maxima on both bodies: T = T1 T2/(T1 + T2) of those with the whole heat."""
    w, b, mu, v = 5e5, 2e-4, 0.05, (10.0, 6.0)
    heat = mu * w * (v[0] - v[1])
    alone = [
        SEMI_ELLIPTIC * heat / (math.sqrt(b) * B * math.sqrt(s)) for B, s in zip((STEEL, 5e3), v, strict=True)
    ]
    found = flash_temperature(w, b, *v, mu, (STEEL, 5e3))
    assert float(found) == pytest.approx(alone[0] * alone[1] / (alone[0] + alone[1]), rel=1e-12)


def test_no_flash_temperature_in_rolling():
    assert np.all(flash_temperature([1e5, 2e5], 2e-4, 3.0, 3.0, 0.05) == 0.0)
