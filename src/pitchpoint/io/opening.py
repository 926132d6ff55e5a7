# SPDX-License-Identifier: Apache-2.0
"""Opening of result files: complete, growing, incomplete after a kill, and damaged ones.

In the mode for growing files (SWMR) HDF5 rereads a block with an invalid checksum repeatedly, with a pause
that doubles each time: a damaged file practically hangs. Every file is therefore first opened without this
mode, in which HDF5 reports errors immediately. Only a file with the status running is reopened with SWMR,
after all its names, shapes, attributes and block addresses have been checked.
"""

from __future__ import annotations

import contextlib
import os
import time
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import PitchpointError
from pitchpoint.io.container import FORMAT, RUNNING, ResultError
from pitchpoint.io.unmarked_file import DAMAGE, UnmarkedFile
from pitchpoint.io.write_lock import share

if TYPE_CHECKING:
    import h5py

PATIENCE = 5.0
"""Timeout for a writer that is creating its file or writing a block [s]."""
_PAUSE = 0.02
_LOOKS = 3
"""Number of attempts after which an unreadable, unchanged file counts as damaged."""

NUMBERS = ("steps", "wall_s", "status_code")
"""Attributes of a result file that are numbers; all others are texts."""
_HEAP = b"GCOL\1\0\0\0"
_TEXTS_END = 1 << 24
"""Texts are created before the first sample; samples follow after these bytes."""


@contextlib.contextmanager
def opened(path: str | os.PathLike[str]) -> Iterator[h5py.File]:
    """Open a result file for a `with` block; damage found in the block is reported as `ResultError`."""
    file = open_file(path)
    try:
        with understood(path):
            yield file
    finally:
        file.close()


@contextlib.contextmanager
def understood(path: str | os.PathLike[str]) -> Iterator[None]:
    """Report variables, dimensions or types that differ from those expected in the block as `ResultError`.

    Raises
    ------
    ResultError
        Instead of the exceptions of HDF5, NumPy and xarray.
    """
    try:
        yield
    except PitchpointError:
        raise
    except DAMAGE as error:
        raise damaged(path, error) from error


def member(group: h5py.Group, name: str) -> h5py.Group | h5py.Dataset:
    """Object of a result file, if it is stored in the file itself.

    Raises
    ------
    ValueError
        For links, external storage and virtual datasets: HDF5 would read other files.
    """
    import h5py

    if not isinstance(group.get(name, getlink=True), h5py.HardLink):
        raise ValueError(f"{name} is a link to somewhere else")
    item = group[name]
    if isinstance(item, h5py.Dataset) and is_elsewhere(item):
        raise ValueError(f"{name} is stored in another file")
    return item


def is_elsewhere(item: h5py.Dataset) -> bool:
    """Whether the numbers of an array are stored in another file: external storage, or a virtual dataset."""
    import h5py

    made = item.id.get_create_plist()
    return bool(made.get_layout() == h5py.h5d.VIRTUAL or made.get_external_count())


def members(group: h5py.Group) -> dict[str, h5py.Group | h5py.Dataset]:
    """All objects of a group of a result file by name, checked by `member`."""
    return {name: member(group, name) for name in group}


class Dimensions:
    """Dimension scales of a file.

    A scale that a reference gives has no name; HDF5 would look for it in all groups, for each axis of each
    variable again. Here one table of addresses is used.

    Parameters
    ----------
    file
        The open file.
    """

    def __init__(self, file: h5py.File) -> None:
        import h5py

        self._names: dict[int, str] = {}
        for _, inside in _groups(file):
            for name, item in inside.items():
                if isinstance(item, h5py.Dataset) and item.is_scale and item.ndim == 1:
                    self._names[_address(item)] = name

    def of(self, item: h5py.Dataset) -> tuple[str, ...]:
        """Names of the dimensions of a variable, without groups; a scale is its own dimension.

        The references are followed individually: the HDF5 function H5DSiterate_scales crashes the process if
        a reference is invalid.

        Raises
        ------
        ValueError
            If an axis has no scale.
        """
        if item.is_scale:
            places = [item]
        else:
            lists = item.attrs["DIMENSION_LIST"] if item.ndim else ()
            places = [item.file[references[0]] for references in lists]
        names = tuple(self._names.get(_address(place), "") for place in places)
        if len(names) != item.ndim or not all(names):
            raise ValueError(f"the dimensions of {item.name} are missing")
        return names


def _groups(file: h5py.File) -> Iterator[tuple[h5py.Group, dict[str, h5py.Group | h5py.Dataset]]]:
    """All groups of a file with their members, each once: a damaged file may have a group within itself."""
    import h5py

    waiting: list[h5py.Group] = [file]
    known = {_address(file)}
    while waiting:
        group = waiting.pop()
        inside = members(group)
        yield group, inside
        for item in inside.values():
            if isinstance(item, h5py.Group) and _address(item) not in known:
                known.add(_address(item))
                waiting.append(item)


def _address(item: h5py.HLObject) -> int:
    """Place of an object in its file."""
    import h5py

    return int(h5py.h5o.get_info(item.id).addr)


def open_file(path: str | os.PathLike[str]) -> h5py.File:
    """Open a result file for reading, also while it is written, or report the reason why it cannot be read.

    Raises
    ------
    ResultError
        If the file does not exist, is just being created, is not a result of pitchpoint, or is damaged.
    """
    name, before, same = os.fspath(path), None, 0
    until = time.monotonic() + PATIENCE
    while True:
        try:
            return _open_unmarked(name)
        except FileNotFoundError as error:
            raise ResultError(f"{name}: there is no such result file") from error
        except ResultError:
            raise
        except DAMAGE as error:
            if isinstance(error, BlockingIOError):
                if time.monotonic() > until:
                    remedy = "try again when it has begun"
                    raise ResultError(f"{name}: is locked by another process; {remedy}") from error
            else:
                now = _stamp(name)
                same = same + 1 if now == before else 0
                before, (size, changed) = now, now
                if time.time() - changed > PATIENCE or (same >= _LOOKS and size > 0):
                    raise damaged(name, error) from error
            time.sleep(_PAUSE)


def damaged(path: str | os.PathLike[str], error: Exception) -> ResultError:
    """Error for an inconsistent file, with the message of the library."""
    if isinstance(error, PermissionError):
        return ResultError(f"{os.fspath(path)}: may not be read by this user")
    reason = " ".join(str(error).split())[:200] or type(error).__name__
    name = os.fspath(path)
    return ResultError(f"{name}: is not a readable HDF5 file, damaged or incomplete ({reason}); rerun")


def heaps_end(data: Any, until: int | None = None) -> bool:
    """Whether the texts of a file are in sequence up to the end of their heaps.

    A heap is a chain of (index, length), which HDF5 follows without checks (HDF5 File Format Specification
    3.0, III.E). `data` are bytes; heaps are searched up to the byte `until`.
    """
    stop = len(data) if until is None else until
    heap = data.find(_HEAP, 0, stop)
    while heap >= 0:
        at, end = heap + 16, heap + int.from_bytes(data[heap + 8 : heap + 16], "little")
        if end > len(data):
            return False
        while at + 16 <= end:
            index, size = data[at : at + 2], int.from_bytes(data[at + 8 : at + 16], "little")
            free = index == b"\0\0"
            step = size if free else 16 + size + -size % 8
            if step < 16 or at + step > end or (free and at + step != end):
                return False
            at += step
        heap = data.find(_HEAP, heap + 8, stop)
    return True


def _open_unmarked(name: str) -> h5py.File:
    """Open without SWMR and check the present contents."""
    import h5py

    unmarked = UnmarkedFile(name)
    try:
        if not share(unmarked.fileno()):
            raise BlockingIOError
        if not _texts_end(unmarked):
            raise ValueError("a text is longer than the block that contains it")
        file = h5py.File(unmarked, "r")
    except BaseException:
        unmarked.close()
        raise
    try:
        if _text(file.attrs.get("format")) != FORMAT:
            raise ResultError(f"{name}: is an HDF5 file, but not a result file of the format {FORMAT}")
        _check_texts(file)
        if _text(file.attrs.get("status")) != RUNNING:
            return file
        _look_through(file)
        with contextlib.suppress(OSError):
            growing = h5py.File(name, "r", libver="latest", swmr=True)
            file.close()
            return growing
        return file
    except BaseException:
        file.close()
        unmarked.close()
        raise


def _check_texts(file: h5py.File) -> None:
    """Raise `ValueError` if an attribute that describes the result is not a single text."""
    for name in file.attrs:
        item = file.attrs.get_id(name)
        if name not in NUMBERS and (item.shape != () or item.dtype.kind not in "OS"):
            raise ValueError(f"the attribute {name} is not a text")


def _texts_end(file: UnmarkedFile) -> bool:
    """Whether the texts end. Not memory-mapped: gaps of a file on a full tmpfs would crash the process."""
    size = os.fstat(file.fileno()).st_size
    for room in (_TEXTS_END, 4 * _TEXTS_END):  # the text of a large model may exceed the first
        data = bytearray(min(size, room))
        file.seek(0)
        file.readinto(data)
        if heaps_end(data, _TEXTS_END):
            return True
        if size <= room:
            break
    return False


def _look_through(file: h5py.File) -> None:
    """Access all objects, attributes and block addresses; damage raises an error."""
    import h5py

    size, dimensions = file.id.get_filesize(), Dimensions(file)
    for group, inside in _groups(file):
        for item in (group, *inside.values()):
            for name in item.attrs:
                item.attrs[name]
        for item in inside.values():
            if isinstance(item, h5py.Dataset):
                _look_at(item, size)
                dimensions.of(item)


def _look_at(item: h5py.Dataset, size: int) -> None:
    """Whether an array of its declared size fits in a file of this size."""
    if item.id.get_storage_size() > size:
        raise ValueError(f"{item.name} is larger than its file")
    if item.chunks:
        count = item.id.get_num_chunks()
        most = 1
        for length, step in zip(item.shape, item.chunks, strict=True):
            most *= -(-length // step)
        if count > most + 1:  # a killed writer may have stored a block before the length of the array
            raise ValueError(f"{item.name} has {count} blocks where {most} have room")


def _text(value: Any) -> str:
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def _stamp(name: str) -> tuple[int, float]:
    """Size and time of the last change, which a writer changes."""
    try:
        found = Path(name).stat()
    except OSError:
        return 0, 0.0
    return found.st_size, found.st_mtime
