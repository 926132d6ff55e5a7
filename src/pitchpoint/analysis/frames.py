# SPDX-License-Identifier: Apache-2.0
"""Frames of short-time spectra: they cover a record up to its ends, where they are shorter."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.spectra import one_sided, window

SHORTEST = 4
"""A frame at an end of the record has at least this fraction of the full length."""


def frame_places(
    size: int, length: int, frames: int, least: int = 8
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """First samples and lengths of frames, evenly distributed from end to end of a record.

    Parameters
    ----------
    size
        Number of samples of the record.
    length
        Full length of a frame [samples]. Near the ends a frame is shortened to remain centred, down to a
        quarter of it: a run-up loses an eighth of a frame at each end instead of half a frame.
    frames
        Maximum number of frames.
    least
        Smallest length of a shortened frame [samples].

    Returns
    -------
    tuple
        First samples and lengths, shape (n_frame,) each.

    Notes
    -----
    Short-time spectra with a window of variable length [1]_: the line width is inversely proportional to it.

    References
    ----------
    .. [1] J. B. Allen, L. R. Rabiner, A unified approach to short-time Fourier analysis and synthesis,
       Proceedings of the IEEE 65(11), 1977, 1558-1564.

    Examples
    --------
    >>> frame_places(100, 40, 5)
    (array([ 0,  8, 30, 53, 90]), array([10, 40, 40, 40, 10]))
    """
    least = min(length, max(least, length // SHORTEST))
    count = max(1, min(int(frames), size - least + 1))
    middle = np.linspace(0.5 * least, size - 0.5 * least, count) if count > 1 else np.array([0.5 * size])
    room = 2.0 * np.minimum(middle, size - middle)
    lengths = np.clip(np.floor(room + 1e-9), least, length).astype(np.int64)
    starts = np.clip(np.floor(middle - 0.5 * lengths + 0.5), 0, size - lengths).astype(np.int64)
    kept = np.unique(np.stack([starts, lengths]), axis=1)
    order = np.argsort(kept[0] + 0.5 * kept[1], kind="stable")
    return kept[0][order], kept[1][order]


def frame_spectra(
    values: Array, places: tuple[NDArray[np.int64], NDArray[np.int64]], length: int, window_name: str
) -> Iterator[tuple[float, Array]]:
    """Mean and peak amplitudes of each frame, at the lines of the full length; amplitudes without the mean.

    Parameters
    ----------
    values
        Record, shape (n,).
    places
        First samples and lengths of the frames.
    length
        Full length, which defines the lines [samples]; shorter frames are padded with zeros.
    window_name
        See `spectra.window`.
    """
    windows: dict[int, Array] = {}
    for start, size in zip(*places, strict=True):
        w = windows.setdefault(int(size), window(window_name, int(size)))
        piece = values[start : start + size]
        mean = float(piece.mean())
        yield mean, one_sided(np.fft.rfft(w * (piece - mean), n=length), length, float(w.sum()))
