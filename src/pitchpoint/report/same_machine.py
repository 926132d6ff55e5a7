# SPDX-License-Identifier: Apache-2.0
"""Results of another machine: their scene, curves and powers would be drawn on parts of the wrong model."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import Message, ModelError, PitchpointError, ValidityWarning

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

SECTIONS = {"bodies": ("bodies", "shafts"), "meshes": ("meshes", "bevel_meshes")}
"""Sections of a model file with the names that results share with their model, by what they contain."""
REMEDY = "give the model of this result, or no model file: the model is in the result"
MOST = 6
"""Names listed of one kind."""

Names = Mapping[str, Iterable[str]]


def require_same_machine(
    model: Model, results: Sequence[str | os.PathLike[str] | xr.Dataset], remedy: str = REMEDY
) -> None:
    """Require that the model of every result has the bodies and meshes of a model; values may differ.

    Parameters
    ----------
    model
        Model.
    results
        Files and datasets; those without a model are not checked.
    remedy
        Of the error.

    Raises
    ------
    ModelError
        With the names that only one of the two models has, for all results.
    """
    from pitchpoint.core.provenance import content_hash

    problems = []
    own = content_hash(model)
    for number, result in enumerate(results, start=1):
        place, attrs, file = f"result {number}", getattr(result, "attrs", {}), None
        if isinstance(result, str | os.PathLike):
            place, attrs, file = Path(result).name, _header(result), os.fspath(result)
        text = str(attrs.get("model_text") or "")
        if text and str(attrs.get("model_hash", "")) != own:
            words = _differing(*_names(model, text, file))
            if words:
                problems.append(Message(place, f"was computed with another machine: {words}", remedy=remedy))
    if problems:
        raise ModelError(problems)


def _header(path: str | os.PathLike[str]) -> Mapping[str, Any]:
    from pitchpoint.io.opening import understood
    from pitchpoint.io.reading import read_header

    with understood(path):
        return read_header(os.fspath(path))


def _names(model: Model, text: str, file: str | None) -> tuple[Names, Names]:
    """Names of the bodies and meshes of a model, and of that of a result; as in their files if necessary."""
    from pitchpoint.io.yaml_model import loads_model
    from pitchpoint.model.write import model_text

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ValidityWarning)  # reported when the result was computed
            other = loads_model(text, file=file)
    except PitchpointError:  # it refers to files that are not here, or to functions
        return _written(model_text(model)), _written(text)
    return _read(model), _read(other)


def _read(model: Model) -> Names:
    return {"bodies": tuple(model.bodies), "meshes": tuple(model.every_mesh)}


def _written(text: str) -> Names:
    from pitchpoint.model.reading.yaml_tree import Tree, TreeError

    try:
        data = Tree(text).data
    except TreeError:
        return {}
    return {
        kind: [name for part in parts for name in data.get(part) or ()] for kind, parts in SECTIONS.items()
    }


def _differing(own: Names, other: Names) -> str:
    """Names that only one of two models has, in words.

    Examples
    --------
    >>> _differing({"bodies": ["a", "b"]}, {"bodies": ["b", "c", "d"]})
    'bodies c, d, which the model lacks; it lacks bodies a'
    >>> _differing({"bodies": ["a"]}, {"bodies": ["a"]}), _differing({"bodies": ["a"]}, {})
    ('', '')
    """
    pairs = [(kind, set(own[kind]), set(other[kind])) for kind in SECTIONS if kind in own and kind in other]
    more = [f"{kind} {_listed(theirs - ours)}" for kind, ours, theirs in pairs if theirs - ours]
    less = [f"{kind} {_listed(ours - theirs)}" for kind, ours, theirs in pairs if ours - theirs]
    words = [f"{' and '.join(more)}, which the model lacks"] if more else []
    words += [f"it lacks {' and '.join(less)}"] if less else []
    return "; ".join(words)


def _listed(names: set[str]) -> str:
    found = sorted(names)
    more = f" and {len(found) - MOST} more" if len(found) > MOST else ""
    return ", ".join(found[:MOST]) + more
