# SPDX-License-Identifier: Apache-2.0
"""Universal files: time responses of data set 58, ASCII or binary, through pyuff (extra `uff`)."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

from pitchpoint.core.errors import MissingDependencyError
from pitchpoint.io.measured.record import (
    Column,
    MeasuredError,
    Record,
    Wanted,
    as_floats,
    header_rate,
    refused,
    truncated,
)

_TIME_RESPONSE = 1
_TIME, _EVEN = 17, 1
_MARK = re.compile(rb"    -1(?=[\r\n]| {74}|\Z)")
"""Delimiter of data sets; after binary numbers it follows without a new line."""
_DIRECTIONS = {
    sign * (k + 1): f"{'+' if sign > 0 else '-'}{axis}"
    for k, axis in enumerate(("x", "y", "z", "rx", "ry", "rz"))
    for sign in (1, -1)
}


def read_uff(path: Path, data: bytes, wanted: Wanted) -> Record:
    """Read the time responses of a universal file; other data sets are omitted."""
    if len(_MARK.findall(data)) % 2:
        raise refused(
            path, "", "", "begins a data set that does not end", "-1", "copy it again; it was cut off"
        )
    found = [s for s in _sets(path) if s.get("type") == 58]
    sets = [s for s in found if s.get("func_type") == _TIME_RESPONSE]
    if not sets:
        others = (
            f"functions of type {sorted({str(s.get('func_type')) for s in found})}"
            if found
            else "no data set 58"
        )
        raise refused(path, "", others, "hold no time response", "data set 58, type 1", "export time signals")
    names = _names(sets)
    chosen = [(name, s) for name, s in zip(names, sets, strict=True) if wanted.takes(name)]
    columns, rates, starts, axes = [], set(), set(), []
    for name, s in chosen:
        columns.append(_column(path, name, s))
        if s["abscissa_spacing"] == _EVEN:
            step = float(s["abscissa_inc"])
            if not (np.isfinite(step) and step > 0.0):
                raise refused(
                    path, name, f"{step:g} s", "is not a sampling interval", "> 0", "correct record 7"
                )
            rates.add(1.0 / step)
            starts.add(float(s["abscissa_min"]))
        else:
            axes.append(as_floats(s["x"]))
    if (
        len(rates) + bool(axes) > 1
        or len(starts) > 1
        or any(not np.array_equal(axes[0], a) for a in axes[1:])
    ):
        raise refused(
            path, "time", "", "runs differently in the channels", "one time axis", "choose channels that fit"
        )
    left = len(found) - len(sets)
    return Record(
        "UFF 58",
        tuple(columns),
        time=Column("time", axes[0], "s") if axes else None,
        resolution=1e-5 * float(np.abs(axes[0]).max()) if axes and axes[0].size else 0.0,
        rates=tuple(header_rate(rate) for rate in rates),
        start=next(iter(starts), 0.0),
        notes=(f"{left} functions that are not time responses were omitted",) if left else (),
    )


def _sets(path: Path) -> list[dict[str, Any]]:
    """Data sets of the file; the library may raise any exception."""
    try:
        import pyuff
    except ImportError as error:
        message = f"{path}: universal files are read by pyuff; install it with: pip install 'pitchpoint[uff]'"
        raise MissingDependencyError(message) from error
    try:
        file = pyuff.UFF(str(path))
        wanted = [k for k, kind in enumerate(file.get_set_types()) if int(kind) == 58]
        read = file.read_sets(wanted) if wanted else []
    except Exception as error:
        raise refused(
            path, "", "", f"is not a readable universal file ({str(error)[:100]})", None, "export it again"
        ) from error
    return read if isinstance(read, list) else [read]


def _names(sets: list[dict[str, Any]]) -> list[str]:
    """Node and direction of each response, or its first text line; duplicates are rejected later."""
    nodes = [f"{s.get('rsp_node', 0)}{_DIRECTIONS.get(s.get('rsp_dir', 0), '')}" for s in sets]
    words = [str(s.get("rsp_ent_name", "")).strip() for s in sets]
    named = [f"{w}:{n}" if w and w.upper() != "NONE" else n for w, n in zip(words, nodes, strict=True)]
    if max(Counter(named).values()) == 1:
        return named
    lines = [str(s.get("id1", "")).strip() for s in sets]
    return lines if all(lines) and max(Counter(lines).values()) == 1 else named


def _column(path: Path, name: str, s: dict[str, Any]) -> Column:
    values, promised = np.asarray(s["data"]), int(s.get("num_pts", 0))
    if values.dtype.kind == "c":
        raise refused(path, name, "complex numbers", "are not a time signal", None, "choose other channels")
    if values.size < promised:
        raise _short(path, name, promised, values.size)
    kind = int(s.get("abscissa_spec_data_type", _TIME))
    if kind not in (0, _TIME):
        raise refused(path, name, f"type {kind}", "is not a time axis", f"{_TIME}", "export it over time")
    unit = str(s.get("ordinate_axis_units_lab", "")).strip()
    words = ", ".join(
        t for t in (str(s.get(k, "")).strip() for k in ("id1", "ordinate_axis_lab")) if t and t != "NONE"
    )
    return Column(name, as_floats(values[:promised]), "" if unit.upper() == "NONE" else unit, words)


def _short(path: Path, name: str, promised: int, there: int) -> MeasuredError:
    return truncated(Path(f"{path}: {name}"), promised, there, "samples")
