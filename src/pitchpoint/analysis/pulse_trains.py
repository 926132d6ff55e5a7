# SPDX-License-Identifier: Apache-2.0
"""Identification of tacho channels: two levels or single lobes, even intervals.

Derivation: docs/theory/signals.md, "Angle".
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.sampled import as_signal
from pitchpoint.analysis.tacho import MIN_PULSES, rising_edges

Array = NDArray[np.float64]

LEVEL = 0.15
"""Tolerance of a level over the range; filtered edges overshoot by 9 %."""
FLAT = 0.8
"""Minimum share of the samples above, and of those below, the middle that are on their level."""
EVEN = 1.25
"""Maximum ratio of successive intervals that are even; the speed of a shaft changes slowly."""


def is_pulse_train(values: ArrayLike, time: ArrayLike) -> bool:
    """Whether a channel is a tacho pulse train and not a vibration signal.

    Parameters
    ----------
    values, time
        Channel (any unit) and times [s], shape (n,) each.

    Raises
    ------
    SignalError
        If they are not finite, of different length or too short.

    Notes
    -----
    Vibration has no flat levels: half the samples of a sine are farther than 15 % of the range from both
    extremes, and the peaks of impacts decay. Inductive pickups give one lobe per pulse, or one positive and
    one negative lobe, all alike, with zero signal between them; structures hit by an impact ring several
    times.

    Examples
    --------
    >>> t = np.arange(4000) / 1000.0
    >>> is_pulse_train((10.0 * t) % 1.0 < 0.1, t), is_pulse_train(np.sin(20.0 * np.pi * t), t)
    (True, False)
    """
    x = as_signal(values, "channel")
    low, high = float(x.min()), float(x.max())
    if high <= low:
        return False
    y = (x - low) / (high - low)
    upper = y >= 0.5
    if np.mean(y[upper] >= 1.0 - LEVEL) < FLAT or np.mean(y[~upper] <= LEVEL) < FLAT:
        return _of_a_pickup(x, time)
    return _even(np.diff(rising_edges(x, time)))


def _of_a_pickup(x: Array, time: ArrayLike) -> bool:
    """Whether single lobes, or pairs of one up and one down, stand out of a signal at rest."""
    y = x - np.median(x)
    y /= y[np.argmax(np.abs(y))]
    if np.mean(np.abs(y) <= LEVEL) < FLAT:
        return False
    up = rising_edges(np.clip(y, 0.0, 4.0 * LEVEL), time, hysteresis=0.25)
    if not _even(np.diff(up)):
        return False
    if y.min() < -2.0 * LEVEL:
        down = rising_edges(np.clip(-y, 0.0, 4.0 * LEVEL), time, hysteresis=0.25)
        if np.mean(np.diff(np.searchsorted(down, up)) == 1) < FLAT:
            return False
    places = np.searchsorted(np.asarray(time, dtype=np.float64), up[:-1])
    return _even(np.maximum.reduceat(y, places))


def _even(sizes: Array) -> bool:
    """Whether successive intervals or heights are alike."""
    if sizes.size < MIN_PULSES:
        return False
    ratio = sizes[1:] / sizes[:-1]
    return bool(np.mean(np.abs(np.log(ratio)) < np.log(EVEN)) >= FLAT)
