# SPDX-License-Identifier: Apache-2.0
"""What commands print: JSON for programs, tables for people."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

import click

NOTHING = "–"
SHORT = 30
"""Length up to which the names in a first column are never broken."""
_NUMBER = tuple("0123456789-+–")


def emit_json(data: Mapping[str, Any]) -> None:
    """Print JSON on stdout; numbers that are not finite become null, arrays lists."""
    click.echo(json.dumps(plain(data), indent=2, allow_nan=False))


def plain(data: Any) -> Any:
    """Turn mappings, sequences and numpy values into what JSON knows.

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
    """Print a line for people on stdout."""
    click.echo(text)


def table(
    title: str, columns: Sequence[str], rows: Sequence[Sequence[str]], notes: Sequence[str] = ()
) -> None:
    """Print a table: words left, numbers right; rows of one empty text are rules."""
    from rich import box
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    made = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    for k, name in enumerate(columns):
        cells = [row[k] for row in rows if any(row)]
        words = k == 0 or 2 * sum(cell[:1] in _NUMBER for cell in cells) < len(cells)
        short = k == 0 and max(map(len, cells), default=0) <= SHORT
        made.add_column(escape(name), justify="left" if words else "right", overflow="fold", no_wrap=short)
    for row in rows:
        if not any(row):
            made.add_section()
        else:
            made.add_row(*(escape(cell) for cell in row))
    console = Console(highlight=False)
    if not console.is_terminal:
        # A pipe has no width of its own; a table cut at 80 columns would lose numbers.
        console = Console(highlight=False, width=160)
    # A title inside the table would be broken at the width of the columns.
    console.print(f"[bold]{escape(title)}[/bold]", soft_wrap=True)
    console.print(made)
    for note in notes:
        console.print(f"  {escape(note)}", soft_wrap=True)


def shown(value: Any, dimension: str = "dimensionless", digits: int = 7) -> str:
    """Write a value in the unit people use; an en dash where there is none.

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

    return format_quantity(float(value) + 0.0, dimension, digits)  # no "-0"
