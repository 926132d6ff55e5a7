# SPDX-License-Identifier: Apache-2.0
"""Cases of a data set: simulation, anti-aliasing filter, decimation and noise; reproducible to the bit.

Each case is a separate model. Cases differ only in numerical values and share the compiled code, so creating
a model and its system takes some hundredths of a second.
"""

from __future__ import annotations

import dataclasses
import math
import threading
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.decimation import DAMPING, PASS, REACH, STOP, decimated
from pitchpoint.analysis.noise import white_noise, with_white_noise
from pitchpoint.analysis.pulses import pulse_times, tacho_levels
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.core.errors import PitchpointError, SolverError, with_time
from pitchpoint.core.nomenclature import can_be_filtered
from pitchpoint.core.provenance import content_hash, package_version
from pitchpoint.core.status import OK, REFUSED
from pitchpoint.io.contact_numbers import RATTLE
from pitchpoint.model.dataset_plan import DatasetPlan, ObservedChannel, PlannedCase
from pitchpoint.model.numbers import number_at
from pitchpoint.sweep.case_files import file_hashes
from pitchpoint.sweep.cases import how_it_failed
from pitchpoint.sweep.threads import on_all_cores

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

CONSTANT = 1e-9
"""Relative alternating part below which a channel is constant and a signal-to-noise ratio undefined."""


@dataclass(frozen=True)
class RecordedChannel:
    """One channel of a case: samples, SI unit, long name, rms of the added noise (0 = none)."""

    values: NDArray[Any]
    unit: str
    long_name: str
    noise_rms: float = 0.0


@dataclass(frozen=True)
class CaseRecord:
    """Result of one case.

    Parameters
    ----------
    case
        The planned case.
    key
        Hash of its inputs.
    status, sentence
        Final status (`pitchpoint.core.status`) and its message.
    numbers
        SI value and unit at each varied path, including jitter, and of the contact numbers of each mesh whose
        contact state is recorded.
    channels
        Samples by channel name; empty if the case failed.
    pulses
        Pulse times of each tacho [s].
    steps
        Number of time steps.
    notes
        Notes on the result.
    """

    case: PlannedCase
    key: str
    status: int
    sentence: str
    numbers: Mapping[str, tuple[float, str]] = field(default_factory=dict)
    channels: Mapping[str, RecordedChannel] = field(default_factory=dict)
    pulses: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    steps: int = 0
    notes: tuple[str, ...] = ()


def key_maker(plan: DatasetPlan, model: Model) -> Callable[[PlannedCase], str]:
    """Function that returns the hash of all inputs of a case.

    Inputs are the content of the model, the recording options of the plan, values and seed of the case, the
    contents of files referenced by the values, and the package version, but not the position in the plan or
    the names of factors.
    """
    common = {
        "model": content_hash(model),
        "version": package_version(),
        "scenario": plan.scenario,
        "recording": [plan.sample_rate, plan.length, plan.settle_time, plan.oversampling],
        "channels": dict(plan.channels),
        "jitter": dict(plan.jitter),
    }
    base = content_hash(common)
    folder = Path(model.file).parent if model.file else Path()

    def key_of(case: PlannedCase) -> str:
        """Hash the inputs of one case."""
        changes = dict(case.changes)
        inputs = {"base": base, "changes": changes, "seed": case.seed, "files": file_hashes(changes, folder)}
        return content_hash(inputs)

    return key_of


def lead(plan: DatasetPlan) -> int:
    """Number of samples before the first recorded one: settling time, at least the reach of the filter."""
    return max(math.ceil(plan.settle_time * plan.sample_rate - 1e-9), reach(plan))


def reach(plan: DatasetPlan) -> int:
    """Half length of the anti-aliasing filter in samples."""
    return REACH if plan.oversampling > 1 else 0


def contact_states(plan: DatasetPlan) -> list[str]:
    """Recorded contact states, whose meshes have contact numbers in the table."""
    names = dict.fromkeys(c.channel for c in plan.channels.values() if isinstance(c, ObservedChannel))
    return [name for name in names if name.startswith("contact_state[")]


def treatment(plan: DatasetPlan) -> str:
    """Description of sampling, filtering and decimation."""
    if plan.oversampling == 1:
        return (
            f"sampled at {plan.sample_rate:g} Hz without anti-aliasing filter: "
            "content above half the sampling rate is aliased"
        )
    bare = [
        name
        for name, c in plan.channels.items()
        if isinstance(c, ObservedChannel) and not can_be_filtered(c.channel)
    ]
    return (
        f"sampled at {plan.oversampling * plan.sample_rate:g} Hz, zero-delay linear-phase low-pass filter "
        f"(pass band to {PASS * plan.sample_rate:g} Hz, {DAMPING:g} dB attenuation from "
        f"{STOP * plan.sample_rate:g} Hz), decimated by {plan.oversampling}"
        + (f"; states and phases are not filtered: {', '.join(bare)}" if bare else "")
    )


def compute_case(
    plan: DatasetPlan, model: Model, case: PlannedCase, key: str, stop: threading.Event | None = None
) -> CaseRecord:
    """Compute one case; errors are returned as its status and message.

    Parameters
    ----------
    plan, model
        A checked plan and its model.
    case, key
        The case and the hash of its inputs.
    stop
        Event that another thread sets to stop the case.
    """

    def listen(done: float, total: float, note: str = "") -> None:
        """Stop the case if the data set is stopped."""
        if stop is not None and stop.is_set():
            raise KeyboardInterrupt

    numbers: dict[str, tuple[float, str]] = {}
    try:
        changed = varied_model(plan, model, case)
        paths = (*plan.paths, *plan.jitter)
        numbers |= {path: n for path in paths if (n := number_at(changed, path)) is not None}
        return _compute(plan, changed, case, key, numbers, listen)
    except (Exception, KeyboardInterrupt) as error:  # noqa: BLE001 - one bad case must not take the others with it
        status, words = how_it_failed(error)
        return CaseRecord(case, key, status, words, numbers)


def varied_model(plan: DatasetPlan, model: Model, case: PlannedCase) -> Model:
    """Model of a case: its values, then the random jitter of its seed applied to them."""
    changed = model.replace_all(case.changes, allow_code=plan.allow_code) if case.changes else model
    shaken = {}
    combination = content_hash(dict(case.changes))
    for path, share in plan.jitter.items():
        number = number_at(changed, path)
        if number is None:
            raise SolverError(f"jitter: {path} is not a number in this case", REFUSED)
        [normal] = white_noise(1, deviation=1.0, seed=_seeds(case.seed, path, combination))
        shaken[path] = number[0] * (1.0 + share * float(normal))
    return changed.replace_all(shaken) if shaken else changed


def _seeds(*seeds: int | str) -> list[int]:
    """Seeds as integers; strings are replaced by their checksums."""
    return [s if isinstance(s, int) else zlib.crc32(s.encode()) for s in seeds]


class _Tail:
    """Sink that stores all samples from index `first`."""

    def __init__(self, columns: int, first: int) -> None:
        self.columns, self.first, self.seen = columns, first, 0
        self.parts: list[NDArray[np.float64]] = []

    def append(self, t: NDArray[np.float64], values: NDArray[np.float64]) -> None:
        """Append a block of samples."""
        skip = max(0, self.first - self.seen)
        self.seen += len(t)
        if skip < len(t):
            self.parts.append(values[skip:])

    def rows(self) -> NDArray[np.float64]:
        """Stored samples, shape (samples, columns)."""
        return np.concatenate(self.parts) if self.parts else np.zeros((0, self.columns))


def _compute(
    plan: DatasetPlan,
    model: Model,
    case: PlannedCase,
    key: str,
    numbers: dict[str, tuple[float, str]],
    listen: Any,
) -> CaseRecord:
    """Run the model of a case and create its channels."""
    from pitchpoint.solvers.time import run_time
    from pitchpoint.system.compile import compile_model

    rate, times = plan.sample_rate, plan.oversampling
    before, margin = lead(plan), reach(plan)
    duration = (before + plan.samples - 1 + margin) / rate
    scenario = dataclasses.replace(
        model.scenarios[str(plan.scenario)],
        duration=duration,
        sample_rate=times * rate,
        # statistics are needed for recorded contact states only
        settle_time=before / rate if contact_states(plan) else duration,
    )
    system = compile_model(model, scenario)
    known = [c.name for c in system.layout.channels]
    names = {
        name: c.channel if isinstance(c, ObservedChannel) else f"angle[{c.body}]"
        for name, c in plan.channels.items()
    }
    missing = [c for c in names.values() if c not in known]
    if missing:
        raise SolverError(f"nothing observes {', '.join(missing)} in this case", REFUSED)
    first = (before - margin) * times
    asked = [known.index(c) for c in names.values()]
    sink = _Tail(len(asked), first)
    done = run_time(system, scenario, sink=sink, progress=listen, channels=asked)
    if done.status != OK:
        words = with_time(done.sentence, done.t_end)
        return CaseRecord(case, key, done.status, words, numbers, steps=done.steps)
    rows = sink.rows()
    if not np.all(np.isfinite(rows)):
        raise SignalError("the computed channels are not finite; use a smaller time step")
    t = (first + np.arange(len(rows))) / (times * rate) - before / rate
    recorded = dict(zip(names, rows.T, strict=True))
    channels: dict[str, RecordedChannel] = {}
    pulses: dict[str, NDArray[np.float64]] = {}
    kept = slice(margin * times, margin * times + (plan.samples - 1) * times + 1, times)
    for name, channel in plan.channels.items():
        if isinstance(channel, ObservedChannel):
            found = system.layout.channels[known.index(channel.channel)]
            filtered = times > 1 and can_be_filtered(channel.channel)
            clean = decimated(recorded[name], times) if filtered else recorded[name][kept]
            values, noise = _noisy(name, channel, clean, case.seed, key)
            channels[name] = RecordedChannel(values, found.unit, found.long_name or name, noise)
        else:
            levels = tacho_levels(recorded[name], channel.pulses)[kept]
            words = f"tacho of {channel.body}, {channel.pulses} pulses per turn"
            channels[name] = RecordedChannel(levels, "1", words)
            begun = pulse_times(t, recorded[name], channel.pulses)
            pulses[name] = begun[(begun >= 0.0) & (begun <= (plan.samples - 1) / rate)]
    for state in contact_states(plan):
        mesh = state.removeprefix("contact_state")
        for name, unit, _ in RATTLE:
            numbers[f"{name}{mesh}"] = (float(done.channels[state][name]), unit)
    notes = tuple(n for n in done.notes if "window of the statistics" not in n)
    return CaseRecord(case, key, OK, "finished", numbers, channels, pulses, done.steps, notes)


def _noisy(
    name: str, channel: ObservedChannel, clean: NDArray[np.float64], seed: int, key: str
) -> tuple[NDArray[np.float64], float]:
    """Channel with added noise, and the standard deviation of the noise (0 = none)."""
    if channel.noise is None:
        return clean, 0.0
    seeds = _seeds(seed, key, name)
    if channel.noise.rms is not None:
        rms = channel.noise.rms
        return clean + white_noise(clean.size, deviation=rms, seed=seeds), rms
    if float(clean.std()) <= CONSTANT * float(np.abs(clean).max()):
        raise SignalError(f"channels.{name}: is constant, so snr is undefined; give the rms of the noise")
    noisy = with_white_noise(clean, signal_to_noise=float(channel.noise.snr or 0.0), seed=seeds)
    return noisy.values, noisy.noise_deviation


def compute_cases(
    plan: DatasetPlan,
    model: Model,
    cases: Sequence[tuple[PlannedCase, str]],
    take: Callable[[CaseRecord], None],
    *,
    keep: Callable[[CaseRecord], None],
    jobs: int | None = None,
) -> bool:
    """Compute cases on all cores; returns False if interrupted by Ctrl-C.

    Parameters
    ----------
    plan, model
        A checked plan and its model.
    cases
        Cases with the hashes of their inputs.
    take
        Called with each case, without its samples, in the calling thread.
    keep
        Stores a case; called in the thread that computed it.
    jobs
        Number of threads; default one per core.

    Raises
    ------
    PitchpointError
        If a case could not be stored; cases in progress are abandoned.
    """

    def work(
        piece: tuple[PlannedCase, str], stop: threading.Event
    ) -> tuple[CaseRecord, PitchpointError | None]:
        """Compute and store one case; returns its record without samples."""
        record, lost = compute_case(plan, model, *piece, stop), None
        try:
            keep(record)
        except Exception as error:  # noqa: BLE001 - reported for this case; the other cases are not affected
            status, words = how_it_failed(error)
            record = dataclasses.replace(record, status=status, sentence=words)
            lost = error if isinstance(error, PitchpointError) else None
        return dataclasses.replace(record, channels={}, pulses={}), lost

    def taken(result: tuple[CaseRecord, PitchpointError | None]) -> None:
        """Pass a record to `take`; stop if it could not be stored."""
        take(result[0])
        if result[1] is not None:  # disk full: further results would be lost
            raise result[1]

    return on_all_cores(work, cases, taken, jobs)
