# SPDX-License-Identifier: Apache-2.0
"""Who writes a result file: its writer keeps it from being replaced, and nothing that is in use is emptied.

HDF5 locks a file while it is open, exclusively to write and shared to read, but a writer releases the lock
where SWMR begins. From then on it keeps a shared lock of its own: readers are admitted, and a process that
replaces the file requests an exclusive one first. The system drops a lock when its process ends.

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
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]


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
