# SPDX-License-Identifier: Apache-2.0
"""Cones of bevel gears: pitch cone angles of a pair, and the involute on a sphere about the apex."""

from __future__ import annotations

import math

from pitchpoint.core.errors import GeometryError


def pitch_angles(z1: int, z2: int, Sigma: float) -> tuple[float, float]:
    """Pitch cone angles of a pair of bevel gears.

    Parameters
    ----------
    z1, z2
        Numbers of teeth.
    Sigma
        Shaft angle Σ [rad], between the directions from the apex into both gears.

    Returns
    -------
    delta1, delta2 : float
        tan δ₁ = sin Σ / (z₂/z₁ + cos Σ), δ₂ = Σ − δ₁ [rad].

    Raises
    ------
    GeometryError
        If Σ is not between 0 and π, or if a pitch cone angle is π/2 or more (crown or internal bevel gear).

    Notes
    -----
    ISO 23509. From R sin δ₁ / z₁ = R sin δ₂ / z₂ and δ₁ + δ₂ = Σ.

    Examples
    --------
    >>> [round(math.degrees(d), 5) for d in pitch_angles(20, 40, math.radians(90.0))]
    [26.56505, 63.43495]
    """
    if not 0.0 < Sigma < math.pi:
        raise GeometryError(
            "is not possible", where="shaft_angle", value=f"{Sigma!r} rad", limit="above 0 and below 180 deg"
        )
    delta1 = math.atan2(math.sin(Sigma), z2 / z1 + math.cos(Sigma))
    delta2 = math.atan2(math.sin(Sigma), z1 / z2 + math.cos(Sigma))
    widest = max(delta1, delta2)
    if widest >= 0.5 * math.pi:
        raise GeometryError(
            "opens a pitch cone too far",
            where="shaft_angle",
            value=f"{math.degrees(Sigma):.6g} deg",
            limit=f"a pitch cone angle below 90 deg, here {math.degrees(widest):.6g} deg",
            remedy="use a smaller shaft angle; crown and internal bevel gears are not possible",
        )
    return delta1, delta2


def spherical_involute(sigma: float, delta_b: float) -> float:
    """Azimuth of a point of a spherical involute, measured from its start on the base cone.

    Parameters
    ----------
    sigma
        Arc unrolled from the base cone, seen from the apex [rad], 0 to π.
    delta_b
        Base cone angle [rad].

    Returns
    -------
    float
        θ = σ / sin δ_b − atan(tan σ / sin δ_b) [rad].

    Notes
    -----
    A great circle rolls on the base circle without slip: its point of contact has moved by σ / sin δ_b, and
    the involute point is the arc σ behind it (right spherical triangle). For δ_b → 0 and σ = δ_b tan α, θ is
    the involute function inv α of ISO 21771.

    Examples
    --------
    >>> round(spherical_involute(1e-6 * math.tan(math.radians(20.0)), 1e-6), 9)
    0.014904384
    """
    s = math.sin(delta_b)
    return sigma / s - math.atan2(math.sin(sigma), math.cos(sigma) * s)
