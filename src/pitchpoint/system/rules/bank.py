# SPDX-License-Identifier: Apache-2.0
"""Result of a rule: records of one kind with names, table pool and user laws."""

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
    """Combine rows to a bank."""
    records = np.zeros(len(rows), dtype)
    for k, row in enumerate(rows):
        records[k] = row
    return Bank(kind, records, tuple(names), **more)
