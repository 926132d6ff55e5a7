# SPDX-License-Identifier: Apache-2.0
"""Bytes of a REXS model: a text file, or a ZIP archive with one model and attached files."""

from __future__ import annotations

import io
import zipfile
import zlib
from pathlib import Path

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.io.rexs.raw import MOST_BYTES, RawModel

ENDINGS = (".rexs", ".rexs.xml", ".rexsj", ".rexs.json", ".xml", ".json")
"""Endings of a model in a ZIP archive."""
MOST_FILES = 10_000
"""Largest number of files of a ZIP archive."""


def read_raw(path: Path) -> RawModel:
    """Contents of a file: XML, JSON, or ZIP with either; the contents decide, not the name.

    Parameters
    ----------
    path
        The file.

    Raises
    ------
    ModelError
        With all problems of the file, without its name.
    """
    data = _limited(path)
    if data[:4] in (b"PK\x03\x04", b"PK\x05\x06"):
        data = _from_zip(data)
    begin = data.removeprefix(b"\xef\xbb\xbf").lstrip()[:1]
    if not begin:
        raise ModelError([Message("", "is empty", remedy="export the model again")])
    if begin == b"{":
        from pitchpoint.io.rexs.json_text import read_json

        return read_json(data)
    if begin != b"<" and data[:2] not in (b"\xff\xfe", b"\xfe\xff"):  # marks of UTF-16
        problem = Message("", "is not a REXS file: neither XML nor JSON nor ZIP", remedy="export it as REXS")
        raise ModelError([problem])
    from pitchpoint.io.rexs.xml_text import read_xml

    return read_xml(data)


def _limited(path: Path) -> bytes:
    with path.open("rb") as file:
        data = file.read(MOST_BYTES + 1)
    _check_size("", len(data))
    return data


def _check_size(where: str, size: int) -> None:
    if size > MOST_BYTES:
        value, limit = (f"{n / 2**20:.4g} MiB" for n in (size, MOST_BYTES))
        raise ModelError([Message(where, "is too large for a REXS file", value, limit, "export fewer data")])


def _from_zip(data: bytes) -> bytes:
    """The only model of an archive."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            names = archive.namelist()
            models = [name for name in names if name.lower().endswith(ENDINGS)]
            if len(names) > MOST_FILES or len(models) != 1:
                raise ModelError([_not_one(names, models)])
            entry = archive.getinfo(models[0])
            if entry.flag_bits & 1:
                raise ModelError(
                    [Message(models[0], "is encrypted", remedy="write the archive without a password")]
                )
            _check_size(models[0], entry.file_size)
            with archive.open(entry) as file:
                found = file.read(MOST_BYTES + 1)  # the size in the archive may be wrong
            _check_size(models[0], len(found))
            return found
    except (zipfile.BadZipFile, zlib.error, EOFError, RuntimeError, OSError, ValueError) as error:
        if isinstance(error, ModelError):
            raise
        problem = Message("", f"is a damaged ZIP archive: {error}", remedy="copy or export it again")
        raise ModelError([problem]) from None


def _not_one(names: list[str], models: list[str]) -> Message:
    if len(names) > MOST_FILES:
        return Message("", "is a ZIP archive with too many files", str(len(names)), f"<= {MOST_FILES}")
    what = "is a ZIP archive without a REXS model" if not models else "is a ZIP archive with several models"
    listed = ", ".join((models or names)[:5]) or "nothing"
    remedy = f"it contains {listed}; put one file into it that ends in {', '.join(ENDINGS[:4])}"
    return Message("", what, remedy=remedy)
