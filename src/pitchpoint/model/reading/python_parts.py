# SPDX-License-Identifier: Apache-2.0
"""Components in place of mappings: some of their values may still be as in a file."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pitchpoint.model.checks.python_components import recheck
from pitchpoint.model.component import Unread, needs_reading
from pitchpoint.model.keys import BAD, Place, keys_of
from pitchpoint.model.reading import formulas

if TYPE_CHECKING:
    from pitchpoint.model.reading.reader import Reader


def finished(reader: Reader, part: Any, path: Place) -> Any:
    """A component with its values checked, and those read that are as in a file; BAD with any problem."""
    found: dict[str, Any] = {}
    for name, key in keys_of(type(part)).items():
        value = getattr(part, name)
        if needs_reading(key, value) or (key.kind == "formula" and formulas.mentions(reader, str(value))):
            reader.within = vars(part)
            data = value.data if isinstance(value, Unread) else value
            found[name] = reader.keyed(key, data, (*path, name))
    before = len(reader.problems)
    recheck(part, path, reader, except_for=found)
    if BAD in found.values() or len(reader.problems) > before:
        return BAD
    return replace(part, **found) if found else part


def wrong_type(reader: Reader, data: Any, allowed: Iterable[type], path: Place) -> Any:
    """Report a component of another class."""
    names = " or ".join(cls.__name__ for cls in allowed)
    return reader.problem(path, "is of the wrong type", value=type(data).__name__, limit=names)
