# SPDX-License-Identifier: Apache-2.0
"""Removal of tones from a signal whose background is known only from the signal itself."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.running_median import running_median
from pitchpoint.analysis.sampled import Array, as_signal

WIDTH = 257
"""Lines of the running median."""
HIGHEST = 2.5
"""Highest amplitude of a line over the median: 1.3 % of the lines of noise are above it."""


def limited_tones(values: ArrayLike, *, whiten: bool = False) -> Array:
    """Signal without tones: the amplitude of a spectral line is at most 2.5 times the median around it.

    Parameters
    ----------
    values
        Signal, shape (n,), any unit; the mean is removed.
    whiten
        Whether all lines are divided by the median, too, so that the spectrum becomes flat.

    Returns
    -------
    NDArray
        Shape (n,), in the unit of the signal; whitened without a unit.

    Raises
    ------
    SignalError
        If the signal has fewer than 514 samples.

    Notes
    -----
    Tones of shafts and meshes are few lines and are limited to the level of their surroundings, impacts fill
    a band and keep theirs [1]_. Unlike cepstrum pre-whitening, the random amplitudes of the lines remain. The
    median of the amplitudes of normal noise is sqrt(ln 2) = 0.833 of their rms. Valid for tones that are
    narrower than a hundred lines.

    References
    ----------
    .. [1] R. B. Randall, J. Antoni, Rolling element bearing diagnostics - a tutorial, Mechanical Systems and
       Signal Processing 25(2), 2011, 485-520.

    Examples
    --------
    A tone of rms 7.1 in noise of rms 1; what remains of it is leakage:

    >>> t = np.arange(20_000)
    >>> noise = np.random.default_rng(1).standard_normal(t.size)
    >>> round(float(limited_tones(10.0 * np.sin(0.5 * t) + noise).std()), 2)
    1.34
    """
    x = as_signal(values, minimum=2 * WIDTH)
    lines = np.fft.rfft(x - x.mean())
    size = np.abs(lines)
    median = np.maximum(running_median(size, WIDTH), np.finfo(np.float64).tiny)
    gain = np.minimum(1.0, HIGHEST * median / np.maximum(size, np.finfo(np.float64).tiny))
    return np.asarray(np.fft.irfft(lines * (gain / median if whiten else gain), x.size))
