# SPDX-License-Identifier: Apache-2.0
"""The width integral against dense numerical integration, the spur limit, and its own derivative."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.contact.pair_shape import pair_shape, pair_table
from tests.support.width_moments import table_width_moments, width_moments

TABLE = np.array([0.61, 0.74, 0.93, 1.0, 0.97, 0.88, 0.7])
B = 0.04

ratios = st.floats(0.5, 3.5)
shares = st.floats(0.0, 1.0)
phases = st.floats(-3.0, 3.0)
slopes = st.one_of(st.just(0.0), st.floats(-60.0, 60.0).filter(lambda lam: abs(lam) > 1e-3))


def brute_force(law, psi, lam, eps_alpha, kinks):
    """Sum over pairs by Gauss-Legendre of high order between all kinks."""
    x, w = np.polynomial.legendre.leggauss(12)
    total = np.zeros(3)
    for j in range(-12, 13):
        inner = [(p - psi - j) / lam for p in kinks]
        edges = np.unique(np.clip([-B / 2, *inner, B / 2], -B / 2, B / 2))
        for lo, hi in zip(edges[:-1], edges[1:], strict=True):
            z = 0.5 * (lo + hi) + 0.5 * (hi - lo) * x
            p = psi + j + lam * z
            if not 0.0 < p[6] < eps_alpha:
                continue
            c = np.array([law(min(max(q, 0.0), eps_alpha)) for q in p])
            total += 0.5 * (hi - lo) * np.array([np.sum(w * c * z**n) for n in range(3)])
    return total


def scaled(moments):
    return np.array(moments) / np.array([B, B**2, B**3])


@pytest.mark.nojit
@given(phases, slopes.filter(bool), ratios, shares, shares)
def test_parabola_against_brute_force(psi, lam, eps_alpha, S_R, T_R):
    L = T_R * (eps_alpha % 1.0)
    kinks = [0.0, min(L, eps_alpha / 2), max(eps_alpha - L, eps_alpha / 2), eps_alpha]
    expected = brute_force(lambda p: pair_shape(p, eps_alpha, S_R, L), psi, lam, eps_alpha, kinks)
    assert scaled(width_moments(psi, lam, B, eps_alpha, S_R, L)) == pytest.approx(scaled(expected), abs=1e-12)


@given(phases, slopes.filter(bool), ratios, shares)
def test_table_against_brute_force(psi, lam, eps_alpha, T_R):
    L = T_R * (eps_alpha % 1.0)
    kinks = [L, eps_alpha / 2, eps_alpha - L, *np.linspace(0.0, eps_alpha, TABLE.size)]
    expected = brute_force(
        lambda p: pair_table(p, eps_alpha, TABLE.size, TABLE, L), psi, lam, eps_alpha, kinks
    )
    found = table_width_moments(psi, lam, B, eps_alpha, TABLE.size, TABLE, L, 0)
    assert scaled(found) == pytest.approx(scaled(expected), abs=1e-12)


@given(st.floats(0.02, 0.98), ratios, shares, shares, st.floats(1e-16, 1e-8))
def test_small_helix_angle_meets_the_spur_gear(psi, eps_alpha, S_R, T_R, lam):
    e = eps_alpha % 1.0
    L = T_R * e
    near = min(abs((psi - k + 0.5) % 1.0 - 0.5) for k in (0.0, e, L, e - L, 0.5 * eps_alpha))
    if near < 1e-6:
        return
    spur = width_moments(psi, 0.0, B, eps_alpha, S_R, L)
    for sign in (1.0, -1.0):
        assert scaled(width_moments(psi, sign * lam, B, eps_alpha, S_R, L)) == pytest.approx(
            scaled(spur), abs=1e-12 + lam * B * 1e2
        )
    assert scaled(width_moments(psi, 1e-12, B, eps_alpha, S_R, L)) == pytest.approx(scaled(spur), abs=1e-12)


@pytest.mark.parametrize("lam", [-31.0, -4.0, 4.0, 31.0])
@pytest.mark.parametrize("T_R", [0.0, 0.4, 1.0])
def test_slopes_are_derivatives(lam, T_R):
    eps_alpha, S_R, h = 1.62, 0.7, 1e-6
    L = T_R * 0.62
    rng = np.random.default_rng(5)
    for psi in rng.uniform(-1.0, 1.0, 40):
        up, down = (width_moments(psi + s, lam, B, eps_alpha, S_R, L) for s in (h, -h))
        difference = (np.array(up) - np.array(down)) / (2 * h)
        found = width_moments(psi, lam, B, eps_alpha, S_R, L, 1)
        assert scaled(found) == pytest.approx(
            scaled(difference), abs=1e-4
        )  # a kink within h costs order h/lam
        up, down = (table_width_moments(psi + s, lam, B, eps_alpha, TABLE.size, TABLE, L, 0) for s in (h, -h))
        difference = (np.array(up) - np.array(down)) / (2 * h)
        found = table_width_moments(psi, lam, B, eps_alpha, TABLE.size, TABLE, L, 1)
        assert scaled(found) == pytest.approx(scaled(difference), abs=1e-4)


@given(phases, slopes, ratios, shares)
def test_mirrored_helix_mirrors_the_moments(psi, lam, eps_alpha, S_R):
    left = width_moments(psi, lam, B, eps_alpha, S_R, 0.0)
    right = width_moments(psi, -lam, B, eps_alpha, S_R, 0.0)
    assert scaled(left) == pytest.approx(scaled(right) * [1.0, -1.0, 1.0], abs=1e-13)


@given(phases, slopes, ratios, shares, shares)
def test_period_is_one_base_pitch(psi, lam, eps_alpha, S_R, T_R):
    L = T_R * (eps_alpha % 1.0)
    if lam == 0.0 and min(abs((psi - k + 0.5) % 1.0 - 0.5) for k in (0.0, eps_alpha)) < 1e-9:
        return  # on a jump of a spur gear
    here = width_moments(psi, lam, B, eps_alpha, S_R, L)
    there = width_moments(psi + 5.0, lam, B, eps_alpha, S_R, L)
    assert scaled(here) == pytest.approx(scaled(there), abs=1e-11)
