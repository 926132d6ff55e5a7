# SPDX-License-Identifier: Apache-2.0
"""The example `clutch-driveline`: heat of a clutch, frequency and growth of judder, all by hand too.

By hand the driveline is reduced to the clutch shaft (ratio 4): engine, disc with the gears, vehicle behind
half shafts. What that leaves out is the give of the mesh: 1e8 N/m at 24 mm make 6e4 N m/rad against 500.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model

FOLDER = Path(__file__).parents[2] / "examples" / "clutch-driveline"
RATIO = 68 / 17
ENGINE, DISC, VEHICLE, SHAFTS = 0.25, 0.06 + 0.64 / RATIO**2, 80.0 / RATIO**2, 8000.0 / RATIO**2
SWING = math.sqrt(SHAFTS * (1.0 / DISC + 1.0 / VEHICLE))
"""Natural frequency of the disc on the half shafts while the clutch slips [rad/s]."""


def run(file, scenario):
    system = compile_model(load_model(FOLDER / f"{file}.yaml"), scenario)
    memory = Memory()
    run_time(system, sink=memory)
    t, rows = np.concatenate(memory.times), np.concatenate(memory.rows)
    return t, lambda name: rows[:, system.layout.channel(name)]


def frequency_of(t, x):
    """Mean frequency between the first and the last rising crossing of zero [Hz]."""
    x = np.convolve(x, np.full(150, 1.0 / 150), mode="same")[150:-150]  # 15 ms: without the order of the mesh
    t = t[150:-150]
    up = np.flatnonzero((x[:-1] < 0.0) & (x[1:] >= 0.0))
    times = t[up] - x[up] * (t[up + 1] - t[up]) / (x[up + 1] - x[up])
    return (len(times) - 1) / (times[-1] - times[0])


def test_heat_of_the_engagement():
    t, channel = run("engagement", "pull_away")
    gas, capacity, start = 60.0, 160.0, 1500.0 * math.pi / 30.0
    mean = capacity / (DISC + VEHICLE)
    swing = capacity / DISC * VEHICLE / (DISC + VEHICLE) / SWING

    def slip(t):
        return start + (gas - capacity) / ENGINE * t - mean * t - swing * math.sin(SWING * t)

    grid = np.linspace(0.0, 0.5, 5001)
    first = int(np.flatnonzero([slip(x) <= 0.0 for x in grid])[0])
    sticks = brentq(slip, grid[first - 1], grid[first])
    turn = start * sticks + 0.5 * ((gas - capacity) / ENGINE - mean) * sticks**2
    turn -= swing / SWING * (1.0 - math.cos(SWING * sticks))
    assert sticks == pytest.approx(0.3546, abs=5e-5)
    assert capacity * turn == pytest.approx(4571.9, abs=0.05)
    # rigid: slip falls evenly
    rigid = start / (mean - (gas - capacity) / ENGINE)
    assert 0.5 * capacity * start * rigid == pytest.approx(4575.9, abs=0.05)

    power, speed = channel("friction_power[clutch]"), channel("slip_speed[clutch]")
    seen = float(t[np.flatnonzero(speed <= 0.01 * start)[0]])
    assert seen == pytest.approx(brentq(lambda x: slip(x) - 0.01 * start, 0.9 * sticks, sticks), abs=3e-4)
    until = t <= sticks + 2e-3
    # bristles of 0.01 rad store 0.8 J before they slip, 2e-4 of the heat
    assert np.trapezoid(power[until], t[until]) == pytest.approx(capacity * turn, rel=3e-4)
    # afterwards engine and disc swing as one against the vehicle
    together = math.sqrt(SHAFTS * (1.0 / (ENGINE + DISC) + 1.0 / VEHICLE)) / (2.0 * math.pi)
    twist = channel("torque[half_shafts]")
    after = t > sticks + 0.05
    assert together == pytest.approx(6.22, abs=0.01)
    level = 0.5 * (twist[after].max() + twist[after].min())
    assert frequency_of(t[after], twist[after] - level) == pytest.approx(together, rel=0.02)


def capacity_at(slip):
    return 60.0 * (1.0 + 0.5 * np.exp(-((slip / 60.0) ** 2)))


def test_frequency_and_growth_of_judder():
    t, channel = run("judder", "creep")
    slip = channel("slip_speed[clutch]")
    assert channel("torque[slope]")[0] == pytest.approx(RATIO * capacity_at(30.0), rel=1e-6)
    d = 60.0 * 0.5 * 2.0 * 30.0 / 60.0**2 * math.exp(-0.25)  # fall of the torque per slip
    # twist of the shafts, speed of the disc, speed of the vehicle
    A = [[0.0, 1.0, -1.0], [-SHAFTS / DISC, d / DISC, 0.0], [SHAFTS / VEHICLE, 0.0, 0.0]]
    root = max(np.linalg.eigvals(np.array(A)), key=lambda z: z.imag)
    small = (t > 0.1) & (t < 0.9)
    x = slip[small] - np.polyval(np.polyfit(t[small], slip[small], 2), t[small])
    frequency = frequency_of(t[small], x)
    assert root.imag / (2.0 * math.pi) == pytest.approx(11.362, abs=5e-4)
    assert root.real == pytest.approx(1.909, abs=5e-4)
    # the mesh in line with the half shafts makes it 0.4 % softer
    assert frequency == pytest.approx(root.imag / (2.0 * math.pi), rel=4e-3)
    period = 2.0 * math.pi / root.imag

    def size(start):
        window = (t[small] >= start) & (t[small] < start + 3.0 * period)
        return float(np.std(x[window]))

    growth = math.log(size(0.15 + 5.0 * period) / size(0.15)) / (5.0 * period)
    # 4 rad/s at the end of the second window: what is left of the curvature of the law
    assert growth == pytest.approx(root.real, rel=0.02)

    # by hand, with sharp friction over 0.1 rad/s and the nudge
    def rates(time, y):
        w = 70.0 - y[1]
        torque = capacity_at(w) * math.tanh(w / 0.05)
        nudge = np.interp(time, [0.0, 0.02, 0.04], [0.0, 5.0, 0.0])
        return [
            y[1] - y[2],
            (torque + nudge - SHAFTS * y[0]) / DISC,
            (SHAFTS * y[0] - capacity_at(30.0)) / VEHICLE,
        ]

    start = [capacity_at(30.0) / SHAFTS, 40.0, 40.0]
    hand = solve_ivp(rates, (0.0, 4.0), start, method="Radau", rtol=1e-7, atol=1e-8, max_step=5e-3, t_eval=t)
    other = 70.0 - hand.y[1]
    early, late = t < 1.0, t > 2.5
    # up to 6 rad/s of swing, with the ripple of the mesh on one of the two
    assert np.max(np.abs(other - slip)[early]) < 0.7
    assert slip[late].min() == pytest.approx(0.0, abs=0.1)  # it sticks once in every swing
    assert slip[late].max() == pytest.approx(other[late].max(), rel=0.02)
    cycle = frequency_of(t[late], slip[late] - 30.0)
    assert cycle == pytest.approx(frequency_of(t[late], other[late] - 30.0), rel=3e-3)
    assert cycle == pytest.approx(11.28, abs=0.01)
