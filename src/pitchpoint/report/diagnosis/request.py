# SPDX-License-Identifier: Apache-2.0
"""Options of `pitchpoint diagnose`: file, machine, speed and channels, read and checked."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.line_tests import LONG
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.shaft_tests import SLIP
from pitchpoint.core.nearest import hint
from pitchpoint.report.diagnosis.channels import Places, every_quantity, given_places, preferred
from pitchpoint.report.diagnosis.machine import Machine, machine_of
from pitchpoint.report.diagnosis.origin import origin
from pitchpoint.report.diagnosis.over_angle import OverAngle, over_angle
from pitchpoint.report.diagnosis.record import Record
from pitchpoint.report.diagnosis.severity import machine_group, severities
from pitchpoint.report.diagnosis.steady_speed import at_speed
from pitchpoint.report.diagnosis.study import Study, study, usable

Array = NDArray[np.float64]
SAME_SPEED = 0.02
"""Relative difference between the speed in a file and that of a shaft."""
SIMULATED = 20.0
"""Default signal-to-noise ratio of simulation results [dB]."""
LARGEST_SLIP = 0.1
"""Largest slip of rolling elements that is searched [-]."""


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
    shafts: Sequence[str] = ()
    false_alarm: float = 0.01
    allow_code: bool = False
    sample_rate: float | None = None
    noise: float | None = None
    slip: float | None = None
    more: Sequence[str] = ()
    """Further files, recorded together with the first one."""
    all_channels: bool = False
    sensors: Sequence[str] = ()
    """Parts next to channels."""
    units: Mapping[str, str] = field(default_factory=dict)
    machine_group: str = ""
    references: Sequence[str] = ()
    """Files, folders or patterns of healthy records."""
    load: str | None = None
    load_from: str | None = None
    """Load of the record, and a pattern for file names with the load."""


@dataclass(frozen=True)
class Prepared:
    """Channels of a file over the angle of the reference shaft, and the machine.

    Attributes
    ----------
    record
        Evaluated part of the file.
    machine
        The machine and what is known of its speed.
    places
        Where the channels are.
    over
        Channels over the angle.
    on_housing
        Channels over time whose vibration severity is rated.
    noise, remarks
        Sentences about added noise, and about omitted channels.
    """

    record: Record
    machine: Machine
    places: Places
    over: OverAngle
    on_housing: dict[str, Array]
    noise: list[str]
    remarks: list[str]

    @property
    def units(self) -> dict[str, str]:
        """Units of the channels; empty if unknown."""
        return {name: self.record.units.get(name, "") for name in self.over.signals}


def diagnose_file(request: Request) -> Study:
    """Read a file and its machine, and run the diagnosis.

    Raises
    ------
    PitchpointError
        If the file, the machine or an option cannot be used.
    """
    group = machine_group(request.machine_group) if request.machine_group else ""
    slip = slip_of(request)
    prepared = prepare(request)
    record, machine, over = prepared.record, prepared.machine, prepared.over
    other = _other_speed(record, machine)
    remarks = [f"channels: {', '.join(over.signals)}", *prepared.noise, *machine.remarks, *other]
    try:
        found = study(
            over,
            machine.parts,
            false_alarm=request.false_alarm,
            remarks=[*remarks, *prepared.remarks],
            units=prepared.units,
            slip=slip,
            sensors=prepared.places,
        )
    except SignalError as error:
        source = [f"speed from the {machine.speed_source}"] * bool(machine.speed_source)
        raise SignalError("; ".join([str(error), *other, *source])) from error
    slowest = over.frequency * min(float(shaft.order) for shaft in machine.parts.shafts)
    rated = severities(prepared.on_housing, np.asarray(record.time), prepared.units, slowest, group)
    found = found.with_severity(*rated)
    return replace(
        found,
        file=request.file + (f" and {len(request.more)} more" if request.more else ""),
        origin=origin(request, record, machine, found, prepared.noise),
    )


def slip_of(request: Request) -> float:
    """Maximum slip of rolling elements [-].

    Raises
    ------
    SignalError
        If it is out of range.
    """
    slip = SLIP if request.slip is None else request.slip
    if not 0.0 <= slip <= LARGEST_SLIP:
        raise SignalError(
            f"--slip: {slip:g} (limit 0 to {LARGEST_SLIP:g}); rolling elements slip by 0.01 to 0.02"
        )
    return slip


def prepare(request: Request) -> Prepared:
    """Read a file and its machine, and resample its channels over the angle of the reference shaft.

    Raises
    ------
    PitchpointError
        If the file, the machine or an option cannot be used.
    """
    from pitchpoint.report.diagnosis.record import read_record

    channels = [*request.channels, *(t.partition("@")[0] for t in (request.tacho, request.angle) if t)]
    record = read_record(
        (request.file, *request.more),
        request.sample_rate,
        channels if request.channels else None,
        request.units,
    )
    if record.model_text and request.units:
        raise SignalError(
            f"{request.file}: --unit {next(iter(request.units))}: results have units; omit the option"
        )
    machine = machine_of(request, record)
    places = Places(machine.parts, machine.names, meshes_at=machine.meshes_at)
    places = replace(places, given=given_places(request.sensors, record.channels, places))
    chosen = _chosen(request, record, places)
    _complete(request, record, chosen)
    units = record.units if record.model_text else None
    start = np.asarray(record.time[:LONG])
    signals, remarks = usable(chosen) if request.channels else usable(chosen, start, units)
    if not signals:
        raise SignalError(f"{request.file}: no channel can be used: " + "; ".join(remarks or ["it has none"]))
    settled = record.time[0] + record.settle_time if record.settle_time else None
    part = slice(None if settled is None else int(np.searchsorted(record.time, settled)), None)
    record = replace(record, time=record.time[part], channels=_Part(record.channels, part))
    signals = {name: values[part] for name, values in signals.items()}
    on_housing = _on_housing(record, signals)
    signals, noise = _noisy(request, record, signals)
    over = _over_angle(request, record, machine, signals)
    remarks += places.remark(signals, bool(record.model_text) and not request.all_channels)
    return Prepared(record, machine, places, over, on_housing, noise, remarks)


def _other_speed(record: Record, machine: Machine) -> list[str]:
    """Remark on a speed in the file that is the speed of no shaft."""
    if record.speed is None or machine.limits or math.isnan(machine.frequency):
        return []
    speeds = {shaft.name: machine.frequency * float(shaft.order) for shaft in machine.parts.shafts}
    stated = record.speed
    nearest = min(speeds, key=lambda name: abs(stated - speeds[name]))
    apart = stated / speeds[nearest] - 1.0
    if abs(apart) <= SAME_SPEED:
        return []
    return [
        f"speed: the file states {60.0 * stated:.6g} rpm ({record.speed_source}), the speed of no shaft; by "
        f"--speed {nearest} rotates at {60.0 * speeds[nearest]:.6g} rpm, {100.0 * abs(apart):.2g} % "
        f"{'slower' if apart > 0.0 else 'faster'}; --speed is used, omit it if the file is right"
    ]


def _on_housing(record: Record, signals: dict[str, Array]) -> dict[str, Array]:
    """Channels of which the severity is rated: measured ones, and sensors of simulations."""
    return {name: x for name, x in signals.items() if not record.model_text or name.startswith("signal[")}


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


def _chosen(request: Request, record: Record, places: Places) -> dict[str, Array]:
    """Channels to diagnose."""
    used = {text.partition("@")[0] for text in (request.tacho, request.angle) if text}
    for name in [*request.channels, *used]:
        if name not in record.channels:
            raise SignalError(f"{request.file}: no channel {name!r}; {hint(name, record.channels, 3)}")
    names = list(request.channels)
    if not names:
        kept = [name for name in record.channels if name not in used]
        choose = every_quantity(kept) if request.all_channels else preferred(kept, places)
        names = choose if record.model_text else kept
    if not names:
        listed = ", ".join(list(record.channels)[:12])
        raise SignalError(f"{request.file}: no channel to diagnose; choose with -c; there are: {listed}")
    return {name: record.channels[name] for name in names}


def _over_angle(request: Request, record: Record, machine: Machine, signals: dict[str, Array]) -> OverAngle:
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
    elif machine.limits is not None:
        from pitchpoint.report.diagnosis.varying_speed import at_varying_speed

        over = at_varying_speed(cut, np.asarray(time), machine.parts, machine.limits, machine.reference)
        source = ", ".join(f"--speed {text}" for text in request.speeds) + ", found in the record"
        return replace(over, source=source, began=_began(record, 0))
    elif math.isnan(machine.frequency):
        raise SignalError(
            f"{request.file}: the speed is not known; give --speed, such as --speed 30Hz, --tacho CHANNEL "
            "with --pulses N, or --angle CHANNEL"
        )
    else:
        given = ", ".join(f"--speed {text}" for text in request.speeds)
        source = given or machine.speed_source or "scenario of the model"
        over = at_speed(cut, sample_rate_of(time), machine.parts, machine.frequency, machine.tolerance)
        nominal = f" ±{100.0 * machine.tolerance:.3g} %" if machine.tolerance else ""
        refined = nominal + (f", refined by the {over.lines} lines" if over.lines else "")
        taken = (f"speed of {machine.reference} from the {machine.speed_source}",) * bool(
            machine.speed_source
        )
        return replace(
            over, source=source + refined, began=_began(record, 0), remarks=(*taken, *over.remarks)
        )
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
    record: Record, machine: Machine, first: int, zero: str, angle: Array
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
