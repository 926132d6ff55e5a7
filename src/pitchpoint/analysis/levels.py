# SPDX-License-Identifier: Apache-2.0
"""Levels in decibels of structure-borne and radiated noise: references, A-weighting, radiated power."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError, positive

REFERENCES = {
    "N": 1e-6,
    "m": 1e-12,
    "m/s": 1e-9,
    "m/s^2": 1e-6,
    "Pa": 20e-6,
    "W": 1e-12,
}
"""Reference values of levels by SI unit: ISO 1683:2015 for gear noise in air and structures."""
NAMES = {
    "N": "1 µN",
    "m": "1 pm",
    "m/s": "1 nm/s",
    "m/s^2": "1 µm/s²",
    "Pa": "20 µPa",
    "W": "1 pW",
}
"""The same as texts for axes."""


def reference_of(unit: str) -> tuple[float, str]:
    """Reference value of a level, and its text; one SI unit for units without a standard reference.

    Parameters
    ----------
    unit
        SI unit of the quantity.

    Examples
    --------
    >>> reference_of("m/s^2"), reference_of("N m")
    ((1e-06, '1 µm/s²'), (1.0, '1 N m'))
    """
    return REFERENCES.get(unit, 1.0), NAMES.get(unit, f"1 {unit}")


def level(rms: ArrayLike, unit: str) -> Array:
    """Level of a quantity from its rms value.

    Parameters
    ----------
    rms
        Rms values, or powers if the unit is W, any shape; the amplitude of an order divided by √2.
    unit
        SI unit of the quantity, which gives the reference.

    Returns
    -------
    NDArray
        Level [dB], shape of `rms`; minus infinity for zero.

    Notes
    -----
    L = 20 lg(x/x_0) of field quantities, 10 lg(P/P_0) of powers, x_0 by `REFERENCES` [1]_. The older
    reference of velocities, 5e-8 m/s, gives levels lower by 33.98 dB.

    References
    ----------
    .. [1] ISO 1683:2015, Acoustics - Preferred reference values for acoustical and vibratory levels.

    Examples
    --------
    >>> level([1.0, 2.0], "N").round(2).tolist(), float(level(1e-3, "W"))
    ([120.0, 126.02], 90.0)
    """
    values = np.abs(np.asarray(rms, dtype=np.float64))
    factor = 10.0 if unit == "W" else 20.0
    with np.errstate(divide="ignore"):
        return np.asarray(factor * np.log10(values / reference_of(unit)[0]))


def a_weighting(frequency: ArrayLike) -> Array:
    """A-weighting, to be added to levels.

    Parameters
    ----------
    frequency
        [Hz], > 0, any shape.

    Returns
    -------
    NDArray
        Weighting [dB], 0 at 1 kHz.

    Raises
    ------
    SignalError
        If a frequency is not above 0.

    Notes
    -----
    A(f) = 20 lg(f4² f⁴ / ((f² + f1²) √(f² + f2²) √(f² + f3²) (f² + f4²))) + 2.000 dB with f1 = 20.60 Hz,
    f2 = 107.7 Hz, f3 = 737.9 Hz, f4 = 12194 Hz [1]_.

    References
    ----------
    .. [1] IEC 61672-1:2013, Electroacoustics - Sound level meters, annex E.

    Examples
    --------
    Table 3 of the standard: -26.2 dB at 63 Hz, 0 at 1 kHz, 1.0 dB at 4 kHz, for the exact frequencies:

    >>> a_weighting([63.1, 1000.0, 3981.07]).round(1).tolist()
    [-26.2, 0.0, 1.0]
    """
    f = np.asarray(frequency, dtype=np.float64)
    if not np.all(f > 0.0):
        raise SignalError("frequency: A-weighting needs frequencies above 0")
    square = f * f
    low, second, third, high = 20.60**2, 107.7**2, 737.9**2, 12194.0**2
    gain = high * square**2 / ((square + low) * (square + high))
    gain = gain / np.sqrt((square + second) * (square + third))
    return np.asarray(20.0 * np.log10(gain) + 2.000)


def radiated_power(velocity: ArrayLike, area: ArrayLike, *, impedance: float = 413.0) -> float:
    """Equivalent radiated power of a vibrating surface.

    Parameters
    ----------
    velocity
        Rms velocities normal to the surface [m/s], shape (n,), of surface elements or measuring points.
    area
        Area of each element [m^2], shape (n,) or one number.
    impedance
        Characteristic impedance of the air, density times speed of sound [N s/m^3].

    Returns
    -------
    float
        Sound power [W].

    Raises
    ------
    SignalError
        If an area or the impedance is not positive.

    Notes
    -----
    P = ρ c Σ A v² [1]_: the radiated power for the radiation factor 1, an upper bound of what a housing
    radiates. Valid above the coincidence frequency of its walls; below, the actual power is lower by the
    radiation factor, which depends on the shape of the surface.

    References
    ----------
    .. [1] ISO/TS 7849-1:2009, Determination of airborne sound power levels by vibration measurement, with a
       fixed radiation factor of 1.

    Examples
    --------
    A surface of 0.5 m² at 1 mm/s:

    >>> power = radiated_power([1e-3], 0.5)
    >>> round(power, 9), round(float(level(power, "W")), 2)
    (0.0002065, 83.15)
    """
    speeds = np.atleast_1d(np.asarray(velocity, dtype=np.float64))
    areas = np.broadcast_to(np.asarray(area, dtype=np.float64), speeds.shape)
    if not np.all(areas > 0.0):
        raise SignalError("area: every area must be above 0")
    return float(positive(impedance, "impedance") * np.sum(areas * speeds**2))
