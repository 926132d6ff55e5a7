# SPDX-License-Identifier: Apache-2.0
"""Modes about an operating point: frequencies, damping, shapes, energies, names.

M x'' + D x' + K x = 0 with the derivatives of the residual at the loaded state, exact but for the phase of
the meshes, which is held: they count with the mean of their stiffness over the mesh cycle, or with the value
at one phase. Undamped modes are those at rest, with the symmetric part of K; damped ones carry dampers, the
gyroscopic terms of the speeds and the whole K. A torque that follows its tilting body makes K unsymmetric
and can feed energy into modes that nothing damps. Friction of the flanks is left out of both. Rayleigh and
modal damping are made at the phase where the scenario starts.

Mechanisms vibrate in the directions that their loops leave free, with the reactions of the loops in K. Where
bodies hang in trees, what a steady rotation adds by inertia (centrifugal forces) belongs to the stiffness of
the undamped modes; the operating point then is the relative equilibrium, all rates steady. States of force
elements are held for the undamped modes and free for the damped ones.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.progress import Progress, silent
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.assembly import REDUNDANT
from pitchpoint.solvers.body_shapes import DIRECTIONS, base_vectors, body_motions, participation
from pitchpoint.solvers.eigen import damped, damped_with_states, ratio_of, symmetric, undamped
from pitchpoint.solvers.element_tangents import inertial_stiffness, share_of, state_coordinates
from pitchpoint.solvers.equilibrium import find_equilibrium
from pitchpoint.solvers.mode_names import mode_names
from pitchpoint.solvers.operating_point import OperatingPoint, operating_point
from pitchpoint.solvers.start import without_friction
from pitchpoint.solvers.stiffness_parts import NONE, Array, Parts, mesh_names, shift, split, touching
from pitchpoint.solvers.trains import driven_coordinates, held_spins, rotations
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    import xarray as xr

MOST_MODES = 300
"""Modes that are found if no number is asked for."""


@dataclass(frozen=True)
class Modes:
    """Modes of a system about a state, in order of the undamped frequency.

    Parameters
    ----------
    frequency
        Undamped natural frequencies [Hz], shape (n,); 0 for rigid modes.
    shape
        Undamped shapes, modal mass 1, shape (n, nd); the largest component by mass is positive.
    eigenvalue
        Complex eigenvalue with damping and gyroscopic terms [1/s], shape (n,), the one with Im >= 0; each
        stands beside the undamped mode it resembles most.
    damped_frequency, damping_ratio
        Im/2 pi [Hz] and -Re/|eigenvalue|, shape (n,); 0 Hz and no ratio (nan) where a mode creeps.
    damped_shape
        Complex shapes, shape (n, nd); largest component by mass real and positive, modal mass 1.
    kinetic
        Share of each coordinate in the kinetic energy of a mode, shape (n, nd).
    potential
        Share of each element in the strain energy, shape (n, ne); zero for rigid modes, negative where loads
        or weight weaken it.
    names
        What moves, in words.
    coordinates, elements
        Names of coordinates and elements.
    state
        The operating point.
    participation, effective_mass
        Factor [kg^1/2, kg^1/2 m] and mass [kg, kg m^2] with which the mode follows a base that accelerates
        along x, y, z or turns about them through the world origin, shape (n, 6).
    bodies
        Names of the bodies, ground first.
    place, axes
        Where their frames are at the operating point, shape (nb, 3) [m] and (nb, 3, 3), world axes.
    body_shape, damped_body_shape
        Displacement of the origins and turn of the bodies in a mode, world axes, shape (n, nb, 6).
    state_eigenvalue
        Further eigenvalues [1/s], those of the states of force elements, the slowest first.
    notes
        What the user should know, in sentences.
    """

    frequency: Array
    shape: Array
    eigenvalue: NDArray[np.complex128]
    damped_frequency: Array
    damping_ratio: Array
    damped_shape: NDArray[np.complex128]
    kinetic: Array
    potential: Array
    names: tuple[str, ...]
    coordinates: tuple[str, ...]
    elements: tuple[str, ...]
    state: State
    participation: Array
    effective_mass: Array
    bodies: tuple[str, ...]
    place: Array
    axes: Array
    body_shape: Array
    damped_body_shape: NDArray[np.complex128]
    state_eigenvalue: NDArray[np.complex128]
    notes: tuple[str, ...] = ()


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
    """Matrices of small vibrations about the loaded state of a scenario; arguments as in `find_modes`."""
    point = _without_friction(operating_point(system, scenario, start))
    own, state = point.system.copy(), point.state
    if phase is not None:
        state = _at_phase(own, state, phase, point.held)
    loose = touching(own, state)
    notes = list(point.notes)
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
    states = state_coordinates(own)
    basis = free_directions(own, state, states)
    return Linearised(own, state, at_rest, D, K, basis, states, point.held, tuple(notes))


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


def energy_shares(parts: Parts, shapes: Array, omega: Array) -> tuple[Array, Array]:
    """Shares of coordinates (n, nd) and elements (n, ne) in kinetic and strain energy (rigid modes: 0)."""
    kinetic = shapes * (shapes @ parts.M)
    potential = np.zeros((len(shapes), len(parts.shares)))
    for e, share in enumerate(parts.shares):
        potential[:, e] = share.energy(shapes)
    potential = np.where(omega[:, None] == 0.0, 0.0, potential)
    total = potential.sum(axis=1, keepdims=True)
    return kinetic, np.divide(potential, total, out=np.zeros_like(potential), where=total > 0.0)


def find_modes(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    phase: float | None = None,
    mean: bool = True,
    count: int | None = None,
    start: State | None = None,
    progress: Progress = silent,
) -> Modes:
    """Modes about the loaded state of a scenario.

    Parameters
    ----------
    system
        The compiled model.
    scenario
        Gives speeds and drives; driven spins do not vibrate. Default: the scenario the system was compiled
        with, else everything at rest.
    phase
        Mesh phase in [0, 1) at which every mesh is taken; default: mean over the mesh cycle.
    mean
        False: the phase of the operating point as it is.
    count
        Number of modes, lowest first; damped ones are found in their span. Default: all up to 300.
    start
        State near which the operating point is looked for; its rates are kept. Default: that of the scenario,
        and the initial state of a system made from numbers.
    progress
        Told after every element.

    Returns
    -------
    Modes

    Raises
    ------
    SolverError
        If there is no equilibrium to vibrate about.
    """
    linear = linearise(system, scenario, phase=phase, mean=mean, start=start, progress=progress)
    own, parts = linear.system, linear.at_rest
    omega, shapes, notes = lowest(linear, count)
    values, complex_shapes = damped_modes(linear, omega, shapes)
    n = len(omega)
    complex_shapes = _turned(complex_shapes[:n], parts.M)
    kinetic, potential = energy_shares(parts, shapes, omega)
    factors, masses = participation(base_vectors(own, linear.state), shapes)
    moved = body_motions(own, linear.state, shapes)
    moved_damped = body_motions(own, linear.state, complex_shapes)
    evaluate.residual(own, linear.state)
    frames = own.workspace.fr
    return Modes(
        frequency=omega / (2.0 * np.pi),
        shape=shapes,
        eigenvalue=values[:n],
        damped_frequency=values[:n].imag / (2.0 * np.pi),
        damping_ratio=ratio_of(values[:n]),
        damped_shape=complex_shapes,
        kinetic=kinetic,
        potential=potential,
        names=mode_names(own.layout, parts, omega, shapes, kinetic, potential),
        coordinates=own.layout.coordinates,
        elements=parts.elements,
        state=linear.state,
        participation=factors,
        effective_mass=masses,
        bodies=own.layout.bodies,
        place=frames["r"].copy(),
        axes=frames["R"].copy(),
        body_shape=np.asarray(moved, dtype=np.float64),
        damped_body_shape=np.asarray(moved_damped, dtype=np.complex128),
        state_eigenvalue=values[n:],
        notes=(*linear.notes, *notes),
    )


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


def _turned(shapes: NDArray[np.complex128], M: Array) -> NDArray[np.complex128]:
    """Complex shapes with modal mass 1 whose largest component by mass is real and positive."""
    weight = np.sqrt(np.diag(M))
    for row in shapes:
        sizes = np.abs(row) * weight
        first = int(np.flatnonzero(sizes >= sizes.max() * (1.0 - 1e-6))[0])
        row *= np.exp(-1j * np.angle(row[first]))
        row[first] = abs(row[first])
        row /= np.sqrt((row.conj() @ M @ row).real)
    return shapes


def solve_modal(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    phase: float | None = None,
    mean: bool = True,
    count: int | None = None,
    start: State | None = None,
    progress: Progress = silent,
) -> xr.Dataset:
    """Natural frequencies, damping ratios, shapes and energy shares; parameters as in `find_modes`.

    Returns
    -------
    xarray.Dataset
        Over `mode`: frequency, damped_frequency [Hz], damping_ratio, eigenvalue_real and eigenvalue_imag
        [1/s], name; over `mode` and `coordinate`: shape (modal mass 1), damped_shape_real, damped_shape_imag,
        kinetic_share; over `mode` and `element`: potential_share; over `mode` and `direction`: participation
        and effective_mass; over `mode`, `body` and `direction`: body_shape, the displacement of the origin
        of every body and its turn, world axes.
    """
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    began = time.perf_counter()
    m = find_modes(system, scenario, phase=phase, mean=mean, count=count, start=start, progress=progress)
    one, by_coordinate = ("mode",), ("mode", "coordinate")
    data = {
        "frequency": (one, m.frequency, "Hz", "undamped natural frequency"),
        "damped_frequency": (one, m.damped_frequency, "Hz", "natural frequency with damping at speed"),
        "damping_ratio": (one, m.damping_ratio, "1", "share of critical damping"),
        "eigenvalue_real": (one, m.eigenvalue.real, "1/s", "real part of the eigenvalue"),
        "eigenvalue_imag": (one, m.eigenvalue.imag, "1/s", "imaginary part of the eigenvalue"),
        "shape": (by_coordinate, m.shape, "1", "undamped shape, modal mass 1"),
        "damped_shape_real": (by_coordinate, m.damped_shape.real, "1", "damped shape, real part"),
        "damped_shape_imag": (by_coordinate, m.damped_shape.imag, "1", "damped shape, imaginary part"),
        "kinetic_share": (by_coordinate, m.kinetic, "1", "share in the kinetic energy"),
        "potential_share": (("mode", "element"), m.potential, "1", "share in the strain energy"),
        "participation": (("mode", "direction"), m.participation, "1", "participation factor, SI units"),
        "effective_mass": (("mode", "direction"), m.effective_mass, "1", "effective mass [kg, kg m^2]"),
        "body_shape": (("mode", "body", "direction"), m.body_shape, "1", "motion of the bodies [m, rad]"),
    }
    wall = time.perf_counter() - began
    return xr.Dataset(
        {k: (dims, v, {"units": unit, "long_name": text}) for k, (dims, v, unit, text) in data.items()},
        coords={
            "mode": np.arange(1, len(m.names) + 1),
            "name": ("mode", list(m.names)),
            "coordinate": list(m.coordinates),
            "element": list(m.elements),
            "direction": list(DIRECTIONS),
            "body": list(m.bodies),
        },
        attrs={
            **attributes(system, "modal", wall_s=wall, phase="mean" if phase is None else phase),
            "notes": "; ".join(m.notes),
        },
    )
