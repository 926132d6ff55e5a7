# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint rexs`: REXS files of gear units: comparison, and writing of a model."""

from __future__ import annotations

from collections import Counter
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import click

from pitchpoint.cli.options import as_json, common, debug, model_file, quiet, writes
from pitchpoint.cli.output import emit_json, show, show_notes, table

if TYPE_CHECKING:
    from pitchpoint.io.rexs.comparison.differences import Difference
    from pitchpoint.io.rexs.document import RexsModel

WRITTEN = ("1.4", "1.5", "1.6", "1.7", "2.0.0")
"""Versions of REXS that have all components of a model."""
_file = click.Path(exists=True, dir_okay=False)


@click.group("rexs")
def rexs() -> None:
    """Compare REXS files of gear units, and write a model as one; `pitchpoint import` reads one."""


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
    """List the differences between two gear units, in REXS files or model files (.yaml).

    The files can have different formats (XML, JSON, ZIP) and versions. Parts are paired by their data and
    by their place in the gear unit. Other ids, names and units, or another order, do not count. Values
    are in the units of A. The exit code is 0 with and without differences.
    """
    from pitchpoint.io.rexs.comparison.differences import differences

    one, two = _read(first), _read(second)
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


@rexs.command("write")
@model_file
@writes("-o", "--output", required=True, help="File: .rexs (XML), .rexsj (JSON) or .rexsz (ZIP).")
@click.option(
    "--result",
    "results",
    multiple=True,
    type=_file,
    metavar="FILE.h5",
    help="Result of a run: its scenario becomes a load case with forces and speeds; repeatable.",
)
@click.option(
    "--rexs-version",
    type=click.Choice(WRITTEN),
    default=WRITTEN[-1],
    show_default=True,
    help="Version of REXS.",
)
@common
def write(
    file: str,
    output: str,
    results: tuple[str, ...],
    rexs_version: str,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> None:
    """Write the gear unit of a model as a REXS file, with the stiffness of its meshes.

    The list shows what is not in the file, or not as in the model. Scenarios with speeds become load cases.
    """
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.rexs_values import housing_of, results_of, stiffness_of
    from pitchpoint.io.rexs.exporting.exporting import export_rexs
    from pitchpoint.io.rexs.writing.text import FORMATS, omitted, rexs_bytes
    from pitchpoint.io.target import check_target, write_file

    format = FORMATS.get(Path(output).suffix.lower())
    if format is None:
        endings = ", ".join(FORMATS)
        raise click.BadParameter(
            f"{Path(output).name} has none of the endings {endings}", param_hint="--output"
        )
    target = check_target(output, "rexs", [file, *results])
    model = read_model(file, allow_code, quiet)
    found = export_rexs(
        model,
        rexs_version,
        stiffness=stiffness_of(model),
        housing=housing_of(model),
        results=lambda draft: results_of(draft, results),
    )
    write_file(target, rexs_bytes(found.rexs, format))
    missing = omitted(found.rexs)
    if as_json:
        omissions = [asdict(one) for one in found.omissions]
        emit_json(
            {"output": output, "version": rexs_version, "omissions": omissions, "not_in_version": missing}
        )
        return
    if not quiet:
        rows = [[one.where, one.reason] for one in found.omissions]
        if rows:
            table("not in the file, or not as in the model", ["in the model", "reason"], rows)
        show_notes(missing)
    parts, cases = len(found.rexs.components), sum(len(s.cases) for s in found.rexs.load_spectra)
    many = "" if cases == 1 else "s"
    show(f"written to {target}: REXS {rexs_version}, {parts} components, {cases} load case{many}")


def _read(file: str) -> RexsModel:
    """Gear unit of a REXS file, or of a model file."""
    if Path(file).suffix.lower() in (".yaml", ".yml"):
        from pitchpoint.cli.rexs_values import housing_of, stiffness_of
        from pitchpoint.io.rexs.exporting.exporting import export_rexs
        from pitchpoint.io.yaml_model import load_model

        model = load_model(file)
        return export_rexs(model, stiffness=stiffness_of(model), housing=housing_of(model)).rexs
    from pitchpoint.io.rexs.reading import read_rexs

    return read_rexs(file)


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
    counts = Counter(each.kind for each in found)
    listed = ", ".join(f"{n} {kind}" for kind, n in counts.items())
    show(f"{len(found)} difference{'' if len(found) == 1 else 's'}: {listed}")
