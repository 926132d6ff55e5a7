# SPDX-License-Identifier: Apache-2.0
"""Finite-element structures from the files of a model, and their nodes by position."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.multibody.fe_matrices import read_dmig, read_npz, structure_from_dmig
from pitchpoint.multibody.matrix_market import read_parts
from pitchpoint.multibody.structure import Structure, check_mass

NEAR = 1e-3
"""Maximum distance of a node from the given position, relative to the size of the body."""


def read_structure(files: Sequence[str]) -> Structure:
    """Structure from one archive or punch file, or from the files of stiffness, mass and nodes."""
    if len(files) >= 3:
        structure = read_parts(*files)
    elif Path(files[0]).suffix == ".npz":
        structure = read_npz(files[0])
    else:
        structure, _ = structure_from_dmig(read_dmig(files[0]))
    check_mass(structure)
    return structure


def node_near(structure: Structure, word: str, place: NDArray[np.float64]) -> int:
    """Node at a position; `word` is its name in messages.

    Raises
    ------
    CompileError
        If there is none.
    """
    apart = np.linalg.norm(structure.places - place, axis=1)
    size = float(np.linalg.norm(np.ptp(structure.places, axis=0)))
    k = int(np.argmin(apart))
    if apart[k] > NEAR * size:
        near = ", ".join(f"{1e3 * x:.6g}" for x in structure.places[k])
        raise CompileError(f"{word}: the file has no node at this position; the nearest is at [{near}] mm")
    return k
