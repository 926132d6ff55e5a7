# SPDX-License-Identifier: Apache-2.0
"""Reading of plans with the cases of a model: data sets and studies."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.model.keys import BAD, defaults_of, keys_of
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.dataset_plan import DatasetPlan
    from pitchpoint.model.study_plan import StudyPlan


def check_mapping(data: Any, reader: Reader, file: str | None) -> None:
    """Stop if the contents of a plan have no keys.

    Raises
    ------
    ModelError
        With this problem, and those of the reader.
    """
    if not isinstance(data, Mapping):
        what = "is empty" if data is None else "is not a mapping of keys"
        raise ModelError([*reader.problems, Message("plan", what, remedy="begin with model:", line=1)], file)


def plan_values(
    plan: type, data: Mapping[str, Any], reader: Reader, others: Collection[str] = ()
) -> dict[str, Any]:
    """Readable values of a plan by key; `others` are keys that are read apart."""
    keys, defaults = keys_of(plan), defaults_of(plan)
    reader.unknown(data, [*keys, *others], ())
    values: dict[str, Any] = {}
    for name, description in keys.items():
        if data.get(name) is None:
            if name not in defaults:
                reader.missing((), name, description)
            continue
        value = reader.value(description, data[name], (name,))
        if value is not BAD:
            values[name] = value
    return values


def model_path(plan: DatasetPlan | StudyPlan) -> Path:
    """Model file of a plan.

    Raises
    ------
    ModelError
        If it does not exist.
    """
    path = Path(str(plan.file or "")).parent / plan.model
    if not path.is_file():
        remedy, line = "give the path relative to the plan", plan.lines.get(("model",))
        raise ModelError([Message("model", "file not found", str(path), None, remedy, line)], plan.file)
    return path


def in_order(problems: list[Message]) -> list[Message]:
    """Problems in the order of the file."""
    return sorted(problems, key=lambda p: p.line if p.line is not None else 10**9)
