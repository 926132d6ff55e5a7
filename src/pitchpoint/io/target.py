# SPDX-License-Identifier: Apache-2.0
"""Before a file is written: only what pitchpoint wrote of the same kind may be replaced, and never an input.

Kind and writer are read from the contents, not from the ending. Files that are not ordinary (a pipe, a
terminal) are not checked.
"""

from __future__ import annotations

import contextlib
import errno
import os
import re
import shutil
import threading
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from pitchpoint.core.errors import Message, PitchpointError
from pitchpoint.io.unmarked_file import DAMAGE, UnmarkedFile
from pitchpoint.io.write_lock import is_held, share

HDF5 = b"\x89HDF\r\n\x1a\n"
HEAD = 1024
"""Bytes from which a kind of file is known."""

_SUPERBLOCK = 48
"""Bytes of what HDF5 writes first: a file that ends there has no contents."""


_DISK_FAULTS = {getattr(errno, name, 0) for name in ("ENOSPC", "EDQUOT", "EFBIG", "EIO")} - {0}


class OutputError(PitchpointError, OSError):
    """A file cannot be written, or must not be."""


def _is_result(path: Path, head: bytes) -> bool:
    """Recognise a result by its attribute `format`, which is on the disk before any other contents.

    What cannot be opened may be a damaged file of another program: it does not count as a result.
    """
    if not head.startswith(HDF5):
        return False
    if len(head) <= _SUPERBLOCK:
        return True  # a run that was killed as it began
    import h5py

    try:
        with UnmarkedFile(os.fspath(path)) as unmarked:
            if not share(unmarked.fileno()):
                raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
            with h5py.File(unmarked, "r") as file:
                return str(file.attrs.get("format", "")).startswith("pitchpoint")
    except (BlockingIOError, FileNotFoundError):
        raise  # another process has just begun to write it, or has taken it away
    except DAMAGE:
        return False


def _begins(word: bytes) -> Callable[[Path, bytes], bool]:
    return lambda _, head: head.startswith(word)


def _marked(word: bytes, mark: str) -> Callable[[Path, bytes], bool]:
    return lambda _, head: head.startswith(word) and mark.encode() in head


def _is_animation(_: Path, head: bytes) -> bool:
    """Recognise an animation of modes by its first words, or by the first array in its archive."""
    return head.startswith(b'{"about": "motion: mode, frame') or head[30:40] == b"bodies.npy"


PAGE_MARK = '<meta name="generator" content="pitchpoint">'
SVG_MARK = "<!-- generator: pitchpoint -->"
DXF_MARK = "999\npitchpoint\n"
STEP_MARK = "pitchpoint"
ANALYSIS_MARK = "# pitchpoint analysis\n"
"""Marks of the writer in pages, drawings and tables; in DXF the group 999 is a comment."""


INDEX_HEAD = "case,file,status,status_code,sentence"
"""First columns of the table of the cases of a data set."""


KINDS: dict[str, tuple[str, Callable[[Path, bytes], bool]]] = {
    "result": ("a readable result file of pitchpoint", _is_result),
    "page": ("an HTML page of pitchpoint", _marked(b"<!DOCTYPE html>", PAGE_MARK)),
    "csv": ("points of a gear of pitchpoint (CSV)", _begins(b"x [mm],y [mm],tooth,region")),
    "analysis": ("a table of an analysis of pitchpoint (CSV)", _begins(ANALYSIS_MARK.encode())),
    "dxf": ("a drawing of pitchpoint (DXF)", _begins(DXF_MARK.encode())),
    "svg": ("a drawing of pitchpoint (SVG)", _marked(b"<svg", SVG_MARK)),
    "index": ("a table of cases of pitchpoint (CSV)", _begins(INDEX_HEAD.encode())),
    "animation": ("an animation of modes of pitchpoint (JSON, NPZ)", _is_animation),
    "stl": ("a solid of pitchpoint (STL)", _begins(b"pitchpoint ")),
    "step": ("a solid of pitchpoint (STEP)", _marked(b"ISO-10303-21;", f"'{STEP_MARK}'")),
}
"""Words for a kind of file and how it is recognised, by name."""


def check_target(
    path: str | os.PathLike[str], kind: str, inputs: Iterable[str | os.PathLike[str]] = ()
) -> Path:
    """Give the path of a file that may be written: a new or empty one, or an older one of the same kind.

    Parameters
    ----------
    path
        File to write.
    kind
        Name in `KINDS`.
    inputs
        Files that the same command reads; links and relative names of them count as well.

    Raises
    ------
    OutputError
        If writing is not possible there, or would destroy an input, a file of another kind or origin, or a
        result that another process writes.
    """
    target = Path(path)
    words, recognised = KINDS[kind]
    try:
        _accessible(target)
        if not target.is_file():
            return target
        if any(Path(name).exists() and target.samefile(name) for name in inputs):
            raise _refused(target, "is read by the same command", "a file of its own", "name another file")
        if not os.access(target.resolve().parent, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        if kind == "result" and is_held(target):
            raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
        with target.open("rb") as file:
            head = file.read(HEAD)
        if head and not recognised(target, head):
            remedy = "name another file, or delete this one first"
            raise _refused(target, f"exists and is not {words}", f"a new file, or {words}", remedy)
    except OutputError:
        raise
    except FileNotFoundError:
        return target  # another process has just taken it away
    except (OSError, ValueError) as error:
        raise OutputError(cannot_be_written(target, error)) from error
    return target


def check_place(path: str | os.PathLike[str]) -> None:
    """Report before a long computation that its file has no place; folders that are missing are made later.

    Raises
    ------
    OutputError
        If the place is a folder, lies below a file, or must not be written to.
    """
    target = Path(path)
    try:
        _accessible(target)
    except (OSError, ValueError) as error:
        raise OutputError(cannot_be_written(target, error)) from error


def write_file(path: str | os.PathLike[str], data: str | bytes) -> Path:
    """Write a whole file, texts as UTF-8, bytes of damaged texts as question marks; its folder is made.

    An older file stays as it is until the new one is on the disk. Pipes need a process that reads them.

    Raises
    ------
    OutputError
        With the path and the reason, if that is not possible.
    """
    target = Path(path)
    whole = data.encode("utf-8", "replace") if isinstance(data, str) else data
    try:
        make_folder(target)
        if target.exists() and not target.is_file():
            _write_stream(target, whole)
        else:
            with replacing(target) as draft:
                write_draft(draft, whole)
    except (OSError, ValueError) as error:
        raise OutputError(cannot_be_written(target, error)) from error
    return target


@contextlib.contextmanager
def replacing(target: Path, draft: Path | None = None) -> Iterator[Path]:
    """Give the path of a side file that takes the place of the target when the block ends without an error.

    Parameters
    ----------
    target
        The file; links are followed, and an older file passes on its permissions.
    draft
        The side file; one in the same folder with the ending of the target if omitted.
    """
    place = target.resolve()
    if draft is None:
        draft = place.with_name(f"{place.stem[:60]}.{os.getpid()}-{threading.get_ident()}.part{place.suffix}")
    try:
        yield draft
        if place.exists():
            with contextlib.suppress(OSError):  # a file system without permissions
                shutil.copymode(place, draft)
        draft.replace(place)
    finally:
        with contextlib.suppress(OSError):
            draft.unlink(missing_ok=True)


def write_draft(draft: Path, data: bytes) -> None:
    """Write a side file to the disk: a full disk is reported here, not after the older file is gone."""
    with draft.open("wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())


def _write_stream(target: Path, data: bytes) -> None:
    """Write to a pipe or device; opening a pipe without a reader would wait for ever."""
    descriptor = os.open(target, os.O_WRONLY | getattr(os, "O_NONBLOCK", 0))
    os.set_blocking(descriptor, True)
    with open(descriptor, "wb") as file:
        file.write(data)


def make_folder(target: Path) -> None:
    """Make the folder of a file, and those on the way to it, where they do not exist: every writer does.

    Raises
    ------
    OSError
        If that is not possible.
    """
    target.parent.mkdir(parents=True, exist_ok=True)


def cannot_be_written(target: Path, error: OSError | ValueError) -> str:
    """Message on a file that cannot be written: the reason, and the remedy if another process uses it."""
    remedy = ""
    if isinstance(error, BlockingIOError | FileExistsError):
        remedy = "; wait until it is closed, or name another file"
    elif isinstance(error, OSError) and error.errno == errno.ENXIO:
        remedy = "; start the process that reads this pipe first"
    return f"{target}: cannot be written ({reason_of(error)}){remedy}"


def reason_of(error: OSError | ValueError) -> str:
    """The reason in a few words why the system, or HDF5, refused a file."""
    if isinstance(error, BlockingIOError | FileExistsError):
        return "another process holds it"
    number = disk_errno(error)
    if number:
        return os.strerror(number)  # HDF5 wraps the same words in many of its own
    return str(error).split("(")[-1].rstrip(")") or type(error).__name__


def disk_errno(error: BaseException) -> int:
    """Number of the error of the system, which HDF5 may give in its text only; 0 without one."""
    if isinstance(error, OSError) and error.errno:
        return error.errno
    found = re.search(r"errno = (\d+)", str(error))
    return int(found[1]) if found else 0


def is_disk_fault(error: BaseException | None) -> bool:
    """Whether an error, or what caused it, is a disk that is full or broken, a quota or a limit of size."""
    while error is not None:
        if disk_errno(error) in _DISK_FAULTS:
            return True
        error = error.__cause__
    return False


def _accessible(target: Path) -> None:
    """Ask whether a file may be written there."""
    asked = target if target.exists() else next(p for p in target.absolute().parents if p.exists())
    if target.is_dir():
        error = errno.EISDIR
    elif asked is not target and not asked.is_dir():
        error = errno.ENOTDIR
    elif not os.access(asked, os.W_OK):
        error = errno.EACCES
    else:
        return
    raise OSError(error, os.strerror(error))


def _refused(target: Path, message: str, limit: str, remedy: str) -> OutputError:
    return OutputError(str(Message("output", message, str(target), limit, remedy)))
