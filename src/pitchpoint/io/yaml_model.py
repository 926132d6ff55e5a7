# SPDX-License-Identifier: Apache-2.0
"""Model files: conversion of YAML text to a checked `Model` and back.

All problems of a file are collected and reported with their lines; no contents of a file are executed.
"""

from __future__ import annotations

from pathlib import Path

from pitchpoint.core.errors import ModelError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.io.includes import with_included
from pitchpoint.io.model_tables import read_tables
from pitchpoint.io.yaml_tree import Tree, TreeError, text_of
from pitchpoint.model.build import build_model
from pitchpoint.model.model import Model
from pitchpoint.model.reading.reader import Reader


def load_model(path: str | Path, allow_code: bool = False, progress: Progress = silent) -> Model:
    """Read a model file.

    Parameters
    ----------
    path
        YAML file.
    allow_code
        Accept entries that name Python functions. They are not run here, but by computations with the model.
    progress
        Called with the number of characters read; relevant for files of megabytes.

    Returns
    -------
    Model
        Checked model; relative file names refer to the folder of the file.

    Raises
    ------
    ModelError
        With all problems of the file.
    """
    text = text_of(path)
    return loads_model(text, allow_code=allow_code, file=str(path), progress=progress)


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
    """YAML text of a model that reads back to an equal model.

    Quantities have customary units if the conversion is exact, else SI units.
    """
    from io import StringIO

    from ruamel.yaml import YAML

    from pitchpoint.model.write import plain

    yaml = YAML(typ="rt", pure=True)
    yaml.default_flow_style = None
    yaml.width = 110
    stream = StringIO()
    yaml.dump(plain(model), stream)
    return stream.getvalue()
