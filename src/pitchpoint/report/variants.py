# SPDX-License-Identifier: Apache-2.0
"""Variants of a model among results: what differs between the models stored in them, in words."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

from pitchpoint.viz.quantities import printed

MAX_DIFFERENCES = 4
"""Differing values up to which variants are named after them."""


def variant_words(models: Mapping[str, str], scenarios: Mapping[str, str]) -> dict[str, str]:
    """What differs between results, in words.

    Parameters
    ----------
    models
        Text of the stored model (JSON) by name of the result.
    scenarios
        Scenario by name of the result; only the values of this scenario count.

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
    try:
        leaves = {name: dict(_leaves(json.loads(text))) for name, text in models.items()}
    except ValueError:
        return {}
    for name, own in leaves.items():
        kept = ("scenarios", scenarios.get(name, ""))
        leaves[name] = {
            path if path[0] != "scenarios" else ("scenario", "", *path[2:]): value
            for path, value in own.items()
            if path[0] != "title" and (path[0] != "scenarios" or path[:2] == kept)
        }
    paths = dict.fromkeys(path for own in leaves.values() for path in own)
    differing = [path for path in paths if len({str(own.get(path)) for own in leaves.values()}) > 1]
    if not 0 < len(differing) <= MAX_DIFFERENCES:
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


def _leaves(node: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Paths and values of all numbers and texts."""
    if isinstance(node, Mapping):
        for key, value in node.items():
            yield from _leaves(value, (*path, str(key)))
    else:
        yield path, node
