# SPDX-License-Identifier: Apache-2.0
"""What an exported model needs to find its initial equilibrium for other loads and parameters."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.kind import CLUTCH, DRIVE
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.element_batches import free_flying
from pitchpoint.solvers.equilibrium.balancing import LOAD, balancing_loads, balancing_spins
from pitchpoint.solvers.equilibrium.failure import tooth_gaps
from pitchpoint.solvers.equilibrium.unknowns import extents
from pitchpoint.solvers.gear_trains import complete, driven_coordinates, exchange_all, held_spins
from pitchpoint.solvers.load_cycle import load_cycle
from pitchpoint.solvers.mean_balance import cycle_instants
from pitchpoint.system.system import State, System

LARGEST = 400
"""Largest number of coordinates: the matrix of the equilibrium is dense."""


@dataclass(frozen=True)
class ExportedRest:
    """Equilibrium of an exported model, see `solvers.initial_state.start`.

    Parameters
    ----------
    free, free_balancing
        Coordinates that move to the equilibrium; the second while the bodies of balancing torques are held.
    balancing
        Spin and label of the load of each balancing torque.
    times, weights
        Instants over which balancing torques are averaged [s].
    spins
        Spins that advance with these times.
    entries
        Row, column and place in the blocks of every entry of the matrix, shape (n, 3).
    extents
        Size of every coordinate whose rounding error it has at least [m, rad].
    gaps
        Channel and largest value [m] of the deflection of each mesh with a broken tooth.
    """

    free: tuple[int, ...] = ()
    free_balancing: tuple[int, ...] = ()
    balancing: tuple[tuple[int, str], ...] = ()
    times: tuple[float, ...] = ()
    weights: tuple[float, ...] = ()
    spins: tuple[int, ...] = ()
    entries: tuple[tuple[int, int, int], ...] = ()
    extents: tuple[float, ...] = ()
    gaps: tuple[tuple[int, float], ...] = ()


def exported_rest(system: System, state: State, scenario: Scenario) -> ExportedRest:
    """Data for the equilibrium of a started system; empty where its start is another one.

    That is with assembled starts, closed loops, states of elements, clutches and pulsating loads.

    Parameters
    ----------
    system, state
        The started system and its initial state.
    scenario
        Scenario of the run.
    """
    drives = sum(len(system.records[kind]) for kind in system.kinds(DRIVE))
    held, driven = held_spins(system), driven_coordinates(system)
    unfit = scenario.start == "assembled" or system.states.size or system.sizes["nc"] != drives
    if unfit or system.kinds(CLUTCH) or system.sizes["nd"] > LARGEST or scenario.quasi_static is not None:
        return ExportedRest()
    if load_cycle(system, state, held, driven) is not None:
        return ExportedRest()
    spins = balancing_spins(system)
    let_go = exchange_all(system, held, spins, state) if spins else held
    kept = complete(system, driven, let_go) if spins else held
    times, weights, _ = cycle_instants(system, state)
    turning = [int(s) for s in np.unique(system.program["body"]["spin"]) if s >= 0]
    names = [system.names[LOAD][k] for k in balancing_loads(system)]
    return ExportedRest(
        _free(system, state, kept),
        _free(system, state, let_go),
        tuple(zip(spins, names, strict=True)),
        tuple(times.tolist()),
        tuple(weights.tolist()),
        tuple(turning),
        tuple(zip(*(part.tolist() for part in system.layout.entries), strict=True)),
        tuple(extents(system).tolist()),
        tuple(tooth_gaps(system).values()),
    )


def _free(system: System, state: State, held: tuple[int, ...]) -> tuple[int, ...]:
    """Coordinates that are not held, without those of bodies that fly freely."""
    free: NDArray[np.int64] = np.setdiff1d(np.arange(system.sizes["nd"]), held)
    if state.v.any():
        free = np.setdiff1d(free, free_flying(system))
    return tuple(free.tolist())
