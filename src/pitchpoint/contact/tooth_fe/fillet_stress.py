# SPDX-License-Identifier: Apache-2.0
"""Stress of fillets by forces on planes of the flanks.

Derivation: docs/theory/tooth_fe.md, "Root stress".
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial.legendre import legvander
from numpy.typing import NDArray

from pitchpoint.contact.tooth_fe.tooth import ToothFE
from pitchpoint.contact.tooth_fe.width_basis import WidthBasis

FloatArray = NDArray[np.float64]


def stress_by_planes(
    tooth: ToothFE, n: int, at: FloatArray, span: tuple[float, float] | None = None
) -> FloatArray:
    """Stress of the fillet at the loaded side of a tooth per force on a plane and polynomial of its height.

    Parameters
    ----------
    tooth
        Finite elements of the gear.
    n
        Number of planes.
    at
        Positions over the width [m] from the middle of the gear, shape (k,).
    span
        Lower and upper end of the planes [m]; None: face width.

    Returns
    -------
    ndarray, shape (F, 3, k, 3, n, M)
        Stress [1/m²] at F points of the fillet: along the profile, along the width, shear; at k positions; by
        forces on the previous, the same and the next tooth (counter-clockwise), on planes, times P_m(t).

    Examples
    --------
    One polynomial over height and width, 1/√2 over the width of 2 m:

    >>> one = np.ones((1, 1, 1, 1))
    >>> tooth = ToothFE(width=2.0, roll=np.array([0.0, 1.0]), same=4.0 * one, next=1.5 * one, far=0.5 * one,
    ...     contact=np.zeros(1), tangents=np.zeros(1), fillet=np.zeros((1, 2)),
    ...     stress=np.ones((1, 3, 1, 3, 1, 1)), provenance={})
    >>> stress_by_planes(tooth, 1, np.zeros(1))[0, 0, 0, :, 0, 0].round(12).tolist()
    [0.5, 0.5, 0.5]
    """
    basis = WidthBasis(tooth.width, tooth.same.shape[1])
    low, high = span or (-0.5 * tooth.width, 0.5 * tooth.width)
    means = basis.means(np.linspace(low, high, n + 1))
    return np.einsum("kp,fcpsmq,jq->fcksjm", basis.values(at), tooth.stress, means, optimize=True)


def principal_stress(stress: FloatArray) -> FloatArray:
    """Principal stress in a surface whose direction is nearer to the profile [Pa].

    Parameters
    ----------
    stress
        Stress along the profile and along the width, and shear stress [Pa], shape (3, ...).

    Notes
    -----
    Bending stress of a tooth, at right angles to its trace: tension and compression with their signs.

    Examples
    --------
    >>> principal_stress(np.array([[100.0, -3.0], [0.0, 0.0], [0.0, 2.0]])).tolist()
    [100.0, -4.0]
    """
    mean, half = 0.5 * (stress[0] + stress[1]), 0.5 * (stress[0] - stress[1])
    return np.asarray(mean + np.copysign(np.hypot(half, stress[2]), half))


def stress_of_teeth(by_planes: FloatArray, height: FloatArray, force: FloatArray) -> FloatArray:
    """Principal stress of the fillets of adjacent teeth, due to the forces on them and on their neighbours.

    Parameters
    ----------
    by_planes
        Stress per force, shape (F, 3, k, 3, n, M) as of `stress_by_planes`.
    height
        Heights of the forces (-1 at the root end of the involute, +1 at its tip end), shape (..., T, n).
    force
        Forces on n planes of T teeth, counter-clockwise, along the transverse base tangent [N], shape of
        `height`.

    Returns
    -------
    ndarray, shape (..., T, F, k)
        `principal_stress` [Pa].

    Examples
    --------
    Stress along the profile: 3 per force on the same tooth, -1 per force on the next one:

    >>> by_planes = np.zeros((1, 3, 1, 3, 1, 1))
    >>> by_planes[0, 0, 0, :, 0, 0] = 0.0, 3.0, -1.0
    >>> stress_of_teeth(by_planes, np.zeros((3, 1)), np.array([[1.0], [10.0], [0.0]])).ravel().tolist()
    [-7.0, 30.0, 0.0]
    """
    loads = force[..., None] * legvander(np.clip(height, -1.0, 1.0), by_planes.shape[-1] - 1)
    none = np.zeros_like(loads[..., :1, :, :])
    padded = np.concatenate([none, loads, none], axis=-3)
    teeth = loads.shape[-3]
    around = np.stack([padded[..., k : k + teeth, :, :] for k in range(3)], axis=-3)
    return principal_stress(np.einsum("...sjm,fcksjm->c...fk", around, by_planes, optimize=True))
