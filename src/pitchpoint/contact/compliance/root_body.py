# SPDX-License-Identifier: Apache-2.0
"""Compliance of the gear body under the root of one tooth: half plane, Weber and Banaschek, Sainsot et al.

All of these formulas have the form of Weber and Banaschek: with the moment y c, the shear force c and the
normal force s on the root strip of width s_f, per unit length of the tooth,

    E C = c c' [L* y y'/s_f² + M* (y + y')/(2 s_f) + P*] + s s' P* Q*.

Derivation: docs/theory/flank_compliance.md, "The gear body".
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.stiffness.tooth_compliance import RATIO_RANGE, THETA_RANGE, body_coefficients
from pitchpoint.core.errors import GeometryError

Array = NDArray[np.float64]


@dataclass(frozen=True)
class RootCoefficients:
    """Coefficients L*, M*, P* and Q* of the gear body [-]; Q* is relative to P*."""

    L: float
    M: float
    P: float
    Q: float

    def matrix(self, chord: float, E: float) -> Array:
        """Compliance for moment, shear and normal force on the root strip, per unit length of the tooth.

        Parameters
        ----------
        chord
            Width of the root strip s_f [m].
        E
            Young's modulus [Pa].

        Returns
        -------
        ndarray, shape (3, 3)
            Rotation and displacements per load: [1/N, 1/(N m), 1/Pa] units of m.
        """
        L, M = self.L / (chord * chord), 0.5 * self.M / chord
        return np.array([[L, M, 0.0], [M, self.P, 0.0], [0.0, 0.0, self.P * self.Q]]) / E


def weber_banaschek(nu: float) -> RootCoefficients:
    """Body of Weber and Banaschek, independent of the blank.

    Parameters
    ----------
    nu
        Poisson's ratio.

    Notes
    -----
    (1 − ν²)/E cos² α {18/π y²/s_f² + 2 (1 − 2ν)/(1 − ν) y/s_f + 4.8/π [1 + (1 − ν)/2.4 tan² α]}. C. Weber and
    K. Banaschek (1953/55), for ν = 0.3; here for any ν.

    Examples
    --------
    >>> body = weber_banaschek(0.3)
    >>> [round(v, 4) for v in (body.L, body.M, body.P, body.Q)]
    [5.2139, 1.04, 1.3904, 0.2917]
    """
    share = 1.0 - nu * nu
    return RootCoefficients(
        L=18.0 / math.pi * share,
        M=2.0 * (1.0 - 2.0 * nu) / (1.0 - nu) * share,
        P=4.8 / math.pi * share,
        Q=(1.0 - nu) / 2.4,
    )


def half_plane(chord: float, depth: float, nu: float) -> RootCoefficients:
    """Elastic half plane under the root of a tooth, plane strain.

    Parameters
    ----------
    chord
        Width S of the loaded strip [m].
    depth
        Depth H of the reference point below the middle of the strip [m].
    nu
        Poisson's ratio.

    Raises
    ------
    GeometryError
        If the depth is not positive.

    Notes
    -----
    Moment by linear normal traction, shear and normal force by uniform tractions; rotations and displacements
    are the energetic means over the strip. Displacements are relative to the point at the depth H, because
    those of a half plane have no bound. With the line loads of Flamant (S. P. Timoshenko and J. N. Goodier,
    *Theory of Elasticity*, 3rd ed. (1970), art. 36), A = 2 (1 − ν²)/π, C = (1 + ν)/π, h = S/2 and
    a = H/h atan(h/H):

    * L* = 18 (1 − ν²)/π, M* = 2 (1 − 2ν)(1 + ν)
    * P* = A [1/2 + ln(√(h² + H²)/S) + a] + C a
    * P* Q* = A [1/2 + ln(√(h² + H²)/S) + a] − C a

    Examples
    --------
    >>> body = half_plane(1.8, 2.7, 0.3)
    >>> [round(v, 7) for v in (body.L, body.M, body.P, body.Q)]
    [5.2139159, 1.04, 1.5136939, 0.4722528]
    """
    if not (math.isfinite(depth) and depth > 0.0):
        raise GeometryError(
            "is not a depth of the gear body", where="depth", value=f"{1e3 * depth:.6g} mm", limit="above 0"
        )
    A, C, h = 2.0 * (1.0 - nu * nu) / math.pi, (1.0 + nu) / math.pi, 0.5 * chord
    a = depth / h * math.atan2(h, depth)
    common = A * (0.5 + math.log(math.hypot(h, depth) / chord) + a)
    P = common + C * a
    return RootCoefficients(
        L=18.0 * (1.0 - nu * nu) / math.pi, M=2.0 * (1.0 - 2.0 * nu) * (1.0 + nu), P=P, Q=(common - C * a) / P
    )


def sainsot(theta_f: float, radius_ratio: float) -> RootCoefficients:
    """Elastic disc clamped at its bore: fit of Sainsot, Velex and Duverger, only inside its range.

    Parameters
    ----------
    theta_f
        Half tooth angle at the root circle [rad].
    radius_ratio
        Root radius over bore radius.

    Raises
    ------
    GeometryError
        If an argument is outside the range of the fit.

    Notes
    -----
    Coefficients of `pitchpoint.contact.stiffness.tooth_compliance.body_coefficients`; P. Sainsot, P. Velex
    and O. Duverger, J. Mech. Des. 126 (2004) 748. s_f is the arc 2 r_f θ_f of the root circle.

    Examples
    --------
    >>> body = sainsot(0.05, 3.0)
    >>> [round(v, 4) for v in (body.L, body.M, body.P, body.Q)]
    [6.9271, 1.19, 4.3241, 0.4378]
    """
    for where, value, (low, high) in (
        ("half tooth angle at the root circle [rad]", theta_f, THETA_RANGE),
        ("root radius over bore radius", radius_ratio, RATIO_RANGE),
    ):
        if not low <= value <= high:
            raise GeometryError(
                "is outside the range of the gear body formula of Sainsot, Velex and Duverger (2004)",
                where=where,
                value=f"{value:.4g}",
                limit=f"{low:g} to {high:g}",
                remedy="use body: weber_banaschek, half_plane or ring",
            )
    return RootCoefficients(*body_coefficients(theta_f, radius_ratio))
