# SPDX-License-Identifier: Apache-2.0
"""A contact whose force is a power of its overlap behind a compliance: one root, its slope, its energy."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from pitchpoint.contact.elastic import power_force, series_energy, series_overlap

POWERS = [1.0, 1.2, 1.5, 2.5, 5.0]
every_power = pytest.mark.parametrize("power", POWERS)


def places(power):
    """Overlaps and stiffnesses of tooth pairs; compliances far below and far above that of the contact."""
    for x in (1e-9, 3e-6, 2e-5, 1e-3):
        k = 2e8 * 2e-5 ** (1.0 - power)
        for soft in np.logspace(-6, 6, 13) / (k * x ** (power - 1.0)):
            yield x, k, float(soft)


@pytest.mark.nojit
@every_power
def test_the_overlap_is_the_root(power):
    """u + C k u^e = x to round-off, against a bracketing solver that knows nothing of it."""
    for x, k, soft in places(power):
        u = series_overlap(x, k, power, soft)
        assert 0.0 < u < x
        assert abs(u + soft * power_force(u, k, power)[0] - x) < 1e-15 * x
        wanted = brentq(
            lambda t, A=soft * k * x ** (power - 1.0): t + A * t**power - 1.0, 0.0, 1.0, xtol=1e-16
        )
        assert u == pytest.approx(wanted * x, rel=3e-14)


@every_power
def test_energy_is_the_work_of_the_force(power):
    """The integral of the force over the way, and its slopes over both constants by differences."""
    x = 2e-5
    k = 2e8 * x ** (1.0 - power)
    for soft in (1e-10, 5e-9, 1e-7):

        def per_share(s, soft=soft):  # the way x s^10 makes the powers smooth at nothing
            return power_force(series_overlap(x * s**10, k, power, soft), k, power)[0] * 10.0 * x * s**9

        def energy(k, soft):
            return series_energy(x, series_overlap(x, k, power, soft), k, power, soft, 0.0)

        found, by_k, by_soft = energy(k, soft)
        assert found == pytest.approx(quad(per_share, 0.0, 1.0, epsabs=0.0, epsrel=1e-12)[0], rel=1e-11)
        h = 1e-5
        assert by_k == pytest.approx((energy(k + h * k, soft)[0] - energy(k - h * k, soft)[0]) / (2 * h * k))
        change = energy(k, soft + h * soft)[0] - energy(k, soft - h * soft)[0]
        assert by_soft == pytest.approx(change / (2 * h * soft))


def test_low_load_behind_a_linear_compliance_keeps_the_energy_of_the_softer_spring():
    x, k, soft, limit = 2e-5, 2e8, 2e-9, 1e4
    u = series_overlap(x, k, 1.0, soft)
    found = series_energy(x, u, k, 1.0, soft, limit)
    lower = series_energy(x, x, k / (1.0 + k * soft), 1.0, 0.0, limit)
    assert found[0] == pytest.approx(lower[0], rel=1e-14)
