# SPDX-License-Identifier: Apache-2.0
"""Names of components."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.model.keys import Place

if TYPE_CHECKING:
    from pitchpoint.model.reading.reader import Reader


def good_name(reader: Reader, name: Any, path: Place, dotted: bool) -> bool:
    """Check a name: it must be usable in paths and channels; `dotted` permits JOINT.COORDINATE."""
    text = str(name)
    first, dot, rest = text.partition(".")
    if dotted and dot and first and rest and "." not in rest:
        return good_name(reader, first, path, False) and good_name(reader, rest, path, False)
    if (
        not isinstance(name, bool | float)
        and text
        and not set(text) & set(".[]{}\n\t,:/\\\"'")
        and text.isprintable()
    ):
        return True
    reader.problem(
        (*path, text),
        "is not a usable name",
        remedy="use letters, digits, '_' and '-', without dots and brackets",
    )
    return False
