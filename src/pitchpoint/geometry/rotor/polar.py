# SPDX-License-Identifier: Apache-2.0
"""Aerodynamic coefficients of an airfoil over the angle of attack."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError

FloatArray = NDArray[np.float64]
_CLOSE = 1e-9
"""Tolerance of the ends of a table [rad]; angles in files have few digits."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Polar:
    """Lift, drag and pitching moment of an airfoil over the angle of attack.

    Between the points of the table the coefficients are cubic polynomials with continuous slope that do not
    exceed the values of the table (Fritsch and Butland 1984).

    Parameters
    ----------
    name
        Name in messages.
    alpha
        Angles of attack, increasing, shape (n,) [rad].
    lift, drag
        Coefficients c_l and c_d at these angles, shape (n,).
    moment
        Coefficient c_m about the aerodynamic centre, which is the point of the section at the station of a
        blade, nose up positive, shape (n,); empty for zero.

    Raises
    ------
    GeometryError
        If the table is too short, not increasing, not finite, or its lengths differ.

    Examples
    --------
    >>> polar = Polar(alpha=[-0.1, 0.0, 0.1], lift=[-0.6, 0.0, 0.6], drag=[0.01, 0.01, 0.01])
    >>> polar.complete, polar.at(0.05)[0].round(6).tolist()
    (False, 0.3)
    """

    name: str = "polar"
    alpha: FloatArray
    lift: FloatArray
    drag: FloatArray
    moment: FloatArray = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        for key in ("alpha", "lift", "drag", "moment"):
            object.__setattr__(self, key, np.array(getattr(self, key), dtype=float))
        if self.moment.size == 0:
            object.__setattr__(self, "moment", np.zeros(self.alpha.size))
        sizes = {getattr(self, key).shape for key in ("alpha", "lift", "drag", "moment")}
        if len(sizes) > 1 or self.alpha.ndim != 1:
            raise GeometryError(
                "are the shapes of its columns", where=self.name, value=str(sorted(sizes)), limit="one (n,)"
            )
        if self.alpha.size < 3:
            raise GeometryError(
                "points are too few", where=self.name, value=str(self.alpha.size), limit=">= 3"
            )
        table = np.stack([self.alpha, self.lift, self.drag, self.moment])
        if not np.isfinite(table).all():
            raise GeometryError(
                "contains values that are not finite", where=self.name, remedy="delete these points"
            )
        steps = np.diff(self.alpha)
        if (steps <= 0.0).any():
            k = int(np.argmax(steps <= 0.0)) + 1
            raise GeometryError(
                f"at point {k + 1} does not increase",
                where=self.name,
                value=f"{math.degrees(self.alpha[k]):g} deg",
                limit=f"> {math.degrees(self.alpha[k - 1]):g} deg",
                remedy="sort the table by angle of attack",
            )
        if max(-self.alpha[0], self.alpha[-1]) > math.pi + 1e-6:
            raise GeometryError(
                "is beyond a half turn",
                where=self.name,
                value=f"{math.degrees(max(-self.alpha[0], self.alpha[-1])):g} deg",
                limit="-180 to 180 deg",
                remedy="give angles in radians",
            )

    @property
    def complete(self) -> bool:
        """Whether the table covers all angles of attack, from -180° to 180°."""
        return bool(self.alpha[0] <= -math.pi + _CLOSE and self.alpha[-1] >= math.pi - _CLOSE)

    @cached_property
    def knots(self) -> FloatArray:
        """Rows of α, c_l, c_l', c_d, c_d', c_m, c_m', shape (n, 7), slopes per radian.

        A complete table is continued with its period; its ends have one value, the mean of both.
        """
        out = np.zeros((self.alpha.size, 7))
        out[:, 0] = self.alpha
        for k, column in enumerate((self.lift, self.drag, self.moment)):
            out[:, 1 + 2 * k] = column
            if self.complete:
                out[[0, -1], 1 + 2 * k] = 0.5 * (column[0] + column[-1])
            out[:, 2 + 2 * k] = _slopes(self.alpha, out[:, 1 + 2 * k], self.complete)
        if self.complete:
            out[0, 0], out[-1, 0] = -math.pi, math.pi
        return out

    def at(self, alpha: float) -> FloatArray:
        """Coefficients at an angle of attack within the table.

        Parameters
        ----------
        alpha
            Angle of attack [rad].

        Returns
        -------
        ndarray, shape (3,)
            c_l, c_d, c_m.
        """
        rows = self.knots
        i = int(np.clip(np.searchsorted(rows[:, 0], alpha) - 1, 0, len(rows) - 2))
        h = rows[i + 1, 0] - rows[i, 0]
        t = (alpha - rows[i, 0]) / h
        left, right = rows[i, 1::2], rows[i + 1, 1::2]
        slopes = h * rows[i, 2::2], h * rows[i + 1, 2::2]
        blend = t * t * (3.0 - 2.0 * t)
        value = (1.0 - blend) * left + blend * right
        return np.asarray(value + t * (1.0 - t) * ((1.0 - t) * slopes[0] - t * slopes[1]))


def _slopes(x: FloatArray, y: FloatArray, periodic: bool) -> FloatArray:
    """Slopes of the monotone cubic interpolant: weighted harmonic means of the secants."""
    h, secant = np.diff(x), np.diff(y) / np.diff(x)
    if periodic:
        h, secant = np.r_[h[-1], h, h[0]], np.r_[secant[-1], secant, secant[0]]
    product = secant[:-1] * secant[1:]
    w1, w2 = 2.0 * h[1:] + h[:-1], h[1:] + 2.0 * h[:-1]
    with np.errstate(divide="ignore", invalid="ignore"):
        inner = (w1 + w2) / (w1 / secant[:-1] + w2 / secant[1:])
    inner = np.where(product > 0.0, inner, 0.0)
    return inner if periodic else np.r_[secant[0], inner, secant[-1]]
