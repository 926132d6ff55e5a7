# SPDX-License-Identifier: Apache-2.0
"""Equilibrium where only a broken tooth would carry: what is missing, and what to do."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.units import format_quantity
from pitchpoint.model.components.tooth_faults import BrokenBevelTooth, BrokenTooth
from pitchpoint.system import evaluate
from pitchpoint.system.remarks import DEEPEST

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.system.system import State, System


def broken_tooth(system: System, state: State) -> str:
    """Name the mesh that rests only far inside its flanks because a tooth is broken; '' if there is none.

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
        first = model.every_mesh[mesh].gears[0]
        shape = (model.gears[first] if first in model.gears else model.bevel_gears[first]).geometry
        if depth > DEEPEST * shape.m_n:
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
    for name, mesh in model.every_mesh.items():
        for gear in mesh.gears:
            section = "gears" if gear in model.gears else "bevel_gears"
            for label, fault in getattr(model, section)[gear].faults.items():
                if isinstance(fault, BrokenTooth | BrokenBevelTooth) and fault.severity > 0.0:
                    line = model.line((section, gear, "faults", label))
                    where = f" (line {line})" if line else ""
                    found.setdefault(name, []).append(f"{section}.{gear}.faults.{label}{where}")
    return found
