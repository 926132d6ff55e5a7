# SPDX-License-Identifier: Apache-2.0
"""The superblock of an HDF5 file, its first 48 bytes: the mark 'open for writing', end of the file, checksum.

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
    """Take the mark 'open for writing' off an HDF5 file.

    The library sets it in byte 11 of the superblock and takes it off when the file is closed. A killed
    process cannot, and ordinary readers then refuse a file in which nothing is wrong: SWMR keeps it
    consistent at any moment. The mark is therefore removed after each flush, and the checksum renewed.
    Ordinary readers may fail in the instant of a flush; those that open with swmr never do.
    """
    with Path(path).open("r+b", buffering=0) as raw:
        block = raw.read(SIZE)
        plain = unmarked(block)
        if plain != block:
            raw.seek(0)
            raw.write(plain)


def shorten(path: str | os.PathLike[str]) -> None:
    """Make the superblock state the true size of a file that ends before the address it gives.

    That is what remains where the disk refused the last blocks; nothing that was flushed refers to them.
    """
    with Path(path).open("r+b", buffering=0) as raw:
        size = os.fstat(raw.fileno()).st_size
        block = unmarked(raw.read(SIZE))
        if _is_sound(block) and int.from_bytes(block[_END], "little") > size:
            raw.seek(0)
            raw.write(_signed(block[: _END.start] + size.to_bytes(8, "little") + block[_END.stop : 44]))


def unmarked(block: bytes) -> bytes:
    """Superblock of an HDF5 file (48 bytes) without the mark 'open for writing'.

    Given back as it is where there is no such mark, or where the checksum shows that it is damaged.
    """
    if not _is_sound(block) or block[11] == 0:
        return block
    return _signed(block[:11] + b"\0" + block[12:44])


def extended(block: bytes, size: int) -> bytes:
    """Unmarked superblock (48 bytes) that ends at the size of its file, if it gives a smaller one [bytes].

    A writer that is killed within a flush may have stored blocks, and references to them, behind the end that
    the superblock still gives: without this HDF5 refuses the whole file.
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
