# SPDX-License-Identifier: Apache-2.0
"""Files that a model names: the state of their contents, and their problems at the key that names them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from pitchpoint.core.errors import Message, ModelError


def change_time(path: str) -> int:
    """Time of the last change of a file [ns], for caches of its contents; 0 if it does not exist."""
    return Path(path).stat().st_mtime_ns if Path(path).exists() else 0


def states(paths: Iterable[str]) -> tuple[tuple[str, int, int], ...]:
    """Files with the time of their last change [ns] and their size, for caches of their contents."""
    found = []
    for path in paths:
        try:
            status = Path(path).stat()
            found.append((path, status.st_mtime_ns, status.st_size))
        except (OSError, ValueError):
            found.append((path, 0, 0))
    return tuple(found)


def at_key(error: ModelError, key: str) -> ModelError:
    """Problems of a file as problems of the key that names it; each has its place in the file.

    Examples
    --------
    >>> inner = ModelError([Message("NumBlNds", "is missing", line=4, file="blade.dat")])
    >>> print(at_key(inner, "aerodyn").problems[0])
    aerodyn: NumBlNds (blade.dat, line 4): is missing
    """
    return ModelError([Message(key, str(p)) for p in error.problems])
