# SPDX-License-Identifier: Apache-2.0
"""Compliance of flanks divided into planes over the width, for teeth in contact at any heights.

Derivation: docs/theory/tooth_fe.md, "Planes".
"""

from __future__ import annotations

import math

import numpy as np
from numpy.polynomial.legendre import leggauss, legvander
from numpy.typing import NDArray

from pitchpoint.contact.compliance.description import FlankCompliance
from pitchpoint.contact.compliance.heights import congruence, fitted
from pitchpoint.contact.tooth_fe.tooth import ToothFE
from pitchpoint.contact.tooth_fe.width_basis import WidthBasis

FloatArray = NDArray[np.float64]

_FLOOR = 1e-9
"""Smallest eigenvalue of the compliance of a tooth relative to its largest; above round-off errors."""
_COMMON = 0.95
"""Largest part of the compliance of a tooth that is common to all teeth, in any pattern of forces."""
_HEIGHTS = 24
"""Heights at which fewer polynomials are fitted."""
_NEIGHBOUR = 0.5
"""Largest ratio of coupling to own compliance for which any number of teeth is positive semidefinite."""


def flank_fields(
    tooth: ToothFE, n: int, span: tuple[float, float] | None = None, heights: int | None = None
) -> FlankCompliance:
    """Compliance of n equal planes of the left flanks, without local approach.

    Parameters
    ----------
    tooth
        Finite elements of the gear.
    n
        Number of planes.
    span
        Lower and upper end of the planes over the width [m] from the middle of the gear; None: face width.
    heights
        Number of polynomials over the height; None: all of the finite elements.

    Notes
    -----
    The local approach refers to the depth from the flank to the centre line
    (`pitchpoint.contact.tooth_fe.local_part.contact_depth`), times cos β_b along the normal.

    The displacement that all teeth share is the mean one of the tooth after the next, limited so that the
    rest is positive semidefinite. The coupling of neighbours is limited so that any number of teeth is
    positive semidefinite; `provenance["coupling_ratio"]` above 0.5 shows that this was necessary.

    Examples
    --------
    One polynomial over height and width:

    >>> one = np.ones((1, 1, 1, 1))
    >>> tooth = ToothFE(width=2.0, roll=np.array([0.0, 1.0]), same=4.0 * one, next=1.5 * one, far=0.5 * one,
    ...     contact=np.zeros(1), tangents=np.zeros(1), fillet=np.zeros((1, 2)),
    ...     stress=np.ones((1, 3, 1, 3, 1, 1)), provenance={})
    >>> found = flank_fields(tooth, 1)
    >>> [round(float(c), 12) for c in (found.windup, found.own[0, 0, 0, 0], found.beside[0, 0, 0, 0])]
    [0.25, 1.75, 0.5]
    """
    M, P = heights or tooth.same.shape[0], tooth.same.shape[1]
    basis = WidthBasis(tooth.width, P)
    low, high = span or (-0.5 * tooth.width, 0.5 * tooth.width)
    means = basis.means(np.linspace(low, high, n + 1))
    size = (M * P, M * P)
    same, coupled = (part[:M, :, :M].reshape(size) for part in (tooth.same, tooth.next))
    own, coupled, windup, ratio = separated(
        same, coupled, float(tooth.far[0, 0, 0, 0]) / tooth.width, tooth.width
    )
    turn = _fewer_heights(tooth, own.reshape(M, P, M, P)[:, 0, :, 0], windup)
    planes = [
        np.einsum("ip,km,mpnq,ln,jq->ijkl", means, turn, part.reshape(M, P, M, P), turn, means, optimize=True)
        for part in (own, coupled)
    ]
    contact = np.outer(tooth.contact[:M], tooth.contact[:M]) * n / (high - low)
    planes[0][np.arange(n), np.arange(n)] += contact
    return FlankCompliance(
        (float(tooth.roll[0]), float(tooth.roll[1])),
        0.5 * (planes[0] + planes[0].transpose(1, 0, 3, 2)),
        planes[1],
        windup,
        {**tooth.provenance, "coupling_ratio": ratio, "C_M": 1.0},
    )


def _fewer_heights(tooth: ToothFE, own: FloatArray, windup: float) -> FloatArray:
    """Matrix that fits the compliance at equal heights, shape (M, M); identity if no polynomial was omitted.

    Parameters
    ----------
    tooth
        Finite elements of the gear.
    own
        Compliance in the polynomials that remain, for forces uniform over the width, shape (M, M).
    windup
        Displacement that is not part of it [m/N].
    """
    M, whole = len(own), tooth.same[:, 0, :, 0].copy()
    if len(whole) == M:
        return np.eye(M)
    whole[0, 0] -= windup * tooth.width
    t, weights = leggauss(_HEIGHTS)
    shape = legvander(t, len(whole) - 1)
    return congruence(own, fitted(t, weights, shape @ whole @ shape.T, M))


def separated(
    same: FloatArray, coupled: FloatArray, common: float, width: float
) -> tuple[FloatArray, FloatArray, float, float]:
    """Compliances of a tooth and its neighbour without a common displacement of all teeth.

    Parameters
    ----------
    same, coupled
        Compliances of the loaded tooth and of the tooth before it, shape (k, k); the first value is the
        uniform one.
    common
        Common displacement by a unit force [m/N].
    width
        Face width [m].

    Returns
    -------
    own, coupled : ndarray, shape (k, k)
    windup : float
        The part of `common` that was separated.
    ratio : float
        Largest ratio of coupling to own compliance; coupling is reduced to 0.5 in patterns above it.

    Notes
    -----
    If own^(-1/2) C own^(-1/2) of the coupling C has a norm of at most 1/2, own + e^(iφ) C + e^(-iφ) Cᵀ is
    positive semidefinite for all φ, and so is the matrix of any number of teeth (block Toeplitz matrices: U.
    Grenander and G. Szegö, Toeplitz Forms and their Applications, 1958).

    Examples
    --------
    >>> own, coupled, windup, ratio = separated(np.array([[4.0]]), np.array([[1.5]]), 0.25, 2.0)
    >>> own.round(12).tolist(), coupled.round(12).tolist(), windup, round(ratio, 4)
    ([[3.5]], [[1.0]], 0.25, 0.2857)
    """
    uniform = np.zeros(len(same))
    uniform[0] = math.sqrt(width)
    values, vectors = _positive(same)
    along = vectors.T @ uniform
    windup = min(max(0.0, common), _COMMON / float(along @ (along / values)))
    shared = windup * np.outer(uniform, uniform)
    own, coupling = same - shared, coupled - shared
    values, vectors = _positive(own)
    root = (vectors * np.sqrt(values)) @ vectors.T
    inverse = (vectors / np.sqrt(values)) @ vectors.T
    left, ratios, right = np.linalg.svd(inverse @ coupling @ inverse)
    if ratios[0] > _NEIGHBOUR:
        coupling = root @ (left * np.minimum(ratios, _NEIGHBOUR)) @ right @ root
    return own, coupling, windup, float(ratios[0])


def _positive(matrix: FloatArray) -> tuple[FloatArray, FloatArray]:
    values, vectors = np.linalg.eigh(matrix)
    return np.maximum(values, _FLOOR * values[-1]), vectors
