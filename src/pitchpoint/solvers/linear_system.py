# SPDX-License-Identifier: Apache-2.0
"""The linear system about an operating point: matrices at rest and at speed, free directions, its modes.

What `modal`, `campbell` and `frequency_response` have in common; what the matrices mean stands in `modal`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.progress import Progress, silent
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.assembly import REDUNDANT
from pitchpoint.solvers.eigen import damped, damped_with_states, symmetric, undamped
from pitchpoint.solvers.element_tangents import inertial_stiffness, share_of
from pitchpoint.solvers.equilibrium import find_equilibrium
from pitchpoint.solvers.operating_point import OperatingPoint, operating_point
from pitchpoint.solvers.start import without_friction
from pitchpoint.solvers.stiffness_parts import NONE, Array, Parts, mesh_names, shift, split, touching
from pitchpoint.solvers.trains import driven_coordinates, held_spins, rotations
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

MOST_MODES = 300
"""Modes that are found if no number is asked for."""


@dataclass(frozen=True)
class Linearised:
    """Split matrices about an operating point, at rest and at speed, and what the user should know of it.

    Parameters
    ----------
    system, state
        Own copy of the system, and the operating point.
    at_rest
        Matrices and elements without speeds; its K has the centrifugal part of a steady rotation.
    D, K
        Damping and stiffness matrix at speed, shape (nd, nd).
    basis
        Directions that vibrate: columns, shape (nd, n).
    states
        Coordinates whose rates are states of force elements.
    held
        Spins that keep the operating point where it is.
    notes
        Sentences.
    """

    system: System
    state: State
    at_rest: Parts
    D: Array
    K: Array
    basis: Array
    states: tuple[int, ...]
    held: tuple[int, ...]
    notes: tuple[str, ...]


def _without_friction(point: OperatingPoint) -> OperatingPoint:
    """The same point with frictionless flanks, and a note if that changes something."""
    smooth = without_friction(point.system)
    if smooth is point.system:
        return point
    note = "friction of the flanks is left out of the modes; it belongs to the motion, not to a state"
    return replace(point, system=smooth, notes=(*point.notes, note))


def linearise(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    phase: float | None = None,
    mean: bool = True,
    start: State | None = None,
    progress: Progress = silent,
) -> Linearised:
    """Matrices about the loaded state of a scenario; arguments as in `modal.find_modes`."""
    point = _without_friction(operating_point(system, scenario, start))
    own, state = point.system.copy(), point.state
    if phase is not None:
        state = _at_phase(own, state, phase, point.held)
    loose = touching(own, state)
    notes = [*point.notes, *_of_one_position(own, state)]
    if loose:
        notes.append(
            f"no load presses the flanks of {', '.join(loose)} together: "
            "they are taken as touching, on the front if nothing leans on the back"
        )
    still = state.copy()
    still.v[:] = 0.0
    at_rest = split(own, still, point.held, mean and phase is None, loose, progress)
    D = at_rest.D + evaluate.matrix(own, state, 0.0, 1.0, 0.0) - evaluate.matrix(own, still, 0.0, 1.0, 0.0)
    K = at_rest.K + evaluate.matrix(own, state, 0.0, 0.0, 1.0) - evaluate.matrix(own, still, 0.0, 0.0, 1.0)
    if state.v.any():
        at_rest = _turning(own, state, still, at_rest)
    states = tuple(int(s) for s in own.states)
    basis = free_directions(own, state, states)
    return Linearised(own, state, at_rest, D, K, basis, states, point.held, tuple(notes))


def _of_one_position(system: System, state: State) -> tuple[str, ...]:
    """A note on elastic bodies whose modes turn: their matrices change as they do."""
    body = system.program["body"]
    frames = [int(record["i"]) for record in system.records.get("flexible_body", ())]
    turning = [
        system.layout.bodies[b] for b in frames if body[b]["spin"] >= 0 and state.v[body[b]["spin"]] != 0.0
    ]
    if not turning:
        return ()
    return (
        f"the modes of {', '.join(turning)} turn with the body: what is found holds for one position of it; "
        "elastic shafts hold for all",
    )


def _turning(system: System, state: State, still: State, at_rest: Parts) -> Parts:
    """Add what a steady rotation does to the stiffness by inertia, as one more part."""
    more = symmetric(inertial_stiffness(system, state, still))
    if np.abs(more).max(initial=0.0) <= NONE * np.abs(at_rest.K).max(initial=0.0):
        return at_rest
    return replace(
        at_rest,
        K=at_rest.K + more,
        elements=(*at_rest.elements, "steady rotation"),
        kinds=(*at_rest.kinds, "rotation"),
        bodies=np.vstack([at_rest.bodies, np.zeros((1, 2), np.int64)]),
        shares=(*at_rest.shares, share_of(more)),
    )


def _at_phase(system: System, state: State, phase: float, held: tuple[int, ...]) -> State:
    """Put every mesh at one phase; the records of the system change."""
    for _ in range(4):  # the deflection of the new place moves the phase a little
        values = evaluate.observe(system, state)
        for name, record in zip(mesh_names(system), system.records.get("gear_mesh", ()), strict=True):
            shift(record, phase - float(values[system.layout.channel(f"mesh_phase[{name}]")]))
        rest = find_equilibrium(system, state, held).state
        rest.v[:] = state.v
        state = rest
    return state


def free_directions(system: System, state: State, states: Sequence[int] = ()) -> Array:
    """Columns that span what constraint rows leave free, without the states of elements, shape (nd, n)."""
    nd = system.sizes["nd"]
    mechanical = np.setdiff1d(np.arange(nd), np.array(states, np.int64))
    if system.sizes["nc"] == 0:
        return np.eye(nd)[:, mechanical]
    G = evaluate.constraint_jacobian(system, state)[:, mechanical]
    fixed = np.flatnonzero(np.abs(G).sum(axis=0) > 0.0)
    if np.count_nonzero(G) == np.linalg.matrix_rank(G) == fixed.size:
        return np.eye(nd)[:, np.delete(mechanical, fixed)]  # rows that each hold one coordinate
    weight = system.weight[mechanical]
    _, values, rows = np.linalg.svd(G / weight)
    rank = int(np.sum(values > REDUNDANT * values[0]))
    whole = np.zeros((nd, mechanical.size - rank))
    whole[mechanical] = (rows[rank:] / weight).T
    return whole


def rigid_rotations(system: System) -> Array:
    """Turns of the spins that nothing resists: one row per free train that nothing drives, shape (r, nd)."""
    return rotations(system, held_spins(system)[len(driven_coordinates(system)) :]).T


def lowest(linear: Linearised, count: int | None = None) -> tuple[Array, Array, tuple[str, ...]]:
    """Undamped modes, lowest first: circular frequencies, shapes, and a sentence if some were left out."""
    parts = linear.at_rest
    omega, shapes = undamped(parts.M, parts.K, linear.basis, rigid_rotations(linear.system))
    most = MOST_MODES if count is None else count
    left_out = count is None and len(omega) > most
    note = (f"the lowest {most} of {len(omega)} modes; ask for a number of modes to see more",)
    return omega[:most], shapes[:most], note if left_out else ()


def damped_modes(
    linear: Linearised, omega: Array, shapes: Array
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Eigenvalues at speed, those of states last, and their shapes over the coordinates."""
    left = linear.K - symmetric(linear.at_rest.K)
    if linear.states:
        return damped_with_states(linear.at_rest.M, linear.D, linear.K, shapes, omega, linear.states, left)
    values, z = damped(linear.D, left, shapes, omega)
    return values, np.asarray(z.T @ shapes, dtype=np.complex128)
