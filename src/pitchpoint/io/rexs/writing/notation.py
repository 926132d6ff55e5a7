# SPDX-License-Identifier: Apache-2.0
"""Values in the ids, units and types of one version of REXS."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

from pitchpoint.io.rexs import tables
from pitchpoint.io.rexs.document import RexsAttribute, Value
from pitchpoint.io.rexs.units import RexsUnit, unit_of

ZERO = 1e-13
"""Size below which an entry of a vector is rounding, relative to the largest one."""


@dataclass(frozen=True)
class Written:
    """A value as it is written: id, unit and type of the version, value in this unit."""

    id: str
    unit: str
    type: str
    value: Any


@cache
def _by_number(version: str) -> dict[int, tables.Definition]:
    return {one.number: one for one in tables.definitions() if one.holds_in(version)}


def written(attribute: RexsAttribute, version: str) -> Written | None:
    """Value in the notation of a version; None if the version does not have it.

    Parameters
    ----------
    attribute
        Value in SI units.
    version
        Version of REXS, one of `tables.VERSIONS`.

    Examples
    --------
    >>> written(RexsAttribute("face_width", 808, 0.05, unit="mm"), "2.0.0")
    Written(id='face_width', unit='mm', type='floating_point', value=50.0)
    """
    if attribute.number is None:
        return Written(attribute.id, attribute.unit, _type_of(attribute.value), _listed(attribute.value))
    known = _by_number(version).get(attribute.number)
    if known is None:
        return None
    return Written(known.id, known.unit, known.type, _in_unit(attribute.value, unit_of(known.unit)))


def _type_of(value: Value) -> str:
    """Type of a value whose id REXS does not define."""
    if isinstance(value, tuple):
        first = value[0] if value else 0.0
        if isinstance(first, tuple):
            return f"{_type_of(first).removesuffix('_array')}_matrix"
        return f"{_type_of(first)}_array"
    if isinstance(value, bool):
        return "boolean"
    return {int: "integer", float: "floating_point"}.get(type(value), "string")


def _listed(value: Value) -> Any:
    return [_listed(one) for one in value] if isinstance(value, tuple) else value


def _in_unit(value: Value, unit: RexsUnit) -> Any:
    """Value in a unit; rounding in vectors becomes 0."""
    if isinstance(value, tuple):
        numbers = [one for one in value if isinstance(one, float)]
        least = ZERO * max(map(abs, numbers), default=0.0)
        return [0.0 if isinstance(one, float) and abs(one) < least else _in_unit(one, unit) for one in value]
    return unit.from_si(value) if isinstance(value, float) else value
