# SPDX-License-Identifier: Apache-2.0
"""MAT files of version 5 to 7: arrays of numbers, also inside structures and cells.

They are decoded here, element by element, because available readers allocate the size given in the header of
an array without checking the data; `scipy.io` is the reference of the tests. Files of version
7.3 are HDF5 (`hdf5.read_hdf5`), those of version 4 have another form (`mat4`).

References
----------
The MathWorks, MAT-File Format, R2024a.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from pitchpoint.io.measured.arrays import MAX_BYTES, Arrays, Found
from pitchpoint.io.measured.record import MeasuredError, Record, Wanted, refused, truncated

_MATRIX, _COMPRESSED = 14, 15
_TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8"}
_CELL, _STRUCT, _OBJECT, _CHAR, _SPARSE, _OPAQUE = 1, 2, 3, 4, 5, 17
_BYTES = 9
_NUMERIC = range(6, 16)
_MAX_PARTS = 10_000


def read_mat5(path: Path, data: bytes, wanted: Wanted) -> Record:
    """Read the variables of a MAT file of version 5, 6 or 7."""
    mark = data[126:128]
    if mark not in (b"IM", b"MI"):
        raise refused(
            path, "byte 126", repr(mark), "is not a mark of byte order", "IM or MI", "save the file again"
        )
    found = Arrays(path, "MAT", MAX_BYTES // 8)
    order = "<" if mark == b"IM" else ">"
    unpacked = 0
    for kind, body in _elements(path, memoryview(data)[128:], order):
        if kind == _COMPRESSED:
            content = _unpacked(path, body, order, MAX_BYTES - unpacked)
            unpacked += len(content)
            for inner, part in _elements(path, memoryview(content), order):
                if inner == _MATRIX:
                    _matrix(path, part, order, "", found, 0)
        elif kind == _MATRIX:
            _matrix(path, body, order, "", found, 0)
    return found.record(wanted)


def _unpacked(path: Path, packed: memoryview, order: str, room: int) -> bytes:
    """Contents of a compressed element, of the size that its own tag declares."""
    machine = zlib.decompressobj()
    try:
        tag = machine.decompress(packed, 8)
        size = int(np.frombuffer(tag, f"{order}u4", 1, 4)[0]) if len(tag) == 8 else 0
        if size > room:
            raise _too_large(path, size + MAX_BYTES - room)
        plain = tag + machine.decompress(machine.unconsumed_tail, size + 8)
    except zlib.error as error:
        raise _damaged(path, f"a packed array cannot be unpacked ({error})") from error
    if machine.unconsumed_tail or not machine.eof:
        raise _damaged(path, "a packed array does not end")
    return plain


def _too_large(path: Path, size: int) -> MeasuredError:
    remedy = "export fewer or shorter channels"
    limit = f"{MAX_BYTES / 1e6:.0f} MB"
    return refused(path, "", f"{size / 1e6:.0f} MB", "are what its arrays take unpacked", limit, remedy)


def _damaged(path: Path, what: str) -> MeasuredError:
    return refused(path, "", "", f"is damaged: {what}", None, "save it again, or export it as CSV")


def _elements(path: Path, data: memoryview, order: str) -> Iterator[tuple[int, memoryview]]:
    """Data elements in sequence: type and contents; small ones contain up to 4 bytes in their tag."""
    at = 0
    while at + 8 <= len(data):
        kind, size = np.frombuffer(data, f"{order}u4", 2, at).tolist()
        if kind >> 16:
            kind, size = kind & 0xFFFF, kind >> 16
            if size > 4:
                raise _damaged(path, f"a small element of {size} bytes")
            yield kind, data[at + 4 : at + 4 + size]
            at += 8
            continue
        if at + 8 + size > len(data):
            raise truncated(path, at + 8 + size, len(data))
        yield kind, data[at + 8 : at + 8 + size]
        at += 8 + size + (-size % 8 if kind != _COMPRESSED else 0)
    if bytes(data[at:]).strip(b"\0"):
        raise truncated(path, at + 8, len(data))


def _matrix(path: Path, data: memoryview, order: str, owner: str, found: Arrays, depth: int) -> None:
    """Add one array with its name; parts of structures and cells are named after their parent."""
    parts = list(_limited(path, _elements(path, data, order)))
    if len(parts) < 3 or len(parts[0][1]) < 8:
        return None  # empty arrays
    flags = int(np.frombuffer(parts[0][1], f"{order}u4", 1)[0])
    kind, is_complex = flags & 0xFF, bool(flags & 0x0800)
    if kind == _OPAQUE:
        return found.skip(owner or bytes(parts[1][1]).decode("latin-1"), "an object, such as a table")
    if parts[1][0] != 5:
        return None
    shape = tuple(np.frombuffer(parts[1][1][: len(parts[1][1]) // 4 * 4], f"{order}i4").tolist())
    own = bytes(parts[2][1]).decode("latin-1")
    if not (own or owner) and kind == _BYTES:
        return None  # contents of the objects
    name = f"{owner}{own}" if owner else found.unique(own or "variable")
    if kind in _NUMERIC and len(parts) > 3:
        values = _numbers(path, parts[3], order, name)
        if values.size != int(np.prod([float(n) for n in shape])):
            raise refused(
                path, name, f"{values.size} numbers", "do not fill the array", f"{shape}", "save it again"
            )
        if is_complex:
            found.skip(name, "complex numbers")
        else:
            found.add(Found(name, values.reshape(shape, order="F")))
    elif kind == _CHAR and len(parts) > 3:
        found.text(name, _letters(parts[3], order))
    elif kind == _STRUCT and len(parts) > 4 and depth < 8:
        length = int.from_bytes(bytes(parts[3][1][:4]).ljust(4, b"\0"), "little" if order == "<" else "big")
        letters = bytes(parts[4][1])
        fields = [letters[k : k + length] for k in range(0, len(letters), length)] if length > 0 else []
        names = [field.partition(b"\0")[0].decode("latin-1") for field in fields]
        elements = parts[5:]
        if len(elements) % max(len(names), 1) or (elements and not names):
            raise _damaged(path, f"structure {name} has {len(elements)} values for {len(names)} fields")
        several = len(elements) > len(names)
        for k, (inner, content) in enumerate(elements):
            index = f"[{k // len(names)}]" if several else ""
            if inner == _MATRIX:
                _matrix(path, content, order, f"{name}{index}.{names[k % len(names)]}", found, depth + 1)
    elif kind == _CELL and depth < 8:
        for k, (inner, content) in enumerate(parts[3:]):
            if inner == _MATRIX:
                _matrix(path, content, order, f"{name}[{k}]", found, depth + 1)
    elif kind in (_OBJECT, _SPARSE) or kind > _NUMERIC[-1]:
        found.skip(name, "an object" if kind != _SPARSE else "a sparse matrix")
    return None


def _limited(path: Path, elements: Iterator[tuple[int, memoryview]]) -> Iterator[tuple[int, memoryview]]:
    for count, element in enumerate(elements):
        if count > _MAX_PARTS:
            raise refused(
                path, "", f"{count} parts", "are too many in one variable", f"{_MAX_PARTS}", "split it"
            )
        yield element


def _numbers(path: Path, part: tuple[int, memoryview], order: str, name: str) -> np.ndarray:
    kind, data = part
    if kind not in _TYPES or len(data) % np.dtype(_TYPES[kind]).itemsize:
        raise _damaged(path, f"array {name} has {len(data)} bytes of the type {kind}")
    return np.frombuffer(data, order + _TYPES[kind])


def _letters(part: tuple[int, memoryview], order: str) -> str:
    """Text of a character array, in any of the encodings of the format."""
    kind, data = part
    wide = {4: "utf-16", 17: "utf-16", 18: "utf-32"}.get(kind)
    code = f"{wide}-{'le' if order == '<' else 'be'}" if wide else "utf-8"
    return bytes(data).decode(code, "replace")
