# SPDX-License-Identifier: Apache-2.0
"""Column layout of printed tables: line breaks in cells, and fit to a given width.

Cells are broken between words, long keys at dots and brackets if necessary; a number stays with its unit.
Columns that do not fit next to each other are continued below.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

BESIDE, EDGES = 3, 2
"""Characters between columns and at both ends of a table."""
KEY = 20
"""Minimum width of the first column for long cells."""
_FIRST = tuple("0123456789-+–")
_ORDINAL = re.compile(r"\d+(?:×|(?:st|nd|rd|th)\b)")
"""Start of a text with a number, such as an order (2× mesh) or a mode (1st bending)."""
_NUMBER = re.compile(r"[-+]?\d[\d.e+-]*")
_GO_ON = ("N", "kN", "kg", "m", "s")
"""Units that another unit may follow, as in 12 N m."""
_INSIDE = re.compile(r"(?<=[.,/])|(?=\[)")


@dataclass
class Column:
    """Column of text or numbers.

    Parameters
    ----------
    heading, cells
        Heading and cells.
    first
        Whether it is the row heading.
    """

    heading: str
    cells: Sequence[str]
    first: bool = False
    width: int = field(init=False)
    words: bool = field(init=False)

    def __post_init__(self) -> None:
        self.width = max(map(len, (self.heading, *self.cells)))
        numbers = sum(cell[:1] in _FIRST and not _ORDINAL.match(cell) for cell in self.cells)
        self.words = self.first or 2 * numbers < len(self.cells)

    def least(self, *, inside: bool) -> int:
        """Required width if cells are broken between words, or also inside long keys."""
        parts = [p for cell in self.cells for p in self._pieces(cell)] + pieces(self.heading)
        if inside and self.words:
            parts = [p for part in parts for p in _INSIDE.split(part)]
        return max(max(map(len, parts), default=0), min(self.width, KEY) if self.first else 0)

    def lines(self, text: str) -> str:
        """Cell or heading with line breaks for the width of the column."""
        if len(text) <= self.width:
            return text
        return wrap(pieces(text) if text == self.heading else self._pieces(text), self.width)

    def _pieces(self, cell: str) -> list[str]:
        """Unbreakable pieces of a cell; for numbers the entries of a list."""
        return pieces(cell) if self.words else re.split(r"(?<=,) ", cell)


def total(widths: Sequence[int]) -> int:
    """Width of a table with columns of these widths.

    Examples
    --------
    >>> total([10, 20])
    35
    """
    return sum(widths) + BESIDE * (len(widths) - 1) + EDGES


def groups(columns: Sequence[Column], room: int, keys: int = 1) -> list[list[int]]:
    """Groups of columns next to each other, by index; each group begins with the first `keys`."""
    least = [column.least(inside=True) for column in columns]
    front = list(range(keys))
    found = [list(front)]
    for k in range(keys, len(columns)):
        if len(found[-1]) > keys and total([least[i] for i in (*found[-1], k)]) > room:
            found.append(list(front))
        found[-1].append(k)
    return found


def fit(columns: Sequence[Column], room: int) -> None:
    """Narrow the columns, widest first, until they fit or are at their minimum."""
    for inside in (False, True):
        least = [column.least(inside=inside) for column in columns]
        while total([column.width for column in columns]) > room:
            able = [k for k, column in enumerate(columns) if column.width > least[k]]
            if not able:
                break
            columns[max(able, key=lambda k: columns[k].width)].width -= 1


def pieces(text: str) -> list[str]:
    """Split a text into unbreakable pieces: words, and numbers with their units.

    Examples
    --------
    >>> pieces("wheel tilt 66 %, base 12.5 N m up")
    ['wheel', 'tilt', '66 %,', 'base', '12.5 N m up']
    >>> pieces("  peak to peak")
    ['  peak', 'to', 'peak']
    """
    found: list[str] = []
    joined = False
    for word in text.split():
        if joined:
            found[-1] += f" {word}"
            joined = word in _GO_ON
        else:
            found.append(word)
            joined = _NUMBER.fullmatch(word) is not None
    if not found:
        return [text]
    return [" " * (len(text) - len(text.lstrip(" "))) + found[0], *found[1:]]


def wrap(parts: Sequence[str], width: int) -> str:
    """Wrap pieces into lines of a width; pieces that are too long are split.

    Examples
    --------
    >>> wrap(["a", "2 mm,", "b"], 6)
    'a\\n2 mm,\\nb'
    >>> wrap(["scenarios.steady.step"], 12), wrap(["force[left.fx]"], 10)
    ('scenarios.\\nsteady.step', 'force\\n[left.fx]')
    """
    lines: list[str] = []
    for part in parts:
        for k, piece in enumerate([part] if len(part) <= width else _INSIDE.split(part)):
            between = " " if k == 0 else ""
            if lines and len(lines[-1]) + len(between) + len(piece) <= width:
                lines[-1] += between + piece
            else:
                lines.append(piece)
    return "\n".join(lines)
