# SPDX-License-Identifier: Apache-2.0
"""Linearization about an operating point: matrices at rest and at speed, free directions, modes.

Used by `modal`, `campbell` and `frequency_response`; `modal` describes the matrices.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError, SolverError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import SINGULAR
from pitchpoint.core.units import format_quantity
from pitchpoint.core.words import listed
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.constraints.free_directions import free_directions
from pitchpoint.solvers.cycle_means import shift
from pitchpoint.solvers.eigen import damped, damped_with_states, symmetric, undamped
from pitchpoint.solvers.element_tangents import inertial_stiffness, share_of, without_friction
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.gear_trains import rigid_rotations
from pitchpoint.solvers.initial_state.speeds import body_rates
from pitchpoint.solvers.load_orders import of_one_angle
from pitchpoint.solvers.locked_clutches import overload_notes
from pitchpoint.solvers.modes.sparse import lowest_modes, nearest_damped
from pitchpoint.solvers.operating_point import OperatingPoint, scenario_named, steady_point
from pitchpoint.solvers.position_dependence import changing
from pitchpoint.solvers.stiffness_parts import NONE, Array, Parts, split
from pitchpoint.solvers.unloaded_flanks import TOUCH, close_backlash, touches_at_one_end
from pitchpoint.system import evaluate
from pitchpoint.system.elastic import modal_bodies
from pitchpoint.system.meshes import mesh_names, mesh_records
from pitchpoint.system.system import State, System

MAX_MODES = 200
"""Largest system (number of modes) for which all modes are computed by default."""
LOWEST = 40
"""Default number of modes of larger systems."""
DENSE = 1200
"""Largest number of unknowns of first order, of a large system with states, for which all eigenvalues are
computed, so that those of the states are complete."""
FEW_STATES = 50
"""Number of states up to which iterations for the lowest modes take less time."""
SPARSE = 0.3
"""Share of the modes up to which they are computed iteratively."""

MAX_COORDINATES = 20_000
"""Largest number of coordinates of a linear system; each matrix then takes three gigabytes."""
ONE_POSITION = "hold for one position of it"
"""Words of the notes on bodies that rotate and are not of revolution."""
ACCURATE = 1e-4
"""Relative rounding error of a natural frequency above which it is noted."""


@dataclass(frozen=True)
class Linearised:
    """Matrices about an operating point, at rest and at speed, with notes for the user.

    Parameters
    ----------
    system, state
        Copy of the system, and the operating point.
    at_rest
        Matrices by element at zero speed; K includes the centrifugal part of a steady rotation.
    D, K
        Damping and stiffness matrix at speed, shape (nd, nd).
    basis
        Free directions: columns, shape (nd, n), sparse if the system is large.
    rigid
        Unconstrained rigid rotations, shape (r, nd).
    states
        Coordinates whose rates are states of force elements.
    held
        Spins held at the operating point.
    flanks
        Flanks assumed in contact by unloaded mesh: 1 front, -1 back.
    notes
        Notes for the user.
    at
        Which state of a sweep this is, in words; else empty.
    axes
        Multi-blade coordinates (`turning_rotors.TurningRotors`) if the matrices are in them.
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
    flanks: Mapping[str, int]
    notes: tuple[str, ...]
    at: str = ""
    axes: Any = None


def _frictionless_point(
    system: System, scenario: Scenario | str | None, start: State | None, turning: str | None
) -> OperatingPoint:
    """The operating point with frictionless flanks, and a note if the flanks have friction.

    The other positions and speeds of the analysis (mesh phases, speeds of a Campbell diagram) are equilibria
    of the frictionless machine, so the operating point must be one, too. Torques that pulsate with the angle
    of rotating bodies enter with their mean.
    """
    smooth = without_friction(system)
    point, pulsating = steady_point(smooth, scenario, start, turning)
    notes = []
    if pulsating:
        notes.append(
            f"{listed(list(pulsating))}: the mean torque over the angle is used; its slope has the mean zero"
        )
    elif still := of_one_angle(smooth, point.state):
        notes.append(
            f"{listed(list(still))}: the slope of the torque at the present angle acts as a spring; for the "
            "rotating body select a scenario with its speed"
        )
    if smooth is not system:
        notes.append(
            "flank friction is neglected in the modes, since it depends on the motion, not on the state"
        )
    return replace(point, notes=(*point.notes, *notes))


def linearise(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    phase: float | None = None,
    mean: bool = True,
    start: State | None = None,
    turning: str | None = None,
    progress: Progress = silent,
    settled: bool = True,
) -> Linearised:
    """Linearize about the loaded state of a scenario; arguments as in `modal.find_modes`.

    `turning`: the body that rotates in an analysis over the speed, if the scenario is at rest; `settled`: as
    in `cycle_means`.
    """
    if (count := system.sizes["nd"]) == 0:
        raise SolverError(
            "all bodies are fixed, so there are no modes; free a body (motion: torsion, planar or free)",
            SINGULAR,
        )
    if count > MAX_COORDINATES:
        raise CompileError(
            f"the machine has {count} coordinates, and each matrix of the linear system would take "
            f"{8e-9 * count**2:.2g} GB (limit {MAX_COORDINATES} coordinates); analyse parts of it "
            "separately, or reduce the freedom of bodies (motion: torsion or planar) and the number of shaft "
            "pieces (largest_piece)"
        )
    point = _frictionless_point(system, scenario, start, turning)
    own, state = point.system.copy(), point.state
    if phase is not None:
        state = _at_phase(own, state, phase, point.held)
    loose = close_backlash(own, state)
    notes = [*point.notes, *_of_one_position(own, state), *overload_notes(own, state)]
    if loose:
        notes.append(_of_assumed_flanks(loose))
        notes += _of_arbitrary_stiffness(own, loose)
    stopped = state.copy()
    stopped.v[:] = 0.0
    at_rest = split(own, stopped, point.held, mean and phase is None, loose, progress, state.v, settled)
    D = at_rest.D + evaluate.matrix(own, state, 0.0, 1.0, 0.0) - evaluate.matrix(own, stopped, 0.0, 1.0, 0.0)
    K = at_rest.K + evaluate.matrix(own, state, 0.0, 0.0, 1.0) - evaluate.matrix(own, stopped, 0.0, 0.0, 1.0)
    basis = free_directions(own, state, own.states.tolist())
    # those of locked clutches act on nothing
    states = tuple(int(s) for s in own.states if D[s].any() or D[:, s].any() or K[s].any() or K[:, s].any())
    rigid = rigid_rotations(own)
    if state.v.any():
        at_rest = _turning(own, state, stopped, at_rest, rigid)
    return Linearised(
        own, state, at_rest, D, K, basis, rigid, states, point.held, loose, tuple(notes), point.at
    )


def rates_of(linear: Linearised, body: str, scenario: Scenario | str | None) -> Array:
    """Rates of all coordinates with one body at 1 rad/s, in the direction of the operating point."""
    rates = body_rates(linear.system, body, scenario_named(linear.system, scenario))
    spin = linear.system.spin(body)
    return -rates if rates[spin] * linear.state.v[spin] < 0.0 else rates


def _of_assumed_flanks(loose: Mapping[str, int]) -> str:
    """Note on the flanks that are assumed in contact in unloaded meshes."""
    front, back = (", ".join(m for m, flank in loose.items() if flank == sense) for sense in (1, -1))
    sides = " and ".join(
        f"the {side} of {names}" for side, names in (("front", front), ("back", back)) if names
    )
    return (
        f"the flanks of {', '.join(loose)} carry no load: contact is assumed at {sides}, "
        "as for a small torque through the train"
    )


def _of_arbitrary_stiffness(system: System, loose: Mapping[str, int]) -> list[str]:
    """Note on unloaded meshes whose stiffness grows with the load: at first contact it is zero."""
    records = zip(mesh_names(system), mesh_records(system), strict=True)
    names = [
        name
        for name, record in records
        if name in loose and (record["contact"]["power"] > 1.0 or touches_at_one_end(record, loose[name]))
    ]
    if not names:
        return []
    return [
        f"the stiffness of {', '.join(names)} grows with the load from zero at first contact. Without a load "
        f"the value at {1e9 * TOUCH:g} nm of penetration is used, and the frequencies of modes that deform "
        "these flanks are arbitrary: give the scenario a load that presses them together"
    ]


def _of_one_position(system: System, state: State) -> tuple[str, ...]:
    """Notes on rotating elastic bodies, and on other bodies whose inertia changes with their angle."""
    body, names = system.program["body"], system.layout.bodies
    elastic = modal_bodies(system, frames=True)
    turning = [names[b] for b in sorted(elastic) if body[b]["spin"] >= 0 and state.v[body[b]["spin"]] != 0.0]
    notes = []
    if turning:
        notes.append(
            f"the modes of {', '.join(turning)} rotate with the body: the results {ONE_POSITION}; "
            "elastic shafts have no such limit"
        )
    elif state.v.any() and not elastic:
        moving = changing(system, state, {}, state.v / np.abs(state.v).max())[1]
        if moving:
            notes.append(
                f"the inertia of {', '.join(names[b] for b in moving)} changes as it rotates: the results "
                f"{ONE_POSITION}"
            )
    return tuple(notes)


def _turning(system: System, state: State, stopped: State, at_rest: Parts, rigid: Array) -> Parts:
    """Add the centrifugal stiffness of a steady rotation as one more part."""
    more = inertial_stiffness(system, state, stopped, rigid)
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
    """Set every mesh to one phase; changes the records of the system."""
    for _ in range(4):  # the new deflection changes the phase slightly
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
        Circular frequencies [rad/s] (n,) and mass-normalised shapes (n, nd) of the requested modes.
    total
        Number of modes of the system.
    notes
        A note if modes were omitted by default.
    whole
        All modes of a small system, (omega, shapes), as a basis of the damped modes.
    """

    omega: Array
    shapes: Array
    total: int
    notes: tuple[str, ...]
    whole: tuple[Array, Array] | None


def omitted_note(found: int, total: int) -> str:
    """Note on modes that are not computed by default."""
    return f"the lowest {found} of {total} modes: give a number of modes to get more"


def lowest(linear: Linearised, count: int | None = None) -> Undamped:
    """Undamped modes, lowest first: all of systems with up to `MAX_MODES`, or as many as are requested."""
    parts, rigid = linear.at_rest, linear.rigid
    total = linear.basis.shape[1]
    wanted = total if total <= MAX_MODES else LOWEST
    wanted = min(wanted if count is None else count, total)
    notes = (omitted_note(wanted, total),) if count is None and wanted < total else ()
    if total > MAX_MODES and wanted < SPARSE * total:
        found = lowest_modes(parts.M, parts.K, _sparse(linear.basis), rigid, wanted)
        return Undamped(*found, total, notes, None)
    basis = linear.basis if isinstance(linear.basis, np.ndarray) else linear.basis.toarray()
    omega, shapes = undamped(parts.M, parts.K, basis, rigid)
    notes = (*notes, *_rounding(linear, omega[:wanted], omega, shapes))
    return Undamped(omega[:wanted], shapes[:wanted], total, notes, (omega, shapes))


def _rounding(linear: Linearised, listed: Array, omega: Array, shapes: Array) -> tuple[str, ...]:
    """Note on frequencies that are inaccurate because parts of almost no mass vibrate far above them.

    The rounding error of an eigenvalue is that of the largest one, `eps` omega_max^2: relative to the
    frequency omega it is eps (omega_max/omega)^2/2.
    """
    highest = float(omega.max(initial=0.0))
    limit = highest * math.sqrt(0.5 * np.finfo(float).eps / ACCURATE)
    slow = np.abs(listed)[(listed != 0.0) & (np.abs(listed) < limit)]
    if not slow.size:
        return ()
    worst = 0.5 * np.finfo(float).eps * (highest / float(slow.min())) ** 2
    most = f"up to {100.0 * worst:.2g} %" if worst < 1.0 else "the lowest have no correct digit"
    shape = shapes[int(np.argmax(omega))]
    energy = np.abs(shape * (linear.at_rest.M @ shape))
    at = linear.system.layout.coordinates[int(np.argmax(energy))]
    below, above = (format_quantity(x / math.tau, "frequency", 3) for x in (limit, highest))
    return (
        f"natural frequencies below {below} have rounding errors of more than {100.0 * ACCURATE:g} %, "
        f"{most}, because {at} vibrates at {above}; give it more mass or density",
    )


def _sparse(basis: Any) -> Any:
    """The basis as a sparse matrix."""
    from scipy.sparse import csc_array

    return csc_array(basis)


@dataclass(frozen=True)
class Damped:
    """Damped modes in the order of the undamped ones, and other eigenvalues of states.

    Parameters
    ----------
    values, shapes
        Eigenvalues [1/s] (m,) and shapes (m, nd).
    states
        Other eigenvalues in which states of force elements take part [1/s], in ascending order.
    reach
        Absolute value up to which these are complete [1/s].
    """

    values: NDArray[np.complex128]
    shapes: NDArray[np.complex128]
    states: NDArray[np.complex128]
    reach: float = math.inf


def damped_modes(linear: Linearised, modes: Undamped, complete: bool = False) -> Damped:
    """Modes and eigenvalues of states at speed; `complete`: those of all states, up to `DENSE` unknowns."""
    M, D, K = linear.at_rest.M, linear.D, linear.K
    left = K - symmetric(linear.at_rest.K)
    none = np.zeros(0, np.complex128)
    if modes.whole is None and _is_undamped(linear, modes, left):
        return Damped(1j * modes.omega.astype(np.complex128), modes.shapes.astype(np.complex128), none)
    whole = modes.whole
    if whole is None:
        basis = _sparse(linear.basis)
        states = len(linear.states)
        few = states <= (0 if complete else FEW_STATES)
        if few or 2 * modes.total + states > DENSE:
            found = nearest_damped((M, D, K), basis, linear.rigid, linear.states, modes.omega, modes.shapes)
            return Damped(*found)
        whole = undamped(M, linear.at_rest.K, basis.toarray(), linear.rigid)
    omega, shapes = whole
    m = len(modes.omega)
    if linear.states:
        values, z, rest = damped_with_states(M, D, K, shapes, omega, linear.states, left)
        return Damped(values[:m], z[:m], rest)
    values, z = damped(D, left, shapes, omega)
    return Damped(values[:m], np.asarray(z.T[:m] @ shapes, dtype=np.complex128), none)


def _is_undamped(linear: Linearised, modes: Undamped, left: Array) -> bool:
    """Whether the damped modes equal the undamped ones: a stable system without damping and states."""
    if linear.states or np.any(modes.omega < 0.0) or linear.D.any():
        return False
    return bool(np.abs(left).max(initial=0.0) <= NONE * np.abs(linear.at_rest.K).max(initial=0.0))
