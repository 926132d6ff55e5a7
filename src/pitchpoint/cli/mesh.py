# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint mesh`: stiffness over the mesh cycle, for the meshes of a file or for given contact ratios."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from pitchpoint.cli.mesh_map import MOST_OVERLAP, write_map
from pitchpoint.cli.options import common, output
from pitchpoint.cli.output import emit_json, show, show_unless, shown, table
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    from pitchpoint.contact.mesh_cycle import MeshCycle
    from pitchpoint.report.stiffness_tables import StiffnessTable

BARE = "mesh"
"""Name of the mesh if no file is given."""

_BARS = "▁▂▃▄▅▆▇█"


@click.command()
@click.argument("file", required=False, type=click.Path(exists=True, dir_okay=False))
@click.option(
    "--eps-alpha",
    type=click.FloatRange(0.0, 50.0, min_open=True),
    metavar="X",
    help="Transverse contact ratio (instead of a file).",
)
@click.option("--eps-beta", type=click.FloatRange(0.0, 500.0), metavar="X", help="Overlap ratio; default: 0.")
@click.option(
    "--stiffness-ratio",
    type=float,
    metavar="S_R",
    help="Ratio of minimum to maximum stiffness of one tooth pair, 0 to 1; default: 0.8.",
)
@click.option(
    "--tip-relief-factor",
    type=float,
    metavar="T_R",
    help="Ramp at both ends of contact of a tooth pair, 0 to 1; default: 0.",
)
@click.option(
    "--points", type=click.IntRange(2, 1_000_000), default=401, show_default=True, help="Number of samples."
)
@output("Table of the stiffness of meshes and tooth pairs (csv), or map of its variation (html).")
@set_option
@common
def mesh(
    file: str | None,
    eps_alpha: float | None,
    eps_beta: float | None,
    stiffness_ratio: float | None,
    tip_relief_factor: float | None,
    points: int,
    output: str | None,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> None:
    """Show the mesh stiffness over one mesh cycle, for the meshes of FILE or for given contact ratios.

    Values are relative to c' b (single stiffness times common face width), or to the mean for a prescribed
    waveform; mean and extremes are analytic. Torsional stiffness is about the axis of a gear, the other one
    being fixed. The map is that of the parabolic stiffness of one tooth pair over both contact ratios.
    """
    from pitchpoint.report.number_rows import C_PRIME_B
    from pitchpoint.report.numbers import cycle_numbers, cycles_of_model
    from pitchpoint.report.stiffness_tables import mesh_table, pair_table

    bare = (eps_alpha, eps_beta, stiffness_ratio, tip_relief_factor)
    ending = _ending(output)
    model, tables = None, []
    if file is None:
        if ending == ".csv":
            raise click.BadParameter("a table requires a model FILE", param_hint="--output")
        if eps_alpha is None:
            raise click.UsageError("give a model FILE, or --eps-alpha with its second processes")
        from pitchpoint.contact.mesh_cycle import mesh_cycle

        S_R = 0.8 if stiffness_ratio is None else stiffness_ratio
        bare_cycle = mesh_cycle(eps_alpha, eps_beta or 0.0, S_R, tip_relief_factor or 0.0, points)
        cycles: dict[str, tuple[MeshCycle, str, float | None]] = {BARE: (bare_cycle, C_PRIME_B, None)}
    else:
        if any(option is not None for option in bare):
            raise click.UsageError(
                "the contact ratios are defined by FILE; omit --eps-alpha and its second processes"
            )
        from pitchpoint.cli.reading import read_model

        model = read_model(file, allow_code, quiet)
        cycles = dict(cycles_of_model(model, points))
        for name, (cycle, _, unit) in cycles.items():
            pairs = {"mesh": mesh_table(model, name, cycle, unit), "pair": pair_table(model, name, points)}
            tables += [(name, of, found) for of, found in pairs.items() if found is not None]
    best = {}
    if output is not None and ending == ".html":
        best = write_map(Path(output), model, (eps_alpha, eps_beta, stiffness_ratio, tip_relief_factor))
    elif output is not None and file is not None:
        _write_table(Path(output), tables, file)
    if as_json:
        found_numbers = {name: cycle_numbers(*found) for name, found in cycles.items()}
        for name, of, stiffness in tables:
            found_numbers[name][f"{of}_table"] = {"position": stiffness.position, **stiffness.columns()}
        for name, overlap in best.items():
            found_numbers[name]["best_overlap_ratio"] = overlap.eps_beta
        emit_json({"meshes": found_numbers})
        return
    if not cycles:
        show(f"{file}: no meshes; add meshes: to the file, or give --eps-alpha instead of a file")
    for name, found in cycles.items():
        _print(name, *found)
        for of, title in (
            ("mesh", "Torsional stiffness of the mesh"),
            ("pair", "One tooth pair from A to E"),
        ):
            for stiffness in (t for n, o, t in tables if (n, o) == (name, of)):
                _print_torsion(title, stiffness, pair=of == "pair")
        if name in best:
            value, variation = best[name]
            show(
                f"  best overlap ratio up to {MOST_OVERLAP:g}: {value:.4g}, peak to peak {variation:.4g} c' b"
            )
    if output is not None:
        show_unless(quiet, f"written to {output}")


def _ending(output: str | None) -> str:
    """Extension of the output file; empty without one."""
    if output is None:
        return ""
    ending = Path(output).suffix.lower()
    if ending not in (".csv", ".html"):
        raise click.BadParameter(
            f"{Path(output).name} ends neither in .csv nor in .html", param_hint="--output"
        )
    return ending


def _write_table(target: Path, tables: Sequence[tuple[str, str, StiffnessTable]], file: str) -> None:
    """Write the stiffness tables."""
    from pitchpoint.io.target import check_target, write_file
    from pitchpoint.report.stiffness_tables import csv_text

    write_file(check_target(target, "stiffness", [file]), csv_text(tables))


def _print_torsion(title: str, table_of: StiffnessTable, *, pair: bool) -> None:
    """Print torsional stiffness about both axes, of one pair with its stiffness along the base tangent."""
    columns = table_of.columns()
    names = list(columns) if pair else list(columns)[1:]
    heads = {"stiffness": "along the base tangent"}
    kinds = {name: "stiffness" if name == "stiffness" else "torsional_stiffness" for name in names}
    rows = [
        [word, *(shown(float(of(columns[name].tolist())), kind, 6) for name, kind in kinds.items())]
        for word, of in (("least", min), ("greatest", max))
    ]
    about = [heads.get(n, f"about gear {n[-1]}") for n in names]
    table(title, ["", *about], rows)


def _print(name: str, cycle: MeshCycle, relative_to: str, unit: float | None) -> None:
    """Print one mesh as a table and a line of bars."""
    rows = []
    for label, value in (
        ("mean", cycle.mean),
        ("least", cycle.minimum),
        ("greatest", cycle.maximum),
        ("peak to peak", cycle.peak_to_peak),
    ):
        absolute = [] if unit is None else [shown(float(value * unit), "stiffness", 6)]
        rows.append([label, f"{value:.6f}", *absolute])
    absolute = [] if unit is None else ["along the base tangent"]
    table(f"Mesh {name}: stiffness over one mesh cycle", ["", f"over {relative_to}", *absolute], rows)
    show(f"  {bars(cycle)}  one cycle, from minimum to maximum")
    if cycle.jumps:
        show(f"  jumps at the phases {', '.join(f'{phase:.4f}' for phase in cycle.jumps)}")


def bars(cycle: MeshCycle, width: int = 60) -> str:
    """Draw the cycle as a line of bars between its minimum and maximum."""
    n, span = len(cycle.phase), cycle.peak_to_peak
    line = ""
    for k in range(width):
        value = float(cycle.stiffness_ratio[k * (n - 1) // width])
        height = (value - cycle.minimum) / span if span > 1e-9 * cycle.maximum else 0.5
        line += _BARS[min(max(int(height * len(_BARS)), 0), len(_BARS) - 1)]
    return line
