# SPDX-License-Identifier: Apache-2.0
"""Spectra and spectral maps of a scene."""

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
        Reference body of the orders; empty for frequencies.
    resolution
        Line spacing of the record, in the unit of the lines; some lines may be omitted.
    """

    channel: str
    unit: str
    lines: Array
    amplitude: Array
    of: str
    resolution: float


@dataclass(frozen=True)
class SceneMap:
    """Spectra of successive segments of a record.

    Attributes
    ----------
    channel, unit, lines, of
        As in `SceneSpectrum`; the lines are equally spaced, shape (k,).
    times
        Middle times of the segments [s], shape (n,).
    amplitude
        Peak amplitudes, shape (n, k).
    """

    channel: str
    unit: str
    lines: Array
    times: Array
    amplitude: Array
    of: str = ""
