# SPDX-License-Identifier: Apache-2.0
"""Access to the numbers of a model by path."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import is_dataclass
from typing import Any

from pitchpoint.core.errors import ModelError, UnitError
from pitchpoint.core.formula.dimension import of_number, readable, si_unit
from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.core.units import natural_quantity, parse_quantity
from pitchpoint.model.components.law import Constant
from pitchpoint.model.components.parameter import Parameter
from pitchpoint.model.keys import Key, keys_of
from pitchpoint.model.model import Model


def number_at(model: Model, path: str) -> tuple[float, str] | None:
    """Number at a path of a model and its SI unit; None if there is none."""
    found = _walk(model, path)
    if found is None:
        return None
    part, key = found
    unit = DIMENSIONS[key.dimension].si if key is not None and key.dimension else ""
    if isinstance(part, Parameter):
        part, unit = model.amounts[path.split(".")[1]]
        unit = readable(unit)
    if isinstance(part, Constant):
        part = part.value
    known = isinstance(part, int | float) and not isinstance(part, bool)
    return (float(part), unit or "1") if known else None


def unit_without_number(model: Model, path: str) -> str | None:
    """SI unit of a number that the model may have at a path, but does not give; else None."""
    found = _walk(model, path)
    if found is None or found[0] is not None or found[1] is None or not found[1].dimension:
        return None
    return DIMENSIONS[found[1].dimension].si or "1"


def key_at(model: Model, path: str) -> Key | None:
    """Key of the number at a path, with its permitted range; None for a parameter or an unknown path."""
    found = _walk(model, path)
    return None if found is None or isinstance(found[0], Parameter) else found[1]


def amount_at(model: Model, path: str, written: str) -> float:
    """SI value of a quantity with the dimension of the number at a path; a bare number is in SI units.

    The permitted range of the number is not checked: the quantity may be a deviation from it.

    Parameters
    ----------
    model, path
        Model, and path of one of its numbers.
    written
        Quantity as in a model file.

    Raises
    ------
    UnitError
        For a text that is not a quantity of this dimension.
    """
    found = _walk(model, path)
    if found is None:
        raise UnitError(f"{path} does not exist")
    part, key = found
    if not isinstance(part, Parameter):
        return parse_quantity(
            written, key.dimension if key is not None and key.dimension else "dimensionless"
        )
    wanted = model.amounts[path.split(".")[1]].unit
    value, unit = natural_quantity(written)
    if unit and si_unit(of_number(1.0, unit)) != wanted:
        expected = f"a quantity in {readable(wanted)}" if wanted else "a plain number"
        raise UnitError(f"'{written}' has another unit than {path}; expected {expected}")
    return value


def has_path(model: Model, path: str) -> bool:
    """Whether a path names a key or a component of a model."""
    return _walk(model, path) is not None


def with_defaults(model: Model, paths: Sequence[str]) -> Model:
    """Model with the components that some paths name but that it does not give, with their default values.

    Paths that do not exist, or whose default is not a number, are ignored.
    """
    for path in paths:
        if has_path(model, path):
            continue
        whole, _, name = path.rpartition(".")
        try:
            above = _walk(model.replace_all({path: 0.0}), whole)
            default = getattr(type(above[0]), name, None) if above is not None else None
            if isinstance(default, float):
                model = model.replace_all({path: default})
        except ModelError:
            continue
    return model


def is_name(model: Model, path: str) -> bool:
    """Whether a path ends in a name below a key, such as the body of a speed, and not in a key."""
    whole, _, _ = path.rpartition(".")
    above = _walk(model, whole) if "." in whole else None
    return above is not None and isinstance(above[0], Mapping)


def _walk(model: Model, path: str) -> tuple[Any, Key | None] | None:
    """Value at a path of a model and its key; None if the path does not exist."""
    part: Any = model
    own: Key | None = None
    for name in path.split("."):
        if isinstance(part, Mapping):
            if name not in part:
                return None
            part = part[name]
            continue
        key = keys_of(type(part)).get(name) if is_dataclass(part) else None
        if key is None:
            return None
        own = key
        part = getattr(part, name)
    return part, own
