# SPDX-License-Identifier: Apache-2.0
"""Numbers at paths of a model."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import is_dataclass
from typing import Any

from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.model.components.law import Constant
from pitchpoint.model.keys import keys_of
from pitchpoint.model.model import Model


def number_at(model: Model, path: str) -> tuple[float, str] | None:
    """Number that stands at a path of a model and its SI unit; None if it is none."""
    part: Any = model
    unit = ""
    for name in path.split("."):
        if isinstance(part, Mapping):
            part = part.get(name)
            continue
        if not is_dataclass(part):
            return None
        key = keys_of(type(part)).get(name)
        if key is None:
            return None
        unit = DIMENSIONS[key.dimension].si if key.dimension else ""
        part = getattr(part, name)
    if isinstance(part, Constant):
        part = part.value
    known = isinstance(part, int | float) and not isinstance(part, bool)
    return (float(part), unit or "1") if known else None
