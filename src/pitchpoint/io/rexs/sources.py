# SPDX-License-Identifier: Apache-2.0
"""Components that a REXS file takes from other REXS files: `data_source` and `referenced_component_id`."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path, PurePosixPath, PureWindowsPath

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.nearest import nearest
from pitchpoint.io.rexs.document import RexsAttribute, RexsComponent, RexsModel, RexsRelation

SOURCE, NUMBER = "data_source", "referenced_component_id"
DEEPEST = 5
"""Largest number of files that refer to each other in a chain."""
DOWN = {
    "assembly": "assembly",
    "ordered_assembly": "assembly",
    "reference": "origin",
    "ordered_reference": "origin",
    "flank": "gear",
    "manufacturing_step": "workpiece",
}
"""Role of the main component in the relations through which it brings other components."""
POSITIONS = ("reference_component_for_position", "support_vector", "u_axis_vector", "w_axis_vector")
"""Attributes that belong to the place of a component in its own file."""


def with_sources(
    model: RexsModel, file: Path, read: Callable[[Path], RexsModel], above: tuple[Path, ...] = ()
) -> RexsModel:
    """Model with the data of all components that refer to other files, and with their sub-components.

    Parameters
    ----------
    model, file
        Model without them, and its file.
    read
        Function that reads a file without its external files.
    above
        Files that refer to this one.

    Raises
    ------
    ModelError
        With all files that are missing or unreadable, and all components that they do not have.
    """
    asking = [c for c in model.components.values() if SOURCE in c.attributes]
    if not asking:
        return model
    chain = (*above, file.resolve())
    problems: list[Message] = []
    others: dict[Path, RexsModel] = {}
    components, relations = dict(model.components), list(model.relations)
    for component in asking:
        source = component.attributes[SOURCE]
        try:
            path = _path(str(source.value), file, source.where, chain)
            if path not in others:
                others[path] = with_sources(read(path), path, read, chain)
            _add(component, others[path], components, relations)
        except ModelError as error:
            name = f"{error.file}: " if error.file else ""
            problems += [p.changed(where=f"{name}{p.where}") if name else p for p in error.problems]
    if problems:
        raise ModelError(problems)
    remarks = [remark for one in others.values() for remark in one.remarks]
    return replace(
        model, components=components, relations=tuple(relations), remarks=(*model.remarks, *remarks)
    )


def _path(text: str, file: Path, where: str, chain: tuple[Path, ...]) -> Path:
    """Path of an external file, relative to the file that names it."""
    plain = text.replace("\\", "/")
    if "://" in plain or PurePosixPath(plain).is_absolute() or PureWindowsPath(text).is_absolute():
        remedy = "put the file into the folder of the model and give its name"
        raise ModelError(
            [Message(where, "is not a path relative to the model", repr(text[:80]), remedy=remedy)]
        )
    path = file.parent / plain
    if not path.is_file():
        beside = sorted(p.name for p in path.parent.glob("*")) if path.parent.is_dir() else []
        near = nearest(path.name, beside)
        guess = f"did you mean {near[0]}? " if near else ""
        remedy = f"{guess}paths start at the folder of {file.name}"
        raise ModelError([Message(where, "does not exist", repr(text[:80]), remedy=remedy)])
    if path.resolve() in chain or len(chain) >= DEEPEST:
        what = (
            "refers back to the model"
            if path.resolve() in chain
            else f"is the {DEEPEST + 1}th file in a chain"
        )
        raise ModelError([Message(where, what, repr(text[:80]), remedy="give the data in one of the files")])
    return path


def _add(
    component: RexsComponent,
    source: RexsModel,
    components: dict[int, RexsComponent],
    relations: list[RexsRelation],
) -> None:
    """Add the values and sub-components of the component of another file; own values win."""
    wanted = component.attributes.get(NUMBER)
    place = component.attributes[SOURCE].where
    if wanted is None:
        raise ModelError([Message(place, f"has no {NUMBER}", remedy="give the id of the component there")])
    there = source.components.get(int(wanted.value))  # type: ignore[arg-type]
    if there is None or there.type != component.type:
        same = [str(c.id) for c in source.of_type(component.type)]
        what = "does not exist" if there is None else f"is a {there.type}"
        remedy = f"{component.type} there: {', '.join(same) or 'none'}"
        where = wanted.where
        raise ModelError(
            [Message(where, f"{what} in {Path(source.file).name}", str(wanted.value), remedy=remedy)]
        )
    numbers = {there.id: component.id}
    for relation in _below(there.id, source):
        for id in relation.roles.values():
            if id not in numbers:
                numbers[id] = max(components) + 1
                brought = source.components[id]
                components[numbers[id]] = replace(
                    brought,
                    id=numbers[id],
                    file=brought.file or source.file,
                    attributes=_placed(brought.attributes, numbers),
                )
        relations.append(replace(relation, roles={r: numbers[i] for r, i in relation.roles.items()}))
    values = {k: v for k, v in there.attributes.items() if k not in POSITIONS}
    components[component.id] = replace(component, attributes={**values, **component.attributes})


def _placed(values: Mapping[str, RexsAttribute], numbers: Mapping[int, int]) -> dict[str, RexsAttribute]:
    """Values without a place that refers to components left behind."""
    reference = values.get(POSITIONS[0])
    if reference is None or reference.value in numbers:
        return dict(values)
    return {name: value for name, value in values.items() if name not in POSITIONS}


def _below(number: int, source: RexsModel) -> list[RexsRelation]:
    """Relations of a component to its sub-components, and of these to theirs."""
    found: list[RexsRelation] = []
    seen, todo = {number}, [number]
    while todo:
        main = todo.pop(0)
        for kind, role in DOWN.items():
            for relation in source.related(kind, **{role: main}):
                found.append(relation)
                fresh = [id for id in relation.roles.values() if id not in seen]
                seen.update(fresh)
                todo += fresh
    return found
