# SPDX-License-Identifier: Apache-2.0
"""Shaft angle from a tacho channel as an additional channel of a record."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.tacho import tacho_angle
from pitchpoint.core.errors import join_notes, split_notes

if TYPE_CHECKING:
    import xarray as xr


def with_shaft_angle(dataset: xr.Dataset, tacho: str, *, pulses_per_revolution: int) -> xr.Dataset:
    """Add the angle of a shaft from tacho pulses, and cut the record to where it is known.

    Parameters
    ----------
    dataset
        Record with channels over `time` [s].
    tacho
        Channel with the pulses, any unit.
    pulses_per_revolution
        Pulses per revolution of the shaft [-].

    Returns
    -------
    xarray.Dataset
        The record from the first pulse to the last, with the additional channel `angle[TACHO]` [rad]; missing
        and surplus pulses are listed in `attrs["notes"]`.

    Raises
    ------
    SignalError
        If the channel does not exist, or its pulses give no angle.

    Notes
    -----
    See `tacho.tacho_angle` [1]_.

    References
    ----------
    .. [1] K. R. Fyfe, E. D. S. Munck, Analysis of computed order tracking, Mechanical Systems and Signal
       Processing 11(2), 1997, 187-205.

    Examples
    --------
    >>> import xarray as xr
    >>> t = np.arange(4000) / 1000.0
    >>> record = xr.Dataset({"tacho": ("time", 1.0 * (np.mod(10.0 * t, 1.0) > 0.8))}, {"time": t})
    >>> turned = with_shaft_angle(record, "tacho", pulses_per_revolution=1)
    >>> angle = turned["angle[tacho]"]
    >>> round(float((angle[-1] - angle[0]) / (2 * np.pi) / (angle.time[-1] - angle.time[0])), 2)
    10.0
    """
    if tacho not in dataset.data_vars or dataset[tacho].dims != ("time",):
        listed = ", ".join(str(n) for n, v in dataset.data_vars.items() if v.dims == ("time",)) or "none"
        raise SignalError(f"tacho: {tacho!r} is not a channel over time; there are {listed}")
    values = np.asarray(dataset[tacho].values, dtype=np.float64)
    try:
        found = tacho_angle(values, dataset["time"].values, pulses_per_revolution=pulses_per_revolution)
    except SignalError as error:
        raise SignalError(f"tacho {tacho}: {error}") from error
    known = slice(found.first_sample, found.first_sample + found.angle.size)
    words = {"units": "rad", "long_name": f"angle of the shaft of {tacho}"}
    made = dataset.isel(time=known).assign({f"angle[{tacho}]": ("time", found.angle, words)})
    odd = [
        f"{tacho}: {times.size} pulses {what}, the first at {times[0]:.6g} s"
        for what, times in (("were missing", found.missing), ("too many were omitted", found.doubled))
        if times.size
    ]
    made.attrs["notes"] = join_notes([*split_notes(str(dataset.attrs.get("notes", ""))), *odd])
    return made
