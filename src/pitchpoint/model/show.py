# SPDX-License-Identifier: Apache-2.0
"""Text of paths, values and limits of a model file for messages."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.core.units import format_quantity
from pitchpoint.model.keys import Key, Place

SI = {"length": "metres", "angle": "radians"}


def dotted(path: Place) -> str:
    """Path in dotted notation.

    Examples
    --------
    >>> dotted(("gears", "pinion", "deviations", "pitch", 3))
    'gears.pinion.deviations.pitch[3]'
    """
    out = ""
    for step in path:
        out += f"[{step}]" if isinstance(step, int) else (f".{step}" if out else str(step))
    return out


def shown(value: Any) -> str:
    """Value as text for a message, at most 60 characters."""
    if isinstance(value, Mapping):
        return "a mapping"
    if isinstance(value, list | tuple):
        return f"a list of {len(value)}"
    if value is None:
        return "nothing"
    if isinstance(value, bool):
        return "true" if value else "false"
    text = repr(value) if isinstance(value, str) else str(value)
    return text if len(text) <= 60 else text[:57] + "..."


def limit_text(description: Key) -> str:
    """Allowed range in customary units."""
    if description.range_words:
        return description.range_words
    parts = []
    for bound, strict, loose in (
        (description.minimum, ">" if description.above else ">=", -math.inf),
        (description.maximum, "<" if description.below else "<=", math.inf),
    ):
        if bound != loose:
            parts.append(f"{strict} {'0' if bound == 0.0 else format_quantity(bound, description.dimension)}")
    return " and ".join(parts)


def entries(low: int, high: int, count: int | None = None) -> str:
    """Number of entries of a list: exactly, the least for a shorter list, else the most.

    Examples
    --------
    >>> entries(3, 3), entries(1, 3), entries(2, 9, 1), entries(1, 1)
    ('3 entries', 'at most 3 entries', 'at least 2 entries', '1 entry')
    """
    end, most = (low, "at least ") if count is not None and count < low else (high, "at most ")
    return f"{'' if low == high else most}{end} {'entry' if end == 1 else 'entries'}"


def example(description: Key) -> str:
    """Example of a valid value."""
    if description.sample:
        return description.sample
    if description.kind in ("quantity", "quantities"):
        one = DIMENSIONS[description.dimension].example
        one = one.split(" or ")[0]
        if description.kind == "quantities" or description.length[0] > 1:
            return f"[{', '.join([one] * max(2, min(description.length[0], 3)))}]"
        return one
    if description.kind in ("law", "laws"):
        one = DIMENSIONS[description.dimension].example.split(" or ")[0]
        return one if description.kind == "law" else f"[0, 0, {one}]"
    if description.choices:
        return " or ".join(description.choices)
    samples = {"integer": str(int(max(description.minimum, 20))), "names": "[a, b]", "text": "a name"}
    return samples.get(description.kind, "{...}")
