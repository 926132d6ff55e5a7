# SPDX-License-Identifier: Apache-2.0
"""Sobol' indices and regression against closed forms, SciPy, and factors without influence."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats
from scipy.stats import qmc

from pitchpoint.analysis.study.sensitivity import Array, regression, sobol_indices
from pitchpoint.analysis.study.statistics import QUANTILES, share_with_interval, spread_of


def ishigami(x: Array) -> Array:
    """T. Ishigami, T. Homma (1990), with a = 7, b = 0.1."""
    return np.asarray(np.sin(x[0]) + 7.0 * np.sin(x[1]) ** 2 + 0.1 * x[2] ** 4 * np.sin(x[0]))


def saltelli(n: int) -> tuple[Array, Array, Array]:
    points = np.pi * (2.0 * qmc.Sobol(6, rng=1).random(n).T - 1.0)
    a, b = points[:3], points[3:]
    mixed = []
    for k in range(3):
        one = a.copy()
        one[k] = b[k]
        mixed.append(ishigami(one))
    return ishigami(a), ishigami(b), np.array(mixed).T


def test_indices_of_ishigami() -> None:
    v1 = 0.5 * (1.0 + 0.1 * np.pi**4 / 5.0) ** 2
    v2 = 7.0**2 / 8.0
    v13 = 0.1**2 * np.pi**8 * (1.0 / 18.0 - 1.0 / 50.0)
    v = v1 + v2 + v13
    first, total = sobol_indices(*saltelli(4096))
    for found, exact in ((first, (v1, v2, 0.0)), (total, (v1 + v13, v2, v13))):
        width = found.high - found.low  # four standard errors
        assert np.all(np.abs(found.value - np.array(exact) / v) <= width) and np.all(width < 0.15)


def test_indices_are_those_of_scipy() -> None:
    a, b, ab = saltelli(256)
    own = sobol_indices(a, b, ab)
    theirs = stats.sobol_indices(func={"f_A": a[None, :], "f_B": b[None, :], "f_AB": ab.T[:, None, :]}, n=256)
    # SciPy subtracts the mean of the samples before the estimate, as here
    assert own[0].value == pytest.approx(theirs.first_order.ravel(), abs=1e-9)
    assert own[1].value == pytest.approx(theirs.total_order.ravel(), abs=1e-9)


def test_failed_points_are_left_out_with_all_their_values() -> None:
    a, b, ab = saltelli(256)
    bad = ab.copy()
    bad[7, 1] = np.nan
    keep = np.arange(256) != 7
    found = sobol_indices(a, b, bad)[1]
    assert found.value == pytest.approx(sobol_indices(a[keep], b[keep], ab[keep])[1].value)


def test_regression_of_a_linear_result() -> None:
    x = np.random.default_rng(3).standard_normal((3, 400))
    x[1] *= 2.0
    found = regression(list(x), 3.0 * x[0] + 2.0 * x[1] + 7.0)
    spread = np.array([3.0 * x[0].std(), 2.0 * x[1].std()]) / (3.0 * x[0] + 2.0 * x[1]).std()
    assert found.coefficient.value == pytest.approx([*spread, 0.0], abs=1e-12)
    assert found.determination == pytest.approx(1.0)
    assert found.share.value[2] == pytest.approx(0.0, abs=1e-12)
    assert found.rank.value[0] == pytest.approx(stats.spearmanr(x[0], 3.0 * x[0] + 2.0 * x[1]).statistic)


def test_labels_are_a_factor_with_indicators() -> None:
    label = np.tile([0, 1, 2], 40)
    noise = np.random.default_rng(2).standard_normal(120)
    result = np.array([0.0, 5.0, -5.0])[label] + noise
    found = regression([noise, (label[:, None] == [1, 2]).astype(float)], result)
    assert np.isnan(found.coefficient.value[1]) and found.determination == pytest.approx(1.0)
    assert found.share.value[1] > 0.9 > 0.1 > found.share.value[0] > 0.0


def test_noise_is_not_read_as_sensitivity() -> None:
    """The interval of a factor without influence contains zero about as often as the level states."""
    hits, shares = 0, []
    for seed in range(60):
        x = np.random.default_rng(seed).standard_normal((2, 60))
        found = regression([x[0]], x[1])
        hits += found.coefficient.low[0] <= 0.0 <= found.coefficient.high[0]
        shares.append(found.share.value[0])
    assert hits >= 60 - stats.binom.ppf(0.999, 60, 0.07)
    assert abs(np.mean(shares)) < 3.0 * np.std(shares) / np.sqrt(60)  # corrected for chance


def test_constant_results_have_no_sensitivities() -> None:
    x = np.random.default_rng(1).standard_normal((2, 32))
    assert np.all(np.isnan(regression(list(x), np.full(32, 5.0)).share.value))
    assert np.all(np.isnan(sobol_indices(np.ones(8), np.ones(8), np.ones((8, 2)))[0].value))


def test_intervals_of_quantiles_and_shares() -> None:
    values = np.random.default_rng(5).standard_normal(200)
    values[3] = np.nan
    spread = spread_of(values, 0.9)
    assert spread.count == 199
    assert len(spread.quantiles) == len(QUANTILES)
    for found in spread.quantiles:
        assert not found.low > found.value and not found.value > found.high
    low, high = spread.quantiles[2].low, spread.quantiles[2].high
    theirs = stats.quantile_test(values[np.isfinite(values)], p=0.5).confidence_interval(0.9)
    assert (low, high) == pytest.approx(tuple(theirs), abs=0.05)
    assert np.isnan(spread_of(values[:20]).quantiles[0].low)  # 20 values have no limit below the 1 % quantile
    none = share_with_interval(0, 100)
    assert (none.low, none.high) == pytest.approx((0.0, 1.0 - 0.025**0.01))
    assert spread_of(np.full(3, np.nan)).count == 0
