# SPDX-License-Identifier: Apache-2.0
"""Eigenvalues and modes from matrices: undamped and damped, with defined multiple and zero eigenvalues."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import SINGULAR
from pitchpoint.core.symmetric_pencil import symmetric_pencil
from pitchpoint.solvers.state_shares import OWN, Complex, state_shares

Array = NDArray[np.float64]

RIGID = 1e-11
"""Strain energy over the sum of the magnitudes of its terms, below which a mode counts as rigid."""
OVERLAP = 1e-4
"""Part of a shape outside the space of rigid rotations up to which it counts as rigid."""
SLOW = 1e-4
"""Eigenvalue over the largest up to which a mode is compared with the rigid rotations."""
LEFT_OVER = 1e-6
"""Eigenvalue over the largest below which a rigid mode counts as not oscillating."""
NEGATIVE = (
    "inertia is not positive in some direction, so there are no modes; check mass, inertia and inertia_tensor"
)
SAME = 1e-9
"""Relative distance of eigenvalues that count as one multiple eigenvalue."""


def _are_rigid(shapes: Array, rigid: Array, M: Array) -> NDArray[np.bool_]:
    """Which mass-normalised shapes (n, nd) are in the space of the rigid rotations."""
    if not len(rigid):
        return np.zeros(len(shapes), bool)
    L = np.linalg.cholesky(rigid @ M @ rigid.T)
    within = np.linalg.solve(L, rigid @ M @ shapes.T)
    return np.asarray((within**2).sum(axis=0) > 1.0 - OVERLAP)


def symmetric(A: Array) -> Array:
    """Symmetric part of a matrix."""
    return 0.5 * (A + A.T)


def undamped(M: Array, K: Array, basis: Array, rigid: Array) -> tuple[Array, Array]:
    """Circular frequencies [rad/s] and mass-normalised shapes (n, nd) of M x'' + K x = 0.

    Parameters
    ----------
    M, K
        Mass and stiffness matrix, shape (nd, nd); only their symmetric parts are used.
    basis
        Columns that span the free directions, shape (nd, n).
    rigid
        Free rigid rotations, shape (r, nd). The tangents of tilted gears assume a fixed line of action, so
        their frequency would be small but not zero.

    Raises
    ------
    SolverError
        If a free direction has no mass, or a negative one.
    """
    m, k, scale = scaled_pencil(M, K, basis)
    try:
        values, vectors = symmetric_pencil(k, m)
    except np.linalg.LinAlgError as problem:
        raise SolverError(NEGATIVE, SINGULAR) from problem
    return sorted_modes(m, k, scale, values, vectors, basis, rigid, M)


def scaled_pencil(M: Array, K: Array, basis: Any) -> tuple[Any, Any, Array]:
    """Symmetric mass and stiffness matrix of the free directions, scaled to a unit mass diagonal; the scale.

    Dense for a dense basis, sparse for a sparse basis.
    """
    if isinstance(basis, np.ndarray):
        m, k = (basis.T @ symmetric(A) @ basis for A in (M, K))
    else:
        from scipy.sparse import csc_array

        m, k = (basis.T @ csc_array(symmetric(A)) @ basis for A in (M, K))
    diagonal = m.diagonal()
    if not np.all(diagonal > 0.0):
        raise SolverError("a free direction has no mass, so it has no frequency", SINGULAR)
    scale = 1.0 / np.sqrt(diagonal)
    if isinstance(basis, np.ndarray):
        return scale[:, None] * m * scale, scale[:, None] * k * scale, scale
    from scipy.sparse import csc_array, diags_array

    left = diags_array(scale)
    return csc_array(left @ m @ left), csc_array(left @ k @ left), scale


def sorted_modes(
    m: Any,
    k: Any,
    scale: Array,
    values: Array,
    vectors: Array,
    basis: Any,
    rigid: Array,
    M: Array,
) -> tuple[Array, Array]:
    """Sorted frequencies and shapes, with rigid modes at zero and a unique basis of multiple eigenvalues.

    Parameters
    ----------
    m, k, scale
        As from `scaled_pencil`.
    values, vectors
        Eigenvalues (n,) and eigenvectors (nf, n), all or the lowest ones.
    basis, rigid, M
        As in `undamped`.
    """
    sizes = np.abs(vectors)
    terms = ((abs(k) @ sizes) * sizes).sum(axis=0)
    values[np.abs(((k @ vectors) * vectors).sum(axis=0)) <= RIGID * terms] = 0.0
    unsorted = (basis @ (scale[:, None] * vectors)).T
    # with unit masses, the largest eigenvalue is at least the largest diagonal entry
    largest = max(np.abs(values).max(initial=0.0), k.diagonal().max(initial=0.0))
    values[(np.abs(values) < SLOW * largest) & _are_rigid(unsorted, rigid, M)] = 0.0
    order = np.argsort(values, kind="stable")
    values, vectors = values[order], vectors[:, order]
    # for sparse matrices the (unit) diagonal of the masses is used
    moved = np.linalg.cholesky(m).T @ vectors if isinstance(m, np.ndarray) else vectors
    start = 0
    while start < values.size:
        stop = start + 1
        while stop < values.size and values[stop] - values[stop - 1] <= SAME * abs(values[stop]):
            stop += 1
        vectors[:, start:stop] = _settled(vectors[:, start:stop], moved[:, start:stop])
        start = stop
    return np.sign(values) * np.sqrt(np.abs(values)), (basis @ (scale[:, None] * vectors)).T


def _settled(block: Array, moved: Array) -> Array:
    """Unique basis of the shapes of a (multiple) eigenvalue.

    The first shape is the projection of the coordinate with the largest motion in the space; the others
    follow in the same way in the complement. Ties go to the first coordinate. That component is positive.
    `moved`: components in the mass norm.
    """
    rest, found = block, []
    for _ in range(block.shape[1]):
        sizes = np.linalg.norm(moved, axis=1)
        row = int(np.flatnonzero(sizes >= sizes.max() * (1.0 - 1e-6))[0])
        turn = moved[row] / sizes[row]
        found.append(rest @ turn)
        others = _complement(turn)
        rest, moved = rest @ others, moved @ others
    return np.column_stack(found)


def _complement(turn: Array) -> Array:
    """Orthonormal columns normal to a unit vector (its Householder reflection without one column)."""
    v = turn.copy()
    v[0] += np.copysign(1.0, v[0])
    reflection = np.eye(v.size) - 2.0 * np.outer(v, v) / (v @ v)
    return np.asarray(reflection[:, 1:])


def damped(
    D: Array, K: Array, shapes: Array, omega: Array
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Eigenvalues and shapes with damping, each assigned to the most similar undamped mode.

    Parameters
    ----------
    D, K
        Damping matrix, and the part of the stiffness matrix not included in the undamped modes: contributions
        of the speeds, and the unsymmetric part due to follower loads. Shape (nd, nd).
    shapes, omega
        Undamped modes, shape (n, nd) and (n,): a well-scaled basis of the problem.

    Returns
    -------
    eigenvalue (n,), shape in terms of the undamped modes (n, n), complex
    """
    n = len(shapes)
    k = np.diag(omega * np.abs(omega)) + shapes @ K @ shapes.T
    d = shapes @ D @ shapes.T
    unit = max(float(np.abs(omega).max(initial=0.0)), float(np.abs(d).max(initial=0.0)), 1e-300)
    # decoupled rigid modes are excluded: a double zero eigenvalue would lose half its digits
    size = np.abs(k) / unit**2 + np.abs(d) / unit
    tied = (omega != 0.0) | (size.max(axis=0, initial=0.0) > 1e-12) | (size.max(axis=1, initial=0.0) > 1e-12)
    values = np.zeros(n, np.complex128)
    z: NDArray[np.complex128] = np.eye(n, dtype=np.complex128)
    if np.any(tied):
        own = np.ix_(tied, tied)
        values[tied], z[own] = _quadratic(k[own] / unit**2, d[own] / unit)
        values[_left_over(values, omega == 0.0, d / unit)] = 0.0
    return np.asarray(values * unit, dtype=np.complex128), z


def _left_over(values: NDArray[np.complex128], rigid: NDArray[np.bool_], d: Array) -> NDArray[np.bool_]:
    """Which scaled eigenvalues of rigid rotations are rounding.

    Rigid rotations have no stiffness, so small oscillations are errors of the tangents. A small real value is
    half of the digits of a double zero, unless dampers drive the rotation.
    """
    own = d[np.ix_(rigid, rigid)]
    driven = bool(np.linalg.eigvalsh(symmetric(own)).min(initial=0.0) < -1e-12)
    small = rigid & (np.abs(values) < LEFT_OVER)
    return small & (values.imag > 0.0) if driven else small


def damped_with_states(
    M: Array, D: Array, K: Array, shapes: Array, omega: Array, states: Sequence[int], left: Array
) -> tuple[Complex, Complex, Complex]:
    """Eigenvalues and shapes of a system whose force elements have states.

    A state is stored as the rate of a coordinate whose value is not used: its first derivative is x''.

    Parameters
    ----------
    M, D, K
        Matrices of the whole system, shape (nd, nd).
    shapes, omega
        All undamped modes with constant states, shape (n, nd) and (n,).
    states
        Coordinates whose rates are the states, ns of them.
    left
        Part of K not included in the undamped modes, shape (nd, nd).

    Returns
    -------
    eigenvalue (n,) and shape over the coordinates (n, nd) of the undamped modes, and the other eigenvalues in
    which states take part, in ascending order, those with Im >= 0
    """
    from scipy.linalg import eig

    n, ns = len(shapes), len(states)
    own = list(states)
    mass = M[np.ix_(own, own)]
    A = np.zeros((2 * n + ns, 2 * n + ns))
    A[:n, n : 2 * n] = np.eye(n)
    A[n : 2 * n, :n] = -np.diag(omega * np.abs(omega)) - shapes @ left @ shapes.T
    A[n : 2 * n, n : 2 * n] = -shapes @ D @ shapes.T
    A[n : 2 * n, 2 * n :] = -shapes @ D[:, own]
    A[2 * n :, :n] = -np.linalg.solve(mass, K[own] @ shapes.T)
    A[2 * n :, n : 2 * n] = -np.linalg.solve(mass, D[own] @ shapes.T)
    A[2 * n :, 2 * n :] = -np.linalg.solve(mass, D[np.ix_(own, own)])
    found: Any = eig(A, left=True, right=True)
    values, lefts, vectors = found
    unit = max(float(np.abs(values).max(initial=0.0)), 1e-300)
    share = state_shares(values, vectors, lefts.conj(), slice(2 * n, None))
    upper = np.flatnonzero(values.imag > -1e-12 * unit)
    values, vectors, share = values[upper], vectors[:, upper], share[upper]
    values = np.where(np.abs(values.imag) <= 1e-12 * unit, values.real, values)
    z = vectors[:n] / np.maximum(np.linalg.norm(vectors[:n], axis=0), 1e-300)
    # assign modes by similarity of shape and frequency; eigenvalues of states have shapes of others
    size = np.maximum(np.abs(values), 1e-12 * unit)
    apart = np.abs(np.log(size / np.maximum(np.abs(omega), 1e-12 * unit)[:, None]))
    likeness = np.abs(z) ** 2 * np.where(values.imag > 0.0, 2.0, 1.0) / (1.0 + apart) * (1.0 - share)
    first = best_match(likeness) if n else np.zeros(0, np.intp)
    rest = np.setdiff1d(np.flatnonzero(share > OWN), first)
    rest = rest[np.argsort(np.abs(values[rest]), kind="stable")]
    own_values = values[first]
    rigid = omega == 0.0
    if not A[n : 2 * n, 2 * n :][rigid].any():  # no state acts on a rigid rotation
        own_values[_left_over(own_values / unit, rigid, -A[n : 2 * n, n : 2 * n] / unit)] = 0.0
    full = (shapes.T @ vectors[:n, first]).astype(np.complex128)
    still = np.abs(own_values) <= 1e-12 * unit
    full[own] = np.where(still, 0.0, vectors[2 * n :, first] / np.where(still, 1.0, own_values))
    return own_values, np.asarray(full.T), values[rest]


def _quadratic(k: Array, d: Array) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Eigenvalues of z'' + d z' + k z = 0, one of each pair, assigned to the coordinates; unit shapes."""
    n = len(k)
    values, vectors = np.linalg.eig(np.block([[np.zeros((n, n)), np.eye(n)], [-k, -d]]))
    upper = [j for j in range(2 * n) if values[j].imag > 1e-12]
    real = sorted((j for j in range(2 * n) if abs(values[j].imag) <= 1e-12), key=lambda j: values[j].real)
    upper += real[1::2]  # of a pair of real eigenvalues the slower one represents the mode
    z = vectors[:n, upper]
    z = z / np.linalg.norm(z, axis=0)
    columns = best_match(np.abs(z) ** 2)
    found = values[upper][columns]
    return np.where(np.abs(found) < 1e-12, 0.0, found), z[:, columns]


def best_match(likeness: Array) -> NDArray[np.intp]:
    """Assignment of a different column to each row with the largest sum of entries.

    Examples
    --------
    >>> best_match(np.array([[0.9, 0.2], [0.8, 0.6]]))
    array([0, 1])
    """
    if likeness.size == 0:  # no free coordinates
        return np.zeros(0, np.intp)
    columns = likeness.argmax(axis=1)
    if np.unique(columns).size < len(columns):  # conflicts are rare: import SciPy on demand
        from scipy.optimize import linear_sum_assignment

        columns = linear_sum_assignment(-likeness)[1]
    return np.asarray(columns)


def ratio_of(values: NDArray[np.complex128]) -> Array:
    """Damping ratio -Re/|eigenvalue|: 1 for an overdamped mode, -1 for a divergent one, 0 for a rigid one.

    Examples
    --------
    >>> ratio_of(np.array([-3.0 + 4.0j, -2.0, 0.0]))
    array([0.6, 1. , 0. ])
    """
    size = np.abs(values)
    return np.asarray(np.divide(-values.real, size, out=np.zeros(size.shape), where=size > 0.0))
