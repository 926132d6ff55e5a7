# SPDX-License-Identifier: Apache-2.0
"""Spectra of a scene and their maps over time, as entries of its file."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.viz.scene_numbers import Block
from pitchpoint.viz.scene_spectrum import Array, SceneMap, SceneSpectrum

DECIBELS = 80.0
"""Depth of a map below its largest amplitude [dB]: what is less is drawn as nothing."""
_LEVELS = 255
_AMPLITUDE = 1e-3
"""Largest relative error of a line of a spectrum."""
_NOTHING = 1e-12
"""Lines below this part of the largest one are raised to it: they have a logarithm."""


def spectrum_entry(spectrum: SceneSpectrum, block: Block) -> dict[str, Any]:
    """Entry of a spectrum in the header of a scene.

    Parameters
    ----------
    spectrum
        The spectrum.
    block
        Where its numbers go.

    Raises
    ------
    ValueError
        If an amplitude is not finite.
    """
    amplitude = spectrum.amplitude
    if not np.isfinite(amplitude).all():
        raise ValueError(f"{spectrum.channel}: holds numbers that are not finite")
    level = np.log(np.maximum(amplitude, _NOTHING * float(amplitude.max(initial=0.0)) or 1.0))
    return {
        "channel": spectrum.channel,
        "unit": spectrum.unit,
        "of": spectrum.of,
        "resolution": spectrum.resolution,
        "lines": _lines(spectrum.lines, block),
        "amplitude": {**block.put_steps(level, 2.0 * _AMPLITUDE), "exponent": True},
    }


def map_entry(found: SceneMap, block: Block) -> dict[str, Any]:
    """Entry of a map: its amplitudes as levels of decibels.

    Parameters
    ----------
    found
        The map.
    block
        Where its numbers go.
    """
    return {
        "channel": found.channel,
        "unit": found.unit,
        "of": found.of,
        "lines": block.put(found.lines, "f4"),
        "times": block.put(found.times, "f8"),
        "most": float(found.amplitude.max()),
        "decibels": DECIBELS,
        "levels": block.put_whole(map_levels(found.amplitude)),
    }


def _lines(lines: Array, block: Block) -> dict[str, Any]:
    """Lines of a spectrum: their numbers, where they are multiples of one line."""
    gap = float(np.diff(lines).min(initial=float("inf")))
    number = np.rint(lines / gap)
    if not np.allclose(number * gap, lines, rtol=1e-6, atol=0.0):
        return block.put(lines, "f4")
    return {**block.put_whole(number), "scale": [float(lines[-1] / number[-1])]}


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
