# SPDX-License-Identifier: Apache-2.0
"""All integrators and forms of constraints on one model: accuracy against processor time.

The reference is the tightest run of one stiff method; its distance from a second one is the accuracy of the
reference. An error is the root mean square of the difference to it over all samples of a channel, as
a share of the alternating part of that channel; the worst channel counts.
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
from pitchpoint.solvers.initial_state.start import Start, prepare_start
from pitchpoint.solvers.step_choice import choose_step
from pitchpoint.solvers.time import loop_of, run_time
from pitchpoint.solvers.time_summary import Memory

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.system.system import System

TOLERANCES = (1e-4, 1e-5, 1e-6, 1e-7)
STEPS = (4.0, 2.0, 1.0, 0.5)
"""Steps of methods with equal steps, over the step that a run of the scenario would take."""
TIGHTER = 0.01
"""Tolerance of the reference over the least one compared."""
SAMPLES = 1000
STILL = 1e-9
"""Alternating part over the size of a channel below which it is constant: round-off would be compared."""


@dataclass(frozen=True)
class Attempt:
    """One run of the comparison.

    Parameters
    ----------
    method, form
        Integrator and form of the constraints, "" without constraints or where there is no choice.
    setting, value
        "tolerance" [-] or "step" [s], and how large.
    status, sentence
        How it ended, as a number and in words.
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
    """Runs of all methods, and what they are compared with.

    Parameters
    ----------
    attempts
        All runs, by method, form and setting.
    reference
        What the reference is, in words.
    doubt
        Difference of two tight runs, measured like an error; NaN if there is only one.
    """

    attempts: tuple[Attempt, ...]
    reference: str
    doubt: float


@dataclass(frozen=True)
class _Case:
    """One run to make."""

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
    """Methods, forms and settings that are compared on a system with so many constraint rows."""
    methods = [("generalized_alpha", form) for form in ("I3", "SI2")]
    methods += [(method, "") for method in EXPLICIT_METHODS]
    methods += [(method, form) for method in STIFF_METHODS for form in FORMS]
    known = set()
    for method, form in methods:
        shown = form if rows else ""
        if method == "dassl" and form != "I3":
            continue  # the other forms of this kind are of no use to anybody who has the next ones
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
    """Run one scenario with every integrator and form, at several settings each.

    Parameters
    ----------
    system
        Compiled with the scenario.
    scenario
        A time response; its method, form, order, tolerance and events do not count; its step is about the
        middle of the steps that are compared, and does not limit methods that choose theirs.
    limit_s
        Time after which a run is stopped [s].
    progress
        Called with the number of finished runs.

    Raises
    ------
    SolverError
        If the scenario cannot start, or no reference can be computed.
    """
    if scenario.duration is None:
        raise SolverError("the scenario has no duration; it is a sweep or a slow roll", 0)
    begin = prepare_start(system, scenario)
    rate = scenario.sample_rate or SAMPLES / scenario.duration
    step = choose_step(begin, replace(scenario, sample_rate=rate))[0]
    # no sample may shorten the longest step that is compared
    scenario = replace(scenario, sample_rate=scenario.sample_rate or min(rate, 1.0 / (max(STEPS) * step)))
    chosen = list(cases_of(system.sizes["nc"], step))
    for method in dict.fromkeys(case.method for case in chosen):
        address(loop_of(method))  # what is compiled is not measured
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
    """Samples to compare with, what they are, and how far a second run is from them."""
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
        raise SolverError(f"no tight run finished that could be compared with ({'; '.join(failed)})", 0)
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
    """One run, with its error if there is a reference; and its samples, times first."""
    chosen = case.applied_to(scenario)
    memory = Memory()
    begun = time.process_time()
    end = time.monotonic() + limit_s

    late = threading.Event()

    def stop_in_time(done: float, total: float, note: str = "") -> None:
        """End a run whose time is up, as Ctrl-C would."""
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
            raise KeyboardInterrupt  # it was the user
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
            continue  # states are counted in whole numbers: what they miss is a time, not a value
        error = float(np.sqrt(np.mean((found - given) ** 2))) / size
        if not error <= worst:
            worst, name = error, channel.name
    return worst, name
