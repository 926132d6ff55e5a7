# SPDX-License-Identifier: Apache-2.0
"""The example `flyball-governor`: lift-off speed, lift and small vibrations against the reduced equation.

The reduction is on the page: one angle, energy in the turning frame, massless rods. What it leaves out is
the give of the mesh (450 Hz against 3.5 Hz, 6e-5) and the amplitude of 1.3 mm.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model

FILE = Path(__file__).parents[2] / "examples" / "flyball-governor" / "model.yaml"
L, B, A, BALL, SLEEVE, INERTIA = 0.2, 0.12, 0.03, 1.0, 2.0, 3.6e-4
STIFFNESS, PRELOAD, DAMPING, G = 2000.0, 60.0, 5.0, 9.81
REST = math.radians(25.0)
RPM = math.pi / 30.0


def lift(theta):
    return 2.0 * B * (math.cos(REST) - math.cos(theta))


def moment(theta, speed, push=0.0):
    closing = (BALL * L + SLEEVE * B) * G + B * (PRELOAD + STIFFNESS * lift(theta) - push)
    return (
        2.0 * closing * math.sin(theta)
        - 2.0 * BALL * L * math.cos(theta) * (A + L * math.sin(theta)) * speed**2
    )


def equilibrium(speed, push=0.0):
    return brentq(moment, REST, 1.3, args=(speed, push), xtol=1e-14)


def vibration(speed, push=0.0):
    """Damped frequency [Hz] and damping ratio."""
    theta, h = equilibrium(speed, push), 1e-5
    inertia = 2.0 * (BALL * L**2 + INERTIA) + 4.0 * SLEEVE * (B * math.sin(theta)) ** 2
    stiffness = (moment(theta + h, speed, push) - moment(theta - h, speed, push)) / (2.0 * h)
    natural = math.sqrt(stiffness / inertia)
    ratio = DAMPING * (2.0 * B * math.sin(theta)) ** 2 / inertia / (2.0 * natural)
    return natural * math.sqrt(1.0 - ratio**2) / (2.0 * math.pi), ratio


def run(scenario):
    system = compile_model(load_model(FILE), scenario)
    memory = Memory()
    run_time(system, sink=memory)
    t, rows = np.concatenate(memory.times), np.concatenate(memory.rows)
    return t, lambda name: rows[:, system.layout.channel(name)]


def test_the_sleeve_lifts_at_the_speed_of_the_closed_form():
    t, channel = run("run_up")
    first = int(np.flatnonzero(channel("contact_force[seat]") <= 0.0)[0])
    opening = brentq(lambda speed: moment(REST, speed), 1.0, 100.0) / RPM
    assert opening == pytest.approx(146.22, abs=0.005)
    # the ripple of the mesh (0.05 rpm) and the preload, 0.33 N per 0.1 rpm, decide the last step
    assert -channel("speed[spindle]")[first] / RPM == pytest.approx(opening, rel=2e-3)
    # afterwards the sleeve swings about the equilibrium of each speed: the start of the lift leaves 0.3 mm
    for at in (4.0, 6.0, 8.0, 9.9):
        around = np.abs(t - at) < 0.5 / 3.4
        seen = float(np.mean(channel("displacement[sleeve.z]")[around]))
        assert seen == pytest.approx(lift(equilibrium((120.0 + 11.0 * at) * RPM)), abs=1.5e-4)


def test_frequency_of_the_released_sleeve():
    t, channel = run("hold")
    z = channel("displacement[sleeve.z]") - lift(equilibrium(190.0 * RPM))
    assert z[-1] == pytest.approx(0.0, abs=5e-4)
    z0 = channel("displacement[sleeve.z]")[0]
    assert z0 == pytest.approx(lift(equilibrium(190.0 * RPM, 4.0)), rel=1e-6)
    crossings = np.flatnonzero((z[1:] * z[:-1] < 0.0) & (t[1:] > 0.3))
    times = t[crossings] - z[crossings] * np.diff(t)[crossings] / np.diff(z)[crossings]
    frequency = 8.0 / (times[16] - times[0])  # whole periods: an amplitude of 1 mm shifts the mean
    assert frequency == pytest.approx(vibration(190.0 * RPM)[0], rel=1e-4)
    assert np.all(channel("contact_state[drive]") == 1.0)  # the drag keeps the flanks together


def test_modes_tell_the_same():
    modes = find_modes(compile_model(load_model(FILE), "hold"), "hold")
    frequency, ratio = vibration(190.0 * RPM, 4.0)
    assert modes.damped_frequency[0] == pytest.approx(frequency, rel=1e-4)
    assert modes.damping_ratio[0] == pytest.approx(ratio, rel=1e-3)
