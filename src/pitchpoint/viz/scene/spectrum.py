# SPDX-License-Identifier: Apache-2.0
"""Spectra of a scene, and how they pass over its time."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class SceneSpectrum:
    """Amplitudes of a channel over frequencies or orders, in SI.

    Attributes
    ----------
    channel, unit
        Name of the channel and its unit.
    lines, amplitude
        Frequencies [Hz], or orders of a body, and peak amplitudes, shape (k,) each.
    of
        Body whose turns the orders count; empty where lines are frequencies.
    resolution
        Spacing of the lines of the record, in the unit of the lines; of many some are omitted.
    """

    channel: str
    unit: str
    lines: Array
    amplitude: Array
    of: str
    resolution: float


@dataclass(frozen=True)
class SceneMap:
    """Spectra of one piece of a record after the other.

    Attributes
    ----------
    channel, unit, lines, of
        As of `SceneSpectrum`; the lines are evenly spaced, shape (k,).
    times
        Middles of the pieces [s], shape (n,).
    amplitude
        Peak amplitudes, shape (n, k).
    """

    channel: str
    unit: str
    lines: Array
    times: Array
    amplitude: Array
    of: str = ""
