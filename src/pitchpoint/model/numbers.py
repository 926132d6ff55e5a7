# SPDX-License-Identifier: Apache-2.0
"""Access to the numbers of a model by path."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import is_dataclass
from typing import Any

from pitchpoint.core.formula.dimension import readable
from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.model.components.law import Constant
from pitchpoint.model.components.parameter import Parameter
from pitchpoint.model.keys import keys_of
from pitchpoint.model.model import Model


def number_at(model: Model, path: str) -> tuple[float, str] | None:
    """Number at a path of a model and its SI unit; None if there is none."""
    found = _walk(model, path)
    if found is None:
        return None
    part, unit = found
    if isinstance(part, Parameter):
        part, unit = model.amounts[path.split(".")[1]]
        unit = readable(unit)
    if isinstance(part, Constant):
        part = part.value
    known = isinstance(part, int | float) and not isinstance(part, bool)
    return (float(part), unit or "1") if known else None


def has_path(model: Model, path: str) -> bool:
    """Whether a path names a key or a component of a model."""
    return _walk(model, path) is not None


def is_name(model: Model, path: str) -> bool:
    """Whether a path ends in a name below a key, such as the body of a speed, and not in a key."""
    whole, _, _ = path.rpartition(".")
    above = _walk(model, whole) if "." in whole else None
    return above is not None and isinstance(above[0], Mapping)


def _walk(model: Model, path: str) -> tuple[Any, str] | None:
    """Value at a path of a model and the SI unit of its key; None if the path does not exist."""
    part: Any = model
    unit = ""
    for name in path.split("."):
        if isinstance(part, Mapping):
            if name not in part:
                return None
            part = part[name]
            continue
        key = keys_of(type(part)).get(name) if is_dataclass(part) else None
        if key is None:
            return None
        unit = DIMENSIONS[key.dimension].si if key.dimension else ""
        part = getattr(part, name)
    return part, unit
