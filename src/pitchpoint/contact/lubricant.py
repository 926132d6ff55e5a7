# SPDX-License-Identifier: Apache-2.0
"""Viscosity, density and pressure-viscosity coefficient of gear oils over the temperature, squeeze films.

Sources: ASTM D341-20 (Ubbelohde-Walther equation); ISO 3448:1992 (viscosity grades); ASTM D2270-10 (viscosity
index); ISO/TR 15144-1:2014 (density, pressure-viscosity coefficient); O. Reynolds, Phil. Trans. R. Soc. 177
(1886) (squeeze film).
"""

from __future__ import annotations

import math

ZERO_CELSIUS = 273.15
"""0 °C [K]."""
GRADES: dict[str, tuple[float, float]] = {
    f"ISO VG {grade}": (1e-6 * grade, 1e-6 * at_100)
    for grade, at_100 in (
        (10, 2.64),
        (15, 3.38),
        (22, 4.25),
        (32, 5.29),
        (46, 6.65),
        (68, 8.53),
        (100, 11.07),
        (150, 14.55),
        (220, 18.75),
        (320, 23.96),
        (460, 30.35),
        (680, 39.06),
        (1000, 49.86),
        (1500, 64.2),
    )
}
"""Kinematic viscosity at 40 and 100 °C [m²/s] of the grades, of oils with a viscosity index of 95."""
BASES: dict[str, tuple[float, float]] = {
    "mineral": (2.657e-8, 0.1348),
    "polyalphaolefin": (1.466e-8, 0.0507),
    "polyglycol": (1.392e-8, 0.1572),
}
"""Factor and exponent of the pressure-viscosity coefficient at 38 °C [1/Pa] over the viscosity [Pa s]."""
LIGHTEST = 0.7e-6
"""Constant of the Walther equation [m²/s], for viscosities above 2 mm²/s."""


def kinematic_viscosity(temperature: float, at_40: float, at_100: float) -> float:
    """Kinematic viscosity of an oil [m²/s].

    Parameters
    ----------
    temperature
        Temperature [K], -20 to 200 °C.
    at_40, at_100
        Kinematic viscosity at 40 and 100 °C [m²/s], above 2 mm²/s.

    Notes
    -----
    lg lg(ν + 0.7) = A - B lg T with ν in mm²/s and T in K (ASTM D341).

    Examples
    --------
    Oil of 220 mm²/s at 40 °C and 19 mm²/s at 100 °C, at 80 °C:

    >>> round(1e6 * kinematic_viscosity(353.15, 220e-6, 19e-6), 2)
    35.6
    """
    one, two = (math.log10(math.log10(1e6 * (nu + LIGHTEST))) for nu in (at_40, at_100))
    low, high = (math.log10(ZERO_CELSIUS + t) for t in (40.0, 100.0))
    share = (math.log10(temperature) - low) / (high - low)
    return float(1e-6 * 10.0 ** (10.0 ** (one + share * (two - one))) - LIGHTEST)


def oil_density(temperature: float, at_15: float) -> float:
    """Density of an oil [kg/m³].

    Parameters
    ----------
    temperature
        Temperature [K].
    at_15
        Density at 15 °C [kg/m³].

    Notes
    -----
    ρ = ρ_15 - 0.7 (θ + 273 - 289) with θ in °C (ISO/TR 15144-1).

    Examples
    --------
    >>> round(oil_density(353.15, 890.0), 1)
    845.2
    """
    return at_15 - 0.7 * (temperature - ZERO_CELSIUS + 273.0 - 289.0)


def dynamic_viscosity(temperature: float, at_40: float, at_100: float, density: float) -> float:
    """Dynamic viscosity of an oil at ambient pressure [Pa s].

    Parameters
    ----------
    temperature
        Temperature [K].
    at_40, at_100
        Kinematic viscosity at 40 and 100 °C [m²/s].
    density
        Density at 15 °C [kg/m³].

    Examples
    --------
    Oil of the third stage of the NREL 5 MW gearbox in KISSsoft's report, 30.09 mPa s at 80 °C:

    >>> round(1e3 * dynamic_viscosity(353.15, 220e-6, 19e-6, 890.0), 2)
    30.09
    """
    return kinematic_viscosity(temperature, at_40, at_100) * oil_density(temperature, density)


def pressure_viscosity(temperature: float, at_38: float, base: str = "mineral") -> float:
    """Pressure-viscosity coefficient of an oil [1/Pa].

    Parameters
    ----------
    temperature
        Temperature [K].
    at_38
        Dynamic viscosity at 38 °C [Pa s].
    base
        One of `BASES`.

    Notes
    -----
    α_38 = 2.657e-8 η_38^0.1348 for mineral oils, and α = α_38 (1 + 516 (1/(θ + 273) - 1/311)) with θ in °C
    (ISO/TR 15144-1).

    Examples
    --------
    The same oil at 38 °C, 0.02162 mm²/N in the report:

    >>> at_38 = dynamic_viscosity(311.15, 220e-6, 19e-6, 890.0)
    >>> round(1e6 * pressure_viscosity(311.15, at_38), 5)
    0.02162
    """
    factor, exponent = BASES[base]
    absolute = temperature - ZERO_CELSIUS + 273.0
    return factor * at_38**exponent * (1.0 + 516.0 * (1.0 / absolute - 1.0 / 311.0))


def squeeze_rate(viscosity: float, radius: float, film: float, length: float) -> float:
    """Damping coefficient of the oil film between two cylinders that approach [N s/m].

    Parameters
    ----------
    viscosity
        Dynamic viscosity of the oil η [Pa s].
    radius
        Reduced radius of curvature R [m].
    film
        Film thickness h at the line of contact [m], much less than R.
    length
        Length of the line L [m].

    Notes
    -----
    c = 3 √2 π η L (R/h)^1.5: Reynolds' equation h³ dp/dx = 12 η V x for h + x²/(2R) and the speed V, without
    cavitation.

    Examples
    --------
    Oil of 50 mPa s, R 10 mm, h 10 µm, 20 mm:

    >>> round(squeeze_rate(0.05, 0.01, 1e-5, 0.02), 1)
    421.5
    """
    return 3.0 * math.sqrt(2.0) * math.pi * viscosity * length * (radius / film) ** 1.5
