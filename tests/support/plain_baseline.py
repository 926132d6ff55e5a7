# SPDX-License-Identifier: Apache-2.0
"""The plain method against which the diagnosis of bearings is measured: envelope spectrum of the whitened
signal."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.ndimage import median_filter
from scipy.signal import hilbert

LEAST = 15.0
"""Mean level of three harmonics above the median [dB] from which a part is named."""


def plain_baseline(
    values: np.ndarray, rate: float, speed: float, orders: Mapping[str, float], search: float = 0.022
) -> str:
    """Part with the highest mean level of three harmonics at any speed within the search; empty below the
    limit."""
    lines = np.fft.rfft(values - np.mean(values))
    white = np.fft.irfft(lines / np.maximum(np.abs(lines), 1e-30), values.size)
    square = np.abs(hilbert(white)) ** 2
    power = np.abs(np.fft.rfft((square - square.mean()) * np.hanning(square.size))) ** 2
    level = 10.0 * np.log10(np.maximum(power / median_filter(power, 301), 1e-3))
    level = np.maximum(level, np.maximum(np.roll(level, 1), np.roll(level, -1)))
    trials = 1.0 + np.linspace(-search, search, 401)
    best = {
        part: max(
            np.mean([level[round(k * order * speed * trial * values.size / rate)] for k in (1, 2, 3)])
            for trial in trials
        )
        for part, order in orders.items()
    }
    part = max(best, key=lambda one: best[one])
    return part if best[part] >= LEAST else ""
