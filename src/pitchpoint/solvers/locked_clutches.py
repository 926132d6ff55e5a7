# SPDX-License-Identifier: Apache-2.0
"""Clutches and brakes that stick, as springs: in linear analyses, slow rolls and static solutions.

A bristle that does not yield is a torsional spring of the stiffness capacity over `wind_up`. As a state
it is not determined by its own equilibrium and couples no rotations; as a spring it does both. Time
responses keep the bristles, which can slip.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.units import format_quantity
from pitchpoint.elements.friction_clutch import BRISTLE, LOCKED
from pitchpoint.elements.kind import CLUTCH
from pitchpoint.model.components.law import Constant
from pitchpoint.model.engagement import is_open
from pitchpoint.model.torsional_supports import closed_at_start
from pitchpoint.solvers.element_tangents import element_names
from pitchpoint.solvers.initial_state.speeds import speeds_of
from pitchpoint.solvers.torque_paths import turning
from pitchpoint.system import evaluate

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.system.system import State, System

STICKS = 1e-9
"""Slip over the highest speed up to which a clutch sticks."""


def with_locked_clutches(system: System, scenario: Scenario | None) -> System:
    """The system with a spring in place of every clutch that is closed and does not slip at the start.

    Parameters
    ----------
    system
        The compiled model.
    scenario
        Scenario with the speeds and the engaged clutches; None: at rest.
    """
    model, engaged = system.model, None if scenario is None else scenario.engaged
    if model is None or not model.clutches:
        return system
    speeds = {} if scenario is None else speeds_of(system, scenario)
    spin = system.program["body"]["spin"]
    at = {int(spin[b]): speeds.get(name, 0.0) for b, name in enumerate(system.layout.bodies) if spin[b] >= 0}
    limit = STICKS * max(map(abs, at.values()), default=0.0)
    start = system.initial_state().q
    changed = {}
    for kind in system.kinds(CLUTCH):
        records = system.records[kind].copy()
        for record, name in zip(records, element_names(system, kind), strict=True):
            clutch = model.clutches[name]
            turns = [
                (s, way * factor)
                for way, end in ((1.0, "i"), (-1.0, "j"))
                for s, factor in turning(system, int(record[end])).items()
            ]
            slip = sum(factor * at[s] for s, factor in turns)
            closed = closed_at_start(clutch.capacity) and not is_open(name, clutch, engaged)
            if clutch.stage is None and closed and record["sticking"] == BRISTLE and abs(slip) <= limit:
                record["sticking"] = LOCKED
                record["u0"] = sum(factor * start[s] for s, factor in turns)
        changed[kind] = records
    return system.with_params(changed)


def locked_clutches(system: System) -> list[str]:
    """Names of the clutches and brakes that are springs in a system."""
    return [
        name
        for kind in system.kinds(CLUTCH)
        for record, name in zip(system.records[kind], element_names(system, kind), strict=True)
        if record["sticking"] == LOCKED
    ]


def overload_notes(system: System, state: State) -> list[str]:
    """Notes on locked clutches of constant capacity whose torque in a state exceeds it."""
    values, notes = evaluate.observe(system, state), []
    for kind in system.kinds(CLUTCH):
        for record, name in zip(system.records[kind], element_names(system, kind), strict=True):
            law = None if system.model is None else system.model.clutches[name].capacity
            if record["sticking"] != LOCKED or not isinstance(law, Constant):
                continue
            torque, limit = abs(float(values[int(record["out"])])), law.value * float(record["ratio"])
            if torque > limit:
                words = [format_quantity(x, "torque", 4) for x in (torque, limit)]
                notes.append(
                    f"{name} counts as locked, but its torque of {words[0]} exceeds its capacity of "
                    f"{words[1]}: it slips in a run"
                )
    return notes
