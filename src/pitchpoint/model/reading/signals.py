# SPDX-License-Identifier: Apache-2.0
"""Readers of signal values and gains: numbers in SI units of any dimension.

A given unit converts the number to SI units. It is not checked, because the dimensions of the signals are
unknown.
"""

from __future__ import annotations

from collections.abc import Mapping
from numbers import Real
from typing import TYPE_CHECKING, Any

from pitchpoint.model.keys import BAD, Key, Place
from pitchpoint.model.reading import data_files, laws
from pitchpoint.model.reading.bare_numbers import note_signal
from pitchpoint.model.reading.formula_text import WORDS
from pitchpoint.model.show import shown

if TYPE_CHECKING:
    from pitchpoint.model.reading.reader import Reader

REMEDY = "write a number in SI units, or one with its unit such as 1500 rpm"
NUMBER = Key("quantity", "", dimension="dimensionless")
ANY = Key("quantity", "")


def value(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a number, or a text such as `1500 rpm` or `2*pi*5` whose value in SI is the number."""
    from pitchpoint.core.formula.formula import FormulaError, constant

    if isinstance(data, Real) and not isinstance(data, bool):
        number = reader.number(NUMBER, data, path)
        if number is not BAD:
            note_signal(reader, ANY, data, number, path)
        return number
    if not isinstance(data, str):
        return reader.problem(
            path, "is empty" if data is None else "is not a number", value=_text_of(data), remedy=REMEDY
        )
    if reader.unreadable.intersection(WORDS.findall(data)):
        return reader.taint(path)
    try:
        amount, used = constant(data, "", reader.parameters)
    except FormulaError as error:
        return reader.problem(path, f"cannot be read: {error}", remedy=REMEDY)
    reader.used |= used
    note_signal(reader, ANY, data, amount.value, path)
    return amount.value


def _text_of(data: Any) -> str | None:
    return None if data is None else shown(data)


def values(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a list of signal values."""
    low, high = key.length
    if isinstance(data, list | tuple) and low == high != len(data):
        return reader.problem(path, f"has {len(data)} entries", limit=f"{low} entries")
    return reader.sequence(key, data, path, lambda k, entry, at: value(reader, k, entry, at))


def gains(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a mapping of signal names to gains."""
    if not isinstance(data, Mapping):
        return reader.problem(
            path, "is not a mapping of names to numbers", value=shown(data), remedy="write {speed: -1}"
        )
    found = {str(name): value(reader, key, given, (*path, str(name))) for name, given in data.items()}
    return BAD if any(v is BAD for v in found.values()) else found


def records(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a mapping of records of a controller library to names of signals or numbers."""
    if not isinstance(data, Mapping):
        return reader.problem(
            path,
            "is not a mapping of records",
            value=shown(data),
            remedy="write {generator_speed: SIGNAL}, or {power_demand: 5 MW} for a constant number",
        )
    found = {}
    for name, given in data.items():
        is_name = isinstance(given, str) and (given[:1].isalpha() or given[:1] == "_")
        found[str(name)] = given if is_name else value(reader, key, given, (*path, str(name)))
    return BAD if any(v is BAD for v in found.values()) else found


def record_signals(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a mapping of records of a controller library to names of its output signals."""
    remedy = "write {generator_torque_demand: SIGNAL}"
    if not isinstance(data, Mapping) or len(data) < key.length[0]:
        return reader.problem(path, "is not a mapping of records", value=shown(data), remedy=remedy)
    text = Key("text", "")
    found = {str(name): reader.string(text, given, (*path, str(name))) for name, given in data.items()}
    return BAD if any(v is BAD for v in found.values()) else found


def wires(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a mapping of variables of another program to signals."""
    if not isinstance(data, Mapping):
        return reader.problem(
            path, "is not a mapping of variables to signals", value=shown(data), remedy="write {w: speed}"
        )
    found = {str(name): reader.string(key, given, (*path, str(name))) for name, given in data.items()}
    return BAD if any(v is BAD for v in found.values()) else found


def curve(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read rows [input, value] with increasing inputs, or a text file with two columns."""
    if isinstance(data, str):
        lines = data_files.lines(reader, data, path, "a list of rows")
        if lines is BAD:
            return BAD
        known = len(reader.bare)
        found = curve(reader, key, [cells for _, cells in lines], path)
        reader.bare[known:] = reader.bare[known:][-2:]  # one remark on a file
        return found
    if not isinstance(data, list | tuple) or len(data) < 2:
        return reader.problem(
            path, "is not a list of at least two rows", value=shown(data), remedy="write [[0, 0], [10, 2]]"
        )
    points = []
    for i, row in enumerate(data):
        if not isinstance(row, list | tuple) or len(row) != 2:
            reader.problem((*path, i), "is not a row of two values", remedy="write [input, value]")
            continue
        first = reader.number(key, row[0], (*path, i, 0)) if key.dimension else None
        point = tuple(
            value(reader, key, x, (*path, i, k)) if k or first is None else first for k, x in enumerate(row)
        )
        if BAD not in point:
            points.append(point)
    if len(points) < len(data):
        return BAD
    for i in range(1, len(points)):
        if not points[i][0] > points[i - 1][0]:
            return reader.problem(
                (*path, i), "does not have a larger input than the previous row", remedy="sort the rows"
            )
    return tuple(points)


def code(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read FILE.py:function; parameters have a separate key."""
    if isinstance(data, Mapping):
        return reader.problem(
            path,
            "is a mapping",
            remedy="write function: FILE.py:function, and its numbers under parameters next to it",
        )
    return laws.python(reader, key, data, path)
