# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint modes --multiblade`: modes of a turning wind rotor with its support."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.campbell_output import damping_text, largest
from pitchpoint.cli.output import emit_json, show, shown, table

if TYPE_CHECKING:
    from pitchpoint.model.components.wind_rotor import WindRotor
    from pitchpoint.model.model import Model

WAYS = ("collective", "forward", "backward")
"""Motions of all blades, in the order of `MultibladeModes.blades`."""


def rotor_of(model: Model, name: str) -> WindRotor:
    """The wind rotor of this name, with blades on bodies or beams of their own."""
    if name not in model.wind_rotors:
        from pitchpoint.core.nearest import hint

        raise click.BadParameter(
            f"no wind rotor {name!r}; {hint(name, model.wind_rotors)}", param_hint="--multiblade"
        )
    rotor = model.wind_rotors[name]
    if not rotor.beams and not rotor.bodies:
        raise click.BadParameter(
            f"the blades of {name!r} are fixed to the hub, so they have no modes; omit --multiblade",
            param_hint="--multiblade",
        )
    return rotor


def compute(model: Model, name: str | None, rotor: WindRotor, *, quiet: bool) -> tuple[dict[str, Any], None]:
    """Compute the modes; return the output of `modes --multiblade --json`."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import finished
    from pitchpoint.solvers.multiblade import find_multiblade_modes
    from pitchpoint.system.compile import compile_model

    begun = time.perf_counter()
    system = compile_model(model, name)
    hub, blades = rotor.hub.split(".")[0], rotor.beams or rotor.bodies
    with ProgressDisplay("modes", "elements", quiet=quiet) as progress:
        found = find_multiblade_modes(system, name, hub=hub, blades=blades, progress=progress)
    rows = [
        {
            "mode": k + 1,
            "name": found.names[k],
            "frequency": float(found.frequency[k]),
            "damping_ratio": float(found.damping_ratio[k]),
            **dict(zip(WAYS, found.blades[k].tolist(), strict=True)),
            "strain_share": found.strain[k],
        }
        for k in range(len(found.frequency))
    ]
    return finished(begun, None) | {"total": len(rows), "speed": found.speed, "modes": rows}, None


def of_turning_rotor(
    model: Model, file: str, name: str | None, rotor_name: str, count: int, *, as_json: bool, quiet: bool
) -> int:
    """Compute and print the modes; return the exit code."""
    from pitchpoint.cli.failure import OK, exit_code_of
    from pitchpoint.cli.results import unless_it_cannot_begin

    rotor = rotor_of(model, rotor_name)
    summary, error = unless_it_cannot_begin(
        lambda: compute(model, name, rotor, quiet=quiet), {"total": 0, "speed": 0.0, "modes": []}
    )
    if as_json:
        emit_json(summary)
    elif error is None:
        show_modes(f"{model.title or file}: modes at", summary, count, quiet=quiet)
    return OK if error is None else exit_code_of(error)


def show_modes(title: str, summary: dict[str, Any], count: int, *, quiet: bool) -> None:
    """Print frequencies, damping and amplitudes of the blades of the lowest modes."""
    cells = [
        [
            row["name"],
            shown(row["frequency"], "frequency", 6),
            damping_text(row["damping_ratio"], row["frequency"]),
            *(f"{row[way]:.2f}" for way in WAYS),
            largest(row["strain_share"]),
        ]
        for row in summary["modes"][:count]
    ]
    heads = ["mode", "natural frequency", "damping ratio", "collective", "forward whirl", "backward whirl"]
    heads.append("strain energy")
    table(f"{title} {shown(summary['speed'], 'angular_speed', 4)}, multi-blade coordinates", heads, cells)
    if quiet:
        return
    if count < summary["total"]:
        show(f"the lowest {count} of {summary['total']} modes that oscillate; --count N shows N")
    show("natural frequency: in axes that do not turn; blades: amplitudes over the largest of the mode")
