# SPDX-License-Identifier: Apache-2.0
"""Tacho pulses of a rotating shaft.

Derivation: docs/theory/signals.md, "Angle".
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.sampled import SignalError


def tacho_levels(angle: NDArray[np.float64], per_turn: int) -> NDArray[np.int8]:
    """Level of a tacho: 1 over the first half of the pulse pitch, 0 over the second.

    Parameters
    ----------
    angle
        Unwrapped angle of the shaft, shape (n,) [rad].
    per_turn
        Pulses per revolution, at least 1 [-].

    Returns
    -------
    numpy.ndarray
        Levels 0 and 1, shape (n,) [-].

    Raises
    ------
    SignalError
        If there is less than one pulse per revolution.

    Examples
    --------
    >>> tacho_levels(np.radians([0.0, 80.0, 100.0, 179.0, 181.0]), 2).tolist()
    [1, 1, 0, 0, 1]
    """
    _at_least_one(per_turn)
    share = np.asarray(angle, float) * (per_turn / (2.0 * math.pi))
    return np.asarray(share - np.floor(share) < 0.5, np.int8)


def pulse_times(t: NDArray[np.float64], angle: NDArray[np.float64], per_turn: int) -> NDArray[np.float64]:
    """Start times of tacho pulses, by linear interpolation between the samples.

    Parameters
    ----------
    t
        Times of the samples, increasing, shape (n,) [s].
    angle
        Unwrapped angle of the shaft, shape (n,) [rad]; it may decrease.
    per_turn
        Pulses per revolution, at least 1 [-].

    Returns
    -------
    numpy.ndarray
        Times at which the angle passes a multiple of the pulse pitch, shape (k,) [s].

    Raises
    ------
    SignalError
        If there is less than one pulse per revolution, or t and angle differ in length.

    Examples
    --------
    A shaft with 30 revolutions per second and 10 pulses per revolution: one pulse every 1/300 s.

    >>> t = np.linspace(0.0, 0.01, 101)
    >>> pulse_times(t, 2.0 * np.pi * 30.0 * t + 0.1, 10).round(6).tolist()
    [0.002803, 0.006136, 0.009469]
    """
    _at_least_one(per_turn)
    if np.shape(t) != np.shape(angle):
        raise SignalError(f"angle: {np.shape(angle)[0]} samples, but there are {np.shape(t)[0]} times")
    share = np.asarray(angle, float) * (per_turn / (2.0 * math.pi))
    whole = np.floor(share)
    found: list[float] = []
    for k in np.flatnonzero(np.diff(whole)):
        low, high = sorted((whole[k], whole[k + 1]))
        passed = np.arange(low + 1.0, high + 1.0)
        times = t[k] + (t[k + 1] - t[k]) * (passed - share[k]) / (share[k + 1] - share[k])
        found.extend(np.sort(times).tolist())
    return np.asarray(found, float)


def _at_least_one(per_turn: int) -> None:
    if per_turn < 1:
        raise SignalError(f"per_turn: {per_turn} pulses cannot be counted (limit >= 1)")
