# SPDX-License-Identifier: Apache-2.0
"""Discrete controllers: called at multiples of the sample time; outputs are held constant in between."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.component import Component
from pitchpoint.model.components.law import PythonLaw
from pitchpoint.model.components.sensor import UNITS
from pitchpoint.model.keys import choice, key, positive, quantities, quantity, text

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


Controller: TypeAlias = PythonController | SampledPid | FmuController

CONTROLLERS: dict[str, type] = {c.form: c for c in (PythonController, SampledPid, FmuController)}


def outputs_of(part: Controller) -> tuple[str, ...]:
    """Names of the output signals of a controller."""
    if isinstance(part, FmuController):
        return tuple(part.outputs.values())
    return part.outputs if isinstance(part, PythonController) else (part.output,)


def inputs_of(part: Controller) -> tuple[str, ...]:
    """Names of the input signals of a controller."""
    if isinstance(part, FmuController):
        return tuple(part.inputs.values())
    return part.inputs if isinstance(part, PythonController) else (part.input,)
