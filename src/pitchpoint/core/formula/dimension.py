# SPDX-License-Identifier: Apache-2.0
"""Dimension check of formulas: dimension of the result, and contradictions between units.

Written units are checked, all other numbers are in SI units. The variables have units: t a time, angle an
angle, speed an angular speed, elongation a length and rate a speed. A number without unit is a dimensionless
factor of a written unit, has the unit of the other operand of a sum, and compensates the seconds of a
variable that it multiplies, so that ``150 N m * (1 + 0.1*sin(157*t))`` is a torque and ``1.2 * 150 kg`` is
not. A formula without any unit is never refused.

Radians are dimensionless with the factor 1. Cycles are not: 25 Hz in a formula is the number 25 and needs the
factor 2*pi for an angle or an angular speed.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from pitchpoint.core.errors import UnitError
from pitchpoint.core.formula.language import (
    ABS,
    ADD,
    COS,
    DIV,
    FLOOR,
    FUNCTIONS,
    MAX,
    MIN,
    MOD,
    MUL,
    NEG,
    POW,
    SIGN,
    SIN,
    SQRT,
    STEP,
    SUB,
    TAN,
)
from pitchpoint.core.unit_expression import parse_unit
from pitchpoint.core.unit_table import DIMENSIONS

VARIABLES = {
    "t": (0.0, 1.0),
    "angle": (0.0, 0.0),
    "speed": (0.0, -1.0),
    "elongation": (1.0, 0.0),
    "rate": (1.0, -1.0),
}
"""Exponents of metre and second in the unit of each known variable; radians are 1."""

Base = tuple[float, float, float]
_CLOSE = 1e-6
_MAX_POWER = 1e3
_NUMBER = "a plain number or an angle"
_WORDS = {op: name for name, (op, _) in FUNCTIONS.items()} | {ADD: "+", SUB: "-", POW: "^"}


class CycleError(UnitError):
    """Cycles in place of radians."""


class RadianError(UnitError):
    """Radians in place of cycles."""


class Kind(NamedTuple):
    """Known dimension of a part of a formula.

    The exponent of the second is ``s`` plus that of the variables; with a number without unit it may have any
    value from ``s + falling`` to ``s + rising``.
    """

    base: Base = (0.0, 0.0, 0.0)  # exponents of m, kg, K
    s: float = 0.0  # exponent of the second from written units
    rising: float = 0.0  # positive exponents of the second from variables
    falling: float = 0.0  # negative exponents of the second from variables
    written: bool = False  # contains a unit
    bare: bool = False  # has a factor without unit, which may have any dimension
    loose: bool = False  # a number without unit may compensate the seconds of variables
    cycles: float = 0.0  # exponent of the cycle (Hz)
    turned: bool = False  # has a factor that converts cycles to radians: pi, an angle
    rad: float = 0.0  # exponent of the radian from written units
    named: bool = False  # contains a named constant, next to which a number without unit is a plain number

    @property
    def seconds(self) -> tuple[float, float]:
        """Minimum and maximum exponent of the second."""
        if self.loose:
            return self.s + self.falling, self.s + self.rising
        both = self.s + self.rising + self.falling
        return both, both

    @property
    def open_cycles(self) -> float:
        """Exponent of cycles that are not converted to radians."""
        return 0.0 if self.turned else self.cycles

    @property
    def anything(self) -> bool:
        """Whether the dimension is arbitrary because of a number without unit."""
        return self.bare and not self.named and (not self.written or self.fits(PLAIN))

    def fits(self, other: Kind) -> bool:
        """Whether both can have the same dimension."""
        low, high = self.seconds
        other_low, other_high = other.seconds
        return (
            all(abs(a - b) < _CLOSE for a, b in zip(self.base, other.base, strict=True))
            and low < other_high + _CLOSE
            and other_low < high + _CLOSE
        )


PLAIN = Kind()
ANYTHING = Kind(bare=True, loose=True)


def of_number(value: float, unit: str) -> Kind:
    """Kind of a number: dimension of its unit, arbitrary without unit.

    Parameters
    ----------
    value
        Value in SI units.
    unit
        Unit as written; empty for none.

    Examples
    --------
    >>> unit_text(of_number(150.0, "kN mm"))
    'N m'
    """
    if not unit:
        turns = value / math.pi
        return ANYTHING._replace(turned=round(turns) in (1, 2) and abs(turns - round(turns)) < 2e-3)
    u = parse_unit(unit)
    return Kind(
        (float(u.m), float(u.kg), float(u.K)),
        float(u.s),
        written=True,
        cycles=float(u.cycle),
        turned=u.rad + u.rev != 0,
        rad=float(u.rad + u.rev),
    )


def of_variable(name: str) -> Kind:
    """Kind of a variable; arbitrary for an unknown name."""
    if name not in VARIABLES:
        return ANYTHING
    m, s = VARIABLES[name]
    return Kind((m, 0.0, 0.0), rising=max(s, 0.0), falling=min(s, 0.0), turned=name in ("angle", "speed"))


def combine(op: int, kinds: list[Kind], exponent: float | None = None) -> Kind:
    """Kind of the result of an operation.

    Parameters
    ----------
    op
        Operation code.
    kinds
        Kinds of the operands.
    exponent
        Value of a constant exponent, for a power.

    Raises
    ------
    UnitError
        If written units contradict each other.
    """
    if op in (NEG, ABS, FLOOR):
        return kinds[0]
    if op == MUL:
        return _product(kinds[0], kinds[1])
    if op == DIV:
        return _product(kinds[0], _raised(kinds[1], -1.0))
    if op == SQRT:
        return _raised(kinds[0], 0.5)
    if op == POW:
        return _power(kinds[0], kinds[1], exponent)
    if op in (SIGN, STEP):
        return PLAIN
    if len(kinds) > 1:
        same = kinds[0]
        for kind in kinds[1:]:
            same = _same(op, same, kind)
        return same if op in (ADD, SUB, MIN, MAX, MOD) else PLAIN
    _needs_number(_WORDS[op], kinds[0])
    if op in (SIN, COS, TAN) and kinds[0].written and kinds[0].open_cycles:
        raise CycleError(f"argument of '{_WORDS[op]}' is in cycles, not radians: Hz needs the factor 2*pi")
    return PLAIN


def check_result(kind: Kind, dimension: str) -> None:
    """Raise an error if the units of a formula give a different dimension.

    Parameters
    ----------
    kind
        Kind of the whole formula.
    dimension
        Name of a row of `DIMENSIONS`.

    Raises
    ------
    UnitError
        If the written units are incompatible with the dimension.
    """
    wanted = DIMENSIONS[dimension]
    m, kg, s, kelvin = (float(p) for p in wanted.base)
    if not kind.written:
        return
    if not kind.anything and not kind.fits(Kind((m, kg, kelvin), s)):
        si = wanted.si or _NUMBER
        raise UnitError(
            f"its units give {unit_text(kind)}, not {si} ({wanted.words} such as {wanted.example})"
        )
    if dimension in ("angle", "angular_speed") and kind.open_cycles:
        raise CycleError(f"its units give cycles, not {wanted.si}: Hz needs the factor 2*pi")
    if dimension == "frequency" and kind.rad - kind.cycles > 0.5:
        raise RadianError("its units give rad/s, not Hz: an angular speed is divided by 1 rev")


def unit_text(kind: Kind) -> str:
    """SI unit of a kind, in newtons if that is shorter.

    Examples
    --------
    >>> unit_text(of_number(1.0, "MPa")), unit_text(of_number(1.0, "g mm^2"))
    ('N/m^2', 'kg m^2')
    """
    m, kg, kelvin = kind.base
    # with a number without unit, use the written units only
    s = kind.s if kind.loose and kind.written else kind.s + kind.rising + kind.falling
    with_kg = {"kg": kg, "m": m, "s": s, "K": kelvin}
    with_newton = {"N": kg, "m": m - kg, "s": s + 2.0 * kg, "K": kelvin}
    powers = min(with_kg, with_newton, key=lambda p: sum(abs(v) for v in p.values()))
    return _quotient(powers) or _NUMBER


def readable(unit: str) -> str:
    """Unit of an amount as it is usually written.

    Examples
    --------
    >>> readable("kg m^2 s^-2 rad^-1"), readable("s^-1 rad"), readable("")
    ('N m/rad', 'rad/s', '')
    """
    if not unit:
        return ""
    kind = of_number(1.0, unit)
    kg, m, s = kind.base[1], kind.base[0], kind.s + kind.cycles
    rest = {"K": kind.base[2], "Hz": kind.cycles, "rad": kind.rad}
    with_kg = {"kg": kg, "m": m, "s": s, **rest}
    with_newton = {"N": kg, "m": m - kg, "s": s + 2.0 * kg, **rest}
    return _quotient(min(with_kg, with_newton, key=lambda p: sum(abs(v) for v in p.values())))


def _quotient(powers: Mapping[str, float]) -> str:
    """Product of the units with positive powers over that of the others."""
    above = " ".join(_powered(n, p) for n, p in powers.items() if p > _CLOSE)
    below = " ".join(_powered(n, -p) for n, p in powers.items() if p < -_CLOSE)
    if not below:
        return above
    return f"{above or '1'}/{f'({below})' if ' ' in below else below}"


def of_amount(value: float, unit: str) -> Kind:
    """Kind of a named constant; without unit it is a plain number, unlike a number in a formula.

    Parameters
    ----------
    value
        Value in SI units.
    unit
        SI unit, as `si_unit` writes it.
    """
    kind = of_number(value, unit)
    return (kind if unit else PLAIN._replace(written=True, turned=kind.turned))._replace(named=True)


def si_unit(kind: Kind) -> str:
    """SI unit of the result of a formula without variables, with radians and cycles.

    A factor pi or an angle makes radians of cycles.

    Examples
    --------
    >>> si_unit(of_number(1.0, "rpm")), si_unit(of_number(1.0, "N/mm")), si_unit(of_number(25.0, "Hz"))
    ('s^-1 rad', 'kg s^-2', 'Hz')
    """
    m, kg, kelvin = kind.base
    cycles = kind.open_cycles
    rad = kind.rad + kind.cycles - cycles
    powers = {"kg": kg, "m": m, "s": kind.s + cycles, "K": kelvin, "Hz": cycles, "rad": rad}
    return " ".join(_powered(n, p) for n, p in powers.items() if abs(p) > _CLOSE)


def _powered(name: str, power: float) -> str:
    return name if abs(power - 1.0) < _CLOSE else f"{name}^{power:.4g}"


def _product(a: Kind, b: Kind) -> Kind:
    return Kind(
        (a.base[0] + b.base[0], a.base[1] + b.base[1], a.base[2] + b.base[2]),
        a.s + b.s,
        a.rising + b.rising,
        a.falling + b.falling,
        a.written or b.written,
        a.bare or b.bare,
        a.loose or b.loose,
        a.cycles + b.cycles,
        a.turned or b.turned,
        a.rad + b.rad,
        a.named or b.named,
    )


def _raised(a: Kind, power: float) -> Kind:
    m, kg, kelvin = a.base
    rising, falling = sorted((a.rising * power, a.falling * power), reverse=True)
    return a._replace(
        base=(m * power, kg * power, kelvin * power),
        s=a.s * power,
        rising=rising,
        falling=falling,
        cycles=a.cycles * power,
        rad=a.rad * power,
    )


def _power(a: Kind, exponent: Kind, value: float | None) -> Kind:
    _needs_number("an exponent", exponent)
    if value is not None and abs(value) <= _MAX_POWER:
        return _raised(a, value)
    _needs_number("the base of a power with a varying exponent", a)
    return ANYTHING


def _needs_number(what: str, kind: Kind) -> None:
    """Raise an error if a plain number is required and a written dimension given."""
    if kind.written and not kind.anything and not kind.fits(PLAIN):
        name = what if " " in what else f"'{what}'"
        raise UnitError(f"{name} needs {_NUMBER}, not {unit_text(kind)}")


def _same(op: int, a: Kind, b: Kind) -> Kind:
    """Common kind of two operands of the same dimension, as in a sum."""
    cycles = a.open_cycles or b.open_cycles
    kind = _firm(op, a, b)
    named = a.named or b.named
    return kind._replace(cycles=cycles, turned=a.turned and b.turned and not cycles, named=named)


def _firm(op: int, a: Kind, b: Kind) -> Kind:
    if a.anything and b.anything:
        return _hull(a, b)
    if not a.written and not b.written:
        if a.bare or b.bare:
            # a number added to a variable has its unit, or may be a plain number
            return (b if a.bare else a)._replace(loose=True)
        # no error without units
        return _hull(a, b)._replace(bare=not a.fits(b))
    if a.anything or b.anything:
        return b if a.anything else a
    if not a.fits(b):
        raise UnitError(f"'{_WORDS[op]}' joins {unit_text(a)} and {unit_text(b)}")
    # the more definite one; then the one with variables, whose seconds a factor may still compensate
    firm = min(a, b, key=lambda k: (k.loose, not (k.rising or k.falling)))
    return firm._replace(written=True, bare=a.bare and b.bare)


def _hull(a: Kind, b: Kind) -> Kind:
    """Kind that includes either of two kinds without unit."""
    (a_low, a_high), (b_low, b_high) = a.seconds, b.seconds
    if (a_low, a_high) == (b_low, b_high) and not (a.loose or b.loose):
        return a
    return Kind(
        rising=max(a_high, b_high, 0.0),
        falling=min(a_low, b_low, 0.0),
        written=a.written or b.written,
        bare=a.bare and b.bare,
        loose=True,
    )
