# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint report`: one HTML file about a model and the results computed with it."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import allow_code, debug, output, quiet
from pitchpoint.cli.output import show

if TYPE_CHECKING:
    from pitchpoint.core.progress import Progress
    from pitchpoint.model.model import Model
    from pitchpoint.viz.report import ReportModel, ReportResults

RESULT_ENDINGS = (".h5", ".nc", ".hdf5")
SOURCES = (
    "Geometry: ISO 21771:2007.",
    "Mesh stiffness: DIN 3990-1:1987 and ISO 6336-1:2006, method B.",
    "Stiffness over the mesh cycle: L. Mauer, SIMPACK User Meeting 2006.",
)


@click.command()
@click.argument("files", nargs=-1, required=True, type=click.Path(exists=True, dir_okay=False))
@output("HTML file to write; the name of the model file with .html if left out.")
@allow_code
@quiet
@debug
def report(files: tuple[str, ...], output: str | None, allow_code: bool, quiet: bool) -> None:
    """Write one self-contained HTML page from a model file and any number of result files (.h5).

    FILES: the model file may be left out; it is then taken from the first result file.
    """
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.viz.report import write_report

    results = [name for name in files if name.lower().endswith(RESULT_ENDINGS)]
    models = [name for name in files if name not in results]
    if len(models) > 1:
        raise click.UsageError(f"more than one model file: {', '.join(models)}")
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        model = _model(models[0] if models else None, results, allow_code)
        about = describe(model)
        with ProgressDisplay("report", "meshes", quiet=quiet) as progress:
            found, remarks = collect(model, results, progress)
    about = _with_warnings(about, heard, remarks)
    target = Path(output) if output else Path(models[0] if models else results[0]).with_suffix(".html")
    write_report(target, model=about, results=found)
    if not quiet:
        show(f"report written to {target}")


def _model(file: str | None, results: Sequence[str], allow_code: bool) -> Model:
    """Load the model file, or the text of it that the first result file keeps."""
    from pitchpoint.core.errors import ModelError, Problem
    from pitchpoint.io.reading import read_header
    from pitchpoint.io.yaml_model import load_model, loads_model

    if file is not None:
        return load_model(file, allow_code=allow_code)
    text = read_header(results[0])["model_text"]
    if not text:
        problem = Problem("model", "is not kept in this result file", remedy="name the model file as well")
        raise ModelError([problem], results[0])
    return loads_model(text, allow_code=allow_code, file=results[0])


def describe(model: Model) -> ReportModel:
    """Collect what a report says about a model."""
    from pitchpoint.cli.check import defaults
    from pitchpoint.cli.numbers import geometry_of_model
    from pitchpoint.core.provenance import content_hash, package_version
    from pitchpoint.viz.report import ReportModel

    numbers = geometry_of_model(model)
    return ReportModel(
        title=model.title or "Gears",
        model_hash=content_hash(model),
        version=package_version(),
        gears=numbers["gears"],
        meshes=numbers["meshes"],
        pairs={name: (pair, *model.meshes[name].gears) for name, pair in model.pairs.items()},
        assumptions=[f"{key}: {value}" for key, value in defaults(model)],
        sources=SOURCES,
    )


def _with_warnings(
    about: ReportModel, heard: Sequence[warnings.WarningMessage], remarks: Sequence[str]
) -> ReportModel:
    """Add the validity warnings that came up and other remarks, each once."""
    from dataclasses import replace

    from pitchpoint.core.errors import ValidityWarning

    texts = dict.fromkeys(str(w.message) for w in heard if issubclass(w.category, ValidityWarning))
    return replace(about, warnings=[*texts, *dict.fromkeys(remarks)])


def collect(model: Model, files: Sequence[str], progress: Progress) -> tuple[ReportResults, list[str]]:
    """Collect what a report shows: what follows from the model, the contents of result files, and remarks."""
    from pitchpoint.cli.numbers import C_PRIME_B, cycles_of_model
    from pitchpoint.cli.statics import linear_parts, with_rolls
    from pitchpoint.core.provenance import content_hash
    from pitchpoint.io.reading import read_header
    from pitchpoint.viz.report import MeshCycleData, ReportResults

    cycles = {
        name: (
            MeshCycleData(stiffness=cycle, stiffness_unit="c′·b" if relative_to == C_PRIME_B else "mean"),
            unit,
        )
        for name, (cycle, relative_to, unit) in cycles_of_model(model, 401).items()
    }
    filled, notes = with_rolls(model, cycles, progress)
    modes, campbell, more = linear_parts(model)
    found = ReportResults(mesh_cycles=filled, modes=modes, campbell=campbell, runs={}, sweeps={}, cases={})
    for file in files:
        header = read_header(file)
        if str(header.get("model_hash", "")) not in ("", content_hash(model)):
            more.append(f"{Path(file).name} was computed with another state of the model.")
        _add_file(found, file, header)
    return found, [*notes, *more]


def _add_file(found: ReportResults, file: str, header: dict[str, Any]) -> None:
    """Put the contents of one result file where the report looks for it."""
    from pitchpoint.analysis.jumps import sweep_jumps
    from pitchpoint.io.case_store import read_cases
    from pitchpoint.io.reading import open_result
    from pitchpoint.io.sweep_store import read_sweep
    from pitchpoint.viz.report import CaseTable, TimeRun

    runs, sweeps, tables = (dict_of(d) for d in (found.runs, found.sweeps, found.cases))
    name = str(header["scenario"] or Path(file).stem)
    if header["kind"] == "sweep":
        sweeps[_free(name, file, sweeps)] = read_sweep(file)
    elif header["kind"] == "cases":
        cases = read_cases(file)
        tables[_free(name, file, tables)] = CaseTable(cases=cases, units=_units(file))
        for case in cases:
            if case["points"]:
                words = ", ".join(f"{path} = {text}" for path, text in case["values"].items())
                jumps = [
                    {"direction": j.direction, "mesh_frequency": j.frequency}
                    for j in sweep_jumps(case["points"])
                ]
                sweeps[_free(f"{name}: {words}", file, sweeps)] = {"points": case["points"], "jumps": jumps}
    elif header["kind"] == "time":
        whole = header["status"] == "finished"
        with open_result(file) as data:
            data.load()
        runs[_free(name, file, runs)] = TimeRun(
            data=data,
            settle_time=float(header["options"].get("settle_time", 0.0)),
            note="" if whole else f"This run is not complete: {header['status']}. {header['sentence']}",
        )


def dict_of(found: Any) -> dict[str, Any]:
    """The dictionary behind a read-only view of it."""
    assert isinstance(found, dict)
    return found


def _units(file: str) -> dict[str, str]:
    """SI units of the varied numbers of a file of cases."""
    from pitchpoint.io.reading import read_header

    units: dict[str, str] = read_header(file)["options"].get("vary_units", {})
    return units


def _free(name: str, file: str, taken: dict[str, Any]) -> str:
    """Name a result after its scenario, and after its file where two have the same."""
    return name if name not in taken else f"{name} ({Path(file).name})"
