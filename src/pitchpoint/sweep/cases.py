# SPDX-License-Identifier: Apache-2.0
"""Independent cases: one scenario of many variants of a model, on all cores.

Every case is a model of its own, compiled and run by one thread; the compiled loops release the interpreter,
so threads share the cores. A case computes the same bits whatever runs next to it. A case that fails has a
status and a sentence; it never stops the others.
"""

from __future__ import annotations

import itertools
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import CompileError, ModelError, PitchpointError, SolverError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import DIED, INCONSISTENT, INTERRUPTED, OK, REFUSED, sentence
from pitchpoint.io.sweep_store import QUANTITIES, SHARES, STATISTICS
from pitchpoint.model.numbers import number_at
from pitchpoint.sweep.threads import on_all_cores

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario


@dataclass(frozen=True)
class CaseResult:
    """What one case gave.

    Parameters
    ----------
    index
        Place in the list of cases.
    values
        What was changed, by path, as it was given.
    status, sentence
        How it ended, as a number of `pitchpoint.core.status` and in words.
    numbers
        The same values in SI units with their unit, for those that are numbers.
    steps, wall_s
        Time steps (points of a roll), wall time [s].
    channels
        Statistics by channel (unit, mean, rms of the alternating part, min, max); empty for a sweep.
    points, jumps
        Of a speed sweep, as `sweep --json` prints them.
    notes
        What the user should know.
    """

    index: int
    values: Mapping[str, Any]
    status: int
    sentence: str
    numbers: Mapping[str, tuple[float, str]] = field(default_factory=dict)
    steps: int = 0
    wall_s: float = 0.0
    channels: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    points: Sequence[Mapping[str, Any]] = ()
    jumps: Sequence[Mapping[str, Any]] = ()
    notes: tuple[str, ...] = ()


def grid(paths: Mapping[str, Sequence[Any]]) -> list[dict[str, Any]]:
    """All combinations of values, the last path varying fastest.

    Parameters
    ----------
    paths
        Values by path.

    Examples
    --------
    >>> grid({"a": [1, 2], "b": [3]})
    [{'a': 1, 'b': 3}, {'a': 2, 'b': 3}]
    """
    return [dict(zip(paths, chosen, strict=True)) for chosen in itertools.product(*paths.values())]


def run_cases(
    model: Model,
    cases: Sequence[Mapping[str, Any]],
    scenario: str,
    *,
    jobs: int | None = None,
    progress: Progress = silent,
    sink: Callable[[CaseResult], None] | None = None,
) -> list[CaseResult]:
    """Run one scenario of many variants of a model.

    Parameters
    ----------
    model
        The model that is varied.
    cases
        New values by path for each case, see `Model.replace_all`.
    scenario
        Name of the scenario: a time response, a slow roll or a speed sweep.
    jobs
        Threads; default one per core.
    progress
        Called with the number of finished cases after each.
    sink
        Takes every finished case at once, in the order in which they finish, in the calling thread.

    Returns
    -------
    list of CaseResult
        One per case, in the order of the cases. After Ctrl-C those that were not finished are INTERRUPTED.
    """
    if scenario not in model.scenarios:
        raise SolverError(
            f"no scenario {scenario!r}; there are: {', '.join(model.scenarios) or 'none'}", INCONSISTENT
        )
    todo = list(enumerate(cases))
    done: dict[int, CaseResult] = {}

    def take(result: CaseResult) -> None:
        """Keep a case and state how far the study is."""
        done[result.index] = result
        if sink is not None:
            sink(result)
        ended = {OK: "", INTERRUPTED: f"case {result.index}: interrupted"}
        progress(len(done), len(todo), ended.get(result.status, f"case {result.index}: failed"))

    def work(case: tuple[int, Mapping[str, Any]], stop: threading.Event) -> CaseResult:
        """Compute one case."""
        return run_case(model, case[1], scenario, case[0], stop)

    on_all_cores(work, todo, take, jobs)
    left = sentence(INTERRUPTED)
    return [done.get(k, CaseResult(k, dict(values), INTERRUPTED, left)) for k, values in todo]


def run_case(
    model: Model,
    values: Mapping[str, Any],
    scenario: str,
    index: int = 0,
    stop: threading.Event | None = None,
) -> CaseResult:
    """Run one case; whatever goes wrong becomes its status.

    Parameters
    ----------
    model, values, scenario
        As in `run_cases`, for one case.
    index
        Its place in the list.
    stop
        Set by another thread that wants the case to end.
    """
    begun = time.perf_counter()
    numbers: dict[str, tuple[float, str]] = {}

    def failed(status: int, words: str) -> CaseResult:
        """Result of a case that has no numbers, or not all."""
        wall_s = time.perf_counter() - begun
        return CaseResult(index, dict(values), status, words, numbers, wall_s=wall_s)

    def listen(done: float, total: float, note: str = "") -> None:
        """End a case when the study is stopped."""
        if stop is not None and stop.is_set():
            raise KeyboardInterrupt

    try:
        changed = model.replace_all(values) if values else model
        numbers |= {path: n for path in values if (n := number_at(changed, path)) is not None}
        result = _run(changed, changed.scenarios[scenario], values, index, listen)
        return replace(result, numbers=numbers)
    except (Exception, KeyboardInterrupt) as error:  # noqa: BLE001 - one bad case must not take the others with it
        return failed(*how_it_failed(error))


def how_it_failed(error: BaseException) -> tuple[int, str]:
    """Status and sentence of what ended a case."""
    if isinstance(error, SolverError):
        return error.status, str(error)
    if isinstance(error, CompileError):
        return INCONSISTENT, str(error)
    if isinstance(error, ModelError):
        return REFUSED, "; ".join(map(str, error.problems))
    if isinstance(error, PitchpointError):
        return REFUSED, str(error)
    if isinstance(error, KeyboardInterrupt):
        return INTERRUPTED, sentence(INTERRUPTED)
    return DIED, f"{type(error).__name__}: {error}"


def _run(
    model: Model, scenario: Scenario, values: Mapping[str, Any], index: int, listen: Progress
) -> CaseResult:
    """Compile and compute one case."""
    from pitchpoint.system.compile import compile_model

    begun = time.perf_counter()
    system = compile_model(model, scenario)
    found: dict[str, Any]
    if scenario.kind == "sweep":
        from pitchpoint.sweep.speed import run_sweep

        swept = run_sweep(system, scenario, progress=listen)
        points = [{k: v for k, v in p.items() if k != "channels"} for p in swept.points]
        found = {"points": points, "jumps": swept.jumps, "steps": swept.steps}
        status, words, notes = swept.status, swept.sentence, swept.notes
    elif scenario.kind == "quasi_static":
        from pitchpoint.solvers.quasistatic.roll import roll_through, statistics, tables

        roll = roll_through(system, scenario, progress=listen)
        channels = {t.name: statistics(t) for t in tables(system, roll) if np.size(t.values) and t.rolled}
        found = {"channels": channels, "steps": len(roll.position)}
        status, words, notes = roll.status, roll.sentence, (*roll.notes, *roll.cycle_notes)
    else:
        from pitchpoint.solvers.time import run_time

        done = run_time(system, scenario, progress=listen)
        found = {"channels": done.channels, "steps": done.steps}
        status, words, notes = done.status, done.sentence, done.notes
        if status != OK:
            words = f"{words} (at t = {done.t_end:.6g} s)"
    wall_s = time.perf_counter() - begun
    return CaseResult(index, dict(values), status, words, wall_s=wall_s, notes=notes, **found)


def paths_of(results: Sequence[CaseResult]) -> list[str]:
    """Every path that some case changes, in the order of appearance."""
    return list(dict.fromkeys(path for result in results for path in result.values))


def cases_dataset(results: Sequence[CaseResult]) -> xr.Dataset:
    """Cases as a dataset.

    Parameters
    ----------
    results
        What `run_cases` returned.

    Returns
    -------
    xarray.Dataset
        Over `case` and `statistic` (mean, rms, min, max): every channel; over `case`: status and the values
        that were changed, by path. For speed sweeps over `case`, `direction`, `point` and `statistic`, with
        speed and mesh_frequency of every point and the shares of lost and of back contact. NaN where there is
        nothing. The attributes hold a sentence and the notes of every case.
    """
    import xarray as xr

    from pitchpoint.core.nomenclature import symbol

    data: dict[str, Any] = {}
    first: dict[str, str] = {}
    for result in results:
        for name, row in result.channels.items():
            first.setdefault(name, str(row["unit"]))
    for name, unit in first.items():
        table = [[r.channels[name][s] if name in r.channels else np.nan for s in STATISTICS] for r in results]
        words = {"units": unit, "long_name": name.partition("[")[0].replace("_", " ")}
        data[name] = (("case", "statistic"), np.array(table, float), {**words, "symbol": symbol(name)})
    coords: dict[str, Any] = {"case": np.arange(len(results)), "statistic": list(STATISTICS)}
    if any(r.points for r in results):
        directions, tables = sweep_tables(results)
        coords["direction"] = directions
        for name, (values, unit) in tables.items():
            dims = ("case", "direction", "point", "statistic")[: np.ndim(values)]
            data[name] = (dims, values, {"units": unit, "long_name": name.replace("_", " ")})
    data["status"] = ("case", [r.status for r in results], {"long_name": "how the case ended; 1 is fine"})
    for path in paths_of(results):
        entries, unit = column(results, path)
        coords[path] = ("case", entries, {"units": unit} if unit else {})
    attrs = {
        "sentences": [r.sentence for r in results],
        "notes": ["; ".join(r.notes) for r in results],
    }
    return xr.Dataset(data, coords=coords, attrs=attrs)


def sweep_tables(results: Sequence[CaseResult]) -> tuple[list[str], dict[str, tuple[np.ndarray, str]]]:
    """Points of the sweeps of all cases as tables: directions, and (values, unit) by name.

    Quantities have the shape (case, direction, point, statistic), all others (case, direction, point).
    """
    directions = list(dict.fromkeys(p["direction"] for r in results for p in r.points))
    most = max(
        (sum(p["direction"] == d for p in r.points) for r in results for d in directions),
        default=0,
    )
    shape = (len(results), len(directions), most)
    tables = {name: (np.full((*shape, 4), np.nan), unit) for name, unit, _ in QUANTITIES}
    scalars = {"speed": "rad/s", "mesh_frequency": "Hz", **{name: "1" for name, _ in SHARES}}
    tables |= {name: (np.full(shape, np.nan), unit) for name, unit in scalars.items()}
    for c, result in enumerate(results):
        for d, direction in enumerate(directions):
            here = sorted(
                (p for p in result.points if p["direction"] == direction), key=lambda p: p["mesh_frequency"]
            )
            for k, point in enumerate(here):
                for name, _, _ in QUANTITIES:
                    tables[name][0][c, d, k] = [point[name][s] for s in STATISTICS]
                for name in scalars:
                    tables[name][0][c, d, k] = point[name]
    return directions, tables


def column(results: Sequence[CaseResult], path: str) -> tuple[list[Any], str]:
    """Values of one path over the cases and their unit: SI numbers if they are numbers, else texts."""
    known = [r.numbers.get(path) for r in results]
    if any(known) and all(n is not None or r.status != OK for n, r in zip(known, results, strict=True)):
        return [np.nan if n is None else n[0] for n in known], next(n[1] for n in known if n is not None)
    return [str(r.values.get(path, "")) for r in results], ""
