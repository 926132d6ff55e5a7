# SPDX-License-Identifier: Apache-2.0
"""Compliance of flanks divided into planes over the width, for teeth in contact at any heights.

Derivation: docs/theory/tooth_fe.md, "Planes".
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.tooth_fe.tooth import ToothFE
from pitchpoint.contact.tooth_fe.width_basis import WidthBasis

FloatArray = NDArray[np.float64]

_FLOOR = 1e-9
"""Smallest eigenvalue of the compliance of a tooth relative to its largest; above round-off errors."""
_COMMON = 0.95
"""Largest part of the compliance of a tooth that is common to all teeth, in any pattern of forces."""
_NEIGHBOUR = 0.5
"""Largest ratio of coupling to own compliance for which any number of teeth is positive semidefinite."""


@dataclass(frozen=True)
class FlankFields:
    """Compliance of the left flanks of one gear.

    A force f_j on plane j, uniform over the width of the plane and at the height t_j, displaces plane i by
    Σ P_m(t_i) C_ijmn P_n(t_j) f_j, mean over the plane. Force and displacement are along the transverse base
    tangent.

    Parameters
    ----------
    roll
        Lengths of roll [m] at t = -1 and t = +1.
    own
        Same tooth, without local indentation and windup [m/N], shape (n, n, M, M).
    beside
        Tooth k by a force on tooth k + 1, the next one counter-clockwise [m/N], shape (n, n, M, M).
    windup
        Displacement of all flanks by a force on any of them [m/N].
    provenance
        Settings of the calculation.
    """

    roll: tuple[float, float]
    own: FloatArray
    beside: FloatArray
    windup: float
    provenance: Mapping[str, Any]


def flank_fields(
    tooth: ToothFE, n: int, span: tuple[float, float] | None = None, heights: int | None = None
) -> FlankFields:
    """Compliance of n equal planes.

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
    Local indentation is to be added with the depth from flank to centre line
    (`pitchpoint.contact.tooth_fe.local_part.contact_depth`), times cos β_b in the normal section. The right
    flank of the same gear has the same compliance with the planes in reverse order.

    Windup is the mean displacement of the tooth after the next one, limited so that `own` remains positive
    semidefinite. `beside` is limited so that the compliance of any number of neighbouring teeth is positive
    semidefinite; `provenance["coupling_ratio"]` above 0.5 shows that this was necessary.
    """
    M, P = heights or tooth.same.shape[0], tooth.same.shape[1]
    basis = WidthBasis(tooth.width, P)
    low, high = span or (-0.5 * tooth.width, 0.5 * tooth.width)
    means = basis.means(np.linspace(low, high, n + 1))
    size = (M * P, M * P)
    same, next_, far = (part[:M, :, :M].reshape(size) for part in (tooth.same, tooth.next, tooth.far))
    own, beside, windup, ratio = separated(same, next_, float(far[0, 0]) / tooth.width, tooth.width)
    planes = [
        np.einsum("ip,mpnq,jq->ijmn", means, part.reshape(M, P, M, P), means, optimize=True)
        for part in (own, beside)
    ]
    contact = np.outer(tooth.contact[:M], tooth.contact[:M]) * n / (high - low)
    planes[0][np.arange(n), np.arange(n)] += contact
    return FlankFields(
        roll=(float(tooth.roll[0]), float(tooth.roll[1])),
        own=planes[0],
        beside=planes[1],
        windup=windup,
        provenance={**tooth.provenance, "coupling_ratio": ratio},
    )


def separated(
    same: FloatArray, beside: FloatArray, common: float, width: float
) -> tuple[FloatArray, FloatArray, float, float]:
    """Compliances of a tooth and its neighbour without a common displacement of all teeth.

    Parameters
    ----------
    same, beside
        Compliances of the tooth and of the tooth before the loaded one, shape (k, k); the first value is the
        uniform one.
    common
        Common displacement by a unit force [m/N].
    width
        Face width [m].

    Returns
    -------
    own, beside : ndarray, shape (k, k)
    windup : float
        The part of `common` that was separated.
    ratio : float
        Largest ratio of coupling to own compliance; `beside` is reduced to 0.5 in patterns above it.

    Notes
    -----
    For B = own^(-1/2) beside own^(-1/2) with a norm of at most 1/2, own + e^(iφ) beside + e^(-iφ) besideᵀ is
    positive semidefinite for all φ, and so is the matrix of any number of teeth (block Toeplitz matrices: U.
    Grenander and G. Szegö, Toeplitz Forms and their Applications, 1958).
    """
    uniform = np.zeros(len(same))
    uniform[0] = math.sqrt(width)
    values, vectors = _positive(same)
    along = vectors.T @ uniform
    windup = min(max(0.0, common), _COMMON / float(along @ (along / values)))
    shared = windup * np.outer(uniform, uniform)
    own, coupling = same - shared, beside - shared
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
