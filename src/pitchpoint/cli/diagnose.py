# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint diagnose`: damaged shafts, gears and bearings in a record, with evidence."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, output, pairs, quantity
from pitchpoint.cli.output import emit_json, show, show_notes, table

if TYPE_CHECKING:
    from collections.abc import Mapping

    from pitchpoint.report.diagnosis.study import Study

PAGE_ENDINGS = (".html", ".htm")


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
    metavar="[SHAFT=]QUANTITY[±TOL]|LOW..HIGH",
    help="Nominal speed, such as 30Hz or fan=1800rpm±1%, of the first shaft or of a body of the model; "
    "tolerance without ±: 2 %. Lines of the record determine it more closely. Of a run-up the range, such as "
    "600..1800rpm; the speed is found in the record. Default: a speed that the file states.",
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
    metavar="[NAME:]BEARING[@SHAFT]",
    help="Rolling bearing with rotating inner ring: designation, such as 6205 or left:6205@2; number and "
    "diameter of elements, pitch diameter and angle, such as left:8,7.9mm,33.5mm,0deg@2; or fault orders, "
    "such as left:BPFO=3.58,BPFI=5.42.",
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
@click.option(
    "--reference",
    "references",
    multiple=True,
    metavar="FILE|FOLDER",
    help="Healthy records of the same machine to compare the record with: files, folders or 'PATTERN*'; "
    "may be repeated. A folder in place of FILES gives the trend of its records.",
)
@click.option(
    "--load", metavar="LOAD", help="Load of the record, such as 40%, for interpolation of healthy records."
)
@click.option(
    "--load-from",
    metavar="PATTERN",
    help="Part of the file names with the load, such as 'test{load}pc'; default: column load of records.csv.",
)
@output("HTML page with plots of the evidence; of a folder, table (HTML, CSV or JSON) with a row per file.")
@common
def diagnose(files: tuple[str, ...], as_json: bool, quiet: bool, **options: Any) -> int | None:
    """Look for damaged gears, shafts and bearings in FILES: a result, CSV, TSV, MAT, HDF5, WAV or UFF.

    The machine follows from the model of a result, --model, --train, --bearing and --shaft; one shaft with
    bearings is enough. The speed follows from an angle or tacho channel of the file, or from --speed and
    lines near it. Several files are one record with the channels of all; they were recorded together with
    one sample rate. A folder is diagnosed file by file, with one table as result; with --reference, its
    trend.
    """
    from pitchpoint.cli.diagnose_folder import TABLE_ENDINGS, diagnose_records, files_or_folder
    from pitchpoint.cli.diagnose_trend import show_trend
    from pitchpoint.cli.settings import say_bare_option
    from pitchpoint.report.diagnosis.options import check_options
    from pitchpoint.report.diagnosis.request import Request, diagnose_file

    files, folder = files_or_folder(files, join=options.pop("join"))
    trend = folder is not None and bool(options["references"])
    endings = PAGE_ENDINGS if folder is None else (*PAGE_ENDINGS, *TABLE_ENDINGS)
    target = _target(options.pop("output"), [*files, options["model"]], endings)
    problems = _contradictions(options)
    if problems:
        raise click.UsageError("; ".join(problems))
    for text in options["speeds"]:
        say_bare_option(text.rpartition("=")[2].rpartition("..")[2], "angular_speed", "--speed")
    options["units"] = pairs(options["units"], "--unit")
    request = Request(file=files[0] if folder is None else folder, more=files[1:], **options)
    check_options(request)
    if trend:
        return show_trend(request, target, as_json, quiet)
    if folder is not None:
        return diagnose_records(request, folder, target, as_json=as_json, quiet=quiet)
    found = diagnose_file(request)
    if request.references:
        from pitchpoint.report.diagnosis.reference import compare

        found = found.with_change(compare(request, found))
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


def _contradictions(options: Mapping[str, Any]) -> list[str]:
    """Options that exclude each other, or have no effect alone."""
    given = {name for name, value in options.items() if value not in (None, (), False)}
    rules = (
        (
            {"all_channels", "channels"} <= given,
            "--all-channels and --channel both choose channels",
        ),
        ("pulses" in given and "tacho" not in given, "--pulses requires --tacho CHANNEL"),
        (
            "tacho" in given and "pulses" not in given,
            "--tacho requires --pulses N per revolution",
        ),
        ({"tacho", "angle"} <= given, "--tacho and --angle give the same quantity; omit one of them"),
        (
            "train" in given and bool({"model", "scenario"} & given),
            "--train replaces a model and its scenario; omit one of the two",
        ),
        *(
            (name in given and "references" not in given, f"--{name.replace('_', '-')} requires --reference")
            for name in ("load", "load_from")
        ),
    )
    return [text for broken, text in rules if broken]


def _target(path: str | None, inputs: list[str | None], endings: tuple[str, ...]) -> Path | None:
    """Check the name of the page or table before anything is computed."""
    from pitchpoint.cli.diagnose_folder import TABLE_ENDINGS
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
    from pitchpoint.cli.diagnose_trend import print_change
    from pitchpoint.report.diagnosis.words import cells_of_test

    for number, text in enumerate(found.sentences):
        show(text)
        for detail in found.details(number):
            show(f"  {detail}")
    if found.observed:
        show()
        show("observed, as on sound machines; no verdict from one record:")
    for text in found.observed:
        show(f"  {text}")
    if found.change is not None:
        print_change(found.change)
    show()
    rated = [row.sentence for row in found.severity if not row.is_verdict]
    for text in (*rated, *[""] * bool(rated)):
        show(text)
    rows = []
    several = len(found.over.signals) > 1
    for e in found.diagnosis.evidence:
        whose, test, *rest = cells_of_test(e, found.diagnosis)
        rows.append([whose, test, *[e.channel] * several, *rest])
    heads = ["shaft or bearing", "test", *["channel"] * several, "value", "limit", "by noise", "result"]
    title = "Tests" if several else f"Tests of {next(iter(found.over.signals))}"
    table(title, heads, rows, keys=2)
    if quiet:
        return
    notes = found.change.notes if found.change is not None else ()
    show_notes((*found.diagnosis.unreported, *found.diagnosis.untested, *found.remarks, *notes))
