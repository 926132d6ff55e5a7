# SPDX-License-Identifier: Apache-2.0
"""Result files without the mark of a writer, with which HDF5 refuses them; what it raises on damaged ones."""

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
"""What HDF5 and its Python layer raise where a file contradicts itself."""


class UnmarkedFile(io.RawIOBase):
    """A file as it is, without the mark of a writer, with which HDF5 refuses it, and with its true end.

    The library shares what two readers of one process open by name, and requires the same options of both;
    files opened here are not shared.
    """

    def __init__(self, name: str) -> None:
        self._file = open(name, "rb", buffering=0)  # noqa: SIM115, closed with this object
        self._head = extended(self._file.read(SIZE), os.fstat(self._file.fileno()).st_size)

    def readinto(self, buffer: Any) -> int:
        """Fill a buffer; what lies behind the end of the file reads as zero."""
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
        """Go to a place."""
        return self._file.seek(offset, whence)

    def tell(self) -> int:
        """Place in the file."""
        return self._file.tell()

    def readable(self) -> bool:
        """Whether this can be read."""
        return True

    def seekable(self) -> bool:
        """Whether this has places."""
        return True

    def fileno(self) -> int:
        """Descriptor of the file."""
        return self._file.fileno()

    def close(self) -> None:
        """Let go of the file."""
        self._file.close()
        super().close()
