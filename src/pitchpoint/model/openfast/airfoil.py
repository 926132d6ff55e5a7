# SPDX-License-Identifier: Apache-2.0
"""Airfoil files of AeroDyn v15: coefficients over the angle of attack."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence

import numpy as np

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.rotor.polar import Polar
from pitchpoint.model.openfast.text import read_input


def read_airfoil(
    path: str | os.PathLike[str], table: int = 1, columns: Sequence[int] = (1, 2, 3, 4)
) -> Polar:
    """Polar of an airfoil file of AeroDyn v15. The coordinates of the airfoil are not read.

    Parameters
    ----------
    path
        The file.
    table
        Number of the table, from 1, in a file with several Reynolds numbers.
    columns
        Columns of angle [deg], lift, drag and moment, from 1; 0 for no moment.

    Returns
    -------
    Polar
        Named after the file.

    Raises
    ------
    ModelError
        With every problem and its line.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "Cylinder.dat"
    >>> _ = file.write_text("1 NumTabs\\n3 NumAlf\\n-180 0 .5 0\\n0 0 .5 0\\n180 0 .5 0\\n")
    >>> read_airfoil(file).at(1.0).tolist()
    [0.0, 0.5, 0.0]
    """
    text = read_input(path)
    text.require(
        "an airfoil file of AeroDyn v15", ("NumAlf",), "give an airfoil file of AeroDyn, version 15 or later"
    )
    tables = int(text.number("NumTabs", default=1.0)) if text.find("NumTabs") else 1
    starts = [line for line in text.lines if len(line.tokens) > 1 and line.tokens[1].lower() == "numalf"]
    if not 1 <= table <= len(starts):
        text.problem("table", "is not a table of the file", str(table), f"1 to {len(starts)}")
    elif tables != len(starts):
        line = text.find("NumTabs")
        number = line.number if line else None
        text.problem("NumTabs", "is not the number of tables", str(tables), str(len(starts)), number)
    text.stop()
    start = starts[table - 1]
    count = text.value(start, 0, "NumAlf")
    if not (math.isfinite(count) and 3 <= count <= 1_000_000 and count == int(count)):
        if math.isfinite(count):
            limit = "a whole number >= 3"
            text.problem("NumAlf", "is not a number of rows", f"{count:g}", limit, start.number)
        text.stop()
    rows = np.array(text.rows(start, int(count), max(columns), "table of coefficients"))
    text.stop()
    used = [rows[:, c - 1] if c > 0 else np.zeros(len(rows)) for c in columns]
    try:
        return Polar(
            name=text.path.stem, alpha=np.radians(used[0]), lift=used[1], drag=used[2], moment=used[3]
        )
    except GeometryError as error:
        text.problems.append(error.problem.changed(line=start.number))
        text.stop()
        raise
