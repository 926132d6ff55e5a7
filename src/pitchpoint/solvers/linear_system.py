# SPDX-License-Identifier: Apache-2.0
"""The linear system about an operating point: matrices at rest and at speed, free directions, its modes.

What `modal`, `campbell` and `frequency_response` have in common; `modal` describes the matrices.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError, SolverError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import SINGULAR
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.constraints.free_directions import free_directions
from pitchpoint.solvers.cycle_means import shift
from pitchpoint.solvers.eigen import damped, damped_with_states, symmetric, undamped
from pitchpoint.solvers.element_tangents import inertial_stiffness, share_of, without_friction
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.gear_trains import rigid_rotations
from pitchpoint.solvers.operating_point import OperatingPoint, operating_point
from pitchpoint.solvers.position_dependence import changing
from pitchpoint.solvers.sparse_modes import lowest_modes, nearest_damped
from pitchpoint.solvers.stiffness_parts import NONE, Array, Parts, split
from pitchpoint.solvers.unloaded_flanks import TOUCH, close_backlash
from pitchpoint.system import evaluate
from pitchpoint.system.elastic import modal_bodies
from pitchpoint.system.meshes import mesh_names, mesh_records
from pitchpoint.system.system import State, System

MOST_MODES = 200
"""Modes up to which a system has all of them found if no number is given."""
LOWEST = 40
"""Modes that are found of a larger one."""
SPARSE = 0.3
"""Share of its modes up to which they are found one by one."""

MOST_COORDINATES = 20_000
"""Coordinates up to which there are matrices of the linear system, three gigabytes each."""


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
        Directions that vibrate: columns, shape (nd, n), sparse if the system is large.
    rigid
        Turns that nothing resists, shape (r, nd).
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
    basis: Any
    rigid: Array
    states: tuple[int, ...]
    held: tuple[int, ...]
    notes: tuple[str, ...]


def _frictionless_point(
    system: System, scenario: Scenario | str | None, start: State | None
) -> OperatingPoint:
    """The operating point with frictionless flanks, and a note if that changes something.

    The machine has to rest there without friction too: every other position or speed that the matrices are
    taken at (phases of a mesh, the speeds of a diagram) is an equilibrium of the frictionless machine.
    """
    smooth = without_friction(system)
    point = operating_point(smooth, scenario, start)
    if smooth is system:
        return point
    note = "friction of the flanks is neglected in the modes; it depends on the motion, not on a state"
    return replace(point, notes=(*point.notes, note))


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
    if (count := system.sizes["nd"]) == 0:
        raise SolverError(
            "all bodies are fixed, so nothing can vibrate; let a body move (motion: torsion, planar or free)",
            SINGULAR,
        )
    if count > MOST_COORDINATES:
        raise CompileError(
            f"the machine has {count} coordinates, and each matrix of the linear system would take "
            f"{8e-9 * count**2:.2g} GB (limit {MOST_COORDINATES} coordinates); compute parts of it apart, or "
            "give bodies less freedom (motion: torsion or planar) and shafts fewer pieces (largest_piece)"
        )
    point = _frictionless_point(system, scenario, start)
    own, state = point.system.copy(), point.state
    if phase is not None:
        state = _at_phase(own, state, phase, point.held)
    loose = close_backlash(own, state)
    notes = [*point.notes, *_of_one_position(own, state)]
    if loose:
        notes.append(_of_assumed_flanks(loose))
        notes += _of_arbitrary_stiffness(own, loose)
    stopped = state.copy()
    stopped.v[:] = 0.0
    at_rest = split(own, stopped, point.held, mean and phase is None, loose, progress, state.v)
    D = at_rest.D + evaluate.matrix(own, state, 0.0, 1.0, 0.0) - evaluate.matrix(own, stopped, 0.0, 1.0, 0.0)
    K = at_rest.K + evaluate.matrix(own, state, 0.0, 0.0, 1.0) - evaluate.matrix(own, stopped, 0.0, 0.0, 1.0)
    if state.v.any():
        at_rest = _turning(own, state, stopped, at_rest)
    states = tuple(int(s) for s in own.states)
    basis = free_directions(own, state, states)
    rigid = rigid_rotations(own)
    return Linearised(own, state, at_rest, D, K, basis, rigid, states, point.held, tuple(notes))


def _of_assumed_flanks(loose: Mapping[str, int]) -> str:
    """Note on the flanks at which unloaded meshes are taken."""
    front, back = (", ".join(m for m, flank in loose.items() if flank == sense) for sense in (1, -1))
    sides = " and ".join(
        f"the {side} of {names}" for side, names in (("front", front), ("back", back)) if names
    )
    return (
        f"no load presses the flanks of {', '.join(loose)} together: they are taken as touching at {sides}, "
        "as a small torque through the train presses them"
    )


def _of_arbitrary_stiffness(system: System, loose: Collection[str]) -> list[str]:
    """Note on unloaded meshes whose stiffness grows with the load: at the point of touch they have none."""
    records = zip(mesh_names(system), mesh_records(system), strict=True)
    names = [name for name, record in records if name in loose and record["contact"]["power"] > 1.0]
    if not names:
        return []
    return [
        f"the stiffness of {', '.join(names)} is zero where the flanks touch and grows with the load: "
        f"without one it is that at {1e9 * TOUCH:g} nm of penetration, and frequencies in which these flanks "
        "take part are arbitrary; give the scenario a load that presses them together"
    ]


def _of_one_position(system: System, state: State) -> tuple[str, ...]:
    """Notes on elastic bodies whose modes turn, and on other bodies whose inertia changes as they turn."""
    body, names = system.program["body"], system.layout.bodies
    elastic = modal_bodies(system, frames=True)
    turning = [names[b] for b in sorted(elastic) if body[b]["spin"] >= 0 and state.v[body[b]["spin"]] != 0.0]
    notes = []
    if turning:
        notes.append(
            f"the modes of {', '.join(turning)} turn with the body: what is found holds for one position of "
            "it; elastic shafts hold for all"
        )
    elif state.v.any() and not elastic:
        moving = changing(system, state, {}, state.v / np.abs(state.v).max())[1]
        if moving:
            notes.append(
                f"the inertia of {', '.join(names[b] for b in moving)} changes as it turns: what is found "
                "holds for one position of it"
            )
    return tuple(notes)


def _turning(system: System, state: State, stopped: State, at_rest: Parts) -> Parts:
    """Add what a steady rotation does to the stiffness by inertia, as one more part."""
    more = symmetric(inertial_stiffness(system, state, stopped))
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
        for name, record in zip(mesh_names(system), mesh_records(system), strict=True):
            shift(record, phase - float(values[system.layout.channel(f"mesh_phase[{name}]")]))
        rest = find_equilibrium(system, state, held).state
        rest.v[:] = state.v
        state = rest
    return state


@dataclass(frozen=True)
class Undamped:
    """Undamped modes, lowest first.

    Parameters
    ----------
    omega, shapes
        Circular frequencies [rad/s] (n,) and shapes with modal mass 1 (n, nd): the requested ones.
    total
        Number of modes that there are.
    notes
        A sentence if modes were omitted without a request.
    whole
        All modes of a small system, (omega, shapes); the damped ones are made of them.
    """

    omega: Array
    shapes: Array
    total: int
    notes: tuple[str, ...]
    whole: tuple[Array, Array] | None


def lowest(linear: Linearised, count: int | None = None) -> Undamped:
    """Undamped modes, lowest first: all of systems with up to `MOST_MODES`, or as many as are requested."""
    parts, rigid = linear.at_rest, linear.rigid
    total = linear.basis.shape[1]
    wanted = total if total <= MOST_MODES else LOWEST
    wanted = min(wanted if count is None else count, total)
    note = (f"the lowest {wanted} of {total} modes; give a number of modes to see more",)
    notes = note if count is None and wanted < total else ()
    if total > MOST_MODES and wanted < SPARSE * total:
        found = lowest_modes(parts.M, parts.K, _sparse(linear.basis), rigid, wanted)
        return Undamped(*found, total, notes, None)
    basis = linear.basis if isinstance(linear.basis, np.ndarray) else linear.basis.toarray()
    omega, shapes = undamped(parts.M, parts.K, basis, rigid)
    return Undamped(omega[:wanted], shapes[:wanted], total, notes, (omega, shapes))


def _sparse(basis: Any) -> Any:
    """The same columns, sparse."""
    from scipy.sparse import csc_array

    return csc_array(basis)


def damped_modes(
    linear: Linearised, modes: Undamped
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Eigenvalues at speed in the order of the undamped modes, those of states last, and their shapes."""
    M, D, K = linear.at_rest.M, linear.D, linear.K
    left = K - symmetric(linear.at_rest.K)
    if modes.whole is None and _is_undamped(linear, modes, left):
        return np.asarray(1j * modes.omega, np.complex128), modes.shapes.astype(np.complex128)
    if modes.whole is None:
        return nearest_damped((M, D, K), _sparse(linear.basis), linear.states, modes.omega, modes.shapes)
    omega, shapes = modes.whole
    if linear.states:
        values, found = damped_with_states(M, D, K, shapes, omega, linear.states, left)
    else:
        values, z = damped(D, left, shapes, omega)
        found = np.asarray(z.T @ shapes, dtype=np.complex128)
    own = np.r_[: len(modes.omega), len(omega) : len(values)]
    return values[own], found[own]


def _is_undamped(linear: Linearised, modes: Undamped, left: Array) -> bool:
    """Whether nothing distinguishes the damped modes of a stable system from the undamped ones."""
    if linear.states or np.any(modes.omega < 0.0) or linear.D.any():
        return False
    return bool(np.abs(left).max(initial=0.0) <= NONE * np.abs(linear.at_rest.K).max(initial=0.0))
