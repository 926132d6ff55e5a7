# SPDX-License-Identifier: Apache-2.0
"""File of the stiffness matrix of a housing, which a model needs in its folder."""

from __future__ import annotations

import atexit
import functools
import hashlib
import shutil
import tempfile
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from pitchpoint.io.target import HOUSING_MARK


def matrix_text(matrix: np.ndarray, nodes: Iterable[str]) -> str:
    """Text of a CSV file with the stiffness matrix of a housing.

    Examples
    --------
    >>> matrix_text(np.eye(2), ["left"]).splitlines()[-2:]
    ['1,0', '0,1']
    """
    head = f"{HOUSING_MARK}# N, m, rad; x, y, z and rotations about them of each node: {', '.join(nodes)}\n"
    return head + "".join(",".join(f"{value:.17g}" for value in row) + "\n" for row in matrix)


def stored(name: str, text: str) -> Path:
    """Path of a file with a text in a folder of this process, for models that are not saved."""
    folder = _folder() / hashlib.sha256(text.encode()).hexdigest()[:16]
    folder.mkdir(exist_ok=True)
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


@functools.cache
def _folder() -> Path:
    folder = tempfile.mkdtemp(prefix="pitchpoint-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return Path(folder)
