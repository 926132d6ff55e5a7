# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint rexs`: comparison of two gear units in REXS files."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import click

from pitchpoint.cli.options import as_json, debug, quiet
from pitchpoint.cli.output import emit_json, show, table

if TYPE_CHECKING:
    from pitchpoint.io.rexs.comparison.differences import Difference

_file = click.Path(exists=True, dir_okay=False)


@click.group("rexs")
def rexs() -> None:
    """Work with REXS files of gear units; `pitchpoint import` makes a model of one."""


@rexs.command("diff")
@click.argument("first", metavar="A", type=_file)
@click.argument("second", metavar="B", type=_file)
@click.option(
    "--tolerance",
    type=click.FloatRange(min=0.0, max=1.0),
    default=1e-6,
    show_default=True,
    metavar="X",
    help="Relative difference up to which numbers are equal.",
)
@as_json
@quiet
@debug
def diff(first: str, second: str, tolerance: float, as_json: bool, quiet: bool) -> None:
    """List the differences between the gear units of two REXS files.

    The files can have different formats (XML, JSON, ZIP) and versions. Parts are paired by their data and
    by their place in the gear unit. Other ids, names and units, or another order, are no differences. Values
    are in the units of A. The exit code is 0 with and without differences.
    """
    from pitchpoint.io.rexs.comparison.differences import differences
    from pitchpoint.io.rexs.reading import read_rexs

    one, two = read_rexs(first), read_rexs(second)
    found = differences(one, two, tolerance)
    if as_json:
        data = {"a": first, "b": second, "tolerance": tolerance, "equal": not found}
        emit_json({**data, "differences": [asdict(each) for each in found]})
        return
    if not quiet:
        for name, model in (("A", one), ("B", two)):
            by = f" by {model.application}" if model.application else ""
            parts = f"{len(model.components)} components"
            show(f"{name}: {Path(model.file).name}: REXS {model.version}{by}, {parts}")
            for remark in model.remarks:
                show(f"{name}, remark: {remark}")
    _show(found)


def _show(found: list[Difference]) -> None:
    """Tables of the differences by kind."""
    if not found:
        show("no differences")
        return
    for kind, title in (("removed", "only in A"), ("added", "only in B")):
        rows = [[each.part or f"load case {each.load_case}"] for each in found if each.kind == kind]
        if rows:
            table(title, ["part"], rows)
    rows = [[each.part, each.what, each.a, each.b] for each in found if each.kind == "moved"]
    if rows:
        table("moved", ["part", "role", "A", "B"], rows)
    cases = dict.fromkeys(each.load_case for each in found if each.kind == "changed")
    for case in cases:
        title = {"": "changed", "total": "changed in the load spectrum"}.get(case, f"load case {case}")
        rows = [
            [each.part, each.what, each.a, each.b, each.difference]
            for each in found
            if each.kind == "changed" and each.load_case == case
        ]
        table(title, ["part", "value", "A", "B", "difference"], rows, keys=2)
    counts = {kind: sum(each.kind == kind for each in found) for kind in dict.fromkeys(d.kind for d in found)}
    show(f"{len(found)} differences: {', '.join(f'{n} {kind}' for kind, n in counts.items())}")
