# SPDX-License-Identifier: Apache-2.0
"""Output of `pitchpoint diagnose` about healthy records: comparison of one record, trend of a folder."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from pitchpoint.cli.output import emit_json, plain, show, show_notes, table

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.report.diagnosis.reference import Change
    from pitchpoint.report.diagnosis.request import Request

LISTED = 10


def print_change(change: Change) -> None:
    """Print the comparison of a record with healthy ones."""
    from pitchpoint.report.diagnosis.change_page import HEAD, deviation_rows
    from pitchpoint.report.diagnosis.change_words import change_sentences

    show()
    for text in change_sentences(change):
        show(text)
    show()
    table("Largest deviations from healthy records", HEAD, deviation_rows(change, LISTED))


def show_trend(request: Request, target: Path | None, as_json: bool, quiet: bool) -> int:
    """Compute, write and print the trend of a folder; after Ctrl-C that of the records so far.

    Returns the exit code.
    """
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.report.diagnosis.change_page import TREND_HEAD, trend_csv, trend_page, trend_rows
    from pitchpoint.report.diagnosis.change_words import trend_sentences
    from pitchpoint.report.diagnosis.reference import trend

    found = trend(request)
    if target is not None:
        from pitchpoint.io.target import TABLE_OF_DIAGNOSES, write_file

        ending = target.suffix.lower()
        if ending == ".csv":
            text = trend_csv(found)
        elif ending == ".json":
            text = json.dumps(plain({"about": TABLE_OF_DIAGNOSES} | found.as_data()), indent=2) + "\n"
        else:
            text = trend_page(found, request.file)
        write_file(target, text)
    code = exit_code_of(KeyboardInterrupt()) if found.missing else OK
    if as_json:
        emit_json(found.as_data())
        return code
    for text in trend_sentences(found):
        show(text)
    show()
    table("Records", TREND_HEAD, trend_rows(found))
    if not quiet:
        show_notes(found.notes)
        if target is not None:
            show(f"{'report' if target.suffix.lower().startswith('.htm') else 'table'} written to {target}")
    return code
