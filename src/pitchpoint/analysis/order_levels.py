# SPDX-License-Identifier: Apache-2.0
"""Levels of the harmonics of one order, such as those of a mesh, from a record at nearly constant speed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.levels import a_weighting
from pitchpoint.analysis.sampled import (
    Array,
    SignalError,
    as_increasing,
    as_signal,
    one_way,
    positive,
    same_length,
)

FEWEST = 4.0
"""Smallest distance of two orders in lines of the record, so that they are separated."""


@dataclass(frozen=True)
class OrderLevels:
    """Levels of the harmonics of an order.

    Attributes
    ----------
    order
        Orders of the shaft [-], shape (n,).
    frequency
        Their frequencies at the mean speed [Hz], shape (n,).
    amplitude
        Peak amplitudes, in the unit of the signal, shape (n,).
    level
        Levels of the rms values [dB], A-weighted if requested, shape (n,).
    total
        Level of the sum of the powers of these harmonics [dB].
    """

    order: Array
    frequency: Array
    amplitude: Array
    level: Array
    total: float


def order_levels(
    values: ArrayLike,
    angle: ArrayLike,
    time: ArrayLike,
    *,
    order: float,
    reference: float,
    harmonics: int = 5,
    a_weighted: bool = False,
) -> OrderLevels:
    """Levels of the harmonics of an order of a shaft.

    Parameters
    ----------
    values
        Signal, shape (n,), any unit: force of a bearing, velocity or acceleration of a housing.
    angle
        Unwrapped angle of the shaft at the same samples [rad], shape (n,), strictly monotonic.
    time
        Times [s], shape (n,).
    order
        First order [-]: number of teeth for a mesh, periods of a ripple per revolution for rattle.
    reference
        Reference of the level in the unit of the signal, see `levels.REFERENCES`.
    harmonics
        Number of multiples of the order.
    a_weighted
        Add the A-weighting at the frequency of each order.

    Returns
    -------
    OrderLevels
        The levels.

    Raises
    ------
    SignalError
        If the channels do not match, the shaft reverses, or the record is too short or too coarse for the
        orders.

    Notes
    -----
    X = 2 Σ w x exp(-i o θ) Δθ / Σ w Δθ with a Hann window w over the angle θ [1]_, L = 20 lg(|X|/(√2 x_0)).
    The amplitude of a steady order is exact; other orders that are four or more lines of the record away (a
    line is one period per length of the record) contribute less than 0.4 % of their amplitude. Valid for
    signals that are sampled at least four times per period of the highest order.

    References
    ----------
    .. [1] K. R. Fyfe, E. D. S. Munck, Analysis of computed order tracking, Mechanical Systems and Signal
       Processing 11(2), 1997, 187-205; window as in `spectra.window`.

    Examples
    --------
    A force of 10 N at order 20 and 1 N at order 40 of a shaft at 600 rpm; reference 1 µN:

    >>> t = np.arange(20000) / 20000.0
    >>> angle = 2 * np.pi * 10.0 * t
    >>> force = 500.0 + 10.0 * np.cos(20 * angle) + np.sin(40 * angle)
    >>> found = order_levels(force, angle, t, order=20, reference=1e-6, harmonics=2)
    >>> found.frequency.round(6).tolist(), found.level.round(2).tolist(), round(found.total, 2)
    ([200.0, 400.0], [136.99, 116.99], 137.03)
    """
    x, clock = as_signal(values, minimum=8), as_increasing(time)
    turned = one_way(angle, clock)
    same_length(x, turned, "values, angle")
    same_length(x, clock, "values, time")
    positive(reference, "reference")
    if harmonics < 1:
        raise SignalError(f"harmonics: {harmonics} (limit 1 or more)")
    orders: Array = positive(order, "order") * np.arange(1.0, harmonics + 1.0)
    length = abs(float(turned[-1] - turned[0]))
    if order * length < FEWEST * 2.0 * np.pi:
        raise SignalError(
            f"order: {order:g} has {order * length / (2.0 * np.pi):.3g} periods in the record (limit "
            f"{FEWEST:g}); use a longer record"
        )
    steps = np.abs(np.gradient(turned))
    coarse = float(steps.max()) * orders[-1]
    if coarse > 0.5 * np.pi:
        raise SignalError(
            f"harmonics: order {orders[-1]:g} has {2.0 * np.pi / coarse:.3g} samples per period (limit 4); "
            "use fewer harmonics or a higher sample rate"
        )
    share = (turned - turned[0]) / (turned[-1] - turned[0])
    weight = (0.5 - 0.5 * np.cos(2.0 * np.pi * share)) * steps
    weight = weight / weight.sum()
    level_of_mean = float(weight @ x)
    waves = np.exp(-1j * np.outer(orders, turned))
    amplitude = np.abs(2.0 * waves @ (weight * (x - level_of_mean)))
    frequency: Array = orders * (length / (2.0 * np.pi * float(clock[-1] - clock[0])))
    with np.errstate(divide="ignore"):
        level = 20.0 * np.log10(amplitude / (np.sqrt(2.0) * reference))
    if a_weighted:
        level = level + a_weighting(frequency)
    total = 10.0 * np.log10(float(np.sum(10.0 ** (level / 10.0)))) if np.any(amplitude > 0.0) else -np.inf
    return OrderLevels(orders, frequency, amplitude, level, float(total))
