# SPDX-License-Identifier: Apache-2.0
"""Synthetic vibration of a gear over its angle: mesh harmonics, modulation, faulty tooth."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def mesh_vibration(angle: Array, teeth: int, *, modulation: float = 0.0) -> Array:
    """Three mesh harmonics of amplitudes 1, 1/2, 1/4, modulated in amplitude and phase once per turn."""
    carrier = teeth * angle + modulation * np.sin(angle)
    tones = sum(0.5**k * np.cos((k + 1) * carrier + 0.4 * k) for k in range(3))
    return np.asarray((1.0 + modulation * np.cos(angle)) * tones, dtype=np.float64)


def tooth_pulse(angle: Array, teeth: int, tooth: int = 0) -> Array:
    """One smooth pulse of height 1 over half a tooth pitch, once per turn of the gear; 0 elsewhere.

    Its mean square over a turn is (3/8)·(1/2)/z, as sin⁴ has the mean 3/8.
    """
    pitch = 2.0 * np.pi / teeth
    within = np.mod(angle - tooth * pitch, 2.0 * np.pi) / (0.5 * pitch)
    return np.where(within < 1.0, np.sin(np.pi * within) ** 2, 0.0)
