# SPDX-License-Identifier: Apache-2.0
"""Basic load ratings of rolling bearings from their inner geometry.

Sources: ISO 281:2007 (dynamic), ISO 76:2006 (static); Palmgren, *Ball and Roller Bearing Engineering* (1959).
"""

from __future__ import annotations

import math
from bisect import bisect_right

_F0 = (
    *(14.7, 14.9, 15.1, 15.3, 15.5, 15.7, 15.9, 16.1, 16.3, 16.5, 16.4, 16.1, 15.9, 15.6),
    *(15.4, 15.2, 14.9, 14.7, 14.4, 14.2, 14.0, 13.7, 13.5, 13.2, 13.0, 12.8, 12.5, 12.3),
    *(12.1, 11.8, 11.6, 11.4, 11.2, 10.9, 10.7, 10.5, 10.3, 10.0, 9.8, 9.6, 9.4),
)
"""Factor f_0 [N/mm^2] at gamma = 0, 0.01, ... 0.4 (ISO 76, radial ball bearings, groove radius 0.52 D_w)."""
F0_SPHERE = 1.944
"""Factor f_0 [N/mm^2] of self-aligning ball bearings over (1 + gamma)^2: 4600 MPa between ball and sphere by
Hertz, which is the table of ISO 76 (1.9 at 0, 2.8 at 0.2, 3.8 at 0.4)."""
F0_THRUST = 61.6
"""Factor f_0 [N/mm^2] at a contact angle of 90 deg (ISO 76): 4200 MPa, groove radius 0.54 D_w."""
_GAMMA = (*(0.05, 0.06, 0.07, 0.08, 0.09, 0.1, 0.12, 0.14, 0.16), *(0.02 * k for k in range(9, 21)))
_FC = (
    *(46.7, 49.1, 51.1, 52.8, 54.3, 55.5, 57.5, 58.8, 59.6),
    *(59.9, 59.9, 59.6, 59.0, 58.2, 57.1, 56.0, 54.6, 53.2, 51.7, 50.0, 48.4),
)
"""Factor f_c at `_GAMMA` (ISO 281, single-row radial and angular contact ball bearings)."""
_FC_SPHERE = (
    *(17.3, 18.6, 19.9, 21.1, 22.3, 23.4, 25.6, 27.7, 29.7),
    *(31.7, 33.5, 35.2, 36.8, 38.2, 39.4, 40.3, 40.9, 41.2, 41.3, 41.0, 40.4),
)
"""Factor f_c of self-aligning ball bearings at `_GAMMA` (ISO 281)."""
FC_THRUST = 146.1
"""Factor f_c at a contact angle of 90 deg over (D_w/d_m)^0.3 (ISO 281: 36.7 at 0.01, 73.3 at 0.1)."""
_HUNDREDTHS = tuple(0.01 * k for k in range(len(_F0)))
LARGE_BALL = 25.4e-3
"""Ball diameter [m] above which the exponent of the dynamic load rating is 1.4 instead of 1.8."""
BALL_GAMMA = 0.4
"""Largest D_w cos(alpha)/d_m of the tables for balls."""


def ball_static(
    elements: int, diameter: float, pitch: float, angle: float = 0.0, rows: int = 1, race: str = "groove"
) -> float:
    """Static load rating C_0 of a ball bearing [N]; of thrust bearings the axial one.

    Parameters
    ----------
    elements
        Number of balls Z of a row.
    diameter, pitch
        Ball diameter D_w and pitch diameter d_m [m].
    angle
        Contact angle [rad].
    rows
        Number of rows i.
    race
        Outer raceway: "groove", "sphere" (self-aligning), or "washer" (thrust bearing, 90 deg).

    Notes
    -----
    C_0 = f_0 i Z D_w^2 cos(alpha), ISO 76; gamma = D_w cos(alpha)/d_m is limited to 0.4. Thrust bearings: f_0
    Z D_w^2.

    Examples
    --------
    Bearing 6308, catalogue 24.0 kN; 1206 (two rows of 14 balls of 8 mm), catalogue 4.65 kN:

    >>> round(ball_static(8, 15.081e-3, 65e-3))
    23944
    >>> round(ball_static(14, 8e-3, 46e-3, 0.165, rows=2, race="sphere"))
    4716
    """
    squared = rows * elements * (1e3 * diameter) ** 2
    if race == "washer":
        return F0_THRUST * squared
    gamma = min(diameter * math.cos(angle) / pitch, BALL_GAMMA)
    factor = F0_SPHERE * (1.0 + gamma) ** 2 if race == "sphere" else _between(gamma, _HUNDREDTHS, _F0)
    return factor * squared * math.cos(angle)


def ball_dynamic(
    elements: int, diameter: float, pitch: float, angle: float = 0.0, rows: int = 1, race: str = "groove"
) -> float:
    """Dynamic load rating C of a ball bearing [N]; of thrust bearings the axial one.

    Parameters
    ----------
    elements, diameter, pitch, angle, rows, race
        As of `ball_static`.

    Notes
    -----
    C = 1.3 f_c (i cos alpha)^0.7 Z^(2/3) D_w^1.8, ISO 281; 3.647 D_w^1.4 above 25.4 mm. Thrust bearings: 1.3
    f_c Z^(2/3) D_w^1.8.

    Examples
    --------
    Bearing 6308, catalogue 40.5 kN:

    >>> round(ball_dynamic(8, 15.081e-3, 65e-3))
    40718
    """
    size = 1e3 * diameter
    power = size**1.8 if diameter <= LARGE_BALL else 3.647 * size**1.4
    power *= 1.3 * elements ** (2.0 / 3.0)
    if race == "washer":
        return float(FC_THRUST * (diameter / pitch) ** 0.3 * power)
    gamma = min(diameter * math.cos(angle) / pitch, BALL_GAMMA)
    factor = _between(gamma, _GAMMA, _FC_SPHERE if race == "sphere" else _FC)
    return float(factor * (rows * math.cos(angle)) ** 0.7 * power)


def roller_static(
    elements: int, diameter: float, length: float, pitch: float, angle: float = 0.0, rows: int = 1
) -> float:
    """Static load rating C_0 of a roller bearing [N].

    Parameters
    ----------
    elements
        Number of rollers Z of a row.
    diameter, length
        Mean diameter D_we and effective length L_we of a roller [m].
    pitch
        Pitch diameter d_m [m].
    angle
        Contact angle [rad].
    rows
        Number of rows i.

    Notes
    -----
    C_0 = 44 (1 - gamma) i Z L_we D_we cos(alpha), ISO 76, with gamma = D_we cos(alpha)/d_m.

    Examples
    --------
    Cylindrical roller bearing 209 (Harris: 14 rollers of 10 x 9.6 mm on 65 mm):

    >>> round(roller_static(14, 10e-3, 9.6e-3, 65e-3))
    50038
    """
    gamma = diameter * math.cos(angle) / pitch
    return 44e6 * (1.0 - gamma) * rows * elements * length * diameter * math.cos(angle)


def roller_dynamic(
    elements: int,
    diameter: float,
    length: float,
    pitch: float,
    angle: float = 0.0,
    rows: int = 1,
    rating: float = 1.1,
) -> float:
    """Dynamic load rating C of a roller bearing [N].

    Parameters
    ----------
    elements, diameter, length, pitch, angle, rows
        As of `roller_static`.
    rating
        Factor b_m: 1.1, for spherical roller bearings 1.15.

    Notes
    -----
    C = b_m f_c (i L_we cos alpha)^(7/9) Z^(3/4) D_we^(29/27), ISO 281. f_c is the equation behind its table
    (ISO/TR 8646): 0.83 * 207.9 (1 + (1.04 ((1 - g)/(1 + g))^(143/108))^(9/2))^(-2/9) g^(2/9) (1 -
    g)^(29/27)/(1 + g)^(1/4), g = D_we cos(alpha)/d_m.

    Examples
    --------
    f_c = 88.7 at gamma = 0.2 (table of ISO 281), by a single roller of 1 mm:

    >>> round(roller_dynamic(1, 1e-3, 1e-3, 5e-3, rating=1.0), 1)
    88.7
    """
    g = diameter * math.cos(angle) / pitch
    ring = (1.0 + (1.04 * ((1.0 - g) / (1.0 + g)) ** (143.0 / 108.0)) ** 4.5) ** (-2.0 / 9.0)
    factor = 0.83 * 207.9 * ring * g ** (2.0 / 9.0) * (1.0 - g) ** (29.0 / 27.0) / (1.0 + g) ** 0.25
    together = (rows * 1e3 * length * math.cos(angle)) ** (7.0 / 9.0)
    return float(rating * factor * together * elements**0.75 * (1e3 * diameter) ** (29.0 / 27.0))


def _between(x: float, xs: tuple[float, ...], ys: tuple[float, ...]) -> float:
    """Linear interpolation; constant beyond the ends."""
    k = min(max(bisect_right(xs, x), 1), len(xs) - 1)
    t = min(max((x - xs[k - 1]) / (xs[k] - xs[k - 1]), 0.0), 1.0)
    return ys[k - 1] + t * (ys[k] - ys[k - 1])
