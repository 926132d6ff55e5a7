# SPDX-License-Identifier: Apache-2.0
"""Records of a folder, in the order of their names."""

from __future__ import annotations

import itertools
import re
from pathlib import Path

from pitchpoint.io.measured.packed import is_packed, suffix_of
from pitchpoint.io.measured.reading import EXPECTED, form_of
from pitchpoint.io.measured.record import MeasuredError
from pitchpoint.io.target import written_by_diagnose

DOCUMENTS = frozenset(
    ".md .rst .html .htm .pdf .png .jpg .jpeg .gif .svg .doc .docx .xls .xlsx .ppt .pptx .json .yaml .yml "
    ".toml .xml .py .m .sh .bat .ipynb .log .zip .tar .7z .part".split()
)
"""Endings of files that are not records."""
NAMED = ("readme", "license", "licence", "records")
"""Names without ending of files about the records."""
HEAD, ROWS = 65536, 2
"""Bytes of a file of another ending in which rows of numbers are searched, and their smallest number."""


def records_in(folder: str) -> tuple[list[str], list[str]]:
    """Files of a folder that may be records, by name with numbers by value, and names of the others.

    Raises
    ------
    MeasuredError
        If the folder has none.
    """
    files = sorted(
        (one for one in Path(folder).iterdir() if one.is_file()), key=lambda one: by_number(one.name)
    )
    shown = [one for one in files if not one.name.startswith(".")]
    omitted = [one for one in shown if not _may_be_record(one)]
    records = [str(one) for one in shown if one not in omitted]
    if not records:
        raise MeasuredError(f"{folder}: has no measured file or result; name another folder")
    return records, [one.name for one in omitted]


def _may_be_record(file: Path) -> bool:
    """Whether a file may be a record: no document, no table of this command, and no text without numbers.

    A file with the ending of a format is one, even if it is damaged.
    """
    if file.suffix.lower() in DOCUMENTS or file.stem.lower() in NAMED or written_by_diagnose(file):
        return False
    return suffix_of(file) in EXPECTED or _has_numbers(file)


def _has_numbers(file: Path) -> bool:
    """Whether a file of another ending is of a binary format, or has rows of numbers."""
    try:
        with file.open("rb") as stream:
            data = stream.read(HEAD)
    except OSError:
        return True
    if is_packed(data) or form_of(file, data) != "text":
        return True
    lines = data.decode("utf-16" if data[:2] in (b"\xff\xfe", b"\xfe\xff") else "latin-1", "replace")
    rows = (line for line in lines.splitlines() if _is_row(line))
    return len(list(itertools.islice(rows, ROWS))) == ROWS


def _is_row(line: str) -> bool:
    """Whether most cells of a line are numbers, with decimal points or commas.

    Examples
    --------
    >>> _is_row("0,001;2,5;-3e-4"), _is_row("12:00:01 0.5 0.7"), _is_row("bearing changed on 3 May")
    (True, True, False)
    """
    cells = re.split(r"[\s,;]+", line.strip(" \t\r,;"))
    return 2 * sum(map(_is_number, cells)) > len(cells)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def by_number(name: str) -> list[tuple[int, str]]:
    """Key that sorts numbers within names by value.

    Examples
    --------
    >>> sorted(["r10.csv", "r2.csv", "R1.csv"], key=by_number)
    ['R1.csv', 'r2.csv', 'r10.csv']
    """
    return [
        (int(text), "") if text.isdigit() else (-1, text.lower()) for text in re.split(r"(\d+)", name) if text
    ]
