# SPDX-License-Identifier: Apache-2.0
"""Mesh load factor of planetary stages in tables and files: its name and its row of statistics."""

from __future__ import annotations

from typing import Any

FACTOR = "load_sharing_factor"
"""Name of the factor in tables, with the stage in brackets."""


def factor_name(stage: str) -> str:
    """Name of the mesh load factor of a stage in tables.

    Examples
    --------
    >>> factor_name("set"), is_factor("load_sharing_factor[set]"), stage_of("load_sharing_factor[set]")
    ('load_sharing_factor[set]', True, 'set')
    """
    return f"{FACTOR}[{stage}]"


def is_factor(name: str) -> bool:
    """Whether a name in tables is that of the mesh load factor of a stage."""
    return name.startswith(f"{FACTOR}[")


def stage_of(name: str) -> str:
    """Stage of the name of a mesh load factor."""
    return name[len(FACTOR) + 1 : -1]


def factor_row(value: float) -> dict[str, Any]:
    """Mesh load factor as a row of statistics: the factor of the means has no variation."""
    return {"unit": "1", "mean": value, "rms": 0.0, "min": value, "max": value}
