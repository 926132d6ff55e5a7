# SPDX-License-Identifier: Apache-2.0
"""Amplitudes over time and frequency by the short-time Fourier transform."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.frames import frame_places, frame_spectra
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive


@dataclass(frozen=True)
class TimeFrequencyMap:
    """Short-time amplitude spectra.

    Attributes
    ----------
    time
        Shape (n_frame,). Mid-time of each frame [s], from `start`.
    frequency
        Shape (n_line,). Frequency [Hz].
    amplitude
        Shape (n_frame, n_line). Peak amplitude, in the unit of the signal; the mean of each frame is removed.
    """

    time: Array
    frequency: Array
    amplitude: Array


def time_frequency_map(
    values: ArrayLike,
    sample_rate: float,
    *,
    frame: int | None = None,
    frames: int = 300,
    highest_frequency: float | None = None,
    window_name: str = "hann",
    start: float = 0.0,
) -> TimeFrequencyMap:
    """Short-time Fourier transform as a map of peak amplitudes, corrected for the window.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit, uniformly spaced.
    sample_rate
        Sample rate f_s [Hz].
    frame
        Samples per frame L [-]; default the power of two nearest to √(2n), at least 64, of a record just
        fast enough for the highest frequency, which balances time and frequency resolution of the map.
        Frames at the ends are shorter, see `frames.frame_places`.
    frames
        Maximum number of frames [-], evenly distributed over the record; they overlap as needed.
    highest_frequency
        Highest frequency of the map [Hz]; default f_s/2.
    window_name
        See `spectra.window`.
    start
        Time of the first sample [s].

    Returns
    -------
    TimeFrequencyMap
        One row per frame.

    Raises
    ------
    SignalError
        If the frame is longer than the record or shorter than 8 samples, or an input is unsuitable.

    Notes
    -----
    A(t_j, f_k) = 2 |Σ w_n (x_{n+s_j} - x̄_j) exp(-2πikn/L)| / Σ w_n [1]_. Frames are transformed one at a
    time to limit memory. Valid if amplitude and frequency change little within one frame.

    References
    ----------
    .. [1] J. B. Allen, L. R. Rabiner, A unified approach to short-time Fourier analysis and synthesis,
       Proceedings of the IEEE 65(11), 1977, 1558-1564.

    Examples
    --------
    A chirp f = 20 Hz/s · t with an amplitude of 3 passes 100 Hz at 5 s:

    >>> t = np.arange(20000) / 2000.0
    >>> m = time_frequency_map(3.0 * np.cos(2 * np.pi * 10.0 * t**2), 2000.0, frame=256)
    >>> j = int(np.argmin(np.abs(m.time - 5.0)))
    >>> bool(abs(m.frequency[np.argmax(m.amplitude[j])] - 100.0) < 2000.0 / 256)
    True
    >>> bool(abs(m.amplitude[j].max() - 3.0) < 0.15 * 3.0)
    True
    """
    x = as_signal(values, minimum=16)
    rate = positive(sample_rate, "sample_rate")
    top = 0.5 * rate if highest_frequency is None else positive(highest_frequency, "highest_frequency")
    length = _balanced(x.size, rate, top) if frame is None else int(frame)
    if not 8 <= length <= x.size:
        raise SignalError(f"frame: {length} samples (limit 8 to {x.size}); choose a length inside the record")
    n_line = min(length // 2 + 1, int(np.floor(top * length / rate * (1.0 + 1e-12))) + 1)
    places = starts, lengths = frame_places(x.size, length, frames)
    amplitude = np.empty((starts.size, n_line))
    for row, (_, lines) in enumerate(frame_spectra(x, places, length, window_name)):
        amplitude[row] = lines[:n_line]
    return TimeFrequencyMap(
        time=np.asarray(start + (starts + 0.5 * (lengths - 1)) / rate, dtype=np.float64),
        frequency=np.arange(n_line) * rate / length,
        amplitude=amplitude,
    )


def _balanced(size: int, rate: float, top: float) -> int:
    """Samples per frame with equal numbers of frames and lines up to the highest frequency."""
    thinner = max(1.0, 0.5 * rate / top)
    length = 2 ** round(np.log2(thinner * max(64.0, np.sqrt(2.0 * size / thinner))))
    return int(min(size, length))
