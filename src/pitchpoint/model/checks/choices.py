# SPDX-License-Identifier: Apache-2.0
"""Checks of mutually exclusive and dependent keys, from the key descriptions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import is_dataclass
from typing import Any

from pitchpoint.model.keys import Place, keys_of
from pitchpoint.model.parts import Parts
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.sections import groups_of


def check_given(parts: Parts, report: Reader) -> None:
    """Check `one_of` and `needs` of the keys of all components, at any depth."""
    for group in groups_of(parts):
        check_keys(getattr(parts, group), (group,), report)
    check_keys(parts.housing, ("housing",), report)


def check_keys(value: Any, at: Place, report: Reader) -> None:
    """Check a component, or a list or mapping of components, including nested components."""
    if isinstance(value, Mapping):
        for name, each in value.items():
            check_keys(each, (*at, str(name)), report)
    elif isinstance(value, tuple):
        for k, each in enumerate(value):
            if is_dataclass(each):
                check_keys(each, (*at, k), report)
    elif is_dataclass(value) and not isinstance(value, type):
        _component(value, at, report)


def _component(part: Any, at: Place, report: Reader) -> None:
    exclusive: dict[str, list[str]] = {}
    for name, key in keys_of(type(part)).items():
        value = getattr(part, name)
        check_keys(value, (*at, name), report)
        if key.one_of:
            exclusive.setdefault(key.one_of, []).append(name)
        if key.needs and value is not None and getattr(part, key.needs) is None and at not in report.tainted:
            report.problem((*at, name), f"requires {key.needs}", remedy=f"give {key.needs}")
    for names in exclusive.values():
        exactly_one(part, names, at, report)


def exactly_one(part: Any, keys: Iterable[str], at: Place, report: Reader) -> None:
    """Report a component that gives none or several of mutually exclusive keys."""
    given = [k for k in keys if getattr(part, k) is not None]
    if len(given) != 1 and at not in report.tainted:
        listed = ", ".join(keys)
        what = f"gives {' and '.join(given)} together" if given else f"gives none of {listed}"
        remedy = f"give exactly one of {listed}" if given else "give exactly one of them"
        report.problem(at, what, remedy=remedy)
