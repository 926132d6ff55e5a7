# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint report`: report on a model and its results in one HTML file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from pitchpoint.cli.options import allow_code, debug, output, quiet
from pitchpoint.cli.output import show, show_notes
from pitchpoint.cli.settings import load_case_of_command, set_option, settings_of_command

RESULT_ENDINGS = (".h5", ".nc", ".hdf5")


@click.command()
@click.argument("files", nargs=-1, required=True, type=click.Path(exists=True, dir_okay=False))
@output("HTML file; default: name of the model file with .html.")
@click.option("--compare", is_flag=True, help="Overlay runs of different scenarios in one picture, too.")
@set_option
@allow_code
@quiet
@debug
def report(files: tuple[str, ...], output: str | None, compare: bool, allow_code: bool, quiet: bool) -> None:
    """Write one self-contained HTML page from a model file and any number of result files (.h5).

    FILES: without a model file, the model of the first result file is used. Runs and sweeps of one scenario
    with different values (--set) are overlaid; the legend contains these values.
    """
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.results import refuse_without_effect
    from pitchpoint.report.stored_model import stored_model
    from pitchpoint.report.write import write_report

    results = [name for name in files if name.lower().endswith(RESULT_ENDINGS)]
    models = [name for name in files if name not in results]
    if len(models) > 1:
        raise click.UsageError(f"more than one model file: {', '.join(models)}")
    if not models:
        given = {"--set": settings_of_command(), "--load-case": load_case_of_command()}
        refuse_without_effect("without a model file", {name: value or None for name, value in given.items()})
    model = read_model(models[0], allow_code, quiet) if models else stored_model(results[0], allow_code)
    target = Path(output) if output else Path(models[0] if models else results[0]).with_suffix(".html")
    with ProgressDisplay("report", "parts", quiet=quiet) as progress:
        notes: list[str] = []
        options: dict[str, Any] = {
            "allow_code": allow_code,
            "compare": compare,
            "progress": progress,
            "on_note": notes.append,
        }
        write_report(model, target, *results, **options)
    if not quiet:
        show(f"report written to {target}")
        show_notes(notes)
