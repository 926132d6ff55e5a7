# SPDX-License-Identifier: Apache-2.0
"""Plans of data sets: conversion of YAML text to a checked `DatasetPlan`."""

from __future__ import annotations

from pathlib import Path

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_tree import Tree, TreeError, text_of
from pitchpoint.model.dataset_plan import DatasetPlan
from pitchpoint.model.reading.dataset_plan import read_plan
from pitchpoint.model.reading.reader import Reader


def load_plan(path: str | Path, allow_code: bool = False) -> DatasetPlan:
    """Read a plan; `model.reading.dataset_plan.check_plan` checks it against its model.

    Parameters
    ----------
    path
        YAML file.
    allow_code
        Accept levels that name Python functions. They are run when a case is computed, not here.

    Raises
    ------
    ModelError
        With all problems of the file.
    """
    try:
        tree = Tree(text_of(path))
    except TreeError as error:
        raise ModelError([error.problem], str(path)) from None
    reader = Reader(
        lines=tree.lines, allow_code=allow_code, directory=str(Path(path).parent), problems=tree.problems
    )
    return read_plan(tree.data, reader, str(path))
