# SPDX-License-Identifier: Apache-2.0
"""Options of `pitchpoint diagnose`: file, machine, speed and channels, read and checked."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.turning_parts import TurningParts, train_parts
from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.nearest import hint
from pitchpoint.report.diagnosis.option_values import option_speed, with_bearings
from pitchpoint.report.diagnosis.origin import origin
from pitchpoint.report.diagnosis.record import OverAngle, Record, at_speed, over_angle
from pitchpoint.report.diagnosis.study import Study, preferred, study, usable

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]
SAME_SPEED = 0.02
"""Relative difference between the speed in a file and that of a shaft."""
SIMULATED = 20.0
"""Default signal-to-noise ratio of simulation results [dB]."""


@dataclass(frozen=True)
class Request:
    """Options of the command as given."""

    file: str
    model: str | None = None
    scenario: str | None = None
    train: str | None = None
    speeds: Sequence[str] = ()
    tacho: str | None = None
    pulses: int | None = None
    angle: str | None = None
    channels: Sequence[str] = ()
    bearings: Sequence[str] = ()
    false_alarm: float = 0.01
    allow_code: bool = False
    sample_rate: float | None = None
    noise: float | None = None
    more: Sequence[str] = ()
    """Further files, recorded together with the first one."""


@dataclass(frozen=True)
class _Machine:
    """Rotating parts, reference shaft, its rotation frequency if known [Hz], other names of shafts.

    `source` names the speed of the file, if it is used.
    """

    parts: TurningParts
    reference: str
    frequency: float
    names: dict[str, str]
    remarks: tuple[str, ...] = ()
    source: str = ""


def diagnose_file(request: Request) -> Study:
    """Read a file and its machine, and run the diagnosis.

    Raises
    ------
    PitchpointError
        If the file, the machine or an option cannot be used.
    """
    from pitchpoint.report.diagnosis.record import read_record

    channels = [*request.channels, *(t.partition("@")[0] for t in (request.tacho, request.angle) if t)]
    record = read_record(
        (request.file, *request.more), request.sample_rate, channels if request.channels else None
    )
    machine = _machine(request, record)
    chosen = _chosen(request, record)
    _complete(request, record, chosen)
    units = record.units if record.model_text else None
    signals, remarks = usable(chosen) if request.channels else usable(chosen, record.time, units)
    if not signals:
        raise SignalError(f"{request.file}: no channel can be used: " + "; ".join(remarks or ["it has none"]))
    part = slice(int(np.searchsorted(record.time, record.time[0] + record.settle_time)), None)
    record = replace(record, time=record.time[part], channels=_Part(record.channels, part))
    signals = {name: values[part] for name, values in signals.items()}
    signals, noise = _noisy(request, record, signals)
    over = _over_angle(request, record, machine, signals)
    other = _other_speed(record, machine)
    remarks = [f"channels: {', '.join(signals)}", *noise, *machine.remarks, *other, *remarks]
    try:
        found = study(over, machine.parts, false_alarm=request.false_alarm, remarks=remarks)
    except SignalError as error:
        source = [f"speed from the {machine.source}"] * bool(machine.source)
        raise SignalError("; ".join([str(error), *other, *source])) from error
    return replace(
        found,
        file=request.file + (f" and {len(request.more)} more" if request.more else ""),
        origin=origin(request, record, found, noise),
        units={name: record.units.get(name, "") for name in signals},
    )


def _complete(request: Request, record: Record, chosen: Mapping[str, Array]) -> None:
    """Reject a file that grows while it is read: its run has not ended."""
    for name, values in chosen.items():
        if values.size != record.time.size:
            raise SignalError(
                f"{request.file}: {name} has {values.size} samples for {record.time.size} times (limit: "
                "equal numbers); if the run has not ended, wait for it"
            )


class _Part(Mapping[str, Array]):
    """Evaluated part of the channels."""

    def __init__(self, channels: Mapping[str, Array], part: slice) -> None:
        self._channels, self._part = channels, part

    def __getitem__(self, name: str) -> Array:
        return self._channels[name][self._part]

    def __iter__(self) -> Iterator[str]:
        return iter(self._channels)

    def __len__(self) -> int:
        return len(self._channels)


def _noisy(request: Request, record: Record, signals: dict[str, Array]) -> tuple[dict[str, Array], list[str]]:
    """Add sensor noise to simulations: without it, meshes that modulate each other look like a fault."""
    from pitchpoint.analysis.noise import with_white_noise

    level = request.noise
    if level is None and not record.model_text:
        return signals, []
    chosen = SIMULATED if level is None else level
    found = {
        name: with_white_noise(x, signal_to_noise=chosen, seed=[len(signals), k]).values
        for k, (name, x) in enumerate(signals.items())
    }
    return found, [f"white noise {chosen:g} dB below the signal was added to each channel (--noise)"]


def _machine(request: Request, record: Record) -> _Machine:
    """Rotating parts from tooth counts or a model."""
    if request.train is not None:
        return _of_train(request, record)
    model = _model(request, record)
    if model is None:
        raise SignalError(
            f"{request.file}: does not describe the machine; give --train with the tooth counts, such as "
            "--train 32/96-48/80, or --model MODEL.yaml"
        )
    return _of_model(request, record, model)


def _of_train(request: Request, record: Record) -> _Machine:
    stages = []
    for text in str(request.train).split("-"):
        found = re.fullmatch(r"\s*(\d+)\s*/\s*(\d+)\s*", text)
        if not found:
            raise SignalError(
                f"--train: {text!r} is not a pair of tooth counts; write them as in 32/96-48/80"
            )
        stages.append((int(found[1]), int(found[2])))
    parts = train_parts(stages)
    names = {str(k + 1): shaft.name for k, shaft in enumerate(parts.shafts)}
    names |= {shaft.name: shaft.name for shaft in parts.shafts}
    where = request.tacho or request.angle or ""
    reference = _shaft_of(where, names) or parts.shafts[0].name
    speeds = [option_speed(text) for text in request.speeds]
    source = ""
    if not speeds and not where and record.speed is not None:
        speeds, source = [("", record.speed)], f"file, variable {record.speed_source}"
    frequency = math.nan
    for name, value in speeds:
        shaft = names.get(name or parts.shafts[0].name)
        if shaft is None:
            raise SignalError(f"--speed: no shaft {name!r}; there are: {', '.join(names)}")
        given = value / float(parts.shaft(shaft).order) * float(parts.shaft(reference).order)
        if not math.isnan(frequency) and abs(given / frequency - 1.0) > 1e-6:
            raise SignalError("--speed: the speeds do not fit the ratios of the teeth; give one of them")
        frequency = given
    parts = _counted_from(parts, reference)
    parts = with_bearings(parts, request.bearings, names)
    return _Machine(parts, reference, frequency, names, source=source)


def _stated(record: Record) -> str:
    """Speed of the file as the end of a sentence."""
    if record.speed is None:
        return ""
    return f"; the file states {60.0 * record.speed:.6g} rpm ({record.speed_source})"


def _other_speed(record: Record, machine: _Machine) -> list[str]:
    """Remark on a speed in the file that is the speed of no shaft."""
    if record.speed is None or math.isnan(machine.frequency):
        return []
    speeds = [machine.frequency * float(shaft.order) for shaft in machine.parts.shafts]
    if any(abs(record.speed - speed) <= SAME_SPEED * speed for speed in speeds):
        return []
    return [
        f"speed: {60.0 * record.speed:.6g} rpm in the file ({record.speed_source}) is the speed of no shaft; "
        "it is not used"
    ]


def _counted_from(parts: TurningParts, reference: str) -> TurningParts:
    """The same machine with another reference shaft."""
    base = parts.shaft(reference).order
    return replace(parts, shafts=tuple(replace(shaft, order=shaft.order / base) for shaft in parts.shafts))


def _model(request: Request, record: Record) -> Model | None:
    """The given model, else the model stored in the file."""
    from pitchpoint.io.yaml_model import load_model, loads_model

    if request.model is not None:
        return load_model(request.model, allow_code=request.allow_code)
    if not record.model_text:
        return None
    return loads_model(record.model_text, allow_code=request.allow_code, file=request.file)


def _of_model(request: Request, record: Record, model: Model) -> _Machine:
    """Rotating parts of a model; speeds from options or a scenario, arbitrary with an angle channel."""
    from pitchpoint.report.frequencies import turning_speeds
    from pitchpoint.report.machine_parts import parts_of

    where = request.tacho or request.angle or ""
    angles = (
        [] if where or request.speeds else [n for n in record.channels if _owner(n, "angle") in model.bodies]
    )
    bodies = {body: body for body in model.bodies}
    spins, remarks = _spins(request, record, model)
    if not any(spins.values()):
        measured = _shaft_of(where, bodies) or next((_owner(name, "angle") for name in angles), "")
        if not measured:
            raise SignalError(
                f"{request.file}: the speed is not known; give --speed BODY=QUANTITY, such as --speed "
                f"{next(iter(model.bodies), 'motor')}=1500rpm, or a tacho{_stated(record)}"
            )
        spins = turning_speeds(model, {measured: 1.0})
    known = {name: abs(spins.get(name, 0.0)) for name in model.bodies}
    seen = [_owner(name, "angle") for name in angles if known[_owner(name, "angle")]]
    reference = _shaft_of(where, bodies) or max(seen or known, key=lambda body: known[body])
    if where and not _shaft_of(where, bodies):
        turning = ", ".join(body for body, speed in known.items() if speed)
        raise SignalError(f"{where}: give its shaft, as in {where}@BODY; there are: {turning}")
    parts, names, more = parts_of(model, spins, reference)
    parts = with_bearings(parts, request.bearings, names)
    return _Machine(parts, reference, known[reference] / math.tau, names, (*remarks, *more))


def _spins(request: Request, record: Record, model: Model) -> tuple[dict[str, float], list[str]]:
    """Speeds of all bodies [rad/s] from options or a scenario; empty if neither gives any."""
    from pitchpoint.report.frequencies import scenario_speeds, turning_speeds

    given = {}
    for text in request.speeds:
        name, value = option_speed(text)
        if not name:
            raise SignalError(f"--speed: {text!r} does not name a body; write BODY={text}")
        given[name] = value * math.tau
    if given:
        return turning_speeds(model, given), []
    scenario = request.scenario or record.scenario
    if not scenario and len(model.scenarios) == 1:
        scenario = next(iter(model.scenarios))
    if scenario and scenario not in model.scenarios:
        if request.scenario is None:
            return {}, []
        listed = ", ".join(model.scenarios) or "none"
        raise ModelError(
            [Message(f"scenarios.{scenario}", "is not in the model", remedy=f"there are: {listed}")]
        )
    if not scenario:
        return {}, []
    speeds, remarks = scenario_speeds(model, scenario)
    return turning_speeds(model, speeds, model.scenarios[scenario]), remarks


def _chosen(request: Request, record: Record) -> dict[str, Array]:
    """Channels to diagnose."""
    used = {text.partition("@")[0] for text in (request.tacho, request.angle) if text}
    for name in [*request.channels, *used]:
        if name not in record.channels:
            raise SignalError(f"{request.file}: no channel {name!r}; {hint(name, record.channels, 3)}")
    names = list(request.channels)
    if not names:
        kept = [name for name in record.channels if name not in used]
        names = preferred(kept) if record.model_text else kept
    if not names:
        listed = ", ".join(list(record.channels)[:12])
        raise SignalError(f"{request.file}: no channel to diagnose; choose with -c; there are: {listed}")
    return {name: record.channels[name] for name in names}


def _over_angle(request: Request, record: Record, machine: _Machine, signals: dict[str, Array]) -> OverAngle:
    """Channels over the angle of the reference shaft, from an angle, a tacho or a constant speed."""
    from pitchpoint.analysis.sampled import sample_rate_of
    from pitchpoint.analysis.tacho import angle_channel, tacho_angle

    time = record.time
    cut = signals
    own = f"angle[{machine.reference}]"
    if request.tacho is not None:
        name = request.tacho.partition("@")[0]
        source, zero = f"tacho {name}, {request.pulses} pulses per turn", f"the first pulse of {name}"
        shaft = tacho_angle(
            record.channels[name],
            time,
            pulses_per_revolution=int(request.pulses or 1),
        )
    elif request.angle is not None or (own in record.channels and not request.speeds):
        name = (request.angle or own).partition("@")[0]
        source, zero = f"angle channel {name}", f"the zero of {name}"
        shaft = angle_channel(record.channels[name], time)
    elif math.isnan(machine.frequency):
        raise SignalError(
            f"{request.file}: the speed is not known; give --speed, such as --speed 30Hz, --tacho CHANNEL "
            "with --pulses N, or --angle CHANNEL"
        )
    else:
        given = ", ".join(f"--speed {text}" for text in request.speeds)
        source = given or machine.source or "scenario of the model"
        over = at_speed(cut, sample_rate_of(time), machine.parts, machine.frequency)
        refined = ", refined by the mesh lines" if over.remarks else ""
        taken = (f"speed of the input from the {machine.source}",) if machine.source else ()
        remarks = (*taken, *over.remarks)
        return replace(over, source=source + refined, began=_began(record, 0), remarks=remarks)
    first, count = shaft.first_sample, shaft.angle.size
    cut = {name: values[first : first + count] for name, values in cut.items()}
    zeros = _zeros(record, machine, first, zero, shaft.angle)
    began = _began(record, first)
    return replace(over_angle(cut, shaft.time, shaft.angle), source=source, zeros=zeros, began=began)


def _began(record: Record, first: int) -> str:
    """First evaluated sample in words."""
    if first == 0 and not record.settle_time:
        return "the start of the record"
    return f"t = {float(record.time[first]):.6g} s"


def _zeros(
    record: Record, machine: _Machine, first: int, zero: str, angle: Array
) -> dict[str, tuple[float, str]]:
    """Angles of shafts at the first sample, if a channel gives them."""
    found = {}
    own = machine.names.get(machine.reference, machine.reference)
    for shaft in machine.parts.shafts:
        name = f"angle[{shaft.name}]"
        # shafts of equal speed are merged and have two angles
        if shaft.name == own and own == machine.reference:
            turned, words = angle, zero
        elif name in record.channels:
            turned, words = record.channels[name][first:], f"the zero of {name}"
        else:
            continue
        forward = 1.0 if turned[-1] >= turned[0] else -1.0
        found[shaft.name] = (forward * float(turned[0]), words)
    return found


def _shaft_of(where: str, names: dict[str, str]) -> str:
    """Shaft of CHANNEL@SHAFT, or the shaft in the name of an angle channel."""
    channel, at, shaft = where.partition("@")
    if at:
        if shaft not in names:
            raise SignalError(f"{where}: no shaft {shaft!r}; there are: {', '.join(names)}")
        return names[shaft]
    return names.get(_owner(channel, "angle"), "")


def _owner(channel: str, quantity: str) -> str:
    """Name of the body in `angle[body]`; empty for other channels."""
    found = re.fullmatch(rf"{quantity}\[([^\]]+)\]", channel)
    return found[1] if found else ""
