# SPDX-License-Identifier: Apache-2.0
"""Signal blocks: signals computed from other signals.

Signal values and gains are numbers in SI units. They may have a unit (`1500 rpm`, `2 N m s`), which
converts the number to SI but is not checked.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, TypeAlias, get_args

from pitchpoint.model.component import Component
from pitchpoint.model.components.law import PythonLaw
from pitchpoint.model.components.sensor import UNITS
from pitchpoint.model.keys import choice, key, positive, quantities, quantity, text

INPUT = "name of the input signal"
UNIT = "unit of the signal in results"
MIN_AND_MAX = "minimum and maximum"


@dataclass(frozen=True, kw_only=True)
class Sum(Component):
    """Weighted sum of signals, plus a constant."""

    form: ClassVar[str] = "sum"
    inputs: Mapping[str, float] = key("gains", "gain of each input signal, by name: {speed: -1}", {})
    offset: float = key("value", "constant added to the sum", 0.0)
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class Limits(Component):
    """Saturation: limits a signal."""

    form: ClassVar[str] = "limits"
    input: str = text(INPUT)
    limits: tuple[float, float] = key("values", MIN_AND_MAX, length=(2, 2))


@dataclass(frozen=True, kw_only=True)
class Curve(Component):
    """Lookup table: linear interpolation, constant extrapolation."""

    form: ClassVar[str] = "table"
    input: str = text(INPUT)
    points: tuple[tuple[float, float], ...] = key(
        "curve", "points [input, value] with increasing input, or the name of a text file of two columns"
    )
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class FormulaBlock(Component):
    """A formula of up to three signals; one of them may be the time t."""

    form: ClassVar[str] = "formula"
    formula: str = key("formula", "formula of the input names")
    inputs: tuple[str, ...] = key("names", "names of the input signals; t is the time", length=(1, 3))
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class LawBlock(Component):
    """A Python function f(t, x, parameters) of the time and an input signal, evaluated in every step."""

    form: ClassVar[str] = "python"
    input: str = text(INPUT)
    function: PythonLaw = key("code", "FILE.py:function")
    parameters: tuple[float, ...] = quantities("dimensionless", "numbers passed to the function", ())
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class Integrator(Component):
    """Integral of a signal over time."""

    form: ClassVar[str] = "integrator"
    input: str = text(INPUT)
    start: float = key("value", "initial value, unless the initial equilibrium determines it", 0.0)
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class Filter(Component):
    """First-order low-pass filter; second-order if a damping ratio is given."""

    form: ClassVar[str] = "filter"
    input: str = text(INPUT)
    time_constant: float = positive("time", "first order: T of T y' + y = x; second order: 1/omega_0")
    damping_ratio: float | None = quantity(
        "dimensionless", "damping ratio of the second-order filter", None, minimum=0.0, display="first order"
    )


@dataclass(frozen=True, kw_only=True)
class RateLimit(Component):
    """First-order lag with limited rate, such as the torque of a converter or a pitch drive."""

    form: ClassVar[str] = "rate_limit"
    input: str = text(INPUT)
    rate: float = key("value", "largest rate of the output in both directions, per second")
    time_constant: float = positive("time", "T of T y' + y = x, below the largest rate")
    start: float = key("value", "initial value, unless the initial equilibrium determines it", 0.0)


@dataclass(frozen=True, kw_only=True)
class DryFriction(Component):
    """Dry friction of a brake per unit of capacity, opposite to the slip: sticks, then slips with 1 or -1."""

    form: ClassVar[str] = "friction"
    input: str = text("name of the slip speed")
    wind_up: float = key("value", "angle of twist or displacement at the capacity", 1e-3)
    holding: float = quantity(
        "dimensionless",
        "fraction of the capacity below which the brake sticks without creep",
        0.8,
        minimum=0.0,
        maximum=1.0,
        below=True,
        sample="0.8",
    )
    damping_time: float = quantity("time", "ratio of damping to stiffness before slip", 1e-3, minimum=0.0)


@dataclass(frozen=True, kw_only=True)
class Input(Component):
    """Input of the model, such as a command or the voltage of the grid; scenarios give its course."""

    form: ClassVar[str] = "input"
    value: float = key("value", "value in scenarios that do not give another one", 0.0)
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class TransferFunction(Component):
    """Rational transfer function."""

    form: ClassVar[str] = "transfer_function"
    input: str = text(INPUT)
    numerator: tuple[float, ...] = key("values", "coefficients of descending powers of s", length=(1, 30))
    denominator: tuple[float, ...] = key("values", "coefficients of descending powers of s", length=(2, 30))
    unit: str = choice(UNITS, UNIT, "1")


@dataclass(frozen=True, kw_only=True)
class Pid(Component):
    """Continuous PID controller with filtered derivative and back-calculation as anti-windup."""

    form: ClassVar[str] = "pid"
    input: str = text("name of the control error")
    proportional: float = key("value", "proportional gain")
    integral: float = key("value", "integral gain", 0.0)
    derivative: float = key("value", "derivative gain", 0.0)
    filter_time: float = quantity(
        "time", "time constant of the derivative filter, required with derivative", 0.0, minimum=0.0
    )
    limits: tuple[float, float] | None = key("values", MIN_AND_MAX, None, length=(2, 2), display="none")
    tracking_time: float | None = positive(
        "time", "tracking time constant of the anti-windup", None, display="from the gains"
    )
    unit: str = choice(UNITS, UNIT, "1")


Block: TypeAlias = (
    Sum
    | Limits
    | Curve
    | FormulaBlock
    | LawBlock
    | Integrator
    | Filter
    | RateLimit
    | DryFriction
    | Input
    | TransferFunction
    | Pid
)

BLOCKS: dict[str, type] = {c.form: c for c in get_args(Block)}
