# SPDX-License-Identifier: Apache-2.0
"""Origin of records in the model file: component and line for messages of failed computations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import ModelError
from pitchpoint.elements import registry
from pitchpoint.elements.kind import DRIVE, Kind

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.system.system import System


def source(system: System, kind: str, name: str) -> str:
    """Path of a record in the model file, such as "loads.push (line 6)".

    Parameters
    ----------
    system
        The compiled system.
    kind, name
        Kind and name of the record; a component may have several records such as NAME.x or NAME.2.

    Returns
    -------
    str
        Path and line; kind and name if there is no model or no component with this name.
    """
    described = registry.find(kind)
    if described.role == DRIVE and (driven := _drive(system, name)):
        return driven
    found = _component(system, described, name)
    if found is None:
        return f"{described.words} {name!r}"
    section, component = found
    return named(system, (section, component), f"{section}.{name}")


def named(system: System, place: tuple[str, ...], name: str = "") -> str:
    """Name of a component with its line in the model file, if known; default name: its path."""
    line = system.model.line(place) if system.model is not None else None
    return (name or ".".join(place)) + (f" (line {line})" if line is not None else "")


def coordinate_source(system: System, name: str) -> str:
    """Name of a coordinate with the line of its body: "rotor.z (line 4)"."""
    body = name.rpartition(".")[0]
    for section in ("bodies", "shafts", "elastic_bodies") if system.model is not None else ():
        line = system.model.line((section, body.partition(".")[0])) if system.model is not None else None
        if line is not None:
            return f"{name} (line {line})"
    return name


def _drive(system: System, name: str) -> str:
    """Path of a drive in its scenario; "" without a model."""
    if system.model is None or system.scenario is None:
        return ""
    scenario = next((n for n, s in system.model.scenarios.items() if s is system.scenario), "")
    place = f"scenarios.{scenario}.drive.{name}" if scenario else f"drive.{name}"
    return named(system, ("scenarios", scenario, "drive", name), place)


def row_source(system: System, row: int) -> str:
    """Path of a constraint row in the model file, by its number; see `source`."""
    words = system.layout.rows[row]
    kind, _, name = words.partition(" ")
    return source(system, kind, name) if _component(system, registry.find(kind), name) else words


def row_unit(system: System, row: int) -> str:
    """Unit of the residual of a constraint row, with a leading blank; "" for angles and ratios."""
    kind = registry.find(system.layout.rows[row].partition(" ")[0])
    bank = system.records[kind.name]
    unit = kind.row_unit(bank[(bank["row"] <= row) & (row < bank["row"] + kind.rows)][0])
    return f" {unit}" if unit else ""


def with_lines(model: Model, error: ModelError) -> ModelError:
    """Copy of the error with line numbers added to the problems that have a path but no line."""
    found = [p if p.line is not None else p.changed(line=model.line_of(p.where)) for p in error.problems]
    return ModelError(found, error.file or model.file)


def _component(system: System, kind: Kind, name: str) -> tuple[str, str] | None:
    """Section and name of the component of a record."""
    if system.model is None:
        return None
    for section in kind.sections:
        known = getattr(system.model, section, {})
        for candidate in (name, name.rpartition(".")[0], name.partition(".")[0]):
            if candidate in known:
                return section, candidate
    return None
