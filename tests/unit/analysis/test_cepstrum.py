# SPDX-License-Identifier: Apache-2.0
"""Cepstra of echoes in closed form, and of families of lines."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.cepstrum import power_cepstrum, rahmonics, real_cepstrum
from pitchpoint.analysis.sampled import SignalError


@pytest.mark.parametrize("echo", [0.3, 0.6, -0.5])
def test_an_echo_adds_its_powers_at_multiples_of_its_delay(echo: float) -> None:
    """-(-a)^k/(2 k), over the cepstrum of the sound itself; the difference of the two is the echo alone.

    The record is a circle here, so the closed form holds to round-off but for line 0, which the mean takes
    away: it errs by no more than the logarithm of one line over the number of lines.
    """
    n, delay = 8192, 100
    x = np.random.default_rng(5).normal(size=n)
    y = x + echo * np.roll(x, delay)
    a, b = (real_cepstrum(v, 1000.0, window_name="rectangular", floor=1e-12).cepstrum for v in (x, y))
    for k in (1, 2, 3, 4):
        assert (b - a)[k * delay] == pytest.approx(-((-echo) ** k) / (2 * k), abs=5e-4)
    rest = np.delete(b - a, [k * delay for k in range(41)])
    assert np.abs(rest).max() < 5e-4


def test_power_cepstrum_is_the_square_of_twice_the_real_one() -> None:
    x = np.random.default_rng(1).normal(size=999)
    np.testing.assert_allclose(
        power_cepstrum(x, 10.0).cepstrum, (2.0 * real_cepstrum(x, 10.0).cepstrum) ** 2, rtol=1e-12
    )


def test_a_gain_changes_only_quefrency_zero() -> None:
    x = np.random.default_rng(2).normal(size=2000)
    one, ten = (real_cepstrum(g * x, 10.0) for g in (1.0, 10.0))
    assert ten.cepstrum[0] - one.cepstrum[0] == pytest.approx(np.log(10.0), rel=1e-12)
    np.testing.assert_allclose(ten.cepstrum[1:], one.cepstrum[1:], atol=1e-12)
    assert one.quefrency[-1] == pytest.approx(100.0)


def test_sidebands_of_two_shafts_are_two_periods() -> None:
    """Families 6 and 10 Hz apart about two meshes: peaks at 1/6 and 1/10 s, and none at 1/8 s."""
    rate, t = 5000.0, np.arange(40_000) / 5000.0
    rng = np.random.default_rng(7)
    x = 0.01 * rng.normal(size=t.size)
    for mesh in (600.0, 1200.0, 1800.0):
        for spacing in (6.0, 10.0):
            for j in range(-12, 13):
                x += 0.8 ** abs(j) * np.cos(2 * np.pi * (mesh + j * spacing) * t + rng.uniform(0.0, 6.28))
    c = real_cepstrum(x, rate)
    for period in (1.0 / 6.0, 1.0 / 10.0):
        found = rahmonics(c, 1.004 * period, count=1)
        assert found.quefrency[0] == pytest.approx(period, abs=1.0 / rate)
        assert found.value[0] > 3.0 * found.background[0]
    nothing = rahmonics(c, 1.0 / 8.0, count=1)
    assert nothing.value[0] < 2.0 * nothing.background[0]


def test_rahmonics_end_with_the_record() -> None:
    c = real_cepstrum(np.random.default_rng(0).normal(size=1000), 1000.0)
    assert rahmonics(c, 0.2, count=5).number.tolist() == [1.0, 2.0]
    with pytest.raises(SignalError, match=r"quefrency: 0.6 s \(limit below 0.5 s"):
        rahmonics(c, 0.6)
    with pytest.raises(SignalError, match="constant"):
        real_cepstrum(np.ones(100), 10.0)
