# SPDX-License-Identifier: Apache-2.0
"""Records of blade stations and of what all stations of a rotor share; values are computed once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.geometry.rotor.flow import RotorFlow
from pitchpoint.geometry.rotor.polar import Polar
from pitchpoint.geometry.rotor.separation import separation
from pitchpoint.geometry.rotor.tower import Tower

STATION = np.dtype(
    [
        ("chord", "f8"),
        ("twist", "f8"),
        ("solidity", "f8"),  # B c / (2 pi r)
        ("tip", "f8"),  # B/2 (R - r)/r of the tip loss; infinite without it
        ("hub", "f8"),  # B/2 (r - r_h)/r_h of the hub loss; infinite without it
        ("share", "f8"),  # r/R, for the skewed wake
        ("radius", "f8"),  # R of the rotor
        ("alpha_0", "f8"),  # angle without lift and slope of attached flow; slope 0 without dynamic stall
        ("slope", "f8"),
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
        # scratch: row of the polar near the angle of attack; inflow angle, values of `momentum` and normal
        # velocity without skewed wake, for the derivatives
        ("row", "i8"),
        ("balance", "f8", 8),
    ],
    align=True,
)
COLUMNS = 11
"""Columns of the rows of polars: those of `Polar.knots`, point of separation, lift of separated flow, each
with its slope."""
BATCH = np.dtype(
    [("stations", "i8"), ("n", "i8"), ("knots", "i8"), ("rows", "i8"), ("air", "i8")], align=True
)

SKEW = 15.0 * np.pi / 32.0
"""Factor of the skewed wake (Pitt and Peters 1981, as in Moriarty and Hansen 2005)."""


def station_records(
    rotor: Rotor, tip_loss: bool = True, hub_loss: bool = True, stall: bool = False
) -> NDArray[Any]:
    """Records of the stations of a blade.

    Parameters
    ----------
    rotor
        The rotor.
    tip_loss, hub_loss
        Whether Prandtl's losses are used.
    stall
        Whether the stall of sections with lift is dynamic.
    """
    blade = rotor.blade
    out = np.zeros(blade.span.size, STATION)
    r, count = rotor.radius, 0.5 * rotor.blades
    out["chord"], out["twist"] = blade.chord, blade.twist
    out["solidity"] = count * blade.chord / (np.pi * r)
    out["tip"] = count * (rotor.tip_radius - r) / r if tip_loss else np.inf
    out["hub"] = count * (r - rotor.root_radius) / rotor.root_radius if hub_loss else np.inf
    out["share"] = r / rotor.tip_radius
    out["radius"] = rotor.tip_radius
    for k, polar in enumerate(blade.polars):
        found = separation(polar) if stall else None
        if found is not None:
            own = blade.polar_index == k
            out["alpha_0"][own], out["slope"][own] = found.alpha_0, found.slope
    ends = np.cumsum([0, *(len(polar.alpha) for polar in blade.polars)])
    out["first"], out["last"] = ends[blade.polar_index], ends[blade.polar_index + 1] - 1
    return out


def polar_rows(rotor: Rotor) -> NDArray[np.float64]:
    """Rows of all polars, shape (n, 11): `Polar.knots`, point of separation and lift of separated flow, each
    with its slope per radian.

    Sections without lift have attached flow and a slope of lift of zero.
    """
    return np.ascontiguousarray(np.concatenate([_rows(polar) for polar in rotor.blade.polars]))


def _rows(polar: Polar) -> NDArray[np.float64]:
    """Rows of one polar."""
    found = separation(polar)
    one = np.ones(len(polar.alpha))
    f, separated = (one, 0.0 * one) if found is None else (found.f, found.separated)
    apart = Polar(alpha=polar.alpha, lift=f, drag=separated).knots[:, 1:5]
    return np.hstack([polar.knots, apart])


def tower_rows(tower: Tower) -> NDArray[np.float64]:
    """Rows of height and radius of a tower, shape (n, 2)."""
    return np.ascontiguousarray(np.column_stack([tower.elevation, 0.5 * tower.diameter]))


def air_record(flow: RotorFlow) -> NDArray[Any]:
    """Record of the air and of the options of the theory, shape (1,)."""
    air = np.zeros(1, AIR)
    air["rho"], air["axial"], air["swirl"] = flow.density, flow.axial_induction, flow.tangential_induction
    air["axial_drag"] = flow.drag_in_axial_induction
    air["swirl_drag"] = flow.drag_in_tangential_induction
    air["skew"] = SKEW if flow.skewed_wake else 0.0
    return air
