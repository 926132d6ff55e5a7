# SPDX-License-Identifier: Apache-2.0
"""Import of finite-element matrices: Nastran DMIG punch files and NumPy archives.

The result is a `Structure` for modal reduction. Files are untrusted: sizes are checked before memory is
allocated, nothing is executed, and errors are reported with the line number.

Matrix Market files are read by `matrix_market`. DMIG: MSC Nastran Quick Reference Guide, bulk data entries
DMIG and GRID; fixed fields of 8 characters, or of 16 characters if the entry name ends with an asterisk.
"""

from __future__ import annotations

import os
import re
import zipfile
import zlib
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.multibody.structure import Structure, make_structure

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from scipy.sparse import coo_array

MAX_BYTES = 2_000_000_000
"""Maximum size of a file, and of an array in an archive [byte]."""
MAX_ENTRIES = 200_000_000
MAX_UNKNOWNS = 2_000_000

SYMMETRIC, SQUARE = 6, 1
FIELDS = "write fixed fields of 8 or 16 characters"
_NUMBER = re.compile(r"^[+-]?(\d+\.?\d*|\.\d+)([eEdD][+-]?\d+|[+-]\d+)?$")


@dataclass
class DmigFile:
    """Content of a punch file.

    Parameters
    ----------
    matrices
        Entries of each matrix by name: {(row, column): value} with rows and columns as (grid, component 1-6;
        0 for scalar points).
    symmetric
        Names of the matrices stored as one triangle.
    grids
        Positions of the grid points listed in the file, in the basic system [unit of the file].
    """

    matrices: dict[str, dict[tuple[tuple[int, int], tuple[int, int]], float]] = field(default_factory=dict)
    symmetric: set[str] = field(default_factory=set)
    grids: dict[int, tuple[float, float, float]] = field(default_factory=dict)

    def displacements(self) -> list[tuple[int, int]]:
        """Sorted list of all (grid, component) of the matrices."""
        return sorted({d for m in self.matrices.values() for pair in m for d in pair})

    def matrix(self, name: str, order: Sequence[tuple[int, int]]) -> coo_array:
        """One matrix with both triangles, rows and columns in the given order of displacements."""
        from scipy.sparse import coo_array

        at = {d: k for k, d in enumerate(order)}
        rows, columns, values = [], [], []
        for (r, c), value in self.matrices[name].items():
            rows.append(at[r])
            columns.append(at[c])
            values.append(value)
            if name in self.symmetric and r != c:
                rows.append(at[c])
                columns.append(at[r])
                values.append(value)
        return coo_array((values, (rows, columns)), shape=(len(order), len(order)))


def refuse(path: Path, message: str, line: int | None = None, remedy: str | None = None) -> ModelError:
    """Error for a file and, if known, a line."""
    return ModelError([Message("", message, line=line, remedy=remedy)], str(path))


def checked(path: str | os.PathLike[str]) -> Path:
    """Path of an existing file that is not too large."""
    file = Path(path)
    if not file.is_file():
        raise refuse(file, "file not found")
    if file.stat().st_size > MAX_BYTES:
        raise refuse(
            file, f"{file.stat().st_size} bytes (limit {MAX_BYTES})", remedy="reduce the model first"
        )
    return file


def _lines(file: Path) -> Iterator[tuple[int, str]]:
    """Lines with their numbers, without comments and empty lines."""
    with file.open(encoding="ascii", errors="replace") as text:
        number = 0
        while True:
            line = text.readline(4096)  # bounds the memory for files without line breaks
            if not line:
                return
            number += 1
            if len(line) >= 4096:
                raise refuse(file, "is not a text file with lines of 80 characters", number)
            if line.strip() and not line.startswith("$"):
                yield number, line.rstrip("\r\n")


def _fields(line: str) -> list[str]:
    """Fields of a fixed-format entry after its name: eight of 8 characters or four of 16."""
    if "*" in line[:8]:
        return [line[k : k + 16].strip() for k in (8, 24, 40, 56)]
    return [line[k : k + 8].strip() for k in range(8, 72, 8)]


def _whole(file: Path, number: int, text: str, what: str) -> int:
    if not re.fullmatch(r"\d{1,9}", text):
        raise refuse(file, f"{what}: {text!r} is not a whole number", number, FIELDS)
    return int(text)


def real(file: Path, number: int, text: str, what: str, remedy: str = FIELDS) -> float:
    """Number in Nastran format: 1.0+5 and 1.0D+05 are 1e5."""
    if not _NUMBER.match(text):
        raise refuse(file, f"{what}: {text!r} is not a number", number, remedy)
    plain = text.upper().replace("D", "E")
    if "E" not in plain:
        plain = plain[0] + re.sub(r"([+-])", r"E\1", plain[1:])
    value = float(plain)
    if not np.isfinite(value):
        raise refuse(file, f"{what}: {text} is not finite", number)
    return value


def read_dmig(path: str | os.PathLike[str]) -> DmigFile:
    """Read the real matrices and grid points of a Nastran punch file.

    Parameters
    ----------
    path
        File with DMIG entries and, optionally, GRID entries for the positions.

    Raises
    ------
    ModelError
        If the file is missing or an entry cannot be read; with its line.
    """
    file = checked(path)
    found = DmigFile()
    column: tuple[str, tuple[int, int]] | None = None
    grid: tuple[int, list[str]] | None = None
    count = 0
    for number, line in _lines(file):
        word = line[:8].strip().rstrip("*").upper()
        if word == "DMIG":
            grid, column = None, _dmig(file, number, line, found)
        elif word == "GRID":
            column, grid = None, _grid(file, number, line, found)
        elif line[0] in "*+ " and column is not None:
            _term(file, number, line, found, column)
            count += 1
            if count > MAX_ENTRIES:
                raise refuse(file, f"more than {MAX_ENTRIES} entries", number)
        elif line[0] in "*+ " and grid is not None:
            third = real(file, number, line[8:24].strip() or "0.", "x3")
            first, second = (real(file, number, t or "0.", "GRID") for t in grid[1])
            found.grids[grid[0]] = (first, second, third)
            grid = None
        else:
            column = grid = None  # other entries are ignored
    if not found.matrices:
        raise refuse(file, "has no DMIG matrix", remedy="punch K and M with PARAM,EXTOUT,DMIGPCH")
    return found


def _dmig(file: Path, number: int, line: str, found: DmigFile) -> tuple[str, tuple[int, int]] | None:
    """Read the header of a matrix, or the start of a column, which is returned."""
    fields = _fields(line)
    name = fields[0].upper()
    if not re.fullmatch(r"[A-Z][A-Z0-9]{0,7}", name):
        raise refuse(file, f"DMIG: {fields[0]!r} is not a matrix name", number)
    large = "*" in line[:8]
    if not large and fields[1] == "0":
        form, kind = _whole(file, number, fields[2], "form"), _whole(file, number, fields[3], "type")
        if form not in (SYMMETRIC, SQUARE):
            raise refuse(file, f"{name}: form {form} (limit 1 square or 6 symmetric)", number)
        if kind not in (1, 2):
            raise refuse(file, f"{name}: type {kind} is complex (limit 1 or 2, real)", number)
        found.matrices.setdefault(name, {})
        if form == SYMMETRIC:
            found.symmetric.add(name)
        return None
    if name not in found.matrices:
        raise refuse(file, f"{name}: a column precedes the header of the matrix", number)
    column = (_whole(file, number, fields[1], "grid"), _component(file, number, fields[2]))
    if not large and fields[4]:
        _put(file, number, found, (name, column), fields[4:7])
    return name, column


def _component(file: Path, number: int, text: str) -> int:
    value = _whole(file, number, text or "0", "component")
    if value > 6:
        raise refuse(file, f"component {value} (limit 0 to 6)", number)
    return value


def _put(
    file: Path, number: int, found: DmigFile, column: tuple[str, tuple[int, int]], fields: Sequence[str]
) -> None:
    name, at = column
    row = (_whole(file, number, fields[0], "grid"), _component(file, number, fields[1]))
    entries = found.matrices[name]
    if (row, at) in entries or (name in found.symmetric and (at, row) in entries):
        raise refuse(file, f"{name}: the entry of {row} and {at} is listed twice", number)
    entries[row, at] = real(file, number, fields[2], "value")


def _term(file: Path, number: int, line: str, found: DmigFile, column: tuple[str, tuple[int, int]]) -> None:
    """Read a continuation line: grid, component, value."""
    fields = _fields(line)
    if "*" in line[:8]:
        _put(file, number, found, column, fields[:3])
        return
    for first in (0, 4):
        if fields[first]:
            _put(file, number, found, column, fields[first : first + 3])


def _grid(file: Path, number: int, line: str, found: DmigFile) -> tuple[int, list[str]] | None:
    """Read a grid point; returns grid and first coordinates if a second line follows."""
    fields = _fields(line)
    grid = _whole(file, number, fields[0], "grid")
    if fields[1] not in ("", "0"):
        raise refuse(
            file,
            f"GRID {grid}: uses the coordinate system {fields[1]}",
            number,
            "give positions in the basic system",
        )
    if "*" in line[:8]:
        return grid, fields[2:4]
    x, y, z = (real(file, number, t or "0.", "GRID") for t in fields[2:5])
    found.grids[grid] = (x, y, z)
    return None


def structure_from_dmig(
    file: DmigFile,
    stiffness: str = "KAAX",
    mass: str = "MAAX",
    places: dict[int, Sequence[float]] | None = None,
) -> tuple[Structure, list[int]]:
    """Structure from two matrices of a punch file, and the grid numbers of its nodes.

    Parameters
    ----------
    file
        Result of `read_dmig`.
    stiffness, mass
        Names of the matrices.
    places
        Positions of grid points that are not in the file, by number [m].

    Raises
    ------
    ModelError
        If a matrix or a position is missing, or a displacement is a scalar point.
    """
    for name in (stiffness, mass):
        if name not in file.matrices:
            listed = ", ".join(sorted(file.matrices))
            raise ModelError([Message(name, "matrix not found", remedy=f"the file contains: {listed}")])
    order = file.displacements()
    scalar = [g for g, c in order if c == 0]
    if scalar:
        what = "is a scalar point without position"
        raise ModelError([Message(f"point {scalar[0]}", what, remedy="reduce to grid points only")])
    nodes = sorted({g for g, _ in order})
    known: dict[int, Any] = {**file.grids, **(places or {})}
    missing = [g for g in nodes if g not in known]
    if missing:
        remedy = "add GRID entries to the file or give `places`"
        raise ModelError([Message(f"grid {missing[0]}", "has no position", remedy=remedy)])
    number = {g: k for k, g in enumerate(nodes)}
    structure = make_structure(
        file.matrix(stiffness, order),
        file.matrix(mass, order),
        [known[g] for g in nodes],
        [number[g] for g, _ in order],
        [c - 1 for _, c in order],
    )
    return structure, nodes


_DAMAGE = (ValueError, OSError, EOFError, LookupError, MemoryError, RuntimeError, TypeError, SyntaxError)
"""Exceptions that NumPy raises for damaged archives; it parses array headers as Python literals."""


def read_npz(path: str | os.PathLike[str]) -> Structure:
    """Read a NumPy archive with K, M, places and, if nodes have different directions, node and direction.

    Parameters
    ----------
    path
        File written by `numpy.savez` with dense K and M, or with K_data, K_indices, K_indptr in compressed
        sparse column format (M likewise); optionally K_spin (see `Structure`).

    Raises
    ------
    ModelError
        If an array is missing, contains objects, or is too large.
    """
    file = checked(path)
    try:
        with zipfile.ZipFile(file) as archive:
            for item in archive.infolist():
                if item.file_size > MAX_BYTES:
                    raise refuse(file, f"{item.filename}: {item.file_size} bytes (limit {MAX_BYTES})")
        with np.load(file, allow_pickle=False) as arrays:
            data = {name: np.asarray(arrays[name]) for name in arrays.files}
    except (*_DAMAGE, zipfile.BadZipFile, zlib.error) as error:
        raise refuse(file, f"is not an archive of plain arrays ({error})") from None
    if "places" not in data:
        raise refuse(file, "has no array 'places'", remedy="add the nodes (number of nodes, 3) in m")
    found = {name: _matrix(file, data, name) for name in ("K", "M")}
    if "K_spin" in data or "K_spin_data" in data:
        found["K_spin"] = _matrix(file, data, "K_spin")
    for name, array in data.items():
        if array.dtype.kind not in "fiu":
            raise refuse(file, f"{name}: does not contain real numbers")
    node, direction = data.get("node"), data.get("direction")
    return make_structure(found["K"], found["M"], data["places"], node, direction, found.get("K_spin"))


def _matrix(file: Path, data: dict[str, Any], name: str) -> Any:
    """One matrix of an archive, dense or in compressed sparse column format."""
    from scipy.sparse import csc_array

    parts = [f"{name}_{p}" for p in ("data", "indices", "indptr")]
    if name in data:
        return data[name]
    if not all(p in data for p in parts):
        raise refuse(file, f"has no matrix {name!r}", remedy=f"save {name}, or {', '.join(parts)}")
    n = data[parts[2]].size - 1
    try:
        arrays_of: Any = tuple(data[p] for p in parts)
        matrix = csc_array(arrays_of, shape=(n, n))
        matrix.check_format()
    except (ValueError, TypeError) as error:
        raise refuse(file, f"{name}: inconsistent arrays ({error})") from None
    return matrix
