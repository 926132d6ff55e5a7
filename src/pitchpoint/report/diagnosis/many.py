# SPDX-License-Identifier: Apache-2.0
"""Diagnosis of all records of a folder: one row per file, as table, CSV, JSON and HTML page."""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from html import escape
from pathlib import Path
from time import perf_counter
from typing import Any

from pitchpoint import __version__
from pitchpoint.analysis.findings import Evidence
from pitchpoint.core.errors import PitchpointError
from pitchpoint.io.csv_cells import plain_cell
from pitchpoint.io.measured.folder import records_in
from pitchpoint.io.measured.record import as_options
from pitchpoint.io.target import TABLE_OF_DIAGNOSES
from pitchpoint.report.diagnosis.request import Request, diagnose_file
from pitchpoint.report.diagnosis.study import Study
from pitchpoint.report.diagnosis.tables import rows_html
from pitchpoint.report.diagnosis.words import evidence_of, unit_of, what_is_tested
from pitchpoint.viz.report.page import Section, page
from pitchpoint.viz.tables import plain_table

Progress = Callable[[float, float, str], None]


@dataclass(frozen=True)
class FileRow:
    """Diagnosis of one file.

    Attributes
    ----------
    file
        Name of the file.
    verdict
        Findings in few words, `nothing found`, or `not diagnosed`.
    test, channel
        Strongest test and its channel: that of the first finding, else the one closest to its limit.
    value, limit
        Its value and limit; None if the file is not diagnosed.
    unit
        Unit of both.
    frequency
        Rotation frequency of the reference shaft [Hz]; None if it varies or is unknown.
    tolerance
        Its relative tolerance that remains [-]; None if the file is not diagnosed.
    speeds
        Lowest and highest rotation frequency [Hz], if it varies.
    time
        Time that the diagnosis took [s].
    sentences
        All findings, or the message why the file is not diagnosed.
    failed
        Whether the file is not diagnosed.
    """

    file: str
    verdict: str
    test: str = ""
    channel: str = ""
    value: float | None = None
    limit: float | None = None
    unit: str = ""
    frequency: float | None = None
    tolerance: float | None = None
    time: float = 0.0
    sentences: tuple[str, ...] = ()
    failed: bool = False
    speeds: tuple[float, float] | None = None

    def cells(self) -> tuple[str, ...]:
        """Texts of the table."""
        evidence = "–" if self.value is None else f"{self.value:.1f} {self.unit} (limit {self.limit:.1f})"
        near = f" ±{100.0 * self.tolerance:.2g} %" if self.tolerance else ""
        speed = "–" if self.frequency is None else f"{60.0 * self.frequency:.5g} rpm{near}"
        if self.speeds is not None:
            speed = f"{60.0 * self.speeds[0]:.4g} to {60.0 * self.speeds[1]:.4g} rpm"
        verdict = f"{self.verdict}: {self.sentences[0]}" if self.failed else self.verdict
        test = f"{self.test}, {self.channel}" if self.test else "–"
        return (self.file, verdict, test, evidence, speed, f"{self.time:.1f} s")


HEAD = ("file", "verdict", "strongest test", "value", "speed", "time")
WIDE = (
    "file",
    "verdict",
    "test",
    "channel",
    "value",
    "limit",
    "unit",
    "speed [rpm]",
    "tolerance",
    "time [s]",
    "sentences",
)


@dataclass(frozen=True)
class FolderDiagnosis:
    """Diagnosis of a folder.

    Attributes
    ----------
    folder
        The folder.
    rows
        One per file, by name.
    omitted
        Files that are not records.
    left
        Number of files that were not reached because of an interruption.
    """

    folder: str
    rows: tuple[FileRow, ...]
    omitted: tuple[str, ...] = ()
    left: int = 0

    @property
    def failed(self) -> int:
        """Number of files that are not diagnosed."""
        return sum(row.failed for row in self.rows)

    @property
    def notes(self) -> list[str]:
        """Remarks on the folder."""
        done = len(self.rows)
        stopped = [f"interrupted after {done} of {done + self.left} files; the others are not in the table"]
        listed = ", ".join(self.omitted[:LISTED]) + ", ..." * (len(self.omitted) > LISTED)
        count = (
            "1 file is not a record"
            if len(self.omitted) == 1
            else f"{len(self.omitted)} files are not records"
        )
        omitted = [f"{count}, omitted: {listed}"]
        return stopped * bool(self.left) + omitted * bool(self.omitted)

    def as_data(self) -> dict[str, Any]:
        """Plain data."""
        return {
            "about": TABLE_OF_DIAGNOSES,
            "folder": self.folder,
            "files": [asdict(row) for row in self.rows],
            "failed": self.failed,
            "interrupted": self.left > 0,
            "not_reached": self.left,
            "omitted": list(self.omitted),
        }

    def csv_text(self) -> str:
        """Table as CSV."""
        made = io.StringIO()
        writer = csv.writer(made, lineterminator="\n")
        writer.writerow(WIDE)
        for row in self.rows:
            cells = [row.file, row.verdict, row.test, row.channel, row.value, row.limit, row.unit]
            cells += [
                None if row.frequency is None else 60.0 * row.frequency,
                row.tolerance,
                round(row.time, 2),
                "; ".join(row.sentences),
            ]
            writer.writerow([plain_cell("" if cell is None else cell) for cell in cells])
        return made.getvalue()

    def json_text(self) -> str:
        """Table as JSON."""
        return json.dumps(self.as_data(), indent=2, ensure_ascii=False, allow_nan=False) + "\n"

    def page(self) -> str:
        """HTML page: the table, and the sentences of each file."""
        summary, details = Section("files", "Files"), Section("results", "Results")
        cells = [
            ("**" + row.cells()[0] if row.verdict not in QUIET else row.cells()[0], *row.cells()[1:])
            for row in self.rows
        ]
        summary.add(plain_table(HEAD, rows_html(cells, 3), words=3))
        for row in (row for row in self.rows if not row.failed):
            items = "".join(f"<li>{escape(text)}</li>" for text in row.sentences)
            details.add(f'<h3>{escape(row.file)}</h3><ul class="notes">{items}</ul>')
        notes = Section("notes", "Notes")
        notes.add("".join(f"<p>{escape(text)}</p>" for text in self.notes))
        found = sum(row.verdict not in QUIET for row in self.rows)
        facts = [
            ("folder", Path(self.folder).name),
            ("files", str(len(self.rows))),
            ("with findings", str(found)),
            ("not diagnosed", str(self.failed)),
            *[("not reached", str(self.left))] * bool(self.left),
            ("version", __version__),
        ]
        title = f"Diagnosis of {Path(self.folder).name}"
        return page(title, facts, [summary, details, notes], f"Made by pitchpoint {__version__}.")


LISTED = 6
"""Number of omitted files with their names in a note."""
NOTHING, FAILED = "nothing found", "not diagnosed"
QUIET = (NOTHING, FAILED)


def diagnose_folder(request: Request, folder: str, progress: Progress) -> FolderDiagnosis:
    """Diagnose each file of a folder with the same options; an interruption ends it with the files so far.

    Parameters
    ----------
    request
        Options; its file is replaced.
    folder
        The folder.
    progress
        Called with the number of files done, the number of all, and the name of the next one.

    Raises
    ------
    PitchpointError
        If all files fail with the same message: an option is wrong.
    """
    records, omitted = records_in(folder)
    rows: list[FileRow] = []
    errors: list[BaseException] = []
    try:
        for number, file in enumerate(records):
            progress(number, len(records), Path(file).name)
            began = perf_counter()
            try:
                row = _row(Path(file).name, diagnose_file(replace(request, file=file)))
            except Exception as error:  # noqa: BLE001 - one file must not take the rows of the others with it
                errors.append(error)
                row = FileRow(Path(file).name, FAILED, sentences=(_message(error, file),), failed=True)
            rows.append(replace(row, time=perf_counter() - began))
        progress(len(records), len(records), "")
    except KeyboardInterrupt:
        if len(rows) < len(records):
            return FolderDiagnosis(folder, tuple(rows), tuple(omitted), len(records) - len(rows))
    if len(errors) == len(records) and len({row.sentences for row in rows}) == 1:
        raise errors[0]
    return FolderDiagnosis(folder, tuple(rows), tuple(omitted))


def _row(file: str, study: Study) -> FileRow:
    """Row of a diagnosed file."""
    found = study.diagnosis
    words = [_short(finding.shaft, finding.gears, finding.kind) for finding in found.findings]
    words += [f"severity zone {row.found.zone} in {row.channel}" for row in study.severity if row.is_verdict]
    best = _strongest(study)
    hertz = study.over.frequency
    return FileRow(
        file,
        "; ".join(words) or NOTHING,
        test=_test(best),
        channel=best.channel,
        value=best.value if math.isfinite(best.value) else None,
        limit=best.threshold,
        unit=unit_of(best.kind),
        frequency=hertz if math.isfinite(hertz) else None,
        tolerance=study.over.tolerance,
        speeds=study.over.speeds,
        sentences=tuple(
            text for k, words in enumerate(study.sentences) for text in (words, *study.details(k))
        ),
    )


def _test(e: Evidence) -> str:
    """Name of a test with the part to which it belongs."""
    if e.kind == "bearing":
        return ", by ".join((f"{e.shaft} of {e.gear}", *e.detectors[:1]))
    return what_is_tested(e) if e.kind == "sidebands" else f"{what_is_tested(e)} of {e.shaft}"


def _short(shaft: str, gears: Sequence[str], kind: str) -> str:
    """Damaged part in few words."""
    if kind == "bearing":
        return f"{shaft} of {gears[0]}"
    return f"local fault on {' or '.join(gears) or shaft}"


def _strongest(study: Study) -> Evidence:
    """Test of the first finding, else the one closest to a finding, which is not that of an observation."""
    found = study.diagnosis
    mine = evidence_of(found.findings[0], found) if found.findings else []
    if mine:
        return mine[0]
    rest = [e for e in found.evidence if not e.found] or found.evidence
    return min(
        rest,
        key=lambda e: (bool(e.explained) and e.value > e.threshold, e.probability, e.threshold - e.value),
    )


def _message(error: BaseException, file: str) -> str:
    """Message without the path of the file, which the row has; an error of this program is named as such."""
    text = as_options(str(error).removeprefix(f"{file}: ")) or type(error).__name__
    own = isinstance(error, PitchpointError | OSError | MemoryError)
    return text if own else f"internal error: {type(error).__name__}: {error}; diagnose this file alone"
