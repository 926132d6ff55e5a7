# SPDX-License-Identifier: Apache-2.0
"""Steady vibration of a linear system under harmonic loads: (K + i omega D - omega^2 M) q = B."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class HarmonicResponse:
    """Complex amplitudes of a vibration e^(i omega t), one column per load.

    Parameters
    ----------
    place
        Coordinates, shape (nd, ni); NaN if nothing resists a load.
    rate
        Their rates, and the states of elements, shape (nd, ni).
    left
        Loads that the constraints carry, shape (nd, ni).
    """

    place: Complex
    rate: Complex
    left: Complex


def harmonic_response(
    matrices: tuple[Any, Any, Any], basis: Any, states: Sequence[int], omega: float, B: Complex
) -> HarmonicResponse:
    """Response to harmonic loads at one circular frequency.

    Parameters
    ----------
    matrices
        M, D and K, dense or sparse, shape (nd, nd).
    basis
        Free directions: columns, shape (nd, n), sparse if the system is large.
    states
        Coordinates whose rates are states of elements.
    omega
        Circular frequency [rad/s].
    B
        Complex amplitudes of the loads, shape (nd, ni).

    Examples
    --------
    A mass of 2 kg on a spring of 50 N/m without damping at 4 rad/s: 1/(50 - 2 16) = 55.6 mm/N.

    >>> one = np.eye(1)
    >>> found = harmonic_response((2.0 * one, 0.0 * one, 50.0 * one), one, (), 4.0, one + 0j)
    >>> round(float(found.place[0, 0].real), 4)
    0.0556
    """
    M, D, K = matrices
    own = list(states)
    unit = np.eye(M.shape[0])[:, own]
    # the unknown of a state is the rate of its coordinate
    columns = [(K + 1j * omega * D - omega**2 * M) @ basis, (D + 1j * omega * M)[:, own]]
    if isinstance(basis, np.ndarray):
        y = _solved_dense(columns, basis, unit, B)
    else:
        y = _solved_sparse(columns, basis, unit, B)
    n = basis.shape[1]
    place = basis @ y[:n]
    return HarmonicResponse(
        place=np.asarray(place),
        rate=np.asarray(1j * omega * place + unit @ y[n:]),
        left=np.asarray(B - columns[0] @ y[:n] - columns[1] @ y[n:]),
    )


def _solved_dense(columns: Sequence[Any], basis: Any, unit: Any, B: Complex) -> Complex:
    """Response of the basis coordinates and states to loads; NaN if the matrix is singular."""
    rows = np.hstack([basis, unit]).T
    whole = np.hstack([c if isinstance(c, np.ndarray) else c.toarray() for c in columns])
    try:
        return np.asarray(np.linalg.solve(rows @ whole, rows @ B))
    except np.linalg.LinAlgError:
        return np.full((len(rows), B.shape[1]), np.nan + 0j)


def _solved_sparse(columns: Sequence[Any], basis: Any, unit: Any, B: Complex) -> Complex:
    """`_solved_dense` with sparse matrices."""
    from scipy.sparse import csc_array, hstack
    from scipy.sparse.linalg import splu

    rows = hstack([basis, csc_array(unit)]).T
    try:
        lu = splu((rows @ hstack([csc_array(c) for c in columns])).tocsc())
    except RuntimeError:  # a pivot is zero
        return np.full((rows.shape[0], B.shape[1]), np.nan + 0j)
    return np.asarray(lu.solve(rows @ B))
