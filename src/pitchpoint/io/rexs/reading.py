# SPDX-License-Identifier: Apache-2.0
"""Reading of REXS files of versions 1.0 to 2.0.0 as a `RexsModel`."""

from __future__ import annotations

import re
from functools import partial
from pathlib import Path
from typing import Any

from pitchpoint.core.errors import Message, ModelError, UnitError
from pitchpoint.core.nearest import did_you_mean
from pitchpoint.io.rexs import tables
from pitchpoint.io.rexs.container import read_raw
from pitchpoint.io.rexs.document import (
    RexsAttribute,
    RexsComponent,
    RexsLoadCase,
    RexsLoadSpectrum,
    RexsModel,
    RexsRelation,
    Value,
)
from pitchpoint.io.rexs.raw import RawAttribute, RawComponent, RawModel, RawSpectrum
from pitchpoint.io.rexs.sources import with_sources
from pitchpoint.io.rexs.units import RexsUnit, unit_of
from pitchpoint.io.rexs.values import BadValueError, LostValueError, typed

OWN = "custom_"
"""Beginning of the ids that programs may define for themselves."""


def read_rexs(path: str | Path, *, external: bool = True) -> RexsModel:
    """Read a REXS file: XML, JSON or ZIP, versions 1.0 to 2.0.0.

    Parameters
    ----------
    path
        The file.
    external
        Also read the files that `data_source` names, and take the components from there.

    Returns
    -------
    RexsModel
        Components with values in SI units under the ids of the newest version.

    Raises
    ------
    ModelError
        With all problems of the file: place, value, limit, remedy.
    """
    file = Path(path)
    try:
        found = _Assembly(read_raw(file), str(file)).model()
        if external:
            found = with_sources(found, file, partial(read_rexs, external=False))
    except ModelError as error:
        raise ModelError(error.problems, str(file)) from None
    return found


def version_of(text: str) -> str | None:
    """Version of REXS by the text of a file: 2.0 is 2.0.0; None for an unknown version.

    >>> version_of("1.4"), version_of("2.0"), version_of("3.1") is None
    ('1.4', '2.0.0', True)
    """
    if text in tables.VERSIONS:
        return text
    match = re.fullmatch(r"(\d+)\.(\d+)(\.\d+)?", text)
    if match is None:
        return None
    short = f"{match[1]}.{match[2]}"
    return next((v for v in tables.VERSIONS if v == short or v.startswith(f"{short}.")), None)


class _Assembly:
    """Conversion of the raw contents of a file; problems are collected."""

    def __init__(self, raw: RawModel, file: str) -> None:
        self.raw, self.file = raw, file
        self.problems: list[Message] = []
        self.remarks: list[Message] = []
        self.lost: dict[str, int] = {}
        self.version = tables.NEWEST

    def model(self) -> RexsModel:
        """The whole model, or all problems."""
        head = self.raw.head
        version = version_of(head.get("version", ""))
        if version is None:
            listed = ", ".join(tables.VERSIONS)
            text = "is not a version of REXS" if "version" in head else "is missing"
            value = repr(head["version"][:40]) if "version" in head else None
            raise ModelError([Message("model.version", text, value, listed, "export with one of these")])
        self.version = version
        components: dict[int, RexsComponent] = {}
        for part in self.raw.components:
            number = self.number(part.id, part.where, "component")
            if number is None:
                continue
            if number in components:
                self.problem(part.where, "is the id of two components", str(number), "give each its own id")
            components[number] = self.component(part, number)
        relations = self.relations(components)
        spectra = tuple(self.spectrum(one, components) for one in self.raw.spectra)
        self.references(components)
        if self.lost:
            self.say_lost()
        if self.problems:
            raise ModelError(self.problems)
        return RexsModel(
            version,
            " ".join(filter(None, (head.get("applicationId"), head.get("applicationVersion")))),
            head.get("date", ""),
            components,
            tuple(relations),
            spectra,
            self.file,
            tuple(self.remarks),
        )

    # --- messages -------------------------------------------------------------------------------------------
    def problem(
        self,
        where: str,
        text: str,
        value: str | None = None,
        remedy: str | None = None,
        limit: str | None = None,
    ) -> None:
        """Add a problem."""
        self.problems.append(Message(where, text, value, limit, remedy))

    def remark(self, where: str, text: str, value: str | None = None, remedy: str | None = None) -> None:
        """Add a remark."""
        self.remarks.append(Message(where, text, value, remedy=remedy, kind="remark"))

    def say_lost(self) -> None:
        """One remark on all values that the writing program has lost."""
        listed = ", ".join(f"{name} ({count})" for name, count in sorted(self.lost.items()))
        self.remark(
            "",
            f"has false instead of {sum(self.lost.values())} numbers, texts and vectors: {listed}",
            remedy="the program that wrote the file has lost them; use its XML file",
        )

    # --- parts ----------------------------------------------------------------------------------------------
    def number(self, value: Any, where: str, what: str) -> int | None:
        """Id as a number."""
        try:
            found = typed(value, None, "integer", unit_of("none"))
        except BadValueError:
            shown = None if value is None else repr(value)[:40]
            self.problem(where, f"is not the id of a {what}", shown, "ids are whole numbers")
            return None
        return int(found)  # type: ignore[arg-type]

    def component(self, part: RawComponent, number: int) -> RexsComponent:
        """A component with its values."""
        kind = part.type
        if not kind:
            self.problem(part.where, f"component {number} has no type", remedy="give its type")
        elif kind not in tables.component_types() and not kind.startswith(OWN):
            guess = did_you_mean(kind, tables.component_types())
            self.remark(part.where, "is not a component of REXS", f"{kind[:60]!r}", guess.strip() or None)
        return RexsComponent(number, kind, part.name, self.attributes(part, number, kind), part.where)

    def attributes(self, part: RawComponent, number: int, kind: str) -> dict[str, RexsAttribute]:
        """Values of a component, by the newest id."""
        found: dict[str, RexsAttribute] = {}
        for raw in part.attributes:
            where = f"{raw.where}, {kind} {number}" if kind else raw.where
            attribute = self.attribute(raw, kind, f"{where}, {raw.id[:60]}")
            if attribute is None:
                continue
            if attribute.id in found:
                self.problem(attribute.where, "is given twice", remedy="keep one of them")
            found[attribute.id] = attribute
        return found

    def attribute(self, raw: RawAttribute, kind: str, where: str) -> RexsAttribute | None:
        """One value; None if it is empty or lost."""
        if raw.value is None:
            return None
        known = tables.definition(self.version, raw.id, kind)
        if known is None:
            if not raw.id.startswith(OWN):
                guess = did_you_mean(raw.id, tables.ids_of(self.version)).strip()
                self.remark(where, f"is unknown in REXS {self.version}", remedy=guess or None)
            return RexsAttribute(raw.id, None, _plain(raw.value), raw.id, raw.unit or "none", where)
        newest = tables.newest(known.number)
        unit = self.unit(raw, known, newest, where)
        if unit is None:
            return None
        try:
            value = typed(raw.value, raw.kind, known.type, unit)
        except LostValueError:
            self.lost[known.id] = self.lost.get(known.id, 0) + 1
            return None
        except BadValueError as error:
            shown = repr(raw.value)
            self.problem(
                where,
                f"is {error}",
                shown if len(shown) <= 40 else f"{shown[:37]}...",
                limit=f"{known.type} in REXS {self.version}",
            )
            return None
        return RexsAttribute(newest.id, known.number, value, raw.id, raw.unit or known.unit, where)

    def unit(
        self, raw: RawAttribute, known: tables.Definition, newest: tables.Definition, where: str
    ) -> RexsUnit | None:
        """Unit of a value, of the dimension of its attribute; None if it has another one."""
        name = known.unit if raw.unit is None else raw.unit
        try:
            unit = unit_of(name)
        except UnitError as error:
            self.problem(where, f"{error}", limit=f"{known.unit} in REXS {self.version}")
            return None
        expected, now = unit_of(known.unit), unit_of(newest.unit)
        if unit.si != expected.si:
            if unit.si == "1" and isinstance(
                raw.value, list
            ):  # directions without unit, as in newer versions
                return unit
            if unit.si == now.si:
                return unit
            self.problem(
                where,
                "is the unit of another quantity",
                repr(name[:40]),
                limit=f"{known.unit} in REXS {self.version}",
            )
            return None
        if now.si != expected.si or now.offset != expected.offset:  # a correction of REXS: the number remains
            return now
        return unit

    def relations(self, components: dict[int, RexsComponent]) -> list[RexsRelation]:
        """Relations between existing components."""
        found = []
        for raw in self.raw.relations:
            number = self.number(raw.id, raw.where, "relation")
            order = None if raw.order is None else self.number(raw.order, raw.where, "place in an order")
            roles: dict[str, int] = {}
            for role, id in raw.refs:
                part = self.number(id, raw.where, "component")
                if part is None:
                    continue
                if part not in components:
                    self.problem(
                        raw.where,
                        f"names the component {part}, which does not exist",
                        f"{raw.type} {raw.id}",
                        "the file is incomplete: export it again",
                    )
                if role in roles:
                    self.problem(raw.where, f"has the role {role[:40]!r} twice", f"{raw.type} {raw.id}")
                roles[role] = part
            if number is not None:
                found.append(RexsRelation(number, raw.type, roles, order, raw.where))
        return found

    def spectrum(self, raw: RawSpectrum, components: dict[int, RexsComponent]) -> RexsLoadSpectrum:
        """A load spectrum."""
        cases = []
        for id, parts in raw.cases:
            number = self.number(id, raw.where, "load case")
            if number is not None:
                cases.append(RexsLoadCase(number, self.of_case(parts, components)))
        number = self.number(raw.id, raw.where, "load spectrum") or 0
        return RexsLoadSpectrum(number, tuple(cases), self.of_case(raw.accumulation, components))

    def of_case(
        self, parts: list[RawComponent], components: dict[int, RexsComponent]
    ) -> dict[int, dict[str, RexsAttribute]]:
        """Values of the components of a load case."""
        found: dict[int, dict[str, RexsAttribute]] = {}
        for part in parts:
            number = self.number(part.id, part.where, "component")
            if number is None:
                continue
            if number not in components:
                self.problem(part.where, f"names the component {number}, which does not exist")
                continue
            found[number] = self.attributes(part, number, components[number].type)
        return found

    def references(self, components: dict[int, RexsComponent]) -> None:
        """Check that references to components lead somewhere."""
        for part in components.values():
            for name, attribute in part.attributes.items():
                number = attribute.number
                if number is None or tables.newest(number).type != "reference_component":
                    continue
                outside = name == "referenced_component_id"
                if not outside and attribute.value not in components:
                    self.problem(
                        attribute.where,
                        f"names the component {attribute.value}, which does not exist",
                        remedy="the file is incomplete: export it again",
                    )


def _plain(value: Any) -> Value:
    """Value of an unknown attribute, as it is."""
    if isinstance(value, list):
        return tuple(_plain(one) for one in value)
    return value if isinstance(value, bool | int | float | str) else str(value)
