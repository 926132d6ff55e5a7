# SPDX-License-Identifier: Apache-2.0
"""Provenance of a result: version, model, solver and options as attributes of a dataset."""

from __future__ import annotations

import dataclasses
import hashlib
import json
import platform
from collections.abc import Mapping, Sized
from datetime import UTC, datetime
from enum import Enum
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from pitchpoint.core.status import sentence


@lru_cache(maxsize=1)
def package_version() -> str:
    """Version of the installed package."""
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("pitchpoint")
    except PackageNotFoundError:
        return "unknown"


def content_hash(data: Any) -> str:
    """Hash of nested data, independent of the order of keys and of the process.

    Parameters
    ----------
    data
        Numbers, texts, sequences, mappings, arrays, dataclasses, nested. For a field with a key of kind
        "file" or "library" the content of the file is hashed, not its name. Fields that are excluded from
        comparison, such as lines in a file, and fields whose key is marked `later` are ignored while they are
        None, an empty container or their default. The attribute `former_values` of a dataclass has the values
        of its empty fields in earlier versions; its attribute `further_files` has files that its files name,
        whose content is hashed, too.

    Returns
    -------
    str
        First 16 hexadecimal digits of a SHA-256.

    Examples
    --------
    >>> content_hash({"a": 1, "b": [2.0]}) == content_hash({"b": [2.0], "a": 1})
    True
    """
    text = json.dumps(plain_data(data), sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def provenance(
    *, model_hash: str, solver: str, options: Mapping[str, Any], status: int, wall_s: float
) -> dict[str, str | int | float]:
    """Attributes of every result.

    Parameters
    ----------
    model_hash
        `content_hash` of the model.
    solver
        Name of the solver.
    options
        Options of the solver, stored as JSON.
    status
        Integer status of `pitchpoint.core.status`.
    wall_s
        Wall time [s].
    """
    return {
        "pitchpoint_version": package_version(),
        "model_hash": model_hash,
        "solver": solver,
        "options": json.dumps(plain_data(options), sort_keys=True),
        "status": int(status),
        "status_text": sentence(status),
        "wall_s": float(wall_s),
        "created": datetime.now(UTC).isoformat(timespec="seconds"),
        "python": platform.python_version(),
        "numpy": np.__version__,
    }


def plain_data(data: Any) -> Any:
    """Convert nested data to JSON types, as `content_hash` compares them.

    Parameters
    ----------
    data
        As for `content_hash`.

    Examples
    --------
    >>> plain_data({1: (2.0, float("inf"))})
    {'1': [2.0, 'inf']}
    """
    if dataclasses.is_dataclass(data) and not isinstance(data, type):
        read = bool(getattr(data, "digest", ""))  # the content is hashed, not the path
        compared = [f for f in dataclasses.fields(data) if f.compare and not (read and f.name == "file")]
        compared = [f for f in compared if not _came_later(f) or _differs(f, getattr(data, f.name))]
        former = getattr(data, "former_values", {})
        fields = {
            f.name: plain_data(former.get(f.name) if value is None else _content(f, value))
            for f in compared
            for value in (getattr(data, f.name),)
        }
        if further := getattr(data, "further_files", ()):
            fields["further files"] = [_of_file(path) for path in further]
        return {"": type(data).__name__, **fields}
    if isinstance(data, Mapping):
        return {str(k): plain_data(v) for k, v in data.items()}
    if isinstance(data, Enum):
        return data.name
    if isinstance(data, np.ndarray):
        return [str(data.dtype), list(data.shape), plain_data(data.tolist())]
    if isinstance(data, list | tuple):
        return [plain_data(v) for v in data]
    if isinstance(data, set | frozenset):
        return sorted((plain_data(v) for v in data), key=repr)
    if isinstance(data, bool | int | str) or data is None:
        return data
    if isinstance(data, float | np.floating):
        return float(data) if np.isfinite(data) else repr(float(data))
    if isinstance(data, np.integer | np.bool_):
        return data.item()
    return str(data)


def _came_later(field: dataclasses.Field[Any]) -> bool:
    """Whether a key was added later: models without it retain their hash, which seeds random noise."""
    return bool(getattr(field.metadata.get("key"), "later", field.metadata.get("later", False)))


def _differs(field: dataclasses.Field[Any], value: Any) -> bool:
    """Whether a value is neither missing, an empty container, nor the default of its field; 0 is a value."""
    if value is None or (isinstance(value, Sized) and len(value) == 0):
        return False
    return type(value) is not type(field.default) or bool(value != field.default)


def _content(field: dataclasses.Field[Any], value: Any) -> Any:
    """Value of a field; for the name of a file, the hash of its content."""
    if value is None or getattr(field.metadata.get("key"), "kind", "") not in ("file", "library"):
        return value
    return _of_file(value)


def _of_file(path: Any) -> Any:
    """Hash of the content of a file; its name if it cannot be read."""
    try:
        status = Path(path).stat()
        return _file_hash(str(path), status.st_mtime_ns, status.st_size)
    except (OSError, ValueError):
        return path


@lru_cache(maxsize=64)
def _file_hash(path: str, stamp: int, size: int) -> str:
    """Hash of the content of a file; `stamp` and `size` are keys of the cache."""
    with Path(path).open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
