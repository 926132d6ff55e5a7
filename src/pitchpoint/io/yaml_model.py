# SPDX-License-Identifier: Apache-2.0
"""Model files: conversion of YAML text to a checked `Model` and back.

All problems of a file are collected and reported with their lines; no contents of a file are executed.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, TextIO

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.io.includes import MEANT, Whole, means_include, with_included
from pitchpoint.io.missing_include import with_missing_include
from pitchpoint.io.model_tables import read_tables
from pitchpoint.model.build import build_model
from pitchpoint.model.changes import Paths, named, put
from pitchpoint.model.keys import INCLUDE
from pitchpoint.model.model import Model
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.reading.yaml_tree import Tree, TreeError, text_of


def load_model(
    path: str | Path | TextIO | None = None,
    allow_code: bool = False,
    progress: Progress = silent,
    *,
    text: str | None = None,
    changes: Mapping[str, Any] | None = None,
) -> Model:
    """Read a model file, or a model from text.

    Parameters
    ----------
    path
        YAML file, or an open text file.
    allow_code
        Accept entries that name Python functions. They are not run here, but by computations with the model.
    progress
        Called with the number of characters read; relevant for files of megabytes.
    text
        YAML text, in place of a file.
    changes
        New values by path as for `Model.replace_all`. They replace values that make the file invalid, too.

    Returns
    -------
    Model
        Checked model; relative file names refer to the folder of the file, those of a text to the working
        directory.

    Raises
    ------
    ModelError
        With all problems of the file or text.

    Examples
    --------
    >>> model = load_model(text="bodies: {rotor: {inertia: 0.2 kg m^2}}")
    >>> model.bodies["rotor"]
    Body(inertia='0.2 kg m^2')
    >>> repaired = {"bodies.rotor.inertia": "0.3 kg m^2"}
    >>> load_model(text="bodies: {rotor: {inertia: 0.2 kg}}", changes=repaired).bodies["rotor"].inertia
    0.3
    """
    if (path is None) == (text is None):
        given = "both a file and a text are given" if text is not None else "no file is given"
        remedy = "write load_model('model.yaml') or load_model(text=...)"
        raise ModelError([Message("", given, remedy=remedy)])
    if isinstance(path, str | Path):
        return loads_model(text_of(path), allow_code, str(path), progress, changes=changes)
    if path is not None:
        name = getattr(path, "name", None)
        file = name if isinstance(name, str) else None
        return loads_model(_content(path), allow_code, file, progress, changes=changes)
    try:
        return loads_model(str(text), allow_code, progress=progress, changes=changes)
    except ModelError as error:
        raise ModelError(error.problems, "text") from None


def _content(file: TextIO) -> str:
    """Text of an open file."""
    found: str | bytes = file.read()
    return found if isinstance(found, str) else found.decode("utf-8-sig")


def loads_model(
    text: str,
    allow_code: bool = False,
    file: str | None = None,
    progress: Progress = silent,
    *,
    changes: Mapping[str, Any] | None = None,
    options: Paths | None = None,
) -> Model:
    """Read a model from YAML text.

    Parameters
    ----------
    text
        The text.
    allow_code
        As for `load_model`.
    file
        File name for messages and base of relative file names.
    progress, changes
        As for `load_model`.
    options
        Name of the option that gives each of the changes, for messages.

    Examples
    --------
    >>> model = loads_model('''
    ... gears:
    ...   a: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
    ... ''')
    >>> model.gears["a"].normal_module
    0.003
    """
    changes = dict(changes or {})
    names = options or dict.fromkeys(changes, "changes")
    if wrong := [path for path in changes if means_include(path)]:
        raise ModelError([Message(p, "is an unknown key", remedy=MEANT, file=names[p]) for p in wrong], file)
    included = changes.pop(INCLUDE, None)
    whole = _whole(text, file, progress, included)
    directory = str(Path(file).parent if file is not None else Path())
    if whole.incomplete:  # names of missing files would be unknown everywhere
        by_option = {INCLUDE: names.get(INCLUDE, "changes")} if included is not None else {}
        raise ModelError([p if p.file else next(iter(named([p], by_option))) for p in whole.problems], file)

    def build(data: Any, more: list[Message]) -> Model:
        """Model of the data of the file, or of these with changes."""
        reader = Reader(
            lines=whole.lines, allow_code=allow_code, directory=directory, problems=[*whole.problems, *more]
        )
        try:
            return read_tables(build_model(data, reader, file, tuple(whole.files)))
        except ModelError as error:
            if file is None:
                raise
            problems = with_missing_include(error.problems, whole, Path(file))
            raise ModelError(problems, error.file) from None

    if not changes:
        return build(whole.data, [])
    try:
        model = build(whole.data, [])
    except ModelError:
        try:
            model = build(*put(whole.data, changes))
        except ModelError as error:
            raise ModelError(named(error.problems, names, whole.lines), file) from None
    try:
        return model.replace_all(changes)
    except ModelError as error:
        raise ModelError(named(error.problems, names, whole.lines), file) from None


def data_of(path: str | Path) -> Any:
    """Nested mappings of a model file and its included files, unchecked; None if it is not valid YAML."""
    try:
        return _whole(text_of(path), str(path), silent).data
    except ModelError:
        return None


def _whole(text: str, file: str | None, progress: Progress, included: Any = None) -> Whole:
    """Data of a model file and its included files, or of others, with lines and problems."""
    try:
        tree = Tree(text, progress)
    except TreeError as error:
        raise ModelError([error.problem], file) from None
    directory = Path(file).parent if file is not None else Path()
    if included is not None and isinstance(tree.data, dict):
        tree.data[INCLUDE] = included
        tree.lines.setdefault((INCLUDE,), 1)
    return with_included(tree, directory, Path(file).name if file is not None else "")


def dump_model(model: Model) -> str:
    """YAML text of a model, as `Model.to_yaml`."""
    return model.to_yaml()


def write_model(model: Model, path: str | Path) -> Path:
    """Write a model as a YAML file, which reads back to an equal model.

    Parameters
    ----------
    model
        The model. Comments of its file are not written.
    path
        The file: a new one, or an older one of this function, which is replaced. Names of other files become
        relative to the folder of the model file from which the model was read, so write to this folder.

    Returns
    -------
    Path
        Path of the file.

    Raises
    ------
    OutputError
        If the file exists and was not written by pitchpoint, or cannot be written.
    """
    from pitchpoint.io.target import MODEL_MARK, check_target, write_file

    return write_file(check_target(path, "model"), MODEL_MARK + model.to_yaml())
