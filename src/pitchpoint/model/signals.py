# SPDX-License-Identifier: Apache-2.0
"""Signals of a model: sources, readers, direct feedthrough, and their text in reports."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from pitchpoint.core import nomenclature
from pitchpoint.core.errors import Message, remark
from pitchpoint.core.units import format_quantity
from pitchpoint.model.components import block as bl
from pitchpoint.model.components.actuator import ForceActuator, TorqueActuator
from pitchpoint.model.components.block import Pid
from pitchpoint.model.components.controller import input_keys, inputs_of, output_keys, outputs_of
from pitchpoint.model.components.sensor import FrameSensor, JointSensor, Listener, LoadSensor
from pitchpoint.model.keys import Place

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


SECTIONS = ("sensors", "blocks", "controllers", "actuators")
"""Sections of a file that define signals or use them."""
TIME = "t"
"""Name of the time in formulas."""
LAW_ARGUMENTS = ("t", "x", "p")
CONTROLLER_ARGUMENTS = ("t", "inputs", "state", "parameters")
"""Arguments of the functions of blocks and controllers."""
APPENDED = {"springs": 1, "torsion_springs": 1}
"""Numbers that follow the parameters of a Python law, by section: the rate of a spring."""


def made(machine: Any) -> Iterator[tuple[str, Place]]:
    """All signals that a model or its parts define, with the path of the name."""
    for section in ("sensors", "blocks"):
        for name in getattr(machine, section):
            yield name, (section, name)
    for name, part in machine.controllers.items():
        for output, at in zip(outputs_of(part), output_keys(part), strict=True):
            yield output, ("controllers", name, *at)


def read(machine: Any) -> Iterator[tuple[str, Place]]:
    """All signals that are read, with the path of the reference; without the time."""
    for name, block in machine.blocks.items():
        for signal, at in inputs(block):
            if signal != TIME or not isinstance(block, bl.FormulaBlock):
                yield signal, ("blocks", name, *at)
    for name, part in machine.controllers.items():
        for signal, at in zip(inputs_of(part), input_keys(part), strict=True):
            yield signal, ("controllers", name, *at)
    for name, part in machine.actuators.items():
        yield part.signal, ("actuators", name, "signal")


def inputs(block: bl.Block) -> list[tuple[str, Place]]:
    """Input signals of a block, with the keys that name them."""
    if isinstance(block, bl.Sum):
        return [(signal, ("inputs", signal)) for signal in block.inputs]
    if isinstance(block, bl.FormulaBlock):
        return [(signal, ("inputs", i)) for i, signal in enumerate(block.inputs)]
    return [] if isinstance(block, bl.Input) else [(block.input, ("input",))]


def at_once(machine: Any) -> dict[str, list[str]]:
    """Direct feedthrough: for every signal and actuator, the signals that it depends on without a state
    between.

    Load sensors depend on all actuators.
    """
    found: dict[str, list[str]] = {name: [] for name, _ in made(machine)}
    for name, part in machine.actuators.items():
        found[name] = [part.signal]
    for name, part in machine.sensors.items():
        if isinstance(part, LoadSensor):
            found[name] = list(machine.actuators)
    for name, block in machine.blocks.items():
        if not has_state_between(block):
            found[name] = [signal for signal, _ in inputs(block) if signal in found]
    return found


def has_state_between(block: bl.Block) -> bool:
    """Whether a block has no direct feedthrough from input to output."""
    if isinstance(block, bl.TransferFunction):
        return len(block.numerator) < len(block.denominator) or block.numerator[0] == 0.0
    return isinstance(block, bl.Integrator | bl.Filter | bl.RateLimit)


RATES = (
    "velocity",
    "acceleration",
    "distance_rate",
    "angular_velocity",
    "angular_acceleration",
)


def rates_behind(machine: Any) -> dict[str, str]:
    """For every actuator that depends on a rate, directly or through blocks, the sensor of the rate."""
    found = {}
    for name, part in machine.actuators.items():
        waiting, seen = [part.signal], set()
        while waiting:
            signal = waiting.pop()
            if signal in seen:
                continue
            seen.add(signal)
            if signal in machine.blocks:
                waiting += [n for n, _ in inputs(machine.blocks[signal])]
            elif signal in machine.sensors and _is_rate(machine.sensors[signal]):
                found[name] = signal
    return found


def _is_rate(sensor: Any) -> bool:
    if isinstance(sensor, JointSensor):
        return sensor.derivative > 0
    if isinstance(sensor, Listener):
        return "/s" in nomenclature.unit(sensor.channel)
    return isinstance(sensor, FrameSensor) and sensor.quantity in RATES


HEAD = ("signal", "what it is", "made of", "read by")
Line = tuple[str, str, str, str]


def signal_lines(model: Model) -> list[Line]:
    """One line for every signal and actuator: name, kind, inputs, readers.

    Parameters
    ----------
    model
        The model.
    """
    readers: dict[str, list[str]] = {}
    for signal, at in read(model):
        users = readers.setdefault(signal, [])
        users += [str(at[1])] * (at[1] not in users)
    lines = [(name, *_sensor(part)) for name, part in model.sensors.items()]
    for name, block in model.blocks.items():
        words = "formula" if block.form == "formula" else f"block: {block.form.replace('_', ' ')}"
        lines.append((name, words, ", ".join(signal for signal, _ in inputs(block))))
    for name, part in model.controllers.items():
        late = f", {format_quantity(part.delay, 'time')} late" if part.delay else ""
        words = f"controller {name} ({part.form}), every {format_quantity(part.period, 'time')}{late}"
        made_of = ", ".join(dict.fromkeys(inputs_of(part)))
        lines += [(output, words, made_of) for output in outputs_of(part)]
    found: list[Line] = [(*line, ", ".join(readers.get(line[0], ()))) for line in lines]
    return [*found, *((name, _actuator(part), part.signal, "") for name, part in model.actuators.items())]


def _sensor(part: Any) -> tuple[str, str]:
    if isinstance(part, FrameSensor):
        along = "" if part.quantity.startswith("distance") else f" {part.axis}"
        return f"sensor: {part.quantity.replace('_', ' ')}{along}", f"{part.ends[0]} from {part.ends[1]}"
    if isinstance(part, JointSensor):
        return f"sensor: {('coordinate', 'rate', 'acceleration')[part.derivative]}", part.coordinate
    if isinstance(part, LoadSensor):
        return f"sensor: {part.quantity} {part.axis} of the joint", part.at
    return "sensor: observation", part.channel


def _actuator(part: Any) -> str:
    if isinstance(part, TorqueActuator):
        return f"torque on {' against '.join(part.bodies)}"
    if isinstance(part, ForceActuator):
        return f"{part.quantity} {part.axis} on {' against '.join(part.ends)}"
    return f"strut between {' and '.join(part.ends)}"


def signals_without_effect(model: Model) -> list[Message]:
    """A remark for every controller whose signals nothing reads, and for keys without effect."""
    used = {signal for signal, _ in read(model)}
    found = [
        remark(f"controllers.{name}.output", f"nothing reads {output}: it is only recorded")
        for name, part in model.controllers.items()
        for output in outputs_of(part)
        if output not in used
    ]
    for name, block in model.blocks.items():
        if isinstance(block, Pid):
            if block.filter_time > 0.0 and block.derivative == 0.0:
                found.append(remark(f"blocks.{name}.filter_time", "has no effect without derivative"))
            if block.tracking_time is not None and (block.limits is None or block.integral == 0.0):
                found.append(
                    remark(f"blocks.{name}.tracking_time", "has no effect without limits and integral")
                )
    return found
