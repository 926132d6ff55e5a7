# SPDX-License-Identifier: Apache-2.0
"""Equality of values of REXS files within rounding."""

from __future__ import annotations

import math
from collections.abc import Mapping

from pitchpoint.io.rexs.document import RexsAttribute, Value
from pitchpoint.io.rexs.tables import newest
from pitchpoint.io.rexs.units import unit_of

ROUNDING = 1e-6
"""Default of the relative difference up to which numbers are equal."""
SMALLEST = 1e-9
"""Difference in the unit of the file up to which numbers are equal, also near zero."""


DIRECTIONS = ("u_axis_vector", "w_axis_vector")
"""Vectors of any length: some files have them in mm, others without unit."""


def _unit(vector: list[float]) -> list[float]:
    length = math.hypot(*vector)
    return [x / length for x in vector] if length else vector


def is_reference(attribute: RexsAttribute) -> bool:
    """Whether the value is the id of a component."""
    return attribute.number is not None and newest(attribute.number).type == "reference_component"


def numbers_in(value: Value) -> list[float] | None:
    """Numbers of a value, of arrays and matrices in a row; None if it has something else.

    Examples
    --------
    >>> numbers_in(((1.0, 2), (3.0, 4))), numbers_in("oil"), numbers_in(True)
    ([1.0, 2.0, 3.0, 4.0], None, None)
    """
    if isinstance(value, tuple):
        rows = [numbers_in(one) for one in value]
        return None if any(row is None for row in rows) else [x for row in rows for x in row or ()]
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return [float(value)]


def shape_of(value: Value) -> tuple[int, ...]:
    """Numbers of rows and columns; empty for a single value.

    Examples
    --------
    >>> shape_of(((1.0, 2.0, 3.0), (4.0, 5.0, 6.0))), shape_of(1.0)
    ((2, 3), ())
    """
    if not isinstance(value, tuple):
        return ()
    return (len(value), *(shape_of(value[0]) if value else ()))


def factor_of(attribute: RexsAttribute) -> float:
    """SI value of one unit of the file; 1 for values of unknown ids, which stay as they are."""
    return float(unit_of(attribute.unit).factor) if attribute.number is not None else 1.0


def equal(a: RexsAttribute, b: RexsAttribute, pairs: Mapping[int, int], tolerance: float = ROUNDING) -> bool:
    """Whether two values are equal within rounding; of vectors, relative to their largest component.

    Parameters
    ----------
    a, b
        Values of the first and of the second file.
    pairs
        Components of the second file by those of the first.
    tolerance
        Relative difference up to which numbers are equal.

    Examples
    --------
    >>> width = RexsAttribute("face_width", 808, 0.05, unit="mm")
    >>> equal(width, RexsAttribute("face_width", 808, 0.05 + 1e-9, unit="mm"), {})
    True
    """
    if is_reference(a):
        return pairs.get(a.value) == b.value  # type: ignore[arg-type]
    if a.number is None:  # XML files have texts only, JSON files also numbers and truth values
        return _as_text(a.value) == _as_text(b.value)
    one, two = numbers_in(a.value), numbers_in(b.value)
    if one is None or two is None:
        return a.value == b.value
    if shape_of(a.value) != shape_of(b.value):
        return False
    if a.id in DIRECTIONS:
        one, two = _unit(one), _unit(two)
    size = max(map(abs, [*one, *two]), default=0.0)
    limit = max(tolerance * size, SMALLEST * factor_of(a))
    return all(abs(x - y) <= limit for x, y in zip(one, two, strict=True))


def _as_text(value: Value) -> object:
    """Value of an id that REXS does not define, the same for all formats."""
    if isinstance(value, tuple):
        return tuple(map(_as_text, value))
    text = str(value).strip()
    try:
        return float(text)
    except ValueError:
        return text.lower() if text.lower() in ("true", "false") else text


def distance(a: RexsAttribute | None, b: RexsAttribute | None) -> float:
    """Difference of two values from 0 (equal) to 1, for numbers by their relative difference.

    Examples
    --------
    >>> wide, half = (RexsAttribute("face_width", 808, x, unit="mm") for x in (0.05, 0.025))
    >>> distance(wide, wide), distance(wide, half), distance(wide, None)
    (0.0, 0.75, 1.0)
    """
    if a is None or b is None:
        return 1.0
    if equal(a, b, {}):
        return 0.0
    one, two = numbers_in(a.value), numbers_in(b.value)
    if one is None or two is None or shape_of(a.value) != shape_of(b.value):
        return 1.0
    size = max(map(abs, [*one, *two]))
    return 0.5 + 0.5 * min(1.0, max(abs(x - y) for x, y in zip(one, two, strict=True)) / size)
