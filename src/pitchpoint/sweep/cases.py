# SPDX-License-Identifier: Apache-2.0
"""Parameter studies: one scenario for many variants of a model, on all cores.

Each case is a separate model, compiled and run in one thread. The compiled loops release the GIL, so that
threads run in parallel. Results are bit-identical for any number of threads. A failed case has a status and
a message and does not stop the others.
"""

from __future__ import annotations

import itertools
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.analysis.mesh_sweep import swept_meshes
from pitchpoint.core.errors import (
    CompileError,
    ModelError,
    PitchpointError,
    SolverError,
    join_notes,
    with_time,
)
from pitchpoint.core.load_sharing import is_factor
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import DIED, INCONSISTENT, INTERRUPTED, OK, REFUSED, sentence
from pitchpoint.io.contact_numbers import RATTLE
from pitchpoint.io.sweep_store import CONTACTS, QUANTITIES, STATISTICS, SWEPT
from pitchpoint.model.numbers import number_at
from pitchpoint.model.study_plan import MODES, RUN
from pitchpoint.sweep.threads import on_all_cores

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario


@dataclass(frozen=True)
class CaseResult:
    """Result of one case.

    Parameters
    ----------
    index
        Index in the list of cases.
    values
        Changed values by path, as given.
    status, sentence
        Final status (`pitchpoint.core.status`) and its message.
    numbers
        Numerical values by path in SI units, with their unit.
    steps, wall_s
        Number of time steps (points of a slow roll), wall time [s].
    channels
        Statistics by channel (unit, mean, rms of the alternating part, min, max); empty for a speed sweep.
    points, jumps
        Points and jumps of a speed sweep, as printed by `sweep --json`.
    notes
        Notes on the result.
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
    """Full factorial of the values; the last path varies fastest.

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
    """Run one scenario for many variants of a model.

    Parameters
    ----------
    model
        Base model.
    cases
        New values by path for each case, see `Model.replace_all`.
    scenario
        Name of the scenario: time response, slow roll or speed sweep.
    jobs
        Number of threads; default one per core.
    progress
        Called after each case with the number of finished cases.
    sink
        Called with each finished case immediately, in order of completion, in the calling thread.

    Returns
    -------
    list of CaseResult
        One per case, in the order of `cases`. After Ctrl-C unfinished cases have the status INTERRUPTED.

    Raises
    ------
    SolverError
        If the scenario does not exist.
    """
    if scenario not in model.scenarios:
        raise SolverError(
            f"no scenario {scenario!r}; there are: {', '.join(model.scenarios) or 'none'}", INCONSISTENT
        )
    todo = list(enumerate(cases))
    done: dict[int, CaseResult] = {}

    def take(result: CaseResult) -> None:
        """Store a case and report the progress."""
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
    scenario: str | None,
    index: int = 0,
    stop: threading.Event | None = None,
    evaluate: str = RUN,
) -> CaseResult:
    """Run one case; errors are returned as its status and message.

    Parameters
    ----------
    model, values, scenario
        As in `run_cases`, for one case; no scenario: at rest, for equilibrium and modes.
    index
        Index in the list of cases.
    stop
        Event that another thread sets to stop the case.
    evaluate
        What is computed, as in the plan of a study; the channels of an equilibrium and the numbers of modes
        have no variation.
    """
    begun = time.perf_counter()
    numbers: dict[str, tuple[float, str]] = {}

    def failed(status: int, words: str) -> CaseResult:
        """Result of a failed case."""
        wall_s = time.perf_counter() - begun
        return CaseResult(index, dict(values), status, words, numbers, wall_s=wall_s)

    def listen(done: float, total: float, note: str = "") -> None:
        """Stop the case if the study is stopped."""
        if stop is not None and stop.is_set():
            raise KeyboardInterrupt

    try:
        changed = model.replace_all(values) if values else model
        numbers |= {path: n for path in values if (n := number_at(changed, path)) is not None}
        chosen = changed.scenarios[scenario] if scenario is not None else None
        if evaluate == RUN and chosen is not None:
            result = _run(changed, chosen, values, index, listen)
        else:
            result = _at_rest(changed, chosen, values, index, evaluate, listen)
        return replace(result, numbers=numbers)
    except (Exception, KeyboardInterrupt) as error:  # noqa: BLE001 - one bad case must not take the others with it
        return failed(*how_it_failed(error))


def how_it_failed(error: BaseException) -> tuple[int, str]:
    """Status and message for the exception that ended a case."""
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


def _at_rest(
    model: Model,
    scenario: Scenario | None,
    values: Mapping[str, Any],
    index: int,
    evaluate: str,
    listen: Progress,
) -> CaseResult:
    """Compile one case and find its equilibrium or modes."""
    from pitchpoint.sweep.states import at_equilibrium, mode_numbers
    from pitchpoint.system.compile import compile_model

    begun = time.perf_counter()
    system = compile_model(model, scenario)
    if evaluate == MODES:
        channels, notes = mode_numbers(system, scenario, listen)
    else:
        channels, notes = at_equilibrium(system, scenario)
    wall_s = time.perf_counter() - begun
    return CaseResult(
        index, dict(values), OK, sentence(OK), wall_s=wall_s, channels=channels, notes=tuple(notes)
    )


def _run(
    model: Model, scenario: Scenario, values: Mapping[str, Any], index: int, listen: Progress
) -> CaseResult:
    """Compile and run one case."""
    from pitchpoint.system.compile import compile_model
    from pitchpoint.system.planet_loads import with_factors

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
        found = {"channels": with_factors(model, channels), "steps": len(roll.position)}
        status, words, notes = roll.status, roll.sentence, (*roll.notes, *roll.cycle_notes)
    else:
        from pitchpoint.solvers.time import run_time

        done = run_time(system, scenario, progress=listen)
        found = {"channels": with_factors(model, done.channels), "steps": done.steps}
        status, notes = done.status, done.notes
        words = done.sentence if status == OK else with_time(done.sentence, done.t_end)
    wall_s = time.perf_counter() - begun
    return CaseResult(index, dict(values), status, words, wall_s=wall_s, notes=notes, **found)


def paths_of(results: Sequence[CaseResult]) -> list[str]:
    """All changed paths, in order of first appearance."""
    return list(dict.fromkeys(path for result in results for path in result.values))


def cases_dataset(results: Sequence[CaseResult]) -> xr.Dataset:
    """Results of cases as a dataset.

    Parameters
    ----------
    results
        Results of `run_cases`.

    Returns
    -------
    xarray.Dataset
        All channels over `case` and `statistic` (mean, rms, min, max); the contact numbers of each mesh, such
        as `impact_rate[stage]`, status and changed values (by path) over `case`. For speed sweeps over
        `case`, `direction`, `point` and `statistic`, with speed, mesh_frequency and the contact numbers of
        every point, those of the swept mesh without name, and of every mesh, as
        `contact_loss_share[stage]`. Missing values are NaN. The attributes contain message and notes of every
        case.
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
        values = np.array(table, float)
        # the factor of mean forces is one number
        over, shown = (("case",), values[:, 0]) if is_factor(name) else (("case", "statistic"), values)
        data[name] = (over, shown, {**words, "symbol": symbol(name)})
    for key, numbers, unit, meaning in contact_tables(results):
        data[key] = ("case", numbers, {"units": unit, "long_name": meaning})
    coords: dict[str, Any] = {"case": np.arange(len(results)), "statistic": list(STATISTICS)}
    if any(r.points for r in results):
        directions, tables = sweep_tables(results)
        coords["direction"] = directions
        for name, (values, unit) in tables.items():
            dims = ("case", "direction", "point", "statistic")[: np.ndim(values)]
            long_name = name.partition("[")[0].replace("_", " ")
            data[name] = (dims, values, {"units": unit, "long_name": long_name})
    data["status"] = ("case", [r.status for r in results], {"long_name": "status of the case; 1: no error"})
    for path in paths_of(results):
        entries, unit = column(results, path)
        coords[path] = ("case", entries, {"units": unit} if unit else {})
    attrs: dict[str, Any] = {
        "sentences": [r.sentence for r in results],
        "notes": [join_notes(r.notes) for r in results],
    }
    swept = next((swept_meshes(r.points)[0] for r in results if r.points), "")
    if swept:
        attrs[SWEPT] = swept
    return xr.Dataset(data, coords=coords, attrs=attrs)


def contact_tables(results: Sequence[CaseResult]) -> list[tuple[str, list[float], str, str]]:
    """Contact numbers of each mesh over the cases of time responses: name, values, unit, description."""
    states = {n: None for r in results for n, row in r.channels.items() if RATTLE[0][0] in row}
    return [
        (
            f"{name}{state.removeprefix('contact_state')}",
            [float(r.channels.get(state, {}).get(name, np.nan)) for r in results],
            unit,
            words,
        )
        for state in states
        for name, unit, words in RATTLE
    ]


def sweep_tables(results: Sequence[CaseResult]) -> tuple[list[str], dict[str, tuple[np.ndarray, str]]]:
    """Sweep points of all cases as tables: directions, and (values, unit) by name, also of every mesh.

    `QUANTITIES` have the shape (case, direction, point, statistic), all others (case, direction, point).
    """
    directions = list(dict.fromkeys(p["direction"] for r in results for p in r.points))
    most = max(
        (sum(p["direction"] == d for p in r.points) for r in results for d in directions),
        default=0,
    )
    shape = (len(results), len(directions), most)
    meshes = list(dict.fromkeys(m for r in results for m in swept_meshes(r.points)))
    owners = ("", *(f"[{mesh}]" for mesh in meshes if mesh))
    tables = {f"{n}{of}": (np.full((*shape, 4), np.nan), unit) for of in owners for n, unit, _ in QUANTITIES}
    scalars = {"speed": "rad/s", "mesh_frequency": "Hz"}
    scalars |= {f"{name}{of}": unit for of in owners for name, unit, _ in CONTACTS}
    scalars |= {name: "1" for r in results for p in r.points for name in p if is_factor(name)}
    tables |= {name: (np.full(shape, np.nan), unit) for name, unit in scalars.items()}
    for c, result in enumerate(results):
        for d, direction in enumerate(directions):
            here = sorted(
                (p for p in result.points if p["direction"] == direction), key=lambda p: p["mesh_frequency"]
            )
            for k, point in enumerate(here):
                by_mesh = {
                    f"{name}[{mesh}]": value
                    for mesh, own in point.get("meshes", {}).items()
                    for name, value in own.items()
                }
                for name, value in {**point, **by_mesh}.items():
                    if name in scalars:
                        tables[name][0][c, d, k] = value
                    elif name in tables:
                        tables[name][0][c, d, k] = [value[s] for s in STATISTICS]
    return directions, tables


def column(results: Sequence[CaseResult], path: str) -> tuple[list[Any], str]:
    """Values of one path over the cases and their unit: SI numbers if all are numeric, otherwise text."""
    known = [r.numbers.get(path) for r in results]
    if any(known) and all(n is not None or r.status != OK for n, r in zip(known, results, strict=True)):
        return [np.nan if n is None else n[0] for n in known], next(n[1] for n in known if n is not None)
    return [str(r.values.get(path, "")) for r in results], ""
