# SPDX-License-Identifier: Apache-2.0
"""Clearance of the flanks of a pair with micro-geometry: smallest distance over a mesh period.

Profiles of both gears are evaluated over the common face width, in the positions of one pitch, for all teeth
that are close to each other. Unlike `clearance`, which rolls outlines, this includes modifications and
deviations of the flanks, the axial position of the gears and tilted axes.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.clearance import BACK, FRONT, Clearance
from pitchpoint.geometry.closest_points import SAMPLES, closest_points
from pitchpoint.geometry.deviations import Deviations
from pitchpoint.geometry.flank_distance import Facing, Gap, Mounting, flank_distance
from pitchpoint.geometry.flank_surface import Flank
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.modifications import FlankModifications

FloatArray = NDArray[np.float64]

POSITIONS = 24
"""Positions within a pitch that are evaluated."""
PROFILES = 21
"""Profiles over the common face width."""


@dataclass(frozen=True, eq=False, kw_only=True)
class MicroGeometry:
    """Deviations of the flanks of a gear from the involute.

    Parameters
    ----------
    left, right
        Modifications of the left and right flanks, or None.
    deviations
        Deviations of single teeth, or None. Every tooth of a gear is assumed to meet every tooth of the mate.
    """

    left: FlankModifications | None = None
    right: FlankModifications | None = None
    deviations: Deviations | None = None

    def flank(self, pair: GearPair, gear: int, side: str, tooth: int) -> Flank:
        """Flank of gear 1 or 2 of a pair with this micro-geometry, at the position of a tooth."""
        return Flank(
            gear=pair.gear1 if gear == 1 else pair.gear2,
            side=side,
            tooth=tooth,
            modifications=self.left if side == "left" else self.right,
            deviations=self.deviations,
            every_tooth=True,
        )


IDEAL = MicroGeometry()


def facing_flanks(
    mounting: Mounting,
    tooth: int,
    front: bool = True,
    micro: tuple[MicroGeometry, MicroGeometry] = (IDEAL, IDEAL),
) -> Facing:
    """Flanks of a tooth of gear 1 and of the tooth of gear 2 that it meets.

    Parameters
    ----------
    mounting
        Relative position of the gears, within half a pitch of centred backlash.
    tooth
        Number of the tooth of gear 1, counted from the line of centres at `phi1` = 0; also negative.
    front
        Front flanks, in contact if gear 1 drives counter-clockwise, or back flanks.
    micro
        Micro-geometry of both gears.

    Examples
    --------
    Tooth 0 of a wheel is half a pitch beyond the line of centres, in the direction in which it rotates:

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=30, m_n=2e-3)
    >>> both = facing_flanks(Mounting(pair=GearPair(gear, gear, 0.06)), 0)
    >>> both.own.side, both.mate.side, both.mate.tooth
    ('left', 'left', -1)
    """
    pair = mounting.pair
    if pair.is_internal:
        sides, mate = (("left", "right"), tooth) if front else (("right", "left"), tooth - 1)
    else:
        sides, mate = (("left", "left"), -1 - tooth) if front else (("right", "right"), -tooth)
    own, other = (
        micro[k].flank(pair, k + 1, side, number)
        for k, (side, number) in enumerate(zip(sides, (tooth, mate), strict=True))
    )
    return Facing(mounting=mounting, own=own, mate=other)


def flank_clearances(
    mounting: Mounting, micro: tuple[MicroGeometry, MicroGeometry] = (IDEAL, IDEAL)
) -> dict[str, Clearance]:
    """Smallest distance of front and back flanks with micro-geometry, over a mesh period.

    Parameters
    ----------
    mounting
        Relative position of the gears; both rotate from there through one pitch.
    micro
        Micro-geometry of both gears.

    Returns
    -------
    dict
        `FRONT` and `BACK`, with the section of the smallest distance: distances along the base tangent [m],
        rotations of the gears at which their mid-face sections are in the same position, and the two points
        in it. Kinds without contact are missing.

    Notes
    -----
    Involute flanks from root form to tip form circle, see `below_form` for what is below. Where tip edge
    meets tip edge there is no point of one flank normal to the other; `clearance` covers this.

    Examples
    --------
    Left flanks with too much material at the tip reduce the clearance of the front flanks:

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=30, m_n=2e-3, thickness_allowance=-40e-6)
    >>> pair = GearPair(gear, gear, 0.06)
    >>> bulge = FlankModifications(profile_slope=10e-6)
    >>> found = flank_clearances(Mounting(pair=pair), (MicroGeometry(left=bulge), IDEAL))
    >>> round(1e6 * 0.5 * pair.j_bt, 2), [round(1e6 * found[kind].distance, 2) for kind in (FRONT, BACK)]
    (37.59, [32.59, 37.59])
    """
    found = {}
    for kind, front in ((FRONT, True), (BACK, False)):
        best = _least(mounting, micro, front)
        if best is not None:
            found[kind] = best
    return found


def below_form(pair: GearPair) -> tuple[bool, bool]:
    """Whether the tip of the mate reaches below the root form circle of gears 1 and 2.

    Parameters
    ----------
    pair
        The pair.

    Returns
    -------
    tuple
        The tip then meets the fillet instead of the involute: interference.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> below_form(GearPair(CylindricalGear(z=15, m_n=3e-3), CylindricalGear(z=100, m_n=3e-3), 0.1725))
    (True, False)
    """
    slack = 1e-6 * pair.gear1.m_n
    return pair.T1A < pair.T1A_form - slack, pair.T1E > pair.T1E_form + slack


def _least(mounting: Mounting, micro: tuple[MicroGeometry, MicroGeometry], front: bool) -> Clearance | None:
    """Smallest distance of the front or back flanks over one pitch.

    All teeth are equal here: one tooth that rolls through the mesh takes the positions of all.
    """
    facing = facing_flanks(mounting, 0, front, micro)
    found = [_start(one) for one in (facing, facing.swapped())]
    starts = [start for start in found if start is not None]
    if not starts:
        return None
    _, one, z, turned = min(starts, key=lambda start: start[0])
    return _refined(one, z, turned)


def _rotated(mounting: Mounting, turned: float) -> Mounting:
    """Mounting after a further rotation of gear 1 [rad]."""
    phi1, phi2 = mounting.turns
    back = turned * mounting.pair.gear1.z / mounting.pair.gear2.z
    return replace(mounting, phi1=phi1 + turned, phi2=phi2 - back)


def _step(facing: Facing) -> float:
    """Rotation of gear 1 between two positions [rad]."""
    return 2.0 * math.pi / facing.mounting.pair.gear1.z / POSITIONS


def _positions(facing: Facing) -> range:
    """Numbers of the positions in which the tooth is within a quarter pitch of the path of contact."""
    pair, gear = facing.mounting.pair, facing.mounting.pair.gear1
    reach = 0.25 * pair.p_et + 0.5 * gear.b * abs(math.tan(gear.beta_b))
    # length of roll of gear 1 at mid-face, on the line of action
    at = pair.T1C + gear.r_b * (gear.psi_b - math.tan(pair.alpha_wt) + pair.alpha_wt)
    way = 1.0 if (facing.own if facing.gear == 1 else facing.mate).side == "left" else -1.0
    at += way * gear.r_b * facing.mounting.turns[0]
    ends = sorted(way * (end - at) / gear.r_b / _step(facing) for end in (pair.T1A - reach, pair.T1E + reach))
    return range(math.floor(ends[0]), math.ceil(ends[1]) + 1)


def _stations(facing: Facing) -> FloatArray:
    """Profiles over the common face width, from the mid-face of the gear whose points are considered [m]."""
    pair, offset = facing.mounting.pair, facing.mounting.offset
    low = max(-0.5 * pair.gear1.b, offset - 0.5 * pair.gear2.b)
    high = min(0.5 * pair.gear1.b, offset + 0.5 * pair.gear2.b)
    shift = offset if facing.gear == 2 else 0.0
    return np.linspace(low, high, PROFILES) - shift


def _start(facing: Facing) -> tuple[float, Facing, float, float] | None:
    """Profile and rotation at which the search starts: smallest distance on a grid over all positions.

    Over the rotation the distance of a point is a parabola near its minimum, which lies between positions.
    """
    z, roll, positions = _stations(facing), np.linspace(*facing.own.span, SAMPLES), _positions(facing)
    distance = np.full((len(positions) + 2, SAMPLES, PROFILES), np.inf)
    for k, position in enumerate(positions, start=1):
        here = replace(facing, mounting=_rotated(facing.mounting, position * _step(facing)))
        found = flank_distance(here, roll[:, None], z[None, :])
        fits = facing.mate.covers(found.mate_roll, found.mate_z)
        distance[k] = np.where(fits, found.distance, np.inf)
    at = np.argmin(distance, axis=0)[None]
    least, before, after = (np.take_along_axis(distance, at + d, axis=0)[0] for d in (0, -1, 1))
    if not np.isfinite(least).any():
        return None
    with np.errstate(invalid="ignore", divide="ignore"):
        lower = least - (before - after) ** 2 / (8.0 * (before + after - 2.0 * least))
    least = np.where(np.isfinite(lower), lower, least)
    i, j = np.unravel_index(int(np.argmin(least)), least.shape)
    turned = positions[int(at[0, i, j]) - 1] * _step(facing)
    return float(least[i, j]), facing, float(z[j]), turned


def _refined(facing: Facing, z: float, start: float) -> Clearance | None:
    """Smallest distance of one profile over rotations near `start`."""
    from scipy.optimize import minimize_scalar

    def at(turned: float) -> Facing:
        """The flanks after a further rotation of gear 1."""
        return replace(facing, mounting=_rotated(facing.mounting, turned))

    def distance(turned: float) -> float:
        """Distance of the profile; large where it does not face the mate."""
        return float(np.nan_to_num(closest_points(at(turned), [z]).distance[0], nan=facing.own.gear.m_n))

    bounds = (start - _step(facing), start + _step(facing))
    best = minimize_scalar(distance, bounds=bounds, method="bounded", options={"xatol": 1e-8})
    turned = start if distance(start) < best.fun else float(best.x)
    found = closest_points(at(turned), [z])
    return _section(at(turned), found) if np.isfinite(found.distance[0]) else None


def _section(facing: Facing, found: Gap) -> Clearance:
    """The distance of a profile, as one of transverse sections."""
    mounting, pair = facing.mounting, facing.mounting.pair
    roll, z = found.own_roll[0], found.own_z[0]
    points, normals = facing.own.points(roll, z)
    here = mounting.world(points - facing.own.gap(roll, z) * normals, facing.gear)
    # the mate is on the side of the outward normal
    outwards = mounting.world(normals, facing.gear) - mounting.world(np.zeros(3), facing.gear)
    distance = float(found.distance[0]) / math.cos(pair.gear1.beta_b)
    there = here[:2] + distance * outwards[:2] / math.hypot(outwards[0], outwards[1])
    ends = [(float(x), float(y)) for x, y in ((here[:2], there) if facing.gear == 1 else (there, here[:2]))]
    at = float(here[2])
    phi1, phi2 = mounting.turns
    turn1, turn2 = (
        z * math.tan(gear.beta_b) / abs(gear.r_b)
        for gear, z in ((pair.gear1, at), (pair.gear2, at - mounting.offset))
    )
    return Clearance(distance, phi1 + turn1, phi2 + turn2, ends[0], ends[1], at)
