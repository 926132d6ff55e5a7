# SPDX-License-Identifier: Apache-2.0
"""A table of computed and published numbers with the source of each."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

from pitchpoint.viz.quantities import number
from pitchpoint.viz.tables import plain_table


@dataclass(frozen=True)
class Compared:
    """One number of a study.

    Attributes
    ----------
    what
        Words for the number.
    value
        The number, in `unit`, or words.
    source
        Where it comes from: run, channel, function.
    unit
        Unit for both numbers.
    published
        What somebody else gives, in `unit`, or words; None if there is nothing to compare with.
    digits
        Significant digits shown.
    """

    what: str
    value: float | str
    source: str
    unit: str = ""
    published: float | str | None = None
    digits: int = 6

    @property
    def difference(self) -> float:
        """Relative difference to the published number [-]; not a number without one.

        Examples
        --------
        >>> round(Compared("frequency", 101.0, "run", published=100.0).difference, 9)
        0.01
        """
        both = (self.value, self.published)
        if any(isinstance(v, str) or v is None for v in both) or not self.published:
            return math.nan
        return float(self.value) / float(self.published) - 1.0


def compared_table(rows: Sequence[Compared], *, published: str = "published") -> str:
    """Quantity, unit, value, published value, difference and source, as HTML.

    Parameters
    ----------
    rows
        The numbers, in order.
    published
        Heading of the column with the numbers of others; without any there is no such column.
    """
    others = any(row.published is not None for row in rows)
    body = []
    for row in rows:
        cells = [row.unit, _cell(row.value, row.digits)]
        if others:
            off = f"{number(100.0 * row.difference, 2)} %" if math.isfinite(row.difference) else ""
            cells += [_cell(row.published, row.digits), off]
        body.append((row.what, *cells, row.source))
    return sourced_table(("quantity", "unit", "here", *((published, "difference") if others else ())), body)


def sourced_table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Table with words, unit, numbers, and last the source of each row, as HTML.

    Parameters
    ----------
    head
        Names of all columns but the last.
    rows
        Texts, one more than names; the third to the last but one are numbers.
    """
    body = []
    for what, unit, *cells, source in rows:
        middle = "".join(f'<td class="num">{escape(cell)}</td>' for cell in cells)
        body.append(
            f'<tr><th scope="row">{escape(what)}</th><td class="unit">{escape(unit)}</td>{middle}'
            f'<td class="from">{escape(source)}</td></tr>'
        )
    # the last column is text: its heading is on the left
    last = '<th scope="col" class="from">from</th></tr></thead>'
    return plain_table(head, body).replace("</tr></thead>", last, 1)


def _cell(value: float | str | None, digits: int) -> str:
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    return number(value, digits) if math.isfinite(value) else "–"
