# SPDX-License-Identifier: Apache-2.0
"""Model files: conversion of YAML text to a checked `Model` and back.

All problems of a file are collected and reported with their lines; no contents of a file are executed.
"""

from __future__ import annotations

from pathlib import Path
from typing import TextIO

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.io.includes import with_included
from pitchpoint.io.model_tables import read_tables
from pitchpoint.io.yaml_tree import Tree, TreeError, text_of
from pitchpoint.model.build import build_model
from pitchpoint.model.model import Model
from pitchpoint.model.reading.reader import Reader


def load_model(
    path: str | Path | TextIO | None = None,
    allow_code: bool = False,
    progress: Progress = silent,
    *,
    text: str | None = None,
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
    """
    if (path is None) == (text is None):
        given = "both a file and a text are given" if text is not None else "no file is given"
        remedy = "write load_model('model.yaml') or load_model(text=...)"
        raise ModelError([Message("", given, remedy=remedy)])
    if isinstance(path, str | Path):
        return loads_model(text_of(path), allow_code=allow_code, file=str(path), progress=progress)
    if path is not None:
        name = getattr(path, "name", None)
        return loads_model(_content(path), allow_code, name if isinstance(name, str) else None, progress)
    try:
        return loads_model(str(text), allow_code=allow_code, progress=progress)
    except ModelError as error:
        raise ModelError(error.problems, "text") from None


def _content(file: TextIO) -> str:
    """Text of an open file."""
    found: str | bytes = file.read()
    return found if isinstance(found, str) else found.decode("utf-8-sig")


def loads_model(
    text: str, allow_code: bool = False, file: str | None = None, progress: Progress = silent
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
    progress
        As for `load_model`.

    Examples
    --------
    >>> model = loads_model('''
    ... gears:
    ...   a: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
    ... ''')
    >>> model.gears["a"].normal_module
    0.003
    """
    try:
        tree = Tree(text, progress)
    except TreeError as error:
        raise ModelError([error.problem], file) from None
    directory = Path(file).parent if file is not None else Path()
    whole = with_included(tree, directory, Path(file).name if file is not None else "")
    reader = Reader(
        lines=whole.lines, allow_code=allow_code, directory=str(directory), problems=whole.problems
    )
    return read_tables(build_model(whole.data, reader, file, tuple(whole.files)))


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
