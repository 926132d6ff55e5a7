# SPDX-License-Identifier: Apache-2.0
"""Cells of CSV files: texts that a spreadsheet would compute are marked as texts.

Names and sentences come from files of other people. A text such as ``=HYPERLINK(...)`` in a table would be
executed by Excel or LibreOffice; an apostrophe in front of it prevents that (OWASP, CSV Injection).
"""

from __future__ import annotations

import contextlib

_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n")


def plain_cell(value: object) -> object:
    """Give a value in the form of a table: numbers as they are, texts never as formulas.

    Examples
    --------
    >>> plain_cell("=HYPERLINK(1)"), plain_cell("-2.5"), plain_cell(-2.5)
    ("'=HYPERLINK(1)", '-2.5', -2.5)
    """
    if not isinstance(value, str) or not value.startswith(_FORMULA):
        return value
    with contextlib.suppress(ValueError):
        float(value)
        return value
    return f"'{value}"
