# SPDX-License-Identifier: Apache-2.0
"""MAT files of version 4: matrices of numbers and texts, one after the other.

References
----------
The MathWorks, MAT-File Format, R2024a, chapter on level 4 files.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from pitchpoint.io.measured.arrays import MAX_BYTES, Arrays, Found
from pitchpoint.io.measured.record import Record, Wanted, refused, truncated

_HEAD = 20
_TYPES = ("f8", "f4", "i4", "i2", "u2", "u1")
_LONGEST = 256
"""Bytes of a name in plausible headers; MATLAB writes 64 at most."""
_MAX_VARIABLES = 10_000


def is_mat4(data: bytes) -> bool:
    """Whether a file begins with a matrix of version 4, which has no magic number."""
    head = _head(data, 0)
    if head is None:
        return False
    name = data[_HEAD : _HEAD + head[-1]].rstrip(b"\0")
    return bool(re.fullmatch(rb"[A-Za-z_]\w*", name))


def read_mat4(path: Path, data: bytes, wanted: Wanted) -> Record:
    """Read the variables of a MAT file of version 4."""
    found = Arrays(path, "MAT 4", MAX_BYTES // 8)
    at = count = 0
    while at < len(data):
        head = _head(data, at)
        if head is None:
            if len(data) - at < _HEAD:
                raise truncated(path, at + _HEAD, len(data))
            remedy = "save it again, or export it as CSV"
            raise refused(
                path, f"byte {at}", "", "is damaged: no variable of version 4 begins here", None, remedy
            )
        count += 1
        if count > _MAX_VARIABLES:
            raise refused(path, "", f"{count} variables", "are too many", f"{_MAX_VARIABLES}", "split it")
        at = _variable(path, data, at, head, found)
    return found.record(wanted)


def _head(data: bytes, at: int) -> tuple[str, int, int, int, int, int] | None:
    """Byte order, type, rows, columns, whether complex, bytes of the name; None if there is none."""
    if len(data) < at + _HEAD:
        return None
    for order in "<>":
        kind, rows, columns, imaginary, length = np.frombuffer(data, f"{order}i4", 5, at).tolist()
        machine, rest = divmod(kind, 1000)
        if (
            machine == "<>".index(order)
            and 0 <= rest < 100
            and rest // 10 < len(_TYPES)
            and rest % 10 <= 2
            and imaginary in (0, 1)
            and 1 <= length <= _LONGEST
            and min(rows, columns) >= 0
        ):
            return order, rest, rows, columns, imaginary, length
    return None


def _variable(
    path: Path, data: bytes, at: int, head: tuple[str, int, int, int, int, int], found: Arrays
) -> int:
    """Add one variable; returns the place of the next one [bytes]."""
    order, kind, rows, columns, imaginary, length = head
    code = order + _TYPES[kind // 10]
    begin = at + _HEAD + length
    end = begin + rows * columns * np.dtype(code).itemsize * (1 + imaginary)
    if end > len(data):
        raise truncated(path, end, len(data))
    name = found.unique(data[at + _HEAD : begin].partition(b"\0")[0].decode("latin-1") or "variable")
    values = np.frombuffer(data, code, rows * columns, begin)
    if imaginary:
        found.skip(name, "complex numbers")
    elif kind % 10 == 2:
        found.skip(name, "a sparse matrix")
    elif kind % 10 == 1:
        letters = np.nan_to_num(values[:_LONGEST].reshape(-1)).clip(0, 255).astype(np.uint8)
        found.text(name, letters.tobytes().decode("latin-1"))
    else:
        found.add(Found(name, values.reshape((rows, columns), order="F")))
    return end
