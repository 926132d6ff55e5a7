# SPDX-License-Identifier: Apache-2.0
"""Modes of a turning rotor with blades in multi-blade coordinates.

The mass, damping and stiffness of a bladed rotor on a flexible support change with its azimuth psi. With
coordinates of the whole rotor instead of those of each blade (Coleman and Feingold 1958),

    q_k = a_0 + sum_n (a_n cos n psi_k + b_n sin n psi_k) + (-1)^k d    (d for an even number of blades),

q = T(psi) z, the matrices are constant if all blades are equal and the air and the support are those of an
isotropic rotor: M T'' z + ... gives

    M_z = T^T M T,   D_z = T^T (D T + 2 M T'),   K_z = T^T (K T + D T' + M T''),   T' = Omega dT/dpsi.

Weight, tilt and wind shear make them periodic; the mean over some azimuths neglects their harmonics, as is
usual (Bir 2008).

References
----------
.. [1] R. P. Coleman, A. M. Feingold: Theory of self-excited mechanical oscillations of helicopter rotors with
   hinged blades, NACA Report 1351, 1958.
.. [2] G. Bir: Multi-blade coordinate transformation and its application to wind turbine analysis,
   NREL/CP-500-42553, 2008.
"""

from __future__ import annotations

import math
import time as clock
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.solvers.blade_branches import ALIKE, BladedHub, bladed_hub, equal_coordinates
from pitchpoint.solvers.eigen import best_match, ratio_of
from pitchpoint.solvers.linear_system import Linearised, linearise
from pitchpoint.solvers.modal import FREQUENCY, RATIO
from pitchpoint.system.system import System

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.scenario import Scenario

Array = NDArray[np.float64]

LOWEST = 0.03
"""Least imaginary part over the absolute value of eigenvalues that oscillate."""


@dataclass(frozen=True)
class MultibladeModes:
    """Modes of a turning rotor with its support, in axes that do not turn, by frequency.

    Parameters
    ----------
    eigenvalue
        Eigenvalues [1/s], shape (n,), those with Im > 0.
    frequency, damping_ratio
        Im/2 pi [Hz] and -Re/|eigenvalue|, shape (n,).
    blades
        Amplitudes of the blades, collective, in forward and in backward whirl, shape (n, 3), relative to the
        largest multi-blade coordinate of the mode.
    speed
        Speed of the rotor [rad/s].
    """

    eigenvalue: NDArray[np.complex128]
    frequency: Array
    damping_ratio: Array
    blades: Array
    speed: float


def find_multiblade_modes(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    hub: str,
    blades: Sequence[str],
    azimuths: int = 6,
) -> MultibladeModes:
    """Modes of a turning rotor with three or more equal blades, with its support.

    Parameters
    ----------
    system
        The compiled model. Blades are branches of the hub without closed loops.
    scenario
        Gives the speed of the hub; default: the one the system was compiled with.
    hub
        Body that carries the blades and turns about its z axis.
    blades
        Bodies or beams of the blades, in the order of their azimuths.
    azimuths
        Number of positions within the angle between two blades whose mean is used.

    Returns
    -------
    MultibladeModes

    Raises
    ------
    CompileError
        If there are fewer than three blades, they differ, or closed loops connect them.
    """

    first = linearise(system, scenario)
    rotor = bladed_hub(first.system, hub, blades)
    alike = equal_coordinates(first.system, rotor)
    spin = first.system.spin(hub)
    speed = float(first.state.v[spin])
    basis = _basis(first, rotor)
    total = np.zeros((3, *2 * basis.shape[1:]))
    linear = first
    for step in range(azimuths):
        if step:
            start = first.state.copy()
            start.q[spin] += step * math.tau / (azimuths * len(blades))
            linear = linearise(system, scenario, start=start)
        total += basis.T @ _transformed(linear, rotor, alike, speed) @ basis / azimuths
    values, z = _modes(total, len(first.states))
    size = np.sqrt(np.abs(np.diag(basis @ total[0] @ basis.T)))
    return MultibladeModes(
        eigenvalue=values,
        frequency=values.imag / math.tau,
        damping_ratio=ratio_of(values),
        blades=_whirl(z @ basis.T * size, rotor, speed),
        speed=speed,
    )


def _modes(matrices: Array, states: int) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Eigenvalues that oscillate and their shapes, by frequency; not those of the states, the last columns.

    Eigenvalues of states are real in turning axes, but turn with the rotor in those that do not. Those of the
    motion are most similar, in shape and value, to the eigenvalues at constant states.
    """
    values, z = _oscillating(matrices, states)
    if states:
        M = matrices[0]
        n = len(M) - states
        held, shapes = _oscillating(matrices[:, :n, :n], 0)
        moved = z[:, :n]
        overlap = np.abs(shapes.conj() @ M[:n, :n] @ moved.T) ** 2
        for one, by in ((shapes, 1), (moved, 0)):
            square = np.einsum("ik,kl,il->i", one.conj(), M[:n, :n], one).real
            overlap /= np.expand_dims(np.maximum(square, 1e-300), by)
        likeness = overlap / (1.0 + np.abs(np.log(values / held[:, None])))
        own = best_match(likeness)
        values, z = values[own], z[own]
    order = np.argsort(values.imag)
    return values[order], z[order]


def _oscillating(matrices: Array, states: int) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Eigenvalues with a positive imaginary part and their shapes, shape (m, n), states last."""
    M, D, K = matrices
    n = len(M) - states
    rates = -np.linalg.solve(np.hstack([M[:, :n], D[:, n:]]), np.hstack([K[:, :n], D[:, :n], K[:, n:]]))
    values, vectors = np.linalg.eig(np.vstack([np.eye(n, 2 * n + states, n), rates]))
    chosen = values.imag > LOWEST * np.abs(values)
    shapes = np.vstack([vectors[:n], vectors[2 * n :]])
    return values[chosen], shapes[:, chosen].T


def _basis(linear: Linearised, rotor: BladedHub) -> Array:
    """Free directions, then states, as columns, shape (nd, n); unit columns for coordinates of blades.

    Constraints of other parts, such as a gearbox of rigid ratio, are the same in multi-blade coordinates.
    """
    free = linear.basis if isinstance(linear.basis, np.ndarray) else linear.basis.toarray()
    states, nd = list(linear.states), len(free)
    own = np.setdiff1d(np.concatenate(rotor.columns), states)
    used = own[np.abs(free[own]).max(axis=1) > 0.0]
    if len(used) == np.count_nonzero(free[own]):  # each in a column of its own
        rest = free[:, np.abs(free[own]).max(axis=0) == 0.0]
        mixed = free.shape[1] - rest.shape[1] != len(used)
    else:
        left, sizes, _ = np.linalg.svd(free, full_matrices=False)
        span = left[:, sizes > ALIKE * sizes.max()]
        mixed = bool(np.abs(span[used] @ span[used].T - np.eye(len(used))).max() > ALIKE)
        rest = span - np.eye(nd)[:, used] @ span[used]
        left, sizes, _ = np.linalg.svd(rest, full_matrices=False)
        rest = left[:, sizes > ALIKE]
    if mixed:
        raise CompileError(
            "blades: closed loops or ratios connect their coordinates with others; give blades that are "
            "branches of the hub without loops"
        )
    return np.hstack([np.eye(nd)[:, used], rest, np.eye(nd)[:, states]])


def _transformed(linear: Linearised, rotor: BladedHub, alike: list[Array], speed: float) -> Array:
    """M, D and K, shape (3, nd, nd), with multi-blade coordinates in the places of those of the blades."""
    nd = linear.system.sizes["nd"]
    T = np.zeros((3, nd, nd))
    T[0] = np.eye(nd)
    columns = rotor.columns
    blades = np.concatenate(columns)
    T[0][blades, blades] = 0.0
    psi = rotor.angles + float(linear.state.q[linear.system.spin(linear.system.layout.bodies[rotor.hub])])
    for k, Q in enumerate(alike):
        for n, values in enumerate(harmonics(psi[k], k, len(psi))):
            for order in range(3):
                rows = np.ix_([order], columns[k], columns[n])
                T[rows] += speed**order * values[order] * Q
    M, D, K = linear.at_rest.M.copy(), linear.D.copy(), linear.K.copy()
    own = list(linear.states)  # the rates of these coordinates are the unknowns: one derivative less
    M[:, own], D[:, own], K[:, own] = 0.0, linear.at_rest.M[:, own], linear.D[:, own]
    return np.array(
        [
            T[0].T @ M @ T[0],
            T[0].T @ (D @ T[0] + 2.0 * M @ T[1]),
            T[0].T @ (K @ T[0] + D @ T[1] + M @ T[2]),
        ]
    )


def harmonics(psi: float, k: int, count: int) -> list[tuple[float, float, float]]:
    """Share of each multi-blade coordinate in blade k at an azimuth, and its two derivatives by azimuth.

    The order is a_0, a_1, b_1, a_2, ..., with d last for an even number of blades.

    Examples
    --------
    >>> [round(value, 3) for value, _, _ in harmonics(0.5, 1, 4)]
    [1.0, 0.878, 0.479, -1.0]
    """
    out = [(1.0, 0.0, 0.0)]
    for n in range(1, (count - 1) // 2 + 1):
        c, s = math.cos(n * psi), math.sin(n * psi)
        out += [(c, -n * s, -n * n * c), (s, n * c, -n * n * s)]
    if count % 2 == 0:
        out.append(((-1.0) ** k, 0.0, 0.0))
    return out


def _whirl(shapes: NDArray[np.complex128], rotor: BladedHub, speed: float) -> Array:
    """Amplitudes of the blades, collective, forward and backward, over the largest one, shape (n, 3)."""
    collective, c, s, *others = (shapes[:, own] for own in rotor.coordinates)
    turn = 1j if speed >= 0.0 else -1j
    parts = (collective, 0.5 * (c + turn * s), 0.5 * (c - turn * s), *others)
    sizes = np.array([np.linalg.norm(part, axis=1) for part in parts]).T
    return np.asarray(sizes[:, :3] / np.maximum(sizes.max(axis=1, keepdims=True), 1e-300))


def solve_multiblade_modes(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    hub: str,
    blades: Sequence[str],
    azimuths: int = 6,
) -> xr.Dataset:
    """Modes of a turning rotor in multi-blade coordinates; arguments and errors of `find_multiblade_modes`.

    Returns
    -------
    xarray.Dataset
        Over `mode`, by frequency: frequency [Hz], the damped natural frequency in axes that do not turn,
        damping_ratio, eigenvalue_real and eigenvalue_imag [1/s]; collective, forward and backward, the
        amplitudes of the blades relative to the largest multi-blade coordinate.
    """
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    began = clock.perf_counter()
    found = find_multiblade_modes(system, scenario, hub=hub, blades=blades, azimuths=azimuths)
    columns = {
        "frequency": (found.frequency, *FREQUENCY),
        "damping_ratio": (found.damping_ratio, *RATIO),
        "eigenvalue_real": (found.eigenvalue.real, "1/s", "real part of the eigenvalue"),
        "eigenvalue_imag": (found.eigenvalue.imag, "1/s", "imaginary part of the eigenvalue"),
        "collective": (found.blades[:, 0], "1", "amplitude of all blades together"),
        "forward": (found.blades[:, 1], "1", "amplitude of the blades in forward whirl"),
        "backward": (found.blades[:, 2], "1", "amplitude of the blades in backward whirl"),
    }
    options: dict[str, Any] = {"hub": hub, "blades": list(blades), "azimuths": azimuths, "speed": found.speed}
    return xr.Dataset(
        {
            name: (("mode",), values, {"units": unit, "long_name": text})
            for name, (values, unit, text) in columns.items()
        },
        coords={"mode": np.arange(1, len(found.frequency) + 1)},
        attrs=attributes(system, "multiblade", wall_s=clock.perf_counter() - began, **options),
    )
