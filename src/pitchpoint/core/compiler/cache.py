# SPDX-License-Identifier: Apache-2.0
"""Kernels compiled for calls from Python, on disk: when they are out of date, one file for each signature.

Numba's own cache looks only at the file of the function itself; the locator here stamps the *import closure*
of that file, so an edited helper is noticed and an unrelated edit is not. Numba numbers the files of a
function through an index that processes read and write without knowing of each other: of two that compile at
once the code of one signature may end under another, and what calls it ends the process.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import pickle
import uuid
from pathlib import Path
from typing import Any

from numba import config
from numba.core.caching import CompileResultCacheImpl, FunctionCache, _CacheLocator
from numba.core.serialize import dumps

from pitchpoint.core.compiler import machine_code
from pitchpoint.core.compiler.intrinsics import FLAGS


class Locator(_CacheLocator):
    """Shows Numba where compiled kernels are and when they are out of date."""

    def __init__(self, py_func: Any, py_file: str) -> None:
        self._py_file = py_file
        self._lineno = py_func.__code__.co_firstlineno
        mode = "bounds" if config.BOUNDSCHECK else "plain"
        self._path = str(machine_code.cache_folder() / mode / self.get_suitable_cache_subpath(py_file))

    def get_cache_path(self) -> str:
        """Folder of the compiled files."""
        return self._path

    def get_source_stamp(self) -> str:
        """Hash of everything that the compiled code depends on."""
        options = (
            config.BOUNDSCHECK,
            config.OPT,
            config.DEBUG,
            FLAGS["error_model"],
            *sorted(FLAGS["fastmath"]),
        )
        return f"{options!r} {machine_code.source_stamp(self._py_file)}"

    def get_disambiguator(self) -> str:
        """Line of the function, which distinguishes functions of one name."""
        return str(self._lineno)

    @classmethod
    def from_function(cls, py_func: Any, py_file: str) -> Locator | None:
        """Locator of a function; None without a file, and where nothing can be written or trusted."""
        if not os.path.exists(py_file):
            return None
        self = cls(py_func, py_file)
        try:
            machine_code.make_folder(Path(self._path))
            self.ensure_cache_path()
        except OSError:
            return None
        return self if machine_code.is_trusted(Path(self._path)) else None


class KernelFiles:
    """What is kept of one function: a file for every key, which describes its contents.

    Parameters
    ----------
    folder
        Where the files lie.
    name
        What their names begin with.
    stamp
        Hash of what the code depends on; files with another are not used, and overwritten.
    """

    def __init__(self, folder: str | os.PathLike[str], name: str, stamp: str) -> None:
        self._start = Path(folder, name)
        self._stamp = stamp

    def _file(self, key: Any) -> Path:
        digest = hashlib.sha256(repr(key).encode()).hexdigest()[:16]
        return self._start.with_name(f"{self._start.name}.{digest}.nbc")

    def load(self, key: Any) -> Any:
        """What was kept under a key and the present stamp; None without a sound file."""
        try:
            digest, body = machine_code.own_bytes(self._file(key)).split(b"\n", 1)
        except (OSError, ValueError):
            return None
        if digest != hashlib.sha256(body).hexdigest().encode():
            return None
        head, _, kept = body.partition(b"\n")
        return pickle.loads(kept) if head == self._head(key) else None

    def save(self, key: Any, data: Any) -> None:
        """Keep data under a key, at once also for a process that reads it now."""
        body = self._head(key) + b"\n" + dumps(data)
        file = self._file(key)
        draft = file.with_name(f"{file.name}.{uuid.uuid4().hex[:16]}")
        with contextlib.suppress(OSError):  # a cache that cannot be written costs time only
            try:
                draft.write_bytes(hashlib.sha256(body).hexdigest().encode() + b"\n" + body)
                draft.chmod(0o600)
                draft.replace(file)
            finally:
                draft.unlink(missing_ok=True)

    def _head(self, key: Any) -> bytes:
        return hashlib.sha256(repr((self._stamp, key)).encode()).hexdigest().encode()


class _Located(CompileResultCacheImpl):
    """Numba's way to write a compilation, with places by `Locator` alone."""

    _locator_classes = [Locator]


class KernelCache(FunctionCache):
    """Numba's cache of a function with a file for every signature; `RuntimeError` where it has no place."""

    _impl_class = _Located

    def __init__(self, py_func: Any) -> None:
        super().__init__(py_func)
        locator = self._impl.locator
        self._cache_file = KernelFiles(
            locator.get_cache_path(), self._impl.filename_base, locator.get_source_stamp()
        )
