# SPDX-License-Identifier: Apache-2.0
"""Lowest modes of large systems by shift-and-invert iterations, with a check that no mode is missing.

Lanczos iterations with (K + s M)^-1 find the modes closest to -s, below which there are none. The number of
eigenvalues below a value x is the number of negative pivots of K - x M (Sylvester's law of inertia). It
reveals missing copies of a multiple eigenvalue; they are then computed in the complement of the modes found.

Damping couples the requested modes with all others, so the damped modes are not computed in the span of the
undamped ones but in the whole space: Arnoldi iterations with (A - s B)^-1 B of the first-order form.

References
----------
.. [1] R. G. Grimes, J. G. Lewis, H. D. Simon: A shifted block Lanczos algorithm for solving sparse symmetric
   generalized eigenproblems, SIAM Journal on Matrix Analysis and Applications 15 (1994) 228-272.
.. [2] R. B. Lehoucq, D. C. Sorensen, C. Yang: ARPACK Users' Guide, SIAM 1998.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import DIVERGED, SINGULAR
from pitchpoint.core.symmetric_pencil import symmetric_pencil
from pitchpoint.solvers.eigen import NEGATIVE, best_match, scaled_pencil, sorted_modes
from pitchpoint.solvers.state_shares import Complex, state_shares

Array = NDArray[np.float64]

SHIFT = 1e-10
"""First shift over the largest stiffness per mass. Rigid modes then have six correct digits, enough to
identify them; all others are accurate to the rounding of the stiffness."""
GUARD = 8
"""Minimum number of modes computed beyond those requested."""
APART = 1e-6
"""Relative gap between eigenvalues at which the lower ones are counted."""
ROUNDS = 8
"""Maximum number of rounds to find missing modes."""
NEARER = 0.1
"""Shift of the damped modes over the lowest non-zero frequency."""
NONE = 1e-12
"""Sum of the forces on a rigid rotation over the sum of their magnitudes up to which they cancel."""
SAME = 1e-9
"""Part of a shape outside the rigid rotations without forces up to which it is one of them."""
STILL = 1e-5
"""Eigenvalue over that shift below which a mode is rigid: a double zero has half the digits only."""
MAX_SHIFT = 1e6
"""Shift over the largest stiffness above which an eigenvalue below it means negative mass."""
MAINLY = 0.5
"""Least share of the states in an eigenvalue that is listed as one of theirs. Of smaller ones it is not known
whether they belong to modes beyond those requested."""


def lowest_modes(M: Array, K: Array, basis: Any, rigid: Array, count: int) -> tuple[Array, Array]:
    """Frequencies and shapes of the lowest modes of M x'' + K x = 0; parameters as in `eigen.undamped`.

    Raises
    ------
    SolverError
        If a free direction has no mass, or modes are still missing after the last round.
    """
    m, k, scale = scaled_pencil(M, K, basis)
    n = m.shape[0]
    shift = least = SHIFT * max(float(abs(k).max()), 1e-300)
    lu, below = _factors(k, m, shift)
    while below:  # unstable: there are modes below the shift
        shift *= 100.0
        if not shift <= MAX_SHIFT * float(abs(k).max()):
            raise SolverError(NEGATIVE, SINGULAR)
        lu, below = _factors(k, m, shift)
    known = _without_forces((k,), m, _coordinates(basis, rigid) / scale[:, None])
    values, vectors = np.zeros(known.shape[1]), known
    if shift > least or known.shape[1] < count:
        values, vectors = _complete(m, k, lu, shift, known, min(count + max(GUARD, count // 4), n - 1))
    omega, shapes = sorted_modes(m, k, scale, values, vectors, basis, rigid, M)
    return omega[:count], shapes[:count]


def _factors(k: Any, m: Any, shift: float) -> tuple[Any, int]:
    """Factorise K + shift M; returns the factors and the number of negative eigenvalues."""
    from scipy.sparse.linalg import splu

    options = {"SymmetricMode": True}
    for nearly in (0.0, 1e-9, 1e-7):  # perturb the shift if a pivot is zero by chance
        try:
            lu = splu(
                (k + shift * (1.0 + nearly) * m).tocsc(),
                "MMD_AT_PLUS_A",
                diag_pivot_thresh=0.0,
                options=options,
            )
        except RuntimeError:
            continue
        # rows and columns in the same order: the pivots are those of L D L^T
        if np.array_equal(lu.perm_r, lu.perm_c):
            return lu, int(np.sum(lu.U.diagonal() < 0.0))
    raise SolverError("a free direction has neither mass nor stiffness, so it has no frequency", SINGULAR)


def _complete(m: Any, k: Any, lu: Any, shift: float, known: Array, count: int) -> tuple[Array, Array]:
    """Lowest eigenvalues and eigenvectors, with a check of their number; some eigenvectors are known."""
    n = m.shape[0]
    vectors = known
    values = np.zeros(0)
    missing = max(count - known.shape[1], GUARD)
    for turn in range(ROUNDS):
        more = _lanczos(m, k, lu, shift, vectors, min(missing, n - 1 - vectors.shape[1]), turn)
        both = np.hstack([vectors, more])
        values, mix = symmetric_pencil(both.T @ (k @ both), both.T @ (m @ both))
        vectors = both @ mix
        # count at the last gap, away from all eigenvalues
        size = np.abs(values) + shift
        gaps = np.flatnonzero(np.diff(values) > APART * size[1:])
        inside = int(gaps[-1]) + 1 if gaps.size else 0
        if not inside:
            return values, vectors
        at = values[inside] - 0.5 * APART * size[inside]
        missing = _factors(k, m, -at)[1] - inside
        if missing <= 0:  # the eigenvalues above the last gap are part of one multiple root
            return values, vectors
    raise SolverError(f"{missing} modes are missing among the lowest {inside}", DIVERGED)


def _lanczos(m: Any, k: Any, lu: Any, shift: float, found: Array, count: int, turn: int) -> Array:
    """Eigenvectors of the lowest eigenvalues, orthogonal to those found."""
    from scipy.sparse.linalg import LinearOperator, eigsh

    n = m.shape[0]
    carried = m @ found

    def solve(b: Array) -> Array:
        """Solve with the factors and remove the part along the vectors found."""
        x = lu.solve(np.asarray(b, dtype=float).ravel())
        return np.asarray(x - found @ (carried.T @ x))

    start = np.random.default_rng(turn).standard_normal(n)
    start -= found @ (carried.T @ start)
    if found.shape[1]:  # one more than the missing ones
        count = min(count + 1, n - 1)
    inverse = LinearOperator((n, n), matvec=solve, dtype=float)
    return np.asarray(
        eigsh(k, count, m, sigma=-shift, which="LM", OPinv=inverse, v0=start, ncv=min(n, 2 * count + 20))[1]
    )


def nearest_damped(
    matrices: tuple[Array, Array, Array],
    basis: Any,
    rigid: Array,
    states: Sequence[int],
    omega: Array,
    shapes: Array,
) -> tuple[Complex, Complex, Complex, float]:
    """Damped modes that correspond to the lowest undamped modes.

    Parameters
    ----------
    matrices
        M, D and K at speed, shape (nd, nd) each.
    basis
        Free directions, sparse, shape (nd, n).
    rigid
        Free rigid rotations, shape (r, nd).
    states
        Coordinates whose rates are states of force elements.
    omega, shapes
        Undamped modes: frequencies [rad/s] (m,) and shapes (m, nd).

    Returns
    -------
    eigenvalues (m,) and shapes over the coordinates (m, nd) of the undamped modes, the other eigenvalues that
    belong mainly to states, in ascending order, and the absolute value up to which these are complete

    Raises
    ------
    SolverError
        If the iteration does not converge.
    """
    A, B = _first_order(matrices, basis, states)
    n = basis.shape[1]
    m, here = B[n : 2 * n, n : 2 * n], A[n : 2 * n]
    loose = _without_forces((A[n:, :n], A[n:, n : 2 * n], here.T), m, _coordinates(basis, rigid))
    known = (omega == 0.0) & _inside(loose, m, _coordinates(basis, shapes))
    values, found = np.zeros(len(omega), np.complex128), shapes.astype(np.complex128)
    if known.all() and not states:
        return values, found, np.zeros(0, np.complex128), 0.0
    own, z, rest, reach = _iterate((A, B), matrices[0], basis, loose, states, omega[~known], shapes[~known])
    values[~known], found[~known] = own, z
    return values, found, rest, reach


def _coordinates(basis: Any, shapes: Array) -> Array:
    """Coordinates of shapes (m, nd) in the free directions, shape (n, m)."""
    from scipy.sparse.linalg import splu

    return np.asarray(splu((basis.T @ basis).tocsc()).solve(np.asarray(basis.T @ shapes.T)))


def _without_forces(forces: Sequence[Any], m: Any, rigid: Array) -> Array:
    """Rigid rotations (n, r) on which no stiffness or damping acts, orthonormal by the mass matrix.

    Their eigenvalue of zero is exact and separate from all others; an iteration would give the double one of
    first-order form half the digits only, and fail if there are hundreds.
    """
    size, free = abs(rigid), np.ones(rigid.shape[1], bool)
    for matrix in forces:
        bound = (abs(matrix) @ size).max(axis=0, initial=0.0)
        free &= abs(matrix @ rigid).max(axis=0, initial=0.0) <= NONE * bound
    rigid = rigid[:, free]
    L = np.linalg.cholesky(rigid.T @ (m @ rigid))
    return np.asarray(np.linalg.solve(L, rigid.T).T)


def _inside(loose: Array, m: Any, shapes: Array) -> NDArray[np.bool_]:
    """Which mass-normalised shapes (n, m) are in the space of the rigid rotations without forces."""
    return np.asarray(((loose.T @ (m @ shapes)) ** 2).sum(axis=0) > 1.0 - SAME)


def _iterate(
    pencil: tuple[Any, Any],
    M: Array,
    basis: Any,
    loose: Array,
    states: Sequence[int],
    omega: Array,
    shapes: Array,
) -> tuple[Complex, Complex, Complex, float]:
    """Damped modes as in `nearest_damped`, in the complement of the rigid rotations without forces."""
    from scipy.sparse import csc_array
    from scipy.sparse.linalg import splu

    A, B = pencil
    n, m = basis.shape[1], len(omega)
    size = A.shape[0] - 2 * loose.shape[1]
    moving = omega[omega > 0.0]
    shift = NEARER * float(moving.min() if moving.size else 1.0)
    lu: Any = splu((A - shift * B).tocsc())
    carried = B[n : 2 * n, n : 2 * n] @ loose

    def solve(x: Array) -> Array:
        """Solve with the factors and remove the rigid rotations from positions and rates."""
        y = np.asarray(lu.solve(B @ np.asarray(x).ravel()))
        for part in (y[:n], y[n : 2 * n]):
            part -= loose @ (carried.T @ part)
        return y

    def solve_left(x: Array) -> Array:
        """The same for left vectors times B."""
        y = np.asarray(B.T @ lu.solve(np.asarray(x).ravel(), "T"))
        for part in (y[:n], y[n : 2 * n]):
            part -= carried @ (loose.T @ part)
        return y

    count = min(2 * (m + max(GUARD, m // 4)) + len(states), size - 2)
    values, y = _eigenvectors(solve, A.shape, shift, count, size)
    share = np.zeros(values.size)
    if states:
        left_values, left = _eigenvectors(solve_left, A.shape, shift, count, size)
        order = best_match(-np.abs(values[:, None] - left_values))
        share = state_shares(values, y, left[:, order], slice(2 * n, None))
    reach = float(np.abs(values - shift).max(initial=0.0)) - shift
    upper = values.imag > -1e-10 * np.abs(values)
    values, y, share = values[upper], y[:, upper], share[upper]
    values = np.where(np.abs(values.imag) <= 1e-10 * np.abs(values), values.real, values)
    z = np.asarray((basis @ y[:n]).T, dtype=np.complex128)
    first = best_match(_likeness(csc_array(M), omega, shapes, values, z) * (1.0 - share))
    rest = np.setdiff1d(np.flatnonzero(share > MAINLY), first)
    rest = rest[np.argsort(np.abs(values[rest]), kind="stable")]
    still = np.zeros(values.size, bool)
    still[first[omega == 0.0]] = True
    still &= np.abs(values) < STILL * shift
    values[still] = 0.0
    if states:
        z[:, list(states)] = (y[2 * n :] / np.where(still, np.inf, values)).T
    return values[first], z[first], values[rest], reach


def _eigenvectors(
    solve: Callable[[Array], Array], shape: tuple[int, int], shift: float, count: int, size: int
) -> tuple[Complex, Complex]:
    """Eigenvalues closest to a shift, and vectors as columns; `solve`: product with the shifted inverse."""
    from scipy.sparse.linalg import ArpackError, LinearOperator, eigs

    start = solve(np.random.default_rng(0).standard_normal(shape[0]))
    inverse = LinearOperator(shape, matvec=solve, dtype=float)
    try:
        found, y = eigs(inverse, count, which="LM", v0=start, ncv=min(size, 2 * count + 20))
    except ArpackError as problem:
        raise SolverError(
            "the iteration for the damped modes did not converge; request another number of modes", DIVERGED
        ) from problem
    return shift + 1.0 / found, y


def _first_order(matrices: tuple[Array, Array, Array], basis: Any, states: Sequence[int]) -> tuple[Any, Any]:
    """Sparse A and B of B y' = A y: positions and rates in the free directions, and the states."""
    from scipy.sparse import block_array, csc_array, eye_array

    M, D, K = (csc_array(A) for A in matrices)
    own = list(states)
    n = basis.shape[1]
    m, d, k = ((basis.T @ A @ basis).tocsc() for A in (M, D, K))
    unit = eye_array(n, format="csc")
    A = [
        [None, unit, None],
        [-k, -d, -(basis.T @ D[:, own])],
        [-(K @ basis)[own], -(D @ basis)[own], -D[own][:, own]],
    ]
    B = [[unit, None, None], [None, m, None], [None, None, M[own][:, own]]]
    if not own:
        A, B = [row[:2] for row in A[:2]], [row[:2] for row in B[:2]]
    return block_array(A, format="csc"), block_array(B, format="csc")


def _likeness(M: Any, omega: Array, shapes: Array, values: Complex, z: Complex) -> Array:
    """Similarity of damped and undamped modes in shape and frequency, shape (m, candidates)."""
    size = np.sqrt(sum(np.einsum("ij,ij->i", part, (M @ part.T).T) for part in (z.real, z.imag)))
    within = np.abs((M @ shapes.T).T @ z.T) ** 2 / np.maximum(size, 1e-300) ** 2
    least = 1e-6 * float(np.abs(omega).max(initial=1e-300))
    fast = np.maximum(np.abs(values), least) / np.maximum(np.abs(omega), least)[:, None]
    vibrates = np.where(values.imag > 0.0, 2.0, np.where(fast > 1.0, 0.5, 1.0))
    return np.asarray(within * vibrates / (1.0 + np.abs(np.log(fast))))
