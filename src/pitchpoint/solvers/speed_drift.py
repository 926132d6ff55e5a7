# SPDX-License-Identifier: Apache-2.0
"""Remarks of a run on bodies whose mean speed leaves that of the scenario, where loads were to balance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, note
from pitchpoint.core.formula.formula import Formula
from pitchpoint.core.formula.periods import phases_of
from pitchpoint.core.units import format_quantity
from pitchpoint.elements.kind import CLUTCH, MESH
from pitchpoint.model.components.law import FormulaLaw, Law, PythonLaw, TableLaw
from pitchpoint.solvers.equilibrium.balancing import LOAD, balancing_loads
from pitchpoint.solvers.equilibrium.unknowns import rest_matrix
from pitchpoint.solvers.gear_trains import free_motions, spins_of_train
from pitchpoint.solvers.speed_stability import REMEDY, UnstableSpeed, unstable_speed
from pitchpoint.system.residual import NEWTON

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.solvers.initial_state.start import Start
    from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

DRIFT = 0.01
"""Relative deviation of the mean speed from the scenario above which a run adds a remark: resonances with a
damping ratio of 1 % are passed half within it."""
UNBALANCED = "the loads do not balance"
"""Start of the note that the speed will change."""


def drift_notes(
    start: Start, scenario: Scenario, channels: Mapping[str, Mapping[str, Any]], end: State, t_end: float
) -> tuple[Message, ...]:
    """Remarks on bodies whose mean speed deviates from that of the scenario.

    Runs that are meant to change the speed have no remark: bodies moved by a drive or `hold`, loads that do
    not balance at the start (which is a note of its own), loads that are switched over time, controlled
    machines, and clutches. A ripple over a part of its period is allowed for.

    Parameters
    ----------
    start
        Start of the run.
    scenario
        Its scenario.
    channels
        Statistics by channel over the window of the statistics.
    end, t_end
        State at the end of the run, and its time [s].
    """
    window, found = t_end - scenario.statistics_start, []
    for body, loads in watched(start, scenario).items():
        spin, given = start.system.spin(body), scenario.speed[body]
        mean = float(channels.get(f"speed[{body}]", {}).get("mean", np.nan))
        if abs(mean - given) > DRIFT * abs(given) + _allowance(start, spin, window):
            left = _net_torque(start, spin, (float(end.v[spin]) - given) / t_end)
            found.append(_remark(start, body, loads, (given, mean, float(end.v[spin])), left))
    return tuple(found)


def watched(start: Start, scenario: Scenario) -> dict[str, list[str]]:
    """Bodies whose mean speed should be that of the scenario, with the torques on their gear trains."""
    system, model = start.system, start.system.model
    if model is None or (scenario.start != "equilibrium" and not balancing_loads(system)):
        return {}
    if model.actuators or system.kinds(CLUTCH) or any(str(n).startswith(UNBALANCED) for n in start.notes):
        return {}
    motions, found = free_motions(system), {}
    for body, given in scenario.speed.items():
        spin = system.spin(body)
        loads = _loads_of(system, spin) if given != 0.0 and motions[spin].any() else []
        if loads and not any(_switched(model.loads[name].torque) for name in loads):
            found[body] = loads
    return found


def _loads_of(system: System, spin: int) -> list[str]:
    """Names of the torques on the gear train of a spin."""
    train, body = spins_of_train(system, spin), system.program["body"]
    records = system.records.get(LOAD, ())
    return [
        n
        for n, r in zip(system.names.get(LOAD, ()), records, strict=True)
        if int(body[r["i"]]["spin"]) in train
    ]


def _switched(law: Law | None) -> bool:
    """Whether a load changes over time without repeating: a run with it need not keep its speed."""
    if isinstance(law, FormulaLaw):
        formula = Formula.parse(law.text, law.variables)
        steady = [name for name in law.variables if name != "t"]
        return formula.uses("t") and phases_of(formula, steady) is None
    return isinstance(law, PythonLaw) or (isinstance(law, TableLaw) and law.over == "time")


def _allowance(start: Start, spin: int, window: float) -> float:
    """Deviation of the mean over a window [s] that a ripple may cause [rad/s]."""
    return 0.0 if start.cycle is None else start.cycle.allowance(spin, window)


def _net_torque(start: Start, spin: int, acceleration: float) -> float:
    """Torque on a body that accelerates its train [N m]."""
    motions = free_motions(start.system)
    row = motions[spin]
    mass = motions.T @ rest_matrix(start.system, start.state, NEWTON, (1.0, 0.0, 0.0)) @ motions
    return acceleration / float(row @ np.linalg.solve(mass, row))


def _remark(
    start: Start, body: str, loads: Sequence[str], speeds: tuple[float, float, float], left: float
) -> Message:
    system, model = start.system, start.system.model
    given, mean, last = (format_quantity(speed, "angular_speed", 4) for speed in speeds)
    text = f"the mean speed of {body} is {mean}, not the {given} of the scenario, and {last} at the end"
    own = [name for name in loads if model is not None and _grows(model.loads[name].torque)]
    rough = any(np.any(bank["contact"]["mu"] > 0.0) for bank in system.banks(MESH))
    remedy = "drive or hold the body, add a controller, or correct a torque"
    net = f"net torque on {body} {format_quantity(left, 'torque', 3)} on average"
    if start.cycle is not None and not start.cycle.steady:
        cause = f"{net}: no steady motion under the loads was found"
    elif unstable := instability(start):
        cause, remedy = str(unstable), REMEDY
    elif own:
        cause = f"{own[0]} does not repeat with the angle and was balanced at its value at the start"
    elif rough:
        cause = f"{net}: losses of the flanks differ from those at the start"
    else:
        cause = f"{net}: a constant torque does not control the speed"
    return note(f"{text} ({cause})", remedy=remedy)


def instability(start: Start) -> UnstableSpeed | None:
    """Fastest growth of a deviation from the mean speeds of a start, if they are unstable."""
    return unstable_speed(start.system, start.mean)


def runaway(start: Start, scenario: Scenario, end: State) -> str:
    """Sentence on the unstable operating point of a run that failed after its speed had left it; else ''.

    Parameters
    ----------
    start, scenario
        Start and scenario of the run.
    end
        State at its end.
    """
    for body in watched(start, scenario):
        given, last = scenario.speed[body], float(end.v[start.system.spin(body)])
        left = not abs(last - given) <= DRIFT * abs(given)  # also if it is not a number
        if left and (found := instability(start)):
            return f": the speed of {body} ran away; {found}; {REMEDY}"
    return ""


def _grows(law: Law | None) -> bool:
    """Whether a load depends on the angle without repeating."""
    if not isinstance(law, FormulaLaw):
        return False
    formula = Formula.parse(law.text, law.variables)
    steady = [name for name in law.variables if name != "angle"]
    return formula.uses("angle") and phases_of(formula, steady) is None
