# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint fatigue`: damage-equivalent loads of results, and loads of all teeth."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from typing import Any

import click

from pitchpoint.cli.options import allow_code, as_json, debug, pairs, quiet, writes
from pitchpoint.cli.output import emit_json, show, show_notes, shown, table

DIMENSIONS = {"N m": "torque", "N": "force", "m": "length", "rad": "angle", "W": "power"}


@click.command()
@click.argument("files", nargs=-1, required=True, type=click.Path(exists=True, dir_okay=False))
@click.option(
    "--channel",
    "-c",
    "patterns",
    multiple=True,
    metavar="NAME",
    help="Channel, * matches any characters; default: moments at the ends of beams, torques of couplings.",
)
@click.option(
    "--slope",
    "slopes",
    multiple=True,
    type=click.FloatRange(min=1.0, max=50.0),
    metavar="M",
    help="Exponent of the Wöhler line; may be repeated. Default: 4 and 10.",
)
@click.option(
    "--tooth-slope",
    type=click.FloatRange(min=1.0, max=100.0),
    metavar="M",
    help="The same for the forces of teeth; default: 8.738, tooth root of case-hardened gears.",
)
@click.option(
    "--cycles",
    type=click.FloatRange(min=0.0, min_open=True),
    metavar="N",
    help="Number of equivalent cycles; default: one per second of the whole time.",
)
@click.option(
    "--hours",
    multiple=True,
    metavar="FILE=H",
    help="Operating hours of the load case, such as rated.h5=60000; may be repeated.",
)
@writes("--csv", help="Write the tables to a CSV file.")
@allow_code
@as_json
@quiet
@debug
def fatigue(
    files: tuple[str, ...], allow_code: bool, as_json: bool, quiet: bool, csv: str | None, **options: Any
) -> None:
    """Damage-equivalent loads of the time responses FILES, by rain-flow counting, and loads of all teeth.

    Several results are load cases of one model: their cycles are added, each as often as --hours states. Open
    cycles count as halves. Teeth have one pulse per passage of a mesh.
    """
    from pitchpoint.io.reading import open_result
    from pitchpoint.io.target import check_target, write_file
    from pitchpoint.report.fatigue import SLOPES, TOOTH_SLOPE, LoadCases, fatigue_loads
    from pitchpoint.report.stored_model import stored_model

    target = check_target(csv, "analysis", files) if csv else None
    hours = _hours(options["hours"], files)
    with ExitStack() as opened:
        results = [opened.enter_context(open_result(file)) for file in files]
        for file, data in zip(files, results, strict=True):
            if "time" not in data.dims:
                raise click.BadParameter(f"{file} is not a time response", param_hint="FILES")
        cases = LoadCases(stored_model(files[0], allow_code), results, hours)
        for file, data in zip(files, results, strict=True):
            if (status := data.attrs.get("status", "finished")) != "finished":
                cases.note(f"{file}: the run has not finished: {status}; its samples up to now count")
        slopes = options["slopes"] or SLOPES
        tooth_slope = options["tooth_slope"] or TOOTH_SLOPE
        found = fatigue_loads(cases, options["patterns"], slopes, options["cycles"], tooth_slope)
    if not (found["channels"] or found["teeth"]):
        show_notes(found["notes"])
        text = "the results have no moments of beams, torques of couplings or springs, or forces of teeth"
        raise click.UsageError(f"{text}: choose channels with -c")
    if target is not None:
        write_file(target, csv_text(found))
    if as_json:
        return emit_json(found)
    _print(found)
    if not quiet:
        show_notes(found["notes"])
        if target is not None:
            show(f"written to {target}")
    return None


def _hours(given: Sequence[str], files: Sequence[str]) -> list[float | None]:
    """Hours of every file; None without."""
    found: dict[str, float] = {}
    for name, text in pairs(given, "--hours").items():
        if name not in files:
            raise click.BadParameter(f"{name!r} is not one of the files", param_hint="--hours")
        try:
            found[name] = float(text)
        except ValueError:
            found[name] = -1.0
        if not 0.0 < found[name] < 1e7:
            raise click.BadParameter(f"{text!r} is not a number of hours", param_hint="--hours")
    return [found.get(file) for file in files]


def _print(found: Mapping[str, Any]) -> None:
    """Tables of channels and teeth."""
    head = ["channel", "minimum", "mean", "maximum", *(f"m = {m:g}" for m in found["slopes"])]
    rows = []
    for name, row in found["channels"].items():
        dimension = DIMENSIONS.get(row["unit"])
        values = [row["min"], row["mean"], row["max"], *row["equivalent"]]
        cells = [shown(v, dimension, 5) if dimension else f"{v:.5g} {row['unit']}" for v in values]
        rows.append([name, *cells])
    title = f"Damage-equivalent ranges for {found['cycles']:.6g} cycles in {_time(found['duration'])}"
    table(title, head, rows)
    rows = [
        [
            gear, flank, str(len(row["pulses"])), f"{min(row['pulses']):.6g}", f"{max(row['pulses']):.6g}",
            shown(max(row["largest"]), "force", 5), shown(min(row["equivalent"]), "force", 5),
            shown(max(row["equivalent"]), "force", 5), str(row["worst"]),
        ]
        for gear, flanks in found["teeth"].items()
        for flank, row in flanks.items()
    ]  # fmt: skip
    if rows:
        head = ["gear", "flank", "teeth", "fewest pulses", "most", "largest force"]
        head += ["smallest equivalent", "largest", "tooth"]
        title = f"Teeth: {found['tooth_force']}, equivalent for m = {found['tooth_slope']:g}"
        table(title, head, rows, ["equivalent: as many constant pulses as the teeth have in the mean"])


def _time(seconds: float) -> str:
    """Time in s or h."""
    return f"{seconds:.6g} s" if seconds < 36000.0 else f"{seconds / 3600.0:.6g} h"


def csv_text(found: Mapping[str, Any]) -> str:
    """Table of all numbers, in SI units: one row per channel and slope, tooth, and class of a duration."""
    from pitchpoint.io.target import ANALYSIS_MARK

    lines = ["kind,name,item,value,unit"]
    for name, row in found["channels"].items():
        lines += [f"channel,{name},{key},{row[key]!r},{row['unit']}" for key in ("min", "mean", "max")]
        pairs_ = zip(found["slopes"], row["equivalent"], strict=True)
        lines += [f"equivalent,{name},m={m:g},{value!r},{row['unit']}" for m, value in pairs_]
        duration = zip(row["levels"], row["exceeded"], strict=True)
        lines += [f"exceeded,{name},{level!r},{share!r},1" for level, share in duration]
    for gear, flanks in found["teeth"].items():
        for flank, row in flanks.items():
            for k, (pulses, largest, own) in enumerate(
                zip(row["pulses"], row["largest"], row["equivalent"], strict=True)
            ):
                where = f"{gear}.{flank},{k}"
                lines += [f"pulses,{where},{pulses!r},1", f"largest,{where},{largest!r},N"]
                lines += [f"equivalent,{where},{own!r},N"]
            duration = zip(row["levels"], row["exceeded"], strict=True)
            lines += [f"exceeded,{gear}.{flank},{level!r},{share!r},1" for level, share in duration]
    return ANALYSIS_MARK + "\n".join(lines) + "\n"
