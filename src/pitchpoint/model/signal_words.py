# SPDX-License-Identifier: Apache-2.0
"""Signals of a model in words, for checks and reports."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.units import format_quantity
from pitchpoint.model.components.actuator import ForceActuator, TorqueActuator
from pitchpoint.model.components.block import Pid
from pitchpoint.model.components.controller import inputs_of, outputs_of
from pitchpoint.model.components.sensor import FrameSensor, JointSensor, LoadSensor
from pitchpoint.model.signal_names import inputs, read

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

HEAD = ("signal", "what it is", "made of", "read by")
Line = tuple[str, str, str, str]


def signal_lines(model: Model) -> list[Line]:
    """One line for every signal and every actuator: its name, what it is, what it is made of, who reads it.

    Parameters
    ----------
    model
        The model.
    """
    readers: dict[str, list[str]] = {}
    for signal, at in read(model):
        readers.setdefault(signal, []).append(str(at[1]))
    lines = [(name, *_sensor(part)) for name, part in model.sensors.items()]
    for name, block in model.blocks.items():
        words = "formula" if block.form == "formula" else f"block: {block.form.replace('_', ' ')}"
        lines.append((name, words, ", ".join(signal for signal, _ in inputs(block))))
    for name, part in model.controllers.items():
        late = f", {format_quantity(part.delay, 'time')} late" if part.delay else ""
        words = f"controller {name} ({part.form}), every {format_quantity(part.period, 'time')}{late}"
        lines += [(output, words, ", ".join(inputs_of(part))) for output in outputs_of(part)]
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
        remark(
            f"controllers.{name}.output", f"nothing reads {output}: it acts on nothing and is only recorded"
        )
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
