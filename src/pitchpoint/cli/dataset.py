# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint dataset`: labelled data set of many cases of a model, one file per case and a common table."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common
from pitchpoint.cli.output import emit_json, show
from pitchpoint.cli.plan_options import plan_options

if TYPE_CHECKING:
    from pitchpoint.io.container import Header
    from pitchpoint.io.dataset_store import DatasetFolder
    from pitchpoint.model.dataset_plan import DatasetPlan, PlannedCase
    from pitchpoint.model.model import Model
    from pitchpoint.sweep.dataset import CaseRecord

REFRESH = 10.0
"""Interval at which the table is rewritten during the computation [s]."""
MAX_FAILURES = 5
PROBE = 0.05
"""Simulated time of the shorter of the two runs from which `--dry-run` extrapolates [s]."""


@click.command()
@plan_options(
    "Folder of the data set; default: PLAN-data in the current folder.", "number of cases, file size"
)
@common
def dataset(
    file: str,
    output: str | None,
    jobs: int | None,
    shard: tuple[int, int],
    dry_run: bool,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> int:
    """Compute the labelled data set of PLAN: every combination of its factors, with every seed.

    Cases that are already in the folder are not computed again: rerun the command after an interruption or
    with a longer plan.
    """
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.core.kernel import expect
    from pitchpoint.io.dataset_store import DatasetFolder
    from pitchpoint.io.yaml_plan import load_plan
    from pitchpoint.solvers.fixed_steps import loop_of
    from pitchpoint.sweep.dataset import key_maker

    plan, model = checked(load_plan(file, allow_code), allow_code, quiet)
    folder = DatasetFolder(output or f"{Path(file).stem}-data")
    key_of = key_maker(plan, model)
    cases = [(case, key_of(case)) for case in plan.cases() if case.index % shard[1] == shard[0] - 1]
    known = folder.known(key for _, key in cases)
    todo = list({key: (case, key) for case, key in reversed(cases) if key not in known}.values())[::-1]
    summary = {"plan": file, "output": str(folder.path), "cases": len(cases), "known": len(cases) - len(todo)}
    if dry_run:
        summary |= forecast(plan, model, todo, jobs)
        emit_json(summary) if as_json else show(forecast_words(summary))
        return OK
    expect(loop_of(model.scenarios[str(plan.scenario)].method))
    folder.begin(Path(file).read_text("utf-8-sig"), Path(str(model.file)).read_text("utf-8-sig"))
    name = "index.csv" if shard[1] == 1 else f"index-{shard[0]}-of-{shard[1]}.csv"
    table = Table(plan, folder, name, cases, known)
    error = compute(plan, model, folder, table, todo, jobs=jobs, quiet=quiet)
    summary |= table.summary()
    if as_json:
        emit_json(summary)
    elif not quiet:
        show(f"{summary['finished']} of {len(cases)} cases are in {folder.path}, the table is {table.path}")
        if others := folder.others(key for _, key in cases):
            show(f"note: {others} files in the folder are from other shards, plans or versions")
        for words in table.failures()[:MAX_FAILURES]:
            show(words)
    return OK if error is None else exit_code_of(error)


def checked(plan: DatasetPlan, allow_code: bool, quiet: bool) -> tuple[DatasetPlan, Model]:
    """Plan, checked against its model, and the model."""
    from pitchpoint.cli.reading import read_model
    from pitchpoint.model.reading.dataset_plan import check_plan
    from pitchpoint.model.reading.plan import model_path
    from pitchpoint.system.compile import compile_model

    model = read_model(str(model_path(plan)), allow_code, quiet)
    over_time = [name for name, s in model.scenarios.items() if s.kind == "time"]
    chosen = plan.scenario if plan.scenario in over_time else over_time[0] if over_time else None
    system = compile_model(model, chosen) if model.bodies else None
    names = tuple(c.name for c in system.layout.channels) if system is not None else ()
    return check_plan(plan, model, names), model


def compute(
    plan: DatasetPlan,
    model: Model,
    folder: DatasetFolder,
    table: Table,
    todo: Sequence[tuple[PlannedCase, str]],
    *,
    jobs: int | None,
    quiet: bool,
) -> BaseException | None:
    """Compute the remaining cases; return the reason why the data set is incomplete, or None."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.provenance import content_hash
    from pitchpoint.core.status import DIED, INTERRUPTED, OK, sentence
    from pitchpoint.io.target import OutputError
    from pitchpoint.sweep.dataset import compute_cases

    digest = content_hash(model)

    def keep(record: CaseRecord) -> None:
        """Write a case, unless it was interrupted."""
        if record.status not in (INTERRUPTED, DIED):  # those are computed again
            folder.write(record, header_of(plan, model, digest, record), plan.sample_rate, plan.samples)

    table.write()
    with ProgressDisplay(f"dataset {Path(str(plan.file)).name}", "cases", quiet=quiet) as progress:
        progress(0, len(todo))

        def take(record: CaseRecord) -> None:
            """Count a case and show the progress."""
            table.put(record)
            failed = f"{table.failed} failed" if table.failed else ""
            progress(table.done, len(todo), failed)

        try:
            whole = compute_cases(plan, model, todo, take, keep=keep, jobs=jobs)
        except OutputError as error:
            with contextlib.suppress(OutputError):
                table.write()
            raise OutputError(f"{error}; previous cases are retained; fix this and rerun") from error
    table.write()
    if not whole:
        return SolverError(f"{sentence(INTERRUPTED)}; rerun to continue", INTERRUPTED, str(folder.path))
    bad = [row for row in table.rows.values() if row["status_code"] not in ("", OK)]
    if not bad:
        return None
    words = f"{len(bad)} of {len(table.rows)} cases failed; case {bad[0]['case']}: {bad[0]['sentence']}"
    return SolverError(words, int(bad[0]["status_code"]), str(table.path))


def header_of(plan: DatasetPlan, model: Model, digest: str, record: CaseRecord) -> Header:
    """Provenance and labels of a case, independent of time and place of the computation."""
    from pitchpoint.io.container import Header
    from pitchpoint.sweep.dataset import lead, treatment

    scenario = model.scenarios[str(plan.scenario)]
    options: dict[str, Any] = {
        "case": record.key,
        "labels": dict(record.case.labels),
        "changes": {path: str(value) for path, value in record.case.changes.items()},
        "numbers": {path: list(number) for path, number in record.numbers.items()},
        "seed": record.case.seed,
        "sample_rate": plan.sample_rate,
        "anti_aliasing": treatment(plan),
        "dropped_before": lead(plan) / plan.sample_rate,
    }
    return Header(
        kind="time",
        title=plan.title or model.title,
        scenario=str(plan.scenario),
        solver=scenario.method,
        model_hash=digest,
        options=options,
        stamped=False,
    )


class Table:
    """Table of the cases, one row each, rewritten every few seconds."""

    def __init__(
        self,
        plan: DatasetPlan,
        folder: DatasetFolder,
        name: str,
        cases: Sequence[tuple[PlannedCase, str]],
        known: Mapping[str, Mapping[str, Any]],
    ) -> None:
        self.folder, self.name, self.path = folder, name, folder.path / name
        self.rows: dict[int, dict[str, Any]] = {}
        self.done = self.failed = 0
        self._of: dict[str, list[int]] = {}
        self._units: dict[str, str] = {}
        from pitchpoint.io.contact_numbers import RATTLE
        from pitchpoint.sweep.dataset import contact_states

        meshes = [state.removeprefix("contact_state") for state in contact_states(plan)]
        contacts = [f"{name}{mesh}" for mesh in meshes for name, _, _ in RATTLE]
        self._paths = dict.fromkeys((*plan.paths, *plan.jitter, *contacts))
        self._labels = list(plan.factors)
        for case, key in cases:
            row = {"case": case.index, "file": "", "status": "waiting", "status_code": "", "sentence": ""}
            self.rows[case.index] = {**row, **case.labels, "seed": case.seed}
            self._of.setdefault(key, []).append(case.index)
        for key, header in known.items():
            numbers = header["options"].get("numbers", {})
            self._fill(
                key, int(header["status_code"]), str(header["sentence"]), int(header["steps"]), numbers
            )
        self._written = time.monotonic()

    def put(self, record: CaseRecord) -> None:
        """Add a computed case."""
        from pitchpoint.core.status import OK

        self.done += 1
        self.failed += record.status != OK
        self._fill(record.key, record.status, record.sentence, record.steps, record.numbers)
        if time.monotonic() - self._written > REFRESH:
            self.write()

    def _fill(self, key: str, code: int, words: str, steps: int, numbers: Mapping[str, Any]) -> None:
        from pitchpoint.cli.results import how_a_status_ends

        there = self.folder.file_of(key)
        found = {
            "file": str(there.relative_to(self.folder.path)) if there.exists() else "",
            "status": how_a_status_ends(code),
            "status_code": code,
            "sentence": words,
            "steps": steps,
        }
        for path, (number, unit) in numbers.items():
            self._units[path] = unit
            found[path] = repr(float(number))
        for index in self._of[key]:
            self.rows[index] |= found

    def write(self) -> None:
        """Write the table."""
        titles = {path: f"{path} [{self._units.get(path, '')}]".replace(" []", "") for path in self._paths}
        columns = [*self._labels, "seed", "steps", *titles.values()]
        rows = [{titles.get(name, name): v for name, v in row.items()} for row in self.rows.values()]
        self.folder.write_index(self.name, columns, rows)
        self._written = time.monotonic()

    def summary(self) -> dict[str, Any]:
        """Number of cases by status."""
        ways = [row["status"] for row in self.rows.values()]
        return {"table": str(self.path), **{w: ways.count(w) for w in ("finished", "failed", "waiting")}}

    def failures(self) -> list[str]:
        """Messages of failed cases."""
        return [f"case {r['case']}: {r['sentence']}" for r in self.rows.values() if r["status"] == "failed"]


def forecast(
    plan: DatasetPlan, model: Model, todo: Sequence[tuple[PlannedCase, str]], jobs: int | None
) -> dict[str, Any]:
    """Size and computing time of the remaining cases, extrapolated from a short run of the first case."""
    import os
    from dataclasses import replace

    from pitchpoint.sweep.dataset import compute_case, lead, reach

    per_sample = sum(4 if hasattr(c, "channel") else 1 for c in plan.channels.values()) + 8
    found: dict[str, Any] = {"left": len(todo), "bytes": len(todo) * (per_sample * plan.samples + 20_000)}
    if not todo:
        return found | {"seconds": 0.0, "jobs": 0}
    case, key = todo[0]
    spent, sizes = [], []
    for length in (PROBE, PROBE, 3.0 * PROBE):  # kernels are loaded in the first
        piece = replace(plan, length=min(length, plan.length), settle_time=0.0)
        begun = time.perf_counter()
        tried = compute_case(piece, model, case, key)
        spent.append(time.perf_counter() - begun)
        sizes.append(lead(piece) + piece.samples + reach(piece))
    whole = lead(plan) + plan.samples + reach(plan)
    # the time to compile a system does not depend on the duration
    slope = (spent[2] - spent[1]) / (sizes[2] - sizes[1]) if sizes[2] > sizes[1] else 0.0
    each = spent[2] + max(slope, 0.0) * (whole - sizes[2])
    threads = min(jobs or os.cpu_count() or 1, len(todo))
    found |= {"seconds": len(todo) * each / threads, "jobs": threads}
    return found | {"first_case": tried.sentence}


def forecast_words(summary: Mapping[str, Any]) -> str:
    """Time and size of a data set in words."""
    from pitchpoint.cli.progress import duration_text

    size = summary["bytes"] / 1e6
    text = f"{summary['cases']} cases, {summary['known']} completed, {summary['left']} remaining"
    if not summary["left"]:
        return text
    return (
        f"{text}: at most {size:.3g} MB in {summary['output']}, about {duration_text(summary['seconds'])} "
        f"on {summary['jobs']} cores (extrapolated from a short run of the first: {summary['first_case']})"
    )
