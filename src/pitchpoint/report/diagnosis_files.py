# SPDX-License-Identifier: Apache-2.0
"""Records that can be diagnosed, from files."""

from __future__ import annotations

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.report.diagnosis_record import Record


def read_record(path: str) -> Record:
    """Read the channels of a time response.

    Raises
    ------
    ResultError
        If the file is no result, or a damaged one.
    SignalError
        If it holds no time series.
    """
    from pitchpoint.io.reading import open_result, read_header

    header = read_header(path)
    if header.get("kind") != "time":
        raise SignalError(f"{path}: holds {header.get('kind')} results (limit: a time response); run one first")
    with open_result(path) as data:
        data.load()
        channels = {
            str(name): values.values.astype(float)
            for name, values in data.data_vars.items()
            if values.dims == ("time",) and values.dtype.kind in "fiu"
        }
        units = {name: str(data[name].attrs.get("units", "")) for name in channels}
        time = data["time"].values.astype(float)
    settle = float(header["options"].get("settle_time") or 0.0)
    return Record(time, channels, units, str(header.get("model_text", "")), str(header.get("scenario", "")), settle)
