# SPDX-License-Identifier: Apache-2.0
"""Output of commands: JSON and tables."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from rich.table import Table

    from pitchpoint.cli.columns import Column
    from pitchpoint.report.power_tables import PowerTable

NOTHING = "–"
ROUNDING = 1e-13
"""Angle [rad] below which a direction of several steps is zero but for rounding."""
PIPE = 160
"""Width of output that is not written to a terminal."""


def emit_json(data: Mapping[str, Any]) -> None:
    """Print JSON on stdout; non-finite numbers become null, arrays lists."""
    click.echo(json.dumps(plain(data), indent=2, allow_nan=False))


def plain(data: Any) -> Any:
    """Convert mappings, sequences and NumPy values to JSON types.

    Examples
    --------
    >>> plain({"a": (1.0, float("nan")), "b": range(2)})
    {'a': [1.0, None], 'b': [0, 1]}
    """
    if isinstance(data, Mapping):
        return {str(key): plain(value) for key, value in data.items()}
    if hasattr(data, "tolist"):
        return plain(data.tolist())
    if isinstance(data, float):
        return data if math.isfinite(data) else None
    if data is None or isinstance(data, str | bool | int):
        return data
    if isinstance(data, Sequence | range | set | frozenset):
        return [plain(value) for value in data]
    return str(data)


def show(text: str = "") -> None:
    """Print a line on stdout."""
    click.echo(text)


def show_unless(quiet: bool, text: str) -> None:
    """Print a line on stdout, except in quiet runs."""
    if not quiet:
        show(text)


def show_notes(notes: Iterable[str]) -> None:
    """Print notes, one per line."""
    for note in notes:
        show(f"note: {note}")


def number_rows(
    rows: Iterable[tuple[str, str, str]],
    numbers: Mapping[str, Mapping[str, Any]],
    digits: int = 7,
    *,
    symbols: bool = True,
) -> list[list[str]]:
    """Rows of a table with one component per column; rows are identifier, meaning and dimension."""
    return [
        [f"{meaning}  {key}" if symbols else meaning]
        + [shown(thing[key], dimension, digits) for thing in numbers.values()]
        for key, meaning, dimension in rows
    ]


def table(
    title: str,
    columns: Sequence[str],
    rows: Sequence[Sequence[str]],
    notes: Sequence[str] = (),
    *,
    keys: int = 1,
) -> None:
    """Print a table, text left-aligned, numbers right-aligned; rows of one empty text are rules.

    Columns that do not fit next to each other follow in separate tables, after the first `keys` columns.
    """
    from rich.console import Console
    from rich.markup import escape

    from pitchpoint.cli.columns import Column, fit, groups, total

    filled = [row for row in rows if any(row)]
    laid = [Column(name, [row[k] for row in filled], k == 0) for k, name in enumerate(columns)]
    console = Console(highlight=False)
    # A pipe has no width; a table truncated at 80 columns would lose numbers.
    room = console.width if console.is_terminal else PIPE
    for number, group in enumerate(groups(laid, room, keys)):
        chosen = [replace(laid[k]) for k in group]
        fit(chosen, room)
        # the terminal wraps what still does not fit
        wide = total([column.width for column in chosen])
        console = Console(highlight=False, width=max(room, wide))
        if number == 0:
            # A title inside the table would be wrapped at the width of the columns.
            console.print(f"[bold]{escape(title)}[/bold]", soft_wrap=True)
        console.print(_made(chosen, rows))
    for note in notes:
        console.print(f"  {escape(note)}", soft_wrap=True)


def _made(columns: Sequence[Column], rows: Sequence[Sequence[str]]) -> Table:
    """Table of columns with given widths; `rows` only give the positions of the rules."""
    from rich import box
    from rich.markup import escape
    from rich.table import Table

    made = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    for column in columns:
        side: Any = "left" if column.words else "right"
        heading = escape(column.lines(column.heading))
        made.add_column(heading, justify=side, width=column.width, no_wrap=True)
    cells = iter(zip(*(map(column.lines, column.cells) for column in columns), strict=True))
    for row in rows:
        if any(row):
            made.add_row(*map(escape, next(cells)))
        else:
            made.add_section()
    return made


def show_tables(*tables: PowerTable) -> None:
    """Print tables of `report`; those without rows are omitted."""
    for each in tables:
        if each.rows:
            table(each.title, each.head, each.rows, each.notes)


def shown(value: Any, dimension: str = "dimensionless", digits: int = 7) -> str:
    """Value in a customary unit; an en dash if there is none.

    Examples
    --------
    >>> shown(0.5, "length"), shown(None), shown(17)
    ('500 mm', '–', '17')
    """
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return NOTHING
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int):
        return str(value)
    from pitchpoint.core.units import format_quantity

    if dimension == "angle" and abs(value) < ROUNDING:
        value = 0.0
    return format_quantity(float(value) + 0.0, dimension, digits)  # no "-0"


def largest(values: Iterable[float | None]) -> str:
    """Largest of some numbers with four decimals; a dash if none is known.

    Examples
    --------
    >>> largest([1.02, None, 1.1, float("nan")]), largest([float("nan")])
    ('1.1000', '–')
    """
    known = [value for value in values if value is not None and not math.isnan(value)]
    return f"{max(known):.4f}" if known else NOTHING
