# SPDX-License-Identifier: Apache-2.0
"""Values that replace those of a model file while it is read, such as those of ``--set``.

`Model.replace_all` requires a valid model. If the file is refused, the new values take the place of those of
the file in its data, so that they can repair it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from pitchpoint.core.errors import Message
from pitchpoint.core.nearest import hint
from pitchpoint.model.keys import Key, Place, keys_of
from pitchpoint.model.model import Model
from pitchpoint.model.parameters import SECTION, in_its_unit
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.replace import whole
from pitchpoint.model.show import dotted

Paths = Mapping[str, str]
"""Paths with new values, and the name of the option or argument that gives each of them."""


def put(data: Any, changes: Mapping[str, Any]) -> tuple[Any, list[Message]]:
    """Data of a model file with new values, and the problems of their paths.

    Parameters
    ----------
    data
        Nested mappings of the file; not modified.
    changes
        New values by path as for `Model.replace`; None removes a key. Missing mappings inside a component
        are added, but no components of a section.

    Examples
    --------
    >>> put({"loads": {"drive": {"torque": "3 kg"}}}, {"loads.drive.torque": "3 N m"})
    ({'loads': {'drive': {'torque': '3 N m'}}}, [])
    """
    report = Reader()
    if not isinstance(data, Mapping):
        return data, report.problems
    if any(path.split(".")[0] == SECTION for path in changes):
        known = Reader()
        known.value(Key("parameters", ""), data.get(SECTION) or {}, (SECTION,))
        report.parameters = known.parameters
    for path, value in changes.items():
        data = _put(data, tuple(path.split(".")), value, report, ())
    return data, report.problems


def _put(part: Any, path: tuple[str, ...], value: Any, report: Reader, at: Place) -> Any:
    """Copy of a mapping with the value at a path replaced."""
    name, *rest = path
    if rest and name not in part and f"{name}.{rest[0]}" in part:  # JOINT.COORDINATE is one name
        name, *rest = f"{name}.{rest[0]}", *rest[1:]
    here = (*at, name)
    if at == () and name not in part and name not in keys_of(Model):
        report.unknown({name: None}, keys_of(Model), ())
        return part
    key = keys_of(Model).get(str(at[0])) if len(at) == 1 else None
    if name not in part and key is not None and key.kind in ("components", SECTION):
        report.problem(here, "does not exist", remedy=hint(name, map(str, part)))
        return part
    if rest:
        below = {} if part.get(name) is None else part[name]
        if at == (SECTION,):
            below = below if isinstance(below, Mapping) else {"value": below}
        if not isinstance(below, Mapping):
            remedy = f"replace the whole value above it: {whole(here, rest, value)}"
            report.problem((*here, rest[0]), "is below a key without keys", remedy=remedy)
            return part
        return {**part, name: _put(below, tuple(rest), value, report, here)}
    if value is None:
        return {n: v for n, v in part.items() if n != name}
    if at == (SECTION,) and not isinstance(value, Mapping):
        value = in_its_unit(value, name, report)
        if isinstance(part[name], Mapping):
            value = {**part[name], "value": value}
    return {**part, name: value}


def leads_to(data: Any, path: str) -> bool:
    """Whether a path leads to a value in the data of a model file."""
    for name in path.split("."):
        if not isinstance(data, Mapping) or name not in data:
            return False
        data = data[name]
    return True


def named(
    messages: Iterable[Message], paths: Paths, lines: Mapping[Place, int] | None = None
) -> tuple[Message, ...]:
    """Messages with the option in place of the line for values given by options.

    Parameters
    ----------
    messages
        Problems or remarks.
    paths
        Names of the options by path.
    lines
        Lines of the file by path; messages on other values without line get theirs.

    Examples
    --------
    >>> print(*named([Message("a.b.c", "is wrong", line=4)], {"a.b": "--set"}))
    a.b.c (--set): is wrong
    """
    in_file = {dotted(place): line for place, line in (lines or {}).items() if place}
    found = []
    for message in messages:
        where = message.where
        if path := next((p for p in paths if _concerns(where, p, in_file)), None):
            message = message.changed(line=None, file=paths[path])
        elif message.line is None:
            while where and where not in in_file:
                where = where.rpartition(".")[0]
            message = message.changed(line=in_file.get(where))
        found.append(message)
    return tuple(dict.fromkeys(found))


def _concerns(where: str, path: str, in_file: Mapping[str, int]) -> bool:
    """Whether a message is on the value of a path, or on a key above it that only the path has."""
    return f"{where}.".startswith(f"{path}.") or (path.startswith(f"{where}.") and where not in in_file)
