# SPDX-License-Identifier: Apache-2.0
"""Checks before a file is written: only a file of the same kind written by pitchpoint may be replaced.

Input files are never replaced. Kind and writer are identified by the contents, not by the extension. Special
files (pipes, terminals) are not checked.
"""

from __future__ import annotations

import contextlib
import errno
import os
import re
import shutil
import threading
import zipfile
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from pitchpoint.core.errors import Message, PitchpointError
from pitchpoint.io.unmarked_file import DAMAGE, UnmarkedFile
from pitchpoint.io.write_lock import is_held, share

HDF5 = b"\x89HDF\r\n\x1a\n"
HEAD = 1024
"""Number of bytes that identify a kind of file."""

_SUPERBLOCK = 48
"""Size of the first write of HDF5: a file of this size has no contents."""


_DISK_FAULTS = {getattr(errno, name, 0) for name in ("ENOSPC", "EDQUOT", "EFBIG", "EIO")} - {0}


class OutputError(PitchpointError, OSError):
    """A file cannot be written, or must not be replaced."""


def _is_result(path: Path, head: bytes) -> bool:
    """Identify a result by its attribute `format`, which is written before all other contents.

    A file that cannot be opened may be a damaged file of another program: it does not count as a result.
    """
    if not head.startswith(HDF5):
        return False
    if len(head) <= _SUPERBLOCK:
        return True  # a run that was killed at its start
    return _format_of(path).startswith("pitchpoint")


def _is_contact_table(path: Path, head: bytes) -> bool:
    return head.startswith(HDF5) and len(head) > _SUPERBLOCK and _format_of(path).startswith(CONTACT_TABLE)


def _format_of(path: Path) -> str:
    """Attribute `format` of an HDF5 file; empty if the file cannot be opened."""
    import h5py

    try:
        with UnmarkedFile(os.fspath(path)) as unmarked:
            if not share(unmarked.fileno()):
                raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
            with h5py.File(unmarked, "r") as file:
                found = file.attrs.get("format", "")
                return found.decode("utf-8", "replace") if isinstance(found, bytes) else str(found)
    except (BlockingIOError, FileNotFoundError):
        raise  # another process has just started to write it, or has removed it
    except DAMAGE:
        return ""


def _is_rexs(_: Path, head: bytes) -> bool:
    """Identify a REXS file by the program that wrote it, in a ZIP archive by the name of the model."""
    marks = (b'applicationId="pitchpoint"', b'"applicationId": "pitchpoint"')
    return any(mark in head for mark in marks) or (head.startswith(b"PK") and b"pitchpoint.rexs" in head)


def _begins(word: bytes) -> Callable[[Path, bytes], bool]:
    return lambda _, head: head.startswith(word)


def _marked(word: bytes, mark: str) -> Callable[[Path, bytes], bool]:
    return lambda _, head: head.startswith(word) and mark.encode() in head


def _is_animation(_: Path, head: bytes) -> bool:
    """Identify an animation of modes by its first words, or by the first array in its archive."""
    return head.startswith(b'{"about": "motion: mode, frame') or head[30:40] == b"bodies.npy"


def _is_diagnoses(_: Path, head: bytes) -> bool:
    """Identify a table of diagnoses or of a trend by its first columns or its first entry."""
    first = f'{{\n  "about": "{TABLE_OF_DIAGNOSES}"'
    return head.startswith((DIAGNOSES_HEAD.encode(), TREND_OF_RECORDS.encode(), first.encode()))


def written_by_diagnose(path: Path) -> bool:
    """Whether a file is a table of diagnoses."""
    try:
        with path.open("rb") as file:
            return _is_diagnoses(path, file.read(HEAD))
    except OSError:
        return False


def _is_pdf(_: Path, head: bytes) -> bool:
    """Identify a PDF file by its title."""
    return head.startswith(b"%PDF") and f"/Title ({PDF_TITLE})".encode() in head


def _is_png(_: Path, head: bytes) -> bool:
    return head.startswith(b"\x89PNG") and PNG_MARK in head


PDF_TITLE = "pitchpoint"
"""Title of PDF files."""
PAGE_MARK = '<meta name="generator" content="pitchpoint">'
SVG_MARK = "<!-- generator: pitchpoint -->"
DXF_MARK = "999\npitchpoint\n"
STEP_MARK = "pitchpoint"
TURBSIM_MARK = b"This full-field file was written by pitchpoint."
PNG_MARK = b"Software\x00pitchpoint"
ANALYSIS_MARK = "# pitchpoint analysis\n"
SCHEMA_TITLE = '"title": "pitchpoint model file"'
MODEL_MARK = "# model written by pitchpoint\n"
HOUSING_MARK = "# housing matrix written by pitchpoint\n"
"""Marks of the writer in pages, drawings and tables; in DXF the group 999 is a comment."""

TABLE_OF_DIAGNOSES = "diagnoses by pitchpoint"
"""Entry `about` of a table of diagnoses in JSON."""
DIAGNOSES_HEAD = "file,verdict,test,channel,value,limit"
TREND_OF_RECORDS = "file,state,distance,limit"
"""First columns of a table of diagnoses, and of one of a trend, in CSV."""

CONTACT_TABLE = "gear-contact-potential-"
"""Beginning of the attribute `format` of a contact table; the version of the format follows."""


STIFFNESS_HEAD = "stiffness of mesh"
"""First cell of a table of stiffness."""
INDEX_HEAD = "case,file,status,status_code,sentence"
"""First columns of the table of the cases of a data set."""


def _is_fmu(path: Path, head: bytes) -> bool:
    """Whether a file is an archive whose model description names this program."""
    if not head.startswith(b"PK"):
        return False
    try:
        with zipfile.ZipFile(path) as archive, archive.open("modelDescription.xml") as file:
            return b'generationTool="pitchpoint"' in file.read(HEAD)
    except (OSError, KeyError, zipfile.BadZipFile, RuntimeError):
        return False


KINDS: dict[str, tuple[str, Callable[[Path, bytes], bool]]] = {
    "result": ("a readable result file of pitchpoint", _is_result),
    "contact": ("a readable contact table of pitchpoint (HDF5)", _is_contact_table),
    "page": ("an HTML page of pitchpoint", _marked(b"<!DOCTYPE html>", PAGE_MARK)),
    "csv": ("points of a gear of pitchpoint (CSV)", _begins(b"x [mm],y [mm],tooth,region")),
    "analysis": ("a table of an analysis of pitchpoint (CSV)", _begins(ANALYSIS_MARK.encode())),
    "model": ("a model written by a command of pitchpoint (YAML)", _begins(MODEL_MARK.encode())),
    "housing": ("a housing matrix of pitchpoint (CSV)", _begins(HOUSING_MARK.encode())),
    "rexs": ("a REXS file of pitchpoint", _is_rexs),
    "stiffness": ("a table of stiffness of pitchpoint (CSV)", _begins(STIFFNESS_HEAD.encode())),
    "dxf": ("a drawing of pitchpoint (DXF)", _begins(DXF_MARK.encode())),
    "svg": ("a drawing of pitchpoint (SVG)", _marked(b"<svg", SVG_MARK)),
    "png": ("a picture of pitchpoint (PNG)", _is_png),
    "pdf": ("a drawing of pitchpoint (PDF)", _is_pdf),
    "index": ("a table of cases of pitchpoint (CSV)", _begins(INDEX_HEAD.encode())),
    "animation": ("an animation of modes of pitchpoint (JSON, NPZ)", _is_animation),
    "diagnoses": ("a table of diagnoses of pitchpoint (CSV, JSON)", _is_diagnoses),
    "schema": ("a schema of pitchpoint (JSON)", _marked(b"{", SCHEMA_TITLE)),
    "stl": ("a solid of pitchpoint (STL)", _begins(b"pitchpoint ")),
    "step": ("a solid of pitchpoint (STEP)", _marked(b"ISO-10303-21;", f"'{STEP_MARK}'")),
    "fmu": ("an FMU of pitchpoint", _is_fmu),
    "turbsim": ("a wind file of pitchpoint (TurbSim)", lambda _, head: head[70:].startswith(TURBSIM_MARK)),
}
"""Description and identification function of each kind of file, by name."""


def check_target(
    path: str | os.PathLike[str], kind: str, inputs: Iterable[str | os.PathLike[str]] = ()
) -> Path:
    """Path of a file that may be written: a new or empty file, or an older one of the same kind.

    Parameters
    ----------
    path
        File to write.
    kind
        Name in `KINDS`.
    inputs
        Input files of the same command; links and relative names are resolved.

    Raises
    ------
    OutputError
        If writing is not possible, or would overwrite an input, a file of another kind or origin, or a result
        that another process writes.
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
        return target  # another process has just removed it
    except (OSError, ValueError) as error:
        raise OutputError(cannot_be_written(target, error)) from error
    return target


def check_place(path: str | os.PathLike[str]) -> None:
    """Check before a long computation that its file can be written; missing folders are created later.

    Raises
    ------
    OutputError
        If the path is a folder, is below a file, or is not writable.
    """
    target = Path(path)
    try:
        _accessible(target)
    except (OSError, ValueError) as error:
        raise OutputError(cannot_be_written(target, error)) from error


def write_file(path: str | os.PathLike[str], data: str | bytes) -> Path:
    """Write a complete file, texts as UTF-8, invalid characters as question marks; its folder is created.

    An older file remains until the new one is on the disk. Pipes require a process that reads them.

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
    """Context manager for a temporary file that replaces the target if the block ends without an error.

    Parameters
    ----------
    target
        Target file; links are followed, and the permissions of an older file are retained.
    draft
        Temporary file; default: one in the same folder with the extension of the target.
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
    """Sync a temporary file: a full disk is reported before the older file is replaced."""
    with draft.open("wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())


def _write_stream(target: Path, data: bytes) -> None:
    """Write to a pipe or device; opening a pipe without a reader would block."""
    descriptor = os.open(target, os.O_WRONLY | getattr(os, "O_NONBLOCK", 0))
    os.set_blocking(descriptor, True)
    with open(descriptor, "wb") as file:
        file.write(data)


def make_folder(target: Path) -> None:
    """Create the missing folders of a file; used by all writers.

    Raises
    ------
    OSError
        If that is not possible.
    """
    target.parent.mkdir(parents=True, exist_ok=True)


def cannot_be_written(target: Path, error: OSError | ValueError) -> str:
    """Message for a file that cannot be written: reason, and remedy if another process uses it."""
    remedy = ""
    if isinstance(error, BlockingIOError | FileExistsError):
        remedy = "; wait until it is closed, or name another file"
    elif isinstance(error, OSError) and error.errno == errno.ENXIO:
        remedy = "; start the process that reads this pipe first"
    return f"{target}: cannot be written ({reason_of(error)}){remedy}"


def reason_of(error: OSError | ValueError) -> str:
    """Reason why the operating system, or HDF5, rejected a file."""
    if isinstance(error, BlockingIOError | FileExistsError):
        return "another process holds it"
    number = disk_errno(error)
    if number:
        return os.strerror(number)  # HDF5 embeds the same text in its messages
    return str(error).split("(")[-1].rstrip(")") or type(error).__name__


def disk_errno(error: BaseException) -> int:
    """Error number of the operating system, which HDF5 may give in its text only; 0 without one."""
    if isinstance(error, OSError) and error.errno:
        return error.errno
    found = re.search(r"errno = (\d+)", str(error))
    return int(found[1]) if found else 0


def is_disk_fault(error: BaseException | None) -> bool:
    """Whether an error, or its cause, is a full or defective disk, a quota or a size limit."""
    while error is not None:
        if disk_errno(error) in _DISK_FAULTS:
            return True
        error = error.__cause__
    return False


def _accessible(target: Path) -> None:
    """Check that a file may be written at a path."""
    asked = target if target.exists() else next(p for p in target.absolute().parents if p.exists())
    if target.is_dir():
        error = errno.EISDIR
    elif asked is not target and not asked.is_dir():
        error = errno.ENOTDIR
    elif not os.access(asked, os.W_OK) and asked.exists():  # another process may just have removed it
        error = errno.EACCES
    else:
        return
    raise OSError(error, os.strerror(error))


def _refused(target: Path, message: str, limit: str, remedy: str) -> OutputError:
    return OutputError(str(Message("output", message, str(target), limit, remedy)))
