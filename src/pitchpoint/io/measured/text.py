# SPDX-License-Identifier: Apache-2.0
"""Measured text files: CSV, TSV and similar, with decimal points or commas.

Separator and decimal sign are detected: tabs and semicolons always separate; a comma separates unless the
header has only one name. Ambiguous files are rejected. Lines that begin with `#`, `%` or `//` are comments;
a comment such as `sample_rate: 25.6 kHz` is evaluated.
"""

from __future__ import annotations

import csv
import io
import itertools
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pitchpoint.io.measured.record import (
    TIME_NAMES,
    Column,
    MeasuredError,
    Record,
    Wanted,
    key_of,
    refused,
    split_name,
)
from pitchpoint.io.measured.stated import Given, Statements, is_rate
from pitchpoint.io.measured.units import is_unit

_REMARK = ("#", "%", "//")
_NUMBER = re.compile(r"[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eEdD][+-]?\d+)?|[+-]?(?:nan|inf(?:inity)?)", re.I)
_WORDS = re.compile(r"[^\s\[]+(?:\s*\[[^\]]*\])?")
_KEY_VALUE = re.compile(r"\s*([\w .\-]{1,40}?(?:\s*[\[(][^\[\]()]{1,20}[\])])?)\s*[:=]\s*(.{1,100})")
_CONTROL = re.compile(r"[\x00-\x08\x0e-\x1f\x7f]")
_PROBE = 20
"""Number of rows used to distinguish numbers from text."""
_CLOCK = 200
"""Number of rows used to find the resolution of a time axis."""
_MAX_REMARKS = 1000
_BLOCK = 1 << 23
"""Block size for reading [bytes]; a block requires about ten times as much memory."""


@dataclass(frozen=True)
class _Layout:
    """Layout of a file: separator, decimal sign, and index of the first line with numbers."""

    separator: str
    comma: bool
    names: list[str]
    units: list[str]
    first: int


@dataclass(frozen=True)
class _Text:
    """Lines of a file, decoded in blocks of complete lines: a long record is never in memory as text."""

    data: bytes
    code: str
    blocks: list[tuple[int, int, int]]
    """Begin and end of every block [bytes], and the number of lines before it."""
    head: list[tuple[int, str]]
    """First rows with line indices from 0, without empty lines and comments."""
    last: tuple[int, str]
    """Last row."""
    remarks: list[tuple[int, str]]

    def rows(self, first: int) -> Iterator[tuple[list[int], list[str]]]:
        """Rows from a line on, in blocks, with their line indices."""
        for begin, end, before in self.blocks:
            lines = self.data[begin:end].decode(self.code).splitlines()
            found = [k for k, line in enumerate(lines) if before + k >= first and _is_row(line)]
            if found:
                yield [before + k for k in found], [lines[k] for k in found]


def read_text(path: Path, data: bytes, wanted: Wanted) -> Record:
    """Read a text file with columns of numbers."""
    text, notes = _decoded(path, data)
    layout = _layout(path, text)
    head = [(k, line) for k, line in text.head if k >= layout.first]
    if not head:
        raise refused(path, "", "", "has a header and no rows of numbers", "2 or more rows", "record again")
    cells = {k: _cut(line, layout) for k, line in (*head[:_PROBE], text.last)}
    names = _names(path, layout, cells[head[0][0]], head[0][0])
    _same_width(path, cells, len(names))
    numeric = [
        j for j in range(len(names)) if any(_is_number(row[j], layout.comma) for row in cells.values())
    ]
    if not numeric:
        (line, head_line), remedy = text.head[0], "begin the lines before the names of the columns with #"
        raise refused(path, f"line {line + 1}", repr(head_line[:40]), "has no numbers below it", None, remedy)
    place = _time_place(names, layout.units, numeric)
    chosen = [j for j in numeric if j == place or wanted.takes(names[j])]
    texts = [
        names[j] for j in range(len(names)) if j not in numeric and any(row[j] for row in cells.values())
    ]
    asked = [
        names[j] for j in range(len(names)) if j not in numeric and wanted.channels and wanted.takes(names[j])
    ]
    if asked:
        raise refused(
            path, asked[0], "", "holds text and no numbers", "a column of numbers", "choose other channels"
        )
    if texts:
        notes.append(f"omitted because they hold text: {', '.join(texts)}")
    table = _numbers(path, text, chosen, layout, names)
    columns = {j: Column(names[j], table[k], layout.units[j]) for k, j in enumerate(chosen)}
    decimals = (
        0.0
        if place is None
        else _resolution([_cut(line, layout)[place] for _, line in (*head[:_CLOCK], text.last)])
    )
    given = _statements(path, text.remarks, [names[j] for j in chosen])
    return Record(
        form="TSV" if layout.separator == "\t" else "CSV",
        columns=tuple(c for j, c in columns.items() if j != place),
        time=None if place is None else columns[place],
        resolution=decimals,
        rates=given.rates,
        speed=given.speed,
        fault_orders=given.fault_orders,
        notes=(*notes, *given.notes),
    )


def _is_row(line: str) -> bool:
    """Whether a line is neither empty nor a comment."""
    plain = line.lstrip()
    return bool(plain) and not plain.startswith(_REMARK)


def _decoded(path: Path, data: bytes) -> tuple[_Text, list[str]]:
    """Text of a file in UTF-8, UTF-16 with its mark, or Windows-1252."""
    wide = data[:2] in (b"\xff\xfe", b"\xfe\xff")
    for code in ("utf-16",) if wide else ("utf-8-sig", "cp1252"):
        try:
            text = _text(path, data, code)
        except UnicodeDecodeError:
            continue
        if text is not None:
            return text, ["letters were read as Windows-1252"] if code == "cp1252" else []
        break
    what, limit = "holds neither text nor a known measured format", "CSV, TSV, MAT, HDF5, WAV or UFF"
    raise refused(path, "", "", what, limit, "export it as one of these, texts as UTF-8")


def _text(path: Path, data: bytes, code: str) -> _Text | None:
    """Scan a file in blocks; None if it contains characters that are not text."""
    blocks: list[tuple[int, int, int]] = []
    head: list[tuple[int, str]] = []
    remarks: list[tuple[int, str]] = []
    last: tuple[int, str] | None = None
    begin = before = 0
    while begin < len(data):
        end = len(data) if code == "utf-16" else data.find(b"\n", begin + _BLOCK) + 1 or len(data)
        block = data[begin:end].decode(code)
        if _CONTROL.search(block):
            return None
        lines = block.splitlines()
        blocks.append((begin, end, before))
        if len(remarks) < _MAX_REMARKS and any(mark in block for mark in _REMARK):
            remarks += [(before + k, x) for k, x in enumerate(lines) if x.lstrip().startswith(_REMARK)]
        found = ((before + k, line) for k, line in enumerate(lines) if _is_row(line))
        head += itertools.islice(found, _PROBE + _CLOCK - len(head))
        at = next((k for k in range(len(lines) - 1, -1, -1) if _is_row(lines[k])), None)
        last = last if at is None else (before + at, lines[at])
        begin, before = end, before + len(lines)
    if last is None:
        raise refused(
            path, "", "no line", "holds numbers", "2 or more rows", "name the file that holds the record"
        )
    return _Text(data, code, blocks, head, last, remarks[:_MAX_REMARKS])


def _layout(path: Path, text: _Text) -> _Layout:
    """Separator, decimal sign and header of a file."""
    rows = text.head
    first_line, head = rows[0]
    body = [line for _, line in (*rows[1 : _PROBE + 1], text.last)]
    if "\t" in head.strip():
        separator = "\t"
    elif ";" in head:
        separator = ";"
    elif "," in head or all("," in line for line in body):
        separator = _comma_or_decimal(path, head, body, first_line)
    elif len(head.split()) > 1 and all(len(line.split()) > 1 for line in body):
        separator = " "
    else:
        separator = "\n"  # one column
    probe = _Layout(separator, separator != ",", [], [], 0)
    header = _cut(head, probe)
    comma = separator != "," and any("," in cell for line in body for cell in _cut(line, probe))
    if all(_is_number(cell, separator != ",") or not cell for cell in header):
        return _Layout(separator, comma or any("," in c for c in header), [], [""] * len(header), first_line)
    if separator == " ":
        header = _WORDS.findall(head)
    while len(header) > 1 and not header[-1]:  # the header ends with a separator
        header.pop()
    pairs = [split_name(cell) for cell in header]
    names, units = [name for name, _ in pairs], [unit for _, unit in pairs]
    first = 1
    if len(rows) > 1:
        second = [cell.strip("[]() ") for cell in _cut(rows[1][1], probe)][: len(names)]
        words = any(cell and not _is_number(cell, separator != ",") for cell in second)
        if not any(units) and words and all(not cell or is_unit(cell) for cell in second):
            units, first = second, 2
    units += [""] * (len(names) - len(units))
    return _Layout(separator, comma, names, units, rows[first][0] if len(rows) > first else text.last[0] + 1)


def _comma_or_decimal(path: Path, head: str, body: Sequence[str], line: int) -> str:
    """Decide whether a comma separates columns or is a decimal sign, or raise."""
    if "," in head and not all(_is_number(cell.strip(), comma=True) for cell in head.split()):
        pieces = head.split(",")
        if not all(_is_number(p.strip(), comma=False) for p in pieces):
            return ","  # a header with several names
        if any("." in p for p in pieces) or len(pieces) > 2:
            return ","
    elif "," not in head:
        return " " if len(head.split()) > 1 and all(len(b.split()) > 1 for b in body) else "\n"
    every = [head, *body]
    if any("." in text for text in every) or any(
        text.count(",") > 1 for text in every if len(text.split()) == 1
    ):
        return ","
    if all(len(text.split()) > 1 for text in every):
        return " "
    raise refused(
        path,
        "",
        repr(head.strip()[:40]),
        "may be two columns or one number with a decimal comma",
        None,
        "give the file a header line with a name for each column",
        line=line + 1,
    )


def _cut(line: str, layout: _Layout) -> list[str]:
    """Cells of a line without surrounding spaces."""
    if layout.separator == "\n":
        return [line.strip()]
    if layout.separator == " ":
        return line.split()
    if '"' not in line:
        return [cell.strip() for cell in line.split(layout.separator)]
    try:
        return [cell.strip() for cell in next(csv.reader([line], delimiter=layout.separator), [])]
    except csv.Error:
        return [cell.strip().strip('"') for cell in line.split(layout.separator)]


def _names(path: Path, layout: _Layout, first: Sequence[str], line: int) -> list[str]:
    """Names of the columns; numbered without a header."""
    if not layout.names:
        return [f"channel {j + 1}" for j in range(len(first))]
    filled = len(first)
    while filled > len(layout.names) and not first[filled - 1]:
        filled -= 1
    if filled != len(layout.names):
        raise refused(
            path,
            "",
            f"{filled} cells",
            "are under a header with another number of names",
            f"{len(layout.names)}",
            "separate names and numbers by the same sign",
            line=line + 1,
        )
    return [name or f"column {j + 1}" for j, name in enumerate(layout.names)]


def _same_width(path: Path, cells: dict[int, list[str]], count: int) -> None:
    for k, row in cells.items():
        while len(row) > count and not row[-1]:
            row.pop()
        if len(row) != count:
            remedy = "complete or delete this line; it may be where the file was cut off"
            raise refused(path, "", f"{len(row)} cells", "are in this line", f"{count}", remedy, line=k + 1)


def _time_place(names: Sequence[str], units: Sequence[str], numeric: Sequence[int]) -> int | None:
    """Index of the time column by its name."""
    return next((j for j in numeric if key_of(names[j]) in TIME_NAMES), None)


def _is_number(cell: str, comma: bool) -> bool:
    return bool(_NUMBER.fullmatch(cell)) and (comma or "," not in cell)


def _numbers(
    path: Path, text: _Text, chosen: Sequence[int], layout: _Layout, names: Sequence[str]
) -> NDArray[np.float64]:
    """Columns of numbers, shape (n_chosen, n_row); by the fast parser, else by the strict one."""
    parts = []
    for lines, rows in text.rows(layout.first):
        table = _fast(rows, chosen, layout)
        parts.append(_careful(path, lines, rows, chosen, layout, names) if table is None else table.T)
    whole = np.empty((len(chosen), sum(part.shape[1] for part in parts)))
    at = whole.shape[1]
    while parts:  # from the last, so that each is released
        part = parts.pop()
        whole[:, at - part.shape[1] : at] = part
        at -= part.shape[1]
    return whole


def _fast(rows: Sequence[str], chosen: Sequence[int], layout: _Layout) -> NDArray[np.float64] | None:
    """Columns of plain numbers, shape (n_row, n_chosen); None if the strict parser is required."""
    if not chosen:
        return np.empty((len(rows), 0))
    text = "\n".join(rows)
    if '"' in text or (layout.comma and "." in text) or re.search(r"[dD_]", text):
        return None
    text = text.replace(",", ".") if layout.comma else text
    separator = layout.separator if layout.separator in "\t;," else None
    try:
        return np.loadtxt(
            io.StringIO(text), delimiter=separator, usecols=list(chosen), ndmin=2, comments=None
        )
    except ValueError:
        return None  # the strict parser finds the line


def _careful(
    path: Path,
    lines: Sequence[int],
    rows: Sequence[str],
    chosen: Sequence[int],
    layout: _Layout,
    names: Sequence[str],
) -> NDArray[np.float64]:
    """Columns of numbers, cell by cell, shape (n_chosen, n_row); empty cells are NaN."""
    found = np.empty((len(chosen), len(rows)))
    for i, (k, row) in enumerate(zip(lines, rows, strict=True)):
        cells = _cut(row, layout)
        _same_width(path, {k: cells}, len(names))
        for column, j in enumerate(chosen):
            cell = cells[j]
            if cell and not _is_number(cell, layout.comma):
                raise _no_number(path, names[j], cell, k)
            if layout.comma and "." in cell:
                remedy = "write numbers without separators of thousands"
                message = "has a decimal point in a file with decimal commas"
                raise refused(path, names[j], repr(cell[:40]), message, None, remedy, line=k + 1)
            plain = cell.replace(",", ".").translate(str.maketrans("dD", "ee"))
            found[column, i] = float(plain) if cell else np.nan
    return found


def _no_number(path: Path, name: str, cell: str, line: int) -> MeasuredError:
    remedy = "repair or delete this line, or choose the other columns by channels="
    return refused(path, name, repr(cell[:40]), "is not a number", None, remedy, line=line + 1)


def _resolution(cells: Sequence[str]) -> float:
    """Value of the last digit of the largest time in the file.

    Examples
    --------
    >>> _resolution(["0", "0.0001", "12.3456"]), _resolution(["0", "1e-05", "2.00001e+00"])
    (0.0001, 1e-05)
    """
    digits, largest = 1, 0.0
    for cell in cells:
        plain = cell.replace(",", ".").lower().replace("d", "e")
        digits = max(digits, len(re.sub(r"[+\-.]", "", plain.partition("e")[0]).lstrip("0")))
        largest = max(largest, abs(float(plain or 0.0))) if _is_number(plain, comma=False) else largest
    if not 0.0 < largest < 1e300:
        return 0.0
    return float(f"1e{math.floor(math.log10(largest)) + 1 - digits}")


def _statements(path: Path, remarks: Sequence[tuple[int, str]], names: Sequence[str]) -> Given:
    """Sample rate, speed and bearing given in comments; numbers without unit are in Hz, steps in s."""
    found = Statements()
    for k, line in remarks:
        pair = _KEY_VALUE.fullmatch(line.lstrip("#%/ \t").strip())
        if not pair:
            continue
        name, unit = split_name(pair[1])
        text = pair[2].strip()
        used = found.text(name, f"{text} {unit}") or found.text(name, text)
        if is_rate(name) and not (used and found.on(names, names).rates):
            remedy = "correct the comment or delete it"
            raise refused(
                path, name, repr(text), "is not a sample rate", "such as 12.8 kHz", remedy, line=k + 1
            )
    return found.on(names, names)
