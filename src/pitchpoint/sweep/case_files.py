# SPDX-License-Identifier: Apache-2.0
"""Files to which the values of a case refer: their contents belong to its inputs."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any


def file_hashes(data: Any, folder: Path) -> list[str]:
    """Hashes of the files referenced by values as `FILE` or `FILE.py:function`."""
    if isinstance(data, Mapping):
        return [digest for value in data.values() for digest in file_hashes(value, folder)]
    if isinstance(data, list | tuple):
        return [digest for value in data for digest in file_hashes(value, folder)]
    if not isinstance(data, str):
        return []
    file = folder / data.partition(":")[0]
    with suppress(OSError, ValueError):  # too long or with a null character: not a file name
        if file.is_file():
            return [hashlib.sha256(file.read_bytes()).hexdigest()]
    return []
