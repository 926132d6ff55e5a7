# SPDX-License-Identifier: Apache-2.0
"""MS-OVERLAP, CONV and SEED-SIMPACK: mesh stiffness over the overlap ratio, means, tip-relief ramps.

Source: L. Mauer, "The new, powerful gearwheel module", SIMPACK User Meeting 2006: parabola with stiffness
ratio, its integral along the face width, tip-relief factor. Closed forms of the moving average for S_R = 1;
the numbers for S_R = 0.8 were computed independently of this package. Units of c' b throughout, as in the
slides. Tolerance 1e-6: seven printed digits.
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.contact.mesh_cycle import mesh_cycle

TABLE = [  # eps_alpha, eps_beta, peak to peak at S_R = 1, at 0.8
    (1.3, 0.0, 1.0, 0.8213018),
    (1.3, 0.3, 1.0, 0.7786982),
    (1.3, 0.7, 0.4285714, 0.3337278),
    (1.3, 0.85, 0.1764706, 0.1408632),
    (1.3, 1.0, 0.0, 0.0),
    (1.3, 2.0, 0.0, 0.0),
]


@pytest.mark.parametrize(("eps_alpha", "eps_beta", "p_p_1", "p_p_08"), TABLE)
def test_table(eps_alpha, eps_beta, p_p_1, p_p_08):
    assert mesh_cycle(eps_alpha, eps_beta, 1.0).peak_to_peak == pytest.approx(p_p_1, abs=1e-6)
    cycle = mesh_cycle(eps_alpha, eps_beta, 0.8)
    assert cycle.peak_to_peak == pytest.approx(p_p_08, abs=1e-6)
    assert cycle.mean == pytest.approx(1.2133333, abs=1e-6)


@pytest.mark.parametrize("eps_alpha", [1.1, 1.3, 1.5, 1.78, 2.2])
@pytest.mark.parametrize("eps_beta", [0.05, 0.2, 0.35, 0.5, 0.85, 1.3, 1.6, 2.4, 3.75])
def test_peak_to_peak_without_parabola(eps_alpha, eps_beta):
    e, f = eps_alpha % 1.0, eps_beta % 1.0
    expected = min(e, 1 - e, f, 1 - f) / eps_beta
    if eps_beta < min(e, 1 - e):
        expected = 1.0
    cycle = mesh_cycle(eps_alpha, eps_beta, 1.0)
    assert cycle.peak_to_peak == pytest.approx(expected, abs=1e-12)
    assert cycle.mean == pytest.approx(eps_alpha, abs=1e-12)


@pytest.mark.parametrize("S_R", [1.0, 0.8, 0.5])
@pytest.mark.parametrize("n", [1, 2, 3])
def test_integer_overlap_is_constant(S_R, n):
    assert mesh_cycle(1.3, float(n), S_R).peak_to_peak < 1e-12


@pytest.mark.parametrize("n", [0, 1, 2])
@pytest.mark.parametrize("eps_alpha", [1.3, 1.7])
def test_sharp_edges(eps_alpha, n):
    """The upper plateau vanishes at eps_beta = eps_alpha - 1 + n, the lower one at 2 - eps_alpha + n."""

    def plateau(eps_beta, level):
        cycle = mesh_cycle(eps_alpha, eps_beta, 1.0, n=20001)
        edge = getattr(cycle, level)
        return sum(abs(k - edge) < 1e-9 for k in cycle.stiffness_ratio) / 20001

    assert plateau(eps_alpha - 1 + n, "maximum") < 1e-3
    assert plateau(2 - eps_alpha + n, "minimum") < 1e-3
    for shift in (-0.05, 0.05):
        assert plateau(eps_alpha - 1 + n + shift, "maximum") > 0.04
        assert plateau(2 - eps_alpha + n + shift, "minimum") > 0.04


@pytest.mark.parametrize("eps_beta", [0.0, 0.4, 1.7])
@pytest.mark.parametrize(("eps_alpha", "S_R", "mean"), [(1.3, 1.0, 1.3), (1.3, 0.8, 1.2133333)])
def test_means_of_the_slides(eps_alpha, eps_beta, S_R, mean):
    assert mesh_cycle(eps_alpha, eps_beta, S_R).mean == pytest.approx(mean, abs=1e-7)


@pytest.mark.parametrize(("eps_alpha", "S_R"), [(1.3, 0.8269231), (1.5, 0.75)])
def test_stiffness_ratio_that_meets_the_standards_mean(eps_alpha, S_R):
    assert 1 - 0.75 * (1 - 1 / eps_alpha) == pytest.approx(S_R, abs=1e-7)
    exact = 1 - 0.75 * (1 - 1 / eps_alpha)
    assert mesh_cycle(eps_alpha, 0.0, exact).mean == pytest.approx(0.75 * eps_alpha + 0.25, abs=1e-12)


def test_tip_relief_ramps():
    relieved = mesh_cycle(1.3, 0.0, 1.0, 0.75)
    assert relieved.minimum == pytest.approx(1.0, abs=1e-12)
    assert relieved.maximum == pytest.approx(4 / 3, abs=1e-12)
    assert relieved.mean == pytest.approx(1.075, abs=1e-12)
    full = mesh_cycle(1.3, 0.0, 1.0, 1.0)
    assert full.peak_to_peak < 1e-12
    assert full.mean == pytest.approx(1.0, abs=1e-12)
    assert full.jumps == relieved.jumps == ()


def test_slices_converge_to_the_integral():
    """Slices err by up to one slice at either extreme: in the order of 1/slices."""
    exact = mesh_cycle(1.3, 0.85, 1.0)

    def sliced(slices):
        def total(psi):
            places = [psi + 0.85 * ((i + 0.5) / slices - 0.5) for i in range(slices)]
            return sum(math.floor(p) - math.ceil(p - 1.3) + 1 for p in places) / slices

        values = [total(i / 4001) for i in range(4001)]
        return max(values) - min(values)

    for slices in (20, 100, 400):
        assert abs(sliced(slices) - exact.peak_to_peak) <= 2.0 / slices
