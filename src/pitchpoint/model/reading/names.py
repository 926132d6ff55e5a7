# SPDX-License-Identifier: Apache-2.0
"""Names of components."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.model.keys import Place

if TYPE_CHECKING:
    from pitchpoint.model.reading.reader import Reader


USABLE = "use letters, digits, '_' and '-', without dots and brackets"
"""Remedy for a name that is not usable."""


def good_name(reader: Reader, name: Any, path: Place, dotted: bool) -> bool:
    """Check a name: it must be usable in paths and channels; `dotted` permits JOINT.COORDINATE."""
    text = str(name)
    first, dot, rest = text.partition(".")
    if dotted and dot and first and rest and "." not in rest:
        return good_name(reader, first, path, False) and good_name(reader, rest, path, False)
    if not isinstance(name, bool | float) and is_usable(text):
        return True
    reader.problem((*path, text), "is not a usable name", remedy=USABLE)
    return False


def is_usable(text: str) -> bool:
    """Whether a text can be a name in paths and channels.

    Examples
    --------
    >>> is_usable("planet_1"), is_usable("stage.1")
    (True, False)
    """
    return bool(text) and not set(text) & set(".[]{}\n\t,:/\\\"'") and text.isprintable()
