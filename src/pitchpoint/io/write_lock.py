# SPDX-License-Identifier: Apache-2.0
"""Who writes a result file: its writer keeps it from being replaced, and nothing that is in use is emptied.

A writer holds an exclusive lock while it makes the structure of its file, and a shared one from where SWMR
begins: readers, which lock a file shared, are admitted then, and a process that replaces the file requests an
exclusive one first. The system drops a lock when its process ends. HDF5 does not lock for the writer: it
releases its lock and requests it again where SWMR begins, and a reader in between would end the run.

An older file is not emptied but taken out of its folder, and the new one is made where no file is: a reader
of the old one without a lock reads it to its end. Of several writers that begin at once one continues; the
others find the name taken, or another file under it.

Windows has no such locks; there an open file cannot be taken away. On a file system without locks the last
writer wins, and the one whose file is gone reports it at its end.
"""

from __future__ import annotations

import errno
import os
import stat
import time
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

PATIENCE = 5.0
"""How long a writer waits for readers that opened its file the moment it was there [s]."""
_PAUSE = 0.001


def is_held(path: Path) -> bool:
    """Whether somebody writes an existing file, or has it open in HDF5 with its lock."""
    with path.open("r+b") as file:
        return not _locked(file.fileno(), exclusive=True)


def share(descriptor: int) -> bool:
    """Keep a file from being replaced while it is read; False while HDF5 still makes its structure."""
    return _locked(descriptor, exclusive=False)


def remove_old(path: Path) -> int | None:
    """Take an older file away, unless it is held; gives its permissions, None if there is no such file.

    Raises
    ------
    OSError
        A `BlockingIOError` if another process holds the file.
    """
    try:
        mode = path.stat().st_mode
        if not stat.S_ISREG(mode):
            raise OSError("no ordinary file")
        _unlink_unless_held(path)
    except FileNotFoundError:
        return None
    return stat.S_IMODE(mode)


def _unlink_unless_held(path: Path) -> None:
    if fcntl is None:
        path.unlink()
        return
    with path.open("r+b") as file:
        if not _locked(file.fileno(), exclusive=True) or not is_at(file.fileno(), path):
            raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
        path.unlink()  # under the lock: whoever opened it before is refused, whoever comes now finds no file


def hold(descriptor: int, path: Path) -> bool:
    """Lock a new file while its structure is made; False if another process has taken it away or keeps it."""
    until = time.monotonic() + PATIENCE
    while is_at(descriptor, path):
        if _locked(descriptor, exclusive=True):
            return is_at(descriptor, path)
        if time.monotonic() > until:
            break
        time.sleep(_PAUSE)
    return False


def keep(descriptor: int, path: Path) -> bool:
    """Keep a file from being replaced while its descriptor is open; False if that has happened already."""
    return _locked(descriptor, exclusive=False) and is_at(descriptor, path)


def is_at(descriptor: int, path: Path) -> bool:
    """Whether an open file is still the one of this name."""
    if fcntl is None:
        return True
    try:
        return os.path.samestat(os.fstat(descriptor), path.stat())
    except FileNotFoundError:
        return False


def _locked(descriptor: int, *, exclusive: bool) -> bool:
    """Request a lock; False if another process holds one against it, True also where there are no locks."""
    if fcntl is None:
        return True
    try:
        fcntl.flock(descriptor, (fcntl.LOCK_EX if exclusive else fcntl.LOCK_SH) | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:
        return True  # a file system that knows no locks
    return True
