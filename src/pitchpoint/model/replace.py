# SPDX-License-Identifier: Apache-2.0
"""Replacement of single values by path, for `Model.replace`."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.nearest import hint
from pitchpoint.model.components.law import Balance, Constant, FormulaLaw, PythonLaw, TableLaw
from pitchpoint.model.keys import BAD, TYPE, Key, Place, defaults_of, keys_of
from pitchpoint.model.origin import drop
from pitchpoint.model.parameters import SECTION, check_units, replaced, resolve
from pitchpoint.model.reading.laws import MATERIALS, material_source
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.show import dotted, shown
from pitchpoint.model.signal_units import doubtful
from pitchpoint.model.stand_ins import own_parts, path_of

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.model.reading.bare_numbers import Bare


def changed_parts(model: Model, changes: Mapping[str, Any], report: Reader) -> dict[str, Any]:
    """Keys of a model with new values; values with a changed parameter are read again.

    Parameters
    ----------
    model
        The model.
    changes
        New values by path.
    report
        Reader with the parameters and sources of the model; both are updated.

    Raises
    ------
    ModelError
        With all paths that do not exist and values that cannot be read.
    """
    tops: dict[str, Any] = {}
    problems: list[Message] = []
    paths = {path: tuple(path.split(".")) for path in changes}
    before = report.parameters
    for path, value in changes.items():
        if paths[path][0] == SECTION:
            tops[SECTION] = replaced(tops.get(SECTION, model.parameters), paths[path][1:], value, report)
    if SECTION in tops:
        report.parameters = resolve(tops[SECTION], report)
        check_units(before, report.parameters, report)
        if report.problems:
            raise ModelError(report.problems)
    for first in (True, False):  # materials first: the others may name them
        for path, value in changes.items():
            if paths[path][0] != SECTION and (paths[path][0] == MATERIALS) == first:
                problems += _change(model, paths[path], value, tops, report)
        report.materials = tops.get(MATERIALS, model.materials)
    if not problems:  # all values with changed parameters, then materials, unless they were replaced
        problems += _read_again(model, _changed(before, report.parameters), tops, report)
        report.materials = tops.get(MATERIALS, model.materials)
        new = _changed(model.materials, report.materials)
        problems += _read_again(model, {material_source(n) for n in new}, tops, report)
    if problems:
        raise ModelError(problems)
    return tops


def _read_again(model: Model, names: set[str], tops: dict[str, Any], report: Reader) -> list[Message]:
    """Read all values again that use some of the given parameters or materials; the problems."""
    problems: list[Message] = []
    for place, source in list(report.sources.items()):
        if source.names & names:
            problems += _change(model, place, source.data, tops, report)
    return problems


def _changed(before: Mapping[str, Any], now: Mapping[str, Any]) -> set[str]:
    """Names whose values differ, or that do not exist any more."""
    return {n for n, value in now.items() if before.get(n) != value} | {n for n in before if n not in now}


def bare_in(model: Model, path: str, value: Any) -> list[Bare]:
    """Numbers without unit that are rarely meant in SI in a new value of a model; none if it is not valid.

    Parameters
    ----------
    model
        The model.
    path, value
        As in `Model.replace`.
    """
    report = Reader(
        allow_code=model.allow_code,
        directory=model.directory,
        parameters=model.amounts,
        materials=model.materials,
        sources=dict(model.origin.sources),
    )
    try:
        changed_parts(model, {path: value}, report)
    except ModelError:
        return []
    return doubtful(model, report.bare)


def _change(
    model: Model, path: tuple[Any, ...], value: Any, tops: dict[str, Any], report: Reader
) -> list[Message]:
    """Replace one value in the keys of a model; the problems."""
    name, *rest = path
    keys = keys_of(type(model))
    if rest and name in keys:
        part = tops.get(name, getattr(model, name))
        if isinstance(part, Mapping):
            part = _own(part, name, str(rest[0]), report)
        tops[name] = replace_at(part, tuple(rest), value, report, (name,), keys[name])
    else:
        whole = replace_at(model, (name, *rest), value, report)
        if not report.problems:
            tops[name] = getattr(whole, name)
    problems = list(report.problems)
    report.problems.clear()
    return problems


def _own(parts: Mapping[str, Any], section: str, name: str, report: Reader) -> dict[str, Any]:
    """Components of a section that can be replaced; reports one that belongs to a planetary stage."""
    stage = getattr(parts.get(name), "stage", None)
    if stage is not None:
        report.problem(
            (section, name),
            "belongs to " + (stage if "." in stage else f"the planetary stage {stage}"),
            remedy=f"replace keys of {path_of(stage)}",
        )
    return own_parts(parts)


def replace_at(
    part: Any,
    path: tuple[str, ...],
    value: Any,
    report: Reader,
    at: tuple[str, ...] = (),
    held: Key | None = None,
) -> Any:
    """Copy of a component with the value at a path replaced, read by the rules of the reader.

    `held` is the key of `part`. Named components inside a component, such as faults, can be added; in
    sections of a model an unknown name is an error.
    """
    if isinstance(part, Mapping):
        return _replace_named(part, path, value, report, at, held)
    name = path[0]
    here = (*at, name)
    if not dataclasses.is_dataclass(part) or isinstance(part, type):
        remedy = f"replace the whole value above it: {whole(at, path, value)}"
        report.problem(here, "is below a key without keys", remedy=remedy)
        return part
    keys = keys_of(type(part))
    report.within = vars(part)
    if name == TYPE and name not in keys and (hasattr(part, "form") or hasattr(part, TYPE)):
        remedy = f"replace the whole mapping {'.'.join(at)}"
        report.problem(here, "determines the other keys and cannot change alone", remedy=remedy)
        return part
    if name not in keys:
        report.unknown({name: value}, keys, at)
        return part
    old = getattr(part, name)
    if len(path) == 2 and isinstance(old, Mapping) and keys[name].kind != "components":
        # numbers by name, such as speeds
        written = report.sources[here].data if here in report.sources else old
        kept = {k: v for k, v in written.items() if k != path[1]}
        drop(report, here)
        new = report.keyed(keys[name], kept if value is None else {**written, path[1]: value}, here)
    elif len(path) > 1 and old is None and keys[name].of is not None and value is not None:
        new = report.keyed(keys[name], inside(path[1:], value), here)  # the other keys have their defaults
    elif len(path) > 1:
        new = replace_at(old, path[1:], value, report, here, keys[name])
    elif value is None and defaults_of(type(part)).get(name, ...) is None:
        new = None
        drop(report, here)
    elif _is_component(keys[name], value):
        new = value
        drop(report, here)
    else:
        drop(report, here)
        new = report.keyed(keys[name], value, here)
    if report.problems:
        return part
    if name in part.__dataclass_fields__:
        return dataclasses.replace(part, **{name: new})
    model: Any = part
    return dataclasses.replace(model, others={**model.others, name: new})  # section of another package


def _replace_named(
    part: Mapping[str, Any],
    path: tuple[str, ...],
    value: Any,
    report: Reader,
    at: tuple[str, ...],
    held: Key | None,
) -> Any:
    """Copy of named components with one of them changed, removed or, inside a component, added."""
    if path[0] not in part and ".".join(path[:2]) in part:  # JOINT.COORDINATE is one name
        path = (".".join(path[:2]), *path[2:])
    name = path[0]
    here = (*at, name)
    key = held if held is not None and held.kind == "components" else None
    grows = key is not None and len(at) > 1
    one_form = key is not None and not isinstance(key.of, dict)
    if name not in part and grows and one_form and len(path) > 1 and value is not None:
        # a new one by one of its keys, the others have their defaults
        path, value = (name,), inside(path[1:], value)
    if name not in part and (not grows or len(path) > 1 or not _is_whole(key, value)):
        more = f"; a new one is a whole mapping, as in {'.'.join(here)}: {_sample(key)}" if grows else ""
        report.problem(here, "does not exist", remedy=f"{hint(name, map(str, part))}{more}")
        return part
    if len(path) == 1:
        drop(report, here)
    if len(path) == 1 and value is None:
        return {k: v for k, v in part.items() if k != name}
    if len(path) > 1:
        new = replace_at(part[name], path[1:], value, report, here)
    else:
        if name not in part:
            report.good_name(name, at)
        forms = type(part[name]) if key is None else key.of
        allowed = tuple(forms.values()) if isinstance(forms, dict) else (forms,)
        if isinstance(value, Mapping) and isinstance(forms, dict):
            new = report.chosen(forms, TYPE, value, here)
        else:
            new = report.component(allowed[0], value, here) if isinstance(value, Mapping) else value
        if not isinstance(new, allowed) and new is not BAD:
            report.problem(here, "is neither a mapping nor a component", value=shown(value))
    return part if report.problems else {**part, name: new}


def inside(path: Iterable[str], value: Any) -> Any:
    """Mapping that contains a value at a path.

    Examples
    --------
    >>> inside(["stiffness", "radial"], 3e8)
    {'stiffness': {'radial': 300000000.0}}
    """
    for name in reversed(list(path)):
        value = {name: value}
    return value


def whole(at: Place, path: Iterable[str], value: Any) -> str:
    """Setting of a whole mapping with one of its keys, for messages.

    Examples
    --------
    >>> whole(("meshes", "st1", "friction"), ["mu"], 0.06)
    "meshes.st1.friction='{mu: 0.06}'"
    """
    text = f"{value}"
    for name in reversed(list(path)):
        text = f"{{{name}: {text}}}"
    return f"{dotted(at)}='{text}'"


def _is_whole(key: Key | None, value: Any) -> bool:
    """Whether a value can be a new component of a key."""
    return isinstance(value, Mapping) or (key is not None and _is_component(key, {"new": value}))


def _sample(key: Key | None) -> str:
    """Beginning of a component of a key, for messages."""
    forms = key.of if key is not None else None
    return f"{{{TYPE}: {next(iter(forms))}, ...}}" if isinstance(forms, dict) else "{...}"


def _is_component(key: Key, value: Any) -> bool:
    allowed = tuple(key.of.values()) if isinstance(key.of, dict) else (key.of,)
    if isinstance(value, Constant | FormulaLaw | TableLaw | PythonLaw | Balance):
        return key.kind == "law" or (key.kind == "code" and isinstance(value, PythonLaw))
    if key.kind == "components":
        return isinstance(value, Mapping) and all(isinstance(v, allowed) for v in value.values())
    return any(cls is not None and isinstance(value, cls) for cls in allowed)
