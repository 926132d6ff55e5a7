# SPDX-License-Identifier: Apache-2.0
"""Balancing torques of rotating machines, from means over the period of the loads and over the mesh cycle.

A torque that balances a pulsating load at one instant only changes the mean speed with every revolution. The
mean speed is constant if the work balances: angle-dependent loads enter with their mean over their period,
flank friction, which pulsates with the mesh phase, with its mean over mesh cycles. So do the forces of tooth
surfaces: their stored energy changes with the mesh phase also under constant load (decision 0034). This
changes the torque by 1e-4 to 1e-3 at a single position, and has zero mean over a cycle.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import note
from pitchpoint.core.units import format_quantity
from pitchpoint.core.words import listed
from pitchpoint.elements.kind import MESH
from pitchpoint.elements.mesh.record import SURFACE
from pitchpoint.elements.signal import TWO_PI
from pitchpoint.multibody.bodies import spin_of
from pitchpoint.solvers.equilibrium.balancing import LOAD, balancing_loads
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.equilibrium.solve import NOW
from pitchpoint.solvers.gear_trains import mesh_rates
from pitchpoint.solvers.load_cycle import LoadCycle
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

SAME = 1e-9
"""Relative difference below which two values, or two mesh frequencies, count as equal."""
IN_CYCLE = 16
"""Instants per mesh cycle at which friction is averaged if all meshes have the same frequency."""
IN_SURFACE_CYCLE = 64
"""The same for contact of tooth surfaces, whose stiffness changes within a small part of a cycle: 4e-6."""
MAX_COORDINATES = 300
"""Largest number of coordinates for which friction is averaged: every instant needs an equilibrium."""
CYCLES = 3
"""Cycles of the slowest mesh, with a Hann window, over which friction is averaged if frequencies differ."""
RIPPLE = 1e-4
"""Relative deviation of the speed at the start from its mean above which it is noted."""


def cycle_instants(system: System, state: State) -> tuple[Array, Array, int]:
    """Instants [s] at which flank forces are averaged, their weights, and the number of cycles they cover.

    The weights sum to one; the cycles are those of the slowest mesh. Only the start, and no cycle, if nothing
    rotates, no flank has friction and none is a tooth surface, or the system has closed loops or is large.
    """
    rough, surface = _pulsating(system)
    rates, count = np.zeros(0), IN_SURFACE_CYCLE if surface else IN_CYCLE
    if (rough or surface) and system.sizes["nd"] <= MAX_COORDINATES and not is_looped(system):
        body = system.program["body"]
        speeds = {
            name: float(state.v[spin_of(body, b)])
            for b, name in enumerate(system.layout.bodies)
            if b and spin_of(body, b) >= 0
        }
        rates = np.array(mesh_rates(system, speeds))
        rates = rates[rates > SAME * rates.max(initial=0.0)]
    if not rates.size:
        return (*NOW, 0)
    if np.ptp(rates) <= SAME * rates.max():
        share = np.arange(count) / count
        return share * TWO_PI / rates[0], np.full(count, 1.0 / count), 1
    share = np.arange(CYCLES * count) / (CYCLES * count)
    weights = 1.0 - np.cos(TWO_PI * share)
    return share * CYCLES * TWO_PI / rates.min(), weights / weights.sum(), CYCLES


def _pulsating(system: System) -> tuple[bool, bool]:
    """Whether a mesh has flank friction, and whether one is a contact of tooth surfaces."""
    banks = system.banks(MESH)
    rough = any(np.any(bank["contact"]["mu"] > 0.0) for bank in banks)
    surface = any(np.any(bank["source"] == SURFACE) for bank in banks if "source" in (bank.dtype.names or ()))
    return rough, surface


def cycle_notes(system: System, state: State, cycle: LoadCycle, rates: Array) -> tuple[str, ...]:
    """Notes on the mean torques of pulsating loads and on the ripple of the speed.

    Parameters
    ----------
    system, state
        The system, and the state at t = 0.
    cycle
        Its pulsating loads.
    rates
        Mean rates, shape (nd,).
    """
    names, records = system.names[LOAD], system.records[LOAD]
    balancing = balancing_loads(system)
    torques = listed([names[k] for k in balancing])
    verb = "balance" if len(balancing) > 1 else "balances"
    text = f"{torques} {verb} {_mean_of(system, cycle)}"
    if not cycle.steady:
        stops = [f"{body} after {format_quantity(t, 'time', 3)}" for body, t in cycle.stops.items()]
        then = f"; the rigid train, started at constant speed, would stop {listed(stops)}" if stops else ""
        remedy = "drive the body, increase its inertia or speed, or reduce the ripple of the load"
        return (
            text,
            note(
                f"no steady motion under these loads was found, so they count at constant speed{then}",
                "",
                remedy,
            ),
        )
    starts = []
    for k in balancing:
        body = int(records[k]["i"])
        spin = spin_of(system.program["body"], body)
        mean, begun = float(rates[spin]), float(state.v[spin])
        if abs(begun - mean) > RIPPLE * abs(mean):
            speeds = (begun, mean, mean + cycle.lowest[spin], mean + cycle.highest[spin])
            now, wanted, least, most = (format_quantity(x, "angular_speed", 5) for x in speeds)
            name = system.layout.bodies[body]
            rigid = f"rigid train: from {least} to {most}"
            starts.append(f"{name} starts at {now} for a mean speed of {wanted} ({rigid})")
    return (": ".join([text, *starts]),)


def _mean_of(system: System, cycle: LoadCycle) -> str:
    """Loads of a cycle and the time or angle of their mean."""
    names = system.names[LOAD]
    loads = listed([names[k] for k in cycle.means])
    unit, of = ("angle", f" of {cycle.body}") if cycle.body else ("time", "")
    time = format_quantity(cycle.averaged, unit, 4) + of
    if cycle.averaged == cycle.period:
        over = f"{time}, their common period" if len(cycle.means) > 1 else f"its period of {time}"
    else:
        period = format_quantity(cycle.period, unit, 4) + of
        part = f"a part of their period of {period}" if cycle.period > 0.0 else "no common period"
        over = f"{time} ({part}; estimated error {format_quantity(cycle.error, 'torque', 2)})"
    return f"the mean torque of {loads} over {over}"


def balanced_words(system: System, state: State, cycle: LoadCycle | None) -> str:
    """What the balancing torques of a start balance: loads at the start or their mean, flank forces.

    Parameters
    ----------
    system, state
        The system, and the state at t = 0.
    cycle
        Its pulsating loads, if there are any.
    """
    text = "the loads at the start" if cycle is None else _mean_of(system, cycle)
    times, _, cycles = cycle_instants(system, state)
    if cycles:
        count = "one mesh cycle" if cycles == 1 else f"{cycles} cycles of the slowest mesh"
        forces = " and ".join(
            word
            for word, there in zip(("flank friction", "flank contact"), _pulsating(system), strict=True)
            if there
        )
        text += f", and {forces} over {count} ({format_quantity(times.size * times[1], 'time', 4)})"
    return text
