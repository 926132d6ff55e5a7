# SPDX-License-Identifier: Apache-2.0
"""Outlines of two gears in mesh at given rotation angles.

Derivation: docs/theory/geometry.md, "Generation by the tool".
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.tooth_form import gear_outline

if TYPE_CHECKING:
    from pitchpoint.geometry.gear_pair import GearPair

FloatArray = NDArray[np.float64]


def mesh_offset(pair: GearPair, direction: float = 0.0) -> float:
    """Angle of tooth 0 of gear 2 at which the backlash is centred.

    Parameters
    ----------
    pair
        External or internal pair.
    direction
        Direction of the pitch point from the axis of gear 1 [rad].

    Returns
    -------
    float
        Angle from the +x axis [rad] of tooth 0 of gear 2 while tooth 0 of gear 1 points to the pitch point.

    Notes
    -----
    The middle of a space of gear 2 is then at the pitch point, which is at `direction` + π from the axis of
    an external gear 2 and at `direction` from that of an internal one.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> gear = CylindricalGear(z=50, m_n=3e-3)
    >>> round(mesh_offset(GearPair(gear, gear, 0.15)) / math.pi, 6)
    1.02
    """
    toward = direction if pair.gear2.is_internal else direction + math.pi
    return toward + math.pi / abs(pair.gear2.z)


def mesh_outlines(
    pair: GearPair,
    phi1: float = 0.0,
    n_flank: int = 40,
    *,
    phi2: float | None = None,
    direction: float = 0.0,
) -> tuple[FloatArray, FloatArray]:
    """Outlines of both gears in mesh, at the pair's centre distance.

    Parameters
    ----------
    pair
        External pair, or pinion (gear 1) with internal gear (gear 2).
    phi1
        Rotation of gear 1 [rad], counter-clockwise; 0 puts its tooth 0 on the line of centres.
    n_flank
        Points per flank.
    phi2
        Rotation of gear 2 [rad], counter-clockwise; None = −phi1 z₁/z₂, half of the backlash on either flank.
        The front flanks touch for r_b1 φ₁ + r_b2 φ₂ = j_bt/2.
    direction
        Direction of the pitch point from the axis of gear 1 [rad].

    Returns
    -------
    outline1, outline2 : ndarray, shape (n, 2)
        Closed polygons [m], the axis of gear 1 at the origin. The axis of gear 2 is at the signed centre
        distance along `direction`: beyond the pitch point for external pairs, on the opposite side of the
        axis of gear 1 for internal pairs.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> gear = CylindricalGear(z=50, m_n=3e-3)
    >>> one, two = mesh_outlines(GearPair(gear, gear, 0.15), 0.0, 20)
    >>> two.mean(axis=0).round(3)
    array([0.15, 0.  ])
    """
    if phi2 is None:
        phi2 = -phi1 * pair.gear1.z / pair.gear2.z
    one = gear_outline(pair.gear1, n_flank, rotation=direction + phi1)
    two = gear_outline(pair.gear2, n_flank, rotation=mesh_offset(pair, direction) + phi2)
    return one, two + pair.a_w * np.array([math.cos(direction), math.sin(direction)])
