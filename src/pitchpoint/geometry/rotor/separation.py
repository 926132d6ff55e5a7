# SPDX-License-Identifier: Apache-2.0
"""Point of separation of a polar, for dynamic stall (Hansen 2008, after Øye 1991)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.rotor.polar import Polar

FloatArray = NDArray[np.float64]
_LINEAR = math.radians(20.0)
"""Range of angles in which lift vanishes and is steepest."""


@dataclass(frozen=True)
class Separation:
    """Lift of a polar as a mixture of attached and separated flow.

    Attributes
    ----------
    alpha_0
        Angle of attack without lift [rad].
    slope
        Lift slope of attached flow [1/rad].
    f
        Point of separation at the angles of the polar, 1 attached, 0 separated, shape (n,).
    separated
        Lift of separated flow at the angles of the polar, shape (n,).
    """

    alpha_0: float
    slope: float
    f: FloatArray
    separated: FloatArray


def separation(polar: Polar) -> Separation | None:
    """Point of separation of a polar.

    c_l = c_lα (α - α_0) (1 + √f)²/4 of a flat plate in Kirchhoff flow, solved for f (Hansen 2008). c_lα is
    the largest slope from the angle without lift, so that f does not exceed 1. The lift of separated flow
    makes c_l a mixture, f c_l,att + (1 - f) c_l,sep: c_l,sep = c_l,att (1 + 3 √f)/(4 + 4 √f), half of the
    attached lift where all flow is attached, and the lift of the table where f = 0.

    Parameters
    ----------
    polar
        Table of lift.

    Returns
    -------
    Separation or None
        Constants of attached flow and f at the points of the table; None for a section without lift, such as
        a cylinder, whose lift does not rise through zero within 20° of 0.

    Examples
    --------
    >>> alpha = np.radians(np.arange(-20.0, 21.0))
    >>> found = separation(Polar(alpha=alpha, lift=2 * np.pi * alpha, drag=0 * alpha))
    >>> round(found.slope, 3), found.f[[0, 10, -1]].round(9).tolist()
    (6.283, [1.0, 1.0, 1.0])
    >>> float((found.separated / np.sin(alpha + 1e-12)).round(3)[-1])
    3.142
    """
    alpha, lift = polar.alpha, polar.lift
    near = np.abs(alpha) <= _LINEAR
    rising = np.flatnonzero(near[:-1] & near[1:] & (lift[:-1] <= 0.0) & (lift[1:] > 0.0))
    if rising.size == 0:
        return None
    k = int(rising[np.argmin(np.abs(alpha[rising]))])
    alpha_0 = float(alpha[k] - lift[k] * (alpha[k + 1] - alpha[k]) / (lift[k + 1] - lift[k]))
    away = near & (np.abs(alpha - alpha_0) > math.radians(0.5))
    slope = float((lift[away] / (alpha[away] - alpha_0)).max())
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = lift / (slope * (alpha - alpha_0))
    ratio[np.abs(alpha - alpha_0) <= 1e-9] = 1.0
    ratio[np.abs(alpha) > 0.5 * math.pi] = 0.0
    root = 2.0 * np.sqrt(np.clip(ratio, 0.25, 1.0)) - 1.0
    attached = slope * np.sin(alpha - alpha_0)
    separated = np.where(root > 0.0, attached * (1.0 + 3.0 * root) / (4.0 + 4.0 * root), lift)
    return Separation(alpha_0, slope, root**2, separated)
