# SPDX-License-Identifier: Apache-2.0
"""Dynamic inflow and dynamic stall: steps against their closed form, steady values, polars."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.elements.rotor.unsteady import (
    SHARE,
    attached_lift,
    inflow_rates,
    inflow_times,
    separation_rate,
    stalling_lift,
)
from pitchpoint.geometry.rotor.polar import Polar
from pitchpoint.geometry.rotor.separation import separation
from tests.support.rotors import aerodyn


def integrate(rates, x, h, steps):
    """Classical Runge-Kutta method with constant input; shape (steps + 1, n)."""
    out = [np.array(x, float)]
    for _ in range(steps):
        y = out[-1]
        k1 = np.array(rates(y))
        k2 = np.array(rates(y + 0.5 * h * k1))
        k3 = np.array(rates(y + 0.5 * h * k2))
        k4 = np.array(rates(y + h * k3))
        out.append(y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4))
    return np.array(out)


def test_time_constants_of_the_nrel_5mw() -> None:
    """a = 1/3, 63 m, 8 m/s: τ1 = 1.1/(1 - 0.4333) · 7.875 s = 15.287 s; at r/R = 0.5 τ2 = 0.325 τ1."""
    assert inflow_times(1 / 3, 0.5, 63.0, 8.0) == pytest.approx((15.287, 0.325 * 15.287), rel=1e-4)
    assert inflow_times(0.9, 1.0, 63.0, 8.0) == inflow_times(0.5, 1.0, 63.0, 8.0)


def test_step_of_the_steady_induction() -> None:
    """From 2 to 5 m/s: W = 5 - 3 [(1 - k) τ1/(τ1 - τ2) e^(-t/τ1) + (1 - (1 - k) τ1/(τ1 - τ2)) e^(-t/τ2)]."""
    first, second, h = 9.0, 3.0, 0.05
    start = (1 - SHARE) * 2.0, 2.0
    assert inflow_rates(*start, 2.0, first, second) == pytest.approx((0.0, 0.0), abs=1e-15)
    w = integrate(lambda x: inflow_rates(x[0], x[1], 5.0, first, second), start, h, 800)[:, 1]
    t = h * np.arange(801)
    part = (1 - SHARE) * first / (first - second)
    expected = 5.0 - 3.0 * (part * np.exp(-t / first) + (1 - part) * np.exp(-t / second))
    assert w == pytest.approx(expected, abs=1e-8)


def test_step_of_the_point_of_separation() -> None:
    """f follows with τ = 4 c/W: 4 · 2 m/40 m/s = 0.2 s; lift from attached to stalled in between."""
    h = 0.002
    f = integrate(lambda x: (separation_rate(x[0], 0.3, 2.0, 40.0),), (1.0,), h, 500)[:, 0]
    assert f == pytest.approx(0.3 + 0.7 * np.exp(-h * np.arange(501) / 0.2), abs=1e-9)
    lift = [stalling_lift(1.1, 0.3, 1.9, x) for x in f]
    assert lift[0] == 1.9
    assert lift[-1] == pytest.approx(1.1, abs=0.01)
    assert (np.diff(lift) < 0).all()


def test_steady_lift_is_that_of_the_polar() -> None:
    """At the steady point of separation the mixture is the table, between -20° and 20°."""
    for polar in aerodyn().blade.polars[2:]:
        found = separation(polar)
        assert 5.0 < found.slope < 9.0 and -0.09 < found.alpha_0 < 0.0
        assert ((found.f >= 0.0) & (found.f <= 1.0)).all()
        for alpha, lift, f in zip(polar.alpha, polar.lift, found.f, strict=True):
            if abs(alpha) < 0.35 and f < 0.999:
                attached = attached_lift(alpha, found.alpha_0, found.slope)
                assert stalling_lift(lift, f, attached, f) == pytest.approx(lift, abs=1e-9)


def test_kirchhoff_plate() -> None:
    """Lift 2π α (1 + √f)²/4 with f given: f comes back."""
    alpha = np.radians(np.arange(-15.0, 15.5, 0.5))
    f = np.clip(1.0 - (np.abs(np.degrees(alpha)) / 16.0) ** 2, 0.0, 1.0)
    f[np.abs(alpha) < 0.05] = 1.0
    polar = Polar(alpha=alpha, lift=2 * np.pi * alpha * (1 + np.sqrt(f)) ** 2 / 4, drag=0 * alpha)
    found = separation(polar)
    assert found.slope == pytest.approx(2 * np.pi) and found.alpha_0 == pytest.approx(0.0, abs=1e-12)
    assert found.f == pytest.approx(f, abs=1e-9)


def test_cylinders_have_no_separation() -> None:
    with pytest.raises(GeometryError, match="without dynamic stall"):
        separation(aerodyn().blade.polars[0])
