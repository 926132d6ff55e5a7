# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint diagnose FOLDER`: one row per record, or one record with the channels of all files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from pitchpoint.cli.output import emit_json, show, show_notes, table

if TYPE_CHECKING:
    from pitchpoint.report.diagnosis.request import Request

TABLE_ENDINGS = (".csv", ".json")


def files_or_folder(paths: tuple[str, ...], *, join: bool) -> tuple[tuple[str, ...], str | None]:
    """Files of one record, or a folder with one record per file."""
    from pitchpoint.io.measured.folder import records_in

    folders = [path for path in paths if Path(path).is_dir()]
    if folders and len(paths) > 1:
        raise click.UsageError(f"{folders[0]} is a folder; give one folder, or files")
    if not join:
        return (() if folders else paths), (folders[0] if folders else None)
    if not folders:
        raise click.UsageError("--join requires a folder; several files are one record without it")
    return tuple(records_in(folders[0])[0]), None


def diagnose_records(
    request: Request, folder: str, target: Path | None, *, as_json: bool, quiet: bool
) -> int:
    """Diagnose each file of a folder, and write one table; the exit code is not 0 if some fail.

    After Ctrl-C the table has the files so far, unless there are none.
    """
    from pitchpoint.cli.failure import FAILED, OK, exit_code_of
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.io.target import write_file
    from pitchpoint.report.diagnosis.many import HEAD, diagnose_folder

    with ProgressDisplay("diagnosis", "files", quiet=quiet) as progress:
        found = diagnose_folder(request, folder, progress)
    if found.left and not found.rows:
        raise KeyboardInterrupt
    if target is not None:
        ending = target.suffix.lower()
        made = {".csv": found.csv_text, ".json": found.json_text}.get(ending, found.page)
        write_file(target, made())
    if as_json:
        emit_json(found.as_data())
    else:
        table(folder, HEAD, [row.cells() for row in found.rows])
        if not quiet:
            show_notes(found.notes)
            show(f"table written to {target}") if target is not None else None
    if found.left:
        return exit_code_of(KeyboardInterrupt())
    return FAILED if found.failed else OK
