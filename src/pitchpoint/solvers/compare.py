# SPDX-License-Identifier: Apache-2.0
"""Comparison of all integrators and constraint formulations on one model: accuracy against processor time.

The reference is a run of a stiff method with a tight tolerance; its difference from a second tight run is the
uncertainty of the reference. The error is the rms difference from the reference over all samples of a
channel, relative to the rms of the alternating part of that channel; the worst channel counts.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.kernel import address
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INTERRUPTED, OK
from pitchpoint.model.scenario import ERROR_METHODS, EXPLICIT_METHODS, FORMS, STIFF_METHODS
from pitchpoint.solvers.fixed_steps import loop_of, without_long_steps
from pitchpoint.solvers.initial_state.start import Start, prepare_start
from pitchpoint.solvers.step_choice import choose_step
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.system.system import System

TOLERANCES = (1e-4, 1e-5, 1e-6, 1e-7)
STEPS = (4.0, 2.0, 1.0, 0.5)
"""Steps of fixed-step methods, relative to the default step of the scenario."""
TIGHTER = 0.01
"""Tolerance of the reference relative to the tightest one compared."""
SAMPLES = 1000
STILL = 1e-9
"""Alternating part over the maximum of a channel below which it counts as constant and is not compared."""


@dataclass(frozen=True)
class Attempt:
    """One run of the comparison.

    Parameters
    ----------
    method, form
        Integrator and constraint formulation; "" without constraints or without a choice.
    setting, value
        "tolerance" [-] or "step" [s], and its value.
    status, sentence
        Status code and its description.
    steps, cpu_s, t_end
        Accepted steps, processor time [s], time reached [s].
    error, channel
        Error of the worst channel against the reference, and its name; NaN if the run did not finish.
    """

    method: str
    form: str
    setting: str
    value: float
    status: int
    sentence: str
    steps: int
    cpu_s: float
    t_end: float
    error: float
    channel: str


@dataclass(frozen=True)
class Comparison:
    """Runs of all methods, and their reference.

    Parameters
    ----------
    attempts
        All runs, ordered by method, form and setting.
    reference
        Description of the reference.
    doubt
        Difference of two tight runs, computed like an error; NaN if there is only one.
    """

    attempts: tuple[Attempt, ...]
    reference: str
    doubt: float


@dataclass(frozen=True)
class _Case:
    """Settings of one run."""

    method: str
    form: str
    setting: str
    value: float

    def applied_to(self, scenario: Scenario) -> Scenario:
        """The scenario with method, form and setting of this run."""
        chosen = replace(scenario, method=self.method, form=self.form or None, order=None, events=())
        if self.setting == "tolerance":
            return replace(chosen, tolerance=self.value, step=None)
        return replace(chosen, step=self.value)


def cases_of(rows: int, step: float) -> Iterator[_Case]:
    """Methods, forms and settings to compare, for the number of constraint rows and the default step."""
    methods = [("generalized_alpha", form) for form in ("I3", "SI2")]
    methods += [(method, "") for method in EXPLICIT_METHODS]
    methods += [(method, form) for method in STIFF_METHODS for form in FORMS]
    known = set()
    for method, form in methods:
        shown = form if rows else ""
        if method == "dassl" and form != "I3":
            continue  # its other forms bring nothing over the methods that follow
        if (method, shown) in known:
            continue
        known.add((method, shown))
        if method in ERROR_METHODS:
            yield from (_Case(method, shown, "tolerance", x) for x in TOLERANCES)
        else:
            yield from (_Case(method, shown, "step", x * step) for x in STEPS)


def compare_solvers(
    system: System,
    scenario: Scenario,
    *,
    limit_s: float = 20.0,
    progress: Progress = silent,
) -> Comparison:
    """Run one scenario with every integrator and constraint formulation, at several settings each.

    Parameters
    ----------
    system
        Compiled with the scenario.
    scenario
        A time response. Method, form, order, tolerance and events are ignored; its step is about the middle
        of the compared steps and does not limit methods with step control.
    limit_s
        Wall time after which a run is stopped [s].
    progress
        Called with the number of finished runs.

    Raises
    ------
    SolverError
        If the scenario cannot start, or no reference can be computed.
    """
    scenario = without_long_steps(system, scenario, "a comparison of methods")
    if scenario.duration is None:
        raise SolverError("the scenario has no duration; it is a sweep or a slow roll", 0)
    begin = prepare_start(system, scenario)
    rate = scenario.sample_rate or SAMPLES / scenario.duration
    step = choose_step(begin, replace(scenario, sample_rate=rate))[0]
    # the sample period must not shorten the longest step compared
    scenario = replace(scenario, sample_rate=scenario.sample_rate or min(rate, 1.0 / (max(STEPS) * step)))
    chosen = list(cases_of(system.sizes["nc"], step))
    for method in dict.fromkeys(case.method for case in chosen):
        address(loop_of(method))  # compile first, so that compile time is not measured
    total = len(chosen) + 2
    progress(0, total, "reference")
    reference, words, doubt = _reference(begin, scenario, 5.0 * limit_s)
    attempts = []
    for k, case in enumerate(chosen):
        progress(k + 2, total, f"{case.method} {case.form}".strip())
        attempts.append(_attempt(begin, scenario, case, limit_s, reference)[0])
    progress(total, total)
    return Comparison(tuple(attempts), words, doubt)


def _reference(begin: Start, scenario: Scenario, limit_s: float) -> tuple[NDArray[np.float64], str, float]:
    """Reference samples, their description, and the difference of a second run from them."""
    tight = TIGHTER * min(TOLERANCES)
    found: list[tuple[str, NDArray[np.float64]]] = []
    failed = []
    for method, form in (("wstiff", "SI2"), ("gstiff", "SI1"), ("runge_kutta", "")):
        shown = form if begin.system.sizes["nc"] else ""
        case = _Case(method, shown, "tolerance", tight)
        attempt, rows = _attempt(begin, scenario, case, limit_s, None)
        if attempt.status == OK:
            found.append((f"{method} {shown}".strip(), rows))
        else:
            failed.append(f"{method}: {attempt.sentence}")
        if len(found) == 2:
            break
    if not found:
        raise SolverError(f"no reference run finished ({'; '.join(failed)})", 0)
    name, rows = found[0]
    doubt = _error(begin.system, found[1][1], rows)[0] if len(found) > 1 else float("nan")
    return rows, f"{name} with tolerance {tight:g}", doubt


def _attempt(
    begin: Start,
    scenario: Scenario,
    case: _Case,
    limit_s: float,
    reference: NDArray[np.float64] | None,
) -> tuple[Attempt, NDArray[np.float64]]:
    """Carry out one run; returns it, with its error if there is a reference, and its samples (time first)."""
    chosen = case.applied_to(scenario)
    memory = Memory()
    begun = time.process_time()
    end = time.monotonic() + limit_s

    late = threading.Event()

    def stop_in_time(done: float, total: float, note: str = "") -> None:
        """Stop a run at the time limit, as Ctrl-C would."""
        if time.monotonic() > end:
            late.set()
            raise KeyboardInterrupt

    status, steps, t_end = INTERRUPTED, 0, begin.state.t
    try:
        done = run_time(begin.system, chosen, sink=memory, progress=stop_in_time, start=begin)
        status, sentence, steps, t_end = done.status, done.sentence, done.steps, done.t_end
    except SolverError as error:
        status, sentence = error.status, str(error)
    cpu_s = time.process_time() - begun
    if status == INTERRUPTED:
        if not late.is_set():
            raise KeyboardInterrupt  # interrupted by the user
        sentence = f"stopped after {limit_s:g} s at t = {t_end:.4g} s"
    rows = np.zeros((0, 1))
    if memory.rows:
        rows = np.column_stack([np.concatenate(memory.times), np.concatenate(memory.rows)])
    miss, channel = float("nan"), ""
    if status == OK and reference is not None:
        miss, channel = _error(begin.system, rows, reference)
    attempt = Attempt(
        case.method,
        case.form,
        case.setting,
        case.value,
        status,
        sentence,
        steps,
        cpu_s,
        t_end,
        miss,
        channel,
    )
    return attempt, rows


def _error(system: System, rows: NDArray[np.float64], reference: NDArray[np.float64]) -> tuple[float, str]:
    """Error of the worst channel, and its name."""
    n = min(len(rows), len(reference))
    worst, name = 0.0, ""
    for k, channel in enumerate(system.layout.channels, start=1):
        given, found = reference[:n, k], rows[:n, k]
        size = float(np.std(given))
        still = size <= STILL * max(float(np.abs(given).max(initial=0.0)), 1e-300)
        if still or bool(np.all(given == np.round(given))):
            continue  # integer states: an error there is one of time, not of value
        error = float(np.sqrt(np.mean((found - given) ** 2))) / size
        if not error <= worst:
            worst, name = error, channel.name
    return worst, name
