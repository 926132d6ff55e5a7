# SPDX-License-Identifier: Apache-2.0
"""Read a record over time from a file."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.line_tests import LONG, fine_spectrum
from pitchpoint.analysis.sampled import SignalError, sample_rate_of
from pitchpoint.report.diagnosis.channels import matching

Array = NDArray[np.float64]


@dataclass(frozen=True)
class EvenTimes:
    """Times of evenly spaced samples; an array of them is as large as a channel.

    Attributes
    ----------
    start
        First time [s].
    step
        Sampling interval [s].
    size
        Number of samples [-].

    Examples
    --------
    >>> times = EvenTimes(1.0, 0.5, 4)
    >>> times[-1], np.asarray(times[1:]).tolist()
    (2.5, [1.5, 2.0, 2.5])
    """

    start: float
    step: float
    size: int

    def __getitem__(self, at: Any) -> Any:
        """Time of a sample, or times of several in sequence."""
        places = range(self.size)[at]
        if isinstance(places, int):
            return self.start + places * self.step
        return EvenTimes(self.start + places.start * self.step, places.step * self.step, len(places))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        """All times."""
        times = np.arange(self.size, dtype=np.float64)
        times *= self.step
        times += self.start
        return times


def even_times(time: Array) -> Array | EvenTimes:
    """Times of a long record in little memory if they are even, else as they are."""
    if time.size <= LONG:
        return time
    try:
        rate = sample_rate_of(time)
    except SignalError:
        return time
    return EvenTimes(float(time[0]), 1.0 / rate, time.size)


@dataclass
class Record:
    """Channels over time as stored in a file.

    Attributes
    ----------
    time
        Times [s], shape (n,); of long measured records only the interval.
    channels
        Values by channel, shape (n,) each.
    model_text
        Model stored in the file; empty if none.
    scenario
        Scenario of a result.
    settle_time
        Settling time that is not evaluated [s].
    units
        Unit of each channel, if known.
    about
        Format, fingerprint and notes of the file, by name.
    speed, speed_source
        Rotation frequency of a shaft given in the file [Hz], or None, and the name of this number.
    fault_orders
        Orders of the fault frequencies of a bearing given in the file [-] by BPFO, BPFI, BSF, FTF.
    rate_source
        Name of the number or time axis in the file that gives the sample rate.
    """

    time: Array | EvenTimes
    channels: Mapping[str, Array]
    model_text: str = ""
    scenario: str = ""
    settle_time: float = 0.0
    units: Mapping[str, str] = field(default_factory=dict)
    about: Mapping[str, str] = field(default_factory=dict)
    speed: float | None = None
    speed_source: str = ""
    fault_orders: Mapping[str, float] = field(default_factory=dict)
    rate_source: str = ""


def strongest_lines(values: Array, samples_per_turn: float) -> list[float]:
    """Orders of the four strongest lines [-], by falling amplitude."""
    spectrum = fine_spectrum(values, samples_per_turn)
    size = spectrum.amplitude.copy()
    apart = max(int(np.ceil(3.0 * spectrum.resolution / spectrum.step)), 1)
    size[:apart] = 0.0
    found = []
    for _ in range(4):
        top = int(np.argmax(size))
        found.append(top * spectrum.step)
        size[max(top - apart, 0) : top + apart + 1] = 0.0
    return found


class ResultChannels(Mapping[str, Array]):
    """Channels of a result file, each read on access: a large machine has hundreds."""

    def __init__(self, path: str) -> None:
        from pitchpoint.io.reading import list_channels

        self._path, self._names = path, dict.fromkeys(list_channels(path))
        self._names.pop("time", None)
        self._read: dict[str, Array] = {}

    def __getitem__(self, name: str) -> Array:
        from pitchpoint.io.reading import read_channel

        if name not in self._names:
            raise KeyError(name)
        if name not in self._read:
            self._read[name] = np.asarray(read_channel(self._path, name)[1], dtype=np.float64)
        return self._read[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


def read_record(
    paths: Sequence[str],
    sample_rate: float | None = None,
    channels: Sequence[str] | None = None,
    units: Mapping[str, str] | None = None,
) -> Record:
    """Read the channels of a time response or a measured file, or of files that were recorded together.

    Parameters
    ----------
    paths
        One file or more.
    sample_rate
        Sample rate given by the user [Hz], or None.
    channels
        Channels to which the record is reduced if not all of a measured file fit together.
    units
        Unit by channel of a measured file, in whose name `*` matches any characters.

    Raises
    ------
    MeasuredError
        If the file is neither a result nor a readable measured file.
    SignalError
        If it contains no time series.
    """
    from pitchpoint.io.container import ResultError
    from pitchpoint.io.reading import read_channel, read_header, read_units

    path = paths[0]
    if len(paths) > 1:
        return _measured(paths, sample_rate, channels, units)
    try:
        header = read_header(path)
    except ResultError:
        return _measured(paths, sample_rate, channels, units)
    if header.get("kind") != "time":
        raise SignalError(
            f"{path}: contains {header.get('kind')} results (limit: a time response); compute one first"
        )
    stored = ResultChannels(path)
    if not stored:
        raise SignalError(f"{path}: has no channel (limit 1); run the scenario again")
    time = read_channel(path, next(iter(stored)))[0]
    settle = float(header["options"].get("settle_time") or 0.0)
    return Record(
        time=np.asarray(time, dtype=np.float64),
        channels=stored,
        model_text=str(header.get("model_text", "")),
        scenario=str(header.get("scenario", "")),
        settle_time=settle,
        units=read_units(path),
        about={"format": "result of pitchpoint", "model": str(header.get("model_hash", ""))},
    )


def _measured(
    paths: Sequence[str],
    sample_rate: float | None,
    chosen: Sequence[str] | None,
    units: Mapping[str, str] | None,
) -> Record:
    """Read measured files: all channels over time, or the chosen ones if others prevent it."""
    from pitchpoint.io.measured.reading import read_measured
    from pitchpoint.io.measured.record import MeasuredError, as_options

    try:
        data = read_measured(paths, sample_rate=sample_rate)
    except MeasuredError:
        if not chosen:
            raise
        data = read_measured(paths, sample_rate=sample_rate, channels=list(dict.fromkeys(chosen)))
    if units:
        names = [str(name) for name in data.data_vars]
        unit_of = {name: unit for text, unit in units.items() for name in matching(text, names, "--unit")}
        data = read_measured(paths, sample_rate=sample_rate, channels=names, units=unit_of)
    channels = {
        str(name): np.asarray(values.values, dtype=np.float64)
        for name, values in data.data_vars.items()
        if values.dims == ("time",)
    }
    about = {key: str(data.attrs.get(key, "")) for key in ("format", "notes")}
    digests = [one[:16] for one in str(data.attrs.get("sha256", "")).split(", ")]
    speed = data.attrs.get("shaft_speed")
    return Record(
        even_times(np.asarray(data["time"].values, dtype=np.float64)),
        channels,
        units={name: str(data[name].attrs.get("units", "")) for name in channels},
        about={"format": about["format"], "SHA-256": ", ".join(digests), "notes": as_options(about["notes"])},
        speed=None if speed is None else float(speed) / math.tau,
        speed_source=str(data.attrs.get("shaft_speed_from", "")),
        fault_orders={
            key.removeprefix("fault_order[").removesuffix("]"): float(value)
            for key, value in data.attrs.items()
            if str(key).startswith("fault_order[")
        },
        rate_source=str(data.attrs.get("sample_rate_from", "")),
    )
