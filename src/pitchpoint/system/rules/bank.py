# SPDX-License-Identifier: Apache-2.0
"""What a rule hands to the assembler: the records of one kind, their names, their tables, their user laws."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Law = Callable[..., float] | int


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
