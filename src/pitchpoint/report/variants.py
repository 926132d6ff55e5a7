# SPDX-License-Identifier: Apache-2.0
"""Variants of a model among results: what differs between the models stored in them, in words."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Any

from pitchpoint.core.errors import PitchpointError, ValidityWarning
from pitchpoint.viz.quantities import printed

Path = tuple[str, ...]
Leaves = dict[Path, Any]

MAX_DIFFERENCES = 4
"""Differing values up to which variants are named after them."""


def variant_words(
    models: Mapping[str, str], scenarios: Mapping[str, str], files: Mapping[str, str] = MappingProxyType({})
) -> dict[str, str]:
    """What differs between results, in words.

    Parameters
    ----------
    models
        Text of the stored model (YAML or JSON) by name of the result. Defaults, the spelling of units and the
        order of keys do not count.
    scenarios
        Scenario by name of the result; only the values of this scenario count.
    files
        Result files by name, for the files to which a model refers.

    Returns
    -------
    dict
        Words by name; empty if the models are equal, differ in more than `MAX_DIFFERENCES` values, or one of
        them cannot be read.

    Examples
    --------
    >>> text = '{"meshes": {"stage": {"backlash": {"normal": "%s"}}}}'
    >>> variant_words({"a": text % "0.1 mm", "b": text % "0.2 mm"}, {"a": "s", "b": "s"})
    {'a': 'backlash normal 0.1 mm', 'b': 'backlash normal 0.2 mm'}
    >>> text = '{"parameters": {"load": {"value": "%s"}}}'
    >>> variant_words({"a": text % "5 N m", "b": text % "9 N m"}, {"a": "s", "b": "s"})
    {'a': 'load 5 N m', 'b': 'load 9 N m'}
    """
    leaves, differing = _compared(models, scenarios, files)
    if not differing:
        return {}
    # a parameter has its own name, a key of a component that of the key
    keys = [path[1:2] if path[0] == "parameters" else path[2:] for path in differing]
    found = {}
    for name, own in leaves.items():
        words = []
        for path, ends in zip(differing, keys, strict=True):
            # the name of the component only where several have this key
            place = [path[1]] if keys.count(ends) > 1 or not ends else []
            key = " ".join(word.replace("_", " ") for word in ends)
            value = printed(str(own[path])) if path in own else "default"
            words.append(" ".join(filter(None, (*place, key, value))))
        found[name] = ", ".join(words)
    return found if len(set(found.values())) == len(found) else {}


def change_words(one: str, other: str, scenario: str, file: str) -> str:
    """Values of the model of a result file that differ from those of another model, by path.

    Parameters
    ----------
    one, other
        Text of the model, and of that of the result file.
    scenario
        Scenario of the result.
    file
        The result file, for the files to which its model refers.

    Returns
    -------
    str
        "" as for `variant_words`.

    Examples
    --------
    >>> text = '{"parameters": {"load": {"value": "%s"}}}'
    >>> change_words(text % "5 N m", text % "9 N m", "s", "")
    'parameters.load = 9 N m (the model: 5 N m)'
    """
    files = {"other": file} if file else {}
    leaves, differing = _compared({"one": one, "other": other}, {"one": scenario, "other": scenario}, files)
    words = []
    for path in differing:
        now, before = (
            printed(str(own[path])) if path in own else "default" for own in (leaves["other"], leaves["one"])
        )
        place = ".".join(("scenarios", scenario, *path[2:]) if path[0] == "scenario" else path)
        words.append(f"{place} = {now} (the model: {before})")
    return ", ".join(words)


def _compared(
    models: Mapping[str, str], scenarios: Mapping[str, str], files: Mapping[str, str]
) -> tuple[dict[str, Leaves], list[Path]]:
    """Values of the models, and the paths of those that differ; none if they are too many."""
    try:
        read = {name: _read(text, files.get(name)) for name, text in models.items()}
    except PitchpointError:
        try:  # a model that refers to other files can be compared as text only
            read = {name: _as_text(text) for name, text in models.items()}
        except PitchpointError:
            return {}, []
    leaves = {name: _of_scenario(written, scenarios.get(name, "")) for name, (written, _) in read.items()}
    values = {name: _of_scenario(exact, scenarios.get(name, "")) for name, (_, exact) in read.items()}
    paths = dict.fromkeys(path for own in leaves.values() for path in own)
    differing = [path for path in paths if _differs(leaves, path) and _differs(values, path)]
    return leaves, differing if len(differing) <= MAX_DIFFERENCES else []


def _read(text: str, file: str | None) -> tuple[Leaves, Leaves]:
    """Values of a model as written, and in common units; defaults are omitted from both."""
    from pitchpoint.io.yaml_model import loads_model
    from pitchpoint.model.write import plain

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ValidityWarning)  # reported when the result was computed
        model = loads_model(text, file=file)
    exact = dict(_leaves(plain(model, as_written=False)))
    exact = {path: value for path, value in exact.items() if path[0] != "parameters"}
    exact |= {("parameters", name): repr(amount) for name, amount in model.amounts.items()}
    return _named(plain(model)), exact


def _as_text(text: str) -> tuple[Leaves, Leaves]:
    """Values of a model file, twice."""
    from pitchpoint.model.reading.yaml_tree import Tree, TreeError

    try:
        found = _named(Tree(text).data)
    except TreeError as error:
        raise PitchpointError(str(error)) from None
    return found, found


def _named(data: Any) -> Leaves:
    """Values by path; those of parameters without the key `value`."""
    return {
        path[:2] if path[0] == "parameters" and path[2:] in ((), ("value",)) else path: value
        for path, value in _leaves(data)
    }


def _of_scenario(leaves: Leaves, scenario: str) -> Leaves:
    """Values of one scenario and of the model, without titles and descriptions."""
    kept = ("scenarios", scenario)
    return {
        path if path[0] != "scenarios" else ("scenario", "", *path[2:]): value
        for path, value in leaves.items()
        if path[0] != "title" and path[2:] != ("text",) and (path[0] != "scenarios" or path[:2] == kept)
    }


def _differs(leaves: Mapping[str, Leaves], path: Path) -> bool:
    """Whether some values at a path differ, except for rounding in the conversion of units."""
    return len({_rounded(own.get(path)) for own in leaves.values()}) > 1


def _rounded(value: Any) -> str:
    """A number, or the number at the beginning of a quantity, with twelve digits."""
    number, space, unit = str(value).partition(" ")
    try:
        return f"{float(number):.12g}{space}{unit}"
    except ValueError:
        return str(value)


def _leaves(node: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Paths and values of all numbers and texts."""
    if isinstance(node, Mapping):
        for key, value in node.items():
            yield from _leaves(value, (*path, str(key)))
    else:
        yield path, node
