# SPDX-License-Identifier: Apache-2.0
"""Units of REXS and their conversion to SI units and radians."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from pitchpoint.core.errors import UnitError

_MILLI, _MICRO = Fraction(1, 1000), Fraction(1, 10**6)


@dataclass(frozen=True)
class RexsUnit:
    """Unit: dimension as an SI unit, factor, and offset in SI units (of degrees Celsius)."""

    si: str
    factor: Fraction | float = Fraction(1)
    offset: Fraction = Fraction(0)

    def to_si(self, value: Fraction | float) -> float:
        """Value in SI units; exact for fractions, so that 4.5 mm is the number nearest to 0.0045."""
        return float(value * self.factor + self.offset)

    def from_si(self, value: float) -> float:
        """Value in this unit."""
        return float((Fraction(repr(float(value))) - self.offset) / Fraction(self.factor))


def _table() -> dict[str, RexsUnit]:
    of = RexsUnit
    return {
        "none": of("1"),
        "%": of("1", Fraction(1, 100)),
        "mm": of("m", _MILLI),
        "mum": of("m", _MICRO),
        "mm^2": of("m^2", _MICRO),
        "m^2": of("m^2"),
        "1 / mm": of("1/m", Fraction(1000)),
        "m / s": of("m/s"),
        "m / s^2": of("m/s^2"),
        "mm / h": of("m/s", _MILLI / 3600),
        "m^3 / s": of("m^3/s"),
        "l / min": of("m^3/s", _MILLI / 60),
        "mm^2 / s": of("m^2/s", _MICRO),
        "deg": of("rad", math.pi / 180.0),
        "°": of("rad", math.pi / 180.0),
        "rad": of("rad"),
        "rad / s": of("rad/s"),
        "1 / min": of("rad/s", math.pi / 30.0),
        "Hz": of("Hz"),
        "s": of("s"),
        "h": of("s", Fraction(3600)),
        "kg": of("kg"),
        "mg": of("kg", _MICRO),
        "kg / mm": of("kg/m", Fraction(1000)),
        "kg m^2": of("kg m^2"),
        "kg / dm^3": of("kg/m^3", Fraction(1000)),
        "N": of("N"),
        "kN": of("N", Fraction(1000)),
        "N m": of("N m"),
        "N / m": of("N/m"),
        "N / mm": of("N/m", Fraction(1000)),
        "N / (mm mum)": of("N/m^2", Fraction(10**9)),
        "N / rad": of("N/rad"),
        "N mm / rad": of("N m/rad", _MILLI),
        "Pa": of("Pa"),
        "MPa": of("Pa", Fraction(10**6)),
        "N / mm^2": of("Pa", Fraction(10**6)),
        "(N / mm^2)^0.5": of("Pa^0.5", Fraction(1000)),
        "mm^2 / N": of("1/Pa", _MICRO),
        "mPa s": of("Pa s", _MILLI),
        "W": of("W"),
        "kW": of("W", Fraction(1000)),
        "W / mm": of("W/m", Fraction(1000)),
        "K": of("K"),
        "C": of("K", Fraction(1), Fraction("273.15")),
        "1e-6 / C": of("1/K", _MICRO),
        "W / (m K)": of("W/(m K)"),
        "W / (m^2 K)": of("W/(m^2 K)"),
        "J / (kg K)": of("J/(kg K)"),
        "K m^2 / W": of("K m^2/W"),
        # units of hardness, wear and electrical data: kept as they are
        **{
            name: of(name)
            for name in (
                *("HB", "HRC", "HV", "MRev", "1e-6 mm^3 / (N m)", "N / (mm s^0.5 K)"),
                *("K (m / s)^0.75 mm^1.75 / W", "Ohm", "pF", "pS / m", "V", "V / m"),
            )
        },
    }


UNITS = _table()
"""Units of all versions."""


def unit_of(name: str) -> RexsUnit:
    """Unit of REXS by its name.

    Parameters
    ----------
    name
        Name, such as "N mm / rad"; blanks do not matter, an empty one is "none".

    Raises
    ------
    UnitError
        If REXS has no such unit.

    Examples
    --------
    >>> unit_of("N mm / rad").to_si(1e15), unit_of("C").to_si(20), unit_of("mum").to_si(3)
    (1000000000000.0, 293.15, 3e-06)
    """
    found = UNITS.get(name) or _PLAIN.get("".join(name.split()) or "none")
    if found is None:
        from pitchpoint.core.nearest import did_you_mean

        guess = did_you_mean(name, UNITS)
        raise UnitError(f"{name[:40]!r} is not a unit of REXS; {guess}REXS writes units as in 'N mm / rad'")
    return found


_PLAIN = {"".join(name.split()): unit for name, unit in UNITS.items()}
