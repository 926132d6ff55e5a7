# SPDX-License-Identifier: Apache-2.0
"""Locking of result files: a file that is being written or read is never replaced or truncated.

A writer holds an exclusive lock while it creates the structure of its file, and a shared lock from the start
of SWMR: readers, which use shared locks, are then admitted, and a process that replaces the file must obtain
an exclusive lock first. The system releases a lock when its process ends. The locks of HDF5 are not used for
the writer: HDF5 releases and reacquires its lock at the start of SWMR, and a reader in between would end the
run.

An older file is not truncated but unlinked, and the new one is created under the free name: a reader of the
old file without a lock can read it to its end. Of several writers that start simultaneously one continues;
the others find the name in use, or another file under it.

Windows has no such locks; there an open file cannot be removed. On a file system without locks the last
writer wins, and a writer whose file was removed reports this at its end.
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
"""Timeout of a writer for readers that opened its file at its creation [s]."""
_PAUSE = 0.001


def is_held(path: Path) -> bool:
    """Whether another process writes an existing file, or has it open in HDF5 with a lock."""
    with path.open("r+b") as file:
        return not _locked(file.fileno(), exclusive=True)


def share(descriptor: int) -> bool:
    """Prevent replacement of a file while it is read; False while HDF5 creates its structure."""
    return _locked(descriptor, exclusive=False)


def remove_old(path: Path) -> int | None:
    """Remove an older file, unless it is locked; return its permissions, None if there is no such file.

    Raises
    ------
    OSError
        A `BlockingIOError` if another process has locked the file.
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
        path.unlink()  # under the lock: earlier openers fail to lock it, later ones find no file


def hold(descriptor: int, path: Path) -> bool:
    """Lock a new file while its structure is created; False if another process has removed or locked it."""
    until = time.monotonic() + PATIENCE
    while is_at(descriptor, path):
        if _locked(descriptor, exclusive=True):
            return is_at(descriptor, path)
        if time.monotonic() > until:
            break
        time.sleep(_PAUSE)
    return False


def keep(descriptor: int, path: Path) -> bool:
    """Prevent replacement of a file while its descriptor is open; False if it has been replaced already."""
    return _locked(descriptor, exclusive=False) and is_at(descriptor, path)


def is_at(descriptor: int, path: Path) -> bool:
    """Whether an open file still has this name."""
    if fcntl is None:
        return True
    try:
        return os.path.samestat(os.fstat(descriptor), path.stat())
    except FileNotFoundError:
        return False


def _locked(descriptor: int, *, exclusive: bool) -> bool:
    """Request a lock; False if another process holds a conflicting one, True if locks are not supported."""
    if fcntl is None:
        return True
    try:
        fcntl.flock(descriptor, (fcntl.LOCK_EX if exclusive else fcntl.LOCK_SH) | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:
        return True  # a file system without locks
    return True
