# SPDX-License-Identifier: Apache-2.0
"""A gear unit as a REXS file describes it: components, relations, load spectra.

Values are in SI units and radians under the ids of the newest version of REXS, for files of all versions.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TypeAlias

from pitchpoint.core.errors import Message

Value: TypeAlias = float | int | bool | str | tuple["Value", ...]
"""A number, a truth value, a word, or an array or matrix of these as nested tuples."""


@dataclass(frozen=True)
class RexsAttribute:
    """One value of a component.

    Attributes
    ----------
    id
        Id in the newest version of REXS; that of the file for ids that REXS does not define.
    number
        Numeric id, the same in all versions; None for ids that REXS does not define.
    value
        Value in SI units: m, rad, N, kg, s, K; rotational speeds in rad/s, shares in 1. Units of hardness and
        wear are unchanged. References are the ids of components. Of an id that REXS does not define: as in
        the file.
    written_id, unit
        Id and unit of the file; the unit is that of the schema if the file has none.
    where
        Place in the file: "line 12", or a path of JSON keys.
    """

    id: str
    number: int | None
    value: Value
    written_id: str = ""
    unit: str = "none"
    where: str = ""


@dataclass(frozen=True)
class RexsComponent:
    """One part, material, stage or tool.

    Attributes
    ----------
    id
        Number of the component in its file; components of external files have new numbers.
    type
        Type, such as "cylindrical_gear".
    name
        Name for people; may be empty.
    attributes
        Values by id.
    where
        Place in the file.
    file
        External file of the component; empty for the file itself.
    """

    id: int
    type: str
    name: str = ""
    attributes: Mapping[str, RexsAttribute] = field(default_factory=dict)
    where: str = ""
    file: str = ""

    def get(self, name: str) -> Value | None:
        """Value of an attribute; None if it is not given."""
        found = self.attributes.get(name)
        return None if found is None else found.value

    def __str__(self) -> str:
        """Type, number and name, as in messages."""
        return f"{self.type} {self.id}" + (f" ({self.name})" if self.name else "")


@dataclass(frozen=True)
class RexsRelation:
    """Relation of several components, each in a role.

    Attributes
    ----------
    id, type
        Number in its file, and type such as "assembly".
    roles
        Ids of the components by role.
    order
        Place in an ordered relation; None without order.
    where
        Place in the file.
    """

    id: int
    type: str
    roles: Mapping[str, int]
    order: int | None = None
    where: str = ""


@dataclass(frozen=True)
class RexsLoadCase:
    """Values of one load case: by id of the component, then by id of the attribute."""

    id: int
    components: Mapping[int, Mapping[str, RexsAttribute]]


@dataclass(frozen=True)
class RexsLoadSpectrum:
    """Load cases, and values accumulated over them."""

    id: int
    cases: tuple[RexsLoadCase, ...]
    accumulation: Mapping[int, Mapping[str, RexsAttribute]] = field(default_factory=dict)


@dataclass(frozen=True)
class RexsModel:
    """Contents of a REXS file.

    Attributes
    ----------
    version
        Version of REXS in the file.
    application, date
        Program that wrote the file, and when.
    components
        Components by id.
    relations
        Relations in the order of the file.
    load_spectra
        Load spectra in the order of the file.
    file
        Name of the file.
    remarks
        What was unclear in the file, or lost by the program that wrote it, without preventing its reading.
    """

    version: str
    application: str = ""
    date: str = ""
    components: Mapping[int, RexsComponent] = field(default_factory=dict)
    relations: tuple[RexsRelation, ...] = ()
    load_spectra: tuple[RexsLoadSpectrum, ...] = ()
    file: str = ""
    remarks: tuple[Message, ...] = ()

    def of_type(self, *types: str) -> tuple[RexsComponent, ...]:
        """Components of some types, in the order of the file."""
        return tuple(c for c in self.components.values() if c.type in types)

    def related(self, type: str, **roles: int) -> Iterator[RexsRelation]:
        """Relations of a type in which one or several components have given roles.

        Examples
        --------
        >>> model = RexsModel("1.5", relations=(RexsRelation(1, "assembly", {"assembly": 4, "part": 7}),))
        >>> [r.roles["part"] for r in model.related("assembly", assembly=4)]
        [7]
        """
        role, number = next(iter(roles.items()))
        for relation in self._by_role.get((type, role, number), ()):
            if all(relation.roles.get(r) == n for r, n in roles.items()):
                yield relation

    @cached_property
    def _by_role(self) -> dict[tuple[str, str, int], list[RexsRelation]]:
        """Relations by type, and by role and id of each component."""
        found: dict[tuple[str, str, int], list[RexsRelation]] = {}
        for relation in self.relations:
            for role, number in relation.roles.items():
                found.setdefault((relation.type, role, number), []).append(relation)
        return found
