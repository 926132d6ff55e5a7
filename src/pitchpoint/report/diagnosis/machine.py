# SPDX-License-Identifier: Apache-2.0
"""Machine of a diagnosis: shafts, gears and bearings of the options, of a model, or of both."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import TYPE_CHECKING

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.turning_parts import Shaft, TurningParts, train_parts
from pitchpoint.core.errors import Message, ModelError
from pitchpoint.report.diagnosis.bearings import given_bearing
from pitchpoint.report.diagnosis.speeds import TOLERANCE, GivenSpeed, given_speed

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.report.diagnosis.record import Record
    from pitchpoint.report.diagnosis.request import Request

FINEST = 1_000_000
"""Largest denominator of the ratio of a belt."""
_SHAFT = re.compile(r"([^=@]+)=([^@]+)(?:@(.+))?")


@dataclass(frozen=True)
class Machine:
    """Rotating parts and what is known of their speed.

    Attributes
    ----------
    parts
        Rotating parts; orders refer to the reference shaft.
    reference
        Reference shaft or body.
    frequency
        Its rotation frequency [Hz], of a range the upper limit; NaN if unknown.
    tolerance
        Relative tolerance of the frequency [-].
    names
        Names of shafts by what the user may write.
    remarks
        Remarks on omitted parts.
    sources
        Source of the orders of each given bearing, in words.
    speed_source
        Number in the file that gives the speed, in words; empty if an option or the model gives it.
    limits
        Lowest and highest rotation frequency of the reference shaft [Hz], if a range is given.
    meshes_at
        Names of the meshes at each body of a model.
    """

    parts: TurningParts
    reference: str
    frequency: float
    tolerance: float
    names: dict[str, str]
    remarks: tuple[str, ...] = ()
    sources: tuple[str, ...] = ()
    speed_source: str = ""
    limits: tuple[float, float] | None = None
    meshes_at: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


SETTLED = 0.01
"""Relative deviation of the speed of a run from that of its scenario: free speeds settle under load."""


def machine_of(request: Request, record: Record) -> Machine:
    """Machine of the options and of the model that is given or stored in the file.

    Raises
    ------
    SignalError
        If an option cannot be read, or nothing describes what rotates.
    ModelError
        If the model has no such scenario or nothing that rotates.
    """
    model = None if request.train is not None else _model(request, record)
    if model is None and request.scenario is not None and request.train is None:
        raise SignalError(f"--scenario {request.scenario}: {request.file} contains no model; give --model")
    found = _of_model(request, record, model) if model is not None else _of_options(request, record)
    return _with_bearings(found, request)


def _of_options(request: Request, record: Record) -> Machine:
    """Machine of tooth numbers, belts and speeds; without tooth numbers it has one shaft, or those of
    belts."""
    given = _given_speeds(request)
    where, source = request.tacho or request.angle or "", ""
    if not given and not where and record.speed is not None:
        given, source = (
            [GivenSpeed("", record.speed, TOLERANCE, False)],
            f"file, variable {record.speed_source}",
        )
    if request.train is not None:
        parts = train_parts(stages(request.train))
    else:
        if not (request.bearings or request.shafts or request.speeds or where or record.fault_orders):
            raise SignalError(
                f"{request.file}: does not describe the machine; give --speed, and --bearing or --train "
                "with the "
                "tooth counts, such as --train 32/96-48/80, or --model MODEL.yaml"
            )
        first = next((speed.shaft for speed in given if speed.shaft), "") or _at(request) or "shaft 1"
        driven = {_SHAFT.fullmatch(text)[1].strip() for text in request.shafts if _SHAFT.fullmatch(text)}  # type: ignore[index]
        parts = TurningParts((Shaft("shaft 1" if first in driven else first, Fraction(1)),))
    names = {str(k + 1): shaft.name for k, shaft in enumerate(parts.shafts)}
    names |= {shaft.name: shaft.name for shaft in parts.shafts}
    parts, names = _with_shafts(parts, names, request.shafts)
    reference = shaft_of(where, names) or parts.shafts[0].name
    parts = _counted_from(parts, reference)
    frequency, tolerance = _reference_speed(given, parts, names)
    limits = _limits(given, frequency)
    if record.fault_orders and not request.bearings and len(parts.shafts) == 1:
        orders = ",".join(f"{fault}={order!r}" for fault, order in record.fault_orders.items())
        one = given_bearing(f"bearing:{orders}", parts, names)
        parts = replace(parts, bearings=(one.bearing,))
        sources: tuple[str, ...] = (f"bearing: fault orders of the file, {orders}",)
    else:
        sources = ()
    return Machine(
        parts, reference, frequency, tolerance, names, sources=sources, speed_source=source, limits=limits
    )


def _at(request: Request) -> str:
    """Shaft of CHANNEL@SHAFT of a tacho or an angle."""
    return (request.tacho or request.angle or "").partition("@")[2]


def stages(train: str) -> list[tuple[int, int]]:
    """Tooth numbers of each mesh."""
    stages = []
    for text in train.split("-"):
        found = re.fullmatch(r"\s*(\d+)\s*/\s*(\d+)\s*", text)
        if not found:
            raise SignalError(
                f"--train: {text!r} is not a pair of tooth counts; write them as in 32/96-48/80"
            )
        stages.append((int(found[1]), int(found[2])))
    return stages


def _with_shafts(
    parts: TurningParts, names: dict[str, str], options: Sequence[str]
) -> tuple[TurningParts, dict[str, str]]:
    """Add shafts driven by belts or by gears of unknown tooth numbers."""
    for text in options:
        name, ratio, driver = read_shaft(text)
        driver = driver or parts.shafts[0].name
        if driver not in names:
            raise SignalError(f"--shaft: no shaft {driver!r}; there are: {', '.join(names)}")
        if name in names:
            raise SignalError(f"--shaft: {name!r} exists already; use another name")
        order = parts.shaft(names[driver]).order * ratio
        same = next((shaft.name for shaft in parts.shafts if shaft.order == order), "")
        names = {**names, name: same or name}
        if not same:
            parts = replace(parts, shafts=(*parts.shafts, Shaft(name, order)))
    return parts, names


def read_shaft(text: str) -> tuple[str, Fraction, str]:
    """Name, ratio and driver of `NAME=RATIO[@SHAFT]`; the driver is empty if it is not given.

    Examples
    --------
    >>> read_shaft("fan=120/280@motor")
    ('fan', Fraction(3, 7), 'motor')
    """
    match = _SHAFT.fullmatch(text.strip())
    ratio = _ratio(match[2]) if match else None
    if match is None or ratio is None:
        raise SignalError(
            f"--shaft: {text!r} is not NAME=RATIO@SHAFT; write it as in fan=120/280@motor, the "
            "revolutions of fan per revolution of motor"
        )
    return match[1].strip(), ratio, (match[3] or "").strip()


def _ratio(text: str) -> Fraction | None:
    """Ratio as a number or a fraction; None if it is neither, or not positive."""
    try:
        found = [Fraction(one.strip()) for one in text.split("/")]
        ratio = found[0] / found[1] if len(found) == 2 else found[0]
    except (ValueError, ZeroDivisionError):
        return None
    return ratio.limit_denominator(FINEST) if len(found) <= 2 and ratio > 0 else None


def _reference_speed(
    given: list[GivenSpeed], parts: TurningParts, names: dict[str, str]
) -> tuple[float, float]:
    """Rotation frequency [Hz] of the reference shaft and its relative tolerance; NaN without a speed."""
    frequency, tolerance = math.nan, 0.0
    for one in given:
        shaft = names.get(one.shaft or parts.shafts[0].name)
        if shaft is None:
            raise SignalError(f"--speed: no shaft {one.shaft!r}; there are: {', '.join(names)}")
        speed = one.frequency / float(parts.shaft(shaft).order)
        if math.isnan(frequency):
            frequency, tolerance = speed, one.tolerance
            continue
        apart = abs(speed / frequency - 1.0)
        if apart > one.tolerance + tolerance:
            raise SignalError(
                f"--speed: the speeds differ by {100.0 * apart:.2g} % from the ratios of the machine "
                "(limit: their "
                f"tolerances, {100.0 * (one.tolerance + tolerance):.2g} %); give one of them"
            )
        if one.tolerance < tolerance:
            frequency, tolerance = speed, one.tolerance
    return frequency, tolerance


def _given_speeds(request: Request) -> list[GivenSpeed]:
    """Speeds of the options; a range is the only one."""
    given = [given_speed(text) for text in request.speeds]
    if len(given) > 1 and any(one.lowest is not None for one in given):
        raise SignalError(
            f"--speed: {len(given)} speeds, one of them a range (limit: a range alone); give the range of "
            "one shaft"
        )
    return given


def _limits(given: Sequence[GivenSpeed], highest: float) -> tuple[float, float] | None:
    """Range of the reference shaft [Hz] from that of the given shaft; None without one."""
    if not given or given[0].lowest is None:
        return None
    return highest * given[0].lowest / given[0].frequency, highest


def _counted_from(parts: TurningParts, reference: str) -> TurningParts:
    """The same machine with another reference shaft."""
    base = parts.shaft(reference).order
    return replace(parts, shafts=tuple(replace(shaft, order=shaft.order / base) for shaft in parts.shafts))


def _model(request: Request, record: Record) -> Model | None:
    """The given model, else the model stored in the file."""
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.report.stored_model import model_of_text

    if request.model is not None:
        return load_model(request.model, allow_code=request.allow_code)
    if not record.model_text:
        return None
    return model_of_text(record.model_text, request.file, request.allow_code)


def _of_model(request: Request, record: Record, model: Model) -> Machine:
    """Rotating parts of a model; speeds from options or a scenario, arbitrary with an angle channel."""
    from pitchpoint.report.frequencies import turning_speeds
    from pitchpoint.report.machine_parts import meshes_at_bodies, parts_of

    where = request.tacho or request.angle or ""
    angles = (
        [] if where or request.speeds else [n for n in record.channels if owner(n, "angle") in model.bodies]
    )
    bodies = {body: body for body in model.bodies}
    given = _given_speeds(request)
    spins, tolerance, remarks = _spins(request, record, model, given)
    if not any(spins.values()):
        measured = shaft_of(where, bodies) or next((owner(name, "angle") for name in angles), "")
        if not measured:
            raise SignalError(
                f"{request.file}: the speed is not known; give --speed BODY=QUANTITY, such as --speed "
                f"{next(iter(model.bodies), 'motor')}=1500rpm, or a tacho{_stated(record)}"
            )
        spins = turning_speeds(model, {measured: 1.0})
    known = {name: abs(spins.get(name, 0.0)) for name in model.bodies}
    seen = [owner(name, "angle") for name in angles if known[owner(name, "angle")]]
    reference = shaft_of(where, bodies) or max(seen or known, key=lambda body: known[body])
    if where and not shaft_of(where, bodies):
        turning = ", ".join(body for body, speed in known.items() if speed)
        raise SignalError(f"{where}: give its shaft, as in {where}@BODY; there are: {turning}")
    parts, names, more = parts_of(model, spins, reference)
    parts, names = _with_shafts(parts, names, request.shafts)
    frequency = known[reference] / math.tau
    return Machine(
        parts,
        reference,
        frequency,
        tolerance,
        names,
        (*remarks, *more),
        limits=_limits(given, frequency),
        meshes_at=meshes_at_bodies(model),
    )


def _stated(record: Record) -> str:
    """Speed of the file as the end of a sentence."""
    if record.speed is None:
        return ""
    return f"; the file states {60.0 * record.speed:.6g} rpm ({record.speed_source})"


def _spins(
    request: Request, record: Record, model: Model, given: Sequence[GivenSpeed]
) -> tuple[dict[str, float], float, list[str]]:
    """Speeds of all bodies [rad/s] from options or a scenario, and their tolerance; empty if neither gives
    any."""
    from pitchpoint.report.frequencies import scenario_speeds, turning_speeds

    if given:
        names = [one.shaft or (next(iter(model.bodies)) if len(model.bodies) == 1 else "") for one in given]
        if "" in names:
            text = request.speeds[names.index("")]
            raise SignalError(f"--speed: {text!r} does not name a body; write BODY={text}")
        speeds = {name: one.frequency * math.tau for name, one in zip(names, given, strict=True)}
        return turning_speeds(model, speeds), max(one.tolerance for one in given), []
    scenario = request.scenario or record.scenario
    if not scenario and len(model.scenarios) == 1:
        scenario = next(iter(model.scenarios))
    if scenario and scenario not in model.scenarios:
        if request.scenario is None:
            return {}, 0.0, []
        listed = ", ".join(model.scenarios) or "none"
        raise ModelError(
            [Message(f"scenarios.{scenario}", "is not in the model", remedy=f"there are: {listed}")]
        )
    if not scenario:
        return {}, 0.0, []
    speeds, remarks = scenario_speeds(model, scenario)
    return turning_speeds(model, speeds, model.scenarios[scenario]), SETTLED, remarks


def _with_bearings(machine: Machine, request: Request) -> Machine:
    """Add the bearings of the options to those of the model."""
    given = [given_bearing(text, machine.parts, machine.names) for text in request.bearings]
    bearings = (*machine.parts.bearings, *(one.bearing for one in given))
    twice = sorted({b.name for b in bearings if sum(b.name == other.name for other in bearings) > 1})
    if twice:
        raise SignalError(f"--bearing: {', '.join(twice)} is there twice; use different names")
    return replace(
        machine,
        parts=replace(machine.parts, bearings=bearings),
        sources=(*machine.sources, *(f"{one.bearing.name}: {one.source}" for one in given)),
    )


def shaft_of(where: str, names: dict[str, str]) -> str:
    """Shaft of CHANNEL@SHAFT, or the shaft in the name of an angle channel.

    Raises
    ------
    SignalError
        If there is no such shaft.
    """
    channel, at, shaft = where.partition("@")
    if at:
        if shaft not in names:
            raise SignalError(f"{where}: no shaft {shaft!r}; there are: {', '.join(names)}")
        return names[shaft]
    return names.get(owner(channel, "angle"), "")


def owner(channel: str, quantity: str) -> str:
    """Name of the body in `angle[body]`; empty for other channels.

    Examples
    --------
    >>> owner("angle[motor]", "angle"), owner("speed[motor]", "angle")
    ('motor', '')
    """
    found = re.fullmatch(rf"{quantity}\[([^\]]+)\]", channel)
    return found[1] if found else ""
