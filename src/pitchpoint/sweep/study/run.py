# SPDX-License-Identifier: Apache-2.0
"""Evaluation of the cases of a study on all cores; computed cases are reused.

A case is identified by the hash of its inputs. Its record contains the numbers of all results of the
evaluation, not only of those in the plan: another plan for the same cases computes nothing.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from pitchpoint.core.errors import PitchpointError, SolverError
from pitchpoint.core.provenance import content_hash, package_version
from pitchpoint.core.status import DIED, INTERRUPTED, OK, REFUSED
from pitchpoint.sweep.case_files import file_hashes
from pitchpoint.sweep.cases import how_it_failed, run_case
from pitchpoint.sweep.study.check import Study
from pitchpoint.sweep.study.design import StudyCase, cases_of, nominal_case
from pitchpoint.sweep.study.quantities import numbers_of, value_of
from pitchpoint.sweep.threads import on_all_cores

Record = Mapping[str, Any]
"""Result of a case as stored: status, sentence, steps, notes, changes, numbers by name."""


def key_maker(study: Study) -> Callable[[StudyCase], str]:
    """Function that returns the hash of all inputs of a case.

    Inputs are the content of the model, the evaluation, the new values of the case with the contents of files
    to which they refer, and the package version; not the distributions, the sampling, or the results.
    """
    model = study.model
    base = content_hash(
        {
            "model": content_hash(model),
            "version": package_version(),
            "scenario": study.scenario,
            "evaluate": study.plan.evaluate,
        }
    )
    folder = Path(model.file).parent if model.file else Path()

    def key_of(case: StudyCase) -> str:
        """Hash the inputs of one case."""
        return content_hash(
            {"base": base, "changes": case.changes, "files": file_hashes(case.changes, folder)}
        )

    return key_of


def evaluated(study: Study, case: StudyCase, stop: threading.Event | None = None) -> dict[str, Any]:
    """Record of one case; errors are its status and sentence.

    Parameters
    ----------
    study
        The checked study.
    case
        The case.
    stop
        Event that another thread sets to stop the case.
    """
    model = study.model
    result = run_case(model, case.changes, study.scenario, case.index, stop, study.plan.evaluate)
    return {
        "status": result.status,
        "sentence": result.sentence,
        "steps": result.steps,
        "notes": list(result.notes),
        "changes": dict(case.changes),
        "numbers": numbers_of(result) if result.status == OK else {},
    }


def compute_cases(
    study: Study,
    cases: Sequence[tuple[StudyCase, str]],
    take: Callable[[str, Record], None],
    *,
    keep: Callable[[str, Record], None] = lambda key, record: None,
    jobs: int | None = None,
) -> bool:
    """Compute cases on all cores; returns False if interrupted by Ctrl-C.

    Parameters
    ----------
    study
        The checked study.
    cases
        Cases with the hashes of their inputs, all different.
    take
        Called with hash and record of each case, in the calling thread.
    keep
        Stores a case; called in the thread that computed it.
    jobs
        Number of threads; default one per core.

    Raises
    ------
    PitchpointError
        If a case could not be stored; cases in progress are abandoned.
    """
    Done = tuple[str, dict[str, Any], PitchpointError | None]

    def work(piece: tuple[StudyCase, str], stop: threading.Event) -> Done:
        """Compute and store one case."""
        case, key = piece
        lost: PitchpointError | None = None
        try:
            record = evaluated(study, case, stop)
            if record["status"] not in (INTERRUPTED, DIED):  # those are computed again
                keep(key, record)
        except Exception as error:  # noqa: BLE001 - reported for this case; the other cases are not affected
            status, words = how_it_failed(error)
            record = {
                "status": status,
                "sentence": words,
                "steps": 0,
                "notes": [],
                "changes": {},
                "numbers": {},
            }
            lost = error if isinstance(error, PitchpointError) else None
        return key, record, lost

    def taken(done: Done) -> None:
        """Pass a record to `take`; stop if it could not be stored."""
        take(done[0], done[1])
        if done[2] is not None:  # disk full: further results would be lost
            raise done[2]

    return on_all_cores(work, cases, taken, jobs)


def planned(study: Study) -> list[tuple[StudyCase, str]]:
    """The nominal case and all cases of the plan, with the hashes of their inputs."""
    key_of = key_maker(study)
    return [(case, key_of(case)) for case in (nominal_case(study), *cases_of(study))]


def remaining(
    cases: Sequence[tuple[StudyCase, str]], known: Mapping[str, Any]
) -> list[tuple[StudyCase, str]]:
    """Cases without a record, each only once, in their order."""
    first: dict[str, StudyCase] = {}
    for case, key in cases:
        if key not in known:
            first.setdefault(key, case)
    return [(case, key) for key, case in first.items()]


def values_of(study: Study, record: Record | None) -> dict[str, float]:
    """Values of the results of the plan in a case; NaN without a record, and of a failed case."""
    numbers = record["numbers"] if record is not None else {}
    return {r.name: value_of(numbers, r.channel, r.statistic) for r in study.results}


def missing_results(study: Study, nominal: Record) -> list[str]:
    """Results of the plan that the nominal case does not have."""
    if nominal["status"] != OK:
        return []
    return [r.channel for r in study.results if r.channel not in nominal["numbers"]]


def check_nominal(study: Study, nominal: Record) -> None:
    """Refuse a study whose model fails without changes, or lacks a result.

    Raises
    ------
    SolverError
        With the reason.
    """
    if nominal["status"] != OK:
        words = f"the model fails without changes: {nominal['sentence']}"
        raise SolverError(words, int(nominal["status"]))
    if missing := missing_results(study, nominal):
        raise SolverError(f"the model has no result {', '.join(missing)}", REFUSED)
