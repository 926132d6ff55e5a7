# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint diagnose`: damaged shafts, gears and bearings in a record, with evidence."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, output, pairs, quantity
from pitchpoint.cli.output import emit_json, show, show_notes, table

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.report.diagnosis.request import Request
    from pitchpoint.report.diagnosis.study import Study

PAGE_ENDINGS = (".html", ".htm")
TABLE_ENDINGS = (".csv", ".json")


@click.command()
@click.argument("files", nargs=-1, required=True, type=click.Path(exists=True))
@click.option("--join", is_flag=True, help="The files of the folder are one record with the channels of all.")
@click.option(
    "--model",
    type=click.Path(exists=True, dir_okay=False),
    metavar="MODEL",
    help="Model file with shafts, gears and bearings; default: the model of a pitchpoint result.",
)
@click.option("--scenario", "-s", metavar="NAME", help="Scenario of the model with the speeds.")
@click.option(
    "--train",
    metavar="Z/Z-Z/Z",
    help="Tooth numbers of the meshes, starting at the input, such as 32/96-48/80.",
)
@click.option(
    "--speed",
    "speeds",
    multiple=True,
    metavar="[SHAFT=]QUANTITY[±TOL]",
    help="Nominal speed, such as 30Hz or fan=1800rpm±1%, of the first shaft or of a body of the model; "
    "tolerance "
    "without ±: 2 %. Lines of the record determine it more closely. Default: a speed that the file states.",
)
@click.option("--tacho", metavar="CHANNEL[@SHAFT]", help="Channel with tacho pulses.")
@click.option("--pulses", type=click.IntRange(min=1), metavar="N", help="Tacho pulses per revolution.")
@click.option("--angle", metavar="CHANNEL[@SHAFT]", help="Channel with the angle of a shaft [rad].")
@click.option("--channel", "-c", "channels", multiple=True, metavar="NAME", help="Channel; may be repeated.")
@click.option(
    "--all-channels", is_flag=True, help="Test all vibration channels of a result, not the usual six."
)
@click.option(
    "--sensor",
    "sensors",
    multiple=True,
    metavar="CHANNEL=PART",
    help="Bearing, mesh or shaft next to a sensor, such as '*_1=left'; default: the part whose name is in "
    "that of the channel.",
)
@click.option(
    "--unit", "units", multiple=True, metavar="NAME=UNIT", help="Unit of a channel, such as acc='9.81 m/s^2'."
)
@click.option(
    "--machine-group",
    default="",
    metavar="GROUP",
    help="Machine group and support for zones of vibration severity: '1 rigid', '1 flexible', '2 rigid', "
    "'2 flexible' of ISO 20816-3, or 'small'.",
)
@click.option(
    "--bearing",
    "bearings",
    multiple=True,
    metavar="NAME:BEARING[@SHAFT]",
    help="Rolling bearing with rotating inner ring: designation, such as left:6205@2; number and diameter "
    "of elements, "
    "pitch diameter and angle, such as left:8,7.9mm,33.5mm,0deg@2; or fault orders, such as "
    "left:BPFO=3.58,BPFI=5.42.",
)
@click.option(
    "--shaft",
    "shafts",
    multiple=True,
    metavar="NAME=RATIO[@SHAFT]",
    help="Shaft driven by a belt or by unknown gears: revolutions per revolution of SHAFT, such as "
    "fan=120/280@motor.",
)
@quantity(
    "--slip",
    "dimensionless",
    "Slip of rolling bearings: maximum deviation of their orders; default: 1 %.",
)
@click.option(
    "--false-alarm",
    type=click.FloatRange(1e-9, 0.5),
    default=0.01,
    show_default=True,
    help="Probability of a finding in noise alone.",
)
@click.option(
    "--noise",
    type=float,
    metavar="DB",
    help="Add white noise this far below the signal; default: 20 for simulations, none for measurements.",
)
@quantity("--sample-rate", "frequency", "Sample rate, if the file does not contain it.")
@output("HTML page with plots of the evidence; of a folder, table (HTML, CSV or JSON) with a row per file.")
@common
def diagnose(files: tuple[str, ...], as_json: bool, quiet: bool, **options: Any) -> int | None:
    """Look for damaged gears, shafts and bearings in FILES: a result, CSV, TSV, MAT, HDF5, WAV or UFF.

    The machine follows from the model of a result, --model, --train, --bearing and --shaft; one shaft with
    bearings is enough. The speed follows from an angle or tacho channel of the file, or from --speed and
    lines near it. Several files are one record with the channels of all; they were recorded together with
    one sample rate. A folder is diagnosed file by file, with one table as result.
    """
    from pitchpoint.cli.settings import say_bare_option
    from pitchpoint.report.diagnosis.request import Request, diagnose_file

    files, folder = _files_or_folder(files, join=options.pop("join"))
    endings = PAGE_ENDINGS if folder is None else (*PAGE_ENDINGS, *TABLE_ENDINGS)
    target = _target(options.pop("output"), [*files, options["model"]], endings)
    if options["all_channels"] and options["channels"]:
        raise click.UsageError("--all-channels and --channel both choose channels; omit one of them")
    if options["pulses"] is not None and options["tacho"] is None:
        raise click.UsageError("--pulses requires --tacho CHANNEL")
    if options["tacho"] is not None and options["pulses"] is None:
        raise click.UsageError("--tacho requires --pulses N, the pulses per revolution")
    given = [flag for flag in ("tacho", "angle") if options[flag] is not None]
    if len(given) > 1:
        raise click.UsageError("--tacho and --angle give the same quantity; omit one of them")
    if options["train"] is not None and (options["model"] or options["scenario"]):
        raise click.UsageError("--train replaces a model and its scenario; omit one of the two")
    for text in options["speeds"]:
        say_bare_option(text.rpartition("=")[2], "angular_speed", "--speed")
    options["units"] = pairs(options["units"], "--unit")
    request = Request(file=files[0] if files else "", more=files[1:], **options)
    if folder is not None:
        return _diagnose_folder(request, folder, target, as_json=as_json, quiet=quiet)
    found = diagnose_file(request)
    if target is not None:
        from pitchpoint.io.target import write_file
        from pitchpoint.report.diagnosis.page import diagnosis_page

        write_file(target, diagnosis_page(found))
    if as_json:
        emit_json(found.as_data())
        return None
    _print(found, quiet)
    if target is not None and not quiet:
        show(f"report written to {target}")
    return None


def _files_or_folder(paths: tuple[str, ...], *, join: bool) -> tuple[tuple[str, ...], str | None]:
    """Files of one record, or a folder with one record per file."""
    import os

    from pitchpoint.io.measured.folder import records_in

    folders = [path for path in paths if os.path.isdir(path)]
    if folders and len(paths) > 1:
        raise click.UsageError(f"{folders[0]} is a folder; give one folder, or files")
    if not join:
        return (() if folders else paths), (folders[0] if folders else None)
    if not folders:
        raise click.UsageError("--join requires a folder; several files are one record without it")
    return tuple(records_in(folders[0])[0]), None


def _diagnose_folder(
    request: Request, folder: str, target: Path | None, *, as_json: bool, quiet: bool
) -> int:
    """Diagnose each file of a folder, and write one table; the exit code is not 0 if some fail."""
    from pitchpoint.cli.failure import FAILED, OK
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.io.target import write_file
    from pitchpoint.report.diagnosis.many import HEAD, diagnose_folder

    with ProgressDisplay("diagnosis", "files", quiet=quiet) as progress:
        found = diagnose_folder(request, folder, progress)
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
    return FAILED if found.failed else OK


def _target(path: str | None, inputs: list[str | None], endings: tuple[str, ...]) -> Path | None:
    """Check the name of the page or table before anything is computed."""
    from pitchpoint.core.errors import Message
    from pitchpoint.io.target import OutputError, check_target

    if path is None:
        return None
    if not path.lower().endswith(endings):
        what = "is not an HTML page" if endings == PAGE_ENDINGS else "is not a table"
        raise OutputError(str(Message("output", what, path, " or ".join(endings), "name another file")))
    kind = "diagnoses" if path.lower().endswith(TABLE_ENDINGS) else "page"
    return check_target(path, kind, [name for name in inputs if name])


def _print(found: Study, quiet: bool) -> None:
    """Print findings and tests."""
    from pitchpoint.report.diagnosis.words import NEVER, outcome, percent, unit_of, what_is_tested

    for number, text in enumerate(found.sentences):
        show(text)
        for detail in found.details(number):
            show(f"  {detail}")
    if found.observed:
        show()
        show("observed, as on sound machines; no verdict from one record:")
    for text in found.observed:
        show(f"  {text}")
    show()
    rated = [row.sentence for row in found.severity if not row.is_verdict]
    for text in (*rated, *[""] * bool(rated)):
        show(text)
    rows = [
        [
            e.shaft if e.kind != "bearing" else e.gear,
            what_is_tested(e),
            e.channel,
            f"{e.value:.1f} {unit_of(e.kind)}" if e.value > NEVER else "–",
            f"{e.threshold:.1f} {unit_of(e.kind)}",
            percent(e.probability),
            outcome(e, found.diagnosis),
        ]
        for e in found.diagnosis.evidence
    ]
    heads = ["shaft or bearing", "test", "channel", "value", "limit", "by noise", "result"]
    table("Tests", heads, rows)
    if quiet:
        return
    show_notes((*found.diagnosis.unreported, *found.diagnosis.untested, *found.remarks))
