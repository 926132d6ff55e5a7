# SPDX-License-Identifier: Apache-2.0
"""Result container: one HDF5 file that is also a netCDF-4 file and can be read at any time.

Dimension scales, one variable per quantity and text attributes make the file netCDF-4. The single-writer
multiple-reader mode (SWMR) of HDF5 orders the writes, so that another process can read the growing file and
all flushed data survive if the process is killed. In this mode no object and no attribute can be added;
therefore all of them are created first and `begin` freezes the structure. `status`, `sentence` and `notes`
are text attributes of fixed length and can still change. `status` is `running` from the start: a file with
this status but without a writing process is incomplete.
"""

from __future__ import annotations

import contextlib
import datetime
import errno
import json
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import PitchpointError, join_notes
from pitchpoint.core.status import NOT_WRITTEN
from pitchpoint.io.disk_fault import WriteError, abandon, conclude
from pitchpoint.io.superblock import clear_writer_flag
from pitchpoint.io.target import cannot_be_written, check_target, disk_errno, make_folder
from pitchpoint.io.write_lock import hold, is_at, keep, remove_old

if TYPE_CHECKING:
    import h5py

FORMAT = "pitchpoint-1"
RUNNING, FINISHED, FAILED, INTERRUPTED = "running", "finished", "failed", "interrupted"
_LENGTHS = {"status": 16, "sentence": 512, "notes": 4096}
# Every netCDF reader has these two filters; the C library does not support faster ones (lzf, blosc).
_PACKING: dict[str, Any] = {"compression": "gzip", "compression_opts": 1, "shuffle": True}
# NetCDF-4 marks dimensions without a variable by this name of their scale.
_NO_COORDINATE = "This is a netCDF dimension but not a netCDF variable."
_ROOM, _ROOM_OF_VARIABLE = 24_000, 1_000
"""Estimated bytes of the structure; measured: 16 kB per file and 550 to 750 B per variable."""
_CHUNK_CACHE = 65536  # bytes per variable: whole chunks are written, so a cache only costs memory


class ResultError(PitchpointError, OSError):
    """A result file cannot be created, opened or interpreted."""


@dataclass(frozen=True)
class Header:
    """Provenance of a result file.

    `options` contains the solver options as plain numbers and texts, `model_text` the model file.
    Without `stamped` the creation time is omitted, so that equal results give equal files.
    """

    kind: str
    title: str = ""
    scenario: str = ""
    solver: str = ""
    model_hash: str = ""
    model_text: str = ""
    options: Mapping[str, Any] = field(default_factory=dict)
    stamped: bool = True


class Container:
    """Result file being written; base of the writers for time series and tables.

    Parameters
    ----------
    path
        File to write; an existing result file is replaced unless another process writes it, any other file is
        rejected; the folder is created.
    header
        Provenance, stored as attributes of the file.
    variables, values
        Number of variables and bytes of their values up to `begin`. A disk without space for them is rejected
        here, because HDF5 can crash if the disk fills up before the file structure is complete.
    """

    def __init__(
        self, path: str | os.PathLike[str], header: Header, variables: int = 0, values: int = 0
    ) -> None:
        self.path = check_target(path, "result")
        self.file = self._make_file()
        self._open = True
        self._growing: list[h5py.Dataset] = []
        self._flushed: dict[str, int] | None = None  # lengths at the last flush, None before the first
        room = _ROOM + _ROOM_OF_VARIABLE * variables + values + len(header.model_text.encode("utf-8"))
        with self.writing():
            self._check_room(room)
            self._describe_file(header)

    def _check_room(self, size: int) -> None:
        """Reserve bytes beyond the end of the file and release them for HDF5.

        Raises
        ------
        OSError
            If the disk has no space for them.
        """
        if hasattr(os, "posix_fallocate"):
            descriptor = self.file.id.get_vfd_handle()
            end = os.fstat(descriptor).st_size
            os.posix_fallocate(descriptor, end, size)
            os.ftruncate(descriptor, end)

    def _describe_file(self, header: Header) -> None:
        """Write provenance and status first, so that an incomplete file identifies its source."""
        import h5py

        from pitchpoint.core.provenance import package_version

        attributes = self.file.attrs
        attributes["Conventions"] = "CF-1.11"
        attributes["format"] = FORMAT
        attributes["kind"] = header.kind
        attributes["title"] = header.title
        attributes["source"] = f"pitchpoint {package_version()}"
        attributes["package_version"] = package_version()
        now = datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds")
        attributes["created"] = now if header.stamped else ""
        attributes["model_hash"] = header.model_hash
        attributes["scenario"] = header.scenario
        attributes["solver"] = header.solver
        attributes["options"] = json.dumps(dict(header.options), default=str, sort_keys=True)
        attributes["model_text"] = header.model_text
        attributes["steps"] = 0
        attributes["wall_s"] = 0.0
        attributes["status_code"] = 0
        self._text = {}
        for name, length in _LENGTHS.items():
            self._text[name] = (h5py.string_dtype("utf-8", length), length)
            attributes.create(name, _cut("", length), dtype=self._text[name][0])
        self._set_text("status", RUNNING)
        self._flush()

    @contextlib.contextmanager
    def writing(self) -> Iterator[None]:
        """Context manager for all writes to the file; a failed write abandons the file.

        Raises
        ------
        WriteError
            With the reason; the file is closed, retains flushed data, and has the status of a failed run.
        """
        try:
            yield
        except PitchpointError:
            raise
        except (OSError, RuntimeError) as error:
            raise self._give_up(error) from error
        except KeyboardInterrupt:
            if self._flushed is None:  # the structure is not complete, and the file cannot be read
                self._abandon()
            raise

    def _give_up(self, error: OSError | RuntimeError) -> PitchpointError:
        """Abandon the file after storing the reason in it; return the error to raise."""
        kept = self._abandon()
        fault: PitchpointError = WriteError(self.path, error, kept=kept)
        if disk_errno(error) == errno.EAGAIN:
            fault = ResultError(cannot_be_written(self.path, BlockingIOError()))
        if kept:
            texts = {"status": self._fixed("status", FAILED), "sentence": self._fixed("sentence", str(fault))}
            conclude(self._place, texts, NOT_WRITTEN, self._flushed or {})
        return fault

    def _abandon(self) -> bool:
        """Close the file without writing; False if no data are retained and the file is removed."""
        there = False  # a file of this name by another writer is not touched
        with contextlib.suppress(OSError, RuntimeError):
            there = is_at(self.file.id.get_vfd_handle(), self._place)
        kept = there and self._flushed is not None
        self._open = False
        self._growing.clear()
        abandon(self.file)
        if there and not kept:
            with contextlib.suppress(OSError):
                self._place.unlink()
        return kept

    def _make_file(self) -> h5py.File:
        """Replace an existing file by a new one; links remain valid."""
        import h5py

        self._place = place = self.path.resolve()
        try:
            make_folder(place)
            mode = remove_old(place)
            # "w" would empty the file of another writer before it is known to be locked
            file = h5py.File(place, "x", libver="latest", rdcc_nbytes=_CHUNK_CACHE, locking=False)
            if not hold(file.id.get_vfd_handle(), place):
                abandon(file)
                raise BlockingIOError
        except (OSError, ValueError) as error:
            raise ResultError(cannot_be_written(self.path, error)) from error
        if mode is not None:
            with contextlib.suppress(OSError):  # a file system without permissions
                place.chmod(mode)
        return file

    def dimension(
        self,
        name: str,
        values: Any = None,
        *,
        group: str = "",
        unlimited: bool = False,
        chunk: int = 1024,
        packed: bool = False,
        dtype: str = "f8",
        attributes: Mapping[str, str] | None = None,
    ) -> h5py.Dataset:
        """Create a dimension with its coordinate; texts are stored as variable-length UTF-8.

        A number as `values` creates a dimension of that length without a coordinate.
        """
        import h5py

        where = self.file.require_group(group) if group else self.file
        if isinstance(values, int):
            bare = where.create_dataset(name, (values,), dtype="i1")
            bare.make_scale(f"{_NO_COORDINATE}{values:10d}")
            return bare
        if unlimited:
            filters = _PACKING if packed else {}
            made = where.create_dataset(name, (0,), maxshape=(None,), chunks=(chunk,), dtype=dtype, **filters)
            self._growing.append(made)
        elif len(values) and isinstance(values[0], str):
            made = where.create_dataset(name, data=list(values), dtype=h5py.string_dtype("utf-8"))
        else:
            made = where.create_dataset(name, data=values, dtype=dtype)
        made.make_scale(name)
        _describe(made, attributes)
        return made

    def variable(
        self,
        name: str,
        scales: Sequence[h5py.Dataset],
        *,
        group: str = "",
        dtype: str = "f4",
        chunks: tuple[int, ...] | None = None,
        packed: bool = False,
        attributes: Mapping[str, str] | None = None,
    ) -> h5py.Dataset:
        """Create a variable over existing dimensions; unwritten values read as NaN (integers: -1).

        The type `text` is for tables that are filled before `begin`: HDF5 does not support it afterwards.
        Later texts are rows of characters, type `S1`, over a separate dimension.
        """
        import h5py
        import numpy as np

        where = self.file.require_group(group) if group else self.file
        shape = tuple(int(s.shape[0]) for s in scales)
        limits = tuple(s.maxshape[0] for s in scales)
        growing = None in limits
        if dtype == "text":
            made = where.create_dataset(name, shape, dtype=h5py.string_dtype("utf-8"))
            return self._attach(made, scales, attributes)
        made = where.create_dataset(
            name,
            shape,
            maxshape=limits if growing else None,
            chunks=chunks if (growing or packed) else None,
            dtype=dtype,
            fillvalue={"f": np.nan, "S": b""}.get(np.dtype(dtype).kind, -1),
            **(_PACKING if packed else {}),
        )
        if not growing:
            # Space is allocated before readers are admitted: a table that grows the file later would be
            # beyond the end of file that a reader has just read.
            made[...] = np.full(shape, made.fillvalue, made.dtype)  # a bare number is written row by row
        return self._attach(made, scales, attributes)

    def _attach(
        self, made: h5py.Dataset, scales: Sequence[h5py.Dataset], attributes: Mapping[str, str] | None
    ) -> h5py.Dataset:
        for axis, scale in enumerate(scales):
            made.dims[axis].attach_scale(scale)
        _describe(made, attributes)
        return made

    @property
    def is_open(self) -> bool:
        """Whether the file is open for writing."""
        return self._open

    def begin(self) -> None:
        """Freeze the structure; other processes can then read, but not replace, the file."""
        with self.writing():
            self.file.flush()  # changing the mode on a full disk crashes HDF5
            self.file.swmr_mode = True
            if not keep(self.file.id.get_vfd_handle(), self._place):
                self._open = False
                self.file.close()
                raise ResultError(cannot_be_written(self.path, BlockingIOError()))
            self.flush()

    def flush(self) -> None:
        """Flush all written data to the disk, consistent at any time."""
        with self.writing():
            self._flush()
            self._flushed = {d.name: d.shape[0] for d in self._growing}

    def _flush(self) -> None:
        self.file.flush()
        clear_writer_flag(self._place)

    def finish(
        self,
        status: str = FINISHED,
        sentence: str = "",
        *,
        code: int = 1,
        steps: int = 0,
        wall_s: float = 0.0,
        notes: Sequence[str] = (),
    ) -> None:
        """Write status and notes, and close; a second call has no effect.

        Raises
        ------
        ResultError
            If the file was removed or replaced while it was written.
        """
        if not self._open:
            return
        with self.writing():
            self._set_text("status", status)
            self._set_text("sentence", sentence)
            self._set_text("notes", join_notes(notes))
            self.file.attrs.modify("status_code", int(code))
            self.file.attrs.modify("steps", int(steps))
            self.file.attrs.modify("wall_s", float(wall_s))
            self._flush()
            self._open = False
            self._close()

    def _close(self) -> None:
        """Close the file and check that it still exists under its name."""
        there = is_at(self.file.id.get_vfd_handle(), self._place)
        self.file.close()
        if not there:
            raise ResultError(f"{self.path}: was removed or replaced while it was written; rerun")

    def _set_text(self, name: str, text: str) -> None:
        self.file.attrs.modify(name, self._fixed(name, text))

    def _fixed(self, name: str, text: str) -> Any:
        """Write a text as an attribute of fixed length."""
        import numpy as np

        dtype, length = self._text[name]
        return np.array(_cut(text, length), dtype=dtype)


class MemoryContainer(Container):
    """Small result file created in memory; its bytes are `image` when finished.

    On a full disk HDF5 could crash the process if it cannot complete a file.
    """

    image: bytes = b""

    def _make_file(self) -> h5py.File:
        import h5py

        return h5py.File(
            self.path, "w", driver="core", backing_store=False, libver="latest", rdcc_nbytes=_CHUNK_CACHE
        )

    def _check_room(self, size: int) -> None:
        """Files in memory need no disk space."""

    def _flush(self) -> None:
        self.file.flush()

    def _close(self) -> None:
        self.file.flush()
        self.image = self.file.id.get_file_image()
        self.file.close()


def _cut(text: str, length: int) -> bytes:
    """Shorten a text to a number of bytes without splitting a character."""
    return text.encode("utf-8")[:length].decode("utf-8", "ignore").encode("utf-8")


def _describe(made: h5py.Dataset, attributes: Mapping[str, str] | None) -> None:
    for key, text in (attributes or {}).items():
        if text:
            made.attrs[key] = text
