# SPDX-License-Identifier: Apache-2.0
"""Digest of the content of files that a model names: a changed file is another model."""

from __future__ import annotations

import functools
import hashlib
from pathlib import Path


def file_digest(file: str | None) -> str:
    """First 16 hexadecimal digits of the SHA-256 of a file, '' where there is none to be read.

    Examples
    --------
    >>> file_digest(None), file_digest("/no/such/file")
    ('', '')
    """
    if not file:
        return ""
    try:
        status = Path(file).stat()
        return _digest(file, status.st_mtime_ns, status.st_size)
    except (OSError, ValueError):
        return ""


@functools.lru_cache(maxsize=64)
def _digest(file: str, stamp: int, size: int) -> str:
    """Digest of a file; time of its last change and size tell whether it is the same."""
    with open(file, "rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()[:16]
