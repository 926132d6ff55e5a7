# SPDX-License-Identifier: Apache-2.0
"""Handling of write errors of result files: disk full, quota or size limit exceeded, defective disk.

After a failed write HDF5 retains blocks that it writes again at every flush or close, at the latest when the
process ends: this damages the file, and can end the process. The file is therefore detached from the disk
before it is closed. In SWMR mode all data up to the last flush are consistent on the disk; the status is
written there afterwards, into existing bytes.
"""

from __future__ import annotations

import contextlib
import io
import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import NOT_WRITTEN
from pitchpoint.io.superblock import shorten
from pitchpoint.io.target import reason_of

if TYPE_CHECKING:
    import h5py

HDF5_FAULTS = (OSError, RuntimeError, KeyError, ValueError)
"""Exceptions of HDF5 and h5py for files that cannot be written or closed."""


class WriteError(SolverError):
    """A result cannot be written any more; flushed data are retained."""

    def __init__(self, path: Path, error: Exception, *, kept: bool) -> None:
        reason = (
            reason_of(error) if isinstance(error, OSError | ValueError) else reason_of(OSError(str(error)))
        )
        what = "previous data are retained" if kept else "no data are retained"
        words = f"{path}: cannot be written any more ({reason}); {what}; free disk space and rerun"
        super().__init__(words, NOT_WRITTEN, str(path) if kept else None)


def abandon(file: h5py.File) -> None:
    """Close a file after a failed write, without further access to the disk.

    Parameters
    ----------
    file
        The file; all pending writes of HDF5 go to the null device.
    """
    with contextlib.suppress(*HDF5_FAULTS):
        descriptor = file.id.get_vfd_handle()
        nowhere = os.open(os.devnull, os.O_RDWR)
        try:
            os.dup2(nowhere, descriptor, inheritable=False)
        finally:
            os.close(nowhere)
    with contextlib.suppress(*HDF5_FAULTS):
        file.close()


def conclude(place: Path, texts: Mapping[str, Any], code: int, lengths: Mapping[str, int]) -> None:
    """Write the status into an abandoned file, and remove incomplete rows.

    Parameters
    ----------
    place
        The file.
    texts
        Attributes of fixed length.
    code
        Status of the computation.
    lengths
        Length of every growing dimension at the last flush.
    """
    import h5py

    with contextlib.suppress(*HDF5_FAULTS):
        shorten(place)
        with _Lenient(place) as raw, h5py.File(raw, "r+", libver="latest") as file:
            for name, value in texts.items():
                file.attrs.modify(name, value)
            file.attrs.modify("status_code", code)
            file.flush()
            for name, length in lengths.items():
                if file[name].shape[0] > length:
                    file[name].resize((length,))


class _Lenient(io.FileIO):
    """File that is changed in place as far as the disk permits, without reporting errors to HDF5."""

    def __init__(self, place: Path) -> None:
        super().__init__(place, "r+")

    def write(self, data: Any) -> int:
        """Write as much as the disk accepts."""
        view = memoryview(data).cast("B")
        done = 0
        with contextlib.suppress(OSError):
            while done < len(view):
                done += super().write(view[done:]) or 0
        return len(view)

    def truncate(self, size: int | None = None) -> int:
        """Truncate only; growth would need disk space."""
        end = os.fstat(self.fileno()).st_size
        with contextlib.suppress(OSError):
            return super().truncate(end if size is None else min(size, end))
        return end
