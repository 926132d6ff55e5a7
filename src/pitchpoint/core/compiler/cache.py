# SPDX-License-Identifier: Apache-2.0
"""Disk cache of kernels compiled for calls from Python: validity check, one file per signature.

Numba's cache checks only the file of the function itself; the locator here hashes the *import closure* of
that file, so that the cache is invalidated by an edited helper and not by an unrelated edit. Numba numbers
the files of a function through an index that processes read and write without locking: if two processes
compile concurrently, the code of one signature may be stored under another, and its call crashes the process.
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
    """Location and validity stamp of compiled kernels, for Numba."""

    def __init__(self, py_func: Any, py_file: str) -> None:
        self._py_file = py_file
        self._lineno = py_func.__code__.co_firstlineno
        mode = "bounds" if config.BOUNDSCHECK else "plain"
        self._path = str(machine_code.cache_folder() / mode / self.get_suitable_cache_subpath(py_file))

    def get_cache_path(self) -> str:
        """Folder of the cache files."""
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
        """Line of the function, which distinguishes functions of the same name."""
        return str(self._lineno)

    @classmethod
    def from_function(cls, py_func: Any, py_file: str) -> Locator | None:
        """Locator of a function; None without a source file, or if the folder is not writable or trusted."""
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
    """Cache files of one function: one file per key, with a checksum.

    Parameters
    ----------
    folder
        Folder of the files.
    name
        Prefix of the file names.
    stamp
        Hash of all dependencies of the code; files with a different stamp are ignored and overwritten.
    """

    def __init__(self, folder: str | os.PathLike[str], name: str, stamp: str) -> None:
        self._start = Path(folder, name)
        self._stamp = stamp

    def _file(self, key: Any) -> Path:
        digest = hashlib.sha256(repr(key).encode()).hexdigest()[:16]
        return self._start.with_name(f"{self._start.name}.{digest}.nbc")

    def load(self, key: Any) -> Any:
        """Data stored under a key with the current stamp; None without a valid file."""
        try:
            digest, body = machine_code.own_bytes(self._file(key)).split(b"\n", 1)
        except (OSError, ValueError):
            return None
        if digest != hashlib.sha256(body).hexdigest().encode():
            return None
        head, _, kept = body.partition(b"\n")
        return pickle.loads(kept) if head == self._head(key) else None

    def save(self, key: Any, data: Any) -> None:
        """Store data under a key; the file is replaced atomically."""
        body = self._head(key) + b"\n" + dumps(data)
        file = self._file(key)
        draft = file.with_name(f"{file.name}.{uuid.uuid4().hex[:16]}")
        with contextlib.suppress(OSError):  # a cache that is not writable only costs time
            try:
                draft.write_bytes(hashlib.sha256(body).hexdigest().encode() + b"\n" + body)
                draft.chmod(0o600)
                draft.replace(file)
            finally:
                draft.unlink(missing_ok=True)

    def _head(self, key: Any) -> bytes:
        return hashlib.sha256(repr((self._stamp, key)).encode()).hexdigest().encode()


class _Located(CompileResultCacheImpl):
    """Numba's serialisation of compilation results, located by `Locator` only."""

    _locator_classes = [Locator]


class KernelCache(FunctionCache):
    """Numba's function cache with one file per signature; raises `RuntimeError` without a usable folder."""

    _impl_class = _Located

    def __init__(self, py_func: Any) -> None:
        super().__init__(py_func)
        locator = self._impl.locator
        self._cache_file = KernelFiles(
            locator.get_cache_path(), self._impl.filename_base, locator.get_source_stamp()
        )
