# SPDX-License-Identifier: Apache-2.0
"""Blocks: signals made of other signals.

Values of signals and gains are numbers in SI units of both sides. They may have a unit
(`1500 rpm`, `2 N m s`): it converts the number to SI and is not checked.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.components.law import PythonLaw
from pitchpoint.model.components.sensor import UNITS
from pitchpoint.model.keys import choice, key, positive, quantities, quantity, text

INPUT = "name of the signal it is made of"
UNIT = "unit that results give the signal"
LEAST_AND_MOST = "minimum and maximum"


@dataclass(frozen=True, kw_only=True)
class Sum:
    """Sum of signals times gains, plus a constant."""

    form: ClassVar[str] = "sum"
    inputs: Mapping[str, float] = key("gains", "gain of every signal by its name: {speed: -1}", {})
    offset: float = key("value", "constant that is added", 0.0)
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class Limits:
    """A signal kept within limits."""

    form: ClassVar[str] = "limits"
    input: str = text(INPUT)
    limits: tuple[float, float] = key("values", LEAST_AND_MOST, length=(2, 2))


@dataclass(frozen=True, kw_only=True)
class Curve:
    """Straight lines between points over another signal, constant beyond the ends."""

    form: ClassVar[str] = "table"
    input: str = text(INPUT)
    points: tuple[tuple[float, float], ...] = key(
        "curve", "[input, value] of every point with rising input, or the name of a text file of two columns"
    )
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class FormulaBlock:
    """A formula of up to three signals; one of them may be the time t."""

    form: ClassVar[str] = "formula"
    formula: str = text("formula of the names of its inputs")
    inputs: tuple[str, ...] = key("names", "names of the signals that it uses, t for the time", length=(1, 3))
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class LawBlock:
    """A Python function f(t, x, parameters) of the time and another signal, evaluated in every step."""

    form: ClassVar[str] = "python"
    input: str = text(INPUT)
    function: PythonLaw = key("code", "FILE.py:function")
    parameters: tuple[float, ...] = quantities("dimensionless", "numbers handed to the function", ())
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class Integrator:
    """Integral of a signal over time."""

    form: ClassVar[str] = "integrator"
    input: str = text(INPUT)
    start: float = key("value", "value at the start, where the state of rest does not decide about it", 0.0)
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class Filter:
    """Low-pass filter of first order, or of second order where a damping ratio is given."""

    form: ClassVar[str] = "filter"
    input: str = text(INPUT)
    time_constant: float = positive("time", "T of T y' + y = x, or 1/omega_0 of second order")
    damping_ratio: float | None = quantity(
        "dimensionless", "damping ratio of second order", None, minimum=0.0, display="first order"
    )


@dataclass(frozen=True, kw_only=True)
class TransferFunction:
    """Rational transfer function."""

    form: ClassVar[str] = "transfer_function"
    input: str = text(INPUT)
    numerator: tuple[float, ...] = key("values", "factors of falling powers of s", length=(1, 30))
    denominator: tuple[float, ...] = key("values", "factors of falling powers of s", length=(2, 30))
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class Pid:
    """PID controller with filtered derivative; within limits its integral tracks what comes out."""

    form: ClassVar[str] = "pid"
    input: str = text("name of the control error")
    proportional: float = key("value", "gain of the error")
    integral: float = key("value", "gain of its integral", 0.0)
    derivative: float = key("value", "gain of its derivative", 0.0)
    filter_time: float = quantity(
        "time", "time constant of the derivative, which needs one", 0.0, minimum=0.0
    )
    limits: tuple[float, float] | None = key("values", LEAST_AND_MOST, None, length=(2, 2), display="none")
    tracking_time: float | None = positive(
        "time", "time in which the integral follows limits", None, display="from the gains"
    )
    unit: str = choice(UNITS, UNIT, "1")


Block: TypeAlias = (
    Sum | Limits | Curve | FormulaBlock | LawBlock | Integrator | Filter | TransferFunction | Pid
)

BLOCKS: dict[str, type] = {
    c.form: c for c in (Sum, Limits, Curve, FormulaBlock, LawBlock, Integrator, Filter, TransferFunction, Pid)
}
