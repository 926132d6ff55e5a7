# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint import`: a model from a REXS file."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import click

from pitchpoint.cli.options import as_json, debug, model_file, output, quiet
from pitchpoint.cli.output import NOTHING, emit_json, show, table

if TYPE_CHECKING:
    from collections.abc import Iterable

    from pitchpoint.io.rexs.importing import Imported, Item


@click.command("import")
@model_file
@output("Model file; default: only list what would be taken.")
@click.option(
    "--load-case",
    type=int,
    metavar="N",
    help="Load case of the file for loads and speeds; default: the first one.",
)
@as_json
@quiet
@debug
def import_(file: str, output: str | None, load_case: int | None, as_json: bool, quiet: bool) -> None:
    """Import the gear unit of a REXS file (XML, JSON, ZIP; versions 1.0 to 2.0.0) as a model.

    The list shows what was imported, the defaults for missing values, what was changed, and what has no
    effect in a model. A file with a part that a model cannot represent is refused.
    """
    from pitchpoint.io.rexs.importing import import_rexs
    from pitchpoint.io.target import MODEL_MARK, check_target, write_file

    target = None if output is None else check_target(output, "model", [file])
    found = import_rexs(file, load_case)
    if target is not None:
        write_file(target, MODEL_MARK + found.text())
    if as_json:
        emit_json(_data(found, output))
        return
    if not quiet:
        _show(found)
    if target is not None:
        show(f"written to {target}")
        show(f"  pitchpoint check {target}")
        for name in found.model.scenarios:
            show(f"  pitchpoint run {target} -s {name}")


def _data(found: Imported, output: str | None) -> dict[str, object]:
    """Contents of the import as JSON."""
    source = found.source
    return {
        "file": source.file,
        "version": source.version,
        "application": source.application,
        "date": source.date,
        "load_case": found.load_case,
        "output": output,
        "remarks": [remark.parts for remark in source.remarks],
        "items": [asdict(item) for item in found.items],
    }


def _show(found: Imported) -> None:
    """Tables of the entries by kind, and remarks on the file."""
    source = found.source
    case = "" if found.load_case is None else f", load case {found.load_case}"
    by = f" by {source.application}" if source.application else ""
    show(f"{Path(source.file).name}: REXS {source.version}{by}, {len(source.components)} components{case}")
    for remark in source.remarks:
        show(f"remark: {remark}")
    for item in found.of("changed"):
        if "placeholder" in item.reason:
            show(f"warning: {item.target}: {item.reason}; {item.value}")
    table("taken", ["component", "values"], _by_component(found.of("taken")))
    for kind, title in (
        ("default", "missing, with the default"),
        ("changed", "changed"),
    ):
        rows = [[cell or NOTHING for cell in row] for row in found.joined(kind)]
        if rows:
            table(title, ["in the model", "value", "attribute in the file", "reason"], rows)
    ignored: dict[tuple[str, str], list[str]] = {}
    for item in found.of("ignored"):
        ignored.setdefault((item.component, item.reason), []).append(item.attribute)
    rows = [[component, ", ".join(names), reason] for (component, reason), names in ignored.items()]
    if rows:
        table("ignored", ["component", "attributes", "reason"], rows)


def _by_component(items: Iterable[Item]) -> list[list[str]]:
    """Components with the values that were taken from them."""
    rows: dict[str, list[str]] = {}
    for item in items:
        rows.setdefault(item.component, []).append(f"{item.attribute} {item.value}")
    return [[component, ", ".join(values)] for component, values in rows.items()]
