# SPDX-License-Identifier: Apache-2.0
"""Blade and tower files of ElastoDyn: distributed mass, stiffness and structural twist."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from pitchpoint.core.errors import FileLine, Message, ModelError
from pitchpoint.geometry.beam_table import BeamTable
from pitchpoint.model.files import read_once
from pitchpoint.model.openfast.text import InputText, Line, read_input

MOST_TWIST = 90.0
"""Largest twist of a blade [deg]."""
_CORRECT = "correct the value"
_TITLES: tuple[dict[str, str], ...] = (
    {
        "position": "BlFract",
        "mass": "BMassDen",
        "bending_1": "FlpStff",
        "bending_2": "EdgStff",
        "twist": "StrcTwst",
    },
    {"position": "HtFract", "mass": "TMassDen", "bending_1": "TwFAStif", "bending_2": "TwSSStif"},
)
"""Titles of the columns of blades and towers by the properties of a beam."""
_FURTHER: tuple[dict[str, str], ...] = (
    {"torsion": "GJStff", "axial": "EAStff", "center_1": "FlpcgOf", "center_2": "EdgcgOf"},
    {"torsion": "TwGJStif", "axial": "TwEAStif"},
)
"""Titles of columns that a file may have, too."""
_FACTORS: tuple[dict[str, str], ...] = (
    {"mass": "AdjBlMs", "bending_1": "AdjFlSt", "bending_2": "AdjEdSt"},
    {"mass": "AdjTwMa", "bending_1": "AdjFASt", "bending_2": "AdjSSSt"},
)
"""Names of the adjustment factors; 1 if they are missing."""


def read_elastodyn(path: str | os.PathLike[str]) -> BeamTable:
    """Distributed properties of a blade or tower file of ElastoDyn, with its adjustment factors.

    Parameters
    ----------
    path
        The file.

    Returns
    -------
    BeamTable
        Axis 1 is flapwise, downwind without twist, or fore-aft; the first end is the root or the base. The
        structural twist is positive with the leading edge upwind, a negative rotation about the blade.
        Columns GJStff, EAStff, FlpcgOf and EdgcgOf of older files are used too.

    Raises
    ------
    ModelError
        With every problem and its line.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "Tower.dat"
    >>> lines = ["2 NTwInpSt", "2 AdjTwMa", "HtFract TMassDen TwFAStif TwSSStif", "0 5600 6e11 6e11"]
    >>> _ = file.write_text("\\n".join([*lines, "1 2500 1e11 1e11"]))
    >>> read_elastodyn(file).mass.tolist()
    [11200.0, 5000.0]
    """
    text = read_input(path)
    blade, tower = text.find("NBlInpSt"), text.find("NTwInpSt")
    remedy = "give a blade or tower file of ElastoDyn"
    if blade is None and tower is None:
        text.require("a blade or tower file of ElastoDyn", ("NBlInpSt", "NTwInpSt"), remedy)
    if blade is not None and tower is not None:
        text.problem("NBlInpSt, NTwInpSt", "are given together", None, "one of them", remedy=remedy)
        text.stop()
    count = "NTwInpSt" if blade is None else "NBlInpSt"
    columns = _columns(text, blade or tower, count, tuple(_TITLES[blade is None].values()))
    try:
        return _table(text, blade is None, columns)
    except ModelError as error:
        raise ModelError([_in_row(text, p) for p in error.problems]) from None


@read_once(files=16)
def elastodyn_part(path: str) -> str:
    """Part that a file of ElastoDyn describes, "blade" or "tower"; "" if it cannot be read.

    Parameters
    ----------
    path
        The file.
    """
    try:
        text = read_input(path)
    except ModelError:
        return ""
    found = [part for part, name in (("blade", "NBlInpSt"), ("tower", "NTwInpSt")) if text.find(name)]
    return found[0] if len(found) == 1 else ""


def _in_row(text: InputText, problem: Message) -> Message:
    """Problem of a table at the column and the line of the file."""
    name, _, index = problem.where.partition("[")
    tower = text.find("NBlInpSt") is None
    columns = _TITLES[tower] | _FURTHER[tower]
    title = columns.get(name, name)
    first = next(ln for ln in text.lines if ln.tokens[0].lower() == columns["position"].lower())
    line = text.row_line(first, int(index[:-1])) if index else first.number
    return problem.changed(
        where=title, line=FileLine(line, text.path.name), remedy=problem.remedy or _CORRECT
    )


def _columns(
    text: InputText, start: Line | None, count: str, needed: tuple[str, ...]
) -> dict[str, np.ndarray]:
    """Columns of the table of properties by their titles in lower case."""
    title = next((ln for ln in text.lines if ln.tokens[0].lower() == needed[0].lower()), None)
    if title is None or start is None:
        text.problem(needed[0], "is not the title of a column", None, None, remedy="give an ElastoDyn file")
        text.stop()
        raise AssertionError
    names = [token.lower() for token in title.tokens]
    missing = [name for name in needed if name.lower() not in names]
    if missing:
        text.problem(", ".join(missing), "are missing in the titles of the columns", None, None, title.number)
    rows = text.rows(title, text.count(count), len(names), "properties")
    text.stop()
    return dict(zip(names, np.array(rows).reshape(-1, len(names)).T, strict=True))


def _table(text: InputText, tower: bool, column: dict[str, np.ndarray]) -> BeamTable:
    """Table of the columns of a blade or a tower."""
    factors = {name: text.number(title, default=1.0) for name, title in _FACTORS[tower].items()}
    text.stop()
    titles = {name: title.lower() for name, title in (_TITLES[tower] | _FURTHER[tower]).items()}
    found: dict[str, Any] = {
        name: factors.get(name, 1.0) * column[t] for name, t in titles.items() if t in column
    }
    if "twist" in found:
        for k in np.flatnonzero(np.abs(found["twist"]) > MOST_TWIST)[:1]:
            value, limit = f"{found['twist'][k]:.6g} deg", f"-{MOST_TWIST:g} to {MOST_TWIST:g} deg"
            remedy = "correct the value; it is in degrees"
            raise ModelError([Message(f"twist[{k}]", "is out of range", value, limit, remedy)])
        found["twist"] = -np.radians(found["twist"])
    return BeamTable(**found)
