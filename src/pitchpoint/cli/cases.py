# SPDX-License-Identifier: Apache-2.0
"""`--vary` of `run` and `sweep`: many variants of a model on all cores, with one results table."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from pitchpoint.analysis.mesh_sweep import points_of_mesh, swept_meshes
from pitchpoint.cli.output import NOTHING, emit_json, largest, show, show_notes, shown, table
from pitchpoint.cli.settings import say_bare
from pitchpoint.cli.vary import varied
from pitchpoint.core.extremes import greatest
from pitchpoint.core.load_sharing import factor_name, is_factor, stage_of

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.model.model import Model
    from pitchpoint.sweep.cases import CaseResult

MAX_ROWS = 60
MAX_NOTES = 5


def run_varied(
    model: Model,
    file: str,
    name: str,
    target: Path,
    vary: Sequence[str],
    *,
    jobs: int | None,
    as_json: bool,
    quiet: bool,
) -> int:
    """Run all combinations of the values, write and print the table; return the exit code."""
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.core.errors import SolverError
    from pitchpoint.io.writing import how_it_ended
    from pitchpoint.model.numbers import has_path, is_name
    from pitchpoint.model.replace import bare_in
    from pitchpoint.sweep.cases import grid

    paths = varied(vary, partial(has_path, model))
    cases = grid(paths)
    refuse_the_impossible(model, cases)
    bare = (found for path in paths for value in paths[path] for found in bare_in(model, path, value))
    say_bare(bare, dict.fromkeys(paths, "--vary"))
    begun = time.perf_counter()
    results: list[CaseResult] = []
    error: BaseException | None
    try:
        results, status, error = compute(model, file, name, target, cases, jobs=jobs, quiet=quiet)
    except (SolverError, KeyboardInterrupt) as stopped:
        # the model cannot be compiled: no case was started
        status, error = how_it_ended(stopped)[0], stopped
    wall_s = time.perf_counter() - begun
    if as_json:
        emit_json(
            {
                "status": status,
                "wall_s": wall_s,
                "output": str(target) if results else None,
                "vary": paths,
                "cases": [as_data(result) for result in results],
            }
        )
    elif results and not quiet:
        heads = [shortest(path, list(paths), is_name(model, path)) for path in paths]
        _print(f"{model.title or file}: {name}", results, list(paths), heads)
        show(f"{len(results)} cases in {wall_s:.3g} s, written to {target}")
        notes = notes_of(results)
        show_notes(notes[:MAX_NOTES])
        if len(notes) > MAX_NOTES:
            show(f"note: {len(notes) - MAX_NOTES} more notes on single cases are in the file")
    return OK if error is None else exit_code_of(error)


def refuse_the_impossible(model: Model, cases: Sequence[dict[str, Any]]) -> None:
    """Stop with all problems if no case can be run; single invalid cases only get a status."""
    from pitchpoint.core.errors import Message, ModelError

    problems: dict[Message, None] = {}
    for case in cases:
        try:
            model.replace_all(case)
        except ModelError as error:
            problems |= dict.fromkeys(error.problems)
        else:
            return
    raise ModelError(list(problems), "--vary")


def compute(
    model: Model,
    file: str,
    name: str,
    target: Path,
    cases: Sequence[dict[str, Any]],
    *,
    jobs: int | None = None,
    quiet: bool = False,
) -> tuple[list[CaseResult], str, BaseException | None]:
    """Run cases into a file; return results, status, and the reason for a stop or for failed cases."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import header_of, how_a_status_ends
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.status import INTERRUPTED, OK, sentence
    from pitchpoint.io.case_store import CaseWriter
    from pitchpoint.model.numbers import number_at
    from pitchpoint.sweep.case_channels import case_channels
    from pitchpoint.sweep.cases import run_cases

    chosen = model.scenarios[name]
    header = header_of(model, file, name, "cases", chosen.method)
    known = {path: number_at(model, path) for path in cases[0]}
    units = {path: number[1] for path, number in known.items() if number is not None}
    header = replace(header, options={**header.options, "vary_units": units})
    texts = {path: [str(case[path]) for case in cases] for path in cases[0]}
    channels, plan = case_channels(model, chosen)
    with CaseWriter(target, header, texts, channels, **plan) as writer:
        with ProgressDisplay(f"run {name}", "cases", quiet=quiet) as progress:
            results = run_cases(model, cases, name, jobs=jobs, progress=progress, sink=writer.put)
        bad = [r for r in results if r.status != OK]
        stopped = any(r.status == INTERRUPTED for r in bad)
        code = INTERRUPTED if stopped else bad[0].status if bad else OK
        words = sentence(code)
        if bad:
            done = len(results) - len(bad)
            why = words if stopped else f"case {bad[0].index}: {bad[0].sentence}"
            words = f"{done} of {len(results)} cases finished; {why}"
        status = how_a_status_ends(code)
        writer.finish(status, words, code=code, steps=sum(r.steps for r in results), notes=notes_of(results))
    return results, status, SolverError(words, code, str(target)) if bad else None


def notes_of(results: Sequence[CaseResult]) -> list[str]:
    """Notes with the numbers of their cases, equal notes of several cases once."""
    found: dict[str, list[int]] = {}
    for result in results:
        for note in result.notes:
            found.setdefault(note, []).append(result.index)
    return [f"{_cases(numbers)}: {note}" for note, numbers in found.items()]


def _cases(numbers: Sequence[int]) -> str:
    """Numbers of cases in words.

    Examples
    --------
    >>> _cases([3]), _cases([0, 1, 2]), _cases([0, 2, 5])
    ('case 3', 'cases 0 to 2', 'cases 0, 2 and 5')
    """
    if len(numbers) == 1:
        return f"case {numbers[0]}"
    if len(numbers) > 2 and numbers[-1] - numbers[0] == len(numbers) - 1:
        return f"cases {numbers[0]} to {numbers[-1]}"
    return f"cases {', '.join(map(str, numbers[:-1]))} and {numbers[-1]}"


def as_data(result: CaseResult) -> dict[str, Any]:
    """Case in the form of `--json`."""
    from pitchpoint.cli.results import how_a_status_ends

    found: dict[str, Any] = {
        "case": result.index,
        "values": result.values,
        "numbers": {path: number for path, (number, _) in result.numbers.items()},
        "status": how_a_status_ends(result.status),
        "status_code": result.status,
        "sentence": result.sentence,
        "steps": result.steps,
        "wall_s": result.wall_s,
        "notes": list(result.notes),
    }
    if result.points or result.jumps:
        return found | {"points": result.points, "jumps": result.jumps}
    return found | {"channels": result.channels}


def _print(title: str, results: Sequence[CaseResult], paths: Sequence[str], heads: Sequence[str]) -> None:
    """Print the mesh forces of each case next to its values; one row per case, for rolls one per mesh.

    `heads` are the headings of the values.
    """
    from pitchpoint.cli import roll
    from pitchpoint.cli.case_bearings import show_bearing_forces
    from pitchpoint.cli.results import how_a_status_ends
    from pitchpoint.core.status import OK

    meshes = list(dict.fromkeys(m for r in results for m in meshes_of(r))) or [""]
    rolled = any(is_roll(r) for r in results)
    words = roll.WORDS if rolled else (*WORDS, *causes_of(results))
    columns = list(heads)
    several = len(meshes) > 1
    if rolled:
        columns += ["mesh"] * several + list(words)
    else:
        columns += [f"{word} {mesh}".rstrip() for mesh in (meshes if several else [""]) for word in words]
    stages = list(dict.fromkeys(s for r in results for s in stages_of(r)))
    columns += [f"K_γ {stage}" for stage in stages]
    rows = []
    for result in results[:MAX_ROWS]:
        values = [str(result.values[path]) for path in paths]
        per_mesh = [mesh_cells(result, mesh, words) for mesh in meshes]
        if result.status != OK and all(cell == NOTHING for cells in per_mesh for cell in cells):
            per_mesh[0][0] = f"{how_a_status_ends(result.status)} ({result.status})"
        if rolled:
            named = [[mesh] * several for mesh in meshes]
            factors = [factor_cells(result, stages), *([[""] * len(stages)] * (len(meshes) - 1))]
            rows += [
                [*values, *name, *cells, *ends]
                for name, cells, ends in zip(named, per_mesh, factors, strict=True)
            ]
        else:
            cells = [cell for cells in per_mesh for cell in cells]
            rows.append([*values, *cells, *factor_cells(result, stages)])
    notes = [f"{len(results) - MAX_ROWS} more cases are in the file"] if len(results) > MAX_ROWS else []
    table(title, columns, rows, notes, keys=len(paths) + (rolled and several))
    listed = [([str(r.values[path]) for path in paths], r.channels) for r in results[:MAX_ROWS]]
    show_bearing_forces(title, listed, columns[: len(paths)])
    for result in results:
        if result.status != OK:
            show(
                f"case {result.index} ({', '.join(f'{p} = {v}' for p, v in result.values.items())}): "
                f"{result.sentence}"
            )


WORDS = ("rms of deflection", "maximum force", "contact loss", "impacts", "closing speed")
CAUSES = {"rattle index": ("rattle_index", 0.1), "load reversal": ("load_reversal", 0.05)}
"""Further columns, and the number up to which they are omitted: the load of the meshes hardly varies."""

CONTACT = ("contact_loss_share", "impact_rate", "closing_speed_max")


def is_roll(result: CaseResult) -> bool:
    """Whether a case is a slow roll with at least one point."""
    return any(name.startswith("unloaded_transmission_error[") for name in result.channels)


def causes_of(results: Sequence[CaseResult]) -> list[str]:
    """Columns of `CAUSES` that are shown."""
    rows = [row for result in results for row in result.channels.values()]
    return [word for word, (name, least) in CAUSES.items() if any(row.get(name, 0.0) > least for row in rows)]


def stages_of(result: CaseResult) -> list[str]:
    """Names of the planetary stages with a mesh load factor in a case."""
    names = result.points[0] if result.points else result.channels
    return [stage_of(name) for name in names if is_factor(name)]


def factor_cells(result: CaseResult, stages: Sequence[str]) -> list[str]:
    """Mesh load factor of every stage; the largest one of a sweep."""
    return [
        largest([p[name] for p in result.points] or [result.channels.get(name, {}).get("mean")])
        for name in map(factor_name, stages)
    ]


def meshes_of(result: CaseResult) -> list[str]:
    """Names of the meshes of a case, of a sweep the swept mesh first."""
    if result.points:
        return swept_meshes(result.points)
    return [n[len("deflection[") : -1] for n in result.channels if n.startswith("deflection[")]


def mesh_cells(result: CaseResult, mesh: str, words: Sequence[str]) -> list[str]:
    """Table cells of one mesh: those of a slow roll, or of `WORDS` and `CAUSES`, of a sweep the largest.

    There is a cell for each of `words`, also for a case without numbers.
    """
    if is_roll(result):
        from pitchpoint.cli import roll

        return roll.mesh_cells(result.channels, mesh)
    if result.points:
        points = points_of_mesh(result.points, mesh)
        rms = max(p["deflection"]["rms"] for p in points)
        force = max((greatest(p["mesh_force"]) for p in points), key=abs)
        contact = [max(p[name] for p in points) for name in CONTACT]
    elif f"deflection[{mesh}]" in result.channels:
        rms = result.channels[f"deflection[{mesh}]"]["rms"]
        force = greatest(result.channels[f"mesh_force[{mesh}]"])
        contact = [result.channels[f"contact_state[{mesh}]"][name] for name in CONTACT]
    else:
        return [NOTHING] * len(words)
    cells = [shown(rms, "length", 4), shown(force, "force", 5), *contact_cells(*contact)]
    for word in words[len(WORDS) :]:
        number = result.channels.get(f"contact_state[{mesh}]", {}).get(CAUSES[word][0], math.nan)
        cells.append(f"{number:.3f}" if math.isfinite(number) else NOTHING)
    return cells


def contact_cells(loss: float, rate: float, closing: float) -> list[str]:
    """Cells of the share of contact loss, the impacts per time [1/s] and the closing speed [m/s].

    Examples
    --------
    >>> contact_cells(0.123, 25.0, 0.0085), contact_cells(0.0, 0.0, 0.0)
    (['12.3 %', '25 1/s', '8.5 mm/s'], ['0 %', '0 1/s', '0 mm/s'])
    """
    if not math.isfinite(loss):  # a case that failed before its window has no samples
        return [NOTHING] * 3
    return [f"{100.0 * loss:.3g} %", f"{rate:.4g} 1/s", f"{1e3 * closing:.4g} mm/s"]


def shortest(path: str, paths: Sequence[str], ends_in_name: bool = False) -> str:
    """Shortest unambiguous end of a path, with its key if it ends in a name of the model.

    Examples
    --------
    >>> shortest("loads.input.torque", ["loads.input.torque", "loads.output.torque"])
    'input.torque'
    >>> shortest("scenarios.run.speed.i", ["scenarios.run.speed.i"], True)
    'speed.i'
    """
    steps = path.split(".")
    for count in range(1 + ends_in_name, len(steps)):
        end = ".".join(steps[-count:])
        if sum(p == end or p.endswith(f".{end}") for p in paths) == 1:
            return end
    return path
