# SPDX-License-Identifier: Apache-2.0
"""Reading of result files: as an `xarray.Dataset`, or single channels without importing xarray.

Supports complete files, files being written, and files of killed processes.
"""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.core.nearest import hint
from pitchpoint.io.container import ResultError
from pitchpoint.io.opening import member, members, open_file, opened, understood
from pitchpoint.io.writing import BLOCK_GROUP, EVENT_GROUP

if TYPE_CHECKING:
    import h5py
    import numpy as np
    import xarray as xr


def read_header(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Read the attributes of a result file: title, status, sentence, solver, options, ..."""
    with opened(path) as file:
        return header_in(file)


def header_in(file: h5py.File) -> dict[str, Any]:
    """Attributes of an open result file."""
    header: dict[str, Any] = {}
    for key, value in file.attrs.items():
        if isinstance(value, bytes):
            value = value.decode("utf-8")
        header[key] = value.item() if hasattr(value, "item") and not isinstance(value, str) else value
    header["options"] = json.loads(header.get("options", "{}"))
    return header


@contextlib.contextmanager
def open_table(path: str | os.PathLike[str], kind: str) -> Iterator[Mapping[str, h5py.Dataset]]:
    """Open a result file of one kind (`sweep`, `cases`) for a `with` block; yields its variables by name."""
    with opened(path) as file:
        found = file.attrs.get("kind")
        if found != kind:
            raise ResultError(f"{os.fspath(path)}: holds {found} results, not those of {kind}")
        yield {name: item for name, item in members(file).items() if hasattr(item, "shape")}


def list_channels(path: str | os.PathLike[str]) -> list[str]:
    """Names of the variables of a result file, without dimensions."""
    with opened(path) as file:
        return _channels(file)


def read_channel(
    path: str | os.PathLike[str], name: str, start: int = 0, stop: int | None = None, step: int = 1
) -> tuple[np.ndarray, np.ndarray]:
    """Read one channel of a run: times and values, both of shape (n,), in SI units.

    Parameters
    ----------
    path
        Result file, finished or not.
    name
        Channel, as in `mesh_force[stage]`.
    start, stop, step
        Range of samples, as in a slice.
    """
    with opened(path) as file:
        if "time" not in file:
            raise ResultError(f"{os.fspath(path)}: has no times; it is a result of kind {file.attrs['kind']}")
        if name not in file or name == BLOCK_GROUP:
            raise ResultError(f"{os.fspath(path)}: no channel {name!r}; {_suggest(name, file)}")
        time, channel = member(file, "time"), member(file, name)
        rows = slice(*slice(start, stop, step).indices(time.shape[0]))
        return time[rows], channel[rows]


def read_units(path: str | os.PathLike[str]) -> dict[str, str]:
    """Units of all variables of a result file, by name."""
    with opened(path) as file:
        arrays = {name: item for name, item in members(file).items() if hasattr(item, "shape")}
        found = {name: item.attrs.get("units", "") for name, item in arrays.items()}
    return {name: u.decode("utf-8") if isinstance(u, bytes) else str(u) for name, u in found.items()}


def open_result(path: str | os.PathLike[str], group: str | None = None) -> xr.Dataset:
    """Open a result file as a lazy `xarray.Dataset` with units, names and provenance in its attributes.

    Parameters
    ----------
    path
        Result file; a file being written is read up to its present end.
    group
        None for the signals or tables, `blocks` for the statistics of each block of a run.

    Returns
    -------
    xarray.Dataset
        One variable per channel over `time`, or the tables of a sweep or of modes over their own dimensions.
        A run with recorded events has `event_time` [s], `event_name` and `event_direction` over `event`.
        `attrs["status"]` is finished, failed, interrupted or running; `attrs["notes"]` are its notes.
        Close it, or use it in a `with` block. Copies, also pickled ones in other processes, read the file
        itself; once it has another result they refuse.
    """
    file = open_file(path)
    try:
        from pitchpoint.io.lazy import lazy_dataset

        with understood(path):
            dataset = lazy_dataset(path, file, group)
            for name, variable in ({} if group else _events(file)).items():
                dataset[name] = variable
    except BaseException:
        file.close()
        raise
    dataset.encoding["source"] = os.fspath(path)
    return dataset


def _events(file: h5py.File) -> dict[str, Any]:
    """Events of a run as variables, none for a file without them."""
    from pitchpoint.core.event_list import event_variables

    if EVENT_GROUP not in file:
        return {}
    group = members(member(file, EVENT_GROUP))
    n = min(group[name].shape[0] for name in ("time", "event", "direction"))
    names = group["event"].attrs["flag_meanings"].split(" ")
    return event_variables(group["time"][:n], group["event"][:n], group["direction"][:n], names)


def _channels(file: h5py.File) -> list[str]:
    """Variables that are not dimensions."""
    return [name for name, item in members(file).items() if hasattr(item, "shape") and not item.is_scale]


def _suggest(name: str, file: h5py.File) -> str:
    return hint(name, _channels(file), 3)
