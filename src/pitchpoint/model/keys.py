# SPDX-License-Identifier: Apache-2.0
"""Meaning of every key of a model file: dimension, default, range and a sentence, in one place.

A component is a frozen dataclass whose fields are made by the functions of this module. The reader,
the writer, the JSON schema and the reference page all read the `Key` that each field carries, so a key is
described once.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, TypeAlias

REQUIRED: Any = dataclasses.MISSING
BAD: Any = object()
"""Placeholder of a value that could not be read; its problem has been noted."""

TYPE = "type"
"""Key that names the kind of a component where a section has several kinds."""

Place: TypeAlias = tuple[str | int, ...]
"""Place of a value in a file: names of keys and numbers of list entries."""


@dataclass(frozen=True)
class Key:
    """What one key may hold.

    `kind` names the reader: quantity, integer, choice, text, boolean, quantities (a list), names, end and
    ends (places on bodies), component (nested mapping), components (mapping of names to components) or a
    special form that `model/reading/reader.py` registers. Components of several kinds (`of` is a table) are
    selected by the key `type`; their classes have that word as `form`.
    """

    kind: str
    meaning: str
    dimension: str = ""
    minimum: float = -math.inf
    maximum: float = math.inf
    above: bool = False  # the minimum itself is refused
    below: bool = False  # the maximum itself is refused
    choices: tuple[str, ...] = ()
    length: tuple[int, int] = (0, 10**7)
    variables: tuple[str, ...] = ()  # of a law: what its formulas may use, if not t, angle, speed
    dotted: bool = False  # names of components may be two words with a dot, as JOINT.COORDINATE
    isolated: bool = False  # a problem in it does not affect the component that holds it
    of: Any = None  # dataclass of nested components, or table of variants
    display: str = ""  # default in the words of a user, where it is a formula
    sample: str = ""  # a usual value, where the example of the dimension would be none
    later: bool = False  # came with a later version: empty, it leaves the hash of a model as it was
    names: str = ""  # section whose components it names
    one_of: str = ""  # keys of a component with the same word here exclude each other: exactly one is given
    needs: str = ""  # key that has to be given with this one
    range_words: str = ""  # range in the words of a user, where another key decides about its ends

    @property
    def limit(self) -> str:
        """Allowed range as text, '' when unbounded."""
        low = "" if self.minimum == -math.inf else f"{'>' if self.above else '>='} {self.minimum:g}"
        high = "" if self.maximum == math.inf else f"{'<' if self.below else '<='} {self.maximum:g}"
        return " and ".join(part for part in (low, high) if part)

    def allows(self, value: float) -> bool:
        """Whether a number lies in the range."""
        if value < self.minimum or value > self.maximum:
            return False
        return not ((self.above and value == self.minimum) or (self.below and value == self.maximum))


def key(kind: str, meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Make a dataclass field that carries a `Key`."""
    description = Key(kind, meaning, **more)
    if isinstance(default, dict):
        return dataclasses.field(default_factory=dict, metadata={"key": description})
    return dataclasses.field(default=default, metadata={"key": description})


def quantity(dimension: str, meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for one number with a dimension (SI inside)."""
    return key("quantity", meaning, default, dimension=dimension, **more)


def positive(dimension: str, meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for one number greater than zero."""
    return quantity(dimension, meaning, default, minimum=0.0, above=True, **more)


def quantities(dimension: str, meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for a list of numbers of one dimension."""
    return key("quantities", meaning, default, dimension=dimension, **more)


def integer(meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for a whole number."""
    return key("integer", meaning, default, **more)


def choice(choices: tuple[str, ...], meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for one word out of a list."""
    return key("choice", meaning, default, choices=choices, **more)


def text(meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for free text or the name of something."""
    return key("text", meaning, default, **more)


def boolean(meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for true or false."""
    return key("boolean", meaning, default, **more)


def end(meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for a place on a body: ground, a body or BODY.MARKER."""
    return key("end", meaning, default, **more)


def ends(meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for a list of places on bodies."""
    return key("ends", meaning, default, **more)


def component(of: Any, meaning: str, default: Any = None, **more: Any) -> Any:
    """Field for a nested mapping that becomes the dataclass `of`."""
    return key("component", meaning, default, of=of, **more)


def derived(default: Any = None) -> Any:
    """Field that the model fills in itself; never read from or written to a file, never compared."""
    return dataclasses.field(default=default, compare=False, repr=False, kw_only=True)


def keys_of(cls: type) -> dict[str, Key]:
    """All keys of a component class, in the order of its fields."""
    if cls not in _KEYS:
        fields: Any = dataclasses.fields(cls)
        _KEYS[cls] = {f.name: f.metadata["key"] for f in fields if "key" in f.metadata}
    return _KEYS[cls]


def defaults_of(cls: type) -> dict[str, Any]:
    """Defaults of the optional keys; required keys are absent."""
    if cls not in _DEFAULTS:
        out: dict[str, Any] = {}
        fields: Any = dataclasses.fields(cls)
        for f in fields:
            if "key" not in f.metadata:
                continue
            if f.default is not dataclasses.MISSING:
                out[f.name] = f.default
            elif f.default_factory is not dataclasses.MISSING:
                out[f.name] = f.default_factory()
        _DEFAULTS[cls] = out
    return _DEFAULTS[cls]


_KEYS: dict[type, dict[str, Key]] = {}
_DEFAULTS: dict[type, dict[str, Any]] = {}


def walk(cls: type, path: str = "") -> Iterator[tuple[str, type, str, Key]]:
    """Every key below a component class as (path, class, key name, key), depth first."""
    for name, item in keys_of(cls).items():
        where = f"{path}.{name}" if path else name
        yield where, cls, name, item
        variants = item.of if isinstance(item.of, dict) else {"": item.of}
        for tag, nested in variants.items():
            if dataclasses.is_dataclass(nested) and isinstance(nested, type):
                step = f"{where}.NAME" if item.kind == "components" else where
                yield from walk(nested, f"{step}[{tag}]" if tag else step)
