# SPDX-License-Identifier: Apache-2.0
"""Sampled controllers: called at the multiples of a sample time, outputs constant between."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.keys import key, positive, quantities, quantity, text

PERIOD = "time between two calls"
DELAY = "time from a call to the change of the outputs"


@dataclass(frozen=True, kw_only=True)
class PythonController:
    """A Python function f(t, inputs, state, parameters) -> outputs; `state` is a dictionary of its own."""

    form: ClassVar[str] = "python"
    function: str = text("file.py:function")
    inputs: tuple[str, ...] = key("names", "names of the signals that it reads", ())
    outputs: tuple[str, ...] = key("names", "names of the signals that it makes", length=(1, 10**4))
    start: tuple[float, ...] = quantities(
        "dimensionless", "values of the outputs before the first call", (), display="zeros"
    )
    period: float = positive("time", PERIOD)
    delay: float = quantity("time", DELAY, 0.0, minimum=0.0)
    parameters: tuple[float, ...] = quantities("dimensionless", "numbers handed to the function", ())


@dataclass(frozen=True, kw_only=True)
class SampledPid:
    """Digital PID controller by backward differences; at its limits it integrates only what leads back."""

    form: ClassVar[str] = "pid"
    input: str = text("name of the control error")
    output: str = text("name of the signal that it makes")
    proportional: float = quantity("dimensionless", "gain of the error")
    integral: float = quantity("dimensionless", "gain of its integral", 0.0)
    derivative: float = quantity("dimensionless", "gain of its derivative", 0.0)
    limits: tuple[float, ...] = quantities("dimensionless", "least and greatest output", ())
    period: float = positive("time", PERIOD)
    delay: float = quantity("time", DELAY, 0.0, minimum=0.0)


Controller: TypeAlias = PythonController | SampledPid

CONTROLLERS: dict[str, type] = {c.form: c for c in (PythonController, SampledPid)}
