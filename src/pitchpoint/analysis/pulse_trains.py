# SPDX-License-Identifier: Apache-2.0
"""Identification of tacho channels: two levels, steep edges, even intervals.

Derivation: docs/theory/signals.md, "Angle".
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import as_signal
from pitchpoint.analysis.tacho import FEWEST_PULSES, rising_edges

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
    extremes, and the peaks of impacts decay.

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
        return False
    intervals = np.diff(rising_edges(x, time))
    if intervals.size < FEWEST_PULSES:
        return False
    ratio = intervals[1:] / intervals[:-1]
    return bool(np.mean(np.abs(np.log(ratio)) < np.log(EVEN)) >= FLAT)
