# SPDX-License-Identifier: Apache-2.0
"""Read access to result files without the flag of an open writer, with which HDF5 rejects them."""

from __future__ import annotations

import io
import os
from typing import Any

from pitchpoint.io.superblock import SIZE, extended

DAMAGE = (
    OSError,
    RuntimeError,
    KeyError,
    ValueError,
    TypeError,
    AttributeError,
    LookupError,
    ArithmeticError,
    MemoryError,
    StopIteration,
    EOFError,
)
"""Exceptions of HDF5 and h5py for inconsistent files."""


class UnmarkedFile(io.RawIOBase):
    """Read-only file object with the flag of an open writer cleared and the true end of file.

    The library shares files that a process opens twice by name, and requires identical options; files opened
    here are not shared.
    """

    def __init__(self, name: str) -> None:
        self._file = open(name, "rb", buffering=0)  # noqa: SIM115, closed with this object
        self._head = extended(self._file.read(SIZE), os.fstat(self._file.fileno()).st_size)

    def readinto(self, buffer: Any) -> int:
        """Fill a buffer; bytes beyond the end of the file read as zero."""
        at, view = self._file.tell(), memoryview(buffer).cast("B")
        count = 0
        while count < len(view):
            got = self._file.readinto(view[count:])
            if not got:
                break
            count += got
        view[count:] = bytes(len(view) - count)
        if at < len(self._head):
            part = self._head[at : at + len(view)]
            view[: len(part)] = part
        return len(view)

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        """Set the position."""
        return self._file.seek(offset, whence)

    def tell(self) -> int:
        """Position in the file."""
        return self._file.tell()

    def readable(self) -> bool:
        """Whether the file is readable."""
        return True

    def seekable(self) -> bool:
        """Whether the file is seekable."""
        return True

    def fileno(self) -> int:
        """File descriptor."""
        return self._file.fileno()

    def close(self) -> None:
        """Close the file."""
        self._file.close()
        super().close()
