# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint analyse`: spectra, orders and indicators of a result or a measured file."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.analysis.tools import TOOLS
from pitchpoint.cli.options import as_json, debug, pairs, quantity, quiet, writes
from pitchpoint.cli.output import emit_json, show, show_notes, table

if TYPE_CHECKING:
    import xarray as xr

_LISTED = 60
_QUANTITY = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?\s*\D.*")


def _tools() -> str:
    return "\b\nTools:\n" + "\n".join(f"  {name:24}{row.summary}" for name, row in TOOLS.items())


@click.command(epilog=_tools())
@click.argument("words", nargs=-1, metavar="[FILE]... [TOOL]")
@click.option("--channel", "-c", "channels", multiple=True, metavar="NAME", help="Channel; may be repeated.")
@click.option(
    "--angle", metavar="NAME", help="Channel with angle [rad] or speed [rad/s] of the reference shaft."
)
@click.option(
    "--tacho", metavar="NAME", help="Channel with tacho pulses of the reference shaft, instead of --angle."
)
@click.option(
    "--pulses-per-revolution",
    type=click.IntRange(min=1),
    metavar="N",
    help="Tacho pulses per revolution.",
)
@quantity("--sample-rate", "frequency", "Sample rate, if the file does not contain it.")
@click.option(
    "--unit", "units", multiple=True, metavar="NAME=UNIT", help="Unit of a channel, such as acc='50 m/s^2'."
)
@click.option("--option", "-O", "settings", multiple=True, metavar="NAME=VALUE", help="Option of the tool.")
@click.option(
    "--mesh-frequency",
    "lines",
    multiple=True,
    metavar="QUANTITY",
    help="List its harmonics above half the sample rate.",
)
@writes("--csv", help="Write the result to a CSV table.")
@writes("--html", help="Write an HTML page with plots.")
@as_json
@quiet
@debug
def analyse(words: tuple[str, ...], as_json: bool, quiet: bool, **options: Any) -> None:
    """Apply TOOL to channels of FILE: a result, CSV, TSV, MAT, HDF5, WAV or UFF (data set 58).

    Without TOOL, list the channels of FILE; without FILE, list the tools. Several files are one record with
    the channels of all; they were recorded together with one sample rate.
    """
    from pitchpoint.analysis.dataset import analyse as apply
    from pitchpoint.analysis.shaft_channel import with_shaft_angle
    from pitchpoint.core.errors import split_notes
    from pitchpoint.io.measured.reading import read_measured
    from pitchpoint.io.measured.record import as_options
    from pitchpoint.io.target import check_target

    files, tool = _files_and_tool(words)
    if not files:
        return _list_tools(as_json)
    targets = {
        kind: check_target(options[key], kind, files) for key, kind in _TARGETS.items() if options[key]
    }
    tacho, angle = options["tacho"], options["angle"]
    _one_shaft(tacho, angle, options["pulses_per_revolution"])
    chosen = list(dict.fromkeys([*options["channels"], *(n for n in (angle, tacho) if n)]))
    wanted = chosen if options["channels"] else None
    units = pairs(options["units"], "--unit")
    record = read_measured(files, sample_rate=options["sample_rate"], channels=wanted, units=units)
    if tacho is not None:
        record = with_shaft_angle(record, tacho, pulses_per_revolution=options["pulses_per_revolution"])
        angle = f"angle[{tacho}]"
    notes = split_notes(as_options(str(record.attrs.get("notes", ""))))
    lost = _lost(record, options["lines"])
    notes += [lost] if lost else []
    if tool is None:
        named = files[0] + (f" and {len(files) - 1} more" if files[1:] else "")
        return _list_channels(named, record, notes, as_json)
    names = options["channels"][0] if len(options["channels"]) == 1 else list(options["channels"]) or None
    settings = {name: value_of(text) for name, text in pairs(options["settings"], "--option").items()}
    result = apply(record, tool, channel=names, angle=angle, **settings)
    notes += split_notes(str(result.attrs.get("notes", "")))
    _write(targets, record, result, notes)
    if as_json:
        return emit_json(_plain(result, notes))
    _highlights(result)
    if not quiet:
        show_notes(notes)
        for path in targets.values():
            show(f"written to {path}")
    return None


_MAX_VALUES = 100_000
"""Maximum number of values of a map in JSON output (2 MB); files contain all."""

_TARGETS = {"csv": "analysis", "html": "page"}


def _files_and_tool(words: Sequence[str]) -> tuple[list[str], str | None]:
    """Files, and the tool if the last word names one and no file."""
    files = list(words)
    tool = None
    if len(files) > 1 and (files[-1] in TOOLS or not os.path.exists(files[-1])):
        tool = files.pop()
    kind = click.Path(exists=True, dir_okay=False)
    context = click.get_current_context()
    parameter = next(p for p in context.command.params if p.name == "words")
    return [str(kind.convert(name, parameter, context)) for name in files], tool


def _one_shaft(tacho: str | None, angle: str | None, pulses: int | None) -> None:
    """Reject options that do not define one reference shaft."""
    if tacho is not None and angle is not None:
        raise click.UsageError("--tacho and --angle both define the shaft; omit one of them")
    if (tacho is None) != (pulses is None):
        raise click.UsageError("--tacho requires --pulses-per-revolution and vice versa; give both")


def value_of(text: str) -> Any:
    """Parsed option value: number, quantity in SI, Boolean, None, tuple of these, or text.

    Examples
    --------
    >>> [value_of(text) for text in ("2 kHz", "8", "true", "hann", "none", "1,2.5")]
    [2000.0, 8, True, 'hann', None, (1, 2.5)]
    """
    from pitchpoint.core.errors import UnitError
    from pitchpoint.core.units import natural_si

    text = text.strip()
    words = {"true": True, "false": False, "none": None}
    if text.lower() in words:
        return words[text.lower()]
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    if re.fullmatch(r"\d+/[1-9]\d*", text):
        return Fraction(text)
    if "," in text:
        return tuple(value_of(part) for part in text.split(","))
    if _QUANTITY.fullmatch(text):
        found = re.match(r"[+-]?[\d.]+(?:[eE][+-]?\d+)?", text)
        try:
            return float(found[0]) * natural_si(text[found.end() :].strip()) if found else text
        except (UnitError, ValueError):
            return text
    return text


def _lost(record: xr.Dataset, lines: Sequence[str]) -> str:
    """Sentence about mesh harmonics above half the sampling rate."""
    from pitchpoint.analysis.bandwidth import lost_harmonics
    from pitchpoint.core.errors import UnitError
    from pitchpoint.core.units import parse_quantity

    found = {}
    for number, text in enumerate(lines, start=1):
        name = "the mesh frequency" if len(lines) == 1 else f"mesh frequency {number}"
        try:
            plain = value_of(text)
            found[name] = parse_quantity(
                plain if isinstance(plain, int) else text, "frequency", positive=True
            )
        except UnitError as error:
            raise click.BadParameter(str(error), param_hint="--mesh-frequency") from None
    rate = record.attrs.get("sample_rate")
    return lost_harmonics(float(rate), found) if rate and found else ""


def _list_tools(as_json: bool) -> None:
    """Print all tools with their options."""
    from pitchpoint.analysis.dataset import tool_options

    if as_json:
        return emit_json(
            {n: {"summary": r.summary, "options": list(tool_options(n))} for n, r in TOOLS.items()}
        )
    rows = [[name, row.summary, ", ".join(tool_options(name))] for name, row in TOOLS.items()]
    table("Tools", ["tool", "result", "options"], rows)
    return None


def _list_channels(file: str, record: xr.Dataset, notes: Sequence[str], as_json: bool) -> None:
    """Print the channels of a file with their properties."""
    import numpy as np

    from pitchpoint.viz.quantities import number

    rate = record.attrs.get("sample_rate")
    listed = {
        str(name): {
            "unit": v.attrs["units"],
            "mean": float(np.mean(v.values)),
            "min": float(np.min(v.values)),
            "max": float(np.max(v.values)),
        }
        for name, v in record.data_vars.items()
    }
    if as_json:
        about = {"format": record.attrs["format"], "sample_rate": rate, "samples": record.sizes["time"]}
        return emit_json(about | {"channels": listed, "notes": list(notes)})
    rows = [
        [name, row["unit"], *(number(row[key], 5) for key in ("mean", "min", "max"))]
        for name, row in list(listed.items())[:_LISTED]
    ]
    known = f" at {rate:.6g} Hz" if rate else ", not evenly spaced"
    title = f"{file}: {record.attrs['format']}, {record.sizes['time']} samples{known}"
    more = [f"and {len(listed) - _LISTED} more"] if len(listed) > _LISTED else []
    table(title, ["channel", "unit", "mean", "min", "max"], rows, [*more, *notes])
    show(f"tools: {', '.join(TOOLS)}")
    return None


def _highlights(result: xr.Dataset) -> None:
    """Print the numbers of a result and the maxima of its curves."""
    from pitchpoint.cli.highlights import highlights
    from pitchpoint.viz.analysis_page import results_by_channel

    for name, one in results_by_channel(result).items():
        table(f"{result.attrs['tool']} of {name}", ["", "value", "at"], highlights(one))


def _plain(result: xr.Dataset, notes: Sequence[str]) -> Mapping[str, Any]:
    """Output of `--json`; maps above `_MAX_VALUES` values are decimated along their longest dimension."""
    maps = [v for v in result.data_vars.values() if v.ndim > 1 and v.size > _MAX_VALUES]
    if maps:
        largest = max(maps, key=lambda v: v.size)
        dim = max(largest.sizes, key=lambda d: largest.sizes[d])
        step, count = -(-largest.size // _MAX_VALUES), result.sizes[dim]
        result = result.isel({dim: slice(None, None, step)})
        notes = [*notes, f"every {step}th of {count} values of {dim} is given; --csv FILE writes all of them"]
    variables = {
        str(name): {"dims": list(v.dims), "unit": v.attrs.get("units", ""), "values": v.values}
        for name, v in result.variables.items()
    }
    return {**{str(k): v for k, v in result.attrs.items()}, "notes": list(notes), "variables": variables}


def _write(targets: Mapping[str, Any], record: xr.Dataset, result: xr.Dataset, notes: Sequence[str]) -> None:
    """Write the requested files."""
    from pitchpoint.io.target import write_file

    if "analysis" in targets:
        from pitchpoint.io.analysis_table import table_text

        write_file(targets["analysis"], table_text(result))
    if "page" in targets:
        from pitchpoint.viz.analysis_page import analysis_page

        write_file(targets["page"], analysis_page(record, result, notes))
