# SPDX-License-Identifier: Apache-2.0
"""Extrapolation of a short polar to all angles of attack (Viterna and Corrigan 1982)."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.geometry.rotor.polar import Polar

FloatArray = NDArray[np.float64]
_STEP = math.radians(5.0)
_NEAR = 0.02
_REFLECTED = 0.7
"""Ratio of the lift with reversed flow to that of the stalled airfoil (Viterna and Janetzke 1982)."""


def extrapolate_polar(polar: Polar, aspect_ratio: float = 10.0) -> Polar:
    """Polar from -180° to 180°: the table where there is one, beyond it a stalled flat plate.

    c_d = C sin²α + B cos α and c_l = ½ C sin 2α + A cos²α / sin α with C = 1.11 + 0.018 AR; A and B are such
    that both continue the last point of the table (Viterna and Corrigan 1982). Reflected flow has 0.7 of this
    lift. The pitching moment outside the table is that of the normal force at a point that moves from the
    quarter chord at 0° to the mid-chord at 90°.

    Parameters
    ----------
    polar
        Table from at most 0° to more than 0° and less than 90°; its last point must be beyond stall.
    aspect_ratio
        Length of the blade over its mean chord; maximum drag increases with it.

    Returns
    -------
    Polar
        The same polar if it is complete already.

    Raises
    ------
    GeometryError
        If the table does not include 0° or ends beyond 90°.

    Examples
    --------
    >>> short = Polar(alpha=[-0.2, 0.0, 0.3], lift=[-0.9, 0.2, 1.2], drag=[0.05, 0.01, 0.08])
    >>> extrapolate_polar(short).at(0.5 * 3.141592653589793).round(4).tolist()
    [0.0, 1.29, -0.3225]
    """
    if polar.complete:
        return polar
    high, low = float(polar.alpha[-1]), float(polar.alpha[0])
    if not (0.0 < high < 0.5 * math.pi and -0.5 * math.pi < low <= 0.0):
        raise GeometryError(
            "is the range of angles of attack",
            where=polar.name,
            value=f"{math.degrees(low):g} to {math.degrees(high):g} deg",
            limit="from at least -90 deg and at most 0, to more than 0 and less than 90 deg",
            remedy="give -180 to 180 deg, or a table around 0 deg",
        )
    stalled = _Stalled(polar, aspect_ratio)
    count = math.floor(2.0 * math.pi / _STEP + 0.5)
    every = np.linspace(-math.pi, math.pi, count + 1)
    outer = every[(every < low - 0.5 * _STEP) | (every > high + 0.5 * _STEP)]
    rows = np.array([stalled.at(a) for a in outer])
    alpha = np.r_[outer[outer < low], polar.alpha, outer[outer > high]]
    before = rows[outer < low], rows[outer > high]
    columns = [
        np.r_[before[0][:, k], own, before[1][:, k]]
        for k, own in enumerate((polar.lift, polar.drag, polar.moment))
    ]
    return Polar(name=polar.name, alpha=alpha, lift=columns[0], drag=columns[1], moment=columns[2])


def range_problem(polar: Polar, remedy: str) -> Message:
    """Problem of a table that does not contain all angles of attack.

    Parameters
    ----------
    polar
        Table with a smaller range.
    remedy
        Corrective action, unless the angles seem to be in another unit.

    Examples
    --------
    >>> short = Polar(alpha=[-0.2, 0.0, 0.3], lift=[-0.9, 0.2, 1.2], drag=[0.05, 0.01, 0.08])
    >>> print(range_problem(short, "complete it"))
    -11.4592 to 17.1887 deg is the range of the angles of attack (limit -180 to 180 deg); complete it
    """
    low, high = (math.degrees(polar.alpha[k]) for k in (0, -1))
    if abs(high - math.pi) < _NEAR and abs(low + math.pi) < _NEAR:
        remedy = "give the angles in degrees; these seem to be in radians"
    return Message(
        "",
        "is the range of the angles of attack",
        f"{low:.6g} to {high:.6g} deg",
        "-180 to 180 deg",
        remedy,
    )


class _Stalled:
    """Coefficients of a stalled airfoil that continue the last point of a table."""

    def __init__(self, polar: Polar, aspect_ratio: float) -> None:
        self.high, self.lift = float(polar.alpha[-1]), float(polar.lift[-1])
        self.low = float(polar.alpha[0]), float(polar.lift[0]), float(polar.drag[0])
        s, c = math.sin(self.high), math.cos(self.high)
        self.most = max(1.11 + 0.018 * aspect_ratio, float(polar.drag.max()))
        self.a = (self.lift - self.most * s * c) * s / c**2
        self.b = (float(polar.drag[-1]) - self.most * s**2) / c

    def _plate(self, alpha: float) -> tuple[float, float]:
        """Lift and drag between the last point of the table and 90°."""
        s, c = math.sin(alpha), math.cos(alpha)
        return 0.5 * self.most * math.sin(2.0 * alpha) + self.a * c**2 / s, self.most * s**2 + self.b * c

    def at(self, alpha: float) -> tuple[float, float, float]:
        """Lift, drag and moment outside the table."""
        lift, drag = self._lift_and_drag(alpha)
        normal = lift * math.cos(alpha) + drag * math.sin(alpha)
        return lift, max(drag, 0.0), -0.25 * normal * abs(alpha) / (0.5 * math.pi)

    def _lift_and_drag(self, alpha: float) -> tuple[float, float]:
        """Stalled plate, reflected for negative angles and reversed flow; straight lines in between."""
        if -self.high < alpha < self.low[0]:
            t = (alpha + self.high) / (self.low[0] + self.high)
            lift, drag = self._plate(self.high)
            return -(1.0 - t) * _REFLECTED * lift + t * self.low[1], (1.0 - t) * drag + t * self.low[2]
        sign = math.copysign(1.0, alpha)
        size = min(abs(alpha), math.pi - abs(alpha))
        lift, drag = self._plate(max(size, self.high))
        if size < self.high:
            lift *= size / self.high
            drag = self.most * math.sin(size) ** 2 + self.b * math.cos(size)
        if abs(alpha) > 0.5 * math.pi:
            return -sign * _REFLECTED * lift, drag
        return (lift if sign > 0.0 else -_REFLECTED * lift), drag
