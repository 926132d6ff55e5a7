# SPDX-License-Identifier: Apache-2.0
"""Campbell diagram: speeds at which excitation orders cross natural frequencies."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import SignalError, as_increasing, same_length


@dataclass(frozen=True)
class Crossing:
    """Crossing of an excitation order and a mode.

    Attributes
    ----------
    speed
        Speed of the reference shaft [rad/s].
    frequency
        Frequency at the crossing [Hz].
    order
        Excitations per revolution of the reference shaft [-]; the first mesh order of a gear is its tooth
        number.
    mode
        Index of the mode (column of the data), from 0.
    name
        Name of the order, if given.
    damping_ratio
        Damping ratio of the mode at the crossing; NaN if not given.
    """

    speed: float
    frequency: float
    order: float
    mode: int
    name: str = ""
    damping_ratio: float = math.nan


def campbell_crossings(
    speed: ArrayLike,
    mode_frequencies: ArrayLike,
    orders: Sequence[float] | Mapping[str, float],
    damping_ratios: ArrayLike | None = None,
) -> tuple[Crossing, ...]:
    """Crossings of excitation orders with natural frequencies in a speed range.

    Parameters
    ----------
    speed
        Speeds of the reference shaft [rad/s], shape (n_speed,), increasing.
    mode_frequencies
        Natural frequencies [Hz], shape (n_speed, n_mode), or (n_mode,) if independent of speed. NaN marks a
        mode that does not exist at a speed.
    orders
        Excitations per revolution of the reference shaft [-], each > 0; with names in a mapping.
    damping_ratios
        Damping ratios [-], shape as `mode_frequencies`; optional.

    Returns
    -------
    tuple of Crossing
        Sorted by speed, then order, then mode; each crossing once, also if it is at a sample.

    Raises
    ------
    SignalError
        If shapes do not fit, speeds do not increase, or an order is not positive.

    Notes
    -----
    Zeros of f_mode(Ω) - order·Ω/(2π) [1]_, with f_mode between the given speeds by monotone cubic
    interpolation, linear in columns with gaps. Valid if each column tracks one mode; pairs of crossings
    closer than the speed grid are missed. `solve_campbell` solves its crossings again instead.

    References
    ----------
    .. [1] W. E. Campbell, The protection of steam-turbine disk wheels from axial vibration, Transactions of
       the ASME 46, 1924, 31-160.

    Examples
    --------
    A mesh of 20 teeth and its second harmonic against 1000 Hz: 3000 and 1500 rpm.

    >>> c = campbell_crossings([0.0, 400.0], [1000.0], [20, 40])
    >>> [(round(k.speed * 30 / np.pi, 6), k.order) for k in c]
    [(1500.0, 40.0), (3000.0, 20.0)]
    """
    omega = as_increasing(speed, "speed")
    modes = np.asarray(mode_frequencies, dtype=np.float64)
    if modes.ndim == 1:
        modes = np.broadcast_to(modes, (omega.size, modes.size))
    if modes.ndim != 2:
        raise SignalError(f"mode_frequencies: has {modes.ndim} dimensions (limit 2)")
    if modes.shape[1]:
        same_length(omega, modes[:, 0], "speed, mode_frequencies")
    found: list[Crossing] = []
    damping = None if damping_ratios is None else np.asarray(damping_ratios, dtype=np.float64)
    if damping is not None:
        damping = np.broadcast_to(damping, modes.shape)
    named = orders.items() if isinstance(orders, Mapping) else (("", order) for order in orders)
    for name, order in named:
        if not np.isfinite(order) or order <= 0.0:
            raise SignalError(f"orders: {order} (limit > 0)")
        for mode in range(modes.shape[1]):
            distance = modes[:, mode] - float(order) * omega / (2.0 * np.pi)
            found.extend(
                Crossing(
                    at,
                    float(order) * at / (2.0 * np.pi),
                    float(order),
                    mode,
                    str(name),
                    math.nan if damping is None else float(np.interp(at, omega, damping[:, mode])),
                )
                for at in _zeros(omega, distance)
            )
    return tuple(sorted(found, key=lambda c: (c.speed, c.order, c.mode)))


def _zeros(x: np.ndarray, y: np.ndarray) -> list[float]:
    """Zeros of sampled values; an interval of zeros counts once, at its start."""
    zeros: list[float] = []
    curve: Any = None
    if x.size > 2 and np.all(np.isfinite(y)):
        from scipy.interpolate import PchipInterpolator

        curve = PchipInterpolator(x, y)
    for i in range(x.size):
        if y[i] == 0.0 and (i == 0 or y[i - 1] != 0.0):
            zeros.append(float(x[i]))
        elif i and y[i - 1] * y[i] < 0.0 and curve is not None:
            from scipy.optimize import brentq

            zeros.append(float(brentq(curve, x[i - 1], x[i], xtol=1e-12 * abs(x[i]))))
        elif i and y[i - 1] * y[i] < 0.0:
            zeros.append(float(x[i - 1] + (x[i] - x[i - 1]) * y[i - 1] / (y[i - 1] - y[i])))
    return zeros
