# SPDX-License-Identifier: Apache-2.0
"""Equal explicit steps: no bit depends on how steps are cut into chunks, samples are of their state."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.explicit.runge_kutta import start_adams, start_classical
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.sampling import new_statistics
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.unit.system.test_mass_programmes import SEEN, SHAFTS

BOTH = pytest.mark.parametrize("begin", [start_classical, start_adams])


@BOTH
def test_chunks_change_no_bit(begin: Any) -> None:
    system = compile_model(loads_model(SHAFTS + SEEN), "driven")
    start = prepare_start(system, system.scenario)  # type: ignore[arg-type]
    found = []
    for sizes in ([300], [1, 99, 7, 193]):
        run = begin(start.system.copy(), start.state, 3e-6)
        chunks = [run.advance(n, every=1) for n in sizes]
        assert all(chunk.status == OK for chunk in chunks)
        found.append((np.concatenate([c.rows for c in chunks]), run.state()))
    (one, a), (many, b) = found
    np.testing.assert_array_equal(one, many)
    np.testing.assert_array_equal(a.q, b.q)
    np.testing.assert_array_equal(a.v, b.v)


def test_a_sample_holds_the_accelerations_of_its_state() -> None:
    """Torque of the drive and sensed acceleration against those that are solved anew at the same state."""
    system = compile_model(loads_model(SHAFTS + SEEN), "driven")
    start = prepare_start(system, system.scenario)  # type: ignore[arg-type]
    run = start_classical(start.system, start.state, 3e-6)
    chunk = run.advance(50, every=50)
    anew = start.system.copy()
    evaluate.prepare(anew)
    evaluate.load(anew, run.state())
    assert evaluate.accelerations(anew, run.t, 200.0) == OK
    row = evaluate.observe(anew, evaluate.store(anew, run.t))
    np.testing.assert_allclose(chunk.rows[0, 1:], row, rtol=1e-12, atol=1e-12 * np.abs(row).max())


def test_rates_told_are_those_of_the_state() -> None:
    """Adams' method foretells rates for the forces; what a row says of bodies are those that follow."""
    system = compile_model(loads_model(SHAFTS + SEEN), "driven")
    start = prepare_start(system, system.scenario)  # type: ignore[arg-type]
    run = start_adams(start.system, start.state, 3e-6)
    chunk = run.advance(50, every=50)
    reached = run.state()
    row = evaluate.observe(start.system, reached)
    names = [c.name for c in system.layout.channels]
    places = [k for k, name in enumerate(names) if name.startswith(("speed[", "velocity["))]
    assert places
    np.testing.assert_array_equal(chunk.rows[0, 1:][places], row[places])
    # and forces differ from those at these rates by what foretelling is off
    np.testing.assert_allclose(chunk.rows[0, 1:], row, rtol=1e-6, atol=1e-6 * np.abs(row).max())


@BOTH
def test_rows_told_with_the_slope_have_the_bits_of_rows_told_at_once(begin: Any) -> None:
    """Elements that need no acceleration say what they observe while forces are summed, the others later."""
    sensed = SEEN.partition("  heard")[0]  # what listens to others runs after all of them
    system = compile_model(loads_model(SHAFTS + sensed), "driven")
    start = prepare_start(system, system.scenario)  # type: ignore[arg-type]
    found = []
    for shares in (1, 0):
        run = begin(start.system.copy(), start.state, 3e-6)
        mach = run.system.workspace.mach[0]
        assert (mach["shares"], mach["later"]) == (1, 1)
        mach["shares"] = shares
        sums = new_statistics(system.sizes["no"])
        chunks = [run.advance(n, every=2, statistics=sums, stride=3, events=100) for n in (101, 7)]
        run.change_step(2e-6)
        chunks.append(run.advance(30, every=1))
        assert all(chunk.status == OK for chunk in chunks)
        found.append([*(c.rows for c in chunks), *(c.events for c in chunks), sums.sums, run.state().q])
    for told, whole in zip(*found, strict=True):
        np.testing.assert_array_equal(told, whole)


@pytest.mark.parametrize("seen", [SEEN, SEEN.partition("  heard")[0]])
@pytest.mark.parametrize("method", ["rk4", "adams", "generalized_alpha", "runge_kutta"])
def test_a_sink_gets_the_channels_that_it_asks_for(method: str, seen: str) -> None:
    """Of all kinds, whether they observe with the slope or after it; those not asked for need not observe."""
    model = loads_model(SHAFTS + seen)
    scenario = replace(model.scenarios["driven"], method=method, step=3e-6, sample_rate=1e5, settle_time=1e-3)
    rows = []
    system = compile_model(model, scenario)
    no = system.sizes["no"]
    for channels in ((), (7, 2, 7), *((k, 0) for k in range(2, no, 3))):
        sink = Memory()
        done = run_time(system.copy(), scenario, sink=sink, channels=channels)
        assert done.status == OK
        rows.append(np.concatenate(sink.rows))
        np.testing.assert_array_equal(rows[-1], rows[0][:, channels or slice(None)])
