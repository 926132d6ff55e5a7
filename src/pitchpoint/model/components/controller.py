# SPDX-License-Identifier: Apache-2.0
"""Discrete controllers: called at multiples of the sample time; outputs are held constant in between."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.component import Component
from pitchpoint.model.components.law import PythonLaw
from pitchpoint.model.components.sensor import UNITS
from pitchpoint.model.keys import choice, integer, key, positive, quantities, quantity, text

PERIOD = "sample time"
DELAY = "delay from a sample to the change of the outputs"
START = "before the first update"


@dataclass(frozen=True, kw_only=True)
class PythonController(Component):
    """A Python function f(t, inputs, state, parameters) -> outputs; `state` is a private dictionary."""

    form: ClassVar[str] = "python"
    function: PythonLaw = key("code", "FILE.py:function")
    inputs: tuple[str, ...] = key("names", "names of its input signals", ())
    outputs: tuple[str, ...] = key("names", "names of its output signals", length=(1, 1000))
    start: tuple[float, ...] = key("values", f"values of the outputs {START}", (), display="zeros")
    period: float = positive("time", PERIOD)
    delay: float = quantity("time", DELAY, 0.0, minimum=0.0)
    parameters: tuple[float, ...] = quantities("dimensionless", "numbers passed to the function", ())
    unit: str = choice(UNITS, "unit of the outputs in results", "1")


@dataclass(frozen=True, kw_only=True)
class SampledPid(Component):
    """Digital PID controller by backward differences, with conditional integration as anti-windup."""

    form: ClassVar[str] = "pid"
    input: str = text("name of the control error")
    output: str = text("name of the output signal")
    proportional: float = key("value", "proportional gain")
    integral: float = key("value", "integral gain", 0.0)
    derivative: float = key("value", "derivative gain", 0.0)
    limits: tuple[float, float] | None = key(
        "values", "minimum and maximum output", None, length=(2, 2), display="none"
    )
    start: float = key("value", f"output {START}, and the integral part at the first call", 0.0)
    period: float = positive("time", PERIOD)
    delay: float = quantity("time", DELAY, 0.0, minimum=0.0)
    unit: str = choice(UNITS, "unit of the output in results", "1")


@dataclass(frozen=True, kw_only=True)
class DisconController(Component):
    """Controller library of a wind turbine with the interface of Bladed, in a process of its own."""

    form: ClassVar[str] = "discon"
    library: str = key("library", "shared library for this system, .so, .dll or .dylib, or rosco")
    procedure: str = text("name of the procedure in the library", "DISCON")
    input_file: str | None = key(
        "file", "input file of the library; its folder is the working directory of the library", None
    )
    output_name: str | None = text(
        "name from which the library makes the names of its output files",
        None,
        display="name of the controller with .out",
    )
    inputs: Mapping[str, str | float] = key("records", "signal or constant number for each record", {})
    outputs: Mapping[str, str] = key(
        "record_signals", "name of the output signal for each record", length=(1, 1000)
    )
    start: Mapping[str, float] = key("gains", f"values of output signals {START}", {}, display="zeros")
    period: float = positive("time", PERIOD)
    delay: float = quantity("time", DELAY, 0.0, minimum=0.0)
    blades: int = integer("number of blades", 3, minimum=1, maximum=3)
    pitch_control: str = choice(("collective", "individual"), "pitch demands", "collective")
    pitch_actuator: str = choice(("position", "rate"), "meaning of the pitch demands", "position")
    yaw_control: str = choice(("rate", "torque"), "yaw demand", "rate")
    torque_table: tuple[tuple[float, float], ...] | None = key(
        "curve", "generator torque below rated: points [speed, torque], or a text file", None
    )
    timeout: float = positive("time", "longest duration of a call; then the process is ended", 30.0)


@dataclass(frozen=True, kw_only=True)
class FmuController(Component):
    """A functional mock-up unit (FMU) of another program, for co-simulation, in a process of its own."""

    form: ClassVar[str] = "fmu"
    delay: ClassVar[float] = 0.0
    file: str = key("file", "FMU of version 2.0 or 3.0", sample="engine.fmu")
    inputs: Mapping[str, str] = key("wires", "signal that each of its inputs follows", {})
    outputs: Mapping[str, str] = key("wires", "signal that follows each of its outputs")
    parameters: Mapping[str, float] = key("gains", "values of its parameters, set before the start", {})
    start: tuple[float, ...] = key("values", f"values of the outputs {START}", (), display="zeros")
    period: float = positive("time", "communication step")
    time_limit: float = positive("time", "maximum wall time of a communication step", 30.0)


Controller: TypeAlias = PythonController | SampledPid | DisconController | FmuController

CONTROLLERS: dict[str, type] = {
    c.form: c for c in (PythonController, SampledPid, DisconController, FmuController)
}


def outputs_of(part: Controller) -> tuple[str, ...]:
    """Names of the output signals of a controller."""
    if isinstance(part, DisconController | FmuController):
        return tuple(part.outputs.values())
    return part.outputs if isinstance(part, PythonController) else (part.output,)


def inputs_of(part: Controller) -> tuple[str, ...]:
    """Names of the input signals of a controller."""
    if isinstance(part, DisconController | FmuController):
        return tuple(signal for signal in part.inputs.values() if isinstance(signal, str))
    return part.inputs if isinstance(part, PythonController) else (part.input,)


def output_keys(part: Controller) -> tuple[tuple[str | int, ...], ...]:
    """Key of each output signal of a controller, in the order of `outputs_of`."""
    if isinstance(part, DisconController | FmuController):
        return tuple(("outputs", name) for name in part.outputs)
    if isinstance(part, PythonController):
        return tuple(("outputs", i) for i in range(len(part.outputs)))
    return (("output",),)


def input_keys(part: Controller) -> tuple[tuple[str | int, ...], ...]:
    """Key of each input signal of a controller, in the order of `inputs_of`."""
    if isinstance(part, DisconController | FmuController):
        return tuple(("inputs", name) for name, signal in part.inputs.items() if isinstance(signal, str))
    if isinstance(part, PythonController):
        return tuple(("inputs", i) for i in range(len(part.inputs)))
    return (("input",),)
