# SPDX-License-Identifier: Apache-2.0
"""Damped modes at many speeds: in the span of the exact modes at a few of them, or of single modes.

The modes at some speeds (snapshots) span a small space. The modes between these speeds are found in it with
the square of the small error of their shapes [1]_. The residual of every mode is evaluated, and where it is
too large the whole system is solved, whose modes join the space. A single mode close to a known one, as at a
crossing, is found by inverse iteration of the quadratic eigenvalue problem [2]_.

References
----------
.. [1] K.-J. Bathe: Finite Element Procedures, 2nd ed. 2014, section 10.3.2 (Rayleigh-Ritz analysis).
.. [2] A. Ruhe: Algorithms for the nonlinear eigenvalue problem, SIAM J. Numer. Anal. 10 (1973) 674-689.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.solvers.eigen import LEFT_OVER, symmetric
from pitchpoint.solvers.linear_system import Linearised, damped_modes, lowest

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Found = tuple[Complex, Complex]
One = tuple[complex, Complex]

GUARD = 6
"""Modes computed beyond those that are followed: a curve may pass its neighbours."""
RESIDUAL = 1e-4
"""Largest residual over the inertia forces, in the norm of the flexibility; the relative error of the
frequency is its square, times a ratio of neighbouring eigenvalues."""
KEPT = 1e-7
"""Least singular value of the snapshots, relative to the largest, of a vector of the basis."""
WORTHWHILE = 0.7
"""Largest basis over the number of free directions that is faster than the whole system."""
QUADRATIC, ROUNDING = 1e-8, 1e-12
"""Error over the change with speed, plus rounding, up to which matrices are quadratic functions of it."""
ITERATIONS, CONVERGED = 12, 1e-11
"""Maximum number of inverse iterations, and their last relative change of the eigenvalue."""
OWN = 0.5
"""Similarity from which an inverse iteration has found the mode from which it started."""


class WhirlModes:
    """Modes at any speed of one body.

    Parameters
    ----------
    linear
        The system about its operating point.
    at
        Function of the speed [rad/s] that returns the linear system.
    speeds
        Range of the speeds [rad/s].
    count
        Number of modes, the lowest at rest.
    """

    def __init__(
        self,
        linear: Linearised,
        at: Callable[[float], Linearised],
        speeds: Array,
        count: int | None,
    ) -> None:
        self.linear, self.count = linear, None if count is None else count + GUARD
        self.modes = lowest(linear, self.count)
        self.exact: dict[float, Found] = {}
        self.basis: Array | None = None
        changing = bool(linear.states) or not self.modes.omega.size
        self.over_speed = None if changing else _quadratic(linear, at, speeds)
        self._in_basis: Quadratic | None = None
        self.at = at if self.over_speed is None else self.over_speed.at
        self.reducible = self.over_speed is not None
        if self.reducible and len(speeds) > 6 and count is not None:
            for speed in (speeds[0], speeds[len(speeds) // 2], speeds[-1]):
                self._whole(float(speed))

    def solve(self, speed: float) -> Found:
        """Eigenvalues (n,) and shapes (n, nd) with modal mass 1 at a speed, in no particular order."""
        if speed in self.exact:
            return self.exact[speed]
        found = None if self.basis is None else self._reduced(speed)
        return self._whole(speed) if found is None else found

    def near(self, speed: float, value: complex, shape: Complex) -> tuple[complex, Complex]:
        """The mode at a speed that is similar to a given mode at a near speed: eigenvalue, shape (nd,)."""
        found = (self._in_basis_near if self.reducible else self._whole_near)(speed, value, shape)
        if found is not None:
            return found
        values, z = self.solve(speed)
        k = int(np.argmax(np.abs(shape.conj() @ self.linear.at_rest.M @ z.T)))
        return complex(values[k]), z[k]

    def _whole(self, speed: float) -> Found:
        """Modes of the whole system; they extend the basis."""
        system = self.at(speed)
        same = system.at_rest is self.linear.at_rest
        modes = self.modes if same else lowest(system, self.count)
        found = damped_modes(system, modes)
        values, z = found.values, normalised(found.shapes, system.at_rest.M)
        if self.reducible and self.count is not None:
            self.exact[speed] = values, z
            self._extend()
        return values, z

    def _extend(self) -> None:
        """Basis of all snapshots, orthonormal in energy; None if it is not worthwhile.

        In the norm of the masses, the omitted part could be small and still carry most of the residual: it
        consists of motions of high frequency.
        """
        rows = np.vstack(
            [
                self.modes.shapes[self.modes.omega == 0.0],
                *(part for _, z in self.exact.values() for part in (z.real, z.imag)),
            ]
        )
        B, M = self._free
        L = np.linalg.cholesky(self._energy)
        rows = np.linalg.solve(M, B.T @ self.linear.at_rest.M @ rows.T).T @ L
        _, sizes, basis = np.linalg.svd(rows, full_matrices=False)
        basis = np.linalg.solve(L.T, basis[sizes > KEPT * sizes[0]].T)
        fits = basis.shape[1] <= WORTHWHILE * len(L)
        self.basis, self._in_basis = B @ basis if fits else None, None

    @cached_property
    def _free(self) -> tuple[Array, Array]:
        """Free directions (nd, n), dense, and their mass matrix (n, n)."""
        given: Any = self.linear.basis
        B = given if isinstance(given, np.ndarray) else given.toarray()
        return B, symmetric(B.T @ self.linear.at_rest.M @ B)

    @cached_property
    def _energy(self) -> Array:
        """Stiffness of the free directions at rest plus that of a shift, positive definite, (n, n)."""
        B, M = self._free
        shift = float(np.median(np.abs(self.modes.omega)) ** 2)
        least = float(min(self.modes.omega.min(), 0.0) ** 2)  # negative for a stiffness that pushes away
        return symmetric(B.T @ self.linear.at_rest.K @ B) + (shift + 2.0 * least) * M

    def _projected(self, speed: float) -> tuple[Array, Array, Array]:
        """Mass, damping and stiffness matrix at a speed in the basis, or in the free directions."""
        assert self.over_speed is not None
        if self._in_basis is None:
            self._in_basis = self.over_speed.projected(self._free[0] if self.basis is None else self.basis)
        return self._in_basis.matrices(speed)

    def _reduced(self, speed: float) -> Found | None:
        """Modes in the basis; None if one of them is not accurate, or too few of them oscillate."""
        V = self.basis
        assert V is not None
        n, omega = V.shape[1], self.modes.omega
        m, d, k = self._projected(speed)
        stiffness, damping = np.linalg.solve(m, k), np.linalg.solve(m, d)
        unit = max(float(np.sqrt(np.abs(stiffness).max())), 1e-300)  # about the highest frequency
        A = np.zeros((2 * n, 2 * n))
        A[:n, n:] = np.eye(n)
        A[n:, :n], A[n:, n:] = -stiffness / unit**2, -damping / unit
        values, vectors = np.linalg.eig(A)
        upper = values.imag > LEFT_OVER
        count = int(np.sum(omega != 0.0))
        if int(upper.sum()) < count:
            return None  # overdamped modes are left to the whole system
        values, vectors = np.asarray(values[upper] * unit, np.complex128), vectors[:n, upper]
        order, system = np.argsort(np.abs(values))[:count], self.at(speed)
        values, z = values[order], normalised((V @ vectors[:, order]).T, system.at_rest.M)
        if not self._accurate(system, values, z):
            return None
        rigid = self.modes.shapes[omega == 0.0].astype(np.complex128)
        return np.concatenate([np.zeros(len(rigid)), values]), np.vstack([rigid, z])

    def _accurate(self, system: Linearised, values: Complex, z: Complex) -> bool:
        """Whether the residuals of modes are small."""
        B, M = self._free
        s = float(np.median(np.abs(values)) ** 2)
        columns = z.T
        r = system.at_rest.M @ columns * values**2 + system.D @ columns * values + system.K @ columns
        r = B.T @ r
        flexible = np.linalg.solve(symmetric(B.T @ system.K @ B) + s * M, r)
        energy = np.einsum("ij,ij->j", r.conj(), flexible).real
        scale = np.abs(values) ** 2
        return bool(np.all(energy <= RESIDUAL**2 * scale**2 / (scale + s)))

    def _in_basis_near(self, speed: float, value: complex, shape: Complex) -> One | None:
        """Mode in the basis from a start close to it."""
        B = self._free[0] if self.basis is None else self.basis
        return inverse_iteration(self._projected(speed), B, self.linear.at_rest.M, (value, shape))

    def _whole_near(self, speed: float, value: complex, shape: Complex) -> One | None:
        """Mode of the whole system from a start close to it; states are rates of their own coordinates."""
        system = self.at(speed)
        given: Any = system.basis
        B = given if isinstance(given, np.ndarray) else given.toarray()
        bare = [s for s in system.states if not B[s].any()]
        B = np.hstack([B, np.eye(len(B))[:, bare]])
        M = system.at_rest.M
        m, d, k = (B.T @ A @ B for A in (M, system.D, system.K))
        return inverse_iteration((m, d, k), B, M, (value, shape))


def inverse_iteration(matrices: tuple[Array, Array, Array], B: Array, M: Array, start: One) -> One | None:
    """Mode of a quadratic eigenvalue problem from a start close to it; None if it converges to another mode.

    Parameters
    ----------
    matrices
        Mass, damping and stiffness in the columns of B, shape (n, n).
    B
        Directions, shape (nd, n).
    M
        Mass matrix of the whole system, shape (nd, nd).
    start
        Eigenvalue and shape (nd,) close to the mode.
    """
    m, d, k = matrices
    value, shape = start
    x = np.linalg.solve(m, B.T @ (M @ shape))
    begun = x
    for _ in range(ITERATIONS):
        try:
            u = np.linalg.solve(value**2 * m + value * d + k, 2.0 * value * (m @ x) + d @ x)
        except np.linalg.LinAlgError:  # the eigenvalue is exact
            break
        step = np.vdot(x, x) / np.vdot(x, u)
        value, x = complex(value - step), u / np.linalg.norm(u)
        if abs(step) < CONVERGED * abs(value):
            break
    else:
        return None
    alike = abs(np.vdot(begun, m @ x)) ** 2 / (np.vdot(begun, m @ begun) * np.vdot(x, m @ x)).real
    if alike < OWN or value.imag <= 0.0:
        return None
    return value, normalised((B @ x)[None], M)[0]


@dataclass(frozen=True, eq=False)
class Quadratic:
    """The linear system as quadratic function of the speed.

    Parameters
    ----------
    linear
        The system about its operating point.
    low, high
        Lowest and highest speed [rad/s].
    M
        Mass matrix, shape (n, n).
    D, K
        Damping and stiffness matrices at the lowest, mean and highest speed, shape (3, n, n).
    """

    linear: Linearised
    low: float
    high: float
    M: Array
    D: Array
    K: Array

    def matrices(self, speed: float) -> tuple[Array, Array, Array]:
        """M, D and K at a speed [rad/s]: interpolation between three speeds."""
        x = (speed - self.low) / (self.high - self.low)
        shares = np.array([(2.0 * x - 1.0) * (x - 1.0), 4.0 * x * (1.0 - x), x * (2.0 * x - 1.0)])
        return self.M, np.tensordot(shares, self.D, axes=1), np.tensordot(shares, self.K, axes=1)

    def at(self, speed: float) -> Linearised:
        """The linear system at a speed [rad/s]."""
        _, D, K = self.matrices(speed)
        return replace(self.linear, D=D, K=K)

    def projected(self, basis: Array) -> Quadratic:
        """The same in the columns of a basis (nd, n)."""
        M, D, K = (basis.T @ A @ basis for A in (self.M, self.D, self.K))
        return replace(self, M=M, D=D, K=K)


def _quadratic(linear: Linearised, at: Callable[[float], Linearised], speeds: Array) -> Quadratic | None:
    """The linear system as quadratic function of the speed; None if it is not one.

    Gyroscopic terms grow with the speed, centrifugal ones with its square. Laws of bearings and motors may
    depend on the speed in other ways, and bodies in trees move, which changes masses and free directions.
    """
    low, high = float(np.min(speeds)), float(np.max(speeds))
    if high - low <= 0.0 or len(speeds) <= 4:
        return None
    try:
        nodes = [at(s) for s in (low, 0.5 * (low + high), high)]
    except SolverError:  # no equilibrium at one of them
        return None
    if not all(_same_inertia(linear, node) for node in nodes):
        return None
    D, K = (np.array([getattr(node, name) for node in nodes]) for name in "DK")
    found = Quadratic(linear, low, high, linear.at_rest.M, D, K)
    for share in (0.23, 0.81):
        speed = low + share * (high - low)
        given, between = at(speed), found.at(speed)
        for name, nodes_of in (("D", D), ("K", K)):
            exact = getattr(given, name)
            change = float(np.abs(exact - nodes_of[0]).max())
            least = QUADRATIC * change + ROUNDING * float(np.abs(exact).max())
            if np.abs(exact - getattr(between, name)).max() > least:
                return None
    return found


def _same_inertia(one: Linearised, two: Linearised) -> bool:
    """Whether masses and free directions are the same."""
    M = one.at_rest.M
    if np.abs(two.at_rest.M - M).max() > ROUNDING * np.abs(M).max() or one.basis.shape != two.basis.shape:
        return False
    return bool(abs(one.basis - two.basis).max() <= ROUNDING)


def normalised(z: Complex, M: Array) -> Complex:
    """Complex shapes (n, nd) with modal mass 1."""
    mass = ((z.conj() @ M) * z).sum(axis=1).real
    return np.asarray(z / np.sqrt(np.maximum(mass, 1e-300))[:, None])
