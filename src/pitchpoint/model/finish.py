# SPDX-License-Identifier: Apache-2.0
"""Values of a model made in Python that are given as in a file: texts with units, formulas, mappings."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import Message
from pitchpoint.model import sections
from pitchpoint.model.component import HOOKS, needs_reading, without_arrays
from pitchpoint.model.keys import BAD, Key, defaults_of, keys_of
from pitchpoint.model.parameters import SECTION
from pitchpoint.model.reading.laws import MATERIALS, note_materials
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.stand_ins import own_parts

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def finish(model: Model, report: Reader) -> tuple[dict[str, Any], dict[str, set[str]]]:
    """Read the values of a new model that are still as in a file.

    Parameters
    ----------
    model
        Model during construction, with the values given to the constructor.
    report
        Collects the parameters, the values with parameters, and the problems.

    Returns
    -------
    values
        Values of all keys, read; what cannot be read is missing or has its default.
    names
        All names of each section, readable or not.
    """
    values: dict[str, Any] = {}
    names: dict[str, set[str]] = {}
    for name, key in keys_of(type(model)).items():
        value = model.others.get(name, {}) if sections.is_other(name) else getattr(model, name)
        value = without_arrays(value)
        if key.kind == "components" and isinstance(value, Mapping):
            value = own_parts(value)
            names[name] = {str(n) for n in value}
        if name == SECTION or needs_reading(key, value) or _is_no_section(key, value):
            value = report.keyed(key, value, (name,))
        values[name] = defaults_of(type(model))[name] if value is BAD else value
        if name == MATERIALS:
            note_materials(report, values[name], names.get(name, ()))
    return values, names


def _is_no_section(key: Key, value: Any) -> bool:
    """Whether something else than a mapping is given as a section."""
    return key.kind == "components" and not isinstance(value, Mapping)


def _read_alone(key: Key, data: Any, within: Mapping[str, Any]) -> tuple[Any, list[Message]]:
    """Value of a component without a model; BAD if it cannot be read, with the problems."""
    reader = Reader(within=within)
    found = reader.value(key, data, ())
    return BAD if reader.problems else found, reader.problems


HOOKS["read"] = _read_alone
