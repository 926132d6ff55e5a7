# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint mesh`: stiffness over the mesh cycle, for the meshes of a file or for given contact ratios."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from pitchpoint.cli.options import common
from pitchpoint.cli.output import emit_json, show, shown, table

if TYPE_CHECKING:
    from pitchpoint.contact.mesh_cycle import MeshCycle

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
@common
def mesh(
    file: str | None,
    eps_alpha: float | None,
    eps_beta: float | None,
    stiffness_ratio: float | None,
    tip_relief_factor: float | None,
    points: int,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> None:
    """Show the mesh stiffness over one mesh cycle, for the meshes of FILE or for given contact ratios.

    Values are relative to c' b (single stiffness times common face width), or to the mean for a prescribed
    waveform; mean and extremes are analytic.
    """
    from pitchpoint.report.number_rows import C_PRIME_B
    from pitchpoint.report.numbers import cycle_numbers, cycles_of_model

    bare = (eps_alpha, eps_beta, stiffness_ratio, tip_relief_factor)
    if file is None:
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

        cycles = dict(cycles_of_model(read_model(file, allow_code, quiet), points))
    if as_json:
        emit_json({"meshes": {name: cycle_numbers(*found) for name, found in cycles.items()}})
        return
    if not cycles:
        show(f"{file}: no meshes; add meshes: to the file, or give --eps-alpha instead of a file")
    for name, found in cycles.items():
        _print(name, *found)


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
