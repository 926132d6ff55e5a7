# SPDX-License-Identifier: Apache-2.0
"""Sampled controllers: user-defined or built-in functions that are called at multiples of a sample time."""

from __future__ import annotations

import copy
import math
import traceback
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from pitchpoint.core.discon.process import ControllerError
from pitchpoint.core.errors import CompileError
from pitchpoint.core.fmi.fmu_process import FmuError


@dataclass(frozen=True)
class SampledController:
    """Sampled controller f(t, inputs, state, parameters) -> outputs.

    Parameters
    ----------
    name
        Name of the controller, for messages.
    function
        Called with time [s], inputs (array), controller state (may be modified in place) and parameters;
        returns one number per output, or a single number for one output.
    inputs, outputs
        Names of the input signals and of the zero-order-hold output signals.
    period
        Sample time [s]; the first call is at the start of the run.
    delay
        Time from a call to the change of the outputs [s]; may be one or more periods.
    state
        Initial state, copied at the start of each run.
    parameters
        Passed to the function unchanged.
    finish
        Called with the state at the end of the run; returns remarks.
    keeping
        Functions that return a saved copy of a state, and a state from a saved copy.
    """

    name: str
    function: Callable[..., Any]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    period: float
    delay: float = 0.0
    state: Any = None
    parameters: Any = ()
    finish: Callable[[Any], tuple[str, ...]] | None = None
    keeping: tuple[Callable[[Any], Any], Callable[[Any], Any]] = (copy.deepcopy, copy.deepcopy)

    def __post_init__(self) -> None:
        """Check period and delay."""
        if not (self.period > 0.0 and math.isfinite(self.period)):
            raise CompileError(f"controller {self.name!r}: its period must be positive, not {self.period}")
        if not (self.delay >= 0.0 and math.isfinite(self.delay)):
            raise CompileError(f"controller {self.name!r}: its delay must be >= 0, not {self.delay}")

    def call(self, t: float, inputs: Any, state: Any) -> tuple[list[float], str]:
        """Call the function; returns the outputs and an error message, empty if the call succeeded."""
        try:
            answer = self.function(t, inputs, state, self.parameters)
        except KeyboardInterrupt:
            raise
        except (ControllerError, FmuError) as error:
            return [], self._message(t, str(error))
        except BaseException as error:  # noqa: BLE001 - a user's code may raise anything, SystemExit too
            return [], self._message(t, f"raised {type(error).__name__}: {error}", _where(error))
        try:
            found = [float(x) for x in (answer if np.ndim(answer) else [answer])]
        except (TypeError, ValueError):
            return [], self._message(t, f"returned {answer!r}, which is not a list of numbers")
        if len(found) != len(self.outputs):
            return [], self._message(t, f"returned {len(found)} numbers for {len(self.outputs)} outputs")
        bad = [
            f"{x} for {name!r}" for x, name in zip(found, self.outputs, strict=True) if not math.isfinite(x)
        ]
        return found, self._message(t, f"returned {', '.join(bad)}") if bad else ""

    def _message(self, t: float, what: str, where: str = "") -> str:
        return f"the controller {self.name!r} {what} (t = {t:.6g} s{where})"


def _where(error: BaseException) -> str:
    """File and line in which an exception was raised."""
    last = traceback.extract_tb(error.__traceback__)[-1]
    return f", {Path(last.filename).name}, line {last.lineno}"


def sampled_pid(
    t: float, inputs: Sequence[float], state: dict[str, Any], parameters: dict[str, float]
) -> float:
    """Discrete PID controller: backward differences, output limits, anti-windup by conditional integration.

    Parameters
    ----------
    t
        Time [s].
    inputs
        Control error.
    state
        {"integral": 0.0, "error": None}; error is that of the previous call, None at the first call.
    parameters
        kp, ki, kd, period; optionally low and high as limits of the output.
    """
    e = float(inputs[0])
    h = parameters["period"]
    low, high = parameters.get("low", -math.inf), parameters.get("high", math.inf)
    integral = state["integral"] + parameters.get("ki", 0.0) * h * e
    before = e if state["error"] is None else state["error"]
    u = parameters.get("kp", 0.0) * e + integral + parameters.get("kd", 0.0) * (e - before) / h
    state["error"] = e
    limited = min(max(u, low), high)
    if u == limited or (u - limited) * e < 0.0:  # integrate only if the output leaves saturation
        state["integral"] = integral
    return limited
