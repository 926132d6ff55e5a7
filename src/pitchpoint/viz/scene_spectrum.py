# SPDX-License-Identifier: Apache-2.0
"""Spectra of a scene, and how they pass over its time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Put = Callable[[ArrayLike, str], dict[str, Any]]

DECIBELS = 80.0
"""Depth of a map below its largest amplitude [dB]: what is less is drawn as nothing."""
_LEVELS = 255


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
    """

    channel: str
    unit: str
    lines: Array
    amplitude: Array
    of: str = ""


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


def spectrum_entry(spectrum: SceneSpectrum, put: Put) -> dict[str, Any]:
    """Entry of a spectrum in the header of a scene.

    Parameters
    ----------
    spectrum
        The spectrum.
    put
        Writes an array and says where it lies.
    """
    return {
        "channel": spectrum.channel,
        "unit": spectrum.unit,
        "of": spectrum.of,
        "lines": put(spectrum.lines, "f4"),
        "amplitude": put(spectrum.amplitude, "f4"),
    }


def map_entry(found: SceneMap, put: Put) -> dict[str, Any]:
    """Entry of a map: one byte for every amplitude.

    Parameters
    ----------
    found
        The map.
    put
        As in `spectrum_entry`.
    """
    return {
        "channel": found.channel,
        "unit": found.unit,
        "of": found.of,
        "lines": put(found.lines, "f4"),
        "times": put(found.times, "f8"),
        "most": float(found.amplitude.max()),
        "decibels": DECIBELS,
        "levels": put(map_levels(found.amplitude), "u1"),
    }


def map_levels(amplitude: Array) -> NDArray[np.uint8]:
    """Amplitudes in 255 even steps of decibels below the largest one; 0 is `DECIBELS` below, or less.

    Parameters
    ----------
    amplitude
        Any shape, not negative, any unit.

    Examples
    --------
    >>> map_levels(np.array([1.0, 0.1, 1e-4, 0.0])).tolist()
    [255, 191, 0, 0]
    """
    least = 10.0 ** (-DECIBELS / 20.0)
    share = np.maximum(amplitude / max(float(amplitude.max()), np.finfo(np.float64).tiny), least)
    levels = np.rint(_LEVELS * (1.0 + 20.0 * np.log10(share) / DECIBELS))
    return levels.astype(np.uint8)
