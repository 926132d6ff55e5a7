# SPDX-License-Identifier: Apache-2.0
"""Readers of signal values and gains: numbers in SI units of any dimension.

A given unit converts the number to SI units. It is not checked, because the dimensions of the signals are
unknown.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
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


def mapping(
    reader: Reader,
    key: Key,
    data: Any,
    path: Place,
    read: Callable[..., Any],
    what: str = "names",
    remedy: str = "",
) -> Any:
    """Read a mapping entry by entry; `what` it maps is part of the message."""
    if not isinstance(data, Mapping):
        return reader.problem(path, f"is not a mapping of {what}", value=shown(data), remedy=remedy)
    found = {str(name): read(reader, key, given, (*path, str(name))) for name, given in data.items()}
    return BAD if any(v is BAD for v in found.values()) else found


def gains(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a mapping of signal names to gains."""
    return mapping(reader, key, data, path, value, "names to numbers", "write {speed: -1}")


def records(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a mapping of records of a controller library to names of signals or numbers."""

    def read(reader: Reader, key: Key, given: Any, at: Place) -> Any:
        """Name of a signal, or a number."""
        is_name = isinstance(given, str) and (given[:1].isalpha() or given[:1] == "_")
        return given if is_name else value(reader, key, given, at)

    remedy = "write {generator_speed: SIGNAL}, or {power_demand: 5 MW} for a constant number"
    return mapping(reader, key, data, path, read, "records", remedy)


def record_signals(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a mapping of records of a controller library to names of its output signals."""
    remedy = "write {generator_torque_demand: SIGNAL}"
    if data == {}:
        return reader.problem(path, "is empty", remedy=remedy)
    return mapping(reader, key, data, path, _name, "records", remedy)


def wires(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a mapping of variables of another program to signals."""
    return mapping(reader, key, data, path, _name, "variables to signals", "write {w: speed}")


def _name(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read the name of a signal."""
    return reader.string(key, data, path)


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

    def read(column: int, cell: Any, place: Place) -> Any:
        """Value of a column."""
        if key.dimension and not column:
            return reader.number(key, cell, place)
        return value(reader, key, cell, place)

    rows = data_files.increasing_rows(reader, data, path, read, "input", "[[0, 0], [10, 2]]")
    return BAD if rows is BAD else tuple(rows)


def code(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read FILE.py:function; parameters have a separate key."""
    if isinstance(data, Mapping):
        return reader.problem(
            path,
            "is a mapping",
            remedy="write function: FILE.py:function, and its numbers under parameters next to it",
        )
    return laws.python(reader, key, data, path)
