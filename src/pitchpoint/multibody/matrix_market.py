# SPDX-License-Identifier: Apache-2.0
"""Import of a finite-element body from Matrix Market files and a node table.

Boisvert, Pozo, Remington, The Matrix Market exchange formats, NISTIR 5935 (1996).
"""

from __future__ import annotations

import gzip
import os
import re
import warnings
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import IO, Any, cast

import numpy as np

from pitchpoint.multibody.fe_matrices import MAX_ENTRIES, MAX_UNKNOWNS, checked, real, refuse
from pitchpoint.multibody.structure import Structure, make_structure

LAYOUTS = ("coordinate", "array")
LONGEST = 4096
"""Maximum length of a text line [byte]."""
COLUMNS = "write x y z in m, and the digits of the displacements such as 123 if nodes differ"


def read_matrix_market(path: str | os.PathLike[str]) -> Any:
    """Read a real square matrix from a Matrix Market file as a sparse matrix.

    Parameters
    ----------
    path
        File in coordinate or array format, general or symmetric, plain or compressed as ``.gz``.

    Raises
    ------
    ModelError
        If the file is not a valid Matrix Market file or is too large.

    Notes
    -----
    `scipy.io.mmread` of SciPy 1.16 is not used because it crashes the process on some damaged files.
    """
    from scipy.sparse import csc_array

    file = checked(path)
    try:
        with cast(IO[bytes], gzip.open(file) if file.suffix == ".gz" else file.open("rb")) as text:
            n, i, j, values, symmetric = _body(file, _short_lines(file, text))
    except (ValueError, EOFError, OSError, zlib.error, MemoryError) as error:
        raise refuse(file, f"cannot be read ({error})") from None
    if not np.all(np.isfinite(values)):
        raise refuse(file, "has entries that are not finite")
    if symmetric:
        off = i != j
        i, j, values = (
            np.concatenate([i, j[off]]),
            np.concatenate([j, i[off]]),
            np.concatenate([values, values[off]]),
        )
    return csc_array((values, (i, j)), shape=(n, n))


def _short_lines(file: Path, text: IO[bytes]) -> Iterator[str]:
    """Non-empty lines; comments after the first line are omitted."""
    number = 0
    while line := text.readline(LONGEST):
        number += 1
        if len(line) >= LONGEST or b"\0" in line:
            raise refuse(file, f"is not a text file with lines below {LONGEST} bytes", number)
        if line.strip() and (number == 1 or not line.startswith(b"%")):
            yield line.decode("ascii", "replace")


def _body(file: Path, lines: Iterator[str]) -> tuple[int, Any, Any, Any, bool]:
    """Number of rows; row indices, column indices and values of the entries; whether it is symmetric."""
    words = next(lines, "").lower().split()
    if len(words) != 5 or " ".join(words[:2]) != "%%matrixmarket matrix" or words[2] not in LAYOUTS:
        raise refuse(
            file,
            "is not a Matrix Market file",
            1,
            "the first line must be like %%MatrixMarket matrix coordinate real symmetric",
        )
    layout, kind, symmetry = words[2:]
    if kind not in ("real", "integer") or symmetry not in ("general", "symmetric"):
        raise refuse(file, f"is {kind} and {symmetry} (limit real, general or symmetric)", 1)
    size = next(lines, "").split()
    count = 3 if layout == "coordinate" else 2
    if len(size) != count or not all(re.fullmatch(r"\d{1,12}", w) for w in size):
        raise refuse(file, f"has no line of {count} sizes after its first", remedy="write rows and columns")
    rows, columns = int(size[0]), int(size[1])
    symmetric = symmetry == "symmetric"
    whole = rows * (rows + 1) // 2 if symmetric else rows * columns
    entries = int(size[2]) if layout == "coordinate" else whole
    if rows != columns or not 0 < rows <= MAX_UNKNOWNS or entries > MAX_ENTRIES:
        raise refuse(file, f"{rows} x {columns} with {entries} entries (limit square, {MAX_UNKNOWNS} rows)")
    # an entry has at least two characters; compressed files are checked after reading
    if file.suffix != ".gz" and 2 * entries > file.stat().st_size + 1:
        raise refuse(file, f"its header specifies {entries} entries in {file.stat().st_size} bytes")
    found = np.zeros((0, 1))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # files without entries
        found = np.loadtxt(lines, ndmin=2, max_rows=entries + 1, comments=None)
    if len(found) != entries or (entries and found.shape[1] != (3 if layout == "coordinate" else 1)):
        shown = "x".join(map(str, found.shape))
        raise refuse(file, f"its header specifies {entries} entries, but it has {shown} numbers")
    if layout == "coordinate":
        at = found.reshape(entries, 3)[:, :2]
        if np.any((at < 1) | (at > rows) | (at != np.floor(at))):
            wrong = int(np.argmax(np.any((at < 1) | (at > rows) | (at != np.floor(at)), axis=1)))
            place = f"{at[wrong, 0]:g}, {at[wrong, 1]:g}"
            raise refuse(file, f"entry {wrong + 1} has the indices {place} (limit 1 to {rows})")
        i, j = (at.astype(np.int64) - 1).T
        return rows, i, j, found.reshape(entries, 3)[:, 2], symmetric
    if symmetric:  # the lower triangle by columns
        j, i = np.triu_indices(rows)
    else:
        j, i = (x.ravel() for x in np.indices((rows, rows)))
    return rows, i, j, found[:, 0], symmetric


def read_places(path: str | os.PathLike[str]) -> tuple[Any, Any, Any]:
    """Read a node table: x y z in m per line, and the digits of the displacements if nodes differ.

    Parameters
    ----------
    path
        Text file; numbers are separated by blanks, tabs, commas or semicolons, comments begin with # or %.

    Returns
    -------
    places, node, direction
        Positions (nodes, 3) [m]; node and direction of every displacement as in `Structure`, None without
        digits.

    Raises
    ------
    ModelError
        If a line is not a node, or only some lines have digits.
    """
    file = checked(path)
    places, digits = [], []
    with file.open(encoding="utf-8", errors="replace") as text:
        number = 0
        while line := text.readline(4096):
            number += 1
            if len(line) >= 4096:
                raise refuse(file, "is not a node table", number)
            words = re.split(r"[#%]", line)[0].replace(",", " ").replace(";", " ").split()
            if not words:
                continue
            if len(words) not in (3, 4):
                raise refuse(file, f"has {len(words)} numbers in a line", number, COLUMNS)
            places.append([real(file, number, w, "position", COLUMNS) for w in words[:3]])
            digits.append(_directions(file, number, words[3]) if len(words) == 4 else ())
            if bool(digits[-1]) != bool(digits[0]):
                raise refuse(
                    file, "only some nodes list their displacements", number, "add digits such as 123 to all"
                )
            if len(places) > MAX_UNKNOWNS:
                raise refuse(file, f"more than {MAX_UNKNOWNS} nodes", number)
    if not places:
        raise refuse(file, "has no node", remedy="write one line x y z in m per node")
    if not digits[0]:
        return np.array(places), None, None
    node = np.repeat(np.arange(len(places)), [len(d) for d in digits])
    return np.array(places), node, np.concatenate([np.array(d) for d in digits])


def _directions(file: Path, number: int, text: str) -> tuple[int, ...]:
    """Directions of the displacements of a node, in the order of the digits."""
    if not re.fullmatch(r"[1-6]{1,6}", text) or len(set(text)) != len(text):
        raise refuse(
            file, f"displacements: {text[:20]!r} is not a list of digits 1 to 6", number, "write 123"
        )
    return tuple(int(c) - 1 for c in text)


def read_parts(
    stiffness: str | os.PathLike[str],
    mass: str | os.PathLike[str],
    places: str | os.PathLike[str],
    spin_stiffness: str | os.PathLike[str] | None = None,
) -> Structure:
    """Structure from two Matrix Market files and a node table.

    Parameters
    ----------
    stiffness, mass
        Files for `read_matrix_market`.
    places
        File for `read_places`.
    spin_stiffness
        File for `read_matrix_market` with the spin stiffness `K_spin` of `Structure`.
    """
    K, M = read_matrix_market(stiffness), read_matrix_market(mass)
    more = None if spin_stiffness is None else read_matrix_market(spin_stiffness)
    return make_structure(K, M, *read_places(places), K_spin=more)
