# SPDX-License-Identifier: Apache-2.0
"""Initial bristle deflections of sticking clutches and brakes, so that they carry the load from the start.

The bristle deflection of a sticking clutch is not determined by its own equilibrium. It follows from the
torques of the trains on both sides: each train without drive is balanced by its clutches and its balancing
torque; if both can balance it, the balancing torque does. (A slipping clutch has a unique deflection, which
`find_equilibrium` computes.)
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pitchpoint.contact.bristle import stribeck
from pitchpoint.core.kernel import plain
from pitchpoint.elements import friction_clutch, torque
from pitchpoint.elements.friction_clutch import BRISTLE
from pitchpoint.multibody.bodies import spin_of
from pitchpoint.solvers.equilibrium.balancing import balancing_loads
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.equilibrium.solve import Equilibrium, find_equilibrium
from pitchpoint.solvers.gear_trains import rotations
from pitchpoint.system import evaluate
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.system import State, System

CLUTCH, LOAD = friction_clutch.KIND.name, torque.KIND.name
STICKS = 1e-9
"""Relative slip up to which a clutch sticks."""
BALANCED = 1e-9
"""Residual torque over the largest torque up to which trains count as balanced."""
MAX_PASSES = 4
UNWANTED = 1e-6
"""Weight of clutch torques relative to balancing torques in the balance of a train."""


def settle_clutches(
    system: System, found: Equilibrium, driven: Sequence[int], balanced: Sequence[int]
) -> tuple[System, Equilibrium, tuple[str, ...]]:
    """Adjust bristle deflections of sticking clutches and balancing torques until the trains are balanced.

    Parameters
    ----------
    system
        The system with its balancing torques.
    found
        Its equilibrium, with a spin of every train held.
    driven
        Coordinates with prescribed motion, whose reactions are carried by their drives.
    balanced
        Spins of the bodies with a balancing torque.

    Returns
    -------
    tuple
        The system with its torques, its equilibrium, and notes on overloaded clutches.
    """
    held = list(found.held)
    rows = [k for k, spin in enumerate(held) if spin not in set(driven)]
    names = system.layout.bodies
    clutches = [
        (number, record)
        for number, record in _bristles(system)
        if abs(_slip(system, found.state, record)) <= STICKS * _speed(found.state)
    ]
    if not clutches or not rows or is_looped(system):
        return system, found, ()
    places = [_place(system, number) for number, _ in clutches]
    limits = np.array([float(record["ratio"]) for _, record in clutches])
    loads = balancing_loads(system) if balanced else []
    turning = rotations(system, held)[:, rows]
    for _ in range(MAX_PASSES):
        left = found.reaction[rows]
        if float(np.abs(left).max()) <= BALANCED * max(1.0, _largest(system)):
            break
        slopes = evaluate.matrix(system, found.state, 0.0, 1.0, 0.0, NEWTON)[:, places]
        by_load = [-turning[_spin(system, system.records[LOAD][k])] for k in loads]
        A = np.column_stack([UNWANTED * turning.T @ slopes, *by_load])
        change = np.linalg.lstsq(A, -left, rcond=1e-12)[0]
        state = found.state.copy()
        state.v[places] = np.clip(state.v[places] + UNWANTED * change[: len(places)], -limits, limits)
        if loads:
            records = system.records[LOAD].copy()
            records["value"][loads] += change[len(places) :]
            system = system.with_params({LOAD: records})
        found = find_equilibrium(system, state, held)
    notes = tuple(
        f"the clutch between {names[int(record['i'])]} and {names[int(record['j'])]} cannot hold its load "
        "and begins to slip: increase its capacity if this is not intended"
        for (_, record), place, limit in zip(clutches, places, limits, strict=True)
        if abs(found.state.v[place]) >= limit
    )
    return system, found, notes


def slipping_clutches(system: System, state: State) -> State:
    """Copy of a state in which clutches and brakes that slip have the deflection of steady slip.

    Without deflection, as assembled, the damping of the bristles would act with the whole slip speed: a
    torque of many times the capacity for the first milliseconds.
    """
    found = state.copy()
    for number, record in _bristles(system):
        slip = _slip(system, state, record)
        if abs(slip) > STICKS * _speed(state) and state.v[_place(system, number)] == 0.0:
            steady, _ = plain(stribeck)(slip, float(record["ratio"]), float(record["v_s"]))
            found.v[_place(system, number)] = np.copysign(steady, slip)
    return found


def _bristles(system: System) -> list[tuple[int, np.void]]:
    """Index and record of every clutch with bristles."""
    records = system.records.get(CLUTCH, ())
    return [(k, r) for k, r in enumerate(records) if int(r["sticking"]) == BRISTLE]


def _place(system: System, number: int) -> int:
    """Coordinate whose rate is the deflection of a clutch."""
    return int(system.program["body"][int(system.records[CLUTCH][number]["k"])]["spin"])


def _spin(system: System, record: np.void) -> int:
    """Spin of the body on which a torque acts."""
    return spin_of(system.program["body"], int(record["i"]))


def _slip(system: System, state: State, record: np.void) -> float:
    """Speed of the first body of a clutch relative to the second [rad/s]."""
    return float(evaluate.observe(system, state)[int(record["out"]) + 1])


def _speed(state: State) -> float:
    return max(1.0, float(np.abs(state.v).max(initial=0.0)))


def _largest(system: System) -> float:
    """Largest applied torque [N m]."""
    return max((abs(float(record["value"])) for record in system.records.get(LOAD, ())), default=0.0)
