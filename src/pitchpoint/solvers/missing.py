# SPDX-License-Identifier: Apache-2.0
"""Equilibrium where only a broken tooth would carry: what is missing, and what to do."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.units import format_quantity
from pitchpoint.model.components.tooth_faults import BrokenTooth
from pitchpoint.system import evaluate
from pitchpoint.system.remarks import DEEPEST

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.system.system import State, System


def missing_tooth(system: System, state: State) -> str:
    """Say which mesh rests only far inside its flanks because a tooth is broken; '' if there is none.

    All pairs of a mesh have the same overlap along the line of action. Where a broken tooth leaves none in
    contact, gears turn under their load until another pair comes onto the path of contact: some millimetres
    deep, where it bears any load at once. Teeth would touch outside their path long before, which no flank
    law here knows.

    Parameters
    ----------
    system
        The system.
    state
        Where the search for rest has ended, well or not.
    """
    model = system.model
    suspects = {} if model is None else _broken(model)
    if model is None or not suspects:
        return ""
    values = evaluate.observe(system, state)
    known = {c.name: k for k, c in enumerate(system.layout.channels)}
    for mesh, faults in suspects.items():
        if f"deflection[{mesh}]" not in known:
            continue
        depth = abs(float(values[known[f"deflection[{mesh}]"]])) - 0.5 * model.backlash(mesh)
        if depth > DEEPEST * model.gears[model.meshes[mesh].gears[0]].normal_module:
            return (
                f"no equilibrium: no pair of teeth carries in the mesh {mesh} here, where "
                f"{' or '.join(faults)} leaves a gap (the next pair would be "
                f"{format_quantity(depth, 'length', 3)} deep); run it over time, which goes through the gap "
                "(with start: assembled to begin in it), break out less, or take more overlap"
            )
    return ""


def _broken(model: Model) -> dict[str, list[str]]:
    """Faults that break something out of the gears of a mesh, by mesh, with their lines."""
    found: dict[str, list[str]] = {}
    for name, mesh in model.meshes.items():
        for gear in mesh.gears:
            for label, fault in model.gears[gear].faults.items():
                if isinstance(fault, BrokenTooth) and fault.severity > 0.0:
                    line = model.line(("gears", gear, "faults", label))
                    where = f" (line {line})" if line else ""
                    found.setdefault(name, []).append(f"gears.{gear}.faults.{label}{where}")
    return found
