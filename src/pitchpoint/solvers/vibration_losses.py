# SPDX-License-Identifier: Apache-2.0
"""Balancing torques of vibrating trains: losses of flank friction from the momentum over a few mesh cycles.

Friction follows the vibrating mesh forces, so that the mean loss differs from that of slow rotation. Elastic
mesh forces do not change the momentum of a train that rotates in the ratio of its teeth, L = r . M v. In a
short run under the mean loads, the slope of L over a few mesh cycles is therefore the net torque that is
left, long before the vibration is steady.
The mean has a Hann window w: it is minus the integral of w' L.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.status import OK
from pitchpoint.elements.kind import MESH
from pitchpoint.multibody.bodies import spin_of
from pitchpoint.solvers.equilibrium.balancing import LOAD, balancing_loads
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.equilibrium.unknowns import rest_matrix
from pitchpoint.solvers.gear_trains import mesh_orders, rigid_rotations
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.residual import NEWTON

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.solvers.initial_state.start import Start
    from pitchpoint.system.system import System

Array = NDArray[np.float64]

SETTLE, MEASURE = 3, 3
"""Cycles of the slowest mesh before and within the window."""
SHARE = 0.2
"""Longest duration of the short run over that of the scenario."""
SAME = 1e-9
"""Relative mesh frequency below which a mesh counts as at rest."""


def with_vibration_losses(start: Start, scenario: Scenario, run: Callable[..., Any]) -> Start:
    """Start whose balancing torques include the losses of vibrating flanks; unchanged without friction.

    Unchanged, too, for closed loops, controlled machines, gears with tooth faults (their losses differ from
    tooth to tooth), and where the short run would exceed a fifth of the scenario.

    Parameters
    ----------
    start
        Start of the scenario, with the torques of slow rotation.
    scenario
        The scenario.
    run
        `solvers.time.run_time`.
    """
    system, balancing = start.system, balancing_loads(start.system)
    cycle = _slowest_cycle(start, scenario) if balancing and _applies(system, scenario) else 0.0
    motions = rigid_rotations(system) if cycle > 0.0 else np.zeros((0, 0))
    if not len(motions):
        return start
    slopes = _slopes(start, scenario, run, motions, cycle)
    if slopes is None:
        return start
    records = system.records[LOAD].copy()
    shares = motions[:, [spin_of(system.program["body"], int(records[k]["i"])) for k in balancing]]
    records["value"][balancing] -= np.linalg.lstsq(shares, slopes, rcond=1e-9)[0]
    return replace(start, system=system.with_params({LOAD: records}))


def _applies(system: System, scenario: Scenario) -> bool:
    """Whether flanks have friction, and nothing but loads and vibration changes the speed."""
    model = system.model
    rough = any(np.any(bank["contact"]["mu"] > 0.0) for bank in system.banks(MESH))
    if model is None or not rough or is_looped(system) or scenario.method == "kinematics":
        return False
    faulty = any(g.faults for g in model.gears.values()) or any(g.faults for g in model.bevel_gears.values())
    return not (faulty or model.actuators or model.controllers)


def _slowest_cycle(start: Start, scenario: Scenario) -> float:
    """Period of the slowest mesh [s]; 0 if nothing rotates, or the short run would be too long."""
    found = np.array(list(mesh_orders(start.system, start.mean.v).values()))
    found = found[found > SAME * found.max(initial=0.0)]
    cycle = 2.0 * np.pi / float(found.min()) if found.size else 0.0
    return cycle if (SETTLE + MEASURE) * cycle <= SHARE * (scenario.duration or 0.0) else 0.0


def _slopes(
    start: Start, scenario: Scenario, run: Callable[..., Any], motions: Array, cycle: float
) -> Array | None:
    """Mean rate of the momentum of every free rotation [N m]; None if the short run fails."""
    system, state = start.system, start.mean
    if start.cycle is not None:
        system = start.cycle.applied(system)
    spins = {int(s): b for b, s in enumerate(system.program["body"]["spin"]) if s >= 0}
    spins = {s: b for s, b in spins.items() if f"speed[{system.layout.bodies[b]}]" in _names(system)}
    places = list(spins)
    momentum = (motions @ rest_matrix(system, state, NEWTON, (1.0, 0.0, 0.0)))[:, places]
    short = replace(
        scenario,
        duration=(SETTLE + MEASURE) * cycle,
        settle_time=0.0,
        sample_rate=None,
        events=(),
        channels=(),
    )
    memory = Memory()
    rows = [system.layout.channel(f"speed[{system.layout.bodies[spins[s]]}]") for s in places]
    done = run(system, short, sink=memory, start=replace(start, system=system, state=state), channels=rows)
    if done.status != OK:
        return None
    t = np.concatenate(memory.times)
    L = momentum @ (np.concatenate(memory.rows) - state.v[places]).T
    inside = t >= SETTLE * cycle
    t, L = t[inside] - SETTLE * cycle, L[:, inside]
    span = MEASURE * cycle
    slope_of_window = 2.0 * np.pi / span**2 * np.sin(2.0 * np.pi * t / span)
    found = -np.trapezoid(slope_of_window * (L - L[:, :1]), t, axis=1)
    return found if np.all(np.isfinite(found)) else None


def _names(system: System) -> set[str]:
    return {channel.name for channel in system.layout.channels}
