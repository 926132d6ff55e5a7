# SPDX-License-Identifier: Apache-2.0
"""Time response of a system: chunks of compiled steps, with progress, streaming output and statistics."""

from __future__ import annotations

import json
import time
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, SolverError, join_notes, note
from pitchpoint.core.event_list import event_variables
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INCONSISTENT, INTERRUPTED, NOT_FINITE, OK, UNBOUNDED
from pitchpoint.model.scenario import ERROR_METHODS, EXPLICIT_METHODS, STIFF_METHODS
from pitchpoint.solvers.constraints.row_notes import explain, row_notes
from pitchpoint.solvers.contact_counts import CONTACT_NUMBERS, new_counts, read_counts
from pitchpoint.solvers.divergence import FAILURES, fastest, remedy, sentence_of
from pitchpoint.solvers.event_watch import EventWatch
from pitchpoint.solvers.fixed_steps import start_run
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.initial_state.start import Start, prepare_start
from pitchpoint.solvers.sample_notes import sample_notes
from pitchpoint.solvers.sampling import new_statistics, read_statistics
from pitchpoint.solvers.speed_drift import drift_notes, runaway
from pitchpoint.solvers.step_choice import (
    choose_step,
    largest_step,
    largest_stiff_step,
    next_chunk,
    whole_steps,
)
from pitchpoint.solvers.step_error import step_notes
from pitchpoint.solvers.time_summary import Memory, Sink, TimeSummary, channel_statistics
from pitchpoint.solvers.vibration_losses import with_vibration_losses
from pitchpoint.system import evaluate
from pitchpoint.system.channel_choice import chosen_channels
from pitchpoint.system.flank_remarks import contact_counters
from pitchpoint.system.meshes import forget_contacts
from pitchpoint.system.planet_windows import window_notes
from pitchpoint.system.remarks import run_remarks
from pitchpoint.system.system import System
from pitchpoint.system.workspace import REJECTED

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.scenario import Scenario
    from pitchpoint.solvers.sampled_control import Sampler
    from pitchpoint.solvers.sampling import Accumulators, Chunk

MAX_SAMPLES = 100_000
"""Size of the sample buffer of a chunk of an adaptive method."""


def scenario_of(system: System, scenario: Scenario | None) -> Scenario:
    """The scenario to run: the given one or the one the system was compiled with."""
    chosen = system.scenario if scenario is None else scenario
    if chosen is None:
        raise SolverError("no scenario given, and the system was compiled without one", NOT_FINITE)
    return chosen


def run_time(
    system: System,
    scenario: Scenario | None = None,
    *,
    sink: Sink | None = None,
    progress: Progress = silent,
    start: Start | None = None,
    channels: Sequence[int] = (),
) -> TimeSummary:
    """Compute the time response of a scenario up to its duration, for any step size.

    Samples are taken at multiples of the sample period; the last one is at the duration if that is a
    multiple, otherwise before it. Without a sample rate every step is a sample and the step size divides the
    duration.

    Parameters
    ----------
    system
        Compiled with the scenario (`compile_model(model, scenario)`).
    scenario
        Scenario to run; default the one of the system.
    sink
        Receives the samples; without one only statistics are computed.
    progress
        Called with the time reached after every chunk.
    start
        Initial state; default the start of the scenario.
    channels
        Indices of the channels passed to the sink, in this order; default all.

    Returns
    -------
    TimeSummary
        Returned for a failed or interrupted run too; see its status.

    Raises
    ------
    SolverError
        If the run cannot start.
    """
    chosen = scenario_of(system, scenario)
    if chosen.duration is None:
        raise SolverError("the scenario has no duration; it is a sweep or a slow roll", NOT_FINITE)
    begun = time.perf_counter()
    begin = start or with_vibration_losses(prepare_start(system, chosen), chosen, run_time)
    forget_contacts(begin.system)  # trial states of the start do not count
    loop = Loop(begin, chosen, sink, channels)
    return loop.summary(loop.run(progress), time.perf_counter() - begun)


class Loop:
    """One run: integrator, statistics, events and counters."""

    def __init__(
        self, start: Start, scenario: Scenario, sink: Sink | None, channels: Sequence[int] = ()
    ) -> None:
        self.start, self.scenario, self.sink = start, scenario, sink
        self.channels = np.array(channels, np.int64)
        self.more: dict[str, Any] = {}  # arguments of a loop that selects the channels
        self.system = start.system
        self.t0 = start.state.t
        self.t_end = self.t0 + float(scenario.duration or 0.0)
        self.window = self.t0 + scenario.statistics_start
        self.sums = new_statistics(self.system.sizes["no"], new_counts(self.system))
        self.events: list[NDArray[np.float64]] = []
        self.watch = EventWatch(self.system, scenario)
        self.adaptive = scenario.method in ERROR_METHODS
        self.dense = self.adaptive or scenario.method in STIFF_METHODS  # samples are interpolated in steps
        self.h, self.every = choose_step(start, scenario)
        self.steps, self.diverged = 0, ""
        self.sampler: Sampler | None = None
        if self.system.controllers:
            from pitchpoint.solvers.sampled_control import Sampler  # imported on demand

            self.sampler = Sampler(self.system, start.state)
        try:
            self.run_: Any = self._begun(scenario)
        except BaseException:  # an interrupt too
            self.close()
            raise

    def _begun(self, scenario: Scenario) -> Any:
        """Start the method."""
        if self.sampler is not None and not self.dense:
            self.h, self.every = self.sampler.common_step(self.h, scenario.sample_rate)
        if scenario.method in STIFF_METHODS:
            return self._stiff()
        if scenario.method == "kinematics":
            from pitchpoint.solvers.kinematics import KinematicRun

            return KinematicRun(self.system, self.start.state, self.h)
        if not self.adaptive:
            self.more = {"picked": self.channels} if scenario.method in EXPLICIT_METHODS else {}
            run, self.h, self.every = start_run(self.system, self.start.state, scenario, self.h, self.every)
            return run
        from pitchpoint.solvers.explicit import runge_kutta  # imported on demand

        rtol = scenario.tolerance  # absolute tolerances scale with it, or they would limit the accuracy
        most = largest_step(self.start, scenario)
        run = runge_kutta.start_adaptive(
            self.system, self.start.state, rtol=rtol, atol=1e-4 * rtol, atol_rate=rtol, largest_step=most
        )
        run.watch(self.watch.ends)
        return run

    def _stiff(self) -> Any:
        """Start a run of a BDF method."""
        from pitchpoint.solvers.multistep import bdf

        chosen = self.scenario
        run = bdf.start(
            self.system,
            self.start.state,
            chosen.method,
            form=chosen.chosen_form,
            rtol=chosen.tolerance if self.adaptive else None,
            order=chosen.order,
            largest_step=largest_stiff_step(self.start, chosen) if self.adaptive else self.h,
        )
        if self.watch:
            run.watch(self.watch.functions)
        return run

    def begin(self) -> None:
        """Pass the channels of the start to the sink."""
        if self.sink is not None:
            row = evaluate.observe(self.system, evaluate.store(self.system, self.t0))
            self.sink.append(np.array([self.t0]), self._picked(row[None, :]))

    def run(self, progress: Progress) -> int:
        """Advance to the end of the scenario; returns the status."""
        try:
            self.begin()
            ready = OK if self.sampler is None else self.sampler.status
            return ready if ready != OK else self._dense(progress) if self.dense else self._fixed(progress)
        except KeyboardInterrupt:
            return INTERRUPTED
        finally:
            self.close()

    def close(self) -> None:
        """End the controllers."""
        if self.sampler is not None:
            self.sampler.close()

    def _fixed(self, progress: Progress) -> int:
        total, rest = whole_steps(self.t_end - self.t0, self.h)
        settled, part = whole_steps(self.window - self.t0, self.h)
        settle = min(total, settled + (part > 0.0))
        n = 1000
        while self.run_.steps < total:
            begun = time.perf_counter()
            take = min(n, (settle if self.run_.steps < settle else total) - self.run_.steps)
            if self.sampler is not None:
                take = min(take, self.sampler.steps(self.run_.t, self.h))
            sums = None if self.run_.steps < settle else self.sums.copy()
            every = self.every if self.sink is not None else 0
            status = self._advance(take, sums, every=every, **self.more)
            if status != OK:
                return status
            progress(self.run_.t - self.t0, self.t_end - self.t0, f"{self.steps} steps")
            n = min(next_chunk(n, time.perf_counter() - begun, getattr(self.run_, "count", 1)), total)
        return self._last_step(rest) if rest > 0.0 else OK

    def _last_step(self, h: float) -> int:
        """Take the shorter last step up to the duration; it is not a sample."""
        self.run_.change_step(h)
        return self._advance(1, self.sums.copy() if self.window < self.t_end else None)

    def _advance(self, n: int, sums: Accumulators | None, **more: Any) -> int:
        """Take n fixed steps and store their results."""
        stride = self.every if self.scenario.statistics == "samples" else 1
        more |= {"statistics": sums, "stride": stride, "events": self.watch.room}
        return self.take(self.run_.advance(n, **more), sums)

    def _dense(self, progress: Progress) -> int:
        sample = 1.0 / self.scenario.sample_rate if self.scenario.sample_rate else self.h
        most = max(1, int(MAX_SAMPLES * sample / self.run_.longest))
        n = min(1000, most)
        while self.run_.t < self.t_end - 1e-12 * max(1.0, abs(self.t_end)):
            begun = time.perf_counter()
            limit = self.window if self.run_.t < self.window - 1e-15 else self.t_end
            if self.sampler is not None:
                limit = min(limit, self.sampler.next())
            sums = self.sums.copy() if self.run_.t >= self.window - 1e-15 else None
            chunk = self.run_.advance_to(
                limit,
                sample=sample,
                statistics=sums,
                events=self.watch.room,
                restart=bool(self.watch),
                most=n,
            )
            status = self.take(chunk, sums)
            if status != OK:
                return status
            progress(self.run_.t - self.t0, self.t_end - self.t0, f"{self.steps} steps")
            n = min(next_chunk(n, time.perf_counter() - begun), most)
        return OK

    def take(self, chunk: Chunk, sums: Accumulators | None) -> int:
        """Store the results of a chunk and call the controllers that are due; returns the status.

        Statistics of a chunk in which the solution diverged are discarded.
        """
        self.steps += chunk.steps
        if chunk.status in (OK, NOT_FINITE, INCONSISTENT) and fastest(self.system)[2]:
            chunk = replace(chunk, status=UNBOUNDED)
        if chunk.status == UNBOUNDED:
            taken = self.channels if self.more else np.zeros(0, np.int64)
            self.diverged = sentence_of(self.system, chunk, self.run_.t, taken)
        elif sums is not None:
            self.sums = sums
        if self.sink is not None and len(chunk.rows):
            values = chunk.rows[:, 1:]
            self.sink.append(chunk.rows[:, 0].copy(), values if self.more else self._picked(values))
        if len(chunk.events):
            self.events.append(self.watch.pick(chunk.events))
        if chunk.status == OK and self.sampler is not None:
            return self.sampler.follow(self.run_)
        return int(chunk.status)

    def _divisions(self) -> tuple[Message, ...]:
        """Note on divided steps."""
        n = int(self.system.workspace.clock[REJECTED]) if isinstance(self.run_, generalized_alpha.Run) else 0
        return (note(f"{n} of {self.steps} steps were divided where Newton's method failed"),) * (n > 0)

    def sentence(self, status: int) -> str:
        """Sentence on how the run ended: what diverged and when, why, or whether a smaller step may help."""
        if self.sampler is not None and self.sampler.failure:
            return self.sampler.failure
        said = explain(self.system, status) + (f": {self.diverged}" if self.diverged else "")
        ran = runaway(self.start, self.scenario, self.run_.state()) if status in FAILURES else ""
        return said + (ran or remedy(self.start, self.scenario, status, self.h))

    def _picked(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Columns of the requested channels."""
        return values[:, self.channels] if len(self.channels) else values

    def summary(self, status: int, wall_s: float) -> TimeSummary:
        """Summary of the run: status, times, statistics by channel, events, remarks."""
        found = read_statistics(self.sums)
        rattle = read_counts(self.system, self.sums.counts)
        channels = channel_statistics(self.system, found, rattle)
        t, state = float(self.run_.t), self.run_.state()
        windows = window_notes(self.system.model, channels, max(t - self.window, 0.0))
        remarks = (*run_remarks(self.system, channels), *windows)
        if status == OK:
            remarks = (*remarks, *drift_notes(self.start, self.scenario, channels, state, t - self.t0))
            remarks = (*remarks, *step_notes(self.start, self.scenario, self.h, state))
        if status == OK and found.count == 0:  # dense-output methods feed the statistics at samples
            remarks = (note("the window of the statistics contains no sample", remedy="raise sample_rate"),)
        remarks = (*remarks, *self._divisions(), *(self.sampler.notes if self.sampler is not None else ()))
        return TimeSummary(
            status=status,
            sentence=self.sentence(status),
            steps=self.steps,
            step=0.0 if self.adaptive else self.h,
            wall_s=wall_s,
            t_end=t,
            window=(min(self.window, t), t),
            channels=channels,
            events=np.concatenate(self.events) if self.events else np.zeros((0, 3)),
            event_names=tuple(e.name for e in self.system.layout.events),
            notes=(*self.start.notes, *row_notes(self.system), *remarks),
            state=state,
            contact_solver=contact_counters(self.system),
        )


def solve_time(
    system: System,
    scenario: Scenario | None = None,
    *,
    progress: Progress = silent,
    on_failure: str = "raise",
) -> xr.Dataset:
    """Time response as a dataset over `time`; for long runs write a file with `pitchpoint run`.

    Parameters
    ----------
    system
        Compiled with the scenario (`compile_model(model, scenario)`).
    scenario
        Scenario to run; default the one of the system.
    progress
        Called with the time reached after every chunk.
    on_failure
        "raise" raises a SolverError with the partial dataset; "keep" returns the partial dataset with the
        status in its attributes.

    Returns
    -------
    xarray.Dataset
        The channels of the scenario (default all) over time [s], with units and `statistics` over all steps
        (mean, rms of the alternating part, min, max), contact states also with the numbers of
        `analysis.rattle.Rattle`; provenance, steps and status in the attributes. With events in the scenario
        also `event_time` [s], `event_name` and `event_direction` over `event`.

    Raises
    ------
    SolverError
        If the run cannot start, or fails and `on_failure` is "raise".
    """
    from pitchpoint.solvers.dataset import attributes, channel_dataset

    chosen = scenario_of(system, scenario)
    memory, stored = Memory(), chosen_channels(system, chosen.channels)
    done = run_time(system, chosen, sink=memory, progress=progress, channels=stored)
    settled = chosen.statistics_start
    attrs = attributes(system, chosen.method, done.status, done.wall_s, step=done.step, settle_time=settled)
    attrs |= {"steps": done.steps, "contact_solver": json.dumps(done.contact_solver)}
    attrs["notes"] = join_notes((*done.notes, *sample_notes(system, chosen, done, chosen.sample_rate)))
    times = np.concatenate(memory.times)
    data = channel_dataset(system, "time", times, np.concatenate(memory.rows), attrs, stored)
    data["time"].attrs = {"units": "s", "long_name": "time"}
    for name, numbers in ((n, x) for n, x in done.channels.items() if n in data):
        data[name].attrs["statistics"] = [numbers[key] for key in ("mean", "rms", "min", "max")]
        data[name].attrs |= {key: numbers[key] for key in CONTACT_NUMBERS if key in numbers}
    if chosen.events:
        when, index, direction = done.events.T
        data = data.assign(event_variables(when, index, direction, done.event_names))
    if done.status != OK and on_failure == "raise":
        raise SolverError(done.sentence, done.status, data)
    return data
