# SPDX-License-Identifier: Apache-2.0
"""Checksum after the contents of a file; HDF5 and netCDF readers ignore it.

Checksums of HDF5 cover packed data only. The contents are checked before a library reads them, so that damage
cannot crash it or pass unnoticed.
"""

from __future__ import annotations

import hashlib

_SEAL = b"\npitchpoint sha256 %b\n"


def sealed(contents: bytes | memoryview) -> bytes:
    """Contents followed by their checksum.

    >>> unsealed(sealed(b"abc")).tobytes()
    b'abc'
    """
    return bytes(contents) + _seal(contents)


def unsealed(data: bytes) -> memoryview | None:
    """Contents of data with a valid checksum; None if it is missing or wrong.

    >>> unsealed(sealed(b"abc")[1:]) is None
    True
    """
    whole = memoryview(data)
    end = len(whole) - len(_seal(b""))
    return whole[:end] if end > 0 and whole[end:] == _seal(whole[:end]) else None


def _seal(contents: bytes | memoryview) -> bytes:
    return _SEAL % hashlib.sha256(contents).hexdigest().encode()
