# SPDX-License-Identifier: Apache-2.0
"""Creation of a `Model` from plain data: read, check, then raise all problems or return."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.model import sections
from pitchpoint.model.checks.validate import check
from pitchpoint.model.component import without_arrays
from pitchpoint.model.keys import BAD, INCLUDE, keys_of, remedy_for_key
from pitchpoint.model.model import Model
from pitchpoint.model.origin import Origin
from pitchpoint.model.parts import Parts
from pitchpoint.model.reading.laws import MATERIALS, note_materials
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.sections import GROUPS

MANY = 4
"""Number of values with the same unknown name from which they are one problem."""


def build_model(data: Any, reader: Reader, file: str | None = None, files: tuple[str, ...] = ()) -> Model:
    """Create a model from the nested mappings of a file.

    Parameters
    ----------
    data
        Mappings, lists, strings and numbers.
    reader
        Reader with the line numbers of the file, if any; its previous problems are reported too.
    file
        Name of the file for messages.
    files
        Names of the included files.

    Raises
    ------
    ModelError
        With all problems, in the order of the file.
    """
    if not isinstance(data, Mapping):
        what = "is empty" if data is None else "is not a mapping of keys"
        raise ModelError([*reader.problems, Message("model", what, remedy="begin with gears:", line=1)], file)
    keys = keys_of(Model)
    for name in [name for name in data if name not in keys]:
        sections.find(str(name))  # register sections of other packages
    reader.unknown(data, {INCLUDE: None, **keys} if reader.lines else keys, ())
    names = _names(data, (*GROUPS, *(n for n in keys if sections.is_other(n))))
    values = {}
    for name, key in keys.items():
        if data.get(name) is not None:
            value = reader.keyed(key, without_arrays(data[name]), (name,))
            if value is not BAD:
                values[name] = value
        if name == MATERIALS and name in names:
            note_materials(reader, values.get(name, {}), names[name])
    moving = ("gears", "bevel_gears", "bodies", "shafts", "elastic_bodies")
    if not any(values.get(g) or (g,) in reader.tainted for g in moving):
        reader.problem(("gears",), "is missing: a model has a gear or a body", remedy="add gears: or bodies:")
    parts = Parts.of(values)
    parts.names = names
    parts.planet_names = _planet_names(data.get("planetary_stages"))
    check(parts, reader)
    if reader.problems:
        ordered = sorted(
            _in_one(reader.problems), key=lambda p: (p.file or "", p.line if p.line is not None else 10**9)
        )
        raise ModelError(ordered, file)
    origin = Origin(reader.sources, tuple(reader.bare), files)
    return Model.from_parts(parts, values, file, reader.lines, allow_code=reader.allow_code, origin=origin)


def _in_one(problems: list[Message]) -> list[Message]:
    """Problems, with those of one unknown name that many places have in one."""
    groups: dict[tuple[str | None, ...], list[Message]] = {}
    for problem in problems:
        groups.setdefault((problem.value, problem.text, problem.remedy), []).append(problem)
    found = []
    for (_, text, remedy), each in groups.items():
        names = str(text).startswith("names the ") and str(text).endswith("which does not exist")
        unread = "unknown name " in str(text)
        if len(each) < MANY or not (names or unread or "in parameters" in str(remedy)):
            found += each
            continue
        so = "so do" if names else "nor can" if unread else "so are"
        first = each[0]
        lines = sorted(
            {p.line for p in each[1:] if p.line not in (None, first.line) and p.file == first.file}
        )
        at = f": {'lines' if lines[1:] else 'line'} {', '.join(map(str, lines))}" if lines else ""
        found.append(first.changed(text=f"{text}; {so} {len(each) - 1} other values{at}"))
    return found


def _names(data: Mapping[Any, Any], groups: tuple[str, ...]) -> dict[str, set[str]]:
    """Names of the components of each section, readable or not, also of a section with a misspelt key or
    written as a list."""
    found: dict[str, set[str]] = {}
    for key, part in data.items():
        group = key if key in groups else remedy_for_key(key, keys_of(Model))[0]
        if group in groups and (key in groups or group not in data):
            entries = part if isinstance(part, list) else [part]
            names = {str(name) for entry in entries if isinstance(entry, Mapping) for name in entry}
            if names or isinstance(part, Mapping):
                found[group] = names
    return found


def _planet_names(stages: Any) -> dict[str, str]:
    """`planet_name` as written in every planetary stage that gives it."""
    found = stages.items() if isinstance(stages, Mapping) else ()
    return {str(n): str(s["planet_name"]) for n, s in found if isinstance(s, Mapping) and "planet_name" in s}
