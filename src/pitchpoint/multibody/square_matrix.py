# SPDX-License-Identifier: Apache-2.0
"""Small dense matrices of stiffness, mass or damping from files of finite-element and gearbox programs."""

from __future__ import annotations

import os
import re
import zipfile
import zlib
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pitchpoint.multibody.fe_matrices import checked, refuse
from pitchpoint.multibody.matrix_market import LONGEST, read_matrix_market

Array = NDArray[np.float64]

LARGEST = 6000
"""Maximum number of rows of a dense matrix."""
FORMATS = ".csv, .txt, .mtx, .mtx.gz, .npy or .npz"


def read_square(path: str | os.PathLike[str]) -> Array:
    """Read a real square matrix, by the ending of the file name.

    Parameters
    ----------
    path
        CSV or text (numbers separated by commas, semicolons, blanks or tabs; lines that begin with # or % are
        comments), Matrix Market, or NumPy: an array, or an archive with one array.

    Raises
    ------
    ModelError
        If the file is not a square matrix of finite numbers, with its line if known.
    """
    file = checked(path)
    name = file.name.lower()
    if name.endswith((".mtx", ".mtx.gz")):
        found = read_matrix_market(file)
        if found.shape[0] > LARGEST:
            raise refuse(file, f"has {found.shape[0]} rows (limit {LARGEST})")
        return np.asarray(found.toarray(), float)
    if name.endswith((".npy", ".npz")):
        matrix = _array(file)
    elif name.endswith((".csv", ".txt")):
        matrix = _text(file)
    else:
        raise refuse(file, f"is not a file with a matrix ({FORMATS})")
    if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1] or not matrix.size:
        shape = " x ".join(map(str, matrix.shape)) or "one number"
        raise refuse(file, f"is not a square matrix: {shape}")
    if not np.all(np.isfinite(matrix)):
        raise refuse(file, "has entries that are not finite")
    return matrix


def _array(file: Path) -> Array:
    """Array of a NumPy file; an archive must have exactly one."""
    try:
        if file.suffix == ".npz":
            with np.load(file, allow_pickle=False) as archive:
                if len(archive.files) != 1:
                    raise refuse(file, f"has {len(archive.files)} arrays (limit 1)")
                found = archive[archive.files[0]]
        else:
            found = np.load(file, allow_pickle=False)
        return np.asarray(found, dtype=float)
    except (ValueError, TypeError, EOFError, OSError, MemoryError, zipfile.BadZipFile, zlib.error) as error:
        raise refuse(file, f"cannot be read ({error})") from None


def _text(file: Path) -> Array:
    """Rows of numbers."""
    rows: list[list[float]] = []
    with file.open(encoding="utf-8", errors="replace") as text:
        for number, line in enumerate(iter(lambda: text.readline(LONGEST * 64), ""), 1):
            words = re.split(r"[,;\s]+", line.strip().strip(",;"))
            if words == [""] or line.lstrip()[0] in "#%":
                continue
            try:
                rows.append([float(word) for word in words])
            except ValueError:
                remedy = "write numbers with a decimal point, one row per line"
                raise refuse(file, "is not a row of numbers", number, remedy) from None
            if len(rows[-1]) != len(rows[0]):
                remedy = "give every row the same length"
                raise refuse(
                    file, f"has {len(rows[-1])} numbers, the first row {len(rows[0])}", number, remedy
                )
            if len(rows) > LARGEST or len(rows[0]) > LARGEST:
                raise refuse(file, f"has more than {LARGEST} rows or columns", number)
    return np.array(rows, dtype=float)
