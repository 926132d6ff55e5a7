# SPDX-License-Identifier: Apache-2.0
"""Tables of sweep points over direction and mesh frequency, for the dataset of `sweep_speed`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.load_sharing import FACTOR, is_factor
from pitchpoint.core.nomenclature import symbol
from pitchpoint.io.sweep_store import CONTACTS, QUANTITIES, STATISTICS
from pitchpoint.solvers.dataset import channel_attributes
from pitchpoint.system.layout import Channel
from pitchpoint.system.planet_loads import WORDS

DIMENSIONS = ("direction", "mesh_frequency")

Point = Mapping[str, Any]
Variable = tuple[Any, ...]
"""Dimensions, values and attributes in the form of xarray."""


@dataclass(frozen=True)
class Places:
    """Positions of the points of a sweep: shape of the tables, row and column of each point."""

    shape: tuple[int, int]
    rows: tuple[int, ...]
    columns: tuple[int, ...]

    def table(self, values: Sequence[Any], *more: int) -> NDArray[np.float64]:
        """Values of the points in a table, shape (direction, mesh_frequency, *more), NaN elsewhere."""
        filled = np.full((*self.shape, *more), np.nan)
        if len(values):
            filled[list(self.rows), list(self.columns)] = values
        return filled


def places(points: Sequence[Point], directions: Sequence[str], grid: Sequence[float]) -> Places:
    """Rows and columns of sweep points in tables over direction and mesh frequency [Hz].

    Parameters
    ----------
    points
        As in `SweepSummary`.
    directions, grid
        All directions and mesh frequencies that occur.
    """
    row = {direction: k for k, direction in enumerate(directions)}
    column = {frequency: k for k, frequency in enumerate(grid)}
    return Places(
        (len(row), len(column)),
        tuple(row[p["direction"]] for p in points),
        tuple(column[p["mesh_frequency"]] for p in points),
    )


def mesh_tables(points: Sequence[Point], at: Places) -> dict[str, Variable]:
    """One variable per statistic of the swept mesh, the numbers of its contact, and the speed.

    The numbers of every mesh have its name in brackets.
    """
    data: dict[str, Variable] = {}
    for name, _, _ in QUANTITIES:
        for key in STATISTICS:
            unit = points[0][name]["unit"] if points else ""
            described = {"units": unit, "long_name": f"{name.replace('_', ' ')}, {key}"}
            data[f"{name}_{key}"] = (DIMENSIONS, at.table([p[name][key] for p in points]), described)
    for name, unit in (*((name, unit) for name, unit, _ in CONTACTS), ("speed", "rad/s")):
        described = {"units": unit, "long_name": name.replace("_", " ")}
        data[name] = (DIMENSIONS, at.table([p[name] for p in points]), described)
    for mesh in points[0]["meshes"] if points else ():
        for name, unit, words in CONTACTS:
            values = at.table([p["meshes"][mesh][name] for p in points])
            data[f"{name}[{mesh}]"] = (DIMENSIONS, values, {"units": unit, "long_name": words})
    return data


def channel_tables(channels: Sequence[Channel], points: Sequence[Point], at: Places) -> dict[str, Variable]:
    """One variable per channel, with `statistic` as the last dimension."""
    data: dict[str, Variable] = {}
    for c in channels:
        values = [[p["channels"][c.name][key] for key in STATISTICS] for p in points]
        table = at.table(values, len(STATISTICS))
        data[c.name] = ((*DIMENSIONS, "statistic"), table, channel_attributes(c))
    return data


def factor_tables(points: Sequence[Point], at: Places) -> dict[str, Variable]:
    """Mesh load factors of planetary stages."""
    names = [name for name in points[0] if is_factor(name)] if points else []
    words = {"units": "1", "long_name": WORDS, "symbol": symbol(FACTOR)}
    return {name: (DIMENSIONS, at.table([p[name] for p in points]), words) for name in names}


def jump_tables(jumps: Sequence[Mapping[str, Any]], directions: Sequence[str]) -> dict[str, Variable]:
    """Direction index and mesh frequency [Hz] of each jump."""
    which = np.array([directions.index(j["direction"]) for j in jumps], dtype=np.int32)
    where = np.array([j["mesh_frequency"] for j in jumps], dtype=np.float64)
    words = "direction of the jump, its index in `direction`"
    return {
        "jump_direction": ("jump", which, {"long_name": words}),
        "jump_mesh_frequency": ("jump", where, {"units": "Hz", "long_name": "mesh frequency of the jump"}),
    }
