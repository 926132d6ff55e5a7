# SPDX-License-Identifier: Apache-2.0
"""Dynamic inflow and dynamic stall: steps against their closed form, steady values, polars."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.elements.rotor.polar import coefficient, interval
from pitchpoint.elements.rotor.record import polar_rows
from pitchpoint.elements.rotor.unsteady import (
    SHARE,
    advance_inflow,
    advance_separation,
    attached_lift,
    inflow_times,
    stalling_lift,
)
from pitchpoint.geometry.rotor.flow import RotorFlow
from pitchpoint.geometry.rotor.polar import Polar
from pitchpoint.geometry.rotor.separation import separation
from pitchpoint.solvers.rotor_performance import solve_rotor_performance
from pitchpoint.solvers.rotor_transient import solve_rotor_transient
from tests.support.rotors import aerodyn, report_rotor


def test_time_constants_of_the_nrel_5mw() -> None:
    """a = 1/3, 63 m, 8 m/s: τ1 = 1.1/(1 - 0.4333) · 7.875 s = 15.287 s; at r/R = 0.5 τ2 = 0.325 τ1."""
    assert inflow_times(1 / 3, 0.5, 63.0, 8.0) == pytest.approx((15.287, 0.325 * 15.287), rel=1e-4)
    assert inflow_times(0.9, 1.0, 63.0, 8.0) == inflow_times(0.5, 1.0, 63.0, 8.0)


def test_step_of_the_steady_induction() -> None:
    """From 2 to 5 m/s: W = 5 - 3 [(1 - k) τ1/(τ1 - τ2) e^(-t/τ1) + (1 - (1 - k) τ1/(τ1 - τ2)) e^(-t/τ2)]."""
    first, second, h = 9.0, 3.0, 0.5
    z, w = (1 - SHARE) * 2.0, 2.0
    assert advance_inflow(z, w, 2.0, (first, second), 7.0) == pytest.approx((z, w), rel=1e-14)
    part = (1 - SHARE) * first / (first - second)
    for k in range(1, 100):
        z, w = advance_inflow(z, w, 5.0, (first, second), h)
        t = k * h
        expected = 5.0 - 3.0 * (part * np.exp(-t / first) + (1 - part) * np.exp(-t / second))
        assert w == pytest.approx(expected, rel=1e-13)


def test_filters_satisfy_their_equations() -> None:
    """Steady value sin(ω t): amplitude and phase of (1 + i ω k τ1)/((1 + i ω τ1)(1 + i ω τ2))."""
    first, second, omega, h = 9.0, 3.0, 0.4, 0.005
    z = w = 0.0
    t = h * np.arange(1, 40001)
    found = np.zeros(t.size)
    for k, now in enumerate(t):
        mean = 0.5 * (np.sin(omega * (now - h)) + np.sin(omega * now))
        z, w = advance_inflow(z, w, mean, (first, second), h)
        found[k] = w
    wave = (1 + 1j * omega * SHARE * first) / ((1 + 1j * omega * first) * (1 + 1j * omega * second))
    expected = np.abs(wave) * np.sin(omega * t + np.angle(wave))
    assert found[-4000:] == pytest.approx(expected[-4000:], abs=1e-5)


def test_step_of_the_point_of_separation() -> None:
    """f follows with τ = 4 c/W: 4 · 2 m/40 m/s = 0.2 s; lift from attached to stalled in between."""
    t = 0.05 * np.arange(21)
    f = np.array([advance_separation(1.0, 0.3, 2.0, 40.0, x) for x in t])
    assert f == pytest.approx(0.3 + 0.7 * np.exp(-t / 0.2), rel=1e-14)
    root = np.sqrt(0.3)
    steady, separated = 1.9 * (1.0 + root) ** 2 / 4.0, 1.9 * (1.0 + 3.0 * root) / (4.0 + 4.0 * root)
    assert 0.3 * 1.9 + 0.7 * separated == pytest.approx(steady, rel=1e-14)
    lift = [stalling_lift(steady, 0.3, 1.9, separated, x) for x in f]
    assert lift[0] == pytest.approx(1.9, rel=1e-14)
    assert lift[-1] == pytest.approx(steady, abs=0.01)
    assert (np.diff(lift) < 0).all()


def test_steady_lift_is_a_mixture_of_attached_and_separated_flow() -> None:
    """At the points of the tables from -20° to 20°, to that of sine and angle: 3.2 % at 0.44 rad."""
    for polar in aerodyn().blade.polars[2:]:
        found = separation(polar)
        assert found is not None
        assert 5.0 < found.slope < 9.0 and -0.09 < found.alpha_0 < 0.0
        assert ((found.f >= 0.0) & (found.f <= 1.0)).all()
        attached = attached_lift_of(polar.alpha, found)
        mixture = found.f * attached + (1.0 - found.f) * found.separated
        near = (np.abs(polar.alpha) < 0.35) & (np.abs(polar.alpha - found.alpha_0) > 0.02)
        np.testing.assert_allclose(mixture[near], polar.lift[near], rtol=0.032)


def attached_lift_of(alpha: np.ndarray, found) -> np.ndarray:
    return np.array([attached_lift(a, found.alpha_0, found.slope) for a in alpha])


def test_lift_has_no_poles_between_the_points_of_a_polar() -> None:
    """Lift changes with the point of separation by c_l,att - c_l,sep: between half and three quarters of the
    attached lift, less where the steady lift is less than a quarter of it. It was up to 2059."""
    rotor = report_rotor()
    rows, polars = polar_rows(rotor), rotor.blade.polars
    ends = np.cumsum([0, *(len(polar.alpha) for polar in polars)])
    for k, polar in enumerate(polars[2:], start=2):
        found = separation(polar)
        for alpha in np.radians(np.arange(-12.0, 15.0, 0.02)):
            at = interval(rows, ends[k], ends[k + 1] - 1, alpha, ends[k])
            lift, f, separated = (coefficient(rows, at, c, alpha)[0] for c in (1, 7, 9))
            attached = attached_lift(alpha, found.alpha_0, found.slope)
            change = stalling_lift(lift, f, attached, separated, 1.0) - stalling_lift(
                lift, f, attached, separated, 0.0
            )
            assert 0.0 <= change / attached <= 1.0 or abs(alpha - found.alpha_0) < 0.02, (k, alpha)
            assert stalling_lift(lift, f, attached, separated, f) == lift


def test_kirchhoff_plate() -> None:
    """Lift 2π α (1 + √f)²/4 with f given: f comes back."""
    alpha = np.radians(np.arange(-15.0, 15.5, 0.5))
    f = np.clip(1.0 - (np.abs(np.degrees(alpha)) / 16.0) ** 2, 0.0, 1.0)
    f[np.abs(alpha) < 0.05] = 1.0
    polar = Polar(alpha=alpha, lift=2 * np.pi * alpha * (1 + np.sqrt(f)) ** 2 / 4, drag=0 * alpha)
    found = separation(polar)
    assert found is not None
    assert found.slope == pytest.approx(2 * np.pi) and found.alpha_0 == pytest.approx(0.0, abs=1e-12)
    assert found.f == pytest.approx(f, abs=1e-9)
    attached = 2 * np.pi * np.sin(alpha)
    assert found.separated[f == 1.0] == pytest.approx(0.5 * attached[f == 1.0])


def test_cylinders_have_no_separation() -> None:
    assert separation(aerodyn().blade.polars[0]) is None


STEADY = RotorFlow(sectors=1)


@pytest.fixture(scope="module")
def pitch_step() -> tuple:
    """NREL 5 MW, 8 m/s, 0.95 rad/s: pitch from 0 to 2° at 5 s."""
    rotor = report_rotor()
    time = np.r_[0.0, np.arange(5.0, 300.0, 0.1)]
    pitch = np.where(time < 5.05, 0.0, np.radians(2.0))
    return rotor, time, solve_rotor_transient(rotor, time, 8.0, 0.95, pitch, flow=STEADY)


def test_pitch_step_begins_and_ends_steady(pitch_step) -> None:
    rotor, _, found = pitch_step
    steady = solve_rotor_performance(rotor, 8.0, 0.95, [0.0, np.radians(2.0)], flow=STEADY)
    for name in ("rotor_thrust", "rotor_torque"):
        before, after = steady[name].values
        assert found[name].values[:2] == pytest.approx([before, before], rel=1e-10)
        assert float(found[name][-1]) == pytest.approx(after, rel=1e-6)
        assert float(found[name][2]) < 0.9 * after  # overshoot


def test_overshoot_is_that_of_frozen_induction(pitch_step) -> None:
    """Just after the step the air has its old velocity: lift of the polar at an angle that is less by 2°."""
    rotor, _, _ = pitch_step
    time, pitch = np.array([0.0, 1e-6]), np.radians([0.0, 2.0])
    found = solve_rotor_transient(rotor, time, 8.0, 0.95, pitch, flow=STEADY, dynamic_stall=False)
    steady = solve_rotor_performance(rotor, 8.0, 0.95, flow=STEADY)
    phi, speed = steady.inflow_angle[0].values, steady.relative_speed[0].values
    expected = np.zeros(phi.size)
    for k in range(1, phi.size - 1):
        polar = rotor.blade.polars[rotor.blade.polar_index[k]]
        lift, drag, _ = polar.at(phi[k] - rotor.blade.twist[k] - np.radians(2.0))
        q = 0.5 * 1.225 * speed[k] ** 2 * rotor.blade.chord[k]
        expected[k] = q * (lift * np.cos(phi[k]) + drag * np.sin(phi[k]))
    thrust = 3 * np.trapezoid(expected, rotor.blade.span)
    assert float(found.rotor_thrust[1]) == pytest.approx(thrust, rel=1e-6)


def test_without_states_the_loads_are_steady() -> None:
    """Tilted rotor in shear: blades in three azimuths of a mean over three sectors, at each time."""
    rotor = report_rotor(cone=2.5, tilt=5.0)
    flow = RotorFlow(shear_exponent=0.2, sectors=3)
    found = solve_rotor_transient(
        rotor, [0.0, 0.1], [9.0, 9.0], 1.0, flow=flow, dynamic_inflow=False, dynamic_stall=False
    )
    steady = solve_rotor_performance(rotor, 9.0, 1.0, flow=flow)
    assert float(found.rotor_torque[0]) == pytest.approx(float(steady.rotor_torque[0]), rel=1e-12)
    stall = solve_rotor_transient(rotor, [0.0, 0.1], 9.0, 1.0, flow=flow, dynamic_inflow=False)
    assert float(stall.rotor_torque[0]) == pytest.approx(float(steady.rotor_torque[0]), rel=1e-12)


def test_half_the_step_changes_little() -> None:
    """Gust of 1 - cos shape: second order, 1.1e-4 between 0.1 and 0.05 s."""
    rotor = report_rotor()
    ends = []
    for h in (0.1, 0.05):
        time = h * np.arange(round(20 / h) + 1)
        wind = 8.0 + 2.0 * np.where(time < 10, 1 - np.cos(0.2 * np.pi * time), 0.0)
        found = solve_rotor_transient(rotor, time, wind, 0.95, flow=STEADY)
        ends.append(found.rotor_thrust.values[:: round(0.1 / h)])
    assert ends[0] == pytest.approx(ends[1], rel=2e-4)


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (([0.0], 8.0, 1.0), "at least two increasing times"),
        (([0.0, 0.0], 8.0, 1.0), "at least two increasing times"),
        (([0.0, 1.0], [8.0, 8.0, 8.0], 1.0), "has not one value per time (limit 2)"),
        (([0.0, 1.0], 8.0, 1.0, [0.0, 0.0, 0.0]), "equal, or single numbers"),
        (([0.0, 1.0], -8.0, 1.0), "-8 m/s is out of range"),
    ],
)
def test_bad_times(arguments: tuple, expected: str) -> None:
    with pytest.raises(ModelError) as error:
        solve_rotor_transient(report_rotor(), *arguments)
    assert expected in str(error.value)
