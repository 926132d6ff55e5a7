# SPDX-License-Identifier: Apache-2.0
"""Comparison with few healthy records: closed forms, false alarms and detection of Gaussian features."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats
from scipy.special import polygamma

from pitchpoint.analysis.changed_parts import changed_parts
from pitchpoint.analysis.healthy_reference import deviations, healthy_range, left_at
from pitchpoint.analysis.record_features import Feature
from pitchpoint.analysis.sampled import SignalError


def correlated(rng: np.random.Generator, records: int, features: int) -> np.ndarray:
    """Gaussian features with unequal scatter, half of their variance common to four groups."""
    own = rng.standard_normal((records, features))
    common = rng.standard_normal((records, 4)) @ np.kron(np.eye(4), np.ones((1, features // 4)))
    return (own + common) * np.exp(0.5 * rng.standard_normal(features))


@pytest.mark.parametrize(("count", "loads"), [(4, False), (4, True), (8, True)])
def test_the_stated_rate_of_false_alarms_holds_and_a_shift_is_found(count: int, loads: bool) -> None:
    rng = np.random.default_rng(1)
    draws, features, above, found = 150, 40, 0, 0
    for _ in range(draws):
        point = np.arange(count + 1.0)[:, None] if loads else np.empty((count + 1, 0))
        y = correlated(rng, count + 1, features) + point @ np.full((point.shape[1], features), 3.0)
        k = int(rng.integers(count + 1))
        rest = np.arange(count + 1) != k
        limits = healthy_range(y[rest], point[rest])
        assert limits is not None and limits.rate == 1.0 / (count + 1)
        above += deviations(y[rest], y[k], point[rest], point[k]).distance > limits.limit
        changed = y[k] + np.where(np.arange(features) % 3 == 0, 12.0, 0.0)
        found += deviations(y[rest], changed, point[rest], point[k]).distance > limits.limit
    # three standard deviations of the binomial distribution
    rate = 1.0 / (count + 1)
    assert above / draws <= rate + 3.0 * np.sqrt(rate * (1.0 - rate) / draws)
    assert above > 0
    assert found / draws > (0.75 if count == 4 else 0.95)


def test_single_features_have_the_stated_probability() -> None:
    # variances from a scaled inverse chi-square distribution, for which the moderated t distribution is exact
    rng = np.random.default_rng(2)
    features, prior, nu = 40_000, 4.0, 2.0
    scatter = np.sqrt(prior / rng.chisquare(prior, features))
    x = np.array([0.0, 1.0, 2.0, 3.0, 7.0])
    y = scatter * rng.standard_normal((5, features)) + 2.0 * x[:, None]
    found = deviations(y[:4], y[4], x[:4, None], x[4:])
    # ν₀ from ψ'(ν₀/2) = variance of log s² less ψ'(ν/2): three standard deviations of the sample variance of
    # log F, whose fourth cumulant is ψ'''(ν/2) + ψ'''(ν₀/2)
    fourth, variance = (sum(float(polygamma(order, 0.5 * free)) for free in (nu, prior)) for order in (3, 1))
    scatter_of_variance = np.sqrt((fourth + 2.0 * variance**2) / features)
    allowed = 3.0 * scatter_of_variance * 2.0 / -float(polygamma(2, 0.5 * prior))
    assert allowed < 0.32
    assert found.freedom == pytest.approx(prior + nu, abs=allowed)
    for level in (0.5, 0.1, 0.01):
        assert np.mean(found.probability < level) == pytest.approx(level, abs=4.0 * np.sqrt(level / features))


def test_prediction_beyond_the_healthy_points_is_the_regression_interval() -> None:
    x, y = np.array([0.0, 1.0, 2.0, 4.0]), np.array([1.0, 2.5, 2.5, 5.0])
    line = stats.linregress(x, y)
    residual = y - line.intercept - line.slope * x
    s = np.sqrt(residual @ residual / 2.0)
    spread = s * np.sqrt(1.0 + 0.25 + (6.0 - x.mean()) ** 2 / np.sum((x - x.mean()) ** 2))
    found = deviations(y[:, None], [10.0], x[:, None], [6.0])
    assert found.expected[0] == pytest.approx(line.intercept + 6.0 * line.slope)
    assert found.spread[0] == pytest.approx(spread)
    assert found.probability[0] == pytest.approx(2.0 * stats.t.sf(found.deviation[0] / spread, 2))


def test_too_few_records_give_differences_without_a_limit() -> None:
    one = deviations([[1.0, 2.0]], [2.0, 5.0])
    assert one.deviation.tolist() == [1.0, 3.0] and np.isnan(one.spread).all() and np.isnan(one.distance)
    assert healthy_range([[1.0], [2.0]]) is None
    assert healthy_range([[1.0], [2.0], [2.5]], [[0.0], [1.0], [2.0]]) is None
    with pytest.raises(SignalError, match="do not determine"):
        deviations([[1.0], [2.0], [2.5]], [3.0], [[1.0], [1.0], [1.0]], [2.0])
    with pytest.raises(SignalError, match="shapes"):
        deviations([[1.0, 2.0]], [2.0])


def test_identical_healthy_records_do_not_divide_by_zero() -> None:
    found = deviations(np.ones((4, 3)), [1.0, 1.0, 2.0])
    # the standard deviation of a feature is at least 0.01 dB
    assert found.score.tolist() == pytest.approx([0.0, 0.0, 1.0 / (0.01 * np.sqrt(1.25))])


def test_a_trend_leaves_the_range_with_two_consecutive_records() -> None:
    assert left_at([1.0, 3.0, 1.0, 3.0], 2.0) is None
    assert left_at([1.0, 3.0, 3.0], 2.0) == 1
    assert left_at([3.0], 2.0) is None


def test_a_part_is_named_only_if_its_feature_rises_alone() -> None:
    features = [
        Feature("a", "level"),
        Feature("a", "residual", "Z1", "rms"),
        Feature("a", "residual", "Z2", "rms"),
        Feature("a", "bearing", "outer ring of left", "lines"),
        Feature("a", "bearing", "inner ring of left", "lines"),
    ]
    healthy = 0.2 * np.random.default_rng(3).standard_normal((9, 5))

    def named(*changes: float) -> list[int]:
        """Named features of a record with these deviations [dB]."""
        return changed_parts(features, deviations(healthy, changes))

    assert named(0.0, 6.0, 0.0, 0.0, 0.0) == [1]
    assert named(6.0, 6.0, 0.0, 0.0, 0.0) == []  # as the whole signal
    assert named(0.0, 6.0, 6.0, 0.0, 0.0) == []
    assert named(0.0, -6.0, 0.0, 0.0, 0.0) == []
    assert named(0.0, 0.0, 0.0, 4.0, 9.0) == [4]
