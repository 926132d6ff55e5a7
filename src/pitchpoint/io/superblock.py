# SPDX-License-Identifier: Apache-2.0
"""Superblock of an HDF5 file, its first 48 bytes: flag 'open for writing', end of file, checksum.

Layout: HDF5 File Format Specification 3.0, II.A (versions 2 and 3). The checksum is Jenkins' lookup3 over the
first 44 bytes.
"""

from __future__ import annotations

import os
from pathlib import Path

SIZE = 48
_END = slice(28, 36)
"""Where the address of the end of the file is stored."""


def clear_writer_flag(path: str | os.PathLike[str]) -> None:
    """Clear the flag 'open for writing' of an HDF5 file.

    The library sets it in byte 11 of the superblock and clears it when the file is closed. A killed process
    does not, and ordinary readers then reject an intact file: SWMR keeps it consistent at any time. The flag
    is therefore cleared after each flush, and the checksum updated. Ordinary readers may fail during a flush;
    those that open with swmr do not.
    """
    with Path(path).open("r+b", buffering=0) as raw:
        block = raw.read(SIZE)
        plain = unmarked(block)
        if plain != block:
            raw.seek(0)
            raw.write(plain)


def shorten(path: str | os.PathLike[str]) -> None:
    """Correct the superblock of a file that ends before the given end of file.

    Such a file remains if the last blocks could not be written; flushed data do not refer to them.
    """
    with Path(path).open("r+b", buffering=0) as raw:
        size = os.fstat(raw.fileno()).st_size
        block = unmarked(raw.read(SIZE))
        if _is_sound(block) and int.from_bytes(block[_END], "little") > size:
            raw.seek(0)
            raw.write(_signed(block[: _END.start] + size.to_bytes(8, "little") + block[_END.stop : 44]))


def unmarked(block: bytes) -> bytes:
    """Superblock of an HDF5 file (48 bytes) without the flag 'open for writing'.

    Returned unchanged if the flag is not set, or if the checksum is invalid.
    """
    if not _is_sound(block) or block[11] == 0:
        return block
    return _signed(block[:11] + b"\0" + block[12:44])


def extended(block: bytes, size: int) -> bytes:
    """Superblock (48 bytes) without the flag, with the end of file raised to the size of the file [bytes].

    A writer that is killed during a flush may have stored blocks, and references to them, beyond the end in
    the superblock: without this correction HDF5 rejects the whole file.
    """
    plain = unmarked(block)
    if not _is_sound(plain) or int.from_bytes(plain[_END], "little") >= size:
        return plain
    return _signed(plain[: _END.start] + size.to_bytes(8, "little") + plain[_END.stop : 44])


def _is_sound(block: bytes) -> bool:
    """Whether these are a signature, a known version, addresses of 8 bytes and the right checksum."""
    return (
        len(block) == SIZE
        and block[:8] == b"\x89HDF\r\n\x1a\n"
        and block[8] >= 2
        and block[9] == 8
        and lookup3(block[:44]) == int.from_bytes(block[44:], "little")
    )


def _signed(block: bytes) -> bytes:
    return block + lookup3(block).to_bytes(4, "little")


def lookup3(data: bytes, start: int = 0) -> int:
    """Hash bytes with Bob Jenkins' lookup3 (`hashlittle`), the checksum of HDF5 metadata.

    Examples
    --------
    >>> hex(lookup3(b"Four score and seven years ago"))
    '0x17770551'
    """

    def turn(x: int, k: int) -> int:
        """Rotate 32 bits to the left by k."""
        return ((x << k) | (x >> (32 - k))) & 0xFFFFFFFF

    m = 0xFFFFFFFF
    a = b = c = (0xDEADBEEF + len(data) + start) & m
    blocks = max((len(data) - 1) // 12, 0)
    for k in range(0, 12 * blocks, 12):
        a = (a + int.from_bytes(data[k : k + 4], "little")) & m
        b = (b + int.from_bytes(data[k + 4 : k + 8], "little")) & m
        c = (c + int.from_bytes(data[k + 8 : k + 12], "little")) & m
        for way in (4, 6, 8, 16, 19, 4):
            a, c = ((a - c) & m) ^ turn(c, way), (c + b) & m
            a, b, c = b, c, a
    tail = data[12 * blocks :]
    if not tail:
        return c
    tail = tail.ljust(12, b"\0")
    a = (a + int.from_bytes(tail[0:4], "little")) & m
    b = (b + int.from_bytes(tail[4:8], "little")) & m
    c = (c + int.from_bytes(tail[8:12], "little")) & m
    for way in (14, 11, 25, 16, 4, 14, 24):
        c = ((c ^ b) - turn(b, way)) & m
        a, b, c = b, c, a
    return b
