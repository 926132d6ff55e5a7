# SPDX-License-Identifier: Apache-2.0
"""Turbulence from a seed: spectrum, variance, coherence, seeds; limits from the number of averages."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad

from pitchpoint.core.errors import ModelError
from pitchpoint.model.wind.iec import WindClass
from pitchpoint.model.wind.turbulence import KaimalTurbulence
from pitchpoint.solvers.turbulence import coherent_phases
from pitchpoint.solvers.turbulence.box import frequencies, line_variances, make_turbulence
from pitchpoint.solvers.turbulence.kaimal import coherence_decay, spectral_density

WIND = KaimalTurbulence(
    mean_speed=12.0,
    deviation=1.8,
    hub_height=90.0,
    size=(30.0, 45.0),
    points=(4, 4),
    duration=60.0,
    time_step=0.1,
    coherent="uvw",
)
SEEDS = 60
SIGMAS = 5.0
"""Limit of all statistical comparisons in standard deviations of the estimate; 6e-7 is exceeded by chance."""


@pytest.fixture(scope="module")
def lines() -> np.ndarray:
    """Fourier coefficients over those of unit variance, shape (seed, line, z, y, component)."""
    found = []
    amplitude = np.stack([np.sqrt(0.5 * line_variances(WIND, k)) for k in range(3)], axis=-1)
    for seed in range(SEEDS):
        whole = np.fft.rfft(make_turbulence(WIND, seed).velocity.astype(float), axis=0) / WIND.samples
        found.append(whole[1 : 1 + len(amplitude)] / amplitude[:, None, None, :])
    return np.array(found)


# --------------------------------------------------------------------------------------------- closed forms


@pytest.mark.parametrize("component", range(3))
def test_lines_are_the_spectrum_integrated_over_their_bands(component: int) -> None:
    f, found = frequencies(WIND), line_variances(WIND, component)
    deviation = 1.8 * (1.0, 0.8, 0.5)[component]
    assert found.sum() == pytest.approx(deviation**2, rel=1e-12)

    def density(x: float) -> float:
        return 4 * deviation**2 * length / 12.0 / (1 + 6 * x * length / 12.0) ** (5 / 3)

    length = 42.0 * (8.1, 2.7, 0.66)[component]
    bands = np.array([quad(density, x - 0.5 * f[0], x + 0.5 * f[0])[0] for x in f[[0, 5, 100, -1]]])
    factor = deviation**2 / quad(density, 0.5 * f[0], f[-1] + 0.5 * f[0], limit=200)[0]
    np.testing.assert_allclose(found[[0, 5, 100, -1]], factor * bands, rtol=1e-7)


def test_spectrum_and_coherence_against_pyconturb() -> None:
    """Numbers of `kaimal_spectrum` and `get_iec3d_cor_mat` of pyconturb 2.7.4 (MIT), points 10 m apart."""
    reference = {0.01: (70.13752305, 37.07676121, 6.02844113), 1.0: (0.06967464, 0.09097536, 0.08332826)}
    for f, expected in reference.items():
        found = [spectral_density(f, k, 1.8 * s, 12.0, 90.0) for k, s in enumerate((1.0, 0.8, 0.5))]
        assert found == pytest.approx(list(expected), rel=1e-7)  # digits printed
    for k, expected in enumerate(
        ((0.89709867, 0.36755018), (0.85075405, 0.36493711), (0.58918328, 0.32404248))
    ):
        found = np.exp(-10.0 * coherence_decay([0.01, 0.1], k, 12.0, 90.0))
        np.testing.assert_allclose(found, expected, rtol=1e-7)


def test_lines_against_a_record_of_pyconturb() -> None:
    """First point of `gen_turb` of pyconturb 2.7.4: T 60 s, 600 samples, 12 m/s, class B, lines 1, 2, 6, 60.

    It takes the density at the middle of each band, half of it at the last one, and 599/600 of σ².
    """
    reference = np.array([1.62338788, 0.64538895, 0.12326555, 0.00289255])
    density = spectral_density(np.arange(1, 301) / 60.0, 0, 1.0, 12.0, 90.0)
    variance = (0.14 * 14.6) ** 2
    middle = density / (density.sum() - 0.5 * density[-1]) * variance * 599.0 / 600.0
    np.testing.assert_allclose(middle[[0, 1, 5, 59]], reference, rtol=1e-6)


@pytest.mark.parametrize(
    ("points", "spacing", "decay"),
    [
        ((4, 3), (5.0, 7.0), 0.3),
        ((9, 9), (10.0, 10.0), 0.05),
        ((12, 1), (5.0, 1.0), 0.2),
        ((1, 9), (1.0, 2.0), 0.9),
    ],
)
def test_both_square_roots_give_the_coherence_matrix(
    points: tuple[int, int], spacing: tuple[float, float], decay: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Column by column with unit vectors in place of random phases: B B* is exp(-c r) for all pairs."""
    period = tuple(
        max(2 * n, 2 * math.ceil(6.0 / (decay * d))) if n > 1 else 1
        for n, d in zip(points, spacing, strict=True)
    )
    z, y = (
        g.ravel()
        for g in np.meshgrid(
            np.arange(points[1]) * spacing[1], np.arange(points[0]) * spacing[0], indexing="ij"
        )
    )
    target = np.exp(-decay * np.hypot(y[:, None] - y, z[:, None] - z))
    rng = np.random.default_rng(0)
    for name, count in (("transform", period[0] * period[1]), ("cholesky", points[0] * points[1])):
        columns = []
        for k in range(count):
            unit = np.zeros(count, complex)
            unit[k] = 1.0
            monkeypatch.setattr(coherent_phases, "_phases", lambda shape, _, u=unit: u.reshape(shape))
            if name == "transform":
                whole = coherent_phases._by_transform(np.array([decay]), points, spacing, period, rng)
            else:
                whole = coherent_phases._by_cholesky(decay, points, spacing, rng)
            columns.append(whole.ravel())
        root = np.array(columns).T
        np.testing.assert_allclose(root @ root.conj().T, target, atol=1e-12)


def test_a_period_that_is_too_short_is_noticed() -> None:
    """It has negative eigenvalues: the coefficients are those of the Cholesky factor."""
    decay = np.array([0.01])
    found = coherent_phases._by_transform(decay, (6, 6), (5.0, 5.0), (10, 10), np.random.default_rng(2))
    rng = np.random.default_rng(2)
    rng.random((1, 10, 10))
    expected = coherent_phases._by_cholesky(0.01, (6, 6), (5.0, 5.0), rng)
    np.testing.assert_array_equal(found[0], expected)


# ---------------------------------------------------------------------------------- a second implementation


def test_a_naive_sum_of_cosines_gives_the_same_wind() -> None:
    """Veers (1988) written out for four points: waves with the phases of the same random numbers."""
    wind = replace(WIND, size=(20.0, 30.0), points=(2, 2), duration=10.0)
    box = make_turbulence(wind, seed=7)
    t, places = np.arange(100) * 0.1, [(z, y) for z in (0.0, 30.0) for y in (0.0, 20.0)]
    length = 42.0 * np.array([8.1, 2.7, 0.66])
    for component, share in enumerate((1.0, 0.8, 0.5)):
        rng = np.random.default_rng([7, component])
        scale = length[component]
        edges = (np.arange(1, 51) - 0.5) * 0.1
        rest = (1 + 6 * edges * scale / 12.0) ** (-2 / 3)
        variance = (rest[:-1] - rest[1:]) / (rest[0] - rest[-1]) * (1.8 * share) ** 2
        series = np.zeros((4, 100))
        for k in range(1, 50):
            decay = 12.0 * math.sqrt((0.1 * k / 12.0) ** 2 + (0.12 / scale) ** 2)
            matrix = [[math.exp(-decay * math.dist(a, b)) for b in places] for a in places]
            factor, phase = np.linalg.cholesky(matrix), 2 * math.pi * rng.random(4)
            for i in range(4):
                for j in range(i + 1):
                    wave = np.cos(2 * math.pi * 0.1 * k * t + phase[j])
                    series[i] += math.sqrt(2 * variance[k - 1]) * factor[i, j] * wave
        np.testing.assert_allclose(box.velocity[..., component].reshape(100, 4).T, series, atol=2e-6)


# ------------------------------------------------------------------------------------------------ statistics


def test_mean_is_zero_at_every_point() -> None:
    assert np.abs(make_turbulence(WIND, 0).velocity.mean(axis=0, dtype=float)).max() < 1e-6


def test_components_without_coherence_have_their_spectrum_exactly() -> None:
    """Each wave has its amplitude; the variance of every record is σ²."""
    velocity = make_turbulence(replace(WIND, coherent="u"), 1).velocity.astype(float)
    for component, deviation in ((1, 1.44), (2, 0.9)):
        np.testing.assert_allclose(velocity[..., component].var(axis=0), deviation**2, rtol=1e-5)
        power = 2.0 * np.abs(np.fft.rfft(velocity[..., component], axis=0)[1:300] / 600.0) ** 2
        expected = line_variances(WIND, component)[:, None, None]
        np.testing.assert_allclose(power, np.broadcast_to(expected, power.shape), rtol=1e-3)


def test_deviations_are_those_of_a_file_of_turbsim() -> None:
    """`TurbSim_NoTwr.bts` of openfast_toolbox, TurbSim 2.00.07a, class B at 8 m/s: v 1.2992, w 0.8120 m/s."""
    deviation = WindClass("I", "B").normal_deviation(8.0)
    wind = replace(WIND, mean_speed=8.0, deviation=deviation, coherent="u")
    found = make_turbulence(wind, 1).velocity.std(axis=(0, 1, 2), dtype=float)
    assert found[1:] == pytest.approx([1.2992, 0.8120], abs=1e-4)


def test_spectra_of_all_components_within_their_spread(lines: np.ndarray) -> None:
    """Mean of |X|² over seeds and 23 lines: 1, standard deviation at most 1/sqrt(averages) of a Gaussian."""
    power = np.abs(lines) ** 2
    bands = power.reshape(SEEDS, 13, 23, 4, 4, 3).mean(axis=(0, 2))
    assert np.abs(bands - 1.0).max() < SIGMAS / math.sqrt(SEEDS * 23)


def test_variance_within_its_spread(lines: np.ndarray) -> None:
    """Variance of a record: Σ P |X|², standard deviation at most sqrt(Σ P²)."""
    for component, deviation in enumerate((1.8, 1.44, 0.9)):
        share = line_variances(WIND, component)
        found = np.einsum("k,skzy->zy", share, np.abs(lines[..., component]) ** 2) / SEEDS
        limit = SIGMAS * math.sqrt((share**2).sum() / SEEDS)
        assert np.abs(found - deviation**2).max() < limit


def coherence_matrices(component: int) -> tuple[np.ndarray, np.ndarray]:
    """Products c r of decay and distance, and the target exp(-c r), shape (line, point, point)."""
    scale = 42.0 * (8.1, 2.7, 0.66)[component]
    decay = 12.0 * np.sqrt((np.arange(1, 300) / 60.0 / 12.0) ** 2 + (0.12 / scale) ** 2)
    y, z = (g.ravel() for g in np.meshgrid(np.arange(4) * 10.0, np.arange(4) * 15.0))
    product = decay[:, None, None] * np.hypot(y[:, None] - y, z[:, None] - z)
    return product, np.exp(-product)


@pytest.mark.parametrize("component", range(3))
def test_coherence_of_all_pairs_within_its_spread(lines: np.ndarray, component: int) -> None:
    """Mean of Re X_i X_j* over seeds and lines: C, standard deviation at most sqrt((1 + C²)/(2 averages))."""
    x = lines[..., component].reshape(SEEDS, 299, 16)
    cross = np.einsum("ski,skj->kij", x, x.conj()).real / SEEDS
    target = coherence_matrices(component)[1]
    pairs = ~np.eye(16, dtype=bool)
    for low, high in ((0, 1), (1, 3), (3, 10), (10, 40), (40, 299)):
        error = (cross - target)[low:high, pairs].mean(axis=0)
        spread = np.sqrt((1.0 + target[low:high, pairs] ** 2).mean(axis=0) / (2.0 * SEEDS * (high - low)))
        assert (np.abs(error) < SIGMAS * spread).all()


@pytest.mark.parametrize("component", range(3))
def test_decay_of_the_coherence_from_all_pairs_together(lines: np.ndarray, component: int) -> None:
    """Score of a factor on the decay: expectation 0, standard deviation of the factor 1/sqrt(information).

    With C' = dC/dln c it is tr(C⁻¹ C' C⁻¹ (X X* - C)), its variance tr(C⁻¹ C' C⁻¹ C') for Gaussian X, less
    for sums of waves with random phases.
    """
    x = lines[..., component].reshape(SEEDS, 299, 16)
    cross = np.einsum("ski,skj->kij", x, x.conj()).real / SEEDS
    product, target = coherence_matrices(component)
    weight = np.linalg.solve(target, -product * target)
    information = np.einsum("kij,kji->", weight, weight)
    excess = np.linalg.solve(target, cross - target)
    factor = np.einsum("kij,kji->", weight, excess) / information
    limit = SIGMAS / math.sqrt(SEEDS * information)
    assert limit < 0.08  # a decay that is wrong by 16 % is always noticed
    assert abs(factor) < limit


def test_quadrature_components_and_seeds_are_independent(lines: np.ndarray) -> None:
    """Cross spectra with zero expectation: standard deviation at most 1/sqrt(2 averages)."""
    limit = SIGMAS / math.sqrt(2.0 * SEEDS * 299)
    first, last = lines[:, :, 0, 0], lines[:, :, 3, 3]
    for a, b in (
        (first[..., 0], first[..., 1]),
        (first[..., 0], first[..., 2]),
        (first[..., 1], last[..., 2]),
        (first[..., 0], np.roll(first[..., 0], 1, axis=0)),  # the next seed
    ):
        assert np.abs((a * b.conj()).mean()) < math.sqrt(2.0) * limit
    assert abs((first[..., 0] * last[..., 0].conj()).imag.mean()) < limit


def test_seeds() -> None:
    one, again, other = (make_turbulence(WIND, seed).velocity for seed in (3, 3, 4))
    assert (one == again).all()
    assert (one != other).mean() > 0.99
    for seed in (-1, 1.0, True, "1"):
        with pytest.raises(ModelError, match="turbulence.seed: .* is not an integer from 0"):
            make_turbulence(WIND, seed)  # type: ignore[arg-type]


def test_results_do_not_depend_on_the_size_of_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    """Frequencies take their random numbers in order: memory may be bounded anywhere."""
    from pitchpoint.solvers.turbulence import box

    wind = replace(WIND, points=(6, 5))
    whole = make_turbulence(wind, 5).velocity
    monkeypatch.setattr(box, "_BLOCK", 1000)
    monkeypatch.setattr(coherent_phases, "_BATCH", 500)
    np.testing.assert_allclose(make_turbulence(wind, 5).velocity, whole, atol=1e-6)


def test_one_point_and_a_line_of_points() -> None:
    one = make_turbulence(replace(WIND, size=(0.0, 0.0), points=(1, 1)), 1)
    assert one.velocity.shape == (600, 1, 1, 3)
    assert one.velocity[:, 0, 0, 0].astype(float).var() == pytest.approx(1.8**2, rel=1e-5)
    line = make_turbulence(replace(WIND, size=(0.0, 60.0), points=(1, 5)), 1)
    assert line.velocity.shape == (600, 5, 1, 3)
    assert line.z[[0, -1]].tolist() == [60.0, 120.0]
