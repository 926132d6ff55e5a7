# SPDX-License-Identifier: Apache-2.0
"""Decimation with an anti-aliasing filter.

The low-pass filter is a sinc function with a Kaiser window, symmetric about its middle: zero phase. The pass
band ends at 0.4 of the new rate; above 0.5 of the new rate the attenuation is 80 dB.

Source: Oppenheim and Schafer, Discrete-Time Signal Processing (1989), 7.5.3.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.sampled import SignalError

PASS, STOP = 0.4, 0.5
"""End of the pass band and start of the stop band, over the new sample rate."""
DAMPING = 80.0
"""Attenuation in the stop band [dB]."""
REACH = math.ceil((DAMPING - 7.95) / (2.285 * 2.0 * math.pi * (STOP - PASS)) / 2.0)
"""Half length of the filter in samples at the new rate."""


def decimation_filter(factor: int) -> NDArray[np.float64]:
    """Weights of the anti-aliasing filter of a decimation factor.

    Parameters
    ----------
    factor
        Old sample rate over the new one, at least 2 [-].

    Returns
    -------
    numpy.ndarray
        Weights, shape (2 factor REACH + 1,); their sum is one [-].

    Raises
    ------
    SignalError
        If the factor is less than 2.

    Notes
    -----
    J. F. Kaiser's formulas give length and window for an attenuation A: n = (A - 7.95)/(2.285 dw),
    beta = 0.1102 (A - 8.7) (A. V. Oppenheim, R. W. Schafer, *Discrete-Time Signal Processing*, section
    7.5.3).

    Examples
    --------
    >>> h = decimation_filter(2)
    >>> len(h), round(float(h.sum()), 12)
    (105, 1.0)
    """
    if factor < 2:
        raise SignalError(f"factor: {factor} does not decimate (limit >= 2)")
    n = np.arange(-factor * REACH, factor * REACH + 1)
    middle = 0.5 * (PASS + STOP)
    weights = np.sinc(2.0 * middle * n / factor) * np.kaiser(n.size, 0.1102 * (DAMPING - 8.7))
    return np.asarray(weights / weights.sum(), float)


def decimated(signal: NDArray[np.float64], factor: int) -> NDArray[np.float64]:
    """Decimate a signal; the ends, where the filter exceeds the record, are omitted.

    Parameters
    ----------
    signal
        Samples at the old rate along the first axis, shape (n, ...) with n >= 2 factor REACH + 1 [any unit].
    factor
        Old sample rate over the new one, at least 2 [-].

    Returns
    -------
    numpy.ndarray
        Samples at the new rate, shape ((n - 1) // factor - 2 REACH + 1, ...) [unit of the signal]; the first
        one is at the time of the old sample factor REACH.

    Raises
    ------
    SignalError
        If the signal is shorter than the filter, or the factor less than 2.

    Examples
    --------
    A constant passes; a vibration at 0.7 of the new rate, which would alias to 0.3 of it, is suppressed.

    >>> decimated(np.ones(111), 2)
    array([1., 1., 1., 1.])
    >>> high = np.cos(2.0 * np.pi * 0.35 * np.arange(1000))
    >>> float(np.abs(decimated(high, 2)).max()) < 1e-4
    True
    """
    from scipy.signal import upfirdn

    weights = decimation_filter(factor)
    x = np.asarray(signal, float)
    if x.shape[0] < weights.size:
        raise SignalError(f"signal: {x.shape[0]} samples are less than the filter has (limit {weights.size})")
    whole = upfirdn(weights, x, up=1, down=factor, axis=0)
    return np.asarray(whole[2 * REACH : (x.shape[0] - 1) // factor + 1])
