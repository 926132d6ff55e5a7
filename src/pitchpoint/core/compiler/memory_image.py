# SPDX-License-Identifier: Apache-2.0
"""Memory of a compiled model as one block without addresses, with the places where addresses belong."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class MemoryImage:
    """Arrays of a model one after the other in one block; it works at every address after relocation.

    Parameters
    ----------
    data
        Bytes of the block. Addresses of the block are offsets in it, and those of entry points are zero.
    at
        Offset of every array, by name.
    moved
        Offsets of the words to which the address of the block must be added.
    code
        Offset and number of the entry point of each word that holds the address of one.
    entries
        The entry points.
    """

    data: bytes
    at: Mapping[str, int]
    moved: tuple[int, ...]
    code: tuple[tuple[int, int], ...]
    entries: tuple[Any, ...]

    def place(self, offset: int) -> str:
        """Array that contains an offset, and the distance from its start in bytes."""
        name = max((n for n, start in self.at.items() if start <= offset), key=lambda n: self.at[n])
        return f"{name}+{offset - self.at[name]}"
