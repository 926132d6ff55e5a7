# SPDX-License-Identifier: Apache-2.0
"""JSON schema of the model file, generated from the keys of the components."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.model.keys import INCLUDE, TYPE, Key, defaults_of, keys_of
from pitchpoint.model.model import Model
from pitchpoint.model.sections import load_others
from pitchpoint.model.write import quantity_text

FILES = Key("names", "model files, by their paths from the folder of this file, whose sections are added")
DRAFT = "https://json-schema.org/draft/2020-12/schema"


def json_schema() -> dict[str, Any]:
    """JSON schema (draft 2020-12) of a model file, with the unit of every quantity.

    It includes the sections of all installed packages.

    Examples
    --------
    >>> json_schema()["$defs"]["Gear"]["properties"]["normal_module"]["unit"]
    'm'
    """
    load_others()
    definitions: dict[str, Any] = {}
    top = _object(Model, definitions)
    top["properties"] = {INCLUDE: _property(FILES, None, definitions), **top["properties"]}
    top["properties"][INCLUDE]["type"] = ["string", "array"]
    return {"$schema": DRAFT, "title": "pitchpoint model file", **top, "$defs": definitions}


def _object(cls: type, definitions: dict[str, Any], word: str = "", tag: str = "law") -> dict[str, Any]:
    keys, defaults = keys_of(cls), defaults_of(cls)
    properties: dict[str, Any] = {tag: {"const": word}} if word else {}
    properties |= {name: _property(key, defaults.get(name), definitions) for name, key in keys.items()}
    required = ([tag] if word else []) + [name for name in keys if name not in defaults]
    out: dict[str, Any] = {
        "type": "object",
        "description": (cls.__doc__ or "").strip().split("\n")[0],
        "properties": properties,
        "additionalProperties": False,
    }
    return out | ({"required": required} if required else {})


def _reference(cls: type, definitions: dict[str, Any], word: str = "", tag: str = "law") -> dict[str, str]:
    if cls.__name__ not in definitions:
        definitions[cls.__name__] = {}
        definitions[cls.__name__] = _object(cls, definitions, word, tag)
    return {"$ref": f"#/$defs/{cls.__name__}"}


def _property(key: Key, default: Any, definitions: dict[str, Any]) -> dict[str, Any]:
    out: dict[str, Any] = {"description": key.meaning, **_type(key, definitions)}
    if key.dimension and key.kind not in ("law", "laws"):
        out["unit"] = DIMENSIONS[key.dimension].si or "1"
    shown = default_text(key, default)
    if shown:
        out["default"] = default if isinstance(default, int | float | str) and not key.display else shown
    return out


def _type(key: Key, definitions: dict[str, Any]) -> dict[str, Any]:
    number = _number(key)
    if key.kind == "components" and isinstance(key.of, dict):
        forms = [_reference(cls, definitions, word, TYPE) for word, cls in key.of.items()]
        return {"type": "object", "additionalProperties": {"oneOf": forms}}
    if key.kind in ("component", "components", "list", "tooth_profile"):
        inner = _reference(key.of, definitions)
        if key.kind == "components":
            return {"type": "object", "additionalProperties": inner}
        return {"type": "array", "items": inner} if key.kind == "list" else inner
    if key.kind == "variant":
        return {"oneOf": [_reference(cls, definitions, word, key.tag) for word, cls in key.of.items()]}
    if key.kind == "parameters":
        of_text = {"type": ["number", "string"]}
        return {
            "type": "object",
            "additionalProperties": {"anyOf": [of_text, _reference(key.of, definitions)]},
        }
    row = {"type": "array", "items": number}
    # a list of any length may also be read from a text file
    file = {"type": "string"}
    if key.kind == "quantities":
        listed = {**row, **_length(key)}
        return listed if key.length[0] else {"anyOf": [listed, file]}
    if key.kind == "pitch":
        return {"anyOf": [row, file, _reference(key.of, definitions)]}
    if key.kind in ("grid", "points"):
        return {"anyOf": [{"type": "array", "items": row}, file]}
    if key.kind in ("names", "words"):
        words: dict[str, Any] = {"enum": list(key.choices)} if key.choices else {"type": "string"}
        return {"type": "array", "items": words, **_length(key)}
    plain: dict[str, dict[str, Any]] = {
        "quantity": number,
        "integer": {"type": ["integer", "string"], **_bounds(key)},
        "choice": {"enum": list(key.choices)},
        "text": {"type": ["string", "number"]},  # a designation such as 6205
        "boolean": {"type": "boolean"},
        "speeds": {"type": "object", "additionalProperties": number},
        "gears": {"type": ["array", "object"]},
        "matrix": {"type": "array", "items": {"type": "array", "items": {"type": ["number", "string"]}}},
        "matrices": {"type": "array", "items": {"type": "array"}},
        "orders": {"type": "object"},
        "material": {"type": ["string", "object"]},
        "law": {"type": ["number", "string", "object"]},
        "laws": {"type": "array", **_length(key)},
        "python": {"type": ["string", "object"]},
        "center": {"anyOf": [number, {**row, "minItems": 3, "maxItems": 3}]},
        "file": {"type": "string"},
        "library": {"type": "string"},
        "record_signals": {"type": "object", "additionalProperties": {"type": "string"}},
        "records": {"type": "object", "additionalProperties": {"type": ["number", "string"]}},
        "end": {"type": "string"},
        "ends": {"type": "array", "items": {"type": "string"}, **_length(key)},
        "coordinates": {"type": "object", "additionalProperties": {"enum": ["length", "angle"]}},
        "displacements": {"type": "object", "additionalProperties": number},
        "rates": {"type": "object", "additionalProperties": number},
        "motions": {"type": "object"},
        "terms": {"type": "object", "additionalProperties": number},
        "value": number,
        "values": {**row, **_length(key)},
        "gains": {"type": "object", "additionalProperties": number},
        "wires": {"type": "object", "additionalProperties": {"type": "string"}},
        "curve": {"anyOf": [{"type": "array", "items": row}, file]},
        "code": {"type": "string"},
        "formula": {"type": "string"},
        "parameter": {"type": ["number", "string"]},
    }
    return plain[key.kind]


def _number(key: Key) -> dict[str, Any]:
    return {"type": ["number", "string"], **_bounds(key)}


def _bounds(key: Key) -> dict[str, float]:
    out = {}
    if key.minimum != -math.inf:
        out["exclusiveMinimum" if key.above else "minimum"] = key.minimum
    if key.maximum != math.inf:
        out["exclusiveMaximum" if key.below else "maximum"] = key.maximum
    return out


def _length(key: Key) -> dict[str, int]:
    low, high = key.length
    return ({"minItems": low} if low else {}) | ({"maxItems": high} if high < 10**7 else {})


def default_text(key: Key, default: Any) -> str:
    """Default of a key as text for the reference page; '' for required keys and empty defaults."""
    if key.display:
        return key.display
    if default is None or default in ({}, (), ""):
        return ""
    if key.kind == "quantity":
        return str(quantity_text(default, key.dimension))
    if key.kind == "quantities":
        return str(list(default))
    if dataclasses.is_dataclass(default):
        return "its defaults"
    return str(default).lower() if isinstance(default, bool) else str(default)
