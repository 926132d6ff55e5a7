# SPDX-License-Identifier: Apache-2.0
"""Blocks: signals made of other signals. Gains are numbers in SI units of both sides."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.keys import key, positive, quantities, quantity, text

INPUT = "name of the signal it is made of"


@dataclass(frozen=True, kw_only=True)
class Sum:
    """Sum of signals times gains, plus a constant."""

    form: ClassVar[str] = "sum"
    inputs: tuple[str, ...] = key("names", "names of the signals", ())
    gains: tuple[float, ...] = quantities("dimensionless", "one gain for each signal", ())
    offset: float = quantity("dimensionless", "constant that is added", 0.0)


@dataclass(frozen=True, kw_only=True)
class Limits:
    """A signal kept within limits."""

    form: ClassVar[str] = "limits"
    input: str = text(INPUT)
    limits: tuple[float, float] = quantities("dimensionless", "least and greatest value", length=(2, 2))


@dataclass(frozen=True, kw_only=True)
class Curve:
    """Straight lines between points over another signal, constant beyond the ends."""

    form: ClassVar[str] = "table"
    input: str = text(INPUT)
    x: tuple[float, ...] = quantities("dimensionless", "values of the input, rising", length=(2, 10**6))
    y: tuple[float, ...] = quantities("dimensionless", "values of the signal", length=(2, 10**6))


@dataclass(frozen=True, kw_only=True)
class FormulaBlock:
    """A formula of up to three signals; one of them may be the time t."""

    form: ClassVar[str] = "formula"
    formula: str = text("formula of the names of its inputs")
    inputs: tuple[str, ...] = key("names", "names of the signals that it uses, t for the time", length=(1, 3))


@dataclass(frozen=True, kw_only=True)
class LawBlock:
    """A Python function f(t, x, parameters) of the time and another signal, evaluated in every step."""

    form: ClassVar[str] = "python"
    input: str = text(INPUT)
    function: str = text("file.py:function")
    parameters: tuple[float, ...] = quantities("dimensionless", "numbers handed to the function", ())


@dataclass(frozen=True, kw_only=True)
class Integrator:
    """Integral of a signal over time."""

    form: ClassVar[str] = "integrator"
    input: str = text(INPUT)
    start: float = quantity("dimensionless", "value at the start", 0.0)


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
    """Rational transfer function, from rest."""

    form: ClassVar[str] = "transfer_function"
    input: str = text(INPUT)
    numerator: tuple[float, ...] = quantities("dimensionless", "factors of falling powers of s")
    denominator: tuple[float, ...] = quantities("dimensionless", "factors of falling powers of s")


@dataclass(frozen=True, kw_only=True)
class Pid:
    """PID controller with filtered derivative; within limits its integral tracks what comes out."""

    form: ClassVar[str] = "pid"
    input: str = text("name of the control error")
    proportional: float = quantity("dimensionless", "gain of the error")
    integral: float = quantity("dimensionless", "gain of its integral", 0.0)
    derivative: float = quantity("dimensionless", "gain of its derivative", 0.0)
    filter_time: float = quantity("time", "time constant of the derivative", 0.0, minimum=0.0)
    limits: tuple[float, ...] = quantities("dimensionless", "least and greatest output", ())
    tracking_time: float | None = positive(
        "time", "time in which the integral follows limits", None, display="from the gains"
    )


Block: TypeAlias = (
    Sum | Limits | Curve | FormulaBlock | LawBlock | Integrator | Filter | TransferFunction | Pid
)

BLOCKS: dict[str, type] = {
    c.form: c for c in (Sum, Limits, Curve, FormulaBlock, LawBlock, Integrator, Filter, TransferFunction, Pid)
}
