# SPDX-License-Identifier: Apache-2.0
"""Names of the signals of a model: who makes them, who reads them, and which follow others at once."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from pitchpoint.core import nomenclature
from pitchpoint.model.components import block as bl
from pitchpoint.model.components.controller import inputs_of, outputs_of
from pitchpoint.model.components.sensor import FrameSensor, JointSensor, Listener, LoadSensor
from pitchpoint.model.keys import Place

SECTIONS = ("sensors", "blocks", "controllers", "actuators")
"""Sections of a file that have to do with signals."""
TIME = "t"
"""Name of the time where a formula takes it."""
LAW_ARGUMENTS = ("t", "x", "p")
CONTROLLER_ARGUMENTS = ("t", "inputs", "state", "parameters")
"""What functions of blocks and of controllers are called with."""


def made(machine: Any) -> Iterator[tuple[str, Place]]:
    """Every signal that a model or its parts make, with the place of its name."""
    for section in ("sensors", "blocks"):
        for name in getattr(machine, section):
            yield name, (section, name)
    for name, part in machine.controllers.items():
        listed = outputs_of(part)
        for i, output in enumerate(listed):
            at: Place = ("controllers", name, "output")
            yield output, at if hasattr(part, "output") else ("controllers", name, "outputs", i)


def read(machine: Any) -> Iterator[tuple[str, Place]]:
    """Every signal that something reads, with the place where it is named; the time is none."""
    for name, block in machine.blocks.items():
        for signal, at in inputs(block):
            if signal != TIME or not isinstance(block, bl.FormulaBlock):
                yield signal, ("blocks", name, *at)
    for name, part in machine.controllers.items():
        many = not hasattr(part, "input")
        for i, signal in enumerate(inputs_of(part)):
            at = ("inputs", i) if many else ("input",)
            yield signal, ("controllers", name, *at)
    for name, part in machine.actuators.items():
        yield part.signal, ("actuators", name, "signal")


def inputs(block: bl.Block) -> list[tuple[str, Place]]:
    """Signals that a block is made of, with the keys that name them."""
    if isinstance(block, bl.Sum):
        return [(signal, ("inputs", signal)) for signal in block.inputs]
    if isinstance(block, bl.FormulaBlock):
        return [(signal, ("inputs", i)) for i, signal in enumerate(block.inputs)]
    return [(block.input, ("input",))]


def at_once(machine: Any) -> dict[str, list[str]]:
    """For every signal those that it follows without a state between; loads follow whatever acts.

    Actuators are among them under their names.
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
    """Whether the output of a block does not follow its input at once."""
    if isinstance(block, bl.TransferFunction):
        return len(block.numerator) < len(block.denominator) or block.numerator[0] == 0.0
    return isinstance(block, bl.Integrator | bl.Filter)


RATES = (
    "velocity",
    "acceleration",
    "distance_rate",
    "angular_velocity",
    "angular_acceleration",
)


def rates_behind(machine: Any) -> dict[str, str]:
    """For every actuator that follows a rate, through whatever blocks, the sensor of it."""
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
