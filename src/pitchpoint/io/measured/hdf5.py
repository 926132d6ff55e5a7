# SPDX-License-Identifier: Apache-2.0
"""HDF5 files: results of pitchpoint, MAT files of version 7.3, netCDF-4, and other files with vectors."""

from __future__ import annotations

import contextlib
import subprocess
import sys
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.child import python_command, python_environment
from pitchpoint.io.container import FORMAT
from pitchpoint.io.measured.arrays import MAX_BYTES, Arrays, Found
from pitchpoint.io.measured.record import (
    Column,
    MeasuredError,
    Record,
    Wanted,
    as_floats,
    key_of,
    refused,
)
from pitchpoint.io.opening import Dimensions, heaps_end, is_elsewhere, members
from pitchpoint.io.unmarked_file import DAMAGE

if TYPE_CHECKING:
    import h5py

_MAX_OBJECTS = 20_000
_PACKED = 1100
"""Maximum compression ratio of an array (deflate: 1032)."""
_SMALL = 1 << 24
_WIDEST = 8
"""Bytes of a number in double precision: the numbers of a file that is not packed take that many times its
size at most."""
_HEAD = 1 << 16
_SLOWEST = 1e7
"""Bytes per second that even a slow disk reads."""
_KEPT = ("title", "scenario", "solver", "model_hash", "status", "notes", "kind")
_UNIT_NAMES, _WORD_NAMES = ("units", "unit"), ("long_name", "description", "title")


def is_own(path: Path, data: bytes) -> bool:
    """Whether this is a result file of pitchpoint; rejects files on which HDF5 would hang or crash.

    Files of pitchpoint have checksums wherever HDF5 supports them; other files are read in a separate process
    first.
    """
    remedy = "copy it again from where it was recorded"
    if not heaps_end(data):
        raise refused(
            path, "", "", "is damaged: a text is longer than the block that contains it", None, remedy
        )
    if data[8] == 3 and FORMAT.encode() in data[:_HEAD]:
        return True
    if not _survives(path, len(data)):
        raise refused(path, "", "", "is damaged so badly that HDF5 cannot read it", None, remedy)
    return False


def _survives(path: Path, size: int) -> bool:
    """Whether a process that reads this file survives."""
    code = (
        "import sys, pathlib\nfrom pitchpoint.io.measured.hdf5 import read_hdf5\n"
        "from pitchpoint.io.measured.record import Wanted\nread_hdf5(pathlib.Path(sys.argv[1]), Wanted())"
    )
    if not sys.executable:
        return True
    try:
        trial = subprocess.run(
            python_command("-c", code, str(path.resolve())),
            env=python_environment(),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=20.0 + size / _SLOWEST,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return False
    except OSError:
        return True  # if no process can be started, HDF5 is trusted
    return trial.returncode in (0, 1)


def read_hdf5(path: Path, wanted: Wanted) -> Record:
    """Read vectors, matrices and attributes of a foreign HDF5 file."""
    import h5py

    try:
        with h5py.File(path, "r") as file:
            matlab = file.userblock_size > 0
            most = max(MAX_BYTES, _WIDEST * path.stat().st_size) // _WIDEST
            found = Arrays(path, "MAT 7.3" if matlab else "HDF5", most)
            for name, value in _attributes(file).items():
                _take_attribute(found, name, value)
            for name, dataset in _datasets(path, file, found):
                _take(path, found, name, dataset)
            return found.record(wanted)
    except MeasuredError:
        raise
    except DAMAGE as error:
        raise _damaged(path, error, "copy it again from where it was recorded") from error


def _datasets(path: Path, file: h5py.File, found: Arrays) -> Iterator[tuple[str, h5py.Dataset]]:
    """Arrays of a file by levels, without those that describe others; numbers at groups are statements."""
    import h5py

    queue: list[tuple[str, Any]] = [("", file)]
    seen: set[Any] = set()
    while queue:
        name, item = queue.pop(0)
        if isinstance(item, h5py.Dataset):
            if h5py.check_ref_dtype(item.dtype) is None:
                yield name, item
                continue
            inner = _referenced(file, name, item, found)
        else:
            inner = [
                (f"{name}/{key}" if name else key, item[key])
                for key in item
                if not key.startswith("#") and isinstance(item.get(key, getlink=True), h5py.HardLink)
            ]
            for key, value in (_attributes(item) if name else {}).items():
                if isinstance(value, float):
                    found.state(f"{name}/{key}", value)
        for entry in inner:
            if len(seen) > _MAX_OBJECTS:
                raise refused(
                    path, "", f"{len(seen)} objects", "are too many", f"{_MAX_OBJECTS}", "export the channels"
                )
            address = h5py.h5o.get_info(entry[1].id).addr
            if address not in seen and isinstance(entry[1], h5py.Group | h5py.Dataset):
                seen.add(address)
                queue.append(entry)


def _referenced(file: h5py.File, name: str, dataset: h5py.Dataset, found: Arrays) -> list[tuple[str, Any]]:
    """Parts of a cell array, `c[1]`, or of a field of an array of structures, `y[1]/data`, of MATLAB."""
    if dataset.size > _MAX_OBJECTS or is_elsewhere(dataset):
        found.skip(name, "a list of too many parts")
        return []
    cell = _attributes(dataset).get("MATLAB_class") == "cell"
    owner, _, field = name.rpartition("/")
    parts = []
    for k, reference in enumerate(np.asarray(dataset[()]).ravel()):
        if reference:
            inner = f"{name}[{k}]" if cell or not owner else f"{owner}[{k}]/{field}"
            parts.append((inner, file[reference]))
    return parts


def _attributes(item: Any) -> dict[str, Any]:
    """Attributes that can be read as a text or a number."""
    found: dict[str, Any] = {}
    for name in list(item.attrs)[:200]:
        with contextlib.suppress(*DAMAGE):
            value = item.attrs[name]
            if isinstance(value, bytes | np.bytes_):
                value = value.decode("utf-8", "replace")
            if isinstance(value, np.ndarray):
                if value.size != 1:
                    continue
                value = value.reshape(-1)[0]
                value = value.decode("utf-8", "replace") if isinstance(value, bytes) else value
            if isinstance(value, str):
                found[name] = value
            elif isinstance(value, int | float | np.integer | np.floating):
                found[name] = float(value)
    return found


def _take_attribute(found: Arrays, name: str, value: Any) -> None:
    if isinstance(value, str):
        found.text(name, value)
    else:
        found.number(name, value)


def _take(path: Path, found: Arrays, name: str, dataset: h5py.Dataset) -> None:
    """Add one array with its unit, description and sample rate."""
    attributes = _attributes(dataset)
    kind = dataset.dtype.kind
    if "MATLAB_object_decode" in attributes:
        return found.skip(name, "an object, such as a table")
    if attributes.get("MATLAB_class") == "char" and dataset.size <= 1000 and not is_elsewhere(dataset):
        found.text(
            name, "".join(chr(c) for c in np.asarray(dataset[()], dtype=np.int64).ravel() if 0 < c < 0x110000)
        )
        return None
    if kind == "V" and dataset.dtype.names and set(dataset.dtype.names) == {"real", "imag"}:
        return found.skip(name, "complex numbers")
    if (
        kind not in "fiub"
        or attributes.get("MATLAB_class") in ("cell", "struct")
        or "MATLAB_empty" in attributes
    ):
        return None if kind == "O" or "MATLAB_empty" in attributes else found.skip(name, "no numbers")
    if dataset.shape is None or dataset.attrs.get("CLASS") == b"DIMENSION_SCALE" and _bare(dataset):
        return None
    unit = next((str(attributes[k]) for k in _UNIT_NAMES if isinstance(attributes.get(k), str)), "")
    words = next((str(attributes[k]) for k in _WORD_NAMES if isinstance(attributes.get(k), str)), "")
    for key, value in attributes.items():
        if isinstance(value, float):
            found.state(f"{name}/{key}", value)
    start = next(
        (v for k, v in attributes.items() if key_of(k) in ("t0", "wf_start_offset") and isinstance(v, float)),
        0.0,
    )
    gain, shift = (attributes.get(k, d) for k, d in (("scale_factor", 1.0), ("add_offset", 0.0)))
    scaled = isinstance(gain, float) and isinstance(shift, float) and (gain, shift) != (1.0, 0.0)
    found.add(
        Found(
            name,
            partial(_numbers, path, name, dataset, (gain, shift) if scaled else None),
            dataset.shape,
            unit,
            words,
            f"{gain:g} times the number stored, plus {shift:g}" if scaled else "",
            start=start,
        )
    )
    return None


def _bare(dataset: h5py.Dataset) -> bool:
    """Whether this is a dimension of netCDF without a variable."""
    return str(dataset.attrs.get("NAME", b"")).find("not a netCDF variable") >= 0


def _numbers(path: Path, name: str, dataset: h5py.Dataset, scale: tuple[float, float] | None) -> np.ndarray:
    """Numbers of an array, if it is stored in the file and consistent with the file size."""
    if is_elsewhere(dataset):
        remedy = "store its numbers in this file, or choose other channels"
        raise refused(path, name, "", "is stored in another file, which is not read", None, remedy)
    promised, stored = dataset.size * dataset.dtype.itemsize, int(dataset.id.get_storage_size())
    if promised > _SMALL and promised > _PACKED * min(stored, path.stat().st_size):
        raise refused(
            path,
            name,
            f"{promised} bytes",
            f"are promised where {stored} are stored",
            f"{_PACKED} times what is stored",
            "the array was not written to its end; shorten it, or record again",
        )
    values = np.asarray(dataset[()])
    return values if scale is None else as_floats(values) * scale[0] + scale[1]


def read_own(path: Path, wanted: Wanted) -> Record:
    """Read the time signals of a result file of pitchpoint, up to the last written sample.

    The file is opened without SWMR: in this mode HDF5 waits a long time for a damaged file to become
    consistent.
    """
    import h5py

    try:
        with h5py.File(path, "r") as file:
            about = {key: value for key, value in _attributes(file).items() if key in _KEPT and value != ""}
            if "time" not in file:
                kind = str(file.attrs["kind"])
                what = (
                    "is damaged: it has no times"
                    if kind == "time"
                    else f"is a result of kind {kind}, without time signals"
                )
                raise refused(path, "", "", what, None, "name a result of run")
            items, dimensions = members(file), Dimensions(file)
            arrays = {n: v for n, v in items.items() if isinstance(v, h5py.Dataset)}
            found = {n: v for n, v in arrays.items() if _over_time(v, dimensions)}
            count = min(v.shape[0] for v in (items["time"], *found.values()))
            columns = tuple(_own_column(path, v, n, count) for n, v in found.items() if wanted.takes(n))
            time = Column("time", _numbers(path, "time", items["time"], None)[:count], "s")
    except MeasuredError:
        raise
    except DAMAGE as error:
        raise _damaged(path, error, "run the model again") from error
    notes = [str(about.pop("notes"))] if "notes" in about else []
    if about.get("status") not in (None, "finished"):
        notes.append(f"the run has not finished: {about['status']}")
    return Record("pitchpoint result", columns, time, attributes=about, notes=tuple(notes))


def _over_time(dataset: h5py.Dataset, dimensions: Dimensions) -> bool:
    return len(dataset.shape) == 1 and not dataset.is_scale and dimensions.of(dataset) == ("time",)


def _own_column(path: Path, dataset: h5py.Dataset, name: str, count: int) -> Column:
    values, about = _numbers(path, name, dataset, None)[:count], _attributes(dataset)
    return Column(name, as_floats(values), str(about.get("units", "")), str(about.get("long_name", "")))


def _damaged(path: Path, error: Exception, remedy: str) -> MeasuredError:
    """Error for an inconsistent file, with the message of the library."""
    reason = ""
    if isinstance(error, OSError | RuntimeError):
        reason = str(error).partition("(")[0].strip().rstrip(":")[:120]
    words = "is damaged or cut off" + (f" ({reason.lower()})" if reason else "")
    return refused(path, "", "", words, None, remedy)
