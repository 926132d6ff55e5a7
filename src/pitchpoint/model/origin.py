# SPDX-License-Identifier: Apache-2.0
"""Contents of a model file beyond the values of a model: formulas with parameters, numbers without unit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from pitchpoint.model.keys import Place


class Source(NamedTuple):
    """Value of a key as written, with the names of the parameters in it."""

    data: Any
    names: frozenset[str]


class Bare(NamedTuple):
    """Number without unit that is rarely meant in SI units."""

    place: Place
    value: float
    dimension: str


@dataclass(frozen=True)
class Origin:
    """Notes of the reader of a file.

    Parameters
    ----------
    sources
        Values with parameters as written, by the path of their keys; `Model.replace` reads them again if a
        parameter changes, and a model is written with them.
    bare
        Numbers without unit that are rarely meant in SI units.
    files
        Included files.
    """

    sources: Mapping[Place, Source] = field(default_factory=dict)
    bare: tuple[Bare, ...] = ()
    files: tuple[str, ...] = ()


def drop(sources: dict[Place, Source], place: Place) -> None:
    """Remove what was written at a path and below it."""
    for old in [p for p in sources if p[: len(place)] == place]:
        del sources[old]
