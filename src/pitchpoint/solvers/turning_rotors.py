# SPDX-License-Identifier: Apache-2.0
"""Linear systems of turning rotors with blades in multi-blade coordinates.

The mass, damping and stiffness of a bladed rotor on a flexible support change with its azimuth psi. With
coordinates of the whole rotor instead of those of each blade (Coleman and Feingold 1958),

    q_k = a_0 + sum_n (a_n cos n psi_k + b_n sin n psi_k) + (-1)^k d    (d for an even number of blades),

q = T(psi) z, the matrices are constant if all blades are equal and the air and the support are those of an
isotropic rotor. Here the coordinates are those of the blades at the azimuth of the operating point, x = T_0
z, so that everything else, such as energies and names of modes, is that of this position: q = R(psi) x with
R = T T_0^-1, and M R x'' + ... gives

    M_x = R^T M R,   D_x = R^T (D R + 2 M R'),   K_x = R^T (K R + D R' + M R''),   R' = Omega dR/dpsi.

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
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.solvers.blade_branches import ALIKE, BladedHub, bladed_hub, equal_coordinates
from pitchpoint.solvers.linear_system import Linearised
from pitchpoint.solvers.speed_states import SpeedStates
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.system.system import System

WAYS = ("collective", "forward", "backward")
"""Motions of all blades."""


class TurningRotors:
    """Multi-blade coordinates of one rotor or several.

    Parameters
    ----------
    system
        The system.
    rotors
        Hub and blades of each rotor; blades in the order of their azimuths.
    rates
        Rates of all coordinates with the reference body at 1 rad/s.

    Raises
    ------
    CompileError
        If a rotor has fewer than three blades, they differ, or they are not branches of the hub.
    """

    def __init__(self, system: System, rotors: Sequence[tuple[str, Sequence[str]]], rates: Array) -> None:
        self.rotors: list[BladedHub] = [bladed_hub(system, hub, blades) for hub, blades in rotors]
        self.alike = [equal_coordinates(system, rotor) for rotor in self.rotors]
        self.spins = [system.spin(hub) for hub, _ in rotors]
        self.rates, self.size = rates, system.sizes["nd"]

    def mean(self, states: SpeedStates, linear: Linearised, speed: float, azimuths: int) -> Linearised:
        """The linear system with constant matrices, the mean over some azimuths.

        Parameters
        ----------
        states
            Equilibria over the speed.
        linear
            The linear system at this speed, at the azimuth of reference.
        speed
            Speed of the reference body [rad/s].
        azimuths
            Number of positions within the angle between two blades.
        """
        count = max(len(rotor.angles) for rotor in self.rotors)
        faster = max(abs(float(self.rates[spin])) for spin in self.spins)
        at, total = linear, np.zeros((4, self.size, self.size))
        for step in range(azimuths):
            angle = step * math.tau / (azimuths * count * faster)
            if step:
                at = states.about(*states.turned(linear.state, speed, angle), teeth=linear.state)
            total += self._transformed(at, linear, speed, angle) / azimuths
        M, D, K, K_rest = total
        return replace(linear, at_rest=replace(linear.at_rest, M=M, K=K_rest), D=D, K=K)

    def _transformed(self, at: Linearised, reference: Linearised, speed: float, angle: float) -> Array:
        """M, D, K and K at rest in multi-blade coordinates, shape (4, nd, nd)."""
        from scipy.sparse import csr_array

        R = [csr_array(one) for one in self._turned(reference, speed, angle)]
        M, D, K = at.at_rest.M.copy(), at.D.copy(), at.K.copy()
        own = list(at.states)  # the rates of these coordinates are the unknowns: one derivative less
        M[:, own], D[:, own], K[:, own] = 0.0, at.at_rest.M[:, own], at.D[:, own]
        back, (MR, MR1, MR2) = R[0].T, (M @ one for one in R)
        m = back @ MR
        d = back @ (D @ R[0] + 2.0 * MR1)
        k = back @ (K @ R[0] + D @ R[1] + MR2)
        m[:, own], d[:, own], k[:, own] = d[:, own], k[:, own], 0.0
        return np.array([m, d, k, back @ (at.at_rest.K @ R[0])])

    def _turned(self, reference: Linearised, speed: float, angle: float) -> Array:
        """R, R' and R'' with the reference body turned by an angle, shape (3, nd, nd)."""
        R = np.zeros((3, self.size, self.size))
        R[0] = np.eye(self.size)
        for rotor, alike, spin in zip(self.rotors, self.alike, self.spins, strict=True):
            rate, start = float(self.rates[spin]), float(reference.state.q[spin])
            back = np.linalg.inv(self._shares(rotor, start)[0])
            shares = self._shares(rotor, start + rate * angle) @ back
            for k, row in enumerate(rotor.columns):
                for n, column in enumerate(rotor.columns):
                    own = alike[k] @ np.linalg.inv(alike[n])
                    for order in range(3):
                        value = (rate * speed) ** order * shares[order, k, n]
                        R[np.ix_([order], row, column)] = value * own
        return R

    @staticmethod
    def _shares(rotor: BladedHub, azimuth: float) -> Array:
        """Share of every multi-blade coordinate in every blade, and its two derivatives, shape (3, B, B)."""
        count = len(rotor.angles)
        found = [harmonics(azimuth + float(psi), k, count) for k, psi in enumerate(rotor.angles)]
        return np.transpose(np.array(found), (2, 0, 1))

    def basis(self, linear: Linearised) -> Array:
        """Free directions, then states, as columns, shape (nd, n); unit columns for coordinates of blades.

        Constraints of other parts, such as a gearbox of rigid ratio, are the same in multi-blade coordinates.

        Raises
        ------
        CompileError
            If closed loops or ratios connect coordinates of blades with others.
        """
        free = linear.basis if isinstance(linear.basis, np.ndarray) else linear.basis.toarray()
        states, nd = list(linear.states), len(free)
        blades = np.concatenate([np.concatenate(rotor.columns) for rotor in self.rotors])
        own = np.setdiff1d(blades, states)
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

    def whirl(self, shapes: NDArray[np.complex128], size: Array, one: int = 0) -> Array:
        """Amplitudes of the blades of a rotor, collective, forward and backward, over the largest.

        Parameters
        ----------
        shapes
            Shapes of modes, shape (n, nd).
        size
            Scale of every coordinate, shape (nd,).
        one
            Number of the rotor.

        Returns
        -------
        ndarray, shape (n, 3)
        """
        rotor, alike = self.rotors[one], self.alike[one]
        back = np.linalg.inv(self._shares(rotor, 0.0)[0])
        n = len(rotor.coordinates[0])
        own = [
            np.linalg.solve(Q[:n, :n], (shapes[:, at]).T).T
            for Q, at in zip(alike, rotor.coordinates, strict=True)
        ]
        weight = size[rotor.coordinates[0]]
        whole = [sum(back[m, k] * own[k] for k in range(len(own))) * weight for m in range(len(own))]
        collective, c, s, *others = whole
        turn = 1j if self.rates[self.spins[one]] >= 0.0 else -1j
        parts = (collective, 0.5 * (c + turn * s), 0.5 * (c - turn * s), *others)
        sizes = np.array([np.linalg.norm(part, axis=1) for part in parts]).T
        return np.asarray(sizes[:, :3] / np.maximum(sizes.max(axis=1, keepdims=True), 1e-300))

    def ways(self, shapes: NDArray[np.complex128], M: Array) -> list[str]:
        """Motion of the blades in each mode, of the rotor with most of the energy: a word of `WAYS`.

        Parameters
        ----------
        shapes, M
            Shapes (n, nd) and mass matrix (nd, nd) in the coordinates of this class.
        """
        size = np.sqrt(np.abs(np.diag(M)))
        energy = (shapes.conj() * (shapes @ M)).real
        own = np.array([energy[:, np.concatenate(r.coordinates)].sum(axis=1) for r in self.rotors])
        sizes = [self.whirl(shapes, size, one) for one in range(len(self.rotors))]
        return [WAYS[int(np.argmax(sizes[int(most)][k]))] for k, most in enumerate(np.argmax(own, axis=0))]


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
