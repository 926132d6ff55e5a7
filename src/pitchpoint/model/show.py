# SPDX-License-Identifier: Apache-2.0
"""Text of paths, values and limits of a model file for messages."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from pitchpoint.core.errors import UnitError
from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.core.units import format_quantity, natural_quantity, parse_quantity
from pitchpoint.model.keys import Key, Place, keys_of

SI = {
    "length": "metres",
    "angle": "radians",
    "temperature": "kelvin",
    "density": "kg/m^3",
    "kinematic_viscosity": "m^2/s",
    "pressure_viscosity": "1/Pa",
}
"""SI units in words, of dimensions in which numbers without unit are rarely meant in SI."""
PLACE = "[x, y, z], such as [0, 0, 60 mm]"
"""Example of a position."""
NAMES = ("names", "words", "gears", "ends")
"""Kinds of keys whose value is a list of names."""


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
        low, high = description.length
        if description.kind == "quantities" or low > 1:
            count = low if low == high else max(2, min(low, 3))
            return (
                PLACE if (count, description.dimension) == (3, "length") else f"[{', '.join([one] * count)}]"
            )
        return one
    if description.kind in ("law", "laws"):
        one = DIMENSIONS[description.dimension].example.split(" or ")[0]
        return one if description.kind == "law" else f"[0, 0, {one}]"
    if description.choices:
        return " or ".join(description.choices)
    samples = {
        "integer": str(int(max(description.minimum, 20))),
        "names": "[a, b]",
        "end": "BODY or BODY.MARKER",
        "ends": "[BODY, BODY]",
        "text": "a name",
        "file": "a file name",
        "library": "a file name",
    }
    return samples.get(description.kind, "{...}")


def as_list(description: Key, data: Any) -> str:
    """Remedy for a value in place of a list: the list that is probably meant."""
    text = data.strip()[:40] if isinstance(data, str) else ""
    if text and description.kind in NAMES and description.length[0] <= 1:
        return f"write [{text}]"
    if text and description.length == (3, 3) and description.dimension == "length":
        return f"write [x, y, z], such as [0, 0, {text}] on the z axis"
    return f"write {example(description)}"


def as_mapping(cls: type, data: Any) -> str:
    """Remedy for a value in place of the mapping of a component: the key that is probably meant, and all
    keys.

    Examples
    --------
    >>> from pitchpoint.model.components.six import Damping6, Stiffness6
    >>> as_mapping(Stiffness6, "8e8 N/m").partition(";")[0]
    'write {radial: 8e8 N/m}, or x, y, axial instead of radial'
    >>> as_mapping(Damping6, 0.05).partition(";")[0]
    'write {ratio: 0.05}'
    """
    keys = keys_of(cls)
    meant = ""
    if isinstance(data, str | float):
        dimensions = {name: key.dimension for name, key in keys.items() if key.kind == "quantity"}
        if isinstance(data, float):  # without unit
            dimensions = {name: d for name, d in dimensions.items() if d == "dimensionless"}
        fits = [name for name, dimension in dimensions.items() if _is_quantity(data, dimension)]
        others = f", or {', '.join(fits[1:])} instead of {fits[0]}" if fits[1:] else ""
        meant = f"write {{{fits[0]}: {data}}}{others}; " if fits else ""
    return f"{meant}possible keys: {', '.join(keys)}"


def _is_quantity(data: str | float, dimension: str) -> bool:
    """Whether a value has a unit of a dimension."""
    try:
        parse_quantity(data, dimension)
    except (UnitError, OverflowError):
        return False
    return isinstance(data, float) or bool(natural_quantity(data)[1])
