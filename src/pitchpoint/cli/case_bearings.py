# SPDX-License-Identifier: Apache-2.0
"""Largest bearing forces of the cases of `--vary`, as a table."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from pitchpoint.cli.output import NOTHING, shown, table
from pitchpoint.core.extremes import greatest

FORCE = "bearing_force["
MOST = 6
"""Largest number of bearings in the table."""
ROUND_OFF = 1e-8
"""Axial force relative to the largest radial force that counts as none."""


def show_bearing_forces(
    title: str, cases: Sequence[tuple[Sequence[str], Mapping[str, Any]]], head: Sequence[str]
) -> None:
    """Print the largest radial and axial force of every bearing, one row per case.

    Parameters
    ----------
    title
        Title of the table.
    cases
        Values of the case as texts, and its statistics by channel.
    head
        Names of the values.
    """
    names = list(
        dict.fromkeys(n[len(FORCE) : -len(".radial]")] for _, c in cases for n in c if _is(n, "radial"))
    )
    forces = [
        {(n, way): _largest(channels, n, way) for n in names for way in ("radial", "axial")}
        for _, channels in cases
    ]
    size = {key: max((abs(f[key] or 0.0) for f in forces), default=0.0) for f in forces for key in f}
    loaded = sorted((n for n in names if size[n, "radial"] + size[n, "axial"] > 0.0), key=names.index)
    if not loaded:
        return
    first = sorted(loaded, key=lambda n: -max(size[n, "radial"], size[n, "axial"]))[:MOST]
    limit = ROUND_OFF * max(size.values())
    keys = [(n, way) for n in loaded if n in first for way in ("radial", "axial") if size[n, way] > limit]
    rows = [
        [*values, *(_cell(f[key], limit) for key in keys)]
        for (values, _), f in zip(cases, forces, strict=True)
    ]
    more = len(loaded) - len(first)
    others = f"{more} more bearing{'s' if more > 1 else ''} with smaller forces"
    notes = [f"{others} {'are' if more > 1 else 'is'} in the file"] if more else []
    columns = [*head, *(f"maximum {way} {name}" for name, way in keys)]
    table(f"{title}: bearing forces", columns, rows, notes, keys=len(head))


def _is(name: str, way: str) -> bool:
    return name.startswith(FORCE) and name.endswith(f".{way}]")


def _largest(channels: Mapping[str, Any], name: str, way: str) -> float | None:
    """Largest force of a bearing in one direction [N], with its sign; None if it is not known."""
    row = channels.get(f"{FORCE}{name}.{way}]")
    return None if row is None else greatest(row)


def _cell(force: float | None, limit: float) -> str:
    """A force as text; forces below the limit are round-off."""
    if force is None:
        return NOTHING
    return shown(force if abs(force) > limit else 0.0, "force", 5)
