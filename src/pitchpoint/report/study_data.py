# SPDX-License-Identifier: Apache-2.0
"""Sweeps and cases as plain data for plots and tables: from datasets of the package and from result files."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.load_sharing import factor_row, is_factor
from pitchpoint.io.case_store import points_of, read_cases
from pitchpoint.io.contact_numbers import RATTLE
from pitchpoint.io.reading import read_header
from pitchpoint.io.sweep_store import (
    CONTACTS,
    QUANTITIES,
    STATISTICS,
    SWEPT,
    read_sweep,
    results_of_meshes,
    statistics_row,
    stored_meshes,
)
from pitchpoint.viz.report.build import CaseTable

if TYPE_CHECKING:
    import xarray as xr

COUNTED = {name for name, _, _ in RATTLE}
"""Contact numbers of a mesh, variables of their own in a dataset."""


def sweep_of(data: xr.Dataset) -> dict[str, Any]:
    """Points and jumps of a sweep in the order of computation; those of a result file are read from it."""
    from pitchpoint.analysis.jumps import sweep_jumps

    if "deflection_rms" not in data:
        return read_sweep(_file_of(data))
    swept = str(data.attrs.get(SWEPT, ""))  # datasets of earlier versions do not name it
    tables = {str(name): variable.values for name, variable in data.data_vars.items()}
    meshes = stored_meshes(list(tables), swept) if swept else []
    frequencies = data["mesh_frequency"].values
    points: list[dict[str, Any]] = []
    for k, direction in enumerate(data["direction"].values):
        order = range(len(frequencies)) if direction == "up" else range(len(frequencies) - 1, -1, -1)
        for i in order:
            known = ("speed", *(name for name, _, _ in CONTACTS))
            values = {name: float(tables[name][k, i]) for name in known if name in tables}
            if not np.isfinite(values["speed"]):
                continue
            point: dict[str, Any] = {"direction": str(direction), "mesh_frequency": float(frequencies[i])}
            for name, unit, _ in QUANTITIES:
                point[name] = statistics_row((tables[f"{name}_{key}"][k, i] for key in STATISTICS), unit)
            if meshes:
                point["meshes"] = results_of_meshes(meshes, tables, (k, i))
            points.append(point | values)
    jumps = [{"direction": j.direction, "mesh_frequency": j.frequency} for j in sweep_jumps(points)]
    return {"mesh": swept, "points": points, "jumps": jumps}


def case_table(data: xr.Dataset) -> CaseTable:
    """Cases of `cases_dataset`; those of a result file are read from it."""
    if "status" not in data:
        file = _file_of(data)
        return CaseTable(cases=read_cases(file), units=read_header(file)["options"].get("vary_units", {}))
    paths = [str(name) for name in data.coords if data[name].dims == ("case",) and name != "case"]
    units = {path: str(data[path].attrs.get("units", "")) for path in paths}
    numeric = [path for path in paths if data[path].dtype.kind in "fiu"]
    sentences, cases = data.attrs.get("sentences", []), []
    tables = {str(n): v for n, v in data.data_vars.items()}
    channels = {n: v for n, v in tables.items() if v.dims == ("case", "statistic")}
    counted = {n: v for n, v in tables.items() if n.partition("[")[0] in COUNTED}
    factors = {n: v.values for n, v in tables.items() if is_factor(n)}
    swept = {n: v.values for n, v in tables.items() if "point" in v.dims}
    directions = [str(d) for d in data["direction"].values] if swept else []
    for k in range(data.sizes["case"]):
        rows = {
            name: {"unit": str(v.attrs.get("units", ""))}
            | {s: float(x) for s, x in zip(STATISTICS, v.values[k], strict=True)}
            for name, v in channels.items()
        }
        for name, v in counted.items():
            number, _, mesh = name.partition("[")
            if v.dims == ("case",):
                rows.setdefault(f"contact_state[{mesh}", {"mean": math.nan})[number] = float(v.values[k])
        rows |= {n: factor_row(float(v[k])) for n, v in factors.items() if v.ndim == 1}
        values = {path: data[path].values[k] for path in paths}
        cases.append(
            {
                "values": {p: _text(v, units[p]) for p, v in values.items()},
                "numbers": {p: float(values[p]) for p in numeric},
                "status": int(data["status"].values[k]),
                "sentence": str(sentences[k]) if k < len(sentences) else "",
                "channels": {n: r for n, r in rows.items() if math.isfinite(float(r["mean"]))},
                "points": points_of(swept, directions, k, str(data.attrs.get(SWEPT, ""))),
            }
        )
    return CaseTable(cases=cases, units=units)


def _text(value: Any, unit: str) -> str:
    """Varied value in words."""
    return f"{float(value):.6g} {unit}".rstrip() if isinstance(value, float | np.floating) else str(value)


def _file_of(data: xr.Dataset) -> str:
    """Result file from which a dataset was opened."""
    file = data.encoding.get("source")
    if not file:
        raise PitchpointError(
            "the dataset does not know its file any more; use the unchanged dataset of open_result"
        )
    return str(file)
