# SPDX-License-Identifier: Apache-2.0
"""Modes about an operating point: frequencies, damping, shapes, energies, names.

M x'' + D x' + K x = 0 with the derivatives of the residual at the loaded state. They are exact except for the
phase of the meshes, which is fixed: mesh stiffness is the mean over the mesh cycle, or the value at one
phase. Undamped modes are those at rest, with the symmetric part of K; damped modes include dampers,
gyroscopic terms and the whole K. A torque that follows a tilting body makes K unsymmetric and can destabilise
undamped modes. Flank friction is neglected in both and in the operating point: sliding reverses within every
mesh cycle. Rayleigh and modal damping are computed at the phase where the scenario starts.

Mechanisms vibrate in the free directions of their loops; K includes the geometric stiffness of the loop
reactions. For trees of bodies, the undamped modes include the centrifugal stiffness of a steady rotation; the
operating point is then the relative equilibrium with constant rates. States of force elements are constant
for the undamped modes and free for the damped ones.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import join_notes
from pitchpoint.core.progress import Progress, silent
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.body_shapes import DIRECTIONS, base_momenta, body_motions, participation
from pitchpoint.solvers.eigen import ratio_of
from pitchpoint.solvers.linear_system import Linearised, damped_modes, linearise, lowest
from pitchpoint.solvers.modes.energies import (
    WAYS,
    Energies,
    energies_of,
    gyroscopic_terms,
    motions_of,
    spins_of,
    whirl_words,
)
from pitchpoint.solvers.modes.machine_groups import Groups
from pitchpoint.solvers.modes.names import base_names, full_names
from pitchpoint.solvers.stiffness_parts import Array, Parts
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    import xarray as xr


FREQUENCY = ("Hz", "damped natural frequency")
RATIO = ("1", "damping ratio")
"""Unit and name of the frequencies and damping ratios of modes, also over the speed."""


@dataclass(frozen=True)
class Modes:
    """Modes of a system about a state, in order of the undamped frequency.

    Parameters
    ----------
    frequency
        Undamped natural frequencies at rest [Hz], shape (n,); 0 for rigid modes.
    shape
        Undamped shapes, modal mass 1, shape (n, nd); the largest component by mass is positive.
    eigenvalue
        Complex eigenvalue with damping and gyroscopic terms [1/s], shape (n,), the one with Im >= 0; assigned
        to the most similar undamped mode.
    damped_frequency, damping_ratio
        Im/2 pi [Hz] and -Re/|eigenvalue|, shape (n,); 0 Hz and 1 where a mode is overdamped, -1 where it
        diverges without oscillation.
    damped_shape
        Complex shapes, shape (n, nd); largest component by mass real and positive, modal mass 1.
    kinetic
        Share of each coordinate in the kinetic energy of a mode, shape (n, nd); they sum to 1, and may be
        negative for coordinates of joints.
    potential
        Share of each element in the strain energy, shape (n, ne); zero for rigid modes, negative for negative
        geometric stiffness of loads or weight.
    names
        Names of the modes, from their energies and shapes.
    energies
        Energies of the damped modes by component and part.
    groups
        Parts and components of the machine.
    whirl
        Whirl of the damped modes: forward, backward, planar, mixed, or empty without lateral motion.
    coordinates, elements
        Names of coordinates and elements.
    state
        The operating point.
    participation, effective_mass
        Participation factor [kg^1/2, kg^1/2 m] and effective mass [kg, kg m^2] for base accelerations along
        x, y, z and rotations about them through the world origin, shape (n, 6).
    bodies
        Names of the bodies, ground first.
    place, axes
        Positions and axes of their frames at the operating point, shape (nb, 3) [m] and (nb, 3, 3), world
        axes.
    body_shape, damped_body_shape
        Displacement of the origins and rotation of the bodies in a mode, world axes, shape (n, nb, 6).
    state_eigenvalue
        Further eigenvalues [1/s], those of the states of force elements, in ascending order; of a pair the
        one with Im > 0.
    state_reach
        Absolute value up to which they are complete [1/s]; infinite except for very large systems.
    states
        Number of states.
    total
        Number of modes of the system; more than n if only the lowest were requested.
    notes
        Notes for the user.
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
    energies: Energies
    groups: Groups
    whirl: tuple[str, ...]
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
    state_reach: float
    states: int
    total: int
    notes: tuple[str, ...] = ()


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
    linear: Linearised | None = None,
) -> Modes:
    """Modes about the loaded state of a scenario.

    Parameters
    ----------
    system
        The compiled model.
    scenario
        Gives speeds and drives; driven spins are fixed. Default: the scenario the system was compiled with,
        or the system at rest.
    phase
        Mesh phase in [0, 1) of all meshes; default: mean over the mesh cycle.
    mean
        False: mesh phases of the operating point.
    count
        Number of modes, lowest first. Default: all of up to 200 modes, otherwise the lowest 40.
    start
        Initial state of the search for the operating point; its rates are retained. Default: that of the
        scenario, or the initial state of a system without a model.
    progress
        Called after every element.
    linear
        Result of `linearise` for the same arguments, if already computed.

    Returns
    -------
    Modes

    Raises
    ------
    SolverError
        If there is no equilibrium.
    """
    if linear is None:
        linear = linearise(system, scenario, phase=phase, mean=mean, start=start, progress=progress)
    own, parts = linear.system, linear.at_rest
    modes = lowest(linear, count)
    omega, shapes = modes.omega, modes.shapes
    damped = damped_modes(linear, modes, complete=True)
    values = damped.values
    complex_shapes = _normalised(damped.shapes, parts.M)
    kinetic, potential = energy_shares(parts, shapes, omega)
    motions = motions_of(own, linear.state, parts)
    spins = spins_of(motions, linear.state.v)
    energies = energies_of(
        motions,
        complex_shapes,
        np.where(omega == 0.0, 0.0, values),
        gyroscopic_terms(complex_shapes, linear.D),
        spins,
    )
    whirls = whirl_words(energies)
    at_rest = energies_of(motions, shapes, (1j * omega).astype(np.complex128), 0.0 * shapes, 0.0 * spins)
    blades = None if linear.axes is None else linear.axes.ways(complex_shapes, parts.M)
    names = full_names(base_names(own, motions, omega, shapes, at_rest), whirls, blades)
    factors, masses = participation(base_momenta(own, linear.state, shapes))
    moved = body_motions(own, linear.state, shapes)
    moved_damped = body_motions(own, linear.state, complex_shapes)
    evaluate.residual(own, linear.state)
    frames = own.workspace.fr
    return Modes(
        frequency=omega / (2.0 * np.pi),
        shape=shapes,
        eigenvalue=values,
        damped_frequency=values.imag / (2.0 * np.pi),
        damping_ratio=ratio_of(values),
        damped_shape=complex_shapes,
        kinetic=kinetic,
        potential=potential,
        names=names,
        energies=energies,
        groups=motions.groups,
        whirl=tuple(whirls),
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
        state_eigenvalue=damped.states,
        state_reach=damped.reach,
        states=len(linear.states),
        total=modes.total,
        notes=(*linear.notes, *modes.notes),
    )


def _normalised(shapes: NDArray[np.complex128], M: Array) -> NDArray[np.complex128]:
    """Complex shapes with modal mass 1 whose largest component by mass is real and positive."""
    sizes = np.abs(shapes) * np.sqrt(np.diag(M))
    chosen = (sizes >= sizes.max(axis=1, keepdims=True) * (1.0 - 1e-6)).argmax(axis=1)
    rows = np.arange(len(shapes))
    shapes = shapes * np.exp(-1j * np.angle(shapes[rows, chosen]))[:, None]
    shapes[rows, chosen] = np.abs(shapes[rows, chosen])
    mass = sum(np.einsum("ij,ij->i", part, part @ M) for part in (shapes.real, shapes.imag))
    return np.asarray(shapes / np.sqrt(mass)[:, None], dtype=np.complex128)


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
        Over `mode`, with the coordinate `name`: frequency [Hz], the damped natural frequency at the speeds of
        the scenario as in `solve_campbell`, 0 where a mode does not oscillate; undamped_frequency [Hz], at
        rest; damping_ratio, whirl, eigenvalue_real and eigenvalue_imag [1/s], strain_to_kinetic and
        gyroscopic_share, which sum to 1. With `component` strain_share, with `part` and `motion`
        kinetic_share: energies of the damped modes, which sum to 1. Of the undamped modes: over `coordinate`
        shape (modal mass 1), coordinate_share, over `element` potential_share, over `direction` participation
        and effective_mass, over `body` and `direction` body_shape, the displacement of the origin of every
        body and its rotation, world axes. Over `coordinate` also damped_shape_real, damped_shape_imag.
    """
    began = time.perf_counter()
    found = find_modes(system, scenario, phase=phase, mean=mean, count=count, start=start, progress=progress)
    wall = time.perf_counter() - began
    return modal_dataset(system, found, wall_s=wall, phase="mean" if phase is None else phase)


COORDINATES = ("mode", "name", "component", "part", "motion", "coordinate", "element", "direction", "body")
"""Coordinates among the variables of modes."""


def modal_dataset(system: System, m: Modes, **attrs: Any) -> xr.Dataset:
    """Dataset of modes, see `solve_modal`; `attrs` as in `dataset.attributes`."""
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    found = {
        name: (dims, values, {key: word for key, word in (("units", unit), ("long_name", text)) if word})
        for name, (dims, values, unit, text) in modal_variables(m).items()
    }
    return xr.Dataset(
        {name: variable for name, variable in found.items() if name not in COORDINATES},
        coords={name: found[name] for name in COORDINATES},
        attrs={**attributes(system, "modal", **attrs), "notes": join_notes(m.notes)},
    )


def modal_variables(m: Modes) -> dict[str, tuple[tuple[str, ...], Any, str, str]]:
    """Dimensions, values, SI unit and description of the variables of modes, `COORDINATES` included."""
    one, by_coordinate = ("mode",), ("mode", "coordinate")
    data: dict[str, tuple[tuple[str, ...], Any, str, str]] = {
        "frequency": (one, m.damped_frequency, *FREQUENCY),
        "undamped_frequency": (one, m.frequency, "Hz", "undamped natural frequency at rest"),
        "damping_ratio": (one, m.damping_ratio, *RATIO),
        "whirl": (one, np.array(m.whirl, dtype=object), "", "whirl of the shafts"),
        "strain_to_kinetic": (one, m.energies.strain_ratio, "1", "strain over kinetic energy"),
        "gyroscopic_share": (one, m.energies.gyroscopic, "1", "gyroscopic over kinetic energy"),
        "strain_share": (("mode", "component"), m.energies.strain, "1", "share in the strain energy"),
        "kinetic_share": (("mode", "part", "motion"), m.energies.kinetic, "1", "share in the kinetic energy"),
        "eigenvalue_real": (one, m.eigenvalue.real, "1/s", "real part of the eigenvalue"),
        "eigenvalue_imag": (one, m.eigenvalue.imag, "1/s", "imaginary part of the eigenvalue"),
        "shape": (by_coordinate, m.shape, "1", "undamped shape, modal mass 1"),
        "damped_shape_real": (by_coordinate, m.damped_shape.real, "1", "damped shape, real part"),
        "damped_shape_imag": (by_coordinate, m.damped_shape.imag, "1", "damped shape, imaginary part"),
        "coordinate_share": (by_coordinate, m.kinetic, "1", "share of a coordinate in the kinetic energy"),
        "potential_share": (
            ("mode", "element"),
            m.potential,
            "1",
            "share of an element in the strain energy",
        ),
        "participation": (("mode", "direction"), m.participation, "1", "participation factor, SI units"),
        "effective_mass": (("mode", "direction"), m.effective_mass, "1", "effective mass [kg, kg m^2]"),
        "body_shape": (("mode", "body", "direction"), m.body_shape, "1", "motion of the bodies [m, rad]"),
    }
    labels = {
        "component": m.groups.components,
        "part": m.groups.parts,
        "motion": WAYS,
        "coordinate": m.coordinates,
        "element": m.elements,
        "direction": DIRECTIONS,
        "body": m.bodies,
    }
    data["mode"] = (one, np.arange(1, len(m.names) + 1), "", "")
    data["name"] = (one, np.array(m.names, dtype=object), "", "name of the mode")
    return data | {
        name: ((name,), np.array(list(texts), dtype=str), "", "") for name, texts in labels.items()
    }
