# SPDX-License-Identifier: Apache-2.0
"""Checks of sampled data common to all analysis functions.

Measured and simulated signals are passed to the analysis as plain arrays.

Derivation: docs/theory/signals.md, "Signals".
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.units import format_quantity

Array = NDArray[np.float64]
Lines = NDArray[np.complex128]

# Maximum relative jitter of the sampling interval of a uniform time axis. Times written as decimal text or
# accumulated in floating point are well below it; a lost sample is six orders of magnitude above.
UNIFORM_TOLERANCE = 1e-6
AT_ONCE = 1 << 20
"""Steps of a time axis that are checked at once, to limit memory."""


class SignalError(PitchpointError, ValueError):
    """Sampled data are not suitable for an analysis function; the message gives location and remedy."""


def as_signal(values: ArrayLike, name: str = "values", minimum: int = 2) -> Array:
    """Return `values` as a one-dimensional array of finite floats.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    name
        Name of the signal in error messages.
    minimum
        Minimum number of samples.

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
    """Return `values` as a strictly increasing signal, such as a time axis.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    name
        Name of the signal in error messages.
    minimum
        Minimum number of samples.

    Raises
    ------
    SignalError
        If a sample is not larger than the preceding one.

    Examples
    --------
    >>> as_increasing([0.0, 0.5, 0.6])
    array([0. , 0.5, 0.6])
    """
    axis = as_signal(values, name, minimum)
    back = np.flatnonzero(axis[1:] <= axis[:-1])
    if back.size:
        raise SignalError(
            f"{name}: does not increase after sample {back[0]}; sort it and drop repeated samples"
        )
    return axis


def one_way(angle: ArrayLike, time: ArrayLike | None = None) -> Array:
    """Angle as an increasing function [rad]: negated for a shaft with negative rotation.

    Parameters
    ----------
    angle
        Unwrapped angle [rad], shape (n,).
    time
        Times [s] for the message, shape (n,).

    Raises
    ------
    SignalError
        If the shaft stops or reverses, with the first place where it does.

    Examples
    --------
    >>> one_way([0.0, -1.0, -3.0])
    array([0., 1., 3.])
    """
    phi = as_signal(angle, "angle")
    steps = np.diff(phi)
    moving = steps[steps != 0.0]
    # the direction at the start: a record through zero speed may end where it began
    if moving.size and moving[0] < 0.0:
        phi, steps = 0.0 - phi, -steps
    stop = np.flatnonzero(steps <= 0.0)
    if stop.size:
        k = int(stop[0])
        where = "" if time is None else f" at {format_quantity(float(as_signal(time, 'time')[k]), 'time', 4)}"
        raise SignalError(
            f"angle: the shaft stops or reverses{where or f' after sample {k}'}; "
            "cut the record there, or unwrap the angle"
        )
    return phi


def same_length(first: Array, second: Array, names: str) -> None:
    """Raise if two channels differ in length.

    Parameters
    ----------
    first
        Samples of one channel, shape (n,).
    second
        Samples of the other channel, shape (n,).
    names
        Names of both channels in error messages.

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
        If the relative variation of the spacing exceeds 1e-6.

    Examples
    --------
    >>> round(sample_rate_of([0.0, 0.25, 0.5, 0.75]), 9)
    4.0
    """
    axis = as_increasing(time)
    step = (axis[-1] - axis[0]) / (axis.size - 1)
    # the second term is the floating-point resolution of the largest time
    allowed = UNIFORM_TOLERANCE * step + 4.0 * np.finfo(np.float64).eps * float(np.abs(axis[[0, -1]]).max())
    places = range(0, axis.size - 1, AT_ONCE)
    off = max(float(np.abs(np.diff(axis[k : k + AT_ONCE + 1]) - step).max()) for k in places)
    if off > allowed:
        raise SignalError("time: is not uniformly spaced; resample the record first")
    return float(1.0 / step)


def positive(value: float, name: str) -> float:
    """Return `value` if it is a finite number above zero; raise otherwise.

    Parameters
    ----------
    value
        Number, any unit.
    name
        Name of the number in error messages.

    Raises
    ------
    SignalError
        If the number is not finite or not above 0.
    """
    if not np.isfinite(value) or value <= 0.0:
        raise SignalError(f"{name}: {value} (limit > 0)")
    return float(value)


def whole(value: float, name: str, minimum: int = 1) -> int:
    """Return `value` if it is a whole number of at least `minimum`; raise otherwise.

    Parameters
    ----------
    value
        Number [-].
    name
        Name of the number in error messages.
    minimum
        Minimum value [-].

    Raises
    ------
    SignalError
        If the number is not whole or below the minimum.
    """
    if isinstance(value, bool | np.bool_) or not np.isfinite(value) or value != int(value) or value < minimum:
        raise SignalError(f"{name}: {value} (limit: a whole number >= {minimum})")
    return int(value)


def finite(value: float, name: str) -> float:
    """Return `value` if it is a finite number; raise otherwise.

    Parameters
    ----------
    value
        Number, any unit.
    name
        Name of the number in error messages.

    Raises
    ------
    SignalError
        If the number is not finite.
    """
    if not np.isfinite(value):
        raise SignalError(f"{name}: {value} (limit: a finite number)")
    return float(value)
