# SPDX-License-Identifier: Apache-2.0
"""One law, many callers: statics, modes and time integration must agree about the same thing."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.solvers.implicit.generalized_alpha import start
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.operating_point import operating_point
from pitchpoint.solvers.quasistatic.roll import roll_through
from tests.support.machines import compiled, pair

LAWS = [
    ("{law: constant, value: 3e8 N/m}", 1e-4),
    # modes hold the mesh phase, but the vibration moves it a little: dk/dpsi times the static deflection
    ("{law: din3990, stiffness_ratio: 0.8, tip_relief_factor: 0.5}", 5e-4),
]


@pytest.mark.parametrize(("law", "tolerance"), LAWS)
def test_small_vibration_has_the_modal_frequency(law, tolerance):
    """Free vibration of 1e-9 m about the equilibrium, undamped: zero crossings against the modes."""
    system = compiled(pair(law))[1]
    f = find_modes(system, mean=False).frequency[1]
    point = operating_point(system)
    state = point.state.copy()
    # as much momentum in one gear as in the other: the pair vibrates and does not roll away
    state.v[:] = 1e-9 * 2 * math.pi * f / 0.1 * np.array([1.0 / 0.002, 1.5 / 0.01]) / 500.0
    h = 1.0 / (f * 400.0)
    run = start(point.system, state, h, rho_inf=1.0, tolerance=1e-17)
    chunk = run.advance(400 * 20, every=1)
    assert chunk.status == OK
    t, u = chunk.rows[:, 0], chunk.rows[:, 1 + system.layout.channel("transmission_error[stage]")]
    u = u - u.mean()
    up = np.flatnonzero((u[:-1] < 0.0) & (u[1:] >= 0.0))
    crossing = t[up] - u[up] * (t[up + 1] - t[up]) / (u[up + 1] - u[up])
    found = (len(crossing) - 1) / (crossing[-1] - crossing[0])
    assert found == pytest.approx(f, rel=tolerance)


def test_slow_rotation_follows_the_quasi_static_error():
    """At one mesh period per second nothing vibrates: the response is the static error of its phase."""
    text = pair(
        "{law: fourier, mean: 3e8 N/m, cosine: [-0.2]}, damper: {ratio: 0.2}",
        rest="scenarios:\n  slow: {drive: {driver: {speed: 2 rpm}}, duration: 1 s}\n",
    )
    from pitchpoint.solvers.initial_state.start import prepare_start

    model, system = compiled(text, "slow")
    begin = prepare_start(system, model.scenarios["slow"])
    run = start(begin.system, begin.state, 1e-5)
    chunk = run.advance(100_000, every=500)
    assert chunk.status == OK
    te = chunk.rows[:, 1 + system.layout.channel("transmission_error[stage]")]
    psi = chunk.rows[:, 1 + system.layout.channel("mesh_phase[stage]")]
    roll = roll_through(system, "stage", 200)
    static = roll.rows[:, system.layout.channel("transmission_error[stage]")]
    phase = roll.rows[:, system.layout.channel("mesh_phase[stage]")]
    order = np.argsort(phase)
    expected = np.interp(psi, phase[order], static[order], period=1.0)
    assert te[5:] == pytest.approx(expected[5:], rel=3e-5)
