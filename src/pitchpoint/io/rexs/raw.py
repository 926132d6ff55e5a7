# SPDX-License-Identifier: Apache-2.0
"""Contents of a REXS file before its values are understood: the same for XML and JSON."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

MOST_BYTES = 256 * 2**20
"""Largest file [bytes]: gear units with reduced housings have some ten MB."""
MOST_PARTS = 5_000_000
"""Largest number of elements of an XML file."""


@dataclass(frozen=True)
class Coded:
    """Array or matrix in base64: "int32", "float32" or "float64", columns after each other."""

    code: str
    text: str
    rows: int | None = None
    columns: int | None = None


@dataclass
class RawAttribute:
    """Attribute with the text of its value.

    Attributes
    ----------
    id, unit
        Id; unit as written, None without.
    value
        Text, JSON value, nested lists of these, or `Coded`; None for an empty value.
    kind
        Value type as the key of a JSON file names it; None in XML.
    where
        Place in the file.
    """

    id: str
    unit: str | None
    value: Any = None
    kind: str | None = None
    where: str = ""


@dataclass
class RawComponent:
    """Component with its attributes; of a load case without type."""

    id: Any
    type: str
    name: str
    where: str
    attributes: list[RawAttribute] = field(default_factory=list)


@dataclass
class RawRelation:
    """Relation with its references: role and id."""

    id: Any
    type: str
    order: Any
    where: str
    refs: list[tuple[str, Any]] = field(default_factory=list)


@dataclass
class RawSpectrum:
    """Load spectrum: its load cases (id, components) and the accumulated values."""

    id: Any
    where: str
    cases: list[tuple[Any, list[RawComponent]]] = field(default_factory=list)
    accumulation: list[RawComponent] = field(default_factory=list)


@dataclass
class RawModel:
    """Whole file."""

    head: dict[str, str] = field(default_factory=dict)
    relations: list[RawRelation] = field(default_factory=list)
    components: list[RawComponent] = field(default_factory=list)
    spectra: list[RawSpectrum] = field(default_factory=list)
