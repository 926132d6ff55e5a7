# SPDX-License-Identifier: Apache-2.0
"""Units of measured channels: known units are converted to SI, all others remain unchanged."""

from __future__ import annotations

import re
from functools import lru_cache

from pitchpoint.core.errors import UnitError
from pitchpoint.core.unit_expression import parse_unit
from pitchpoint.core.unit_table import DIMENSIONS, Unit
from pitchpoint.core.units import TWO_PI

_PREFERRED = """
    length angle mass time angular_speed angular_acceleration speed acceleration force torque power pressure
    stiffness torsional_stiffness damping torsional_damping density inertia temperature_difference
""".split()
_PLAIN = ("", "1", "-", "–", "none", "dimensionless")
_AMBIGUOUS = ("g", "G", "C", "F", "U", "r", "h", "t")
"""Ambiguous units: g of a sensor mostly means 9.80665 m/s^2, not gram."""
_ENERGY = re.compile(r"(?:^|[^a-zA-Z])[kMmµu]?J\b|W\s*[·*]?\s*s\b")
_QUANTITY = re.compile(r"\s*([+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)\s*((?!/).*)", re.DOTALL)


@lru_cache(maxsize=512)
def is_unit(text: str) -> bool:
    """Whether a text in brackets is a unit instead of a part of the name.

    Examples
    --------
    >>> is_unit("m/s^2"), is_unit("g"), is_unit("V"), is_unit("front")
    (True, True, True, False)
    """
    if text in _PLAIN or text in _AMBIGUOUS or text in ("V", "mV", "A", "mA", "dB", "dBA", "°C", "degC"):
        return True
    try:
        parse_unit(text)
    except UnitError:
        return False
    return True


@lru_cache(maxsize=512)
def to_si(text: str) -> tuple[str, float, bool]:
    """SI unit, factor to it, and whether the unit is known; unknown units have the factor 1.

    A leading number is a factor: `50 m/s^2` is the quantity for a value of 1 in the file. Temperatures,
    decibels and volts are not converted, nor are ambiguous units: g may be a gram or the acceleration of
    gravity (write 9.80665 m/s^2), 1/min may count any events (write rpm).

    Examples
    --------
    >>> to_si("kN"), to_si("mm/s"), to_si("50 m/s^2"), to_si("g")
    (('N', 1000.0, True), ('m/s', 0.001, True), ('m/s^2', 50.0, True), ('g', 1.0, False))
    >>> [to_si(text)[0] for text in ("kN m", "mJ", "rpm", "Hz", "%", "1/s", "mm^2/s", "")]
    ['N m', 'J', 'rad/s', 'Hz', '1', '1/s', 'm^2/s', '']
    """
    found = _QUANTITY.fullmatch(text.strip())
    if text.strip() in _PLAIN:
        return "1" if text.strip() else "", 1.0, True
    number, unit = (float(found[1]), found[2]) if found else (1.0, text.strip())
    unit = re.sub(r"\s+since\s.*$", "", unit)
    if unit in _PLAIN:
        return "1" if unit else "", number, True
    if unit in _AMBIGUOUS or re.fullmatch(r"1?\s*/\s*min|min\s*\^?-1", unit):
        return unit, number, False
    try:
        known = parse_unit(unit)
    except UnitError:
        return unit, number, False
    factor = float(known.factor) * (TWO_PI**known.rev)
    return _name(known, unit), number * factor, True


def _name(unit: Unit, text: str) -> str:
    """SI unit for these exponents, in the notation of `DIMENSIONS`."""
    base, turns = (unit.m, unit.kg, unit.s, unit.K), unit.rad + unit.rev
    if base == (2, 1, -2, 0) and _ENERGY.search(text):
        return "J"
    if base == (0, 0, -1, 0) and turns == 0:
        return "Hz" if unit.cycle else "1/s"
    if not any(base) and turns == 0 and unit.cycle == 0:
        return "1"
    for name in _PREFERRED:
        row = DIMENSIONS[name]
        if row.base == base and turns in row.angle and unit.cycle == 0:
            return row.si
    powers = {"kg": unit.kg, "m": unit.m, "s": unit.s, "K": unit.K, "rad": turns, "cycle": unit.cycle}
    up = [f"{n}^{p}" if p != 1 else n for n, p in powers.items() if p > 0]
    down = [f"{n}^{-p}" if p != -1 else n for n, p in powers.items() if p < 0]
    below = f"({' '.join(down)})" if len(down) > 1 else "".join(down)
    return (" ".join(up) or "1") + (f"/{below}" if down else "")
