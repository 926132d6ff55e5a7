# SPDX-License-Identifier: Apache-2.0
"""Dimensions inside formulas: what the units of a formula give, and what cannot be right.

Written units are checked, everything else is SI. The variables carry their units: t a time, angle an angle,
speed an angular speed, elongation a length and rate a speed. A number without unit is a plain factor next
to a written unit, takes the unit of the other side of a sum, and supplies the seconds that a variable next to
it needs, so that ``150 N m * (1 + 0.1*sin(157*t))`` is a torque and ``1.2 * 150 kg`` is not. A formula
without any unit is never refused.

Radians count as 1. Cycles do not: 25 Hz in a formula is the number 25, so it needs 2*pi where an angle or an
angular speed is wanted.
"""

from __future__ import annotations

import math
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
from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.core.units import parse_unit

VARIABLES = {
    "t": (0.0, 1.0),
    "angle": (0.0, 0.0),
    "speed": (0.0, -1.0),
    "elongation": (1.0, 0.0),
    "rate": (1.0, -1.0),
}
"""Powers of metre and second in the unit of each known variable; radians count as 1."""

Base = tuple[float, float, float]
_CLOSE = 1e-6
_MAX_POWER = 1e3
_NUMBER = "a plain number or an angle"
_WORDS = {op: name for name, (op, _) in FUNCTIONS.items()} | {ADD: "+", SUB: "-", POW: "^"}


class CycleError(UnitError):
    """Cycles are given where radians are expected."""


class Kind(NamedTuple):
    """What is known of the dimension of a part of a formula.

    The power of the second is ``s`` plus what the variables bring; next to a number without unit it may be
    anything between ``s + falling`` and ``s + rising``.
    """

    base: Base = (0.0, 0.0, 0.0)  # powers of m, kg, K
    s: float = 0.0  # power of the second by written units
    rising: float = 0.0  # seconds from variables with a positive power
    falling: float = 0.0  # the same with a negative power
    written: bool = False  # holds a unit
    bare: bool = False  # has a factor without unit, which may have any dimension
    loose: bool = False  # a number without unit may have supplied the seconds of variables
    cycles: float = 0.0  # power of the cycle (Hz)
    turned: bool = False  # has a factor that makes radians of cycles: pi, an angle

    @property
    def seconds(self) -> tuple[float, float]:
        """Minimum and maximum power of the second."""
        if self.loose:
            return self.s + self.falling, self.s + self.rising
        both = self.s + self.rising + self.falling
        return both, both

    @property
    def open_cycles(self) -> float:
        """Cycles that nothing turned into radians."""
        return 0.0 if self.turned else self.cycles

    @property
    def anything(self) -> bool:
        """Whether a number without unit gives the dimension."""
        return self.bare and (not self.written or self.fits(PLAIN))

    def fits(self, other: Kind) -> bool:
        """Whether both can be the same dimension."""
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
    """Kind of a number: of its unit, or anything without one.

    Parameters
    ----------
    value
        The number in SI.
    unit
        Its unit as written; empty for none.

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
    )


def of_variable(name: str) -> Kind:
    """Kind of a variable; one that is not known may be anything."""
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
        Value of the second operand of a power if it is a constant.

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
        raise CycleError(f"'{_WORDS[op]}' is given cycles, not radians: Hz needs the factor 2*pi")
    return PLAIN


def check_result(kind: Kind, dimension: str) -> None:
    """Refuse a formula whose units certainly give another dimension.

    Parameters
    ----------
    kind
        Kind of the whole formula.
    dimension
        Name of a row of `DIMENSIONS`.

    Raises
    ------
    UnitError
        If the written units fit nothing but another dimension.
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


def unit_text(kind: Kind) -> str:
    """SI unit of a kind, with newtons where that is shorter.

    Examples
    --------
    >>> unit_text(of_number(1.0, "MPa")), unit_text(of_number(1.0, "g mm^2"))
    ('N/m^2', 'kg m^2')
    """
    m, kg, kelvin = kind.base
    # next to a number without unit, the written units alone are more exact
    s = kind.s if kind.loose and kind.written else kind.s + kind.rising + kind.falling
    with_kg = {"kg": kg, "m": m, "s": s, "K": kelvin}
    with_newton = {"N": kg, "m": m - kg, "s": s + 2.0 * kg, "K": kelvin}
    powers = min(with_kg, with_newton, key=lambda p: sum(abs(v) for v in p.values()))
    above = " ".join(_powered(n, p) for n, p in powers.items() if p > _CLOSE)
    below = " ".join(_powered(n, -p) for n, p in powers.items() if p < -_CLOSE)
    if not below:
        return above or _NUMBER
    return f"{above or '1'}/{f'({below})' if ' ' in below else below}"


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
    )


def _power(a: Kind, exponent: Kind, value: float | None) -> Kind:
    _needs_number("an exponent", exponent)
    if value is not None and abs(value) <= _MAX_POWER:
        return _raised(a, value)
    _needs_number("the base of a power with a varying exponent", a)
    return ANYTHING


def _needs_number(what: str, kind: Kind) -> None:
    """Refuse a written dimension where only a number makes sense."""
    if kind.written and not kind.anything and not kind.fits(PLAIN):
        name = what if " " in what else f"'{what}'"
        raise UnitError(f"{name} needs {_NUMBER}, not {unit_text(kind)}")


def _same(op: int, a: Kind, b: Kind) -> Kind:
    """Kind of two operands that must agree, as in a sum."""
    cycles = a.open_cycles or b.open_cycles
    kind = _firm(op, a, b)
    return kind._replace(cycles=cycles, turned=a.turned and b.turned and not cycles)


def _firm(op: int, a: Kind, b: Kind) -> Kind:
    if a.anything and b.anything:
        return _hull(a, b)
    if not a.written and not b.written:
        if a.bare or b.bare:
            # a number next to a variable takes its unit, but may just as well be meant as a plain number
            return (b if a.bare else a)._replace(loose=True)
        # without units nothing is refused
        return _hull(a, b)._replace(bare=not a.fits(b))
    if a.anything or b.anything:
        return b if a.anything else a
    if not a.fits(b):
        raise UnitError(f"'{_WORDS[op]}' joins {unit_text(a)} and {unit_text(b)}")
    # the more definite one; then the one with variables, whose seconds a factor may still supply
    firm = min(a, b, key=lambda k: (k.loose, not (k.rising or k.falling)))
    return firm._replace(written=True, bare=a.bare and b.bare)


def _hull(a: Kind, b: Kind) -> Kind:
    """Kind that may be either of two numbers without unit."""
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
