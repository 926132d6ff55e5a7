# SPDX-License-Identifier: Apache-2.0
"""Records of blade stations and of what all stations of a rotor share; values are computed once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.rotor.blade import Rotor

STATION = np.dtype(
    [
        ("chord", "f8"),
        ("twist", "f8"),
        ("solidity", "f8"),  # B c / (2 pi r)
        ("tip", "f8"),  # B/2 (R - r)/r of the tip loss; infinite without it
        ("hub", "f8"),  # B/2 (r - r_h)/r_h of the hub loss; infinite without it
        ("share", "f8"),  # r/R, for the skewed wake
        ("first", "i8"),  # first and last row of its polar
        ("last", "i8"),
    ],
    align=True,
)
AIR = np.dtype(
    [
        ("rho", "f8"),
        ("axial", "i8"),  # 1: axial induction
        ("swirl", "i8"),  # 1: tangential induction
        ("axial_drag", "f8"),  # 1: drag contributes to the axial, tangential induction
        ("swirl_drag", "f8"),
        ("skew", "f8"),  # factor of the skewed wake, 15 pi/32; 0 without it
    ],
    align=True,
)
POINT = np.dtype(
    [
        ("station", "i8"),
        ("vx", "f8"),  # velocity of the air relative to the blade, normal to it, downwind positive
        ("vy", "f8"),  # the same against the direction of rotation
        ("pitch", "f8"),
        ("yaw", "f8"),  # angle between wind and rotor axis
        ("downwind", "f8"),  # cosine of the azimuth from the most downwind position
        ("phi", "f8"),  # results
        ("alpha", "f8"),
        ("speed", "f8"),
        ("a", "f8"),
        ("a_prime", "f8"),
        ("lift", "f8"),
        ("drag", "f8"),
        ("moment", "f8"),
        ("loss", "f8"),
        ("f_n", "f8"),  # forces and moment per length of the blade [N/m, N]
        ("f_t", "f8"),
        ("m_c", "f8"),
        ("status", "i8"),
    ],
    align=True,
)
BATCH = np.dtype(
    [("stations", "i8"), ("n", "i8"), ("knots", "i8"), ("rows", "i8"), ("air", "i8")], align=True
)

SKEW = 15.0 * np.pi / 32.0
"""Factor of the skewed wake (Pitt and Peters 1981, as in Moriarty and Hansen 2005)."""


def station_records(rotor: Rotor, tip_loss: bool = True, hub_loss: bool = True) -> NDArray[Any]:
    """Records of the stations of a blade.

    Parameters
    ----------
    rotor
        The rotor.
    tip_loss, hub_loss
        Whether Prandtl's losses are used.
    """
    blade = rotor.blade
    out = np.zeros(blade.span.size, STATION)
    r, count = rotor.radius, 0.5 * rotor.blades
    out["chord"], out["twist"] = blade.chord, blade.twist
    out["solidity"] = count * blade.chord / (np.pi * r)
    out["tip"] = count * (rotor.tip_radius - r) / r if tip_loss else np.inf
    out["hub"] = count * (r - rotor.root_radius) / rotor.root_radius if hub_loss else np.inf
    out["share"] = r / rotor.tip_radius
    ends = np.cumsum([0, *(len(polar.alpha) for polar in blade.polars)])
    out["first"], out["last"] = ends[blade.polar_index], ends[blade.polar_index + 1] - 1
    return out


def polar_rows(rotor: Rotor) -> NDArray[np.float64]:
    """Rows of all polars, shape (n, 7), see `Polar.knots`."""
    return np.ascontiguousarray(np.concatenate([polar.knots for polar in rotor.blade.polars]))
