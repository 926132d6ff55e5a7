# SPDX-License-Identifier: Apache-2.0
"""Flank modifications as a row of numbers: closed form over relative height and width, for kernels.

The gap along the transverse base tangent is the sum of a function of the relative height t, 0 at the root
form circle and 1 at the tip form circle, and a function of the relative width ζ, −1 to 1 over the face width:

    C_α (2t − 1)² − C_Hα (t − ½) + relief(t) + relief(1 − t) + C_β ζ² − C_Hβ ζ/2 + relief(|ζ|)

with relief(u) = C ((u − u_0)/(1 − u_0))ⁿ beyond its start u_0. Beyond the ends of the flank it is constant.

Source: definitions of `pitchpoint.geometry.modifications` (ISO 21771).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.geometry.modifications import (
    SHAPES,
    EndRelief,
    FlankModifications,
    Relief,
    flank_range,
    roll_length,
)

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FloatArray = NDArray[np.float64]

PROFILE_CROWNING, PROFILE_SLOPE, LEAD_CROWNING, HELIX_SLOPE = 0, 1, 2, 3
"""Entries of a row [m]."""
TIP, ROOT, END = 4, 7, 10
"""First entries of the reliefs: amount [m], relative start and exponent [-]."""
N_TERM = 13
"""Length of a row."""


def modification_terms(modifications: FlankModifications, gear: CylindricalGear) -> FloatArray:
    """Row of numbers of the modifications of one flank.

    Parameters
    ----------
    modifications
        Modifications that fit the flank, see `modification_problems`.
    gear
        External or internal gear.

    Returns
    -------
    ndarray, shape (N_TERM,)
        Amounts along the transverse base tangent [m]; starts and exponents of reliefs [-].

    Examples
    --------
    A tip relief of 20 µm over 4 mm of 16.54 mm of roll starts at 0.758 of the height.

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.modifications import Relief
    >>> relieved = FlankModifications(tip_relief=Relief(amount=20e-6, length=4e-3))
    >>> row = modification_terms(relieved, CylindricalGear(z=50, m_n=3e-3, b=0.02))
    >>> (row[TIP : TIP + 3] * [1e6, 1.0, 1.0]).round(6).tolist()
    [20.0, 0.758179, 1.0]
    """
    m = modifications
    root, tip = flank_range(gear)
    row = np.zeros(N_TERM)
    row[:4] = m.profile_crowning, m.profile_slope, m.lead_crowning, m.helix_slope
    for at, relief, end in ((TIP, m.tip_relief, tip), (ROOT, m.root_relief, root)):
        extent = 0.0
        if relief is not None:
            extent = relief.length or abs(end - float(roll_length(gear, relief.start_diameter or 0.0)))
        _set_relief(row, at, relief, extent / abs(tip - root))
    ends = m.end_relief
    _set_relief(row, END, ends, 0.0 if ends is None else ends.length / (0.5 * gear.b))
    amounts = [0, 1, 2, 3, TIP, ROOT, END]
    row[amounts] /= math.cos(gear.beta_b)
    return row


def _set_relief(row: FloatArray, at: int, relief: Relief | EndRelief | None, extent: float) -> None:
    """Set the entries of a relief; without one its amount is 0 and it starts at the end of the flank."""
    row[at : at + 3] = 0.0, 1.0, 1.0
    if relief is not None:
        row[at : at + 3] = relief.amount, 1.0 - extent, SHAPES[relief.shape]


def _relief(row: FloatArray, at: int, u: FloatArray) -> FloatArray:
    """Gap of a relief over the relative distance u towards its end [m]."""
    amount, start, power = row[at : at + 3]
    if start >= 1.0:
        return np.zeros_like(u)
    return np.asarray(amount * np.maximum(0.0, (u - start) / (1.0 - start)) ** power)


def profile_gap(row: FloatArray, t: ArrayLike) -> FloatArray:
    """Gap along the base tangent over the relative height.

    Parameters
    ----------
    row
        As from `modification_terms`.
    t
        Relative height, 0 to 1 [-].

    Returns
    -------
    ndarray, shape of t
        Gap [m].

    Examples
    --------
    >>> crowned = np.eye(N_TERM)[PROFILE_CROWNING]
    >>> profile_gap(crowned, [0.0, 0.5, 0.75]).tolist()
    [1.0, 0.0, 0.25]
    """
    u: FloatArray = np.clip(np.asarray(t, dtype=np.float64), 0.0, 1.0)
    gap = row[PROFILE_CROWNING] * (2.0 * u - 1.0) ** 2 - row[PROFILE_SLOPE] * (u - 0.5)
    return np.asarray(gap + _relief(row, TIP, u) + _relief(row, ROOT, 1.0 - u))


def lead_gap(row: FloatArray, zeta: ArrayLike) -> FloatArray:
    """Gap along the base tangent over the relative width.

    Parameters
    ----------
    row
        As from `modification_terms`.
    zeta
        Relative width ζ, −1 to 1 [-].

    Returns
    -------
    ndarray, shape of zeta
        Gap [m].

    Examples
    --------
    >>> crowned = np.eye(N_TERM)[LEAD_CROWNING]
    >>> lead_gap(crowned, [-1.0, 0.5]).tolist()
    [1.0, 0.25]
    """
    u: FloatArray = np.clip(np.asarray(zeta, dtype=np.float64), -1.0, 1.0)
    gap = row[LEAD_CROWNING] * u**2 - 0.5 * row[HELIX_SLOPE] * u
    return np.asarray(gap + _relief(row, END, np.abs(u)))


def cell_minima(row: FloatArray, t: FloatArray, zeta: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Minima of both functions between the stations of a grid.

    Parameters
    ----------
    row
        As from `modification_terms`.
    t, zeta
        Increasing stations, 0 to 1 and −1 to 1.

    Returns
    -------
    tuple of ndarray
        Minimum of the profile between neighbouring stations [m], shape (t.size − 1,), and of the lead, shape
        (ζ.size − 1,). Both are piecewise quadratic: exact.

    Examples
    --------
    A crowning of 4 µm with a slope of 4 µm is lowest at ζ = 1/4: −0.25 µm.

    >>> row = np.zeros(N_TERM)
    >>> row[LEAD_CROWNING] = row[HELIX_SLOPE] = 4.0
    >>> cell_minima(row, np.array([0.0, 1.0]), np.array([-1.0, 1.0]))[1].tolist()
    [-0.25]
    """
    ends = [row[END + 1], -row[END + 1], 0.0]
    return (
        _minima(lambda u: profile_gap(row, u), t, [row[TIP + 1], 1.0 - row[ROOT + 1]]),
        _minima(lambda u: lead_gap(row, u), zeta, ends),
    )


def _minima(gap: Callable[[FloatArray], FloatArray], stations: FloatArray, kinks: list[float]) -> FloatArray:
    """Minima of a function between stations, quadratic between these and its kinks."""
    inside = [k for k in kinks if stations[0] < k < stations[-1]]
    u = np.union1d(stations, inside)
    a, b = u[:-1], u[1:]
    left, middle, right = gap(a), gap(0.5 * (a + b)), gap(b)
    bend = left - 2.0 * middle + right
    least = np.minimum(left, right)
    with np.errstate(divide="ignore", invalid="ignore"):
        place = (left - right) / (4.0 * bend)  # of the vertex, from the middle in widths of the piece
        vertex = middle - 0.125 * (left - right) ** 2 / bend
    within = (bend > 0.0) & (np.abs(place) < 0.5)
    least = np.where(within, np.minimum(least, vertex), least)
    first = np.searchsorted(u, stations[:-1])
    return np.asarray(np.minimum.reduceat(least, first))
