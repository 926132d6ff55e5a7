# SPDX-License-Identifier: Apache-2.0
"""Scalar kernels: shapes, prescribed waves, damping ramp, friction sign, low-load correction."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.contact.damping import ramp
from pitchpoint.contact.elastic import low_load
from pitchpoint.contact.friction import coulomb
from pitchpoint.contact.pair_shape import (
    FOURIER,
    RECTANGULAR,
    TABLE,
    pair_shape,
    pair_shape_rate,
    pair_table,
    pair_table_rate,
    phase_stiffness,
)
from pitchpoint.contact.stiffness.description import PhaseStiffness

pytestmark = pytest.mark.nojit


def slope_of(f, x, h=1e-7):
    return (f(x + h) - f(x - h)) / (2 * h)


def test_pair_shape_at_marked_points():
    assert pair_shape(0.0, 1.3, 0.8, 0.0) == pytest.approx(0.8, abs=1e-15)
    assert pair_shape(1.3, 1.3, 0.8, 0.0) == pytest.approx(0.8, abs=1e-15)
    assert pair_shape(0.65, 1.3, 0.8, 0.2) == 1.0
    assert pair_shape(-1e-12, 1.3, 0.8, 0.0) == 0.0
    assert pair_shape(1.3 + 1e-12, 1.3, 0.8, 0.0) == 0.0
    assert pair_shape(0.0, 1.3, 1.0, 0.3) == 0.0
    assert pair_shape(0.1, 1.3, 1.0, 0.2) == pytest.approx(0.5)
    assert pair_shape(0.45, 0.9, 1.0, 0.9) == pytest.approx(0.5)  # ramps that overlap


@given(st.floats(0.01, 0.99), st.floats(0.5, 3.0), st.floats(0, 1), st.floats(0.01, 1))
def test_pair_slopes(share, eps_alpha, S_R, T_R):
    p, L = share * eps_alpha, T_R * (eps_alpha % 1.0)
    table = np.array([0.6, 0.9, 1.0, 0.8])
    kinks = [L, eps_alpha - L, eps_alpha / 2, eps_alpha / 3, 2 * eps_alpha / 3]
    if min(abs(p - k) for k in kinks) < 1e-5 or 0 < L < 1e-3:
        return
    assert pair_shape_rate(p, 1.0, eps_alpha, 0.0, S_R, L, 0.0) == pytest.approx(
        slope_of(lambda q: pair_shape(q, eps_alpha, S_R, L), p), rel=1e-5, abs=1e-6
    )
    assert pair_table_rate(p, 1.0, eps_alpha, 0.0, 4, table, L, 0.0) == pytest.approx(
        slope_of(lambda q: pair_table(q, eps_alpha, 4, table, L), p), rel=1e-5, abs=1e-6
    )


@given(st.floats(-50, 50), st.integers(1, 30))
def test_fourier_wave(psi, n):
    rng = np.random.default_rng(n)
    a, b = rng.uniform(-1, 1, n), rng.uniform(-1, 1, n)
    h = np.arange(1, n + 1)
    angle = 2 * math.pi * h * psi
    value, slope = phase_stiffness(psi, FOURIER, n, a, b)
    assert value == pytest.approx(1 + a @ np.cos(angle) + b @ np.sin(angle), abs=1e-10)
    expected = 2 * math.pi * (h * (b * np.cos(angle) - a * np.sin(angle))).sum()
    assert slope == pytest.approx(expected, abs=1e-7)


def test_no_coefficients_is_a_constant():
    assert phase_stiffness(0.3, FOURIER, 0, np.empty(0), np.empty(0)) == (1.0, 0.0)


def test_table_wave_is_periodic_and_linear():
    values, none = np.array([0.8, 1.3, 0.9]), np.zeros(0)
    for psi, expected in ((0.0, 0.8), (1 / 6, 1.05), (1 / 3, 1.3), (5 / 6, 0.85), (-1 / 6, 0.85), (7.5, 1.1)):
        assert phase_stiffness(psi, TABLE, 3, values, none)[0] == pytest.approx(expected)
    assert phase_stiffness(0.9, TABLE, 3, values, none)[1] == pytest.approx(-0.3)


def test_rectangular_wave():
    wave, none = np.array([1.2, 0.8, 0.4]), np.zeros(0)
    found = [phase_stiffness(psi, RECTANGULAR, 3, wave, none) for psi in (0.0, 0.39, 0.4, 0.99, 1.0, -0.01)]
    assert [f[0] for f in found] == [1.2, 1.2, 0.8, 0.8, 1.2, 0.8]
    assert all(f[1] == 0.0 for f in found)


@pytest.mark.parametrize(
    "law",
    [
        PhaseStiffness(mean=1e8),
        PhaseStiffness(mean=1e8, cosine=np.array([-0.2, 0.1]), sine=np.array([0.05])),
        PhaseStiffness(mean=1e8, table=np.array([0.8, 1.3, 0.9])),
        PhaseStiffness(mean=1e8, rectangular=(1.2, 0.8, 0.4)),
    ],
)
def test_kernel_and_description_agree(law):
    n, first, second = law.arrays()
    psi = np.linspace(-1.7, 2.3, 57)
    kernel = [phase_stiffness(s, law.form, n, np.array(first), np.array(second))[0] for s in psi]
    assert law.ratio(psi) == pytest.approx(kernel, abs=1e-12)


def test_ramp():
    assert ramp(-1.0, 2.0) == (0.0, 0.0)
    assert ramp(0.0, 0.0) == (0.0, 0.0)
    assert ramp(1e-9, 0.0) == (1.0, 0.0)
    assert ramp(1.0, 2.0)[0] == pytest.approx(0.5)
    assert ramp(3.0, 2.0) == (1.0, 0.0)
    assert ramp(0.7, 2.0)[1] == pytest.approx(slope_of(lambda u: ramp(u, 2.0)[0], 0.7), rel=1e-7)


@given(st.floats(-3.0, 3.0))
def test_friction_sign(v):
    s, slope = coulomb(v, 1.0)
    assert s == -coulomb(-v, 1.0)[0]
    assert abs(s) <= 1.0
    assert s * v >= 0.0
    assert slope == pytest.approx(slope_of(lambda x: coulomb(x, 1.0)[0], v), abs=1e-6)


def test_friction_without_regularisation():
    assert coulomb(0.0, 0.0) == (0.0, 0.0)
    assert coulomb(1e-300, 0.0) == (1.0, 0.0)
    assert coulomb(-1e-300, 0.0) == (-1.0, 0.0)


def test_low_load_solves_the_rule_of_the_standard():
    c, limit = 14e9, 1e5
    for delta in (1e-7, 1e-6, 5e-6):
        w = low_load(c * delta, limit)[0] * c * delta
        assert w == pytest.approx(c * (w / limit) ** 0.25 * delta, rel=1e-12)
        tangent = slope_of(lambda d: low_load(c * d, limit)[0] * c * d, delta, 1e-12)
        assert low_load(c * delta, limit)[1] * c == pytest.approx(tangent, rel=1e-6)
    assert low_load(2e5, limit) == (1.0, 1.0)
    assert low_load(1.0, 0.0) == (1.0, 1.0)
    assert low_load(-1.0, limit) == (0.0, 0.0)
