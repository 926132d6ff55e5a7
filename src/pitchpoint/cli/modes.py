# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint modes`: natural frequencies, damping ratios and mode shapes about an operating point."""

from __future__ import annotations

import math
import time
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.campbell_output import damping_text, largest
from pitchpoint.cli.options import common, model_file, output, state, writes
from pitchpoint.cli.output import NOTHING, emit_json, show, show_notes, shown, table
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    from pathlib import Path

    from pitchpoint.model.model import Model
    from pitchpoint.solvers.modal import Modes

SHOWN = 20
"""Default number of modes in the table."""

ROUNDING = 1e-7
"""Frequency relative to the highest below which the table shows zero: round-off of eigenvalues."""


@click.command()
@model_file
@state
@click.option(
    "--phase",
    type=click.FloatRange(0.0, 1.0, max_open=True),
    metavar="PSI",
    help="Mesh phase of the mesh stiffness; default: mean over the mesh cycle.",
)
@click.option(
    "--count",
    type=click.IntRange(min=1),
    metavar="N",
    help="Compute and show the lowest N modes. Default: show 20; for JSON and files compute all, "
    "or the lowest 40 of more than 200.",
)
@writes(
    "--animation",
    metavar="FILE",
    help="Write the motion of bodies and nodes over one cycle of every mode (json, npz).",
)
@click.option(
    "--multiblade",
    metavar="ROTOR",
    help="Modes of a turning wind rotor with its support, in axes that do not turn.",
)
@output("Result file (netCDF-4/HDF5); default: none.")
@set_option
@common
def modes(
    file: str,
    scenario: str | None,
    phase: float | None,
    count: int | None,
    animation: str | None,
    multiblade: str | None,
    output: str | None,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> int:
    """Compute the modes of FILE about its loaded equilibrium."""
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.multiblade_modes import of_turning_rotor
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.results import (
        known_scenario,
        refuse_without_effect,
        result_path,
        unless_it_cannot_begin,
    )
    from pitchpoint.io.target import check_target

    model = read_model(file, allow_code, quiet)
    name = known_scenario(model, scenario) if scenario is not None else None
    if multiblade is not None:
        unused = {"--phase": phase, "--animation": animation, "--output": output}
        refuse_without_effect("with --multiblade", unused)
        return of_turning_rotor(model, file, name, multiblade, count or SHOWN, as_json=as_json, quiet=quiet)
    target = result_path(output, file, name or "") if output is not None else None
    if animation is not None:
        check_target(animation, "animation", [file])
    summary, error = unless_it_cannot_begin(
        lambda: compute(
            model, file, name, target, phase=phase, count=count, animation=animation, quiet=quiet
        ),
        {"total": 0, "modes": [], "states": [], "state_count": 0, "state_reach": None},
    )
    if as_json:
        emit_json(summary)
    elif error is None and not (quiet and target is not None):
        at = "the mean stiffness" if phase is None else f"the phase {phase:g}"
        shown_modes = len(summary["modes"]) if count is not None else min(len(summary["modes"]), SHOWN)
        _print(f"{model.title or file}: modes at {at}", summary, shown_modes, quiet=quiet)
    return OK if error is None else exit_code_of(error)


def compute(
    model: Model,
    file: str,
    name: str | None,
    target: Path | None,
    *,
    phase: float | None,
    count: int | None = None,
    animation: str | None = None,
    quiet: bool,
) -> tuple[dict[str, Any], None]:
    """Compute the modes and write them if requested; return the output of `modes --json`."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import finished, header_of
    from pitchpoint.io.dataset_tables import write_variables
    from pitchpoint.solvers.linear_system import linearise
    from pitchpoint.solvers.modal import COORDINATES, find_modes, modal_variables
    from pitchpoint.solvers.modes.unstable import unstable_notes
    from pitchpoint.system.compile import compile_model

    begun = time.perf_counter()
    system = compile_model(model, name)
    with ProgressDisplay("modes", "elements", quiet=quiet) as progress:
        linear = linearise(system, name, phase=phase, progress=progress)
        found = find_modes(system, name, phase=phase, count=count, linear=linear)
    notes = (*found.notes, *unstable_notes(linear, found))
    if target is not None:
        header = header_of(model, file, name or "", "modes", "modal")
        write_variables(target, header, modal_variables(found), COORDINATES, notes=notes)
    if animation is not None:
        animate(animation, found, model)
    summary = finished(begun, target, notes) | {
        "total": found.total,
        "modes": rows_of(found),
        "states": [[float(x.real), float(x.imag)] for x in found.state_eigenvalue],
        "state_count": found.states,
        "state_reach": found.state_reach if math.isfinite(found.state_reach) else None,
    }
    return summary, None


def _print(title: str, summary: dict[str, Any], count: int, *, quiet: bool) -> None:
    """Print frequencies and damping of the lowest modes, and the number of omitted modes.

    The lowest modes are those of the undamped frequency; the rows are in the order of the natural frequency.
    """
    from pitchpoint.solvers.linear_system import omitted_note

    least = ROUNDING * max((abs(row["undamped_frequency"]) for row in summary["modes"]), default=0.0)

    def above_rounding(frequency: float) -> float:
        """Printed frequency [Hz]; round-off of a rigid-body mode becomes zero."""
        return 0.0 if abs(frequency) <= least else frequency

    cells = [
        [
            row["name"],
            shown(above_rounding(row["frequency"]), "frequency", 6),
            damping_text(row["damping_ratio"], above_rounding(row["undamped_frequency"])),
            shown(above_rounding(row["undamped_frequency"]), "frequency", 6),
            largest(row["strain_share"]),
            largest({part: sum(ways.values()) for part, ways in row["kinetic_share"].items()}),
        ]
        for row in sorted(summary["modes"][:count], key=lambda row: above_rounding(row["frequency"]))
    ]
    heads = ["mode", "natural frequency", "damping ratio", "undamped", "strain energy", "kinetic energy"]
    table(title, heads, cells)
    if summary["state_count"]:
        show(states_text(summary["states"], summary["state_count"], summary["state_reach"]))
    if quiet:
        return
    total, computed = summary["total"], len(summary["modes"])
    if count < total:
        last = shown(summary["modes"][count - 1]["undamped_frequency"], "frequency", 4)
        more = f"; {computed} are written" if summary["output"] is not None and computed != count else ""
        show(f"the lowest {count} of {total} modes, up to {last} undamped{more}; --count N shows N")
    if count:
        show(
            "natural frequency: with dampers, gyroscopic terms and speeds of the scenario; undamped: at rest"
        )
    show_notes(note for note in summary["notes"] if note != omitted_note(computed, total))
    if summary["output"] is not None:
        show(f"written to {summary['output']}")


def states_text(roots: list[list[float]], states: int, reach: float | None) -> str:
    """Eigenvalues of states in words, and how many of how many they are.

    Parameters
    ----------
    roots
        Real and imaginary parts [1/s], in ascending order of the absolute value.
    states
        Number of states.
    reach
        Absolute value up to which the eigenvalues are complete [1/s]; None for all.

    Examples
    --------
    >>> states_text([[-0.4, 0.0], [-2.0, 3.0]], 3, None)
    'eigenvalues of states [1/s]: -0.4, -2 ± 3i'
    >>> states_text([[-0.4, 0.0]], 3, 100.0)
    'eigenvalues of states [1/s], all up to 100 1/s, of 3 states: -0.4'
    """
    least = ROUNDING * max((math.hypot(*root) for root in roots), default=0.0)
    words = [
        f"{x:.5g} ± {y:.5g}i" if y > 0.0 else f"{x if abs(x) > least else 0.0:.5g}" for x, y in roots[:SHOWN]
    ]
    found = [f"the slowest {SHOWN} of {len(roots)}, --json has all"] if len(roots) > SHOWN else []
    if reach is not None:
        found.append(f"all up to {reach:.4g} 1/s, of {states} states")
    return f"{', '.join(['eigenvalues of states [1/s]', *found])}: {', '.join(words) or NOTHING}"


def rows_of(found: Modes) -> list[dict[str, Any]]:
    """Output of `modes --json` for each mode; shapes have modal mass 1."""
    from pitchpoint.solvers.modes.energies import WAYS

    return [
        {
            "mode": k + 1,
            "name": found.names[k],
            "frequency": float(found.damped_frequency[k]),
            "undamped_frequency": float(found.frequency[k]),
            "damping_ratio": float(found.damping_ratio[k]),
            "whirl": found.whirl[k],
            "strain_share": dict(
                zip(found.groups.components, found.energies.strain[k].tolist(), strict=True)
            ),
            "kinetic_share": {
                part: dict(zip(WAYS, found.energies.kinetic[k, p].tolist(), strict=True))
                for p, part in enumerate(found.groups.parts)
            },
            "gyroscopic_share": float(found.energies.gyroscopic[k]),
            "eigenvalue": [float(found.eigenvalue[k].real), float(found.eigenvalue[k].imag)],
            "shape": dict(zip(found.coordinates, found.shape[k].tolist(), strict=True)),
            "coordinate_share": dict(zip(found.coordinates, found.kinetic[k].tolist(), strict=True)),
            "potential_share": dict(zip(found.elements, found.potential[k].tolist(), strict=True)),
            "participation": found.participation[k].tolist(),
            "effective_mass": found.effective_mass[k].tolist(),
        }
        for k in range(len(found.names))
    ]


def animate(path: str, found: Modes, model: Model) -> None:
    """Write the motion of all bodies, and of the nodes of elastic ones, over one cycle of every mode."""
    from pitchpoint.io.mode_animation import write_mode_animation
    from pitchpoint.solvers.modes.node_shapes import node_shapes

    write_mode_animation(
        path,
        bodies=found.bodies,
        names=found.names,
        frequency=found.damped_frequency,
        place=found.place,
        axes=found.axes,
        body_shape=found.damped_body_shape,
        nodes=node_shapes(model, found),
    )
