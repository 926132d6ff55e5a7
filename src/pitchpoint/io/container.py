# SPDX-License-Identifier: Apache-2.0
"""The result container: one HDF5 file that is also a netCDF-4 file, safe to read at any moment.

Dimension scales, one variable per quantity and text attributes make the file netCDF-4; HDF5's single-writer
multiple-reader mode (SWMR) orders what reaches the disk, so that another process may read while it grows and
a killed process leaves everything that was flushed. In that mode no object and no attribute may be added,
therefore all of them are made first and `begin` freezes the structure; `status`, `sentence` and `notes` are
text attributes of fixed length and may still change. `status` is `running` from the start: a file in which
it still is, without a process that writes, was cut off.
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

from pitchpoint.core.errors import PitchpointError
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
# Every netCDF reader has these two filters; faster ones (lzf, blosc) are refused by the C library.
_PACKING: dict[str, Any] = {"compression": "gzip", "compression_opts": 1, "shuffle": True}
# NetCDF-4 knows dimensions without a variable by this name of their scale.
_NO_COORDINATE = "This is a netCDF dimension but not a netCDF variable."
_ROOM, _ROOM_OF_VARIABLE = 24_000, 1_000
"""Bytes: measured 16 kB for the file and 550 to 750 B for a variable."""
_CHUNK_CACHE = 65536  # bytes per variable: whole chunks are written, so a cache only costs memory


class ResultError(PitchpointError, OSError):
    """A result file cannot be made, opened or understood."""


@dataclass(frozen=True)
class Header:
    """Provenance of a result file, so that it can be traced years later.

    `options` holds the solver's options as plain numbers and texts; `model_text` the model file as read.
    Without `stamped` the time of making is omitted, so that equal results are equal files.
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
    """A result file under construction; the writers for time series and tables are made from it.

    Parameters
    ----------
    path
        File to write; an existing result file is replaced, any other is refused, and so is one that another
        process writes; its folder is made.
    header
        Provenance, stored as attributes of the file.
    variables, values
        Number of variables and bytes of their values up to `begin`. A disk without room for them is refused
        here, as HDF5 can crash when it fills up before the structure of the file is complete.
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
        """Claim bytes beyond the end of the file and give them back: HDF5 needs them next.

        Raises
        ------
        OSError
            If the disk has no room for them.
        """
        if hasattr(os, "posix_fallocate"):
            descriptor = self.file.id.get_vfd_handle()
            end = os.fstat(descriptor).st_size
            os.posix_fallocate(descriptor, end, size)
            os.ftruncate(descriptor, end)

    def _describe_file(self, header: Header) -> None:
        """Write provenance and status, so that a file that is cut off from here on identifies its source."""
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
        """Everything that writes to the file is done in such a block; where the disk refuses, it is given up.

        Raises
        ------
        WriteError
            With the reason; the file is closed, keeps what was flushed, and has the status of a failed run.
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
        """Cut the file off from the disk with the reason in it; gives the error to raise."""
        kept = self._abandon()
        fault: PitchpointError = WriteError(self.path, error, kept=kept)
        if disk_errno(error) == errno.EAGAIN:
            fault = ResultError(cannot_be_written(self.path, BlockingIOError()))
        if kept:
            texts = {"status": self._fixed("status", FAILED), "sentence": self._fixed("sentence", str(fault))}
            conclude(self._place, texts, NOT_WRITTEN, self._flushed or {})
        return fault

    def _abandon(self) -> bool:
        """Close the file without writing to it; False if nothing of it is kept, and it is removed."""
        there = False  # another writer's file of this name is left alone
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
        """Replace what is there by a new file; a link still points to it."""
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
        """Make a dimension with its coordinate; texts are stored as variable-length UTF-8.

        A number as `values` makes a dimension of that length without a coordinate.
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
        """Make a variable over existing dimensions; what is not written yet reads as NaN (integers: -1).

        The type `text` is for tables that are filled before others may read: HDF5 cannot do it afterwards.
        Texts that come later are rows of letters, type `S1`, over a dimension of their own.
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
            # Space is given before others may read: a table that grows the file later would lie beyond the
            # end that a reader has just read.
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
        """Whether more can be written."""
        return self._open

    def begin(self) -> None:
        """Freeze the structure and let others read, but not replace the file."""
        with self.writing():
            self.file.flush()  # changing the mode on a full disk crashes HDF5
            self.file.swmr_mode = True
            if not keep(self.file.id.get_vfd_handle(), self._place):
                self._open = False
                self.file.close()
                raise ResultError(cannot_be_written(self.path, BlockingIOError()))
            self.flush()

    def flush(self) -> None:
        """Bring everything written so far to the disk, in an order that is consistent at any moment."""
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
        """Write how the computation ended and what is to be known, and close; a second call does nothing.

        Raises
        ------
        ResultError
            If the file was taken away or replaced while it was written.
        """
        if not self._open:
            return
        with self.writing():
            self._set_text("status", status)
            self._set_text("sentence", sentence)
            self._set_text("notes", "; ".join(notes))
            self.file.attrs.modify("status_code", int(code))
            self.file.attrs.modify("steps", int(steps))
            self.file.attrs.modify("wall_s", float(wall_s))
            self._flush()
            self._open = False
            self._close()

    def _close(self) -> None:
        """Close the file and report whether it is still where it was made."""
        there = is_at(self.file.id.get_vfd_handle(), self._place)
        self.file.close()
        if not there:
            raise ResultError(f"{self.path}: was taken away or replaced while it was written; run again")

    def _set_text(self, name: str, text: str) -> None:
        self.file.attrs.modify(name, self._fixed(name, text))

    def _fixed(self, name: str, text: str) -> Any:
        """A text as an attribute of its fixed length."""
        import numpy as np

        dtype, length = self._text[name]
        return np.array(_cut(text, length), dtype=dtype)


class MemoryContainer(Container):
    """A result that is small and written at once: made in memory, its bytes are `image` when it is finished.

    HDF5 gives back a file it could not finish, on a full disk, by a crash of the process.
    """

    image: bytes = b""

    def _make_file(self) -> h5py.File:
        import h5py

        return h5py.File(
            self.path, "w", driver="core", backing_store=False, libver="latest", rdcc_nbytes=_CHUNK_CACHE
        )

    def _check_room(self, size: int) -> None:
        """Files in memory have room."""

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
