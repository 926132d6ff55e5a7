# SPDX-License-Identifier: Apache-2.0
"""Attitudes of tumbling bodies, in the kernel and as channels of a run."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from pitchpoint.multibody.attitude import attitude
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble


def test_quaternion_is_that_of_the_turns_one_after_the_other():
    """Against another implementation, at charts whose largest square is each of the four."""
    out = np.zeros(5)
    kinds = set()
    for k, chart in enumerate(Rotation.random(60, rng=1)):
        alpha, beta, spin = np.random.default_rng(k).uniform(-3.0, 3.0, 3)
        kinds.add(int(np.argmax(np.abs(chart.as_quat()))))
        attitude(chart.as_matrix(), alpha, beta, spin, out, 1)
        exact = (chart * Rotation.from_euler("XYZ", [alpha, beta, spin])).as_quat(canonical=True)
        assert out[1:] == pytest.approx(exact, abs=1e-14) and out[0] == 0.0
    assert kinds == {0, 1, 2, 3}


def test_channels_of_a_tumbling_body_tell_its_axes():
    """Turning about its middle axis it takes new charts; the quaternion does not care."""
    body = Body(motion=FLOATING, mass=1.0, inertia=np.diag([0.01, 0.02, 0.025]), name="stone")
    system = assemble([body], {})
    state = system.initial_state()
    state.v[3:] = (0.05, 6.0, 0.03)
    run = runge_kutta.start_adaptive(system, state, rtol=1e-9, atol=1e-12, atol_rate=1e-10)
    columns = [system.layout.channel(f"attitude[stone.{c}]") for c in "xyzw"]
    for end in (0.3, 0.9, 2.0):
        run.advance_to(end)
        now = run.state()
        found = Rotation.from_quat(evaluate.observe(system, now)[columns])
        evaluate.residual(system, now)
        assert found.as_matrix() == pytest.approx(system.workspace.fr[1]["S"], abs=1e-12)
    assert np.abs(now.charts - np.eye(3)).max() > 0.1
