# SPDX-License-Identifier: Apache-2.0
"""Memory image of a system: all arrays of its compiled code, in one block without addresses.

Addresses are found by value: a word within an array of the system is an address of the block, and a word
equal to the address of a compiled entry point is one of the code. The search is proved by a second copy of
the system at other addresses, whose image must be identical.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core import kernel as door
from pitchpoint.core.compiler.memory_image import MemoryImage
from pitchpoint.core.errors import CompileError
from pitchpoint.system.system import System

ALIGNMENT = 64
"""Alignment of the arrays in the block [bytes], one line of the processor cache."""
LOWEST, HIGHEST = 1 << 20, 1 << 47
"""Range of addresses of programs: integers of a model are below, floating-point numbers above or zero."""
FOREIGN = 1 << 32
"""Value from which a word that is in no array is an address, not an integer of the model."""

_DIRECT = ("ctl", "mach", "fr", "q", "v", "a", "R", "kk", "A", "g", "gt", "gtt", "lam", "G", "Gf")

Array = NDArray[Any]


def arrays_of(system: System) -> dict[str, Array]:
    """All arrays that the compiled code of a system reads or writes, by name."""
    w = system.workspace
    found: dict[str, Array] = {name: getattr(w, name) for name in _DIRECT}
    groups: dict[str, Mapping[str, Array]] = {
        "program": w.program,
        "work": w.arrays,
        "table": w.tables,
        "records": system.records,
        "pool": system.pools,
    }
    for group, arrays in groups.items():
        found |= {f"{group}.{name}": array for name, array in arrays.items()}
    return found


def memory_image(make: Callable[[], tuple[System, Mapping[str, Array]]]) -> MemoryImage:
    """Memory image of a system, proved by a second copy.

    Parameters
    ----------
    make
        Function that returns a new copy of the system in its initial state, and further arrays by name that
        belong to its run.

    Raises
    ------
    CompileError
        If the memory contains an address of something else, such as a user law in Python.
    """
    copies = [make() for _ in range(2)]  # both live: their arrays do not overlap
    first, second = (_image({**arrays_of(system), **more}) for system, more in copies)
    own, other = (np.frombuffer(image.data, np.int64) for image in (first, second))
    if len(own) != len(other) or first.moved != second.moved or first.code != second.code:
        raise CompileError("two copies of the model differ in their structure, so it cannot be exported")
    _refuse(first, [8 * int(k) for k in np.flatnonzero(own != other)])
    return first


def offsets(arrays: Mapping[str, Array]) -> tuple[dict[str, int], int]:
    """Offset of each array in the block, and the size of the block [bytes]."""
    at, size = {}, 0
    for name, array in arrays.items():
        at[name] = size
        size += -(-array.nbytes // ALIGNMENT) * ALIGNMENT
    return at, size


def word_at(arrays: Mapping[str, Array], at: Mapping[str, int], offset: int) -> NDArray[np.float64]:
    """The number at an offset of the block, in the array of a system, shape (1,).

    Parameters
    ----------
    arrays
        Arrays of a system.
    at
        Their offsets.
    offset
        Offset of the word.
    """
    name = max((n for n, a in arrays.items() if a.nbytes and at[n] <= offset), key=lambda n: at[n])
    found: NDArray[np.float64] = arrays[name].reshape(-1).view(np.uint8)[offset - at[name] :][:8].view("f8")
    return found


def _image(arrays: Mapping[str, Array]) -> MemoryImage:
    """Image of arrays, with their addresses as offsets."""
    for name, array in arrays.items():
        if not array.flags.c_contiguous:
            raise CompileError(f"{name}: this array is not contiguous, so the model cannot be exported")
    at, size = offsets(arrays)
    block = np.zeros(size, np.uint8)
    for name, array in arrays.items():
        block[at[name] : at[name] + array.nbytes] = np.frombuffer(array.tobytes(), np.uint8)
    words = block.view(np.int64)
    numbers = door.known_addresses()
    spans = sorted((a.ctypes.data, a.ctypes.data + a.nbytes, at[n]) for n, a in arrays.items() if a.nbytes)
    starts = np.array([start for start, _, _ in spans])
    empty = {a.ctypes.data: at[n] for n, a in arrays.items() if not a.nbytes}
    moved, code, entries, strange = [], [], [], []
    for k in np.flatnonzero((words >= LOWEST) & (words < HIGHEST)).tolist():
        where = int(words[k])
        if where in numbers:
            if numbers[where] not in entries:
                entries.append(numbers[where])
            code.append((8 * k, entries.index(numbers[where])))
            words[k] = 0
            continue
        i = int(np.searchsorted(starts, where, "right")) - 1
        if i >= 0 and where < spans[i][1]:
            words[k] = spans[i][2] + where - spans[i][0]
        elif where in empty:
            words[k] = empty[where]
        else:
            strange += [8 * k] if where >= FOREIGN else []
            continue
        moved.append(8 * k)
    image = MemoryImage(block.tobytes(), at, tuple(moved), tuple(code), tuple(entries))
    _refuse(image, strange)
    return image


def _refuse(image: MemoryImage, offsets: Sequence[int]) -> None:
    """Raise CompileError for words that refer to memory outside of the model."""
    if offsets:
        places = ", ".join(image.place(offset) for offset in offsets[:3])
        raise CompileError(
            f"{places}: the model refers to memory outside of it, such as a Python function; it cannot be "
            "exported"
        )
