# SPDX-License-Identifier: Apache-2.0
"""Descriptions of the keys of a model file: dimension, default, range and meaning.

A component is a frozen dataclass whose fields are created by the functions of this module. Each field has a
`Key`, the only description of the key: the reader, the writer, the JSON schema and the reference page use it.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

from pitchpoint.core.nearest import nearest

REQUIRED: Any = dataclasses.MISSING
BAD: Any = object()
"""Placeholder of a value that could not be read; its problem has been noted."""

TYPE = "type"
"""Key for the kind of a component, in sections with several kinds."""
INCLUDE = "include"
"""Key for included files, which the reader of files replaces by their contents."""

Place: TypeAlias = tuple[str | int, ...]
"""Path of a value in a file: names of keys and indices of list entries."""


@dataclass(frozen=True)
class Key:
    """Description of one key.

    `kind` selects the reader: quantity, integer, choice, text, boolean, quantities (a list), names, end and
    ends (points on bodies), component (nested mapping), components (mapping of names to components) or a
    special form registered by `model/reading/reader.py`. If `of` is a table, the key `type` selects the
    component class by its `form`.
    """

    kind: str
    meaning: str
    dimension: str = ""
    minimum: float = -math.inf
    maximum: float = math.inf
    above: bool = False  # exclusive minimum
    below: bool = False  # exclusive maximum
    choices: tuple[str, ...] = ()
    length: tuple[int, int] = (0, 10**7)
    variables: tuple[str, ...] = ()  # of a law: variables of its formulas, if not t, angle, speed
    dotted: bool = False  # names of components may contain a dot, as JOINT.COORDINATE
    isolated: bool = False  # a problem in it does not affect the enclosing component
    of: Any = None  # dataclass of nested components, or table of variants
    display: str = ""  # description of a default that is not a constant
    sample: str = ""  # typical value, if the example of the dimension does not fit
    tag: str = "law"  # of a variant: key that selects the class
    later: bool = False  # added in a later version: at its default, the hash of a model is unchanged
    names: str = ""  # section of the named components
    one_of: str = ""  # group of mutually exclusive keys of a component: exactly one is given
    needs: str = ""  # key that must be given together with this one
    also: tuple[str, ...] = ()  # names in other components and symbols of catalogues, for suggestions
    range_words: str = ""  # description of a range that depends on another key

    @property
    def limit(self) -> str:
        """Allowed range as text, '' when unbounded."""
        low = "" if self.minimum == -math.inf else f"{'>' if self.above else '>='} {self.minimum:g}"
        high = "" if self.maximum == math.inf else f"{'<' if self.below else '<='} {self.maximum:g}"
        return " and ".join(part for part in (low, high) if part)

    def allows(self, value: float) -> bool:
        """Whether a number is within the range."""
        if value < self.minimum or value > self.maximum:
            return False
        return not ((self.above and value == self.minimum) or (self.below and value == self.maximum))


def key(kind: str, meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Create a dataclass field with a `Key`."""
    description = Key(kind, meaning, **more)
    if isinstance(default, dict):
        return dataclasses.field(default_factory=dict, metadata={"key": description})
    return dataclasses.field(default=default, metadata={"key": description})


def quantity(dimension: str, meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for one number with a dimension (stored in SI units)."""
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
    """Field for one of several options."""
    return key("choice", meaning, default, choices=choices, **more)


def text(meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for free text or a name."""
    return key("text", meaning, default, **more)


def boolean(meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for true or false."""
    return key("boolean", meaning, default, **more)


def end(meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for a point on a body: ground, a body or BODY.MARKER."""
    return key("end", meaning, default, **more)


def ends(meaning: str, default: Any = REQUIRED, **more: Any) -> Any:
    """Field for a list of points on bodies."""
    return key("ends", meaning, default, **more)


def component(of: Any, meaning: str, default: Any = None, **more: Any) -> Any:
    """Field for a nested mapping that is read into the dataclass `of`."""
    return key("component", meaning, default, of=of, **more)


def same_key(cls: type, name: str) -> Any:
    """Field with the key and the default of a field of another component."""
    found = next(f for f in dataclasses.fields(cls) if f.name == name)
    default: Any = {"default": found.default}
    if found.default_factory is not dataclasses.MISSING:
        default = {"default_factory": found.default_factory}
    return dataclasses.field(**default, metadata=found.metadata)


def derived(default: Any = None) -> Any:
    """Field computed by the model; it is not read, written or compared."""
    return dataclasses.field(default=default, compare=False, repr=False, kw_only=True)


def keys_of(cls: type) -> dict[str, Key]:
    """All keys of a component class, in the order of its fields."""
    if cls not in _KEYS:
        fields: Any = dataclasses.fields(cls)
        _KEYS[cls] = {f.name: f.metadata["key"] for f in fields if "key" in f.metadata}
    return _KEYS[cls]


def defaults_of(cls: type) -> dict[str, Any]:
    """Defaults of the optional keys."""
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


def remedy_for_key(name: object, allowed: Iterable[str], *, cut: bool = False) -> tuple[str | None, str]:
    """Key that an unknown one probably means, None if no name is similar, and the remedy for a message.

    Parameters
    ----------
    name
        Unknown key.
    allowed
        Names of the keys, or a mapping of names to keys, whose other names are compared too.
    cut
        Whether the key has no value, as the rest of a text after a comma within {...}.

    Examples
    --------
    >>> remedy_for_key("coefficient", {"mu": Key("quantity", "", also=("coefficient",)), "static": None})
    ('mu', 'did you mean mu? allowed are mu, static')
    """
    keys = list(allowed)
    meaning = {name: name for name in keys}
    if isinstance(allowed, Mapping):
        meaning = {other: key for key in keys for other in getattr(allowed[key], "also", ())} | meaning
    exact = [str(name)] if str(name) in meaning else []  # d and D are different symbols
    near = next((meaning[found] for found in exact or nearest(name, meaning)), None)
    quotes = "; within {...} a text with commas needs quotes" if cut and not near and " " in str(name) else ""
    return near, f"{f'did you mean {near}? ' if near else ''}allowed are {', '.join(keys)}{quotes}"


def walk(cls: type, path: str = "") -> Iterator[tuple[str, type, str, Key]]:
    """All keys of a component class and its nested components as (path, class, key name, key), depth
    first."""
    for name, item in keys_of(cls).items():
        where = f"{path}.{name}" if path else name
        yield where, cls, name, item
        variants = item.of if isinstance(item.of, dict) else {"": item.of}
        for tag, nested in variants.items():
            if dataclasses.is_dataclass(nested) and isinstance(nested, type):
                step = f"{where}.NAME" if item.kind == "components" else where
                yield from walk(nested, f"{step}[{tag}]" if tag else step)
