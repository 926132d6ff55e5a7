# SPDX-License-Identifier: Apache-2.0
"""Records of a folder, in the order of their names."""

from __future__ import annotations

import re
from pathlib import Path

from pitchpoint.io.measured.record import MeasuredError
from pitchpoint.io.target import written_by_diagnose

DOCUMENTS = frozenset(
    ".md .rst .html .htm .pdf .png .jpg .jpeg .gif .svg .doc .docx .xls .xlsx .ppt .pptx .json .yaml .yml "
    ".toml .xml .py .m .sh .bat .ipynb .log .zip .tar .7z .part".split()
)
"""Endings of files that are not records."""
NAMED = ("readme", "license", "licence", "records")
"""Names without ending of files about the records."""


def records_in(folder: str) -> tuple[list[str], list[str]]:
    """Files of a folder that may be records, by name with numbers by value, and names of the others.

    Raises
    ------
    MeasuredError
        If the folder has none.
    """
    files = sorted((one for one in Path(folder).iterdir() if one.is_file()), key=_by_number)
    shown = [one for one in files if not one.name.startswith(".")]
    omitted = [one for one in shown if not _may_be_record(one)]
    records = [str(one) for one in shown if one not in omitted]
    if not records:
        raise MeasuredError(f"{folder}: has no measured file or result; name another folder")
    return records, [one.name for one in omitted]


def _may_be_record(file: Path) -> bool:
    """Whether a file may be a record: no document, and no table of this command."""
    documents = file.suffix.lower() in DOCUMENTS or file.stem.lower() in NAMED
    return not documents and not written_by_diagnose(file)


def _by_number(file: Path) -> list[tuple[int, str]]:
    """Key that sorts numbers within names by value."""
    return [
        (int(text), "") if text.isdigit() else (-1, text.lower())
        for text in re.split(r"(\d+)", file.name)
        if text
    ]
