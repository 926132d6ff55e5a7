# SPDX-License-Identifier: Apache-2.0
"""Cells of CSV files: texts that a spreadsheet would evaluate are marked as text.

Names and sentences may come from untrusted files. A text such as ``=HYPERLINK(...)`` in a table would be
executed by Excel or LibreOffice; an apostrophe in front of it prevents that (OWASP, CSV Injection).
"""

from __future__ import annotations

import contextlib

_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n")


def plain_cell(value: object) -> object:
    """Value for a CSV cell: numbers unchanged, texts never as formulas.

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
