# SPDX-License-Identifier: Apache-2.0
"""Units of signals, and the dimensions of the numbers of blocks and controllers that follow from them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from pitchpoint.core import nomenclature
from pitchpoint.core.discon.records import find_record
from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.unit_expression import parse_unit
from pitchpoint.model.components import block as bl
from pitchpoint.model.components import controller as co
from pitchpoint.model.components.joint import DISPLACEMENTS
from pitchpoint.model.components.sensor import UNITS, FrameSensor, JointSensor, LoadSensor
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.bare_numbers import GIVEN, SIGNAL, Bare, is_doubtful
from pitchpoint.model.scenario import Course

FACTOR, OWN, INPUT, RATE, PATH, RECORD, SPEED = "factor", "own", "input", "rate", "path", "record", "speed"
"""What a number is: a factor of any unit, a value of the signal itself, of the input, its rate, its integral
over time, a record of a controller library, a generator speed."""
MEANINGS: Mapping[tuple[type, str], tuple[str, ...]] = {
    (bl.Sum, "inputs"): (FACTOR,),
    (bl.Sum, "offset"): (OWN,),
    (bl.Limits, "limits"): (OWN,),
    (bl.Curve, "points"): (INPUT, OWN),
    (bl.Integrator, "start"): (OWN,),
    (bl.RateLimit, "rate"): (RATE,),
    (bl.RateLimit, "start"): (OWN,),
    (bl.DryFriction, "wind_up"): (PATH,),
    (bl.Input, "value"): (OWN,),
    (bl.TransferFunction, "numerator"): (FACTOR,),
    (bl.TransferFunction, "denominator"): (FACTOR,),
    (bl.Pid, "proportional"): (FACTOR,),
    (bl.Pid, "integral"): (FACTOR,),
    (bl.Pid, "derivative"): (FACTOR,),
    (bl.Pid, "limits"): (OWN,),
    (co.PythonController, "start"): (OWN,),
    (co.SampledPid, "proportional"): (FACTOR,),
    (co.SampledPid, "integral"): (FACTOR,),
    (co.SampledPid, "derivative"): (FACTOR,),
    (co.SampledPid, "limits"): (OWN,),
    (co.SampledPid, "start"): (OWN,),
    (co.DisconController, "inputs"): (RECORD,),
    (co.DisconController, "start"): (OWN,),
    (co.DisconController, "torque_table"): (SPEED, FACTOR),
    (co.FmuController, "parameters"): (FACTOR,),
    (co.FmuController, "start"): (FACTOR,),
    (Course, "value"): (OWN,),
    (Course, "points"): (FACTOR, OWN),
}
"""What the numbers of keys without dimension are; for rows, in each column."""
DIMENSION = {"m": "length", "rad": "angle", "rad/s": "angular_speed"}
"""Dimensions whose numbers without unit may be doubtful, by the unit of the signal."""
PER_SECOND = {"m": "m/s", "m/s": "m/s^2", "rad": "rad/s", "rad/s": "rad/s^2"}
_FRAMES = {
    "position": "m",
    "velocity": "m/s",
    "acceleration": "m/s^2",
    "distance": "m",
    "distance_rate": "m/s",
    "angle": "rad",
    "angular_velocity": "rad/s",
    "angular_acceleration": "rad/s^2",
}


def source_of(blocks: Mapping[str, Any], name: str) -> str:
    """Signal whose unit a signal has: limits, filters and rate limits have the unit of their input."""
    seen: set[str] = set()
    while isinstance(blocks.get(name), bl.Limits | bl.Filter | bl.RateLimit) and name not in seen:
        seen.add(name)
        name = blocks[name].input
    return name


def unit_of_signal(machine: Any, name: str) -> str:
    """SI unit of a signal of a model; "1" if it is not known.

    Parameters
    ----------
    machine
        The model, or its parts.
    name
        Name of the signal.
    """
    name = source_of(machine.blocks, name)
    if name in machine.blocks:
        return str(getattr(machine.blocks[name], "unit", "1"))
    if name in machine.sensors:
        return _of_sensor(machine, machine.sensors[name])
    for part in machine.controllers.values():
        if isinstance(part, co.DisconController):
            record = next((find_record(r) for r, signal in part.outputs.items() if signal == name), None)
            if record is not None:
                return record.unit
        elif name in co.outputs_of(part):
            return str(getattr(part, "unit", "1"))
    return "1"


def _of_sensor(machine: Any, sensor: Any) -> str:
    """Unit of a sensor."""
    if isinstance(sensor, FrameSensor):
        return _FRAMES[sensor.quantity]
    if isinstance(sensor, LoadSensor):
        return "N m" if sensor.quantity == "moment" else "N"
    if isinstance(sensor, JointSensor):
        joint, _, coordinate = sensor.coordinate.rpartition(".")
        if not joint and coordinate in machine.joints:
            return "1"  # the name of a joint without its coordinate is reported
        own = getattr(machine.joints.get(joint), "coordinates", {})
        unit = "m" if own.get(coordinate, DISPLACEMENTS.get(coordinate)) == "length" else "rad"
        return unit + ("", "/s", "/s^2")[sensor.derivative]
    try:
        unit = nomenclature.unit(sensor.channel)
    except PitchpointError:
        return "1"
    return unit if unit in UNITS else "1"


def unit_at(machine: Any, place: Place) -> str:
    """SI unit of a number of a block, a controller or the course of an input; "" if it is not known.

    Parameters
    ----------
    machine
        The model, or its parts.
    place
        Path of the number.
    """
    owner: type = Course
    if place[0] == "scenarios":  # scenarios.NAME.inputs.INPUT.KEY
        name, rest = str(place[3]), place[4:]
    else:
        name, rest = str(place[1]), place[2:]
        owner = type(getattr(machine, str(place[0])).get(name))
    meanings = MEANINGS.get((owner, str(rest[0])), (FACTOR,))
    meaning = meanings[int(rest[-1])] if len(meanings) > 1 and len(rest) > 2 else meanings[0]
    if meaning == SPEED:
        return "rad/s"
    if meaning == RECORD:
        record = find_record(str(rest[1]))
        return record.unit if record is not None else ""
    if meaning == FACTOR:
        return ""
    if owner is co.DisconController:
        name = str(rest[1])
    elif place[0] == "controllers":
        outputs = co.outputs_of(machine.controllers[name])
        name = outputs[int(rest[-1])] if owner is co.PythonController else outputs[0]
    if meaning in (INPUT, PATH):
        name = machine.blocks[name].input
    unit = unit_of_signal(machine, name)
    if meaning == PATH:
        return next((before for before, after in PER_SECOND.items() if after == unit), "")
    return PER_SECOND.get(unit, "") if meaning == RATE else unit


def doubtful(machine: Any, numbers: Iterable[Bare]) -> list[Bare]:
    """Numbers without unit, and of the values of signals those that are doubtful in the unit of the signal.

    Parameters
    ----------
    machine
        The model.
    numbers
        Notes of the reader.
    """
    found = []
    for bare in numbers:
        if bare.form == GIVEN:
            continue
        if bare.dimension == SIGNAL:
            unit = unit_at(machine, bare.place)
            of_angle = unit == "rad/s" and bare.place[2] == "rate"
            bare = bare._replace(dimension=DIMENSION.get(unit, ""), unit="deg/s" if of_angle else "")
            if not is_doubtful(bare.value, bare.dimension):
                continue
        found.append(bare)
    return found


def contradictory(machine: Any, numbers: Iterable[Bare]) -> Iterator[tuple[Bare, str]]:
    """Values of signals whose unit is not one of the signal, with the unit of the signal.

    Parameters
    ----------
    machine
        The parts of the model.
    numbers
        Notes of the reader.
    """
    for bare in numbers:
        if bare.form == GIVEN:
            unit = unit_at(machine, bare.place)
            if unit not in ("", "1") and _exponents(unit) != _exponents(bare.unit):
                yield bare, unit


def _exponents(unit: str) -> tuple[int, ...]:
    """Exponents of metre, kilogram, second, kelvin and cycle; radians are dimensionless."""
    found = parse_unit(unit)
    return found.m, found.kg, found.s, found.K, found.cycle
