# SPDX-License-Identifier: Apache-2.0
"""Mesh cycle: against an integral by pieces, as a moving average, symmetric, with the spur limit."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.contact.cycle_pieces import Pieces, cycle_pieces, variations
from pitchpoint.contact.mesh_cycle import mesh_cycle, pair_cycle, phase_cycle
from pitchpoint.contact.stiffness.description import PairShape, PhaseStiffness
from pitchpoint.core.errors import ModelError
from tests.support.width_moments import table_width_moments, width_moments

eps_alphas = st.floats(0.9, 3.5)
eps_betas = st.one_of(st.just(0.0), st.floats(1e-3, 3.0))
shares = st.floats(0.0, 1.0)
TABLE = np.array([0.6, 0.8, 1.0, 0.9, 0.7])


@given(eps_alphas, eps_betas, shares, shares)
def test_against_an_integral_by_pieces(eps_alpha, eps_beta, S_R, T_R):
    cycle = mesh_cycle(eps_alpha, eps_beta, S_R, T_R, n=203)
    L = PairShape(c_prime=1.0, T_R=T_R).ramp_length(eps_alpha)
    inside = slice(1, -1) if eps_beta == 0.0 else slice(None)  # psi = 0 is a jump of spur gears
    kernel = width_moments(cycle.phase[inside], eps_beta, 1.0, eps_alpha, S_R, L)[0]
    far = np.ones(len(kernel), bool)
    if eps_beta == 0.0:
        far = np.abs(cycle.phase[inside] - eps_alpha % 1.0) > 1e-9
    assert cycle.stiffness_ratio[inside][far] == pytest.approx(kernel[far], abs=1e-10)
    assert cycle.maximum >= max(kernel[far]) - 1e-10
    assert cycle.minimum <= min(kernel[far]) + 1e-10


@given(eps_alphas, eps_betas, shares, shares)
def test_extremes_are_reached(eps_alpha, eps_beta, S_R, T_R):
    """Sampling closely around the breakpoints and in between comes as near as the sampling allows."""
    cycle = mesh_cycle(eps_alpha, eps_beta, S_R, T_R)
    near = [0.0] if eps_beta > 0.0 else [-1e-9, 1e-9]
    # spur gears of a whole eps_alpha: at psi = 0 alone one pair enters as another one leaves, both count
    grid = np.linspace(0, 1, 2001) if eps_beta > 0.0 else np.linspace(0, 1, 2001)[1:-1]
    phases = np.concatenate([grid, *(cycle.breakpoints + d for d in near)])
    L = PairShape(c_prime=1.0, T_R=T_R).ramp_length(eps_alpha)
    kernel = width_moments(phases, eps_beta, 1.0, eps_alpha, S_R, L)[0]
    steep = 1e-6 * (1.0 + 1.0 / max(L, 1e-3))
    assert kernel.max() == pytest.approx(cycle.maximum, abs=2 * steep)
    assert kernel.min() == pytest.approx(cycle.minimum, abs=2 * steep)


@given(eps_alphas, st.floats(0.05, 3.0), shares, shares)
def test_moving_average_of_the_spur_wave(eps_alpha, eps_beta, S_R, T_R):
    """Independent of any width integral: integrate the spur gear's wave over eps_beta base pitches."""
    spur = mesh_cycle(eps_alpha, 0.0, S_R, T_R)
    helical = mesh_cycle(eps_alpha, eps_beta, S_R, T_R, n=11)
    x, w = np.polynomial.legendre.leggauss(4)
    L = PairShape(c_prime=1.0, T_R=T_R).ramp_length(eps_alpha)
    for psi, found in zip(helical.phase, helical.stiffness_ratio, strict=True):
        a, b = psi - eps_beta / 2, psi + eps_beta / 2
        turns = np.arange(math.floor(a) - 1, math.ceil(b) + 1)
        edges = np.unique(np.clip(np.add.outer(turns, spur.breakpoints).ravel(), a, b))
        edges = np.unique(np.concatenate([[a], edges, [b]]))
        total = 0.0
        for lo, hi in zip(edges[:-1], edges[1:], strict=True):
            if hi - lo < 1e-12:
                continue
            places = 0.5 * (lo + hi) + 0.5 * (hi - lo) * x
            total += 0.5 * (hi - lo) * w @ width_moments(places, 0.0, 1.0, eps_alpha, S_R, L)[0]
        assert found == pytest.approx(total / eps_beta, abs=1e-9)


@given(eps_alphas, eps_betas, shares, shares)
def test_swapping_the_gears_mirrors_the_cycle(eps_alpha, eps_beta, S_R, T_R):
    """The parabola is even about the middle of the path, so psi -> frac(eps_alpha) - psi changes nothing."""
    cycle = mesh_cycle(eps_alpha, eps_beta, S_R, T_R)
    rng = np.random.default_rng(3)
    L = PairShape(c_prime=1.0, T_R=T_R).ramp_length(eps_alpha)
    psi = rng.uniform(0.0, 1.0, 20)
    a, b = (width_moments(s, eps_beta, 1.0, eps_alpha, S_R, L)[0] for s in (psi, (eps_alpha % 1.0) - psi))
    assert a == pytest.approx(b, abs=1e-10)
    mirrored = pair_cycle(PairShape(c_prime=1.0, table=TABLE[::-1], T_R=T_R), eps_alpha, eps_beta)
    straight = pair_cycle(PairShape(c_prime=1.0, table=TABLE, T_R=T_R), eps_alpha, eps_beta)
    assert mirrored.minimum == pytest.approx(straight.minimum, abs=1e-10)
    assert mirrored.maximum == pytest.approx(straight.maximum, abs=1e-10)
    assert cycle.peak_to_peak == cycle.maximum - cycle.minimum


@pytest.mark.parametrize("eps_alpha", [0.9, 1.0, 1.3, 1.7, 2.0, 2.2, 3.5])
@pytest.mark.parametrize("T_R", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("eps_beta", [1e-15, 1e-13, 1e-11, 1e-10])
def test_small_overlap_meets_the_spur_gear(eps_alpha, T_R, eps_beta):
    spur, helical = (mesh_cycle(eps_alpha, e, 0.8, T_R) for e in (0.0, eps_beta))
    assert helical.mean == pytest.approx(spur.mean, abs=1e-12)
    assert helical.minimum == pytest.approx(spur.minimum, abs=1e-9)
    assert helical.maximum == pytest.approx(spur.maximum, abs=1e-9)
    assert spur.jumps == (() if T_R or eps_alpha % 1.0 == 0.0 else (0.0, pytest.approx(eps_alpha % 1.0)))
    assert helical.jumps == ()


@given(eps_alphas, st.floats(1e-3, 3.0), shares)
def test_tables(eps_alpha, eps_beta, T_R):
    shape = PairShape(c_prime=2e10, table=TABLE, T_R=T_R)
    cycle = pair_cycle(shape, eps_alpha, eps_beta, n=41)
    L = shape.ramp_length(eps_alpha)
    kernel = table_width_moments(cycle.phase, eps_beta, 1.0, eps_alpha, TABLE, L)[0]
    assert cycle.stiffness_ratio == pytest.approx(kernel, abs=1e-10)
    fine = np.linspace(0.0, eps_alpha, 200_001)
    ramp = np.clip(np.minimum(fine, eps_alpha - fine) / L, 0, 1) if L > 0 else 1.0
    law = np.interp(fine, np.linspace(0, eps_alpha, TABLE.size), TABLE) * ramp
    assert cycle.mean == pytest.approx(np.trapezoid(law, fine), abs=1e-4)


def test_less_than_one_pair_leaves_gaps():
    cycle = mesh_cycle(0.9, 0.0, 1.0)
    assert (cycle.minimum, cycle.maximum) == pytest.approx((0.0, 1.0), abs=1e-14)
    assert cycle.stiffness_ratio[380] == 0.0  # psi = 0.95


def test_prescribed_waves():
    rng = np.random.default_rng(7)
    for n in (1, 2, 5, 12):
        a, b = rng.uniform(-0.1, 0.1, (2, n))
        cycle = phase_cycle(PhaseStiffness(mean=1e8, cosine=a, sine=b))
        dense = PhaseStiffness(mean=1e8, cosine=a, sine=b).ratio(np.linspace(0, 1, 200_001))
        assert cycle.minimum == pytest.approx(dense.min(), abs=1e-7)
        assert cycle.maximum == pytest.approx(dense.max(), abs=1e-7)
        assert cycle.mean == 1.0
    flat = phase_cycle(PhaseStiffness(mean=1e8))
    assert (flat.minimum, flat.maximum, flat.peak_to_peak) == (1.0, 1.0, 0.0)
    missing = phase_cycle(PhaseStiffness(mean=1e8, cosine=np.array([0.0, 0.2, 0.0])))
    assert missing.peak_to_peak == pytest.approx(0.4)
    wave = phase_cycle(PhaseStiffness(mean=1e8, rectangular=(1.2, 0.8, 0.5)))
    assert (wave.mean, wave.maximum, wave.jumps) == (1.0, 1.2, (0.0, 0.5))
    table = phase_cycle(PhaseStiffness(mean=1e8, table=np.array([0.9, 1.1])))
    assert table.peak_to_peak == pytest.approx(0.2)


@pytest.mark.parametrize(("eps_alpha", "eps_beta"), [(0.0, 1.0), (-1.0, 0.0), (math.nan, 0.0), (1.3, -0.1)])
def test_impossible_ratios_are_refused(eps_alpha, eps_beta):
    with pytest.raises(ModelError, match="eps_"):
        mesh_cycle(eps_alpha, eps_beta)


@given(eps_alphas, st.floats(0.0, 0.999), st.integers(1, 4), shares, shares)
def test_whole_periods_of_overlap_add_the_mean(eps_alpha, part, whole, S_R, T_R):
    """k(psi) = (N k_mean + f k_f(psi - N/2))/(N + f), and the same with the extremes."""
    shape = PairShape(c_prime=1.0, S_R=S_R, T_R=T_R)
    psi = np.linspace(0.013, 0.987, 40)
    less, more = (cycle_pieces(shape, eps_alpha, part + n) for n in (0, whole))
    f = (part + whole) - whole  # as the sum is rounded
    expected = (whole * less.mean() + f * less.at(psi - 0.5 * whole)) / (part + whole)
    assert more.at(psi) == pytest.approx(expected, abs=1e-9)
    assert more.mean() == pytest.approx(less.mean(), rel=1e-12)


@given(st.lists(st.floats(-1.0, 1.0), min_size=5, max_size=5), st.integers(0, 4))
def test_extremes_of_a_quartic_are_those_at_the_roots_of_its_derivative(coefficients, degree):
    """NumPy's roots (eigenvalues of a companion matrix) as the reference; also where leading terms vanish."""
    c = np.array(coefficients)
    c[degree + 1 :] = 0.0
    polynomial = np.polynomial.Polynomial(c)
    roots = polynomial.deriv().trim(1e-14).roots().real
    values = polynomial(
        np.concatenate([[-1.0, 1.0], roots[np.abs(roots) < 1.0], np.linspace(-1.0, 1.0, 101)])
    )
    low, high = Pieces(np.zeros(1), np.ones(1), c[None, :]).extremes()
    assert (low[0], high[0]) == pytest.approx((values.min(), values.max()), abs=1e-12)


def test_many_overlap_ratios_at_once_are_those_of_single_cycles(monkeypatch):
    """Zero, tiny, whole and others together, also in parts: none depends on its neighbours."""
    up = np.array([0.0, 1e-13, 0.2, 0.5, 0.7, 1.0, 1.3, 2.0, 2.999999999999])
    for shape in (PairShape(c_prime=1.0, S_R=0.8, T_R=0.4), PairShape(c_prime=1.0, table=TABLE)):
        single = [pair_cycle(shape, 1.3, b).peak_to_peak for b in up.tolist()]
        assert variations(shape, 1.3, up) == pytest.approx(single, abs=1e-14)
        monkeypatch.setattr("pitchpoint.contact.cycle_pieces.MOST_AT_ONCE", 1)
        assert variations(shape, 1.3, up) == pytest.approx(single, abs=1e-14)
