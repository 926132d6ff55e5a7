# SPDX-License-Identifier: Apache-2.0
"""Balancing torques of rotating machines, from means over the period of the loads and over the mesh cycle.

A torque that balances a pulsating load at one instant only changes the mean speed with every revolution. The
mean speed is constant if the work balances: angle-dependent loads enter with their mean over their period,
flank friction, which pulsates with the mesh phase, with its mean over mesh cycles.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.units import format_quantity
from pitchpoint.elements.kind import MESH
from pitchpoint.elements.signal import CONSTANT, TWO_PI, set_constant
from pitchpoint.multibody.bodies import spin_of
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.equilibrium.solve import LOAD, NOW, balancing_loads
from pitchpoint.solvers.gear_trains import mesh_rates
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System, assemble

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario

Array = NDArray[np.float64]

POINTS = 720
"""Points per revolution at which a load is averaged; lower harmonics cancel exactly."""
MAX_TURNS = 12
"""Revolutions within which a load must repeat to count as periodic."""
SAME = 1e-9
"""Relative difference below which two values, or two mesh frequencies, count as equal."""
IN_CYCLE = 16
"""Instants per mesh cycle at which friction is averaged if all meshes have the same frequency."""
MAX_COORDINATES = 300
"""Largest number of coordinates for which friction is averaged: every instant needs an equilibrium."""
CYCLES = 3
"""Cycles of the slowest mesh, with a Hann window, over which friction is averaged if frequencies differ."""
DRIFT = 0.01
"""Relative deviation of the mean speed from the scenario above which a run adds a remark."""


def with_mean_loads(system: System, state: State) -> System:
    """Copy of the system with angle-periodic torques replaced by their mean values.

    Torques that are not periodic, such as those of springs, and torques on bodies at rest are unchanged.

    Parameters
    ----------
    system, state
        The system and its initial state, whose speeds apply to speed-dependent loads.
    """
    records = system.records.get(LOAD)
    if records is None or not np.any(records["form"] != CONSTANT):
        return system
    alone = assemble(
        system.bodies,
        {LOAD: records.copy()},
        pools={k: p for k, p in system.pools.items() if k == LOAD},
        laws={k: w for k, w in system.laws.items() if k == LOAD},
    )
    found = records.copy()
    now = evaluate.observe(alone, state)[alone.records[LOAD]["out"]]
    pulsates = False
    for k in np.flatnonzero(records["form"] != CONSTANT):
        mean = _mean_over_angle(alone, state, int(k))
        if mean is not None and abs(mean - now[k]) > SAME * abs(mean):
            set_constant(found[k], mean)
            pulsates = True
    return system.with_params({LOAD: found}) if pulsates else system


def _mean_over_angle(alone: System, state: State, k: int) -> float | None:
    """Mean of one torque over its period; None if the body is at rest or the torque is not periodic."""
    body = int(alone.records[LOAD][k]["i"])
    spin, out = spin_of(alone.program["body"], body), int(alone.records[LOAD][k]["out"])
    if spin < 0 or state.v[spin] == 0.0:
        return None
    here = state.copy()

    def torques(turn: int) -> Array:
        """Values over one revolution, after a number of revolutions."""
        here.turns[body] = state.turns[body] + turn
        values = np.empty(POINTS)
        for n, angle in enumerate(np.arange(POINTS) * (TWO_PI / POINTS)):
            here.q[spin] = angle - np.pi
            values[n] = evaluate.observe(alone, here)[out]
        return values

    first = torques(0)
    total = first.copy()
    for turn in range(1, MAX_TURNS + 1):
        values = torques(turn)
        if np.abs(values - first).max() <= SAME * np.abs(first).max():
            return float(total.mean()) / turn
        total += values
    return None


def cycle_instants(system: System, state: State) -> tuple[Array, Array]:
    """Instants [s] at which flank friction is averaged, and their weights; the weights sum to one.

    Only the start if nothing rotates, no flank has friction, or the system has closed loops or is large.
    """
    rough = any(np.any(bank["contact"]["mu"] > 0.0) for bank in system.banks(MESH))
    rates = np.zeros(0)
    if rough and system.sizes["nd"] <= MAX_COORDINATES and not is_looped(system):
        body = system.program["body"]
        speeds = {
            name: float(state.v[spin_of(body, b)])
            for b, name in enumerate(system.layout.bodies)
            if b and spin_of(body, b) >= 0
        }
        rates = np.array(mesh_rates(system, speeds))
        rates = rates[rates > SAME * rates.max(initial=0.0)]
    if not rates.size:
        return NOW
    if np.ptp(rates) <= SAME * rates.max():
        share = np.arange(IN_CYCLE) / IN_CYCLE
        return share * TWO_PI / rates[0], np.full(IN_CYCLE, 1.0 / IN_CYCLE)
    share = np.arange(CYCLES * IN_CYCLE) / (CYCLES * IN_CYCLE)
    weights = 1.0 - np.cos(TWO_PI * share)
    return share * CYCLES * TWO_PI / rates.min(), weights / weights.sum()


def drift_notes(
    system: System, scenario: Scenario, channels: Mapping[str, Mapping[str, Any]]
) -> tuple[str, ...]:
    """Remarks on bodies whose mean speed deviates from the scenario in spite of a balancing torque.

    Parameters
    ----------
    system, scenario
        The system and scenario of the run.
    channels
        Statistics by channel.
    """
    if not balancing_loads(system):
        return ()
    notes = []
    for body, given in scenario.speed.items():
        mean = channels.get(f"speed[{body}]", {}).get("mean", np.nan)
        if body not in scenario.drive and abs(mean - given) > DRIFT * abs(given) > 0.0:
            now, wanted = (format_quantity(x, "angular_speed", 4) for x in (mean, given))
            notes.append(
                f"the mean speed of {body} is {now}, not the {wanted} of the scenario: the balancing torque "
                "is constant and does not control the speed; drive the body, or add a controller"
            )
    return tuple(notes)
