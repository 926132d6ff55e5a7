# SPDX-License-Identifier: Apache-2.0
"""Modes about an operating point: frequencies, damping, shapes, energies, names.

M x'' + D x' + K x = 0 with the exact derivatives of the residual at the loaded state; meshes count with the
mean of their stiffness over the mesh cycle, or with the value at one phase. Undamped modes are those at rest
(symmetric K); damped ones carry dampers, friction and the gyroscopic terms of the speeds.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import SINGULAR
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.equilibrium import find_equilibrium, free_spins, same_group
from pitchpoint.solvers.mode_names import mode_names
from pitchpoint.solvers.operating_point import held_spins, operating_point
from pitchpoint.solvers.stiffness_parts import Array, Parts, mesh_names, shift, split, touching
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    import xarray as xr

RIGID = 1e-11
"""Strain energy over what its terms sum up to without signs, below which a mode counts as rigid."""
OVERLAP = 1e-4
"""Part of a shape outside the rigid rotations up to which it counts as one of them."""
SLOW = 1e-4
"""Eigenvalue over the largest up to which that is asked."""
SAME = 1e-9
"""Relative distance of eigenvalues that count as one multiple root."""


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


def linearise(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    phase: float | None = None,
    mean: bool = True,
    progress: Progress = silent,
) -> Linearised:
    """Matrices of small vibrations about the loaded state of a scenario; arguments as in `find_modes`."""
    point = operating_point(system, scenario)
    own, state = point.system.copy(), point.state
    if phase is not None:
        state = _at_phase(own, state, phase, point.held)
    loose = touching(own, state)
    notes = list(point.notes)
    if loose:
        notes.append(
            f"no load presses the flanks of {', '.join(loose)} together: "
            "the front flanks are taken as touching"
        )
    still = state.copy()
    still.v[:] = 0.0
    at_rest = split(own, still, point.held, mean and phase is None, loose, progress)
    D = at_rest.D + evaluate.matrix(own, state, 0.0, 1.0, 0.0) - evaluate.matrix(own, still, 0.0, 1.0, 0.0)
    K = at_rest.K + evaluate.matrix(own, state, 0.0, 0.0, 1.0) - evaluate.matrix(own, still, 0.0, 0.0, 1.0)
    return Linearised(own, state, at_rest, D, K, _free_directions(own, state), tuple(notes))


def _at_phase(system: System, state: State, phase: float, held: tuple[int, ...]) -> State:
    """Put every mesh at one phase; the records of the system change."""
    for _ in range(2):  # the deflection of the new place moves the phase a little
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
    """Turns of the spins that nothing resists: one row per group of bodies that turns freely, shape (r, nd)."""
    if system.model is None:
        return np.zeros((0, system.sizes["nd"]))
    driven = held_spins(system)[: len(system.records.get("drive", ()))]
    found = []
    for spin in free_spins(system):
        if any(same_group(system, spin, d) for d in driven):
            continue
        body = system.layout.coordinates[spin].rpartition(".")[0]
        row = np.zeros(system.sizes["nd"])
        for name, ratio in system.model.start_speeds(Scenario(speed={body: 1.0})).items():
            if ratio != 0.0:
                row[system.spin(name)] = ratio
        found.append(row)
    return np.array(found).reshape(-1, system.sizes["nd"])


def _are_rigid(shapes: Array, rigid: Array, M: Array) -> NDArray[np.bool_]:
    """Which mass-normalised shapes (n, nd) lie in the space of the rigid rotations."""
    if not len(rigid):
        return np.zeros(len(shapes), bool)
    L = np.linalg.cholesky(rigid @ M @ rigid.T)
    within = np.linalg.solve(L, rigid @ M @ shapes.T)
    return np.asarray((within**2).sum(axis=0) > 1.0 - OVERLAP)


def undamped(M: Array, K: Array, basis: Array, rigid: Array) -> tuple[Array, Array]:
    """Circular frequencies [rad/s] and mass-normalised shapes (n, nd) of M x'' + K x = 0.

    Parameters
    ----------
    M, K
        Mass and stiffness matrix, shape (nd, nd); their symmetric parts count.
    basis
        Columns that span the free directions, shape (nd, n).
    rigid
        Rotations that nothing resists, shape (r, nd): the tangents of tilted gears hold at a frozen line of
        action and would leave a small frequency on them.

    Raises
    ------
    SolverError
        If a free direction has no mass.
    """
    from scipy.linalg import eigh

    m, k = (basis.T @ (0.5 * (A + A.T)) @ basis for A in (M, K))
    scale = 1.0 / np.sqrt(np.diag(m)) if np.all(np.diag(m) > 0.0) else np.zeros(0)
    if scale.size != m.shape[0]:
        raise SolverError("a free direction has no mass, so it has no frequency", SINGULAR)
    m, k = scale[:, None] * m * scale, scale[:, None] * k * scale
    values, vectors = eigh(k, m)
    for j in range(values.size):
        x = vectors[:, j]
        if abs(x @ k @ x) <= RIGID * float(np.abs(x) @ np.abs(k) @ np.abs(x)):
            values[j] = 0.0
    unsorted = (basis @ (scale[:, None] * vectors)).T
    small = np.abs(values) < SLOW * np.abs(values).max(initial=0.0)
    values[small & _are_rigid(unsorted, rigid, M)] = 0.0
    root = np.linalg.cholesky(m).T
    order = np.argsort(values, kind="stable")
    values, vectors = values[order], vectors[:, order]
    start = 0
    while start < values.size:
        stop = start + 1
        while stop < values.size and values[stop] - values[stop - 1] <= SAME * abs(values[stop]):
            stop += 1
        vectors[:, start:stop] = _settled(vectors[:, start:stop], root)
        start = stop
    return np.sign(values) * np.sqrt(np.abs(values)), (basis @ (scale[:, None] * vectors)).T


def _settled(block: Array, root: Array) -> Array:
    """One fixed choice among the shapes of a (multiple) root: each takes all of one component.

    The first shape is the projection of the coordinate that moves most in the whole space onto it, and so on;
    ties go to the first coordinate. Signs: that component is positive.
    """
    rest, found = block.copy(), []
    for _ in range(block.shape[1]):
        weighted = root @ rest
        sizes = np.linalg.norm(weighted, axis=1)
        row = int(np.flatnonzero(sizes >= sizes.max() * (1.0 - 1e-6))[0])
        turn = weighted[row] / sizes[row]
        found.append(rest @ turn)
        rest = rest @ _complement(turn)
    return np.column_stack(found)


def _complement(turn: Array) -> Array:
    """Orthonormal columns that stand on a unit vector (its Householder reflection without one column)."""
    v = turn.copy()
    v[0] += np.copysign(1.0, v[0])
    reflection = np.eye(v.size) - 2.0 * np.outer(v, v) / (v @ v)
    return np.asarray(reflection[:, 1:])


def damped(D: Array, K: Array, shapes: Array, omega: Array) -> tuple[NDArray[np.complex128], Array]:
    """Eigenvalues and shapes with damping, each beside the undamped mode it resembles most.

    Parameters
    ----------
    D, K
        Damping matrix, and what the speeds add to the stiffness matrix, shape (nd, nd).
    shapes, omega
        Undamped modes, shape (n, nd) and (n,): the basis in which the problem is well scaled.

    Returns
    -------
    eigenvalue (n,), shape in terms of the undamped modes (n, n), complex
    """
    n = len(shapes)
    k = np.diag(omega * np.abs(omega)) + shapes @ K @ shapes.T
    d = shapes @ D @ shapes.T
    unit = max(float(np.abs(omega).max(initial=0.0)), float(np.abs(d).max(initial=0.0)), 1e-300)
    # rigid modes that nothing ties to the rest stay out: a double zero root would lose half its digits
    size = np.abs(k) / unit**2 + np.abs(d) / unit
    tied = (omega != 0.0) | (size.max(axis=0, initial=0.0) > 1e-12) | (size.max(axis=1, initial=0.0) > 1e-12)
    values, z = np.zeros(n, complex), np.eye(n, dtype=complex)
    if np.any(tied):
        own = np.ix_(tied, tied)
        values[tied], z[own] = _quadratic(k[own] / unit**2, d[own] / unit)
    return values * unit, z


def _quadratic(k: Array, d: Array) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Roots of z'' + d z' + k z = 0, one of each pair, sorted to the coordinates; shapes of length 1."""
    from scipy.linalg import eig
    from scipy.optimize import linear_sum_assignment

    n = len(k)
    values, vectors = eig(np.block([[np.zeros((n, n)), np.eye(n)], [-k, -d]]))
    upper = [j for j in range(2 * n) if values[j].imag > 1e-12]
    real = sorted((j for j in range(2 * n) if abs(values[j].imag) <= 1e-12), key=lambda j: values[j].real)
    upper += real[1::2]  # real roots come in pairs too: the slower stands for its mode
    z = vectors[:n, upper]
    z = z / np.linalg.norm(z, axis=0)
    _, columns = linear_sum_assignment(-(np.abs(z) ** 2))
    found = values[upper][columns]
    return np.where(np.abs(found) < 1e-12, 0.0, found), z[:, columns]


def energy_shares(parts: Parts, shapes: Array, omega: Array) -> tuple[Array, Array]:
    """Shares of coordinates (n, nd) and elements (n, ne) in kinetic and strain energy (rigid modes: 0)."""
    kinetic = shapes * (shapes @ parts.M)
    potential = np.einsum("ni,eij,nj->ne", shapes, parts.K_element, shapes)
    potential = np.where(omega[:, None] == 0.0, 0.0, potential)
    total = potential.sum(axis=1, keepdims=True)
    return kinetic, np.divide(potential, total, out=np.zeros_like(potential), where=total > 0.0)


def ratio_of(values: NDArray[np.complex128]) -> Array:
    """Share of critical damping of eigenvalues; 0 for a rigid mode, nan for one that creeps."""
    size = np.abs(values)
    ratio = np.divide(-values.real, size, out=np.zeros(size.shape), where=size > 0.0)
    ratio[(values.imag <= 0.0) & (size > 0.0)] = np.nan
    return np.asarray(ratio)


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
    values, z = damped(linear.D, linear.K - parts.K, shapes, omega)
    complex_shapes = _turned(z.T @ shapes, parts.M)
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
