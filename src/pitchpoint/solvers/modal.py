# SPDX-License-Identifier: Apache-2.0
"""Modes about an operating point: frequencies, damping, shapes, energies, names.

M x'' + D x' + K x = 0 with the derivatives of the residual at the loaded state, exact but for the phase of
the meshes, which is held: they count with the mean of their stiffness over the mesh cycle, or with the value
at one phase. Undamped modes are those at rest, with the symmetric part of K; damped ones carry dampers, the
gyroscopic terms of the speeds and the whole K. A torque that follows its tilting body makes K unsymmetric
and can feed energy into modes that nothing damps. Friction of the flanks is left out of both. Rayleigh and
modal damping are made at the phase where the scenario starts.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.progress import Progress, silent
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.eigen import damped, ratio_of, symmetric, undamped
from pitchpoint.solvers.equilibrium import find_equilibrium
from pitchpoint.solvers.mode_names import mode_names
from pitchpoint.solvers.operating_point import OperatingPoint, operating_point
from pitchpoint.solvers.start import without_friction
from pitchpoint.solvers.stiffness_parts import Array, Parts, mesh_names, shift, split, touching
from pitchpoint.solvers.trains import driven_coordinates, held_spins, rotations
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    import xarray as xr


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
        Share of each element in the strain energy, shape (n, ne); zero for rigid modes.
    names
        What moves, in words.
    coordinates, elements
        Names of coordinates and elements.
    state
        The operating point.
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
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Linearised:
    """Split matrices about an operating point, at rest and at speed, and what the user should know of it."""

    system: System
    state: State
    at_rest: Parts
    D: Array
    K: Array
    basis: Array
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
    progress: Progress = silent,
) -> Linearised:
    """Matrices of small vibrations about the loaded state of a scenario; arguments as in `find_modes`."""
    point = _without_friction(operating_point(system, scenario))
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
    return Linearised(own, state, at_rest, D, K, _free_directions(own, state), tuple(notes))


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


def _free_directions(system: System, state: State) -> Array:
    """Columns that span what constraint rows leave free, shape (nd, n)."""
    nd = system.sizes["nd"]
    if system.sizes["nc"] == 0:
        return np.eye(nd)
    G = evaluate.constraint_jacobian(system, state)
    fixed = np.flatnonzero(np.abs(G).sum(axis=0) > 0.0)
    if np.count_nonzero(G) == np.linalg.matrix_rank(G) == fixed.size:
        return np.delete(np.eye(nd), fixed, axis=1)  # rows that each hold one coordinate
    _, values, rows = np.linalg.svd(G)
    rank = int(np.sum(values > 1e-10 * values[0]))
    return np.asarray(rows[rank:].T)


def rigid_rotations(system: System) -> Array:
    """Turns of the spins that nothing resists: one row per free train that nothing drives, shape (r, nd)."""
    return rotations(system, held_spins(system)[len(driven_coordinates(system)) :]).T


def energy_shares(parts: Parts, shapes: Array, omega: Array) -> tuple[Array, Array]:
    """Shares of coordinates (n, nd) and elements (n, ne) in kinetic and strain energy (rigid modes: 0)."""
    kinetic = shapes * (shapes @ parts.M)
    potential = np.einsum("ni,eij,nj->ne", shapes, parts.K_element, shapes)
    potential = np.where(omega[:, None] == 0.0, 0.0, potential)
    total = potential.sum(axis=1, keepdims=True)
    return kinetic, np.divide(potential, total, out=np.zeros_like(potential), where=total > 0.0)


def find_modes(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    phase: float | None = None,
    mean: bool = True,
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
    linear = linearise(system, scenario, phase=phase, mean=mean, progress=progress)
    parts = linear.at_rest
    omega, shapes = undamped(parts.M, parts.K, linear.basis, rigid_rotations(linear.system))
    values, z = damped(linear.D, linear.K - symmetric(parts.K), shapes, omega)
    complex_shapes = _turned(np.asarray(z.T @ shapes, dtype=np.complex128), parts.M)
    kinetic, potential = energy_shares(parts, shapes, omega)
    return Modes(
        frequency=omega / (2.0 * np.pi),
        shape=shapes,
        eigenvalue=values,
        damped_frequency=values.imag / (2.0 * np.pi),
        damping_ratio=ratio_of(values),
        damped_shape=complex_shapes,
        kinetic=kinetic,
        potential=potential,
        names=mode_names(linear.system.layout, parts, omega, shapes, kinetic, potential),
        coordinates=linear.system.layout.coordinates,
        elements=parts.elements,
        state=linear.state,
        notes=linear.notes,
    )


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
    progress: Progress = silent,
) -> xr.Dataset:
    """Natural frequencies, damping ratios, shapes and energy shares; parameters as in `find_modes`.

    Returns
    -------
    xarray.Dataset
        Over `mode`: frequency, damped_frequency [Hz], damping_ratio, eigenvalue_real and eigenvalue_imag
        [1/s], name; over `mode` and `coordinate`: shape (modal mass 1), damped_shape_real, damped_shape_imag,
        kinetic_share; over `mode` and `element`: potential_share.
    """
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    began = time.perf_counter()
    m = find_modes(system, scenario, phase=phase, mean=mean, progress=progress)
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
    }
    wall = time.perf_counter() - began
    return xr.Dataset(
        {k: (dims, v, {"units": unit, "long_name": text}) for k, (dims, v, unit, text) in data.items()},
        coords={
            "mode": np.arange(1, len(m.names) + 1),
            "name": ("mode", list(m.names)),
            "coordinate": list(m.coordinates),
            "element": list(m.elements),
        },
        attrs={
            **attributes(system, "modal", wall_s=wall, phase="mean" if phase is None else phase),
            "notes": "; ".join(m.notes),
        },
    )
