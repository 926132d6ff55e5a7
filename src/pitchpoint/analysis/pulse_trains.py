# SPDX-License-Identifier: Apache-2.0
"""Channels that hold the pulses of a tacho: two levels, steep edges, even intervals.

Derivation: docs/theory/signals.md, "Angle".
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import as_signal
from pitchpoint.analysis.tacho import FEWEST_PULSES, rising_edges

LEVEL = 0.15
"""Distance from a level, over the range, up to which a sample lies on it: filtered edges overshoot by 9 %."""
FLAT = 0.8
"""Share of the samples above, and of those below, the middle that lie on their level."""
EVEN = 1.25
"""Ratio of successive intervals up to which they are alike; a shaft changes its speed slowly."""


def is_pulse_train(values: ArrayLike, time: ArrayLike) -> bool:
    """Whether a channel shows pulses of a tacho, not a vibration.

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
    Vibration has no flat levels: of a sine half the samples lie farther than 15 % of the range from both
    extremes, of impacts the peaks decay.

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
