# SPDX-License-Identifier: Apache-2.0
"""Checks of sampled data that every analysis function starts with.

Measured and simulated signals enter the analysis as plain arrays. What they must fulfil is written once,
here, so that the functions themselves contain nothing but the mathematics.

Derivation: docs/theory/signals.md, "Signals".
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import PitchpointError

Array = NDArray[np.float64]
Lines = NDArray[np.complex128]

# Relative jitter of the sampling interval up to which a time axis counts as uniform. Times written as decimal
# text or summed up in floating point stay well below it; a lost sample is six orders of magnitude above.
UNIFORM_TOLERANCE = 1e-6


class SignalError(PitchpointError, ValueError):
    """Sampled data do not fulfil what an analysis function needs; the message states where and what to do."""


def as_signal(values: ArrayLike, name: str = "values", minimum: int = 2) -> Array:
    """Return `values` as a one-dimensional array of finite floats.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    name
        What to call them in an error message.
    minimum
        Smallest number of samples the caller can work with.

    Returns
    -------
    NDArray
        The samples as float64, shape (n,).

    Raises
    ------
    SignalError
        If the data have another shape, too few samples, or samples that are not finite.

    Examples
    --------
    >>> as_signal([1, 2, 3]).dtype
    dtype('float64')
    """
    try:
        data = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise SignalError(f"{name}: cannot be read as numbers; pass an array of floats") from error
    if data.ndim != 1:
        raise SignalError(f"{name}: has {data.ndim} dimensions (limit 1); select one channel")
    if data.size < minimum:
        raise SignalError(f"{name}: has {data.size} samples (limit {minimum}); use a longer record")
    bad = np.flatnonzero(~np.isfinite(data))
    if bad.size:
        raise SignalError(
            f"{name}: sample {bad[0]} is {data[bad[0]]}; remove or repair samples that are not finite"
        )
    return data


def as_increasing(values: ArrayLike, name: str = "time", minimum: int = 2) -> Array:
    """Return `values` as a signal that increases strictly, as a time axis does.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    name
        What to call them in an error message.
    minimum
        Smallest number of samples the caller can work with.

    Raises
    ------
    SignalError
        If some sample is not larger than the one before it.

    Examples
    --------
    >>> as_increasing([0.0, 0.5, 0.6])
    array([0. , 0.5, 0.6])
    """
    axis = as_signal(values, name, minimum)
    back = np.flatnonzero(np.diff(axis) <= 0.0)
    if back.size:
        raise SignalError(
            f"{name}: does not increase after sample {back[0]}; sort it and drop repeated samples"
        )
    return axis


def same_length(first: Array, second: Array, names: str) -> None:
    """Refuse two channels of different length; `names` is what the message calls them.

    Parameters
    ----------
    first
        Samples of one channel, shape (n,).
    second
        Samples of the other channel, shape (n,).
    names
        What to call the two in an error message.

    Raises
    ------
    SignalError
        If the lengths differ.
    """
    if first.size != second.size:
        raise SignalError(f"{names}: {first.size} and {second.size} samples; both must come from one record")


def sample_rate_of(time: ArrayLike) -> float:
    """Sample rate of a uniform time axis.

    Parameters
    ----------
    time
        Times [s], shape (n,), uniformly spaced.

    Returns
    -------
    float
        Sample rate f_s = (n - 1)/(t_n - t_1) [Hz].

    Raises
    ------
    SignalError
        If the spacing varies by more than a millionth of itself.

    Examples
    --------
    >>> round(sample_rate_of([0.0, 0.25, 0.5, 0.75]), 9)
    4.0
    """
    axis = as_increasing(time)
    step = (axis[-1] - axis[0]) / (axis.size - 1)
    # the second term is the resolution of the axis itself: late times carry fewer digits per step
    allowed = UNIFORM_TOLERANCE * step + 4.0 * np.finfo(np.float64).eps * float(np.abs(axis).max())
    if float(np.max(np.abs(np.diff(axis) - step))) > allowed:
        raise SignalError("time: is not uniformly spaced; resample the record first")
    return float(1.0 / step)


def positive(value: float, name: str) -> float:
    """Return `value` if it is a finite number above zero, else refuse it.

    Parameters
    ----------
    value
        Number, any unit.
    name
        What to call it in an error message.

    Raises
    ------
    SignalError
        If the number is not finite or not above 0.
    """
    if not np.isfinite(value) or value <= 0.0:
        raise SignalError(f"{name}: {value} (limit > 0)")
    return float(value)


def whole(value: float, name: str, minimum: int = 1) -> int:
    """Return `value` if it is a whole number that is large enough, else refuse it.

    Parameters
    ----------
    value
        Number [-].
    name
        What to call it in an error message.
    minimum
        Smallest number allowed [-].

    Raises
    ------
    SignalError
        If the number is not whole or below the minimum.
    """
    if isinstance(value, bool | np.bool_) or not np.isfinite(value) or value != int(value) or value < minimum:
        raise SignalError(f"{name}: {value} (limit: a whole number >= {minimum})")
    return int(value)


def finite(value: float, name: str) -> float:
    """Return `value` if it is a finite number, else refuse it.

    Parameters
    ----------
    value
        Number, any unit.
    name
        What to call it in an error message.

    Raises
    ------
    SignalError
        If the number is not finite.
    """
    if not np.isfinite(value):
        raise SignalError(f"{name}: {value} (limit: a finite number)")
    return float(value)
