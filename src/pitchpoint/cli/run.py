# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint run`: time response of a scenario, streamed to a result file, or a slow roll."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, model_file, output, quantity, scenario
from pitchpoint.cli.output import emit_json, show, show_notes, shown
from pitchpoint.cli.settings import set_option
from pitchpoint.cli.vary import base_model, vary_option

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.solvers.initial_state.start import Start
    from pitchpoint.system.system import System


ALIKE = 0.999
"""Share of the requested step above which a shorter step is not reported."""
NOT_BEGUN: dict[str, Any] = {
    "steps": 0,
    "step": None,
    "t_end": None,
    "window": None,
    "events": 0,
    "channels": {},
    "planet_loads": {},
}
"""Parts of the summary that are empty if a run fails before its first step."""


@click.command()
@model_file
@scenario
@output("Result file (netCDF-4/HDF5); default: MODEL-SCENARIO.h5 in the current folder.")
@quantity("--step", "time", "Time step instead of that of the scenario, as in '5 us'.")
@click.option(
    "--decimate", type=click.IntRange(min=1), metavar="N", help="Store only every N-th sample; default: 1."
)
@quantity(
    "--reduce",
    "frequency",
    "Condense the linear parts for frequencies up to this value, see the command reduce.",
)
@click.option(
    "--channels",
    multiple=True,
    metavar="PATTERN",
    help="Store only these channels, such as 'mesh_force[*]'; may be repeated. Default: all.",
)
@click.option(
    "--communication-error",
    "estimates",
    is_flag=True,
    help="Also run with half of the communication steps of FMUs, and print the error of the given ones.",
)
@click.option("--all", "everything", is_flag=True, help="Print the statistics of all channels.")
@set_option
@vary_option
@common
def run(
    file: str,
    scenario: str | None,
    output: str | None,
    vary: tuple[str, ...],
    jobs: int | None,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
    **how: Any,
) -> int:
    """Compute the time response or slow roll of a scenario of FILE.

    The result file can be read during the run. Ctrl-C stops the run; partial results are kept.
    """
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.planet_loads import show_planets
    from pitchpoint.cli.results import (
        choose_scenario,
        rattle_table,
        refuse_without_effect,
        result_path,
        statistics_table,
        unless_it_cannot_begin,
    )
    from pitchpoint.report.main_channels import main_channels
    from pitchpoint.system.no_load import without_rounding
    from pitchpoint.viz.quantities import window_words

    model = base_model(file, allow_code, quiet, vary)
    step, decimate, reduce = how["step"], how["decimate"], how["reduce"]
    stored = {"--channels": how["channels"] or None}
    name = choose_scenario(model, scenario, "time", "quasi_static")
    rolls = model.scenarios[name].kind == "quasi_static"
    refuse_without_effect(
        "on a slow roll",
        {"--step": step, "--decimate": decimate, "--reduce": reduce, **stored} if rolls else {},
    )
    refuse_without_effect(
        "with --vary, whose table has statistics only", {"--decimate": decimate, **stored} if vary else {}
    )
    refuse_without_effect("with --vary", {"--reduce": reduce} if vary else {})
    refuse_without_effect("without --vary", {} if vary else {"--jobs": jobs})
    estimates = {"--communication-error": how["estimates"] or None}
    refuse_without_effect("on a slow roll", estimates if rolls else {})
    refuse_without_effect(
        "with --vary, --decimate or --reduce", estimates if vary or decimate or reduce else {}
    )
    if how["estimates"]:
        from pitchpoint.solvers.communication_error import with_samples

        model = with_samples(model, name)
    if step is not None:
        model = model.replace(f"scenarios.{name}.step", step)
    if how["channels"]:
        model = model.replace(f"scenarios.{name}.channels", list(how["channels"]))
    if vary:
        from pitchpoint.cli.cases import run_varied

        goal = result_path(output, file, f"{name}-cases")
        return run_varied(model, file, name, goal, vary, jobs=jobs, as_json=as_json, quiet=quiet)
    if rolls:
        return _roll(model, file, name, output, as_json=as_json, quiet=quiet)
    target = result_path(output, file, name)
    summary, error = unless_it_cannot_begin(
        lambda: compute(model, file, name, target, decimate=decimate or 1, reduce=reduce, quiet=quiet),
        NOT_BEGUN,
        target,
    )
    inner = summary.pop("inner", ())
    errors: dict[str, tuple[float, str]] = {}
    if how["estimates"] and error is None:
        from pitchpoint.cli.communication_error import communication_error, show_error

        errors = communication_error(model, name, target, quiet=quiet)
        summary["communication_error"] = {channel: value for channel, (value, _) in errors.items()}
    if as_json:
        emit_json(summary)
    elif not quiet and (summary["steps"] or error is None):
        rows = {channel: row for channel, row in summary["channels"].items() if channel not in inner}
        title = f"{model.title or file}: {name}"
        if not rows or any(math.isfinite(row["mean"]) for row in rows.values()):
            chosen = None if how["everything"] else main_channels(model, rows, name)
            window = f", {window_words(*summary['window'])}" if summary["window"] else ""
            statistics_table(f"{title}{window}", without_rounding(model, rows), chosen)
            rattle_table(rows)
        else:
            show(f"{title}: {no_statistics(model.scenarios[name], summary['t_end'])}")
        size = f" of {shown(summary['step'], 'time', 4)}" if summary["step"] else ""
        show_planets(summary["planet_loads"])
        if errors:
            show_error(title, errors)
        show(f"{summary['steps']} steps{size} in {summary['wall_s']:.3g} s, written to {target}")
        show_notes(summary["notes"])
    return OK if error is None else exit_code_of(error)


def _roll(model: Model, file: str, name: str, output: str | None, *, as_json: bool, quiet: bool) -> int:
    """Compute the slow roll of a scenario."""
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.planet_loads import show_planets
    from pitchpoint.cli.results import result_path, unless_it_cannot_begin
    from pitchpoint.cli.roll import NOT_BEGUN, compute, show_forces, show_roll

    target = result_path(output, file, name)
    summary, error = unless_it_cannot_begin(
        lambda: compute(model, file, name, target, quiet=quiet), NOT_BEGUN, target
    )
    if as_json:
        emit_json(summary)
    elif summary["steps"] and not quiet:
        show_roll(f"{model.title or file}: {name}", summary)
        show_forces(model, summary["channels"], name)
        show_planets(summary["planet_loads"])
        show(f"{summary['steps']} points in {summary['wall_s']:.3g} s, written to {target}")
        show_notes(summary["notes"])
    return OK if error is None else exit_code_of(error)


def compute(
    model: Model,
    file: str,
    name: str,
    target: Path,
    *,
    decimate: int = 1,
    reduce: float | None = None,
    quiet: bool = False,
) -> tuple[dict[str, Any], BaseException | None]:
    """Run a scenario into a file; return the summary for `run --json`, and the error that stopped it.

    For a reduced system the summary also contains `inner`: channels of condensed parts and their modes.
    """
    from pitchpoint.cli.planet_loads import with_stored_positions
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import header_of, how_a_status_ends
    from pitchpoint.core.errors import SolverError, with_time
    from pitchpoint.core.kernel import expect
    from pitchpoint.core.status import INTERRUPTED, OK
    from pitchpoint.io.writing import Channel, ResultWriter
    from pitchpoint.report.bearing_loads import loads_above_ratings
    from pitchpoint.solvers.fixed_steps import loop_of
    from pitchpoint.solvers.sample_notes import sample_notes
    from pitchpoint.solvers.time import run_time
    from pitchpoint.system.channel_choice import chosen_channels
    from pitchpoint.system.compile import compile_model
    from pitchpoint.system.planet_loads import loads_in

    chosen = model.scenarios[name]
    expect(loop_of(chosen.method))
    system, start = compile_model(model, chosen), None
    inner: dict[str, Any] = {}
    if reduce is not None:
        own = {c.name for c in system.layout.channels}
        start = reduced_start(system, chosen, reduce)
        system = start.system
        inner = {"inner": {c.name for c in system.layout.channels} - own}
    stored = chosen_channels(system, chosen.channels)
    channels = [Channel(c.name, c.unit, c.long_name) for c in (system.layout.channels[k] for k in stored)]
    events = [e.name for e in system.layout.events] if chosen.events else []
    header = header_of(model, file, name, "time", chosen.method)
    with ResultWriter(target, header, channels, decimate=decimate, events=events) as writer:
        with ProgressDisplay(f"run {name}", "s", quiet=quiet) as progress:
            done = run_time(system, chosen, sink=writer, progress=progress, start=start, channels=stored)
        if events:
            writer.append_events(done.events)
        rate = chosen.sample_rate or (1.0 / done.step if done.step and decimate > 1 else None)
        coarse = sample_notes(system, chosen, done, None if rate is None else rate / decimate)
        high = loads_above_ratings(model, done.channels)
        notes = (*done.notes, *coarse, *step_notes(chosen, done.step), *high)
        statistics = {c.name: done.channels[c.name] for c in channels}
        status = how_a_status_ends(done.status)
        writer.finish(
            status,
            done.sentence,
            code=done.status,
            steps=done.steps,
            wall_s=done.wall_s,
            notes=notes,
            statistics=statistics,
        )
    sentence = with_time(done.sentence, done.t_end) if done.status != OK else done.sentence
    summary = {
        "status": status,
        "sentence": sentence,
        "steps": done.steps,
        "wall_s": done.wall_s,
        "step": done.step,
        "t_end": done.t_end,
        "window": done.window,
        "output": str(target),
        "notes": notes,
        "events": len(done.events),
        "channels": statistics,
        "planet_loads": with_stored_positions(
            model, loads_in(model, statistics), target, chosen.statistics_start
        ),
        **({"contact_solver": done.contact_solver} if done.contact_solver else {}),
        **inner,
    }
    if done.status == INTERRUPTED and not done.steps:
        text = f"before the first sample: nothing has been computed; {target} has no samples"
        return summary, SolverError(text, INTERRUPTED)
    return summary, None if done.status == OK else SolverError(sentence, done.status, str(target))


def reduced_start(system: System, scenario: Scenario, limit: float) -> Start:
    """Start of a scenario with the linear parts condensed for frequencies up to a limit [Hz]."""
    from pitchpoint.solvers.initial_state.start import Start
    from pitchpoint.solvers.reduction.reduce import lost_channels, reduce_system

    found = reduce_system(system, scenario, limit=limit)
    lost = lost_channels(found.full, found.system)
    return Start(found.system, found.state, (found.error.report(), *found.notes, *lost))


def no_statistics(scenario: Scenario, t_end: float) -> str:
    """Reason why a run that ended at `t_end` [s] has no statistics.

    Examples
    --------
    >>> from pitchpoint.model.scenario import Scenario
    >>> no_statistics(Scenario(duration=0.1), 0.003)
    'no statistics: the run ended at 3 ms, before their window, which begins at 20 ms'
    """
    ended, begins = shown(t_end, "time", 4), shown(scenario.statistics_start, "time", 4)
    if t_end > scenario.statistics_start:
        return f"no statistics: the run ended at {ended}, before any sample of their window from {begins} on"
    return f"no statistics: the run ended at {ended}, before their window, which begins at {begins}"


def step_notes(scenario: Scenario, used: float) -> tuple[str, ...]:
    """Note that the requested step was shortened; `used` [s] is 0 for adaptive methods."""
    if scenario.step is None or not 0.0 < used < ALIKE * scenario.step:
        return ()
    asked, taken = shown(scenario.step, "time", 4), shown(used, "time", 4)
    if scenario.sample_rate is None:
        return (f"the step is {taken} instead of {asked}: steps divide the duration",)
    period = shown(1.0 / scenario.sample_rate, "time", 4)
    return (f"the step is {taken} instead of {asked}: steps divide the sample period, {period}",)
