# SPDX-License-Identifier: Apache-2.0
"""Row definitions of the tables of gears and meshes: identifier, meaning, dimension."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

Row = tuple[str, str, str]
"""Identifier, meaning, dimension of `core.units`."""
C_PRIME_B, MEAN, ONE_PAIR = "c' b", "the mean", "K of one pair"
"""Reference value of a mesh cycle: single stiffness times common width, the mean of a prescribed wave, or
the constant of a pair whose force is a power of its deflection."""


def pick(source: Any, rows: Sequence[Row], positive: set[str]) -> dict[str, Any]:
    """Values of the attributes named in the rows; absolute values for those in `positive`."""
    numbers = {}
    for name, _, _ in rows:
        value = getattr(source, name)
        numbers[name] = abs(value) if name in positive else value
    return numbers
