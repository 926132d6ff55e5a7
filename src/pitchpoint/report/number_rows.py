# SPDX-License-Identifier: Apache-2.0
"""Rows of the tables of numbers of gears and meshes: identifier, meaning, dimension."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

Row = tuple[str, str, str]
"""Identifier, meaning, dimension of `core.units`."""
C_PRIME_B, MEAN, ONE_PAIR = "c' b", "the mean", "K of one pair"
"""What a mesh cycle is relative to: single stiffness times common width, the mean of a prescribed wave, or
the constant of a pair whose force is a power of its deflection."""


def pick(source: Any, rows: Sequence[Row], positive: set[str]) -> dict[str, Any]:
    """Read the attributes that rows name; those in `positive` lose their sign."""
    numbers = {}
    for name, _, _ in rows:
        value = getattr(source, name)
        numbers[name] = abs(value) if name in positive else value
    return numbers
