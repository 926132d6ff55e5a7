# SPDX-License-Identifier: Apache-2.0
"""Before a file is written: what stands there may be replaced only by its own kind, and never an input.

The kind is read from the contents, not from the ending. Nothing is asked of what is no ordinary file (a pipe,
a terminal).
"""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Iterable
from pathlib import Path

from pitchpoint.core.errors import PitchpointError, Problem

HDF5 = b"\x89HDF\r\n\x1a\n"
HEAD = 1024
"""Bytes from which a kind of file is known."""


class OutputError(PitchpointError, OSError):
    """A file cannot be written, or must not be."""


def _is_result(path: Path, head: bytes) -> bool:
    if not head.startswith(HDF5):
        return False
    import h5py

    try:
        with h5py.File(path, "r") as file:
            return str(file.attrs.get("format", "")).startswith("pitchpoint")
    except OSError:
        # a run that was cut off as it made its file, or one that still writes: the writer says what is wrong
        return True


def _begins(*words: bytes) -> Callable[[Path, bytes], bool]:
    return lambda _, head: head.removeprefix(b"\xef\xbb\xbf").lstrip().lower().startswith(words)


KINDS: dict[str, tuple[str, Callable[[Path, bytes], bool]]] = {
    "result": ("a result file of pitchpoint", _is_result),
    "page": ("an HTML page", _begins(b"<!doctype html", b"<html")),
    "csv": ("points of a gear", _begins(b"x [mm],y [mm],tooth,region")),
    "dxf": ("a drawing (DXF)", _begins(b"0\nsection", b"0\r\nsection")),
    "svg": ("a drawing (SVG)", _begins(b"<svg")),
    "stl": ("a solid of pitchpoint (STL)", _begins(b"pitchpoint gear")),
}
"""Words for a kind of file and how it is recognised, by name."""


def check_target(
    path: str | os.PathLike[str], kind: str, inputs: Iterable[str | os.PathLike[str]] = ()
) -> Path:
    """Give the path of a file that may be written: a new or empty one, or one of the same kind.

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
        If writing is not possible there, or would destroy an input or a file of another kind.
    """
    target = Path(path)
    words, recognised = KINDS[kind]
    try:
        _accessible(target)
        if not target.is_file():
            return target
        if any(Path(name).exists() and target.samefile(name) for name in inputs):
            raise _refused(target, "is read by the same command", "a file of its own", "name another file")
        with target.open("rb") as file:
            head = file.read(HEAD)
        if head and not recognised(target, head):
            remedy = "name another file, or delete this one first"
            raise _refused(target, f"exists and is not {words}", f"a new file, or {words}", remedy)
    except OutputError:
        raise
    except (OSError, ValueError) as error:
        raise OutputError(f"{target}: cannot be written ({reason_of(error)})") from error
    return target


def write_file(path: str | os.PathLike[str], data: str | bytes) -> Path:
    """Write a whole file, texts as UTF-8; its folder is made if it does not exist.

    Raises
    ------
    OutputError
        With the path and the reason, if that is not possible.
    """
    target = Path(path)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(data.encode("utf-8") if isinstance(data, str) else data)
    except (OSError, ValueError) as error:
        raise OutputError(f"{target}: cannot be written ({reason_of(error)})") from error
    return target


def reason_of(error: OSError | ValueError) -> str:
    """Say in a few words what the system, or HDF5, did not like about a file."""
    if isinstance(error, BlockingIOError):
        return "another process holds it"
    if isinstance(error, OSError) and error.errno:
        return os.strerror(error.errno)  # HDF5 wraps the same words in many of its own
    return str(error).split("(")[-1].rstrip(")") or type(error).__name__


def _accessible(target: Path) -> None:
    """Say before a long computation that its file has no place; folders that are missing are made later."""
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
    return OutputError(str(Problem("output", message, str(target), limit, remedy)))
