# SPDX-License-Identifier: Apache-2.0
"""Sampled controllers: called at the multiples of a sample time, outputs constant between."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.components.law import PythonLaw
from pitchpoint.model.components.sensor import UNITS
from pitchpoint.model.keys import choice, key, positive, quantities, quantity, text

PERIOD = "time between two calls"
DELAY = "time from a call to the change of the outputs"
START = "before the first change"


@dataclass(frozen=True, kw_only=True)
class PythonController:
    """A Python function f(t, inputs, state, parameters) -> outputs; `state` is a dictionary of its own."""

    form: ClassVar[str] = "python"
    function: PythonLaw = key("code", "FILE.py:function")
    inputs: tuple[str, ...] = key("names", "names of the signals that it reads", ())
    outputs: tuple[str, ...] = key("names", "names of the signals that it makes", length=(1, 1000))
    start: tuple[float, ...] = key("values", f"values of the outputs {START}", (), display="zeros")
    period: float = positive("time", PERIOD)
    delay: float = quantity("time", DELAY, 0.0, minimum=0.0)
    parameters: tuple[float, ...] = quantities("dimensionless", "numbers handed to the function", ())
    unit: str = choice(UNITS, "unit that results give the outputs", "1")


@dataclass(frozen=True, kw_only=True)
class SampledPid:
    """Digital PID controller by backward differences; at its limits it integrates only what leads back."""

    form: ClassVar[str] = "pid"
    input: str = text("name of the control error")
    output: str = text("name of the signal that it makes")
    proportional: float = key("value", "gain of the error")
    integral: float = key("value", "gain of its integral", 0.0)
    derivative: float = key("value", "gain of its derivative", 0.0)
    limits: tuple[float, float] | None = key(
        "values", "minimum and maximum output", None, length=(2, 2), display="none"
    )
    start: float = key("value", f"output {START}, and its integral at the first call", 0.0)
    period: float = positive("time", PERIOD)
    delay: float = quantity("time", DELAY, 0.0, minimum=0.0)
    unit: str = choice(UNITS, "unit that results give the output", "1")


Controller: TypeAlias = PythonController | SampledPid

CONTROLLERS: dict[str, type] = {c.form: c for c in (PythonController, SampledPid)}


def outputs_of(part: Controller) -> tuple[str, ...]:
    """Names of the signals that a controller makes."""
    return part.outputs if isinstance(part, PythonController) else (part.output,)


def inputs_of(part: Controller) -> tuple[str, ...]:
    """Names of the signals that a controller reads."""
    return part.inputs if isinstance(part, PythonController) else (part.input,)
