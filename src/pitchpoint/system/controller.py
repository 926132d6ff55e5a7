# SPDX-License-Identifier: Apache-2.0
"""Sampled controllers: functions of a user or built in, called at the multiples of a sample time."""

from __future__ import annotations

import math
import traceback
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from pitchpoint.core.errors import CompileError


@dataclass(frozen=True)
class SampledController:
    """A controller f(t, inputs, state, parameters) -> outputs.

    Parameters
    ----------
    name
        For messages.
    function
        Gets the time [s], the inputs as an array, its own state, which it may change in place, and its
        parameters; returns one number per output, or the number itself if there is one output.
    inputs, outputs
        Names of the signals it reads, and of the held signals it writes.
    period
        Time between two calls [s]; the first is at the start of the run.
    delay
        Time from a call to the change of the outputs [s], a whole number of periods included.
    state
        Start of its state, copied at the start of every run.
    parameters
        Handed on as they are.
    """

    name: str
    function: Callable[..., Any]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    period: float
    delay: float = 0.0
    state: Any = None
    parameters: Any = ()

    def __post_init__(self) -> None:
        """Refuse times that are none."""
        if not (self.period > 0.0 and math.isfinite(self.period)):
            raise CompileError(f"controller {self.name!r}: its period must be positive, not {self.period}")
        if not (self.delay >= 0.0 and math.isfinite(self.delay)):
            raise CompileError(f"controller {self.name!r}: its delay must not be negative, as {self.delay}")

    def call(self, t: float, inputs: Any, state: Any) -> tuple[list[float], str]:
        """Outputs, and a sentence if it failed: what it raised or returned."""
        try:
            answer = self.function(t, inputs, state, self.parameters)
        except KeyboardInterrupt:
            raise
        except BaseException as error:  # noqa: BLE001 - a user's code may raise anything, SystemExit too
            return [], self._sentence(t, f"raised {type(error).__name__}: {error}", _where(error))
        try:
            found = [float(x) for x in (answer if np.ndim(answer) else [answer])]
        except (TypeError, ValueError):
            return [], self._sentence(t, f"returned {answer!r}, which is not a list of numbers")
        if len(found) != len(self.outputs):
            return [], self._sentence(t, f"returned {len(found)} numbers for {len(self.outputs)} outputs")
        bad = [
            f"{x} for {name!r}" for x, name in zip(found, self.outputs, strict=True) if not math.isfinite(x)
        ]
        return found, self._sentence(t, f"returned {', '.join(bad)}") if bad else ""

    def _sentence(self, t: float, what: str, where: str = "") -> str:
        return f"the controller {self.name!r} {what} (t = {t:.6g} s{where})"


def _where(error: BaseException) -> str:
    """File and line in which an exception was raised."""
    last = traceback.extract_tb(error.__traceback__)[-1]
    return f", {Path(last.filename).name}, line {last.lineno}"


def sampled_pid(
    t: float, inputs: Sequence[float], state: dict[str, Any], parameters: dict[str, float]
) -> float:
    """PID in the form of a digital controller: backward differences, clamped, with conditional integration.

    Parameters
    ----------
    t
        Time [s].
    inputs
        The control error.
    state
        {"integral": 0.0, "error": None}: the error of the call before, None at the first.
    parameters
        kp, ki, kd, period; low and high if the output has limits.
    """
    e = float(inputs[0])
    h = parameters["period"]
    low, high = parameters.get("low", -math.inf), parameters.get("high", math.inf)
    integral = state["integral"] + parameters.get("ki", 0.0) * h * e
    before = e if state["error"] is None else state["error"]
    u = parameters.get("kp", 0.0) * e + integral + parameters.get("kd", 0.0) * (e - before) / h
    state["error"] = e
    limited = min(max(u, low), high)
    if u == limited or (u - limited) * e < 0.0:  # integrate only where it leads back
        state["integral"] = integral
    return limited
