# SPDX-License-Identifier: Apache-2.0
"""Closing loops: against plane geometry, with what is over-determined and what cannot be."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.system import evaluate
from tests.support.mechanisms import four_bar, slider_crank


def test_a_slider_crank_closes_where_geometry_says():
    system = slider_crank()
    state = system.initial_state()
    crank = system.layout.coordinate("crank.spin")
    state.q[crank], state.v[crank] = 0.7, 3.0
    found = assemble_state(system, state, keep=[crank], keep_rates=[crank])
    theta, r, rod = 0.4 + 0.7, 0.3, 1.0
    before = r * np.cos(0.4) + np.sqrt(rod**2 - (r * np.sin(0.4)) ** 2)
    root = np.sqrt(rod**2 - (r * np.sin(theta)) ** 2)
    z = system.layout.coordinate("slider.z")
    assert found.state.q[crank] == 0.7
    assert found.state.q[z] == pytest.approx(r * np.cos(theta) + root - before, abs=1e-12)
    speed = -3.0 * (r * np.sin(theta) + r * np.cos(theta) * r * np.sin(theta) / root)
    assert found.state.v[z] == pytest.approx(speed, abs=1e-11)
    assert found.freedoms == 1
    assert found.redundant == ()
    assert "loops were closed by moving" in found.report()[0]


def test_a_planar_four_bar_with_spatial_joints_repeats_three_rows():
    found = assemble_state(four_bar())
    assert found.freedoms == 1
    assert len(found.redundant) == 3


def test_a_loop_that_cannot_close_is_named_with_what_is_missing():
    """The slider is 0.2 m too far for crank and rod in a line: half of the gap stays at the pin."""
    system = slider_crank()
    state = system.initial_state()
    z = system.layout.coordinate("slider.z")
    reach = 1.3 - (0.3 * np.cos(0.4) + np.sqrt(1.0 - (0.3 * np.sin(0.4)) ** 2))
    state.q[z] = reach + 0.2
    with pytest.raises(SolverError, match=r"loops do not close: closure pin x is off by 0\.2"):
        assemble_state(system, state, keep=[z])


def test_rates_that_contradict_each_other_are_named():
    system = slider_crank()
    state = system.initial_state()
    crank, z = system.layout.coordinate("crank.spin"), system.layout.coordinate("slider.z")
    state.v[crank], state.v[z] = 3.0, 5.0
    with pytest.raises(SolverError, match=r"initial rates contradict .* crank\.spin, slider\.z"):
        assemble_state(system, state, keep_rates=[crank, z])


def test_nothing_to_do_without_rows():
    from tests.support.engine import rattle

    system = rattle()
    found = assemble_state(system)
    assert found.freedoms == 2
    assert found.report() == ()
    np.testing.assert_array_equal(found.state.q, system.initial_state().q)


def test_the_assembled_state_has_consistent_accelerations():
    system = four_bar(points=((0.0, 0.0), (0.2, 0.9), (1.3, 1.1), (1.2, 0.0)))
    state = system.initial_state()
    crank = system.layout.coordinate("crank.spin")
    state.v[crank] = 2.0
    found = assemble_state(system, state, keep_rates=[crank]).state
    evaluate.load(system, found)
    evaluate.check(system, evaluate.send_request(system.workspace, evaluate.ACCELERATE, 0.0))
    a = system.workspace.a.copy()
    h = 1e-4
    rates = []
    for sign in (1.0, -1.0):
        moved = found.copy()
        moved.q[crank] += sign * h * 2.0 + 0.5 * h * h * a[crank]
        moved.v[crank] += sign * h * a[crank]
        moved.q[np.arange(3) != crank] += sign * h * found.v[np.arange(3) != crank]
        rates.append(assemble_state(system, moved, keep=[crank], keep_rates=[crank]).state.v)
    np.testing.assert_allclose((rates[0] - rates[1]) / (2 * h), a, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("turn", [-2.5, 2.5, -6.0])
def test_a_crank_far_from_where_it_was_drawn(turn):
    """The loop closes the way it was drawn: the slider stays in front of the crank."""
    system = slider_crank()
    state = system.initial_state()
    crank = system.layout.coordinate("crank.spin")
    state.q[crank] = turn
    found = assemble_state(system, state, keep=[crank]).state
    r, rod = 0.3, 1.0
    x = [r * np.cos(t) + np.sqrt(rod**2 - (r * np.sin(t)) ** 2) for t in (0.4, 0.4 + turn)]
    assert found.q[crank] == turn
    assert found.q[system.layout.coordinate("slider.z")] == pytest.approx(x[1] - x[0], abs=1e-12)
