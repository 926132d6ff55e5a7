# SPDX-License-Identifier: Apache-2.0
"""Base class of the components of a model: their values may be given as in a file, such as ``"2 mm"``."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from numbers import Real
from typing import Any, Self

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.model.keys import BAD, Key, defaults_of, keys_of, remedy_for_key

WORDS = (
    "choice",
    "text",
    "boolean",
    "end",
    "file",
    "library",
    "formula",
    "parameter",
    "coordinates",
    "material",
)
"""Kinds of keys whose texts are the same in a file and in a component."""
LISTS_OF_WORDS = ("names", "ends", "words")
MAPPINGS = ("component", "variant", "tooth_profile", "pitch", "law", "code", "material", "orders", "points")
"""Kinds of keys with a mapping in a file and another object in a component."""
NUMBERS = ("law", "quantity", "quantities", "center")
"""Kinds of keys whose whole numbers become floating-point numbers."""
_AFTER_NUMBER = re.compile(r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\s*[^\W\d_]\w*")
HOOKS: dict[str, Callable[..., Any]] = {}
"""`read` of the reader, `component` and `law` of the writer, which import all components; they are here
as soon as `Model` is imported."""
PLAIN = (float, int, str, bool, type(None))
"""Types of most values, which contain no arrays."""
LONG = 20
"""Lists with more entries are shortened by `repr`."""


@dataclass(frozen=True)
class Unread:
    """A value as in a file that depends on parameters, or cannot be read; the model reads it or reports it.

    Parameters
    ----------
    data
        The value as given.
    """

    data: Any


class Checked:
    """Base class whose constructor reports unknown keys like those of a file, with the nearest spelling."""

    def __new__(cls, *_: Any, **given: Any) -> Self:
        """Check the names of the keys; the constructor of the dataclass follows."""
        names = {field.name for field in fields(cls)}  # type: ignore[arg-type]
        if not given.keys() <= names:
            unknown = {name: remedy_for_key(name, keys_of(cls))[1] for name in given if name not in names}
            raise ModelError(
                [
                    Message(f"{cls.__name__}.{name}", "is an unknown key", remedy=remedy)
                    for name, remedy in unknown.items()
                ]
            )
        return super().__new__(cls)


class Component(Checked):
    """A component: a frozen dataclass with keys.

    Numbers are in SI units and radians. Every value can also be given as in a file, as a text with its unit,
    a formula, a list or a mapping; it is converted at once. NumPy numbers and arrays are numbers and lists.
    Formulas with parameters are read by the `Model`, which also reports what they give.

    Raises
    ------
    ModelError
        With the unknown keys, or with the texts of numbers that cannot be read whatever the parameters are.

    Examples
    --------
    >>> from pitchpoint.model.components.gear import Gear
    >>> gear = Gear(number_of_teeth=24, normal_module="2 mm", face_width=0.02)
    >>> gear.normal_module
    0.002
    >>> gear
    Gear(number_of_teeth=24, normal_module='2 mm', face_width='20 mm')
    """

    def __init_subclass__(cls) -> None:
        """Set the representation, which the decorator `dataclass` then keeps."""
        cls.__repr__ = Component.__repr__  # type: ignore[method-assign]

    def __post_init__(self) -> None:
        problems: list[Message] = []
        for name, key in keys_of(type(self)).items():
            value = self.__dict__[name]
            if type(value) not in PLAIN:
                value = without_arrays(value)
                object.__setattr__(self, name, value)
            if as_in_file(key, value):
                found, reasons = HOOKS["read"](key, value, self.__dict__) if "read" in HOOKS else (BAD, [])
                if found is BAD and key.kind in (*NUMBERS, "integer") and is_hopeless(value):
                    where = f"{type(self).__name__}.{name}"
                    problems += [reason.changed(where=f"{where}{reason.where}") for reason in reasons]
                object.__setattr__(self, name, Unread(value) if found is BAD else found)
        if problems:
            raise ModelError(problems)

    def __repr__(self) -> str:
        """Keys that differ from their defaults, in the notation of a model file."""
        try:
            values = HOOKS["component"](self)
        except (ValueError, TypeError, AttributeError, KeyError):  # a component that no model accepts
            usual, own = defaults_of(type(self)), vars(self)
            values = {n: own[n] for n in keys_of(type(self)) if n not in usual or own[n] != usual[n]}
        shown = ", ".join(f"{name}={_short(value)}" for name, value in values.items())
        return f"{type(self).__name__}({shown})"


def _short(value: Any) -> str:
    """Representation of plain data, with long lists shortened."""
    if isinstance(value, Unread):
        return _short(value.data)
    if isinstance(value, dict):
        return "{" + ", ".join(f"{k!r}: {_short(v)}" for k, v in value.items()) + "}"
    if not isinstance(value, list):
        return repr(value)
    if len(value) <= LONG:
        return "[" + ", ".join(map(_short, value)) + "]"
    return f"[{_short(value[0])}, {_short(value[1])}, ..., {_short(value[-1])}]"


def as_in_file(key: Key, value: Any) -> bool:
    """Whether a value has a form of files that differs from the form of components.

    Examples
    --------
    >>> length = Key("quantity", "", dimension="length")
    >>> as_in_file(length, "2 mm"), as_in_file(length, 0.002)
    (True, False)
    """
    kind = key.kind
    if value is None or isinstance(value, bool):
        return False
    if isinstance(value, float):
        return kind in ("law", "integer")
    if isinstance(value, int | Real):
        return kind in NUMBERS
    if isinstance(value, str):
        return kind not in WORDS or (kind == "material" and not in_library(value))
    if isinstance(value, list):
        return kind not in WORDS
    if isinstance(value, tuple):
        inside = Key("law", "") if kind == "laws" else key
        return kind == "points" or (kind not in LISTS_OF_WORDS and any(_entry(inside, v) for v in value))
    if isinstance(value, Mapping):
        if kind in MAPPINGS:
            return True
        if kind == "components":
            return any(isinstance(v, Mapping) for v in value.values())
        if kind == "motions":
            return any(_motion(laws) for laws in value.values())
        return kind not in WORDS and any(isinstance(v, str | int) for v in value.values())
    return False


def in_library(material: str) -> bool:
    """Whether a material is one of the library; the others are those of a model.

    Examples
    --------
    >>> in_library("steel"), in_library("own")
    (True, False)
    """
    from pitchpoint.geometry.materials import LIBRARY

    return material in LIBRARY


def without_arrays(value: Any) -> Any:
    """A value with lists and numbers of Python in place of those of NumPy.

    Examples
    --------
    >>> import numpy as np
    >>> without_arrays({"table": np.array([[0, 1], [2, 3]])}), without_arrays((np.int64(2), 1))
    ({'table': [[0, 1], [2, 3]]}, (2, 1))
    """
    if type(value) in PLAIN:
        return value
    if hasattr(value, "tolist"):
        return value.tolist()
    if type(value) is list or type(value) is tuple:
        if all(type(entry) in PLAIN for entry in value):
            return value
        return type(value)(map(without_arrays, value))
    if type(value) is dict:
        return {name: without_arrays(entry) for name, entry in value.items()}
    return value


def is_hopeless(value: Any) -> bool:
    """Whether a text, or a list with texts, cannot contain a parameter.

    Symbols of units, functions and a word after a number cannot be names of parameters.

    Examples
    --------
    >>> is_hopeless("2 mmm"), is_hopeless("2 mm * cos(3 kg)"), is_hopeless("2 * m_n"), is_hopeless("m_n")
    (True, True, False, False)
    """
    from pitchpoint.core.formula.language import CONSTANTS, FUNCTIONS
    from pitchpoint.core.unit_table import UNITS
    from pitchpoint.model.reading.formula_text import WORDS

    entries = value if isinstance(value, list | tuple) else [value]
    texts = [_AFTER_NUMBER.sub(" ", entry) for entry in entries if isinstance(entry, str)]
    known = (*UNITS, *FUNCTIONS, *CONSTANTS)
    return bool(texts) and all(word in known for text in texts for word in WORDS.findall(text))


def _entry(key: Key, value: Any) -> bool:
    """Whether an entry of a tuple has a form of files."""
    return isinstance(value, Mapping) if key.kind == "list" else as_in_file(key, value)


def _motion(laws: Any) -> bool:
    """Whether the motion of one coordinate has a form of files: anything but a tuple of laws."""
    return not isinstance(laws, tuple) or any(as_in_file(Key("law", ""), law) for law in laws)


def needs_reading(key: Key, value: Any) -> bool:
    """Whether a value, or any value inside its components, is still in a form of files."""
    if isinstance(value, Unread) or as_in_file(key, value):
        return True
    if isinstance(value, Mapping):
        return key.kind == "components" and any(map(unfinished, value.values()))
    if isinstance(value, tuple):
        return key.kind == "list" and any(map(unfinished, value))
    return unfinished(value)


def unfinished(part: Any) -> bool:
    """Whether any value of a component is still in a form of files."""
    keys = keys_of(type(part)) if hasattr(part, "__dataclass_fields__") else {}
    return any(needs_reading(key, getattr(part, name)) for name, key in keys.items())


def as_written(data: Any) -> Any:
    """Data of a file, with the components in it in the notation of a file."""
    if isinstance(data, Mapping):
        return {name: as_written(value) for name, value in data.items()}
    if isinstance(data, list | tuple):
        return [as_written(value) for value in data]
    if not hasattr(data, "__dataclass_fields__"):
        return data
    return HOOKS["component" if isinstance(data, Component) or keys_of(type(data)) else "law"](data)
