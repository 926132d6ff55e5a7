# SPDX-License-Identifier: Apache-2.0
"""Conversion of plain mappings (from YAML, JSON or Python) to components; all problems are collected.

The reader does not access model files: it receives the data and, if available, the line numbers of the keys.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from numbers import Real
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import Message
from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.component import as_written
from pitchpoint.model.keys import BAD, TYPE, Key, Place, defaults_of, keys_of, remedy_for_key
from pitchpoint.model.origin import Source, is_kept
from pitchpoint.model.reading import (
    data_files,
    forms,
    formulas,
    laws,
    mechanism,
    names,
    python_parts,
    ranges,
    signals,
)
from pitchpoint.model.reading.bare_numbers import Bare
from pitchpoint.model.show import as_list, as_mapping, dotted, entries, example, shown

if TYPE_CHECKING:
    from pitchpoint.core.formula.formula import Amount

MANY = 1000
"""Length of lists from which the limit is not stated."""
WHOLE = ("list", "tooth_profile")
"""Kinds of keys whose components have no path of their own in `Model.replace`."""


@dataclass
class Reader:
    """Converts data to components and collects problems.

    Parameters
    ----------
    lines
        Line number for each path, from 1; empty without a file.
    allow_code
        Whether Python functions are permitted.
    directory
        Directory of relative file names.
    within
        Data of the component that is being read, for values that depend on other keys.
    aliases
        Paths in the file of components that represent others: SECTION, NAME or that with one or two keys.
    parameters, unreadable, materials
        Parameters by name, names of those without value; materials by name, None if unreadable.
    used
        Parameters and materials in the value that is being read.
    sources
        Values with parameters, as written.
    bare
        Numbers without unit that are rarely meant in SI units.
    """

    lines: Mapping[Place, int] = field(default_factory=dict)
    allow_code: bool = False
    directory: str = "."
    problems: list[Message] = field(default_factory=list)
    tainted: set[Place] = field(default_factory=set)
    within: Mapping[str, Any] = field(default_factory=dict)
    aliases: dict[Place, Place] = field(default_factory=dict)
    parameters: Mapping[str, Amount] = field(default_factory=dict)
    unreadable: set[str] = field(default_factory=set)
    used: set[str] = field(default_factory=set)
    materials: Mapping[str, Any] = field(default_factory=dict)
    sources: dict[Place, Source] = field(default_factory=dict)
    bare: list[Bare] = field(default_factory=list)

    def line(self, path: Place) -> int | None:
        """Line of a path, or of the nearest enclosing path in the file."""
        for n in range(len(path), -1, -1):
            if path[:n] in self.lines:
                return self.lines[path[:n]]
        return None

    def problem(
        self,
        path: Place,
        message: str,
        *,
        value: str | None = None,
        limit: str | None = None,
        remedy: str | None = None,
        taint: bool = True,
    ) -> Any:
        """Add a problem; `taint` marks the path, so that consequential problems are not reported."""
        if taint:
            self.taint(path)
        path = self._in_file(path)
        self.problems.append(Message(dotted(path), message, value, limit or None, remedy, self.line(path)))
        if taint:
            self.taint(path)
        return BAD

    def taint(self, path: Place) -> Any:
        """Mark a path as unreadable, so that consequential problems are not reported."""
        self.tainted.update(path[:n] for n in range(1, len(path) + 1))
        return BAD

    def _in_file(self, path: Place) -> Place:
        """Path in the file of a key of a component that represents another."""
        for n in (4, 3, 2):
            if path[:n] in self.aliases:
                return (*self.aliases[path[:n]], *path[n:])
        return path

    def hand_on(self, base: Place, found: Message, taint: bool = True) -> Any:
        """Add a problem of another layer, such as geometry, at the key below `base` that it names."""
        steps = found.where.split(".") if found.where else []
        place: Place = (*base, *(int(step) if step.isdigit() else step for step in steps))
        return self.problem(
            place, found.text, value=found.value, limit=found.limit, remedy=found.remedy, taint=taint
        )

    # --- components -----------------------------------------------------------------------------------
    def component(self, cls: type, data: Any, path: Place) -> Any:
        """Read a mapping as the component class `cls`; BAD when a required key is missing or unreadable.

        A component of this class is returned with all its values read.
        """
        if isinstance(data, cls):
            return python_parts.finished(self, data, path)
        if not isinstance(data, Mapping):
            if hasattr(data, "__dataclass_fields__"):
                return python_parts.wrong_type(self, data, (cls,), path)
            return self.problem(path, "is not a mapping", value=shown(data), remedy=as_mapping(cls, data))
        keys, defaults = keys_of(cls), defaults_of(cls)
        meant = self.unknown(data, keys, path)
        values: dict[str, Any] = {}
        usable = True
        for name, description in keys.items():
            if name not in data:
                if name not in defaults:
                    usable = False
                    if name not in meant:
                        self.missing(path, name, description)
                continue
            value = data[name]
            if value is None and name in defaults and defaults[name] is None:
                continue
            self.within = data
            before = self.tainted.copy() if description.isolated else None
            result = self.keyed(description, value, (*path, name))
            if before is not None:
                self.tainted = before | {p for p in self.tainted if len(p) > len(path)}
            if result is not BAD:
                values[name] = result
            elif name not in defaults:
                usable = False
        return cls(**values) if usable else BAD

    def missing(self, path: Place, name: str, description: Key) -> None:
        """Report a missing required key."""
        self.problem(
            (*path, name), f"is missing: {description.meaning}", remedy=f"add {name}: {example(description)}"
        )

    def unknown(self, data: Mapping[Any, Any], allowed: Iterable[str], path: Place) -> set[str | None]:
        """Report unknown keys, with the nearest spelling; returns the keys that they probably mean."""
        known, meant = set(allowed), set()
        for name in data:
            if name not in known:
                near, remedy = remedy_for_key(name, allowed, cut=data[name] is None)
                taint = near is not None and near not in data
                self.problem((*path, str(name)), "is an unknown key", remedy=remedy, taint=taint)
                meant.add(near)
                if taint:
                    self.taint((*path, str(near)))
        return meant

    def value(self, description: Key, data: Any, path: Place) -> Any:
        """Read the value of one key by its kind."""
        return _READERS[description.kind](self, description, data, path)

    def keyed(self, description: Key, data: Any, path: Place) -> Any:
        """Read the value of a key, and note it as written if it is a text or contains parameters."""
        outer, self.used, known = self.used, set(), len(self.sources)
        result = self.value(description, data, path)
        if (self.parameters or self.materials) and description.kind in WHOLE:
            for place in list(self.sources)[known:]:
                self.used |= self.sources.pop(place).names
        if self.used:
            self.sources[path] = Source(as_written(data), frozenset(self.used))
        elif result is not BAD and is_kept(description, data, path):
            self.sources[path] = Source(data, frozenset())
        self.used = outer
        return result

    # --- plain values -----------------------------------------------------------------------------------
    def number(self, description: Key, data: Any, path: Place) -> Any:
        """Read a quantity; check dimension, finiteness and range."""
        if data is None:
            return self.problem(path, "is empty", remedy=f"write {example(description)}")
        if isinstance(data, bool) or not isinstance(data, Real | str):
            return self.problem(
                path, "is not a number", value=shown(data), remedy=f"write {example(description)}"
            )
        result = formulas.quantity(self, description, data, path)
        return BAD if result is BAD else ranges.within(self, description, data, result, path)

    def whole(self, description: Key, data: Any, path: Place) -> Any:
        """Read a whole number."""
        if data is None:
            return self.problem(path, "is empty", remedy=f"write {example(description)}")
        if isinstance(data, str) and (found := formulas.whole(self, data, path)) is not None:
            if found is BAD:
                return BAD
            data = found
        number = isinstance(data, Real) and not isinstance(data, bool)
        if not number or data != data or data in (math.inf, -math.inf):
            quoted = f"write {data.strip()} without quotes" if ranges.is_quoted_number(data) else ""
            remedy = quoted or f"write {example(description)}"
            return self.problem(
                path, "is not a whole number", value=shown(data), limit=description.limit, remedy=remedy
            )
        value = int(data)
        if data != value:
            remedy = f"write {round(data)}"
            return self.problem(path, "is not a whole number", value=shown(data), remedy=remedy)
        if not description.allows(value):
            closest = int(min(max(value, description.minimum), description.maximum))
            remedy = f"write {-value if description.allows(-value) else closest}"
            return self.problem(
                path, "is out of range", value=shown(data), limit=description.limit, remedy=remedy
            )
        return value

    def word(self, description: Key, data: Any, path: Place) -> Any:
        """Read one of the choices."""
        if isinstance(data, str) and data in description.choices:
            return data
        return self.problem(
            path,
            "is not allowed",
            value=shown(data),
            remedy=f"{did_you_mean(data, description.choices)}allowed are {', '.join(description.choices)}",
        )

    def string(self, description: Key, data: Any, path: Place) -> Any:
        """Read text; numbers are converted to text."""
        if isinstance(data, bool) or not isinstance(data, str | int | float):
            return self.problem(path, "is not a text", value=shown(data))
        return str(data)

    def boolean(self, description: Key, data: Any, path: Place) -> Any:
        """Read true or false."""
        if isinstance(data, bool):
            return data
        return self.problem(
            path, "is neither true nor false", value=shown(data), remedy="write true or false"
        )

    def sequence(self, description: Key, data: Any, path: Place, read: Callable[..., Any]) -> Any:
        """Read a list entry by entry and check its length."""
        low, high = description.length
        if not isinstance(data, list | tuple):
            limit, remedy = entries(low, high) if high < MANY else None, as_list(description, data)
            return self.problem(path, "is not a list", value=shown(data), limit=limit, remedy=remedy)
        if not low <= len(data) <= high:
            limit, has = entries(low, high, len(data)), f"has {entries(len(data), len(data))}"
            return self.problem(path, has, limit=limit, remedy=f"write {example(description)}")
        out = [read(description, entry, (*path, i)) for i, entry in enumerate(data)]
        return BAD if any(entry is BAD for entry in out) else tuple(out)

    def numbers(self, description: Key, data: Any, path: Place) -> Any:
        """Read a list of quantities, or the name of a text file for lists of any length."""
        if isinstance(data, str) and description.length[0] == 0:
            data = data_files.column(self, description, data, path)
            if data is BAD:
                return BAD
            known = len(self.bare)
            found = self.sequence(description, data, path, self.number)
            del self.bare[known:]  # the file has a unit
            return found
        return self.sequence(description, data, path, self.number)

    def names(self, description: Key, data: Any, path: Place) -> Any:
        """Read a list of names."""
        return self.sequence(description, data, path, self.string)

    def words(self, description: Key, data: Any, path: Place) -> Any:
        """Read a list of choices."""
        return self.sequence(description, data, path, self.word)

    # --- nested values ------------------------------------------------------------------------------------
    def nested(self, description: Key, data: Any, path: Place) -> Any:
        """Read one nested component."""
        return self.component(description.of, data, path)

    def nested_list(self, description: Key, data: Any, path: Place) -> Any:
        """Read a list of nested components."""
        return self.sequence(
            description, data, path, lambda key, entry, at: self.component(key.of, entry, at)
        )

    def nested_names(self, description: Key, data: Any, path: Place) -> Any:
        """Read a mapping of names to components; unreadable components are omitted."""
        if not isinstance(data, Mapping):
            remedy = "give every component a name: NAME: {...}"
            return self.problem(path, "is not a mapping of names", value=shown(data), remedy=remedy)
        out = {}
        for name, entry in data.items():
            if self.good_name(name, path, description.dotted):
                at = (*path, str(name))
                if isinstance(description.of, dict):
                    result = self.chosen(description.of, TYPE, entry, at)
                else:
                    result = self.component(description.of, entry, at)
                if result is not BAD:
                    out[str(name)] = result
        return out

    def good_name(self, name: Any, path: Place, dotted: bool = False) -> bool:
        """Check a name: it must be usable in paths and channels such as `mesh_force[stage]`."""
        return names.good_name(self, name, path, dotted)

    def variant(self, description: Key, data: Any, path: Place) -> Any:
        """Read a component, one key of which selects its class."""
        return self.chosen(description.of, description.tag, data, path)

    def chosen(self, forms: Mapping[str, type], tag: str, data: Any, path: Place) -> Any:
        """Read a component whose key `tag` selects its class."""
        if isinstance(data, tuple(forms.values())):
            return python_parts.finished(self, data, path)
        if hasattr(data, "__dataclass_fields__"):
            return python_parts.wrong_type(self, data, forms.values(), path)
        listed = ", ".join(forms)
        if not isinstance(data, Mapping):
            remedy = f"write {{{tag}: {next(iter(forms))}}}; {tag}s are {listed}"
            return self.problem(path, "is not a mapping", value=shown(data), remedy=remedy)
        if tag not in data:
            return self.problem((*path, tag), "is missing", remedy=f"{tag}s are {listed}")
        word = self.word(Key("choice", "", choices=tuple(forms)), data[tag], (*path, tag))
        if word is BAD:
            return BAD
        return self.component(forms[word], {k: v for k, v in data.items() if k != tag}, path)


_READERS: dict[str, Callable[[Reader, Key, Any, Place], Any]] = {
    "quantity": Reader.number,
    "integer": Reader.whole,
    "choice": Reader.word,
    "text": Reader.string,
    "boolean": Reader.boolean,
    "quantities": Reader.numbers,
    "names": Reader.names,
    "words": Reader.words,
    "component": Reader.nested,
    "components": Reader.nested_names,
    "list": Reader.nested_list,
    "variant": Reader.variant,
    "gears": forms.gears,
    "speeds": forms.speeds,
    "grid": data_files.grid,
    "pitch": data_files.pitch,
    "points": data_files.points,
    "tooth_profile": data_files.tooth_profile,
    "matrix": forms.matrix,
    "matrices": forms.matrices,
    "orders": forms.orders,
    "law": laws.law,
    "laws": laws.laws,
    "python": laws.python,
    "material": laws.material,
    "center": mechanism.center,
    "file": mechanism.file,
    "library": mechanism.library,
    "records": signals.records,
    "record_signals": signals.record_signals,
    "end": mechanism.end,
    "ends": mechanism.ends,
    "coordinates": mechanism.coordinates,
    "displacements": mechanism.displacements,
    "rates": mechanism.rates,
    "motions": mechanism.motions,
    "terms": mechanism.terms,
    "value": signals.value,
    "values": signals.values,
    "gains": signals.gains,
    "wires": signals.wires,
    "curve": signals.curve,
    "code": signals.code,
    "formula": formulas.formula,
    "parameter": formulas.parameter,
    "parameters": formulas.parameters,
}
