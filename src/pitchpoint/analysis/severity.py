# SPDX-License-Identifier: Apache-2.0
"""Vibration severity: rms velocity on housings, and its zones by ISO 20816."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.line_tests import LONG
from pitchpoint.analysis.sampled import Array, as_signal, positive

BAND = (10.0, 1000.0)
"""Frequencies of the rms velocity [Hz]; from 2 Hz for machines slower than 600 rpm."""
SLOW = 10.0
"""Rotation frequency [Hz] below which the band begins at 2 Hz."""
ZONES = {
    "group 1 rigid": (2.3e-3, 4.5e-3, 7.1e-3),
    "group 1 flexible": (3.5e-3, 7.1e-3, 11.0e-3),
    "group 2 rigid": (1.4e-3, 2.8e-3, 4.5e-3),
    "group 2 flexible": (2.3e-3, 4.5e-3, 7.1e-3),
    "small": (0.71e-3, 1.8e-3, 4.5e-3),
}
"""Limits of the zones A/B, B/C and C/D [m/s] by group and support: ISO 20816-3:2022 group 1 above 300 kW,
group 2 from 15 kW; small machines up to 15 kW: ISO 10816-1:1995, class I."""


@dataclass(frozen=True)
class Severity:
    """Vibration severity of a channel.

    Attributes
    ----------
    velocity
        rms velocity [m/s].
    band
        Its frequencies [Hz].
    zone
        `A` to `D`; empty if no group is given.
    """

    velocity: float
    band: tuple[float, float]
    zone: str = ""


def vibration_severity(
    values: ArrayLike, sample_rate: float, unit: str, *, turn: float = math.inf, group: str = ""
) -> Severity | None:
    """Severity of an acceleration or velocity on a housing.

    Parameters
    ----------
    values
        Acceleration [m/s^2] or velocity [m/s], shape (n,).
    sample_rate
        Sample rate [Hz].
    unit
        `m/s^2` or `m/s`.
    turn
        Rotation frequency of the slowest shaft [Hz].
    group
        One of `ZONES`; empty for the velocity alone.

    Returns
    -------
    Severity or None
        None if the unit is another one, or the record ends below 100 Hz.

    Notes
    -----
    By Parseval's theorem from the lines of the whole record between 10 and 1000 Hz, or half the sample rate
    if that is lower; acceleration is divided by 2πf. Zones by [1]_: A new machines, B unrestricted
    operation, C limited operation, D damage is likely. Valid for vibration of non-rotating parts.

    References
    ----------
    .. [1] ISO 20816-3:2022, Mechanical vibration - Measurement and evaluation of machine vibration - Part 3.

    Examples
    --------
    A sine of 1 m/s² at 50 Hz has 1/(2π 50 √2) = 2.25 mm/s:

    >>> t = np.arange(10_000) / 5000.0
    >>> found = vibration_severity(np.cos(2 * np.pi * 50 * t), 5000.0, "m/s^2", group="group 2 rigid")
    >>> round(1e3 * found.velocity, 2), found.zone
    (2.25, 'B')
    """
    x, rate = as_signal(values, minimum=16), positive(sample_rate, "sample_rate")
    low, high = (2.0 if turn < SLOW else BAND[0]), min(BAND[1], 0.45 * rate)
    if velocity_factor(unit, 1.0) is None or high < 100.0:
        return None
    mean = float(x.mean())
    parts = np.array_split(x, -(-x.size // LONG))
    velocity = math.sqrt(sum(_square(part - mean, rate, unit, (low, high)) for part in parts) / x.size)
    limits = ZONES.get(group, ())
    zone = "ABCD"[sum(velocity > limit for limit in limits)] if limits else ""
    return Severity(velocity, (low, high), zone)


def _square(x: Array, rate: float, unit: str, band: tuple[float, float]) -> float:
    """Mean square velocity in a band times the number of samples."""
    frequency = np.fft.rfftfreq(x.size, 1.0 / rate)
    inside = (frequency >= band[0]) & (frequency <= band[1])
    lines = np.abs(np.fft.rfft(x)[inside])
    if unit == "m/s^2":
        lines /= math.tau * frequency[inside]
    return 2.0 * float(np.sum(lines**2)) / x.size


def velocity_factor(unit: str, frequency: float) -> float | None:
    """Velocity [m/s] per unit of a line; None for other units, or without a frequency.

    Parameters
    ----------
    unit
        SI unit of the channel.
    frequency
        Frequency of the line [Hz].

    Examples
    --------
    >>> velocity_factor("m/s", 50.0), round(velocity_factor("m/s^2", 50.0), 6), velocity_factor("V", 50.0)
    (1.0, 0.003183, None)
    """
    if unit == "m/s":
        return 1.0
    if unit == "m/s^2" and frequency > 0.0:
        return 1.0 / (math.tau * frequency)
    return None
