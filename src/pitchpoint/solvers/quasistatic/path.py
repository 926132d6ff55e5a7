# SPDX-License-Identifier: Apache-2.0
"""Path of a slow roll: the rotated gear, the motion of the other bodies, the undeformed state."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import SINGULAR
from pitchpoint.core.words import listed
from pitchpoint.multibody.bodies import GENERAL, spin_of
from pitchpoint.solvers.constraints.assembly import close_loops
from pitchpoint.solvers.equilibrium.balancing import balancing_spins
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.gear_trains import (
    complete,
    driven_coordinates,
    exchange,
    held_spins,
    mesh_orders,
    rotations,
    tied_by_teeth,
    turning_rates,
    turning_spins,
)
from pitchpoint.solvers.locked_clutches import locked_clutches
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.system.meshes import mesh_names, mesh_record
from pitchpoint.system.system import State, System

LARGEST_RATIO = 10**6
"""Largest denominator of a speed ratio that is recovered from its rounded value."""


def turned_gear(system: System, mesh: int) -> tuple[int, int]:
    """Spin and number of teeth of the rotated gear of a mesh: the first of both that can rotate.

    A gear that springs and locked clutches leave free takes precedence.
    """
    record = mesh_record(system, mesh)
    bodies = [int(record[e]) for e in ("i", "j") if spin_of(system.program["body"], record[e]) >= 0]
    spins = [system.spin(system.layout.bodies[body]) for body in bodies]
    free = turning_spins(system) if len(bodies) > 1 else set(spins)
    k = next((k for k, spin in enumerate(spins) if spin in free), 0)
    z = record["z1"] if bodies[k] == record["i"] else record["z2"]
    return spins[k], abs(int(z))


def held_in_roll(system: System, mesh: int, state: State) -> tuple[int, ...]:
    """Held spins of a roll; the first one is rotated: that of the drive of the train, else of the mesh.

    Arguments: the system, the index of the mesh, and the state at the start.

    A held gear between the drive and the loads would take the load off the meshes on the side of the drive.
    Bodies with a balancing torque are held in the other trains.

    Raises
    ------
    SolverError
        If locked clutches hold both gears of the mesh.
    """
    locked = locked_clutches(system)
    if locked and turned_gear(system, mesh)[0] not in turning_spins(system):
        raise SolverError(
            f"mesh {mesh_names(system)[mesh]} cannot be rolled: its gears have no relative rotation while "
            f"{listed(locked)} {'is' if len(locked) == 1 else 'are'} locked; roll another mesh, or engage "
            "other clutches",
            SINGULAR,
        )
    spin, driving, driven = turned_gear(system, mesh)[0], held_spins(system), driven_coordinates(system)
    if is_looped(system):
        return (spin, *(h for h in exchange(system, driving, spin, state) if h != spin))
    driving = complete(system, driven, (*balancing_spins(system), *driving))
    held = exchange(system, driving, spin, state)
    freed = [h for h in driving if h not in held and h in driven]
    if len(freed) == 1 and rotations(system, freed)[spin, 0] != 0.0:
        return (*freed, *(h for h in driving if h not in freed))
    return (spin, *(h for h in held if h != spin))


def periods_per_turn(system: System, mesh: int, rates: Array) -> float:
    """Periods of a mesh per revolution of its rotated gear, reduced by the rotation of a carrier.

    In systems with closed loops, whose ratios vary, the rotation relative to the base of the gear counts.

    Parameters
    ----------
    system, mesh
        The system and the index of the mesh.
    rates
        Rates of all coordinates with that gear at 1 rad/s, shape (nd,).

    Raises
    ------
    SolverError
        If the mesh does not move.
    """
    if is_looped(system):
        return float(turned_gear(system, mesh)[1])
    name = mesh_names(system)[mesh]
    found = mesh_orders(system, rates)[name]
    if not found > 0.0:
        raise SolverError(f"mesh {name} cannot be rolled: its gears have no relative rotation", SINGULAR)
    return found


def pitches_of(system: System, mesh: int, rolled: tuple[int, int], ratio: float) -> Fraction | None:
    """Travel of a mesh in tooth pitches per period of the rolled mesh; exact, None through closed loops.

    `rolled`: the rotated spin and the index of its mesh.
    """
    record = mesh_record(system, mesh)
    for body in (record["i"], record["j"]):
        spin = spin_of(system.program["body"], body)
        if spin < 0 or not is_looped(system) or mesh == rolled[1]:
            continue
        if not tied_by_teeth(system, rolled[0], spin):
            return None
    return Fraction(ratio).limit_denominator(LARGEST_RATIO)


def rolled_on(system: System, state: State, spin: int, step: float, rates: Array, count: int = 1) -> State:
    """Copy of a state with one spin and its gear train rotated by steps, with the ratios in `rates`.

    In systems with closed loops the ratios are those of the present position, and the loops are closed again
    after every step.
    """
    if not is_looped(system):
        return _turn(system, state, count * step * rates)
    for _ in range(abs(count)):
        state = _through_loops(system, state, spin, step if count > 0 else -step)
    return state


def _through_loops(system: System, state: State, spin: int, step: float) -> State:
    """Copy of a state with one spin rotated by a step and the loops closed again."""
    along = turning_rates(system, state, spin)
    if not along.any():
        name = system.layout.coordinates[spin].rsplit(".", 1)[0]
        raise SolverError(f"{name} cannot be rotated further: closed loops lock it", SINGULAR, state)
    return _turn(
        system, close_loops(system, _turn(system, state, step * along), (spin,)), np.zeros(len(along))
    )


def _turn(system: System, state: State, by: Array) -> State:
    """Copy of a state with its coordinates advanced and spin angles wrapped."""
    new = state.copy()
    new.q += by
    for spin, body in system.program["spins"]:
        turns = round(new.q[spin] / (2.0 * np.pi))
        new.q[spin] -= 2.0 * np.pi * turns
        new.turns[body] += turns
    return new


def without_deflections(system: System, state: State, held: Sequence[int]) -> State:
    """Copy of a state with zero deflections of shafts in bearings; spins and closed loops are retained."""
    new = state.copy()
    for body in system.program["body"][1:]:
        if body["joint"] != GENERAL or not is_looped(system):
            own = np.arange(body["dof"], body["dof"] + body["n"])
            new.q[own[own != body["spin"]]] = 0.0
    return close_loops(system, new, held) if is_looped(system) else new
