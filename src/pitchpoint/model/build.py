# SPDX-License-Identifier: Apache-2.0
"""Creation of a `Model` from plain data: read, check, then raise all problems or return."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.model import sections
from pitchpoint.model.checks.validate import check
from pitchpoint.model.component import without_arrays
from pitchpoint.model.keys import BAD, keys_of
from pitchpoint.model.model import Model
from pitchpoint.model.origin import Origin
from pitchpoint.model.parts import Parts
from pitchpoint.model.reading.laws import MATERIALS, note_materials
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.sections import GROUPS


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
    reader.unknown(data, keys, ())
    values = {}
    for name, key in keys.items():
        if data.get(name) is not None:
            value = reader.keyed(key, without_arrays(data[name]), (name,))
            if value is not BAD:
                values[name] = value
            if name == MATERIALS and isinstance(data[name], Mapping):
                note_materials(reader, values.get(name, {}), data[name])
    moving = ("gears", "bevel_gears", "bodies", "shafts", "elastic_bodies")
    if not any(values.get(g) or (g,) in reader.tainted for g in moving):
        reader.problem(("gears",), "is missing: a model has a gear or a body", remedy="add gears: or bodies:")
    parts = Parts.of(values)
    parts.names = {
        g: {str(n) for n in data[g]} for g in (*GROUPS, *parts.others) if isinstance(data.get(g), Mapping)
    }
    check(parts, reader)
    if reader.problems:
        ordered = sorted(
            reader.problems, key=lambda p: (p.file or "", p.line if p.line is not None else 10**9)
        )
        raise ModelError(ordered, file)
    origin = Origin(reader.sources, tuple(reader.bare), files)
    return Model.from_parts(parts, values, file, reader.lines, allow_code=reader.allow_code, origin=origin)
