# SPDX-License-Identifier: Apache-2.0
"""Tables of units and of dimensions.

Factors are exact fractions where possible, so that "159.66 mm" is converted to the double nearest to 0.15966.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from pitchpoint.core.errors import UnitError

ONE = Fraction(1)


class Unit(NamedTuple):
    """Unit: factor and exponents of metre, kilogram, second, kelvin, radian, revolution and cycle."""

    factor: Fraction | float
    m: int = 0
    kg: int = 0
    s: int = 0
    K: int = 0
    rad: int = 0
    rev: int = 0
    cycle: int = 0

    def times(self, other: Unit, power: int = 1) -> Unit:
        """Product with a power of another unit; a negative power divides."""
        try:
            factor = self.factor * other.factor**power
            float(factor)
        except (OverflowError, ZeroDivisionError):
            raise UnitError("the unit is too large or too small for a number") from None
        return Unit(factor, *(a + power * b for a, b in zip(self[1:], other[1:], strict=True)))


@dataclass(frozen=True)
class Dimension:
    """Dimension: exponents of SI units, permitted exponents of the radian, texts and display units."""

    words: str
    base: tuple[int, int, int, int]
    si: str
    example: str
    angle: tuple[int, ...] = (0,)
    # display units in ascending order: (minimum SI magnitude for the unit, unit text)
    display: tuple[tuple[float, str], ...] = ()


_POUND = Fraction("4.4482216152605")
"""Pound-force [N]."""
_PREFIX = {
    "": ONE,
    "n": Fraction(1, 10**9),
    "u": Fraction(1, 10**6),
    "µ": Fraction(1, 10**6),
    "m": Fraction(1, 1000),
    "k": Fraction(1000),
    "M": Fraction(10**6),
    "G": Fraction(10**9),
}
_PREFIXED = {
    "m": Unit(ONE, m=1),
    "g": Unit(Fraction("1e-3"), kg=1),
    "s": Unit(ONE, s=1),
    "N": Unit(ONE, m=1, kg=1, s=-2),
    "Pa": Unit(ONE, m=-1, kg=1, s=-2),
    "J": Unit(ONE, m=2, kg=1, s=-2),
    "W": Unit(ONE, m=2, kg=1, s=-3),
    "Hz": Unit(ONE, s=-1, cycle=1),
    "rad": Unit(ONE, rad=1),
}
PLAIN_UNITS: dict[str, Unit] = {
    "cm": Unit(Fraction("1e-2"), m=1),
    "dm": Unit(Fraction("1e-1"), m=1),
    "micron": Unit(Fraction("1e-6"), m=1),
    "in": Unit(Fraction("0.0254"), m=1),
    "inch": Unit(Fraction("0.0254"), m=1),
    "ft": Unit(Fraction("0.3048"), m=1),
    "t": Unit(Fraction(1000), kg=1),
    "lb": Unit(Fraction("0.45359237"), kg=1),
    "oz": Unit(Fraction("0.45359237") / 16, kg=1),
    "lbf": Unit(_POUND, m=1, kg=1, s=-2),
    "ozf": Unit(_POUND / 16, m=1, kg=1, s=-2),
    "kgf": Unit(Fraction("9.80665"), m=1, kg=1, s=-2),
    "kp": Unit(Fraction("9.80665"), m=1, kg=1, s=-2),
    "dyn": Unit(Fraction("1e-5"), m=1, kg=1, s=-2),
    "hp": Unit(550 * _POUND * Fraction("0.3048"), m=2, kg=1, s=-3),
    "PS": Unit(75 * Fraction("9.80665"), m=2, kg=1, s=-3),
    "min": Unit(Fraction(60), s=1),
    "h": Unit(Fraction(3600), s=1),
    "bar": Unit(Fraction(100000), m=-1, kg=1, s=-2),
    "mbar": Unit(Fraction(100), m=-1, kg=1, s=-2),
    "psi": Unit(_POUND / Fraction("0.0254") ** 2, m=-1, kg=1, s=-2),
    "ksi": Unit(1000 * _POUND / Fraction("0.0254") ** 2, m=-1, kg=1, s=-2),
    "K": Unit(ONE, K=1),
    "deg": Unit(math.pi / 180.0, rad=1),
    "°": Unit(math.pi / 180.0, rad=1),
    "arcmin": Unit(math.pi / 10800.0, rad=1),
    "arcsec": Unit(math.pi / 648000.0, rad=1),
    "gon": Unit(math.pi / 200.0, rad=1),
    "rev": Unit(ONE, rev=1),
    "turn": Unit(ONE, rev=1),
    "r": Unit(ONE, rev=1),  # in speeds only, see ONLY_IN_SPEEDS
    "U": Unit(ONE, rev=1),
    "rpm": Unit(Fraction(1, 60), s=-1, rev=1),
    "RPM": Unit(Fraction(1, 60), s=-1, rev=1),
    "cpm": Unit(Fraction(1, 60), s=-1, cycle=1),
    "%": Unit(Fraction("1e-2")),
    "ppm": Unit(Fraction("1e-6")),
    "mil": Unit(Fraction("0.0254") / 1000, m=1),
    "thou": Unit(Fraction("0.0254") / 1000, m=1),
    "sec": Unit(ONE, s=1),
    "krpm": Unit(Fraction(1000, 60), s=-1, rev=1),
    "rps": Unit(ONE, s=-1, rev=1),
}
UNITS: dict[str, Unit] = {
    p + n: u._replace(factor=u.factor * f) for p, f in _PREFIX.items() for n, u in _PREFIXED.items()
}
UNITS.update(PLAIN_UNITS)
WORDS: dict[str, Unit] = {
    "centimeter": UNITS["cm"],
    "centimetre": UNITS["cm"],
    "degree": UNITS["deg"],
    "revolution": UNITS["rev"],
    "minute": UNITS["min"],
    "hour": UNITS["h"],
    "radian": UNITS["rad"],
} | {
    prefix + word: UNITS[short + symbol]
    for prefix, short in (
        ("", ""), ("nano", "n"), ("micro", "u"), ("milli", "m"), ("kilo", "k"), ("mega", "M"), ("giga", "G"),
    )
    for word, symbol in (
        ("meter", "m"), ("metre", "m"), ("gram", "g"), ("second", "s"), ("newton", "N"), ("pascal", "Pa"),
        ("joule", "J"), ("watt", "W"), ("hertz", "Hz"),
    )
}  # fmt: skip
"""Unit names in words; lower case or capitalised, singular or plural."""
del UNITS["Grad"], UNITS["Mrad"], UNITS["krad"]  # gigaradians are not in use; "Grad" is the German degree
# Products written as one word, all unambiguous: "Nms" is N m s, and "mm", "ms" and "mN" are not affected.
# They are case-sensitive: MNm is not mNm.
JOINED: dict[str, tuple[str, ...]] = {
    f"{p}N{word}": (f"{p}N", *rest)
    for p in ("", "m", "k", "M")
    for word, rest in (
        ("m", ("m",)),
        ("mm", ("mm",)),
        ("cm", ("cm",)),
        ("s", ("s",)),
        ("ms", ("m", "s")),
        ("mms", ("mm", "s")),
    )
}
JOINED |= {mass + length: (mass, length) for mass in ("kg", "g") for length in ("m", "cm", "mm")}
del JOINED["gm"]  # obsolete symbol of gram
for _name, _factors in JOINED.items():
    UNITS[_name] = Unit(ONE)
    for _factor in _factors:
        UNITS[_name] = UNITS[_name].times(UNITS[_factor])

ONLY_IN_SPEEDS = ("r", "U")
"""Symbols of a revolution (r/min; German U/min) that are ambiguous except over a time."""
ZEROS = dict.fromkeys(("C", "degC", "°C"), 273.15)
"""Zero of the scales of temperature with one of their own [K]."""
_ZERO_POINT = "a temperature is given as a difference in K"
REFUSED: dict[str, str] = {
    **dict.fromkeys(ZEROS, _ZERO_POINT),
    **dict.fromkeys(
        ("F", "degF", "°F"), "write a temperature in degC or K, a difference of temperatures in K"
    ),
    **dict.fromkeys(("grad", "Grad"), "write deg for degrees, gon for hundredths of a right angle"),
    **dict.fromkeys(("ton", "tons"), "write t for 1000 kg, or the weight in kg or lb"),
}
"""Ambiguous names, and their remedy."""
FORCE_OF_MASS = {"lb": "lbf", "oz": "ozf", "kg": "N or kgf", "g": "N", "t": "kN"}
"""Units of mass that are often used for forces, and the corresponding units of force."""

DIMENSIONS: dict[str, Dimension] = {
    "dimensionless": Dimension("a plain number", (0, 0, 0, 0), "", "0.05 or 5 %"),
    "length": Dimension(
        "a length", (1, 0, 0, 0), "m", "3 mm", display=((0.0, "µm"), (1e-4, "mm"), (10.0, "m"))
    ),
    "area": Dimension("an area", (2, 0, 0, 0), "m^2", "20 mm^2", display=((0.0, "mm^2"),)),
    "second_moment_of_area": Dimension(
        "a second moment of area", (4, 0, 0, 0), "m^4", "1.2e4 mm^4", display=((0.0, "mm^4"),)
    ),
    "angle": Dimension("an angle", (0, 0, 0, 0), "rad", "20 deg", (1,), ((0.0, "deg"),)),
    "mass": Dimension("a mass", (0, 1, 0, 0), "kg", "2.5 kg", display=((0.0, "g"), (1.0, "kg"), (1e4, "t"))),
    "inertia": Dimension("a moment of inertia", (2, 1, 0, 0), "kg m^2", "0.0115 kg m^2"),
    "density": Dimension("a density", (-3, 1, 0, 0), "kg/m^3", "7850 kg/m^3"),
    "mass_per_length": Dimension("a mass per length", (-1, 1, 0, 0), "kg/m", "300 kg/m"),
    "bending_stiffness": Dimension("a stiffness of a section", (3, 1, -2, 0), "N m^2", "2e9 N m^2"),
    "time": Dimension("a time", (0, 0, 1, 0), "s", "0.5 s", display=((0.0, "µs"), (1e-3, "ms"), (1.0, "s"))),
    "frequency": Dimension(
        "a frequency", (0, 0, -1, 0), "Hz", "1000 Hz", (0, 1), ((0.0, "Hz"), (1e4, "kHz"))
    ),
    "angular_speed": Dimension(
        "a rotational speed", (0, 0, -1, 0), "rad/s", "1500 rpm", (1,), ((0.0, "rpm"),)
    ),
    "angular_acceleration": Dimension(
        "an angular acceleration", (0, 0, -2, 0), "rad/s^2", "10 rad/s^2", (1,)
    ),
    "speed": Dimension("a speed", (1, 0, -1, 0), "m/s", "2 m/s", display=((0.0, "mm/s"), (0.1, "m/s"))),
    "acceleration": Dimension("an acceleration", (1, 0, -2, 0), "m/s^2", "9.81 m/s^2"),
    "force": Dimension("a force", (1, 1, -2, 0), "N", "500 N", display=((0.0, "N"), (1e4, "kN"))),
    "torque": Dimension("a torque", (2, 1, -2, 0), "N m", "150 N m", (0, -1), ((0.0, "N m"), (1e4, "kN m"))),
    "energy": Dimension("an energy", (2, 1, -2, 0), "J", "10 J", display=((0.0, "J"), (1e4, "kJ"))),
    "power": Dimension("a power", (2, 1, -3, 0), "W", "11 kW", display=((0.0, "W"), (1e4, "kW"))),
    "pressure": Dimension(
        "a stress or modulus", (-1, 1, -2, 0), "Pa", "210 GPa", display=((0.0, "MPa"), (1e10, "GPa"))
    ),
    "stiffness": Dimension(
        "a stiffness", (0, 1, -2, 0), "N/m", "4.0e8 N/m", display=((0.0, "N/m"), (1e5, "N/µm"))
    ),
    "line_load": Dimension("a load per width", (0, 1, -2, 0), "N/m", "100 N/mm", display=((0.0, "N/mm"),)),
    "stiffness_per_width": Dimension(
        "a tooth stiffness per face width",
        (-1, 1, -2, 0),
        "N/m^2",
        "14 N/(mm um)",
        display=((0.0, "N/(mm µm)"),),
    ),
    "torsional_stiffness": Dimension(
        "a torsional stiffness", (2, 1, -2, 0), "N m/rad", "1e5 N m/rad", (0, -1, -2)
    ),
    "damping": Dimension("a viscous damping", (0, 1, -1, 0), "N s/m", "2000 N s/m"),
    "torsional_damping": Dimension(
        "a torsional damping", (2, 1, -1, 0), "N m s/rad", "0.1 N m s/rad", (0, -1, -2)
    ),
    "coupling_stiffness": Dimension("a force per angle", (1, 1, -2, 0), "N/rad", "1e6 N/rad", (0, -1)),
    "coupling_damping": Dimension(
        "a force per angular speed", (1, 1, -1, 0), "N s/rad", "10 N s/rad", (0, -1)
    ),
    "rate": Dimension("a rate per time", (0, 0, -1, 0), "1/s", "5 1/s"),
    "compliance": Dimension("a compliance", (0, -1, 2, 0), "m/N", "2e-9 m/N"),
    "wear_coefficient": Dimension("a wear coefficient", (1, -1, 2, 0), "m^2/N", "5e-7 mm^3/(N m)"),
    "dynamic_viscosity": Dimension(
        "a dynamic viscosity", (-1, 1, -1, 0), "Pa s", "15 mPa s", display=((0.0, "mPa s"),)
    ),
    "pressure_viscosity": Dimension(
        "a pressure-viscosity coefficient", (1, -1, 2, 0), "1/Pa", "20 1/GPa", display=((0.0, "1/GPa"),)
    ),
    "curvature": Dimension("a curvature", (-1, 0, 0, 0), "1/m", "20 1/m"),
    "kinematic_viscosity": Dimension(
        "a kinematic viscosity", (2, 0, -1, 0), "m^2/s", "320 mm^2/s", display=((0.0, "mm^2/s"),)
    ),
    "temperature": Dimension("a temperature", (0, 0, 0, 1), "K", "70 degC", display=((0.0, "degC"),)),
    "temperature_difference": Dimension("a temperature difference", (0, 0, 0, 1), "K", "40 K"),
}


def zero_of(unit: str, dimension: str) -> float:
    """Zero of a scale of temperature in SI units; 0 for other units.

    Parameters
    ----------
    unit
        Symbol of a unit.
    dimension
        Name of a row of `DIMENSIONS`.

    Examples
    --------
    >>> zero_of("degC", "temperature"), zero_of("K", "temperature")
    (273.15, 0.0)
    """
    return ZEROS.get(unit, 0.0) if dimension == "temperature" else 0.0
