# SPDX-License-Identifier: Apache-2.0
"""Files of models and those that they name: contents, caches of these, problems at the key of a file."""

from __future__ import annotations

import functools
import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TypeVar

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.nearest import similar_file

MAX_BYTES = 20_000_000
"""Largest text file that is read."""
T = TypeVar("T")


def contents(path: str | os.PathLike[str]) -> bytes:
    """Contents of a text file.

    Raises
    ------
    ModelError
        If it cannot be read or is larger than `MAX_BYTES`.
    """
    try:
        with Path(path).open("rb") as stream:
            data = stream.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        near = similar_file(Path(path).parent, Path(path).name)
        problem = Message("", f"cannot be read: {reason}", remedy=f"{near}check the name")
        raise ModelError([problem], str(path)) from None
    if len(data) > MAX_BYTES:
        raise ModelError([Message("", f"the file is larger than {MAX_BYTES // 10**6} MB")], str(path))
    return data


def read_once(files: int) -> Callable[[Callable[[str], T]], Callable[..., T]]:
    """Decorator of a function of a path: its file is read again only if it has changed since.

    The function then takes a second argument, further files that the file names.

    Parameters
    ----------
    files
        Number of files whose results are kept; results must not be changed.
    """

    def decorate(read: Callable[[str], T]) -> Callable[..., T]:
        """Reader with a cache."""

        @functools.lru_cache(maxsize=files)
        def kept(path: str, state: object) -> T:
            """Result for a state of the files."""
            return read(path)

        def found(path: str, further: Iterable[str] = ()) -> T:
            """Result for the present state."""
            return kept(path, states((path, *further)))

        return functools.wraps(read)(found)

    return decorate


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
