# SPDX-License-Identifier: Apache-2.0
"""Machine code of entries on disk, and its way back into memory without the compiler.

Importing Numba and filling its tables takes longer than everything else that a short command does, and all
of it only serves to compile. An entry has plain integers as arguments and allocates nothing, so its code
needs nothing of Numba at run time: one file per entry holds it, and llvmlite alone links it into the process.
A file that does not fit (other sources, versions, processor or settings) is never found, a damaged one is not
used: then the entry is compiled again.
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

_HEAD = b"pitchpoint machine code 1"

#: Numba's clean-up of an array that it allocated itself. Code that allocates nothing mentions it, because it
#: handles arrays, but never gets there.
UNREACHED = "NRT_MemInfo_call_dtor"

#: Words in the names of settings of Numba that do not change its code.
_NO_MATTER = ("CACHE", "THREAD", "DISABLE_JIT")

#: What the names of drafts begin with, before the number of the process; after an hour it is abandoned.
_DRAFT = "draft-"
_DRAFT_AGE = 3600.0

_OTHERS = stat.S_IWOTH | stat.S_IWGRP

_begun = time.time()

#: What is linked lives as long as the process.
_engines: list[Any] = []


def cache_folder() -> Path:
    """Folder of the compiled kernels: NUMBA_CACHE_DIR if set, else the user's cache."""
    chosen = os.environ.get("NUMBA_CACHE_DIR")
    if chosen:
        return Path(chosen)
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData" / "Local"))
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Caches"
    else:
        base = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache"))
    return base / "pitchpoint" / "kernels"


@cache
def source_stamp(file: str) -> str:
    """Hash of all sources that the kernels of a file depend on: its import closure.

    A source that was edited after the process began may differ from what was imported: then no other process
    will find what is stored under the stamp.
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
    """Hash of what determines the compiler's output besides the sources: versions, processor, options."""
    import llvmlite
    import llvmlite.binding as llvm

    options = sorted(
        (key, value)
        for key, value in os.environ.items()
        if key.startswith("NUMBA_") and not any(word in key for word in _NO_MATTER)
    )
    found = importlib.util.find_spec("numba")  # finds it without importing it
    version = Path(str(found.origin)).with_name("_version.py") if found else Path()
    numba = version.read_text(encoding="utf-8") if version.is_file() else _installed_version("numba")
    processor = (llvm.get_process_triple(), llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten())
    text = repr((llvmlite.__version__, numba, sys.version_info[:2], options, processor, is_stock()))
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def is_stock() -> bool:
    """Whether the user wants kernels compiled through the public interface of Numba alone."""
    return os.environ.get("PITCHPOINT_STOCK_NUMBA", "0").strip() not in ("", "0")


def _installed_version(name: str) -> str:
    from importlib.metadata import version

    return version(name)


def symbol(function: Any) -> str:
    """Name of an entry in its machine code."""
    return "".join(c if c.isalnum() else "_" for c in f"{function.__module__}.{function.__qualname__}")


def code_file(function: Any) -> Path | None:
    """File of the machine code of an entry, written yet or not; None if it cannot have one.

    It has none if its sources are not in files, or if other users can write to the cache.

    Parameters
    ----------
    function
        The plain Python function of the entry.
    """
    source = function.__code__.co_filename
    if function.__closure__ or not os.path.exists(source) or not is_trusted(_folder()):
        return None
    line = function.__code__.co_firstlineno  # distinguishes functions of one name
    name = f"{_family(function)}-{line}-{source_stamp(source)[:32]}.code"
    return _folder() / name


def _folder() -> Path:
    return cache_folder() / "entries" / _settings()


def make_folder(folder: Path) -> None:
    """Make a folder of the cache, with those above it; only the user may write to new ones."""
    if not folder.is_dir():
        make_folder(folder.parent)
        folder.mkdir(mode=0o700, exist_ok=True)


@cache
def is_trusted(folder: Path) -> bool:
    """Whether only the user and the administrator can put code into a folder; reported if not.

    What lies there is executed. Folders above count, too: who may write to one can replace what is in it,
    unless its sticky bit reserves that for the owner.
    """
    if os.name != "posix":
        return True
    way, true = folder.absolute(), folder.resolve()
    for place in dict.fromkeys([way, *way.parents, true, *true.parents]):
        try:
            found, link = place.stat(), place.lstat()
        except OSError:  # it does not exist yet
            continue
        others = stat.S_IWOTH if _is_private(found.st_gid) and place != folder else _OTHERS
        is_open = found.st_mode & others and not (place not in (way, true) and found.st_mode & stat.S_ISVTX)
        if is_open or not {found.st_uid, link.st_uid} <= {0, os.getuid()}:
            notice(
                f"{place}: other users can write to this folder of compiled kernels, so it is not used and "
                "every start compiles; remove their permission (chmod go-w) or set NUMBA_CACHE_DIR"
            )
            return False
    return True


def _is_private(group: int) -> bool:
    """Whether a group is the user's own, which many systems make with each user: it has the same name."""
    import grp
    import pwd

    try:
        user, found = pwd.getpwuid(os.getuid()).pw_name, grp.getgrgid(group)
    except KeyError:
        return False
    return found.gr_name == user and set(found.gr_mem) <= {user}


def own_bytes(file: Path) -> bytes:
    """Contents of a file of the cache that only the user can have written.

    Others may have left it in the folder before their permission was removed.

    Raises
    ------
    OSError
        If there is no such file, or it is not the user's alone.
    """
    with file.open("rb") as stream:
        found = os.fstat(stream.fileno())
        if os.name == "posix" and (found.st_mode & _OTHERS or found.st_uid not in (0, os.getuid())):
            raise PermissionError(errno.EPERM, os.strerror(errno.EPERM), str(file))
        return stream.read()


def can_save() -> bool:
    """Whether machine code can be kept: whether the user, and no one else, may write to the cache."""
    try:
        make_folder(_folder())
        if not is_trusted(_folder()):
            return False
        with tempfile.TemporaryFile(dir=_folder()):
            return True
    except OSError:
        return False


def _family(function: Any) -> str:
    """What the names of all files of an entry begin with; scripts share the module `__main__`."""
    place = hashlib.sha256(os.path.abspath(function.__code__.co_filename).encode()).hexdigest()
    return f"{symbol(function)}-{place[:8]}"


def save(function: Any, code: bytes, needs: list[str]) -> None:
    """Keep the machine code of an entry; it replaces that of older sources.

    Parameters
    ----------
    function
        The plain Python function of the entry.
    code
        Object file with the entry under its `symbol`; empty if it cannot live without the compiler.
    needs
        Symbols that the code expects in the process, such as `sin`.
    """
    file = code_file(function)
    if file is None:
        return
    body = " ".join(needs).encode() + b"\n" + code
    data = b"\n".join([_HEAD, hashlib.sha256(body).hexdigest().encode(), body])
    with contextlib.suppress(OSError):  # a cache that cannot be written costs time only
        make_folder(file.parent)
        with tempfile.TemporaryDirectory(prefix=f"{_DRAFT}{os.getpid()}-", dir=file.parent) as draft:
            whole = Path(draft, file.name)
            whole.write_bytes(data)
            whole.chmod(0o600)
            whole.replace(file)  # at once, also for a process that reads it now
        stamp = file.name.rpartition("-")[2]
        for other in file.parent.glob(f"{_family(function)}-*.code"):
            if other.name.rpartition("-")[2] != stamp:  # the same sources may hold two functions of one name
                other.unlink(missing_ok=True)
        clear_drafts()


def clear_drafts(process: int | None = None) -> None:
    """Remove what killed processes left in the cache as they wrote machine code.

    Parameters
    ----------
    process
        Number of a process that has ended; without it, all drafts older than `_DRAFT_AGE` go.
    """
    for draft in _folder().glob(f"{_DRAFT}*" if process is None else f"{_DRAFT}{process}-*"):
        with contextlib.suppress(OSError):  # another process was quicker
            if process is not None or time.time() - draft.stat().st_mtime > _DRAFT_AGE:
                shutil.rmtree(draft)


def _read(function: Any) -> tuple[list[str], bytes] | None:
    """What the code of an entry needs, and the code; None without a sound file."""
    file = code_file(function)
    try:
        head, digest, body = own_bytes(file).split(b"\n", 2) if file else (b"", b"", b"")
    except (OSError, ValueError):
        return None
    if head != _HEAD or hashlib.sha256(body).hexdigest().encode() != digest:
        return None
    needs, _, code = body.partition(b"\n")
    return needs.decode().split(), code


def is_refused(function: Any) -> bool:
    """Whether it is known that the code of an entry cannot live without the compiler."""
    found = _read(function)
    return found is not None and not found[1]


def declared(module: Any) -> list[str]:
    """Symbols that a module of LLVM expects in the process."""
    functions = [f.name for f in module.functions if f.is_declaration and not f.name.startswith("llvm.")]
    return functions + [g.name for g in module.global_variables if g.is_declaration]


def is_foreign(needs: list[str]) -> bool:
    """Whether some of these symbols belong to Numba's run time or to the interpreter."""
    return any(n.startswith(("NRT_", "numba_", "_Py", "Py")) for n in {*needs} - {UNREACHED})


def load(function: Any) -> int | None:
    """Address of an entry whose machine code is on disk and fits; None otherwise.

    Parameters
    ----------
    function
        The plain Python function of the entry.
    """
    found = _read(function)
    return link(symbol(function), found[1], found[0]) if found and found[1] else None


def link(name: str, code: bytes, needs: list[str]) -> int | None:
    """Bring an object file into the process; address of one of its functions, None if something is missing.

    Parameters
    ----------
    name
        Symbol of the function.
    code
        Object file.
    needs
        Symbols that it expects. LLVM ends the process over a missing one, hence the look before.
    """
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    machine = llvm.Target.from_default_triple().create_target_machine(codemodel="jitdefault", jit=True)
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)  # makes the process's symbols known
    if UNREACHED in needs and llvm.address_of_symbol(UNREACHED) is None:
        llvm.add_symbol(UNREACHED, llvm.address_of_symbol("abort") or 0)  # Numba replaces it when it comes
    if any(llvm.address_of_symbol(other) is None for other in needs):
        return None
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    _engines.append(engine)
    return int(engine.get_function_address(name)) or None
