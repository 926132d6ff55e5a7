# SPDX-License-Identifier: Apache-2.0
"""Records that can be diagnosed, from files."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.report.diagnosis_record import Record

Array = NDArray[np.float64]


class ResultChannels(Mapping[str, Array]):
    """Channels of a result file, each read when it is requested: a large machine has hundreds."""

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


def read_record(path: str, sample_rate: float | None = None) -> Record:
    """Read the channels of a time response, or of a measured file.

    Raises
    ------
    MeasuredError
        If the file is not a result and cannot be read as a measured one.
    SignalError
        If it holds no time series.
    """
    from pitchpoint.io.container import ResultError
    from pitchpoint.io.reading import read_channel, read_header, read_units

    try:
        header = read_header(path)
    except ResultError:
        return _measured(path, sample_rate)
    if header.get("kind") != "time":
        raise SignalError(
            f"{path}: holds {header.get('kind')} results (limit: a time response); run one first"
        )
    channels = ResultChannels(path)
    if not channels:
        raise SignalError(f"{path}: has no channel (limit 1); run the scenario again")
    time = read_channel(path, next(iter(channels)))[0]
    settle = float(header["options"].get("settle_time") or 0.0)
    return Record(
        time=np.asarray(time, dtype=np.float64),
        channels=channels,
        model_text=str(header.get("model_text", "")),
        scenario=str(header.get("scenario", "")),
        settle_time=settle,
        units=read_units(path),
        about={"format": "result of pitchpoint", "model": str(header.get("model_hash", ""))},
    )


def _measured(path: str, sample_rate: float | None) -> Record:
    """Read a measured file: all its channels over time."""
    from pitchpoint.io.measured.reading import read_measured

    data = read_measured(path, sample_rate=sample_rate)
    channels = {
        str(name): np.asarray(values.values, dtype=np.float64)
        for name, values in data.data_vars.items()
        if values.dims == ("time",)
    }
    return Record(
        np.asarray(data["time"].values, dtype=np.float64),
        channels,
        units={name: str(data[name].attrs.get("units", "")) for name in channels},
        about={
            "format": str(data.attrs.get("format", "")),
            "SHA-256": str(data.attrs.get("sha256", ""))[:16],
            "notes": str(data.attrs.get("notes", "")),
        },
    )
