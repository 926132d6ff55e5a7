# SPDX-License-Identifier: Apache-2.0
"""What a rule hands to the assembler: the records of one kind, their names, their tables, their user laws."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Law = Callable[..., float] | int


@dataclass
class Pool:
    """Float array that grows while records are filled; records keep offsets into it."""

    parts: list[NDArray[np.float64]] = field(default_factory=list)

    def __call__(self, values: ArrayLike) -> int:
        """Append numbers and return the offset of the first."""
        offset = sum(part.size for part in self.parts)
        self.parts.append(np.ravel(np.asarray(values, dtype=np.float64)))
        return offset

    def array(self) -> NDArray[np.float64]:
        """All numbers in one array of at least one entry."""
        return np.concatenate([*self.parts, np.zeros(1)])


@dataclass(frozen=True)
class Bank:
    """Records of one element kind, ready for `assemble`."""

    kind: str
    records: NDArray[np.void]
    names: tuple[str, ...]
    pool: NDArray[np.float64] | None = None
    laws: tuple[Law | None, ...] | None = None


def pack(kind: str, dtype: np.dtype[Any], rows: list[np.void], names: list[str], **more: Any) -> Bank:
    """Gather rows into a bank."""
    records = np.zeros(len(rows), dtype)
    for k, row in enumerate(rows):
        records[k] = row
    return Bank(kind, records, tuple(names), **more)
