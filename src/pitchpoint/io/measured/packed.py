# SPDX-License-Identifier: Apache-2.0
"""Files packed by gzip, such as `record.csv.gz`, unpacked in memory up to a limit."""

from __future__ import annotations

import zlib
from pathlib import Path

from pitchpoint.io.measured.arrays import MAX_BYTES
from pitchpoint.io.measured.record import refused, truncated

_MAGIC = b"\x1f\x8b"
_ENDING = ".gz"
_GZIP = 31
"""Window bits of zlib for a stream with a gzip header."""


def suffix_of(path: Path) -> str:
    """Extension of a file in lower case, without that of the packing.

    Examples
    --------
    >>> suffix_of(Path("record.csv.gz")), suffix_of(Path("record.MAT"))
    ('.csv', '.mat')
    """
    return (path.with_suffix("") if path.suffix.lower() == _ENDING else path).suffix.lower()


def is_packed(data: bytes) -> bool:
    """Whether these are the first bytes of a packed file."""
    return data[:2] == _MAGIC


def unpacked(path: Path, data: bytes) -> bytes:
    """Contents of a packed file; other files unchanged.

    Raises
    ------
    MeasuredError
        If the file is damaged or larger than the limit of unpacked arrays.
    """
    if not is_packed(data):
        return data
    parts: list[bytes] = []
    room, rest = MAX_BYTES, data
    while is_packed(rest):  # a packed file may consist of several streams
        machine = zlib.decompressobj(_GZIP)
        try:
            part = machine.decompress(rest, room + 1)
        except zlib.error as error:
            remedy = "copy it again from where it was recorded"
            raise refused(
                path, "", "", f"is damaged: it cannot be unpacked ({error})", None, remedy
            ) from None
        room -= len(part)
        if room < 0:
            limit = f"{MAX_BYTES / 1e6:.0f} MB"
            remedy = "cut it into shorter records"
            raise refused(path, "", f"more than {limit}", "are its contents unpacked", limit, remedy)
        if not machine.eof:
            raise truncated(path, len(data) + 1, len(data), "packed bytes")
        parts.append(part)
        rest = machine.unused_data
    return b"".join(parts)
