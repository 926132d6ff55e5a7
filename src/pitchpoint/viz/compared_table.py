# SPDX-License-Identifier: Apache-2.0
"""Table of computed and published numbers with their sources."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

from pitchpoint.viz.quantities import number
from pitchpoint.viz.tables import plain_table


@dataclass(frozen=True)
class Compared:
    """One row of the table.

    Attributes
    ----------
    what
        Description of the number.
    value
        Computed number in `unit`, or text.
    source
        Origin: run, channel, function.
    unit
        Unit of both numbers.
    published
        Published number in `unit`, or text; None if there is none.
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
        """Relative difference from the published number [-]; NaN without one.

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
    """HTML table of quantity, unit, value, published value, difference and source.

    Parameters
    ----------
    rows
        Rows in order.
    published
        Heading of the column of published numbers; the column is omitted if no row has one.
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
    """HTML table with description, unit, numbers, and source in the last column.

    Parameters
    ----------
    head
        Names of all columns except the last.
    rows
        Texts, one more than `head`; columns three to the last but one are numbers.
    """
    body = []
    for what, unit, *cells, source in rows:
        middle = "".join(f'<td class="num">{escape(cell)}</td>' for cell in cells)
        body.append(
            f'<tr><th scope="row">{escape(what)}</th><td class="unit">{escape(unit)}</td>{middle}'
            f'<td class="from">{escape(source)}</td></tr>'
        )
    # the last column is text: its heading is left-aligned
    last = '<th scope="col" class="from">source</th></tr></thead>'
    return plain_table(head, body).replace("</tr></thead>", last, 1)


def _cell(value: float | str | None, digits: int) -> str:
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    return number(value, digits) if math.isfinite(value) else "–"
