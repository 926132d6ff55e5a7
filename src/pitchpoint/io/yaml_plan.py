# SPDX-License-Identifier: Apache-2.0
"""Plans of data sets and studies: conversion of YAML text to a checked `DatasetPlan` or `StudyPlan`."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from pitchpoint.core.errors import ModelError
from pitchpoint.model.dataset_plan import DatasetPlan
from pitchpoint.model.reading.dataset_plan import read_plan
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.reading.study_plan import read_study
from pitchpoint.model.reading.yaml_tree import Tree, TreeError, text_of
from pitchpoint.model.study_plan import StudyPlan

P = TypeVar("P")


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
    return _loaded(path, allow_code, read_plan)


def load_study(path: str | Path, allow_code: bool = False) -> StudyPlan:
    """Read the plan of a study; `sweep.study.check` checks it against its model.

    Parameters
    ----------
    path, allow_code
        As for `load_plan`.

    Raises
    ------
    ModelError
        With all problems of the file.
    """
    return _loaded(path, allow_code, read_study)


def _loaded(path: str | Path, allow_code: bool, read: Callable[[Any, Reader, str], P]) -> P:
    """Read a YAML file with the reader of its kind."""
    try:
        tree = Tree(text_of(path))
    except TreeError as error:
        raise ModelError([error.problem], str(path)) from None
    reader = Reader(
        lines=tree.lines, allow_code=allow_code, directory=str(Path(path).parent), problems=tree.problems
    )
    return read(tree.data, reader, str(path))
