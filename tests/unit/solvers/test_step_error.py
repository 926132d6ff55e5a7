# SPDX-License-Identifier: Apache-2.0
"""Error of the vibration by the step of generalised-alpha: closed form of the method, short steps."""

from __future__ import annotations

import math
import re

import pytest

from pitchpoint.core.status import OK
from pitchpoint.solvers.step_error import equivalent, frequency_shift
from pitchpoint.solvers.time import run_time
from tests.support.machines import compiled, pair

OMEGA = 2.0 * math.pi * 50.0
INERTIA, DAMPING = 0.01, 0.01
DISC = (
    f"bodies: {{disc: {{motion: torsion, inertia: {INERTIA}}}, wall: {{motion: fixed}}}}\n"
    f"couplings: {{spring: {{bodies: [disc, wall], stiffness: {{torsion: {INERTIA * OMEGA**2!r}}}, "
    f"damping: {{torsion: {2.0 * DAMPING * INERTIA * OMEGA!r}}}}}}}\n"
    "loads: {shake: {body: disc, torque: '1 N m * sin(2*pi*49 Hz*t)'}}\n"
    "scenarios: {run: {duration: 9 s, settle_time: 8 s, step: 1 ms}}\n"
)
RESONANCE = "{law: fourier, mean: 4e8 N/m, cosine: [-0.002, 0, 0.001]}, damper: {ratio: 0.01}"
R_B = 0.0422861679353659
NATURAL = math.sqrt(4e8 * R_B**2 * (1.0 / 0.002 + 2.25 / 0.01))
"""Natural frequency of the pair on its mesh [rad/s]."""


def run(text, scenario="run"):
    model, system = compiled(text, scenario)
    done = run_time(system)
    assert done.status == OK
    return model, done


def geared(step, *, below=0.985, method="", duration=0.4):
    """A pair whose mesh frequency is a share of its natural frequency, with a number of steps per period."""
    omega = below * NATURAL
    return pair(
        RESONANCE,
        torque="100 N m",
        rest=f"scenarios: {{run: {{speed: {{driver: {omega / 30.0!r} rad/s}}, duration: {duration} s, "
        f"settle_time: {duration / 2.0} s, step: {2.0 * math.pi / omega / step!r}{method}}}}}\n",
    )


def notes_of(done):
    return [str(n) for n in done.notes if "linear estimate" in str(n)]


def test_forced_vibration_is_that_of_the_equivalent_matrices():
    """A disc on a spring at 0.98 of its natural frequency, 20 steps per period, after the decay of its own.

    The step lowers the natural frequency to that of the load: the response is 1.44 times too large.
    """
    _, done = run(DISC)
    omega, h = 2.0 * math.pi * 49.0, 1e-3
    s_1, s_2 = equivalent(omega, h)
    k, d = INERTIA * OMEGA**2, 2.0 * DAMPING * INERTIA * OMEGA
    stiffness = k + s_1 * d + s_2 * INERTIA
    exact = k + 1j * omega * d - omega**2 * INERTIA
    angle = done.channels["angle[disc]"]["rms"]
    assert angle == pytest.approx(1.0 / abs(stiffness) / math.sqrt(2.0), rel=1e-7)
    assert abs(exact / stiffness) == pytest.approx(1.44, abs=0.01)


@pytest.mark.parametrize("below", [0.985, 1.01])
def test_the_note_gives_the_change_of_the_mesh_force(below):
    """Below the resonance the step raises the force, above it lowers the force.

    Reference: a run with 16 times as many steps.

    The estimate is linear, with the mean stiffness: parametric excitation and the slope of the second order
    remain, less than a tenth of the change.
    """
    _, coarse = run(geared(15, below=below))
    (text,) = notes_of(coarse)
    told = float(re.search(r"mesh_force\[stage\] by ([+-]\d+) %", text).group(1))
    _, fine = run(geared(240, below=below))
    assert not notes_of(fine)
    seen = coarse.channels["mesh_force[stage]"]["rms"] / fine.channels["mesh_force[stage]"]["rms"] - 1.0
    assert told == pytest.approx(100.0 * seen, rel=0.1)
    assert abs(told) > 20.0
    assert f"{100.0 * frequency_shift(2.0 * math.pi, 1.0 / 15.0):.2g} %" in text


def test_the_recommended_step_is_short_enough():
    _, coarse = run(geared(15))
    step, unit = re.search(r"use ([\d.]+) (µs|ms)", notes_of(coarse)[0]).groups()
    omega = 0.985 * NATURAL
    count = 2.0 * math.pi / omega / (float(step) * {"µs": 1e-6, "ms": 1e-3}[unit])
    _, short = run(geared(count))
    _, fine = run(geared(240))
    ratio = short.channels["mesh_force[stage]"]["rms"] / fine.channels["mesh_force[stage]"]["rms"]
    assert ratio == pytest.approx(1.0, abs=0.025)


def test_other_methods_and_changing_speeds_have_no_note():
    assert not notes_of(run(geared(15, method=", method: rk4", duration=0.05))[1])
    text = geared(15, duration=0.05).replace("torque: balance", "torque: -20 N m")
    assert not notes_of(run(text)[1])
