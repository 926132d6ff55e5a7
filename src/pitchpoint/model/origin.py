# SPDX-License-Identifier: Apache-2.0
"""Contents of a model file beyond the values of a model: formulas with parameters, numbers without unit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

from pitchpoint.model.keys import Key, Place

if TYPE_CHECKING:
    from pitchpoint.model.reading.bare_numbers import Bare
    from pitchpoint.model.reading.reader import Reader

KEPT = ("quantity", "quantities", "integer", "value")
"""Kinds of keys whose texts are kept as written even without parameters."""


class Source(NamedTuple):
    """Value of a key as written, with the names of the parameters in it; the writer uses it again."""

    data: Any
    names: frozenset[str]


@dataclass(frozen=True)
class Origin:
    """Notes of the reader of a file.

    Parameters
    ----------
    sources
        Values with parameters, and texts of numbers such as ``"0.05 m"``, as written, by the path of their
        keys; `Model.replace` reads them again if a parameter changes, and a model is written with them.
    bare
        Numbers without unit that are rarely meant in SI units.
    files
        Included files.
    """

    sources: Mapping[Place, Source] = field(default_factory=dict)
    bare: tuple[Bare, ...] = ()
    files: tuple[str, ...] = ()


def is_kept(key: Key, data: Any, path: Place) -> bool:
    """Whether a value without parameters is kept as written: a number, or numbers, with units.

    Entries of lists are not kept: `Model.replace` has no paths for them.
    """
    if any(isinstance(step, int) for step in path):
        return False
    if key.kind == "quantities":
        return isinstance(data, list) and any(isinstance(entry, str) for entry in data)
    return isinstance(data, str) and key.kind in KEPT


def drop(reader: Reader, place: Place) -> None:
    """Remove what was written at a path and below it, before it is replaced."""
    for old in [p for p in reader.sources if p[: len(place)] == place]:
        del reader.sources[old]
    reader.bare[:] = [bare for bare in reader.bare if bare.place[: len(place)] != place]
