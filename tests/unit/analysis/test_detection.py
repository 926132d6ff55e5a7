# SPDX-License-Identifier: Apache-2.0
"""Detection against noise: thresholds, rates with their intervals, against a detector of known power."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from pitchpoint.analysis.detection import detection_curves, least_ratio, wilson_interval
from pitchpoint.analysis.noise import with_white_noise
from pitchpoint.analysis.sampled import SignalError

T = np.arange(64)
FAULT = np.sqrt(2.0) * np.cos(2 * np.pi * 8 * T / 64)


def matched(x: np.ndarray) -> float:
    """Correlation with the fault: the most powerful detector there is."""
    return float(x @ FAULT) / 64.0


def test_rates_are_those_of_the_normal_distribution() -> None:
    """Matched filter in white noise: mean 1 or 0, deviation sigma/8, so the rate is Phi(8/sigma - z)."""
    ratios = np.array([-30.0, -18.0, -12.0, -6.0])
    found = detection_curves(0.0 * FAULT, FAULT, {"matched": matched}, snr=ratios, seeds=999)
    sigma = 10.0 ** (-ratios / 20.0)
    expected = stats.norm.sf(stats.norm.isf(0.05) - 8.0 / sigma)
    # the quantile of n values scatters by sqrt(a (1 - a)/n) over the density there, here by 0.067 sigma/8
    z, n = stats.norm.isf(0.05), 999
    of_threshold = np.sqrt(0.05 * 0.95 / n) / stats.norm.pdf(z)
    assert np.all(np.abs(found.threshold[0] / (sigma / 8.0) - z) < 3.0 * of_threshold)
    # a rate has the scatter of its count, and that of the threshold times the density of the faulty values
    for rate, p, shift in ((found.rate[0], expected, 8.0 / sigma), (found.false_alarm_rate[0], 0.05, 0.0)):
        deviation = np.hypot(np.sqrt(p * (1.0 - p) / n), stats.norm.pdf(z - shift) * of_threshold)
        assert np.all(np.abs(rate - p) < 3.0 * deviation)
    assert np.all(found.rate_low <= found.rate)
    assert np.all(found.rate <= found.rate_high)


def test_false_alarms_keep_their_rate_on_average() -> None:
    """Threshold from 19 signals at 1 in 20: the largest. In 200 trials 5 % of fresh signals exceed it."""
    rates = [
        detection_curves(
            0.0 * FAULT, FAULT, {"rms": np.std}, snr=[-40.0], seeds=19, first_seed=100 * k
        ).false_alarm_rate[0, 0]
        for k in range(200)
    ]
    # beta-binomial: standard error of the mean of 200 about 0.005
    assert np.mean(rates) == pytest.approx(0.05, abs=0.015)


def test_healthy_and_faulty_get_the_same_noise() -> None:
    """A detector of noise alone learns nothing, though the healthy signal is a tenth of the faulty one."""
    found = detection_curves(
        0.1 * FAULT, FAULT, {"rough": lambda x: float(np.std(np.diff(x - FAULT * matched(x))))}, snr=[0.0]
    )
    assert found.rate[0, 0] < 0.2
    assert found.false_alarm_rate[0, 0] < 0.2


def test_noise_is_that_of_the_stated_ratio_and_seed() -> None:
    seen = []
    detection_curves(
        0.0 * FAULT, FAULT, {"keep": lambda x: seen.append(x) or 0.0}, snr=[6.0], seeds=1, false_alarm=0.5
    )
    expected = with_white_noise(FAULT, signal_to_noise=6.0, seed=[0, 2]).values
    np.testing.assert_array_equal(seen[2], expected)


def test_what_is_not_finite_is_no_alarm() -> None:
    found = detection_curves(0.0 * FAULT, FAULT, {"none": lambda _: np.nan}, snr=[0.0], seeds=20)
    assert found.rate[0, 0] == 0.0
    assert found.false_alarm_rate[0, 0] == 0.0


def test_the_least_ratio_is_the_end_of_an_unbroken_stretch() -> None:
    found = detection_curves(
        0.0 * FAULT, FAULT, {"matched": matched, "blind": lambda _: 0.0}, snr=[0.0, -40.0, -6.0], seeds=50
    )
    assert least_ratio(found)[0] == -6.0
    assert np.isnan(least_ratio(found)[1])


def test_wilson_interval_is_that_of_scipy() -> None:
    for k, n in ((0, 20), (3, 20), (100, 100), (51, 100)):
        expected = stats.binomtest(k, n).proportion_ci(0.9, method="wilson")
        low, high = wilson_interval(k, n, 0.9)
        assert (float(low), float(high)) == pytest.approx((expected.low, expected.high), abs=1e-12)


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ({"seeds": 18}, r"seeds: 18 \(limit 19 for false_alarm 0.05\)"),
        ({"seeds": 2.5}, "seeds: 2.5"),
        ({"false_alarm": 1.0}, "false_alarm: 1.0"),
        ({"confidence": 0.0}, "confidence: 0.0"),
        ({"detectors": {}}, "detectors: none"),
        ({"healthy": FAULT[1:]}, "63 and 64 samples"),
        ({"faulty": np.ones(64)}, "constant"),
        ({"snr": [np.nan]}, "snr"),
    ],
)
def test_bad_input_is_named(more, says: str) -> None:
    given = {"healthy": 0.0 * FAULT, "faulty": FAULT, "detectors": {"m": matched}, "snr": [0.0], **more}
    with pytest.raises(SignalError, match=says):
        detection_curves(given.pop("healthy"), given.pop("faulty"), given.pop("detectors"), **given)
