# SPDX-License-Identifier: Apache-2.0
"""Runs with steps that are much too long: every one ends, and none that diverges ends "finished"."""

from __future__ import annotations

import re
import time
from dataclasses import replace
from functools import cache
from pathlib import Path

import h5py
import numpy as np
import pytest

from pitchpoint import load_model
from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import PitchpointError, SolverError
from pitchpoint.core.status import NOT_FINITE, OK, UNBOUNDED
from pitchpoint.elements.mesh.line_of_action import countable
from pitchpoint.solvers.divergence import remedy
from pitchpoint.solvers.equilibrium import force_jumps
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.sampling import GREATEST
from pitchpoint.solvers.step_choice import choose_step
from pitchpoint.solvers.time import run_time, solve_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model
from tests.support.advanced_contact import folder_with_table
from tests.support.limited import within_limit
from tests.unit.solvers.test_time_loops import oscillator

EXAMPLES = Path(__file__).parents[3] / "examples"
METHODS = ("generalized_alpha", "rk4", "adams", "runge_kutta", "gstiff", "wstiff", "dassl", "constant_bdf")
FACTORS = (3, 10, 30, 100, 300, 1000)
MAX_STEPS = 400
PATIENCE = 3.0
"""Processor time after which a run is asked to stop [s]."""

# an example has shifts beyond the range of its stiffness polynomial on purpose
pytestmark = pytest.mark.filterwarnings("ignore::pitchpoint.core.errors.ValidityWarning")


@cache
def machine(file, name):
    """System of an example, its scenario, and the step that a run of it takes; None if it has no such run."""
    model = load_model(EXAMPLES / file, allow_code=True)
    scenario = model.scenarios[name]
    system = compile_model(model, scenario)
    step = choose_step(prepare_start(system, scenario), replace(scenario, sample_rate=None))[0]
    return system, scenario, step


def ending(file, name, method, step, most=MAX_STEPS):
    """How a run of so many steps ends: status, sentence, whether all that it keeps are proper numbers."""
    system, scenario, _ = machine(file, name)
    chosen = replace(
        scenario,
        method=method,
        form=None,
        order=None,
        step=step,
        duration=min(scenario.duration, most * step),
        settle_time=0.0,
        sample_rate=None,
        events=(),
    )
    memory, end = Memory(), time.process_time() + PATIENCE

    def stop_in_time(*_):
        """End a run that is only long, as Ctrl-C would."""
        if time.process_time() > end:
            raise KeyboardInterrupt

    try:
        done = run_time(system, chosen, sink=memory, progress=stop_in_time)
    except PitchpointError as error:
        return error.status if isinstance(error, SolverError) else -1, str(error), True
    rows = np.concatenate(memory.rows)
    numbers = np.array([[c[key] for key in ("mean", "rms", "min", "max")] for c in done.channels.values()])
    # without a sample in their window there are no statistics
    proper = bool((np.abs(rows) < GREATEST).all()) and not bool(np.isinf(numbers).any())
    if done.status == OK and done.steps:
        proper = proper and bool(np.isfinite(numbers).all())
    return done.status, done.sentence, proper


def warmed(file, name, method):
    """Compile what a run takes, so that the runs in other processes need not."""
    ending(file, name, method, machine(file, name)[2], 3)


@pytest.mark.parametrize(
    ("file", "name", "method", "step"),
    [
        ("backlash-oscillator/model.yaml", "steady", "adams", 1.49e-4),
        ("backlash-oscillator/model.yaml", "steady", "adams", 1e-2),
        ("camshaft-drive/release-backlash.yaml", "release", "adams", 6e-3),
        ("clutch-driveline/engagement.yaml", "pull_away", "rk4", 1.5e-3),
        ("clutch-driveline/engagement.yaml", "pull_away", "adams", 2e-3),
    ],
)
def test_a_run_that_diverges_ends_and_says_so(file, name, method, step):
    """They hung in a count of tooth pairs beyond 2^53, or ended "finished" with 1e232 and more."""
    warmed(file, name, method)
    found = within_limit(lambda: ending(file, name, method, step))
    assert found is not None, "the run does not end"
    status, sentence, proper = found
    assert status in (UNBOUNDED, NOT_FINITE)
    assert proper
    assert "reduce `step`" in sentence


def test_the_sentence_names_what_diverged_and_when_and_the_result_before_it_is_kept(tmp_path, capsys):
    text = (EXAMPLES / "backlash-oscillator" / "model.yaml").read_text()
    line = next(row for row in text.splitlines() if row.strip().startswith("steady:"))
    text = text.replace(
        line, "  steady: {speed: {driver: 3300 rpm}, duration: 0.1 s, method: adams, step: 150 us}"
    )
    (tmp_path / "model.yaml").write_text(text)
    target = tmp_path / "run.h5"
    assert run_command(["run", str(tmp_path / "model.yaml"), "-s", "steady", "-o", str(target)]) == 3
    printed = capsys.readouterr().err
    assert "the solution grew without bound: the rate of driver.spin is" in printed
    assert printed.count(" at t = 0.00") == 1
    with h5py.File(target) as file:
        assert file.attrs["status"] == b"failed"
        times = file["time"][:]
        assert len(times) > 1
        for name, data in file.items():
            if getattr(data, "shape", ())[:1] == times.shape and data.dtype.kind == "f":
                assert np.isfinite(data[:]).all(), name


def test_python_gets_the_partial_dataset_with_the_error():
    system, scenario, _ = machine("backlash-oscillator/model.yaml", "steady")
    chosen = replace(scenario, method="adams", step=1.5e-4, sample_rate=None)
    with pytest.raises(SolverError, match="grew without bound") as raised:
        solve_time(system, chosen)
    assert raised.value.status == UNBOUNDED
    assert raised.value.partial.sizes["time"] > 1


def test_a_smaller_step_is_suggested_only_where_one_helps():
    """Constant BDF shortens a step that fails by itself; the step that a run chooses is short enough."""
    system, scenario, step = machine("backlash-oscillator/model.yaml", "steady")
    start = prepare_start(system, scenario)
    long = replace(scenario, method="adams", step=100.0 * step)
    assert "100 times" in remedy(start, long, UNBOUNDED, 100.0 * step)
    assert remedy(start, replace(scenario, method="adams"), UNBOUNDED, step) == ""
    assert remedy(start, replace(long, method="constant_bdf"), UNBOUNDED, 100.0 * step) == ""
    assert remedy(start, long, OK, 100.0 * step) == ""


@pytest.mark.parametrize(
    ("u", "travel", "eps", "status"),
    [
        (0.0, 0.3, 1.6, OK),
        (1e5, -2.0, 1.6, OK),
        (2.0**55, 0.0, 1.6, UNBOUNDED),
        (0.0, float("nan"), 1.6, UNBOUNDED),
        (float("inf"), 0.0, 1.6, UNBOUNDED),
        (0.0, 0.0, 1e18, UNBOUNDED),
    ],
)
def test_pairs_of_teeth_are_counted_only_where_a_count_ends(u, travel, eps, status):
    assert countable(u, travel, 1e-2, eps) == status


def test_bisection_to_a_jump_ends_where_numbers_lie_far_from_each_other():
    """At 3e12 rad two neighbouring numbers are 5e-4 rad from each other."""
    system, state = oscillator()
    one, two = state.copy(), state.copy()
    one.q[:], two.q[:] = -3e12, 3e12 + 1.0
    goal = np.full(1, 1e-9)
    assert (
        within_limit(lambda: force_jumps.rest_between(system, one, two, np.array([0]), goal) is None)
        is not None
    )


# every kind of machine once: torsional mesh, clutch with mesh, mechanism with rods, spatial bevel gears
SHORT = [
    ("backlash-oscillator/tip-relief.yaml", "steady", ("adams", "rk4"), (30, 300)),
    ("clutch-driveline/judder.yaml", "creep", ("adams", "rk4"), (30, 1000)),
    ("bevel-drive/straight.yaml", "steady", ("adams", "generalized_alpha"), (30, 300)),
]


def scenarios():
    """All examples and those of their scenarios that are responses over time."""
    for file in sorted(EXAMPLES.glob("*/*.yaml")):
        text = file.read_text()
        # files to be included have no title
        if "scenarios:" in text and re.search("^title:", text, re.M) and ".gcp.h5" not in text:
            yield str(file.relative_to(EXAMPLES))


@pytest.mark.parametrize(("file", "name", "methods", "factors"), SHORT)
def test_no_run_with_long_steps_hangs_or_hides_a_divergence(file, name, methods, factors):
    for method in methods:
        warmed(file, name, method)
        for factor in factors:
            step = factor * machine(file, name)[2]
            found = within_limit(lambda step=step, method=method: ending(file, name, method, step))
            assert found is not None, f"{method}, {factor} times: does not end"
            assert found[2], f"{method}, {factor} times: {found[1]}"


def with_all_methods_and_steps(file):
    """No run hangs, and none keeps a number that is none without a status."""
    model = load_model(EXAMPLES / file, allow_code=True)
    for name, scenario in model.scenarios.items():
        if scenario.duration is None or scenario.method == "kinematics":
            continue
        try:
            step = machine(file, name)[2]
        except PitchpointError:
            continue  # it cannot start, with any method
        for method in METHODS:
            warmed(file, name, method)
            for factor in FACTORS:
                if factor * step > scenario.duration:
                    continue
                found = within_limit(
                    lambda name=name, method=method, h=factor * step: ending(file, name, method, h), 60
                )
                assert found is not None, f"{name}, {method}, {factor} times: does not end"
                assert found[2], f"{name}, {method}, {factor} times: {found[1]}"


@pytest.mark.study
@pytest.mark.parametrize("file", list(scenarios()))
def test_all_examples_with_all_methods_and_steps_up_to_a_thousand_times_too_long(file):
    with_all_methods_and_steps(file)


@pytest.mark.study
def test_contact_by_a_table_with_all_methods_and_steps_up_to_a_thousand_times_too_long(tmp_path):
    """A diverging run leaves the table at once."""
    with_all_methods_and_steps(folder_with_table(tmp_path) / "precomputed.yaml")
