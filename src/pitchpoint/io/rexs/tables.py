# SPDX-License-Identifier: Apache-2.0
"""Ids, units and value types of all versions of REXS, from `attributes.csv` and `components.csv`.

Both files are made by `docs/make_rexs_tables.py` from the schema files of FVA GmbH (Apache-2.0). An attribute
has the same number in all versions; its id and its unit may change.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path

VERSIONS = ("1.0", "1.1", "1.2", "1.3", "1.4", "1.5", "1.6", "1.7", "2.0.0")
NEWEST = VERSIONS[-1]


@dataclass(frozen=True)
class Definition:
    """Definition of an attribute from one version to another.

    Attributes
    ----------
    number, id
        Numeric id and id.
    unit, type
        Unit and value type, such as "mm" and "floating_point".
    since, until
        First and last version with this definition.
    components
        Types of components that have the attribute.
    """

    number: int
    id: str
    unit: str
    type: str
    since: str
    until: str
    components: frozenset[str]

    def holds_in(self, version: str) -> bool:
        """Whether the definition is that of a version."""
        return VERSIONS.index(self.since) <= VERSIONS.index(version) <= VERSIONS.index(self.until)


def _rows(name: str) -> list[dict[str, str]]:
    with (Path(__file__).parent / name).open(encoding="utf-8", newline="") as file:
        next(file)  # source and licence
        return list(csv.DictReader(file))


@cache
def component_types() -> dict[str, tuple[str, str]]:
    """First and last version of every type of component.

    Examples
    --------
    >>> component_types()["slide_bearing"]
    ('1.0', '1.7')
    """
    return {row["id"]: (row["since"], row["until"]) for row in _rows("components.csv")}


@cache
def definitions() -> tuple[Definition, ...]:
    """All definitions, by number and version."""
    names = {row["number"]: row["id"] for row in _rows("components.csv")}
    return tuple(
        Definition(
            int(row["number"]),
            row["id"],
            row["unit"],
            row["type"],
            row["since"],
            row["until"],
            frozenset(names[number] for number in row["components"].split()),
        )
        for row in _rows("attributes.csv")
    )


@cache
def _by_id() -> dict[str, tuple[Definition, ...]]:
    found: dict[str, list[Definition]] = {}
    for one in definitions():
        found.setdefault(one.id, []).append(one)
    return {name: tuple(ones) for name, ones in found.items()}


@cache
def _newest() -> dict[int, Definition]:
    return {one.number: one for one in definitions()}  # the last one of a number


def ids_of(version: str) -> list[str]:
    """All ids of a version."""
    return [one.id for one in definitions() if one.holds_in(version)]


def newest(number: int) -> Definition:
    """Newest definition of a number."""
    return _newest()[number]


def definition(version: str, name: str, component: str = "") -> Definition | None:
    """Definition of an id in a version, or in another version that has it; None for an unknown id.

    REXS 1.0 has several numbers for the same value of several components; 1.1 joins them to one, which is
    returned.

    Parameters
    ----------
    version
        Version, one of `VERSIONS`.
    name
        Id.
    component
        Type of the component, which decides between two values with the same id.

    Examples
    --------
    >>> definition("1.0", "tip_radius", "cutter_wheel_tool").number, newest(3084).id
    (3084, 'tip_corner_radius_cutter')
    >>> definition("1.3", "normal_pressure_angle").unit, definition("1.4", "normal_pressure_angle").unit
    ('°', 'deg')
    """
    known = _by_id().get(name, ())
    here = [one for one in known if one.holds_in(version)] or list(known)
    if not here:
        return None

    def fits(one: Definition) -> tuple[bool, int, bool]:
        """Order of preference: of the component, of few others, in use today."""
        own = component in one.components
        return own, -len(one.components) if own else 0, newest(one.number).until == NEWEST

    best = max(here, key=fits)
    if newest(best.number).until != NEWEST:  # joined with that of another component
        joined = [one for one in known if newest(one.number).until == NEWEST]
        best = joined[0] if joined and joined[0].unit == best.unit else best
    return best
