# SPDX-License-Identifier: Apache-2.0
"""Disk cache of the machine code of entry points, loaded without the compiler.

The import of Numba takes longer than all other work of a short command and is needed only to compile. An
entry point has integer arguments and allocates no memory, so that its code does not need Numba at run time:
one file per entry point contains it, and llvmlite links it into the process. Files of other sources,
versions, processors or settings have different names, and damaged files are ignored; the entry point is then
compiled again.
"""

from __future__ import annotations

import contextlib
import errno
import hashlib
import importlib.util
import os
import shutil
import stat
import sys
import tempfile
import time
from functools import cache
from pathlib import Path
from typing import Any

from pitchpoint.core.compiler.import_closure import import_closure
from pitchpoint.core.notices import notice
from pitchpoint.core.user_cache import user_cache

_HEAD = b"pitchpoint machine code 1"

#: Numba's destructor of an array that it allocated. Code that handles arrays refers to it, but code without
#: allocations never calls it.
UNREACHED = "NRT_MemInfo_call_dtor"

#: Substrings of the names of Numba settings that do not affect the machine code.
_NO_MATTER = ("CACHE", "THREAD", "DISABLE_JIT")

#: Prefix of temporary files, followed by the process number; abandoned after an hour.
_DRAFT = "draft-"
_DRAFT_AGE = 3600.0

_OTHERS = stat.S_IWOTH | stat.S_IWGRP

_begun = time.time()

#: Engines of linked code, retained until the process ends.
_engines: list[Any] = []


def cache_folder() -> Path:
    """Folder of the compiled kernels: NUMBA_CACHE_DIR if set, else in the user's cache folder."""
    chosen = os.environ.get("NUMBA_CACHE_DIR")
    return Path(chosen) if chosen else user_cache() / "kernels"


@cache
def source_stamp(file: str) -> str:
    """Hash of all sources that the kernels of a file depend on: its import closure.

    A source that was edited after the start of the process may differ from the imported one: the stamp is
    then random, so that no other process uses code stored under it.
    """
    digest, edited = hashlib.sha256(), False
    for path in import_closure(file):
        digest.update(path.name.encode() + path.read_bytes())
        edited = edited or _begun < path.stat().st_mtime <= time.time()
    if edited:
        digest.update(os.urandom(16))
    return digest.hexdigest()


@cache
def _settings() -> str:
    """Hash of everything except the sources that affects the machine code: versions, processor, options."""
    import llvmlite
    import llvmlite.binding as llvm

    options = sorted(
        (key, value)
        for key, value in os.environ.items()
        if key.startswith("NUMBA_") and not any(word in key for word in _NO_MATTER)
    )
    found = importlib.util.find_spec("numba")  # without import
    version = Path(str(found.origin)).with_name("_version.py") if found else Path()
    numba = version.read_text(encoding="utf-8") if version.is_file() else _installed_version("numba")
    processor = (llvm.get_process_triple(), llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten())
    text = repr((llvmlite.__version__, numba, sys.version_info[:2], options, processor, is_stock()))
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def is_stock() -> bool:
    """Whether PITCHPOINT_STOCK_NUMBA restricts the compilation to the public interface of Numba."""
    return os.environ.get("PITCHPOINT_STOCK_NUMBA", "0").strip() not in ("", "0")


def _installed_version(name: str) -> str:
    from importlib.metadata import version

    return version(name)


def symbol(function: Any) -> str:
    """Symbol of an entry point in its machine code."""
    return "".join(c if c.isalnum() else "_" for c in f"{function.__module__}.{function.__qualname__}")


def code_file(function: Any) -> Path | None:
    """Path of the machine code of an entry point, whether it exists or not.

    None if the source is not a file, or if other users can write to the cache.

    Parameters
    ----------
    function
        Python function of the entry point.
    """
    source = function.__code__.co_filename
    if function.__closure__ or not os.path.exists(source) or not is_trusted(_folder()):
        return None
    line = function.__code__.co_firstlineno  # distinguishes functions of the same name
    name = f"{_family(function)}-{line}-{source_stamp(source)[:32]}.code"
    return _folder() / name


def _folder() -> Path:
    return cache_folder() / "entries" / _settings()


def make_folder(folder: Path) -> None:
    """Create a cache folder with its parents; only the user may write to new folders."""
    if not folder.is_dir():
        make_folder(folder.parent)
        folder.mkdir(mode=0o700, exist_ok=True)


@cache
def is_trusted(folder: Path) -> bool:
    """Whether only the user and the administrator can write code to a folder; reported if not.

    The code in the folder is executed. Parent folders are checked too: write permission allows the
    replacement of their contents, unless the sticky bit restricts it to the owner.
    """
    if os.name != "posix":
        return True
    way, true = folder.absolute(), folder.resolve()
    for place in dict.fromkeys([way, *way.parents, true, *true.parents]):
        try:
            found, link = place.stat(), place.lstat()
        except OSError:  # not yet created
            continue
        others = stat.S_IWOTH if _is_private(found.st_gid) and place != folder else _OTHERS
        is_open = found.st_mode & others and not (place not in (way, true) and found.st_mode & stat.S_ISVTX)
        if is_open or not {found.st_uid, link.st_uid} <= {0, os.getuid()}:
            notice(
                f"{place}: other users can write to this folder of compiled kernels, so it is not used and "
                "kernels compile at every start; remove this permission (chmod go-w) or set NUMBA_CACHE_DIR"
            )
            return False
    return True


def _is_private(group: int) -> bool:
    """Whether a group is the private group of the user (same name, no other member)."""
    import grp
    import pwd

    try:
        user, found = pwd.getpwuid(os.getuid()).pw_name, grp.getgrgid(group)
    except KeyError:
        return False
    return found.gr_name == user and set(found.gr_mem) <= {user}


def own_bytes(file: Path) -> bytes:
    """Contents of a cache file that only the user can have written.

    Other users may have created a file before their permission was removed.

    Raises
    ------
    OSError
        If the file does not exist, or other users own it or can write to it.
    """
    with file.open("rb") as stream:
        found = os.fstat(stream.fileno())
        if os.name == "posix" and (found.st_mode & _OTHERS or found.st_uid not in (0, os.getuid())):
            raise PermissionError(errno.EPERM, os.strerror(errno.EPERM), str(file))
        return stream.read()


def can_save() -> bool:
    """Whether machine code can be stored: the user, and no one else, may write to the cache."""
    try:
        make_folder(_folder())
        if not is_trusted(_folder()):
            return False
        with tempfile.TemporaryFile(dir=_folder()):
            return True
    except OSError:
        return False


def _family(function: Any) -> str:
    """Prefix of the file names of an entry point, with a hash of its path: scripts are all `__main__`."""
    place = hashlib.sha256(os.path.abspath(function.__code__.co_filename).encode()).hexdigest()
    return f"{symbol(function)}-{place[:8]}"


def save(function: Any, code: bytes, needs: list[str]) -> None:
    """Store the machine code of an entry point; code of older sources is removed.

    Parameters
    ----------
    function
        Python function of the entry point.
    code
        Object file with the entry point under its `symbol`; empty if it needs Numba at run time.
    needs
        External symbols of the code, such as `sin`.
    """
    file = code_file(function)
    if file is None:
        return
    store(function, file, _HEAD, " ".join(needs).encode() + b"\n" + code)


def store(function: Any, file: Path, head: bytes, body: bytes) -> None:
    """Store a file of the cache; files of older sources of the function are removed.

    Parameters
    ----------
    function
        Python function of the entry point.
    file
        `code_file`, or the same name with another ending.
    head, body
        First line and contents, see `contents`.
    """
    data = b"\n".join([head, hashlib.sha256(body).hexdigest().encode(), body])
    with contextlib.suppress(OSError):  # a cache that is not writable only costs time
        make_folder(file.parent)
        with tempfile.TemporaryDirectory(prefix=f"{_DRAFT}{os.getpid()}-", dir=file.parent) as draft:
            whole = Path(draft, file.name)
            whole.write_bytes(data)
            whole.chmod(0o600)
            whole.replace(file)  # atomic, for concurrent readers
        stamp = file.stem.rpartition("-")[2]
        for other in file.parent.glob(f"{_family(function)}-*{file.suffix}"):
            if other.stem.rpartition("-")[2] != stamp:  # one source may have two functions of the same name
                other.unlink(missing_ok=True)
        clear_drafts()


def contents(file: Path, head: bytes) -> bytes | None:
    """Contents of a file of the cache; None without a valid file.

    Parameters
    ----------
    file
        The file.
    head
        Its first line.
    """
    try:
        found, digest, body = own_bytes(file).split(b"\n", 2)
    except (OSError, ValueError):
        return None
    return body if found == head and hashlib.sha256(body).hexdigest().encode() == digest else None


def clear_drafts(process: int | None = None) -> None:
    """Remove temporary files of killed processes from the cache.

    Parameters
    ----------
    process
        Number of a process that has ended; None: all temporary files older than `_DRAFT_AGE`.
    """
    for draft in _folder().glob(f"{_DRAFT}*" if process is None else f"{_DRAFT}{process}-*"):
        with contextlib.suppress(OSError):  # removed by another process
            if process is not None or time.time() - draft.stat().st_mtime > _DRAFT_AGE:
                shutil.rmtree(draft)


def _read(function: Any) -> tuple[list[str], bytes] | None:
    """External symbols and code of an entry point; None without a valid file."""
    file = code_file(function)
    body = contents(file, _HEAD) if file else None
    if body is None:
        return None
    needs, _, code = body.partition(b"\n")
    return needs.decode().split(), code


def is_refused(function: Any) -> bool:
    """Whether the cache marks an entry point as dependent on Numba at run time."""
    found = _read(function)
    return found is not None and not found[1]


def declared(module: Any) -> list[str]:
    """External symbols of an LLVM module."""
    functions = [f.name for f in module.functions if f.is_declaration and not f.name.startswith("llvm.")]
    return functions + [g.name for g in module.global_variables if g.is_declaration]


def is_foreign(needs: list[str]) -> bool:
    """Whether some of the symbols are of Numba's run time or of the interpreter."""
    return any(n.startswith(("NRT_", "numba_", "_Py", "Py")) for n in {*needs} - {UNREACHED})


def load(function: Any) -> int | None:
    """Load the machine code of an entry point from disk; returns its address, None without valid code.

    Parameters
    ----------
    function
        Python function of the entry point.
    """
    found = _read(function)
    return link(symbol(function), found[1], found[0]) if found and found[1] else None


def link(name: str, code: bytes, needs: list[str]) -> int | None:
    """Link an object file into the process; returns the address of a function, None if a symbol is missing.

    Parameters
    ----------
    name
        Symbol of the function.
    code
        Object file.
    needs
        External symbols. They are checked first, because LLVM aborts the process if one is missing.
    """
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    machine = llvm.Target.from_default_triple().create_target_machine(codemodel="jitdefault", jit=True)
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)  # registers the process symbols
    if UNREACHED in needs and llvm.address_of_symbol(UNREACHED) is None:
        llvm.add_symbol(UNREACHED, llvm.address_of_symbol("abort") or 0)  # an import of Numba replaces it
    if any(llvm.address_of_symbol(other) is None for other in needs):
        return None
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    _engines.append(engine)
    return int(engine.get_function_address(name)) or None
