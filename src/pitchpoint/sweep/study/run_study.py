# SPDX-License-Identifier: Apache-2.0
"""`run_study`: a whole study as a dataset."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INTERRUPTED, sentence
from pitchpoint.model.reading.plan import model_path
from pitchpoint.model.study_plan import StudyPlan
from pitchpoint.sweep.study.check import check_study
from pitchpoint.sweep.study.run import Record, check_nominal, compute_cases, planned, remaining
from pitchpoint.sweep.study.summary import study_dataset

if TYPE_CHECKING:
    import xarray as xr


def run_study(
    plan: StudyPlan | str | os.PathLike[str],
    *,
    folder: str | os.PathLike[str] | None = None,
    jobs: int | None = None,
    progress: Progress = silent,
) -> xr.Dataset:
    """Compute a study: the spread of results over the distributions of its factors, with sensitivities.

    Parameters
    ----------
    plan
        File of a plan, or a plan read by `pitchpoint.io.yaml_plan.load_study`.
    folder
        Folder in which every case is stored when it is computed, and from which computed cases are taken; as
        of `pitchpoint study -o`. Default: none, the cases are only in memory.
    jobs
        Number of threads; default one per core.
    progress
        Called after each case with the number of finished cases.

    Returns
    -------
    xarray.Dataset
        `factor[NAME]` and `result[NAME]` over `case`, their statistics over `result`, sensitivities over
        `result` and `factor`; see `sweep.study.summary.study_dataset`.

    Raises
    ------
    ModelError
        With all problems of the plan.
    SolverError
        If the model cannot be computed without changes, or after Ctrl-C.
    """
    from pitchpoint.io.study_store import StudyFolder
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.io.yaml_plan import load_study
    from pitchpoint.model.reading.yaml_tree import text_of

    read = plan if isinstance(plan, StudyPlan) else load_study(os.fspath(plan))
    file = model_path(read)
    study = check_study(read, load_model(file, allow_code=read.allow_code))
    cases = planned(study)
    store = StudyFolder(folder) if folder is not None else None
    known: dict[str, Record] = dict(store.known(key for _, key in cases)) if store is not None else {}
    if store is not None:
        store.begin(text_of(read.file) if read.file else "", text_of(str(file)))
    todo = remaining(cases, known)
    count = len(todo)

    def take(key: str, record: Record) -> None:
        """Store a record and report the progress."""
        known[key] = record
        progress(count - len(remaining(cases, known)), count)

    whole = compute_cases(study, todo, take, keep=store.write if store else lambda k, r: None, jobs=jobs)
    if not whole:
        raise SolverError(sentence(INTERRUPTED), INTERRUPTED)
    check_nominal(study, known[cases[0][1]])
    return study_dataset(study, cases, known)
