# SPDX-License-Identifier: Apache-2.0
"""Hertzian approach of a contact node: published numbers, slopes by complex steps, energy as work."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from pitchpoint.contact.local_approach import (
    N_NODE,
    PAIR_MATERIAL,
    D,
    energy_slopes,
    local_approach,
    local_energy,
    local_force,
    set_node,
)

pytestmark = pytest.mark.nojit

STEEL = 206e9, 0.3
BRONZE = 110e9, 0.34
RADIUS_17_43 = 8.5e-3 * 21.5e-3 / 30e-3 * math.sin(math.radians(20.0))
"""Spur pair 17/43, 1 mm, 20 deg, at the pitch point: r_1 r_2/a sin(alpha) [m]."""


def node_of(length, radius, depths, bodies=(STEEL, BRONZE), compliance=0.0):
    """One node, from Young's modulus and Poisson's ratio of both bodies."""
    material = np.zeros(1, PAIR_MATERIAL)[0]
    material["c"] = [(1.0 - nu * nu) / E for E, nu in bodies]
    material["kappa"] = [nu / (1.0 - nu) for _, nu in bodies]
    node = np.zeros((1, N_NODE))
    set_node(node, 0, length, radius, depths, material, compliance)
    return node


def approach(f, length, radius, depths, bodies=(STEEL, BRONZE), compliance=0.0):
    """The formula as printed, for real and complex numbers."""
    c = [(1.0 - nu * nu) / E for E, nu in bodies]
    q = f / length
    b = np.sqrt(4.0 * q * radius * sum(c) / math.pi)
    h = compliance * f
    for k in (0, 1):
        t, nu = depths[k], bodies[k][1]
        bracket = np.arcsinh(t / b) - nu / (1.0 - nu) * t / (np.sqrt(t * t + b * b) + t)
        h = h + 2.0 * c[k] / math.pi * q * bracket
    return h


CASES = {
    "steel": (0.01, 2e-3, (1e-3, 1e-3), (STEEL, STEEL), 0.0),
    "steel on bronze": (0.001, 20e-3, (2e-3, 3e-3), (STEEL, BRONZE), 1e-10),
    "thin layer": (0.001, 0.5, (1e-5, 2e-5), (STEEL, BRONZE), 0.0),
}


@pytest.mark.parametrize(
    ("q", "numbers"),
    [
        (100.0, (7.92088, 9.23780, 9.86421)),
        (300.0, (6.39187, 7.69923, 8.32341)),
        (1000.0, (4.75239, 6.02777, 6.64431)),
    ],
)
def test_line_compliance_of_one_body(q, numbers):
    """Bracket of one steel body, 1e-3 um per N/mm, at the depths 0.5, 0.8 and 1 mm; 5 decimals."""
    for depth, number in zip((0.5e-3, 0.8e-3, 1.0e-3), numbers, strict=True):
        node = node_of(1e-3, RADIUS_17_43, (depth, depth), (STEEL, STEEL))
        assert 0.5 * local_approach(node, 0, q)[0] / q * 1e9 == pytest.approx(number, rel=1e-6)


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("f", [1e-200, 1e-9, 1e-2, 3e2, 1e5])
def test_approach_and_slope(case, f):
    """Slope by a complex step, which has no rounding error of differences."""
    node = node_of(*CASES[case])
    h, slope = local_approach(node, 0, f)
    assert h == pytest.approx(approach(f, *CASES[case]), rel=1e-13)
    step = 1e-30 * f
    assert slope == pytest.approx(approach(f + 1j * step, *CASES[case]).imag / step, rel=1e-12)
    assert local_approach(node, 0, -f) == (-h, slope)


@given(
    st.floats(-12.0, 8.0),
    st.floats(-4.0, 0.0),
    st.floats(-4.0, 1.0),
    st.floats(-6.0, 0.0),
    st.floats(-6.0, 0.0),
    st.floats(0.05, 0.495),
)
def test_approach_increases_and_is_concave(f, length, radius, t_1, t_2, nu):
    """Down to contacts far wider than deep: h increases, and its slope falls."""
    bodies = (206e9, nu), (2e9, 0.4)
    node = node_of(10.0**length, 10.0**radius, (10.0**t_1, 10.0**t_2), bodies)
    force = 10.0**f
    h, slope = local_approach(node, 0, force)
    higher, flatter = local_approach(node, 0, 1.1 * force)
    assert 0.0 < slope * force <= h
    assert higher > h
    assert flatter < slope


@pytest.mark.parametrize("case", CASES)
def test_slope_is_unbounded_only_as_a_logarithm(case):
    node = node_of(*CASES[case])
    slopes = [local_approach(node, 0, f)[1] for f in (1e-240, 1e-120, 1e-60)]
    assert slopes[0] > slopes[1] > slopes[2]
    assert slopes[0] / slopes[1] == pytest.approx(2.0, rel=0.1)
    h, slope = local_approach(node, 0, 0.0)
    assert h == 0.0
    assert slopes[0] < slope < math.inf


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("f", [1e-3, 3e2, 1e5])
def test_energy_is_the_integral_of_the_approach(case, f):
    node = node_of(*CASES[case])
    # f = g^2 removes the singularity of the slope from the integrand
    work = quad(
        lambda g: approach(g * g, *CASES[case]) * 2.0 * g, 0.0, math.sqrt(f), epsabs=0.0, epsrel=1e-12
    )
    assert local_energy(node, 0, f) == pytest.approx(work[0], rel=1e-11)


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("f", [1e-3, 3e2, 1e5])
def test_derivatives_of_the_energy_at_constant_force(case, f):
    """Differences of fourth order of the energy; the linear compliance does not depend on the length."""
    length, radius, depths, bodies, soft = CASES[case]

    def energy(at):
        """Energy at scaled radius, depths and length."""
        scaled = depths[0] * at[1], depths[1] * at[2]
        return local_energy(node_of(length * at[3], radius * at[0], scaled, bodies, soft), 0, f)

    found = energy_slopes(node_of(*CASES[case]), 0, f)
    for k, scale in enumerate((1.0, depths[0], depths[1], 1.0)):
        values = []
        for step in (2e-3, 1e-3, -1e-3, -2e-3):
            at = np.ones(4)
            at[k] += step
            values.append(energy(at))
        slope = (8.0 * (values[1] - values[2]) - (values[0] - values[3])) / 12e-3
        assert found[k] * scale == pytest.approx(slope, rel=1e-9, abs=1e-12 * energy(np.ones(4)))


def test_linear_nodes_have_no_hertzian_part():
    node = np.zeros((1, N_NODE))
    node[0, D] = 3e-9
    assert local_approach(node, 0, 200.0) == (6e-7, 3e-9)
    assert local_energy(node, 0, 200.0) == pytest.approx(6e-5, rel=1e-15)
    assert energy_slopes(node, 0, 200.0) == (0.0, 0.0, 0.0, 0.0)
    assert local_force(node, 0, 6e-7, 0.0) == pytest.approx(200.0, rel=1e-15)


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("compliance", [0.0, 1e-12, 1e-6])
@pytest.mark.parametrize("f", [1e-150, 1e-6, 1.0, 1e3, 1e7])
def test_force_of_an_overlap(case, compliance, f):
    node = node_of(*CASES[case])
    overlap = local_approach(node, 0, f)[0] + compliance * f
    assert local_force(node, 0, overlap, compliance) == pytest.approx(f, rel=1e-11)
    assert local_force(node, 0, 0.0, compliance) == 0.0
    assert local_force(node, 0, -overlap, compliance) == 0.0
