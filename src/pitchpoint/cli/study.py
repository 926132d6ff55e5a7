# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint study`: spread of results over the distributions of factors, yield and sensitivities."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common
from pitchpoint.cli.output import emit_json, show, show_notes
from pitchpoint.cli.plan_options import plan_options

if TYPE_CHECKING:
    from pitchpoint.io.study_store import StudyFolder
    from pitchpoint.sweep.study.check import Study
    from pitchpoint.sweep.study.design import StudyCase
    from pitchpoint.sweep.study.run import Record

    Cases = Sequence[tuple[StudyCase, str]]

MAX_FAILURES = 5


@click.command()
@plan_options("Folder of the study; default: PLAN-study in the current folder.", "factors, number of cases")
@common
def study(
    file: str,
    output: str | None,
    jobs: int | None,
    shard: tuple[int, int],
    dry_run: bool,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> int:
    """Compute the study of PLAN: results of a model whose numbers vary, their spread and its causes.

    Writes tables, a result file and a page with pictures. Cases that are already in the folder are not
    computed again: rerun the command after an interruption, with more samples or with other results.
    """
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.study_output import forecast_words, show_factors
    from pitchpoint.io.study_store import StudyFolder
    from pitchpoint.io.yaml_plan import load_study
    from pitchpoint.model.reading.plan import model_path
    from pitchpoint.sweep.study.check import check_study
    from pitchpoint.sweep.study.remarks import remarks
    from pitchpoint.sweep.study.run import planned, remaining

    plan = load_study(file, allow_code)
    checked = check_study(plan, read_model(str(model_path(plan)), allow_code, quiet))
    folder = StudyFolder(output or f"{Path(file).stem}-study")
    cases = planned(checked)
    known: dict[str, Record] = dict(folder.known(key for _, key in cases))
    own = [cases[0], *(c for c in cases[1:] if c[0].index % shard[1] == shard[0] - 1)]
    todo = remaining(own, known)
    summary: dict[str, Any] = {
        "plan": file,
        "output": str(folder.path),
        "cases": len(cases) - 1,
        "known": len(own) - len(todo),
        "remarks": remarks(checked),
    }
    if dry_run:
        summary |= forecast(checked, todo, jobs)
        if as_json:
            emit_json(summary)
        else:
            show_factors(checked)
            show_notes(summary["remarks"])
            show(forecast_words(summary))
        return OK
    folder.begin(Path(file).read_text("utf-8-sig"), Path(str(checked.model.file)).read_text("utf-8-sig"))
    if not quiet and not as_json:
        show_notes(summary["remarks"])
    error = compute(checked, folder, todo, known, jobs=jobs, quiet=quiet)
    if error is None:
        error = finish(checked, folder, cases, known, shard, summary, as_json=as_json, quiet=quiet)
    return OK if error is None else exit_code_of(error)


def compute(
    study: Study,
    folder: StudyFolder,
    todo: Cases,
    known: dict[str, Record],
    *,
    jobs: int | None,
    quiet: bool,
) -> BaseException | None:
    """Compute the remaining cases, the nominal one first; return the reason why they are incomplete."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.status import INTERRUPTED, OK, sentence
    from pitchpoint.io.target import OutputError
    from pitchpoint.sweep.study.run import check_nominal, compute_cases

    done = failed = 0
    with ProgressDisplay(f"study {Path(str(study.plan.file)).name}", "cases", quiet=quiet) as progress:
        progress(0, len(todo))

        def take(key: str, record: Record) -> None:
            """Count a case and show the progress."""
            nonlocal done, failed
            known[key] = record
            done += 1
            failed += record["status"] not in (OK, INTERRUPTED)
            progress(done, len(todo), f"{failed} failed" if failed else "")

        try:
            first = todo[:1] if todo and todo[0][0].index < 0 else []
            whole = compute_cases(study, first, take, keep=folder.write, jobs=jobs) if first else True
            if first and whole:
                check_nominal(study, known[first[0][1]])
            whole = whole and compute_cases(study, todo[len(first) :], take, keep=folder.write, jobs=jobs)
        except OutputError as error:
            raise OutputError(f"{error}; previous cases are retained; fix this and rerun") from error
    if not whole:
        return SolverError(f"{sentence(INTERRUPTED)}; rerun to continue", INTERRUPTED, str(folder.path))
    return None


def finish(
    study: Study,
    folder: StudyFolder,
    cases: Cases,
    known: Mapping[str, Record],
    shard: tuple[int, int],
    summary: dict[str, Any],
    *,
    as_json: bool,
    quiet: bool,
) -> BaseException | None:
    """Write the tables and the page, print the summary; return the error of failed cases."""
    from pitchpoint.cli.study_output import as_data, index_rows, show_summary
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.status import OK
    from pitchpoint.io.study_store import PAGE, TABLE
    from pitchpoint.sweep.study.run import check_nominal
    from pitchpoint.sweep.study.summary import summarised

    check_nominal(study, known[cases[0][1]])
    part, whole = shard
    name = "index.csv" if whole == 1 else f"index-{part}-of-{whole}.csv"
    own = [c for c in cases[1:] if c[0].index % whole == part - 1]
    columns, rows = index_rows(study, own, known, folder)
    table = folder.write_index(name, columns, rows)
    bad = [row for row in rows if row["status_code"] not in ("", OK)]
    summary |= {"table": str(table), "finished": len(rows) - len(bad), "failed": len(bad)}
    if all(key in known for _, key in cases):
        found = summarised(study, cases, known)
        write_products(study, folder, cases, known, found)
        summary |= {"page": str(folder.path / PAGE), "file": str(folder.path / TABLE), **as_data(found)}
        if not as_json and not quiet:
            show_summary(study, found)
    elif not as_json and not quiet:
        show("other shards are incomplete: run the command without --shard when all have finished")
    if as_json:
        emit_json(summary)
    elif not quiet:
        show(f"{summary['finished']} of {len(rows)} cases are in {folder.path}, the table is {table}")
        if "page" in summary:
            show(f"the pictures are in {summary['page']}")
        if others := folder.others(key for _, key in cases):
            show(f"note: {others} files in the folder are from other plans or versions")
        for row in bad[:MAX_FAILURES]:
            show(f"case {row['case']}: {row['sentence']}")
    if not bad:
        return None
    words = f"{len(bad)} of {len(rows)} cases failed; case {bad[0]['case']}: {bad[0]['sentence']}"
    return SolverError(words, int(bad[0]["status_code"]), str(table))


def write_products(
    study: Study, folder: StudyFolder, cases: Cases, known: Mapping[str, Record], found: Any
) -> None:
    """Write the result file and the page with pictures."""
    from dataclasses import replace

    from pitchpoint.core.provenance import content_hash, package_version
    from pitchpoint.core.status import OK
    from pitchpoint.io.container import FAILED, FINISHED, Header
    from pitchpoint.io.dataset_tables import write_dataset
    from pitchpoint.io.study_store import PAGE, TABLE
    from pitchpoint.io.target import write_file
    from pitchpoint.sweep.study.summary import options_of, study_dataset
    from pitchpoint.viz.study_page import study_page

    data = study_dataset(study, cases, known)
    title = study.plan.title or study.model.title
    header = Header(
        kind="study",
        title=title,
        scenario=study.scenario or "",
        solver="study",
        model_hash=content_hash(study.model),
        options=options_of(study),
        stamped=False,
    )
    bad = [int(code) for code in data["status"].values if code != OK]
    write_dataset(
        folder.path / TABLE,
        header,
        data.drop_vars([name for name in data.variables if data[name].size == 0]),
        status=FAILED if bad else FINISHED,
        code=bad[0] if bad else OK,
        sentence=f"{len(bad)} of {data.sizes['case']} cases failed" if bad else "",
        notes=tuple(data.attrs["notes"]),
    )
    found = replace(found, notes=tuple(data.attrs["notes"]))
    text = study_page(found, title or str(study.plan.file), options_of(study), package_version())
    write_file(folder.path / PAGE, text)


def forecast(study: Study, todo: Cases, jobs: int | None) -> dict[str, Any]:
    """Computing time of the remaining cases, from the time of the first."""
    import os

    from pitchpoint.sweep.study.run import evaluated

    if not todo:
        return {"left": 0, "seconds": 0.0, "jobs": 0}
    evaluated(study, todo[0][0])  # kernels are loaded
    begun = time.perf_counter()
    tried = evaluated(study, todo[-1][0])
    spent = time.perf_counter() - begun
    threads = min(jobs or os.cpu_count() or 1, len(todo))
    seconds = len(todo) * spent / threads
    return {"left": len(todo), "seconds": seconds, "jobs": threads, "tried_case": tried["sentence"]}
