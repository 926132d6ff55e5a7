# SPDX-License-Identifier: Apache-2.0
"""What Rayleigh damping and loads do to the speed of a machine that a sweep moves through its range."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.status import OFF_SPEED
from pitchpoint.solvers.time import solve_time
from pitchpoint.sweep.speed import run_sweep
from tests.support.machines import compiled, pair

LAW = "{law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1]}"
RAYLEIGH = "damping: {rayleigh: {mass: 20 1/s, stiffness: 2e-6 s}}\n"
SWEEP = "sweep: {body: driver, speed: [SPEEDS], points: N, direction: up, settle_periods: 150}"


def swept(speeds: str, points: int, more: str = RAYLEIGH):
    text = SWEEP.replace("SPEEDS", speeds).replace("N,", f"{points},")
    scenario = f"scenarios:\n  sweep: {{{text}}}\n"
    return run_sweep(compiled(pair(LAW, rest=more + scenario), "sweep")[1])


def test_mass_proportional_damping_does_not_know_where_a_sweep_began():
    whole = swept("500 rpm, 3000 rpm", 3).points[-1]
    last = swept("2999 rpm, 3000 rpm", 2).points[-1]
    for quantity in ("deflection", "mesh_force"):
        for key in ("mean", "rms"):
            assert whole[quantity][key] == pytest.approx(last[quantity][key], rel=1e-3)


def test_mass_proportional_damping_brakes_no_run_up():
    """A stiff train: the drive turns its inertia, reduced to the driver, less what the load gives.

    The driven body turns the other way at 1/1.5 of the speed, so that its -30 N m drive it.
    """
    rest = RAYLEIGH.replace("20 1/s", "10 1/s").replace("2e-6", "0")
    rest += "scenarios:\n  up: {drive: {driver: {speed: {table: [[0, 100], [0.1, 200]]}}}, duration: 0.1 s}\n"
    law = "{law: constant, value: 1e11 N/m}, damper: {ratio: 0.5}, "
    text = pair("LAW", torque="0 N m", rest=rest).replace("LAW", law + "transmission_error: {cosine: [0]}")
    text = text.replace(
        "  output: {body: driven, torque: balance}", "  output: {body: driven, torque: -30 N m}"
    )
    found = solve_time(compiled(text, "up")[1])
    late = found["time"] > 0.05
    expected = (0.002 + 0.01 / 1.5**2) * 1000.0 - 30.0 / 1.5
    assert float(found["torque[driver]"][late].mean()) == pytest.approx(expected, rel=1e-3)


def test_a_train_that_leaves_the_speeds_of_a_sweep_is_told():
    text = SWEEP.replace("SPEEDS", "500 rpm, 3000 rpm").replace("N,", "4,")
    text = pair(LAW, rest=f"{RAYLEIGH}scenarios:\n  sweep: {{{text}}}\n")
    text = text.replace("body: driven, torque: balance", "body: driven, torque: 301 N m")
    found = run_sweep(compiled(text, "sweep")[1])
    assert (found.status, found.points) == (OFF_SPEED, [])
    assert "the mean speed left the speed of the sweep at 500 rpm of driver (up), where" in found.sentence
    assert "loads and losses do not balance there; drive or hold a body" in found.sentence
    assert not any("mean speed deviates" in note for note in swept("500 rpm, 3000 rpm", 2).notes)


def fan(law: str, settle: int = 150, measure: int = 90) -> list[dict]:
    """Points of a sweep up and down whose driver balances a load of the driven gear, and its notes."""
    text = SWEEP.replace("SPEEDS", "1000 rpm, 2000 rpm").replace("N,", "3,").replace("up", "both")
    text = text.replace("150", f"{settle}, measure_periods: {measure}")
    text = pair(LAW, rest=f"{RAYLEIGH}scenarios:\n  sweep: {{{text}}}\n")
    text = text.replace("body: driven, torque: balance", f'body: driven, torque: "{law}"')
    text = text.replace("body: driver, torque: 200 N m", "body: driver, torque: balance")
    summary = run_sweep(compiled(text, "sweep")[1])
    assert not any("mean speed deviates" in note for note in summary.notes)
    return summary.points


SPEEDS = [1000.0, 1500.0, 2000.0, 2000.0, 1500.0, 1000.0]


def test_the_balancing_torque_follows_a_load_that_depends_on_the_speed():
    """The law of a fan at every speed, up and down, over the gear ratio of 1.5; both gears drive forwards."""
    points = fan("60 N m*(speed/(100 rad/s))^2")
    for point, rpm in zip(points, SPEEDS, strict=True):
        driven = rpm * math.pi / 30 / 1.5
        channels = point["channels"]
        torque = 60.0 * (driven / 100.0) ** 2 / 1.5
        assert channels["torque[input]"]["mean"] == pytest.approx(torque, rel=1e-6)
        assert channels["speed[driver]"]["mean"] == pytest.approx(rpm * math.pi / 30, rel=1e-4)


LOADS = ["60 + 12*sin(2*angle)", "60 + 12*sin(2*angle) + 20*(speed/100)^2", "60 + 8*cos(2*pi*100 Hz*t)"]


@pytest.mark.parametrize("law", LOADS)
def test_the_ripple_of_a_load_has_its_amplitude_at_every_speed(law):
    """The speed changes at any phase of a wave, which begins with the speed that the wave has there.

    90 mesh cycles are three revolutions of the driver and two of the driven gear; at 1000, 1500 and 2000 rpm
    they contain 18, 12 and 9 waves over time.
    """
    for point, rpm in zip(fan(law), SPEEDS, strict=True):
        assert point["channels"]["speed[driver]"]["mean"] == pytest.approx(rpm * math.pi / 30, rel=1e-4)


RIPPLE = "drive: {driver: {ripple: {w: {order: 0.25, fluctuation: 8 %}}}}, "


def test_a_window_that_cuts_the_waves_of_a_drive_is_no_drift():
    """Ten mesh cycles are a small part of the wave over four revolutions; the mean of the drive is exact."""
    text = SWEEP.replace("SPEEDS", "1000 rpm, 1100 rpm").replace("N,", "2,")
    text = text.replace("settle_periods: 150", "settle_periods: 10, measure_periods: 10")
    summary = run_sweep(compiled(pair(LAW, rest=f"scenarios:\n  sweep: {{{RIPPLE}{text}}}\n"), "sweep")[1])
    means = [p["channels"]["speed[driver]"]["mean"] / p["speed"] for p in summary.points]
    assert max(abs(mean - 1.0) for mean in means) > 0.01
    assert not any("mean speed deviates" in note for note in summary.notes)
