# SPDX-License-Identifier: Apache-2.0
"""When the disk refuses a result file: full, over a quota or a size limit, or broken.

After a write that failed HDF5 still holds blocks that it writes again whenever the file is flushed or closed,
at the latest when the process ends: that damages what is on the disk, and can end the process. Such a file is
therefore cut off from the disk first and closed then. In SWMR mode everything up to the last flush is
consistent on the disk; how the computation ended is written there afterwards, in bytes that exist already.
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
"""What HDF5 and its Python layer raise where a file cannot be written or closed."""


class WriteError(SolverError):
    """A result cannot be written any more; what was flushed before is kept."""

    def __init__(self, path: Path, error: Exception, *, kept: bool) -> None:
        reason = (
            reason_of(error) if isinstance(error, OSError | ValueError) else reason_of(OSError(str(error)))
        )
        what = "what was flushed before is kept" if kept else "nothing is kept"
        words = f"{path}: cannot be written any more ({reason}); {what}; make room there and run again"
        super().__init__(words, NOT_WRITTEN, str(path) if kept else None)


def abandon(file: h5py.File) -> None:
    """Close a file whose writing has failed, without touching the disk again.

    Parameters
    ----------
    file
        The file; all writing that HDF5 still has in mind goes to the null device.
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
    """Write into an abandoned file how its computation ended, and cut off rows that are not whole.

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
    """A file that is changed in place as far as the disk permits; HDF5 must not see an error."""

    def __init__(self, place: Path) -> None:
        super().__init__(place, "r+")

    def write(self, data: Any) -> int:
        """Write all of it, or what the disk takes."""
        view = memoryview(data).cast("B")
        done = 0
        with contextlib.suppress(OSError):
            while done < len(view):
                done += super().write(view[done:]) or 0
        return len(view)

    def truncate(self, size: int | None = None) -> int:
        """Shorten only: what is longer would need room."""
        end = os.fstat(self.fileno()).st_size
        with contextlib.suppress(OSError):
            return super().truncate(end if size is None else min(size, end))
        return end
