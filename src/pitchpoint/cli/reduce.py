# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint reduce`: condensation of the linear parts of a model, with its error."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, model_file, quantity, state
from pitchpoint.cli.output import emit_json, show, show_notes, shown, table
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.system.system import System

SHOWN = 20
"""Number of natural frequencies in the table."""
ELASTIC = "elastic body "
"""Start of the reason why an elastic body is retained."""
LISTED = 40
"""Number of names listed for an unknown name."""


@click.command()
@model_file
@quantity("--limit", "frequency", "Highest frequency of interest, such as '3 kHz'.")
@click.option(
    "--keep",
    multiple=True,
    metavar="NAME",
    help="Body, or element as 'KIND NAME', to retain; may be repeated.",
)
@state
@set_option
@common
def reduce(
    file: str,
    limit: float | None,
    keep: tuple[str, ...],
    scenario: str | None,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> int:
    """Condense the linear parts of FILE about its loaded equilibrium, and report the error.

    `run --reduce LIMIT` computes a time response with the reduced system.
    """
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.results import known_scenario, unless_it_cannot_begin

    if limit is None:
        raise click.UsageError(
            "--limit is required: the highest frequency of interest, such as --limit '3 kHz'"
        )
    model = read_model(file, allow_code, quiet)
    name = known_scenario(model, scenario) if scenario is not None else None
    nothing: dict[str, Any] = {"coordinates": [], "kept": [], "reasons": [], "full": [], "reduced": []}
    summary, error = unless_it_cannot_begin(lambda: compute(model, name, limit, keep), nothing)
    if as_json:
        emit_json(summary)
    elif error is None:
        _print(
            f"{model.title or file}: reduced for frequencies up to {shown(limit, 'frequency', 4)}", summary
        )
        if not quiet:
            show_notes(summary["notes"])
    return OK if error is None else exit_code_of(error)


def compute(
    model: Model, name: str | None, limit: float, keep: tuple[str, ...]
) -> tuple[dict[str, Any], None]:
    """Reduce the system; return the output of `reduce --json`."""
    from pitchpoint.cli.results import finished
    from pitchpoint.solvers.reduction.reduce import reduce_system
    from pitchpoint.system.compile import compile_model

    begun = time.perf_counter()
    system = compile_model(model, name)
    _check_names(system, keep)
    found = reduce_system(system, name, limit=limit, keep=keep)
    error = found.error
    summary = finished(begun, None, found.notes) | {
        "limit": limit,
        "coordinates": list(error.coordinates),
        "kept": list(found.kept),
        "reasons": list(found.reasons),
        "frequency_error": error.frequency,
        "compliance_error": error.compliance,
        "full": error.full.tolist(),
        "reduced": error.reduced.tolist(),
        "report": error.report(),
    }
    return summary, None


def _check_names(system: System, keep: tuple[str, ...]) -> None:
    """Reject unknown names of components to retain."""
    from pitchpoint.core.nearest import did_you_mean
    from pitchpoint.solvers.reduction.condensable import names_to_keep

    known = names_to_keep(system)
    for name in keep:
        if name not in known:
            more = f" and {len(known) - LISTED} more" if len(known) > LISTED else ""
            raise click.BadParameter(
                f"no body or element {name}; {did_you_mean(name, known)}"
                f"there are: {', '.join(known[:LISTED])}{more}",
                param_hint="--keep",
            )


def _print(title: str, summary: dict[str, Any]) -> None:
    """Print natural frequencies of both systems, retained bodies, and the error."""
    cells = []
    for k, (full, less) in enumerate(zip(summary["full"], summary["reduced"], strict=False), start=1):
        off = f"{100.0 * abs(less / full - 1.0):.2g} %" if full > 0.0 else shown(None)
        cells.append([str(k), shown(full, "frequency", 6), shown(less, "frequency", 6), off])
    table(title, ["mode", "full", "reduced", "difference"], cells[:SHOWN])
    if len(cells) > SHOWN:
        show(f"{SHOWN} of {len(cells)} modes up to the limit; --json prints all of them")
    show(summary["report"])
    show(f"retained bodies: {', '.join(_alone(summary))}")
    for why in dict.fromkeys(summary["reasons"]):
        which = [name for name, own in _alone(summary).items() if own == why]
        show(f"  {', '.join(which)}: {why}")


def _alone(summary: dict[str, Any]) -> dict[str, str]:
    """Reasons by retained body; parts of an elastic body are listed under its name."""
    found: dict[str, str] = {}
    for name, why in zip(summary["kept"], summary["reasons"], strict=True):
        found[why.removeprefix(ELASTIC) if why.startswith(ELASTIC) else name] = why
    return found
