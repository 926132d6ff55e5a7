# SPDX-License-Identifier: Apache-2.0
"""Files of healthy records and of trends: folders and patterns, order, loads from a table or file names."""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from glob import glob
from pathlib import Path

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.core.nearest import hint
from pitchpoint.io.measured.folder import by_number, records_in
from pitchpoint.io.measured.record import MeasuredError

TABLE = "records.csv"
"""Table of the records of a folder."""
COLUMNS = ("file", "load", "speed", "time")
_NUMBER = r"[-+]?\d+(?:\.\d+)?"
_LOAD = re.compile(rf"\s*({_NUMBER}(?:[eE][-+]?\d+)?)\s*(.*?)\s*")


@dataclass(frozen=True)
class RecordFile:
    """A file with its operating point.

    Attributes
    ----------
    path
        Path of the file.
    load
        Load, any unit; None if unknown.
    unit
        Unit of the load; empty if not stated.
    speed
        Speed of the table as text; empty if not stated.
    """

    path: str
    load: float | None = None
    unit: str = ""
    speed: str = ""

    @property
    def name(self) -> str:
        """Name of the file without its folder."""
        return Path(self.path).name


def record_files(given: Sequence[str], pattern: str | None, option: str) -> list[RecordFile]:
    """Records of files, folders and file patterns, each folder in the order of its table or of the names.

    Parameters
    ----------
    given
        Files, folders, or patterns such as "healthy/*.csv".
    pattern
        Pattern of file names with the load, such as "30hz{load}"; it precedes the table.
    option
        Name of the option in messages.

    Raises
    ------
    SignalError
        If there is no such file, a folder has no record, or a table or pattern cannot be used.
    """
    found: dict[str, RecordFile] = {}
    problems = []
    for text in given:
        paths = _expanded(text)
        if not paths:
            what = "has no records" if Path(text).is_dir() else "does not exist and matches no file"
            problems.append(
                f"{option}: {text!r} {what}; name files, a folder, or a pattern such as 'day1/*.csv'"
            )
        try:
            for path in paths:
                found.setdefault(str(Path(path).resolve()), record_file(path, pattern))
        except SignalError as error:
            problems.append(str(error))
    if problems:
        raise SignalError("; ".join(dict.fromkeys(problems)))
    return list(found.values())


def unmatched(files: Sequence[RecordFile], pattern: str | None) -> list[str]:
    """Problem of a pattern of loads that matches the name of none of the files; empty if it matches one."""
    if pattern is None or not files or any(_in_name(file.name, pattern) for file in files):
        return []
    return [
        f"--load-from: {pattern!r} matches none of the {len(files)} file names, such as {files[0].name} "
        "(limit 1); correct the text before and after {load}"
    ]


def record_file(path: str, pattern: str | None, load: str | None = None) -> RecordFile:
    """One file with its load: as given, else from its name, else from the table of its folder.

    Raises
    ------
    SignalError
        If the load is not a number, or the table or the pattern cannot be used.
    """
    row = _table(Path(path).parent).get(Path(path).name, {})
    text, where = row.get("load", ""), f"{Path(path).parent / TABLE}, {Path(path).name}"
    if pattern is not None:
        text, where = _in_name(Path(path).name, pattern) or text, "--load-from"
    if load is not None:
        text, where = load, "--load"
    value, unit = _load(text, where) if text else (None, "")
    return RecordFile(path, value, unit, row.get("speed", ""))


def _expanded(text: str) -> list[str]:
    """Files of a file, a folder or a pattern, in order."""
    folder = Path(text)
    if folder.is_file():
        return [text]
    if not folder.is_dir():
        return sorted((path for path in glob(text) if Path(path).is_file()), key=by_number)
    table = _table(folder)
    if not table:
        with suppress(MeasuredError):
            return records_in(text)[0]
        return []
    missing = [name for name in table if not (folder / name).is_file()]
    if missing:
        raise SignalError(
            f"{folder / TABLE}: {', '.join(missing)} is not in the folder; correct the table, or add the file"
        )
    times = [row.get("time", "") for row in table.values()]
    if not all(times):
        return [str(folder / name) for name in table]
    # ISO times sort as text, numbers by value
    return [str(folder / name) for name in sorted(table, key=lambda name: by_number(table[name]["time"]))]


def _table(folder: Path) -> dict[str, dict[str, str]]:
    """Rows of the table of a folder by file; empty without a table."""
    path = folder / TABLE
    if not path.is_file():
        return {}
    try:
        with path.open(encoding="utf-8-sig", newline="") as stream:
            reader = csv.DictReader(stream, skipinitialspace=True)
            heads = [str(head).strip() for head in reader.fieldnames or ()]
            reader.fieldnames = heads
            rows = [{key: (value or "").strip() for key, value in row.items() if key} for row in reader]
    except (UnicodeDecodeError, csv.Error) as error:
        raise SignalError(
            f"{path}: is not a CSV table ({error}); write columns file, load, speed, time"
        ) from error
    other = [head for head in heads if head not in COLUMNS]
    if "file" not in heads or other:
        problem = (
            f"column {other[0]!r} is unknown, {hint(other[0], COLUMNS)}" if other else "has no column 'file'"
        )
        raise SignalError(f"{path}: {problem} (limit {', '.join(COLUMNS)}); correct the first line")
    return {row["file"]: row for row in rows if row.get("file")}


def _in_name(name: str, pattern: str) -> str:
    """Load in a file name; empty if the name does not match."""
    before, mark, after = pattern.partition("{load}")
    if not mark or "{" in before + after:
        raise SignalError(f"--load-from: {pattern!r} must contain {{load}} once, as in 'test_{{load}}pc'")
    found = re.search(rf"{re.escape(before)}({_NUMBER}){re.escape(after)}", name)
    return found[1] if found else ""


def _load(text: str, where: str) -> tuple[float, str]:
    """Load and its unit."""
    found = _LOAD.fullmatch(text)
    if not found:
        raise SignalError(
            f"{where}: load {text!r} is not a number with a unit; write it as in 40% or 250 N m"
        )
    return float(found[1]), found[2]
