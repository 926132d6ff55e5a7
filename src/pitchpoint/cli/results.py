# SPDX-License-Identifier: Apache-2.0
"""Common functions of computing commands: scenario, provenance, name of the result file, tables."""

from __future__ import annotations

import dataclasses
import math
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.output import shown, table

if TYPE_CHECKING:
    from pitchpoint.io.container import Header
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario

STATISTICS = ("mean", "rms", "min", "max")
ROUND_OFF = 1e-10
"""Alternating part of a constant channel, relative to its largest value."""

FEWEST_STEPS = 5
"""Steps in a contact below which a note is printed."""

Computed = tuple[dict[str, Any], BaseException | None]
"""Output of `--json` for a computation, and the error that stopped it, if any."""

_DIMENSIONS = {
    "m": "length",
    "m/s": "speed",
    "N": "force",
    "rad": "angle",
    "rad/s": "angular_speed",
    "W": "power",
    "N m": "torque",
}


def choose_scenario(model: Model, name: str | None, *kinds: str) -> str:
    """Selected scenario: the named one, or the only one of a suitable type."""
    fitting = [n for n, s in model.scenarios.items() if s.kind in kinds]
    kind = " or ".join(kinds)
    if name is None and len(fitting) == 1:
        return fitting[0]
    listed = ", ".join(fitting) or "none"
    if not fitting and name is None:
        raise click.UsageError(f"the model has no scenario of the kind {kind}; add one under scenarios:")
    if name is None:
        raise click.UsageError(f"choose a --scenario; of the kind {kind} there are: {listed}")
    if known_scenario(model, name) not in fitting:
        is_kind = model.scenarios[name].kind
        raise click.BadParameter(
            f"{name!r} is of the kind {is_kind}, not {kind}; of that kind there are: {listed}",
            param_hint="--scenario",
        )
    return name


def known_scenario(model: Model, name: str) -> str:
    """Check that a scenario of this name exists."""
    if name not in model.scenarios:
        from pitchpoint.core.nearest import hint

        raise click.BadParameter(
            f"no scenario {name!r}; {hint(name, model.scenarios)}", param_hint="--scenario"
        )
    return name


def refuse_without_effect(what: str, options: Mapping[str, Any]) -> None:
    """Reject options without effect on the computation."""
    for name, value in options.items():
        if value is not None:
            raise click.UsageError(f"{name} has no effect {what}; omit it")


def result_path(output: str | None, file: str, scenario: str) -> Path:
    """Name of the result file: as given, or from model file and scenario in the current folder.

    It may replace an older result, but neither the model file nor any other file.
    """
    from pitchpoint.io.target import check_target

    return check_target(output or f"{Path(file).stem}-{scenario}.h5", "result", [file])


def header_of(model: Model, file: str, scenario: str, kind: str, solver: str) -> Header:
    """Provenance of a result; for a modified model it contains the model instead of the text of its file.

    Likewise for a model of several files.
    """
    from pitchpoint.core.provenance import content_hash
    from pitchpoint.io.container import Header
    from pitchpoint.model.write import model_text

    chosen = model.scenarios[scenario] if scenario else None
    is_whole = model.changed or bool(model.origin.files)
    return Header(
        kind=kind,
        title=model.title,
        scenario=scenario,
        solver=solver,
        model_hash=content_hash(model),
        model_text=model_text(model) if is_whole else Path(file).read_text(encoding="utf-8-sig"),
        options=options_of(chosen) if chosen is not None else {},
    )


def options_of(scenario: Scenario) -> dict[str, Any]:
    """Scenario as plain numbers and texts."""
    options: dict[str, Any] = {
        field.name: getattr(scenario, field.name) for field in dataclasses.fields(scenario)
    }
    for name in ("drive", "sweep", "quasi_static"):
        value = options[name]
        known = dataclasses.is_dataclass(value) and not isinstance(value, type)
        options[name] = dataclasses.asdict(value) if known else str(value or "")
    options["settle_time"] = scenario.statistics_start
    return options


def how_a_status_ends(status: int) -> str:
    """Status of a result file for a solver status."""
    from pitchpoint.core import status as st
    from pitchpoint.io.container import FAILED, FINISHED, INTERRUPTED

    return {st.OK: FINISHED, st.INTERRUPTED: INTERRUPTED}.get(status, FAILED)


def finished(begun: float, target: Path | None, notes: Sequence[str] = ()) -> dict[str, Any]:
    """Head of the output of `--json` of a computation that succeeded; `begun` by `time.perf_counter()`."""
    from pitchpoint.core.status import OK, sentence

    return {
        "status": how_a_status_ends(OK),
        "sentence": sentence(OK),
        "wall_s": time.perf_counter() - begun,
        "output": None if target is None else str(target),
        "notes": list(notes),
    }


def failed(begun: float, target: Path | None, notes: Sequence[str], error: BaseException) -> dict[str, Any]:
    """Head of the output of `--json` of a computation with a partial result; see `finished`."""
    from pitchpoint.io.writing import how_it_ended

    status, sentence, _ = how_it_ended(error)
    return finished(begun, target, notes) | {"status": status, "sentence": sentence}


def unless_it_cannot_begin(
    compute: Callable[[], Computed], empty: Mapping[str, Any], target: Path | None = None
) -> Computed:
    """Compute; a failure or stop before the first step gives a summary with empty tables.

    `output` then names a file only if it contains samples, as on a full disk. After an interrupt the error
    states what became of the file `target`, if there is one.
    """
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.status import INTERRUPTED
    from pitchpoint.io.writing import how_it_ended

    begun = time.perf_counter()
    before = None if target is None else _stamp(target)
    try:
        return compute()
    except (SolverError, KeyboardInterrupt) as error:
        if isinstance(error, KeyboardInterrupt):
            fate = "" if target is None else _fate(target, before)
            text = f"before the first sample: nothing has been computed{fate}"
            error = SolverError(text, INTERRUPTED)
        status, sentence, _ = how_it_ended(error)
        wall_s = time.perf_counter() - begun
        partial = getattr(error, "partial", None)
        summary: dict[str, Any] = {
            "status": status,
            "sentence": sentence,
            "wall_s": wall_s,
            "output": partial,
            "notes": [],
        }
        return summary | dict(empty), error


def _stamp(target: Path) -> tuple[int, int] | None:
    """Identity of a file; None if it does not exist."""
    try:
        found = target.stat()
    except OSError:
        return None
    return found.st_ino, found.st_mtime_ns


def _fate(target: Path, before: tuple[int, int] | None) -> str:
    """What became of a file in which nothing was stored."""
    after = _stamp(target)
    if after is not None and after == before:
        return f"; the older {target} is unchanged"
    if after is None:
        return (
            f", and {target} was not written" if before is None else f", and the older {target} was removed"
        )
    return f"; {target} has no samples"


def statistics_table(
    title: str, channels: Mapping[str, Mapping[str, Any]], chosen: Sequence[str] | None = None
) -> None:
    """Print the statistics of channels; channels that are zero, and those not chosen, are only counted.

    Parameters
    ----------
    title
        Title of the table.
    channels
        Statistics and unit by channel.
    chosen
        Channels to print, in this order; default: all.
    """
    rows, zeros = [], []
    listed = list(channels) if chosen is None else [name for name in chosen if name in channels]
    # zeros of a table have one unit for each dimension
    of_unit: dict[str, list[Any]] = {}
    for name in listed:
        of_unit.setdefault(channels[name]["unit"], []).extend(_without_round_off(channels[name]))
    zero = {u: _unit_of_zeros(_DIMENSIONS.get(u, "dimensionless"), v) for u, v in of_unit.items()}
    for name in listed:
        row = channels[name]
        if any(row[key] != 0.0 for key in STATISTICS):
            rows.append([name, *statistics_cells(row, zero[row["unit"]])])
        else:
            zeros.append(name.partition("[")[0])
    counts = ", ".join(f"{zeros.count(kind)} of {kind}" for kind in dict.fromkeys(zeros))
    notes = [f"zero throughout, not shown: {counts}"] if zeros else []
    rest = len(channels) - len(listed)
    if rest:
        notes.append(f"{rest} more channel{'s' if rest > 1 else ''} in the file; --all lists all of them")
    table(title, ["channel", "mean", "alternating rms", "min", "max"], rows, notes)


def _largest_force(row: Mapping[str, Any] | None) -> str:
    """Mesh force of the largest magnitude, negative on the back flank; a dash if it is not a channel."""
    return "-" if row is None else shown(max(row["min"], row["max"], key=abs), "force", 4)


def rattle_table(channels: Mapping[str, Mapping[str, Any]]) -> None:
    """Print impacts and contact loss of the meshes that lose contact."""
    from pitchpoint.core.words import ranges

    rows: list[list[str]] = []
    short: dict[str, tuple[float, float]] = {}
    for name, row in channels.items():
        if not row.get("contact_loss_share", 0.0) > 0.0:
            continue
        mesh = name.partition("[")[2][:-1]
        rows.append(
            [
                mesh,
                f"{100.0 * row['contact_loss_share']:.3g} %",
                shown(row["longest_loss"], "time", 3),
                f"{row['front_impacts']} front, {row['back_impacts']} back",
                _largest_force(channels.get(f"mesh_force[{mesh}]")),
                f"{1e3 * row['closing_speed_max']:.4g} mm/s",
                f"{row['impulse_max']:.4g} N s" if row["impulse_max"] > 0.0 else "-",
                *_load_cells(row),
            ]
        )
        if 0.0 < row["shortest_contact"] < FEWEST_STEPS * row["resolution"]:
            short[mesh] = row["shortest_contact"], row["resolution"]
    notes = []
    if short:
        least, step = min(short.values())
        notes.append(
            f"{ranges(list(short))}: the shortest contact lasts {shown(least, 'time', 3)}, and contacts are "
            f"checked every {shown(step, 'time', 3)}, so impacts may be missed; use a smaller step"
        )
    if rows:
        head = [
            *("mesh", "contact loss", "longest", "impacts", "largest force", "closing speed", "impulse"),
            *("rattle index", "load reversal", "flank changes", "impact energy"),
        ]
        notes.append("flank changes and energy of the impacts per revolution of gear 1")
        table("contact loss", head, rows, notes)


def _load_cells(row: Mapping[str, Any]) -> list[str]:
    """Cells of the numbers that follow from loads and inertia."""
    index, reversal = (
        (f"{x:.3g}" if x >= 1e-3 else "0") if math.isfinite(x) else "-"
        for x in (row["rattle_index"], row["load_reversal"])
    )
    changes, energy = (row[f"{name}_per_revolution"] for name in ("flank_changes", "impact_energy"))
    return [
        index,
        reversal,
        f"{changes:.3g}" if math.isfinite(changes) else "-",
        shown(energy, "energy", 3) if math.isfinite(energy) else "-",
    ]


def statistics_cells(row: Mapping[str, Any], zero: str = "") -> list[str]:
    """Statistics of a channel as texts.

    Parameters
    ----------
    row
        Statistics and unit.
    zero
        Unit of zeros; default: that of the smallest other value.
    """
    dimension = _DIMENSIONS.get(row["unit"], "dimensionless")
    values = _without_round_off(row)
    nothing = f"0 {zero or _unit_of_zeros(dimension, values)}".rstrip()
    return [nothing if v == 0.0 else shown(v, dimension, 5) for v in values]


def _without_round_off(row: Mapping[str, Any]) -> list[Any]:
    """Statistics of a channel; the alternating part of a constant is round-off, not a result."""
    values = [row[key] for key in STATISTICS]
    most = max((abs(v) for v in values if v is not None and math.isfinite(v)), default=0.0)
    return [
        0.0 if key == "rms" and v is not None and v <= ROUND_OFF * most else v
        for key, v in zip(STATISTICS, values, strict=True)
    ]


def _unit_of_zeros(dimension: str, values: Iterable[Any]) -> str:
    """Unit of the smallest of some values that is not zero."""
    from pitchpoint.core.units import display_unit

    return display_unit(
        dimension, min((abs(v) for v in values if v is not None and math.isfinite(v) and v), default=0.0)
    )
