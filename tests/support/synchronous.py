# SPDX-License-Identifier: Apache-2.0
"""Speeds at which a natural frequency equals the speed of rotation."""

from __future__ import annotations

import numpy as np


def synchronous_speeds(speeds: np.ndarray, frequencies: np.ndarray) -> list[float]:
    """Crossings of branches (n_speed, n_mode) [Hz] with the first order, increasing [rad/s].

    Between the given speeds, branches are straight lines.
    """
    apart = frequencies - speeds[:, None] / (2.0 * np.pi)
    at, branch = np.nonzero(np.diff(np.sign(apart), axis=0))
    left, right = apart[at, branch], apart[at + 1, branch]
    return sorted((speeds[at] + np.diff(speeds)[at] * left / (left - right)).tolist())
