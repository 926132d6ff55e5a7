# SPDX-License-Identifier: Apache-2.0
"""Readers of text files named in a model file: columns, grids, tooth profiles."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import GeometryError, UnitError
from pitchpoint.core.units import parse_quantity
from pitchpoint.model.components.modifications import FlankPitch
from pitchpoint.model.components.tooth_profile import Points, ToothProfile
from pitchpoint.model.keys import BAD, Key, Place
from pitchpoint.model.reading.bare_numbers import Bare, is_doubtful
from pitchpoint.model.show import shown

if TYPE_CHECKING:
    from pitchpoint.model.reading.reader import Reader

_MAX_BYTES = 10_000_000
_SEPARATOR = re.compile(r"[,;\t]")
_NUMBER = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?|[+-]?(?:nan|inf)", re.IGNORECASE)
_HEADING = re.compile(r"([^\[\]]*)\[([^\[\]]+)\]")
_SHOWN = 5
"""Maximum number of bad lines of a file that are reported individually."""

Line = tuple[int, list[str]]
"""Line number and cells of a line."""


def lines(reader: Reader, name: str, path: Place, instead: str) -> Any:
    """Cells of every non-empty line of a text file; '#' starts a comment. BAD if it cannot be read."""
    file = Path(reader.directory) / name
    try:
        if not file.is_file():
            return reader.problem(path, f"there is no file '{name}'", remedy=f"give {instead}")
        if file.stat().st_size > _MAX_BYTES:
            return reader.problem(path, f"the file '{name}' is larger than 10 MB", remedy="split it")
        with file.open(encoding="utf-8-sig") as stream:
            found = [(n, line.split("#")[0].strip()) for n, line in enumerate(stream, start=1)]
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not a text file"
        return reader.problem(path, f"the file '{name}' cannot be read: {reason}", remedy=f"give {instead}")
    return [(n, _cells(text)) for n, text in found if text]


def _cells(text: str) -> list[str]:
    """Cells separated by commas, semicolons or tabs; plain numbers may be separated by blanks."""
    parts = text.split()
    if not _SEPARATOR.search(text) and all(_NUMBER.fullmatch(part) for part in parts):
        return parts
    return [cell.strip() for cell in _SEPARATOR.split(text)]


def _quantities(
    reader: Reader, name: str, found: list[Line], dimensions: tuple[str, ...], path: Place
) -> Any:
    """Quantities of all lines; a first line such as 'f_p [um]' gives the units of bare numbers.

    `dimensions` is that of all cells, or of each column.
    """
    units = [""]
    headings = [_HEADING.fullmatch(cell) for cell in found[0][1]] if found else []
    if headings and all(headings) and len(headings) == len(dimensions):
        units, found = [f" {match[2]}" for match in headings if match], found[1:]
    rows: list[list[float]] = []
    faults = 0
    for number, cells in found:
        try:
            if len(dimensions) > 1 and len(cells) != len(dimensions):
                raise UnitError(f"there are {len(cells)} values instead of {len(dimensions)}")
            row = []
            for k, cell in enumerate(cells):
                bare = _NUMBER.fullmatch(cell)
                unit, dimension = units[k % len(units)], dimensions[k % len(dimensions)]
                row.append(parse_quantity(f"{cell}{unit}" if bare else cell, dimension))
            rows.append(row)
        except UnitError as error:
            faults += 1
            if faults <= _SHOWN:
                remedy = "write numbers separated by commas or blanks; a first line [um] gives the unit"
                if len(dimensions) > 1:
                    remedy = (
                        "write two values in each line; a first line angle [deg], torque [N m] gives units"
                    )
                reader.problem(path, f"{error} (file '{name}', line {number})", remedy=remedy)
    if faults > _SHOWN:
        reader.problem(path, f"there are {faults - _SHOWN} more such lines in '{name}'")
    return BAD if faults else rows


def pairs(reader: Reader, name: str, dimensions: tuple[str, str], path: Place) -> Any:
    """Read a text file with two quantities per line: abscissa in increasing order, and value."""
    found = lines(reader, name, path, "a list of rows")
    rows = BAD if found is BAD else _quantities(reader, name, found, dimensions, path)
    if rows is BAD:
        return BAD
    if len(rows) < 2:
        return reader.problem(path, f"the file '{name}' has fewer than two rows", remedy="give at least two")
    for (number, _), before, after in zip(found[-len(rows) + 1 :], rows, rows[1:], strict=False):
        if not after[0] > before[0]:
            problem = f"line {number} of '{name}' is not larger than the line before in its first value"
            return reader.problem(path, problem, remedy="sort the table")
    largest = rows[-1][0]
    without = len(found) == len(rows) and _NUMBER.fullmatch(found[-1][1][0]) is not None
    if without and is_doubtful(largest, dimensions[0]):
        reader.bare.append(Bare(path, largest, dimensions[0]))
    return rows


def increasing_rows(
    reader: Reader,
    rows: Any,
    at: Place,
    read: Callable[[int, Any, Place], Any],
    over: str,
    example: str,
) -> Any:
    """Read rows of two values with increasing first values; BAD with any problem.

    Parameters
    ----------
    reader
        Collects the problems.
    rows, at
        The rows and their path.
    read
        Reader of a value: its column, the value and its path.
    over
        What the first values are, for messages.
    example
        Valid rows, for messages.
    """
    if not isinstance(rows, list | tuple) or len(rows) < 2:
        remedy = f"write {example}"
        return reader.problem(at, "is not a list of at least two rows", value=shown(rows), remedy=remedy)
    points = []
    for i, row in enumerate(rows):
        if not isinstance(row, list | tuple) or len(row) != 2:
            reader.problem((*at, i), "is not a row of two values", remedy=f"write [{over}, value]")
            continue
        point = (read(0, row[0], (*at, i, 0)), read(1, row[1], (*at, i, 1)))
        if BAD not in point:
            points.append(point)
    if len(points) != len(rows):
        return BAD
    for i in range(1, len(points)):
        if not points[i][0] > points[i - 1][0]:
            text = f"is not larger in {over} than the previous row"
            return reader.problem((*at, i), text, remedy="sort the rows")
    return points


def column(reader: Reader, key: Key, name: str, path: Place) -> Any:
    """Read a text file with one quantity per line, or several."""
    found = lines(reader, name, path, "a list of quantities")
    if found is BAD:
        return BAD
    rows = _quantities(reader, name, found, (key.dimension,), path)
    return BAD if rows is BAD else [cell for row in rows for cell in row]


def grid(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a rectangular list of lists of quantities, or a text file with one row per line."""
    in_file = isinstance(data, str)
    if in_file:
        found = lines(reader, data, path, "a list of rows")
        data = BAD if found is BAD else _quantities(reader, data, found, (key.dimension,), path)
        if data is BAD:
            return BAD
    row = Key("quantities", "", dimension=key.dimension, length=(1, 10**6))
    known = len(reader.bare)
    rows = reader.sequence(row, data, path, reader.numbers)
    if in_file:
        del reader.bare[known:]  # the file has a unit
    if rows is BAD:
        return BAD
    if len({len(r) for r in rows}) != 1:
        return reader.problem(path, "has rows of different length", remedy="give every row the same length")
    return rows


def pitch(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read deviations for both flanks (a list or the name of a file), or a mapping of left and right."""
    if isinstance(data, Mapping | FlankPitch):
        return reader.component(key.of, data, path)
    return reader.numbers(key, data, path)


def tooth_profile(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read the points of a tooth profile and select those of the tooth `number`; check the order of all."""
    found = reader.component(ToothProfile, data, path)
    if found is BAD:
        return BAD
    chosen: ToothProfile = found.of_number()
    empty = [n for n in chosen.given if getattr(found, n).teeth and not getattr(chosen, n).xy]
    for name in empty:
        source = getattr(found, name)
        reader.problem(
            (*path, name),
            f"has no points of the tooth {found.number} in '{source.file}'",
            limit=f"{min(source.teeth)} to {max(source.teeth)}",
            remedy="set number to a tooth of the file",
        )
    if empty:
        return BAD
    try:
        found.check_teeth()
    except GeometryError as error:
        return reader.hand_on(path[:-1], error.problem)
    return chosen


def points(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read points of an outline: the name of a CSV file, or a list of [x, y]."""
    if isinstance(data, str):
        found = lines(reader, data, path, "a list of [x, y]")
        return BAD if found is BAD else _from_file(reader, data, found, path)
    if isinstance(data, Points):
        return data
    number = Key("quantity", "", dimension="length")
    pair = Key("quantities", "", dimension="length", length=(2, 2))
    if not isinstance(data, list | tuple):
        return reader.problem(
            path, "are not points", value=shown(data), remedy="name a CSV file, or give [[x, y], ...]"
        )
    rows = [
        reader.sequence(pair, row, (*path, i), lambda _, v, at: reader.number(number, v, at))
        for i, row in enumerate(data)
    ]
    return BAD if any(row is BAD for row in rows) else Points(tuple(rows))


def _from_file(reader: Reader, name: str, found: list[Line], path: Place) -> Any:
    heading = _columns(reader, name, found, path)
    if heading is BAD:
        return BAD
    places, scales = heading
    xy, numbers, teeth = [], [], []
    faults = 0
    for number, cells in found[1:]:
        try:
            point = [float(cells[places[c]]) * scales[c] for c in "xy"]
            tooth = int(cells[places["tooth"]]) if "tooth" in places else 0
            if not all(math.isfinite(v) for v in point):
                raise ValueError
        except (ValueError, IndexError):
            faults += 1
            if faults <= _SHOWN:
                reader.problem(
                    path,
                    f"is not a point (file '{name}', line {number})",
                    value=shown(",".join(cells)),
                    remedy="give finite numbers with a decimal point, in the units of the header",
                )
            continue
        xy.append((point[0], point[1]))
        numbers.append(number)
        teeth.append(tooth)
    if faults > _SHOWN:
        reader.problem(path, f"there are {faults - _SHOWN} more such lines in '{name}'")
    if faults:
        return BAD
    return Points(tuple(xy), name, tuple(numbers), tuple(teeth) if "tooth" in places else ())


def _columns(reader: Reader, name: str, found: list[Line], path: Place) -> Any:
    """Indices of the columns x, y and optionally tooth; factors of x and y to metres."""
    number, cells = found[0] if found else (1, [])
    here = f"(file '{name}', line {number})"
    places: dict[str, int] = {}
    scales: dict[str, float] = {}
    for i, cell in enumerate(cells):
        match = _HEADING.fullmatch(cell)
        word = (match[1] if match else cell).strip().lower()
        if word not in ("x", "y", "tooth"):
            continue
        if word in places:
            return reader.problem(path, f"has two columns {word} {here}", remedy="remove one")
        places[word] = i
        if match and word != "tooth":
            try:
                scales[word] = parse_quantity(f"1 {match[2].strip()}", "length")
            except UnitError:
                return reader.problem(
                    path,
                    f"is not a unit of length {here}",
                    value=shown(match[2]),
                    remedy="write mm, um, m or inch",
                )
    if not {"x", "y"} <= set(places) or set(scales) != {"x", "y"}:
        return reader.problem(
            path,
            f"has no header line with column names and units {here}",
            value=shown(",".join(cells)),
            remedy="begin with x [mm],y [mm]",
        )
    return places, scales
