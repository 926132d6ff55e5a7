# SPDX-License-Identifier: Apache-2.0
"""Clearances of an assembled pair: smallest distances between the teeth, and their locations.

The transverse sections of both gears are rolled through one pitch at the centre distance of the pair: with
the backlash centred, and with front or back flanks in contact. On parallel axes every transverse section of
helical teeth passes through the same positions at another angle, so the results hold for the solids.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.outline_distance import FILLET, FLANK, TIP, Outline, gear_line
from pitchpoint.geometry.placement import mesh_offset

if TYPE_CHECKING:
    from pitchpoint.geometry.gear_pair import GearPair

ComplexArray = NDArray[np.complex128]
FloatArray = NDArray[np.float64]

FRONT, BACK = "front_flanks", "back_flanks"
TIP_1_ROOT_2, TIP_2_ROOT_1 = "tip_1_root_2", "tip_2_root_1"
KINDS = (FRONT, BACK, TIP_1_ROOT_2, TIP_2_ROOT_1, "tip_1_fillet_2", "tip_2_fillet_1", "tips")
"""Kinds of clearance; `tips` only for internal pairs: tip interference away from the path of contact."""
ACCURACY = 1e-4
"""Maximum error of a distance in normal modules, from the chords of the fillets on both gears."""
TIP_ROOT = 0.1
"""Minimum tip clearance in normal modules; the basic racks of ISO 53 give 0.25 to 0.4."""

_MOVED = 60
"""Points per flank of the moved gear; rolling covers the positions between two of them."""
_ROLLED = 24
"""Positions within a pitch that are evaluated before the minimum is refined."""
_GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)
_TIMES = 13
"""Golden-section steps: they reduce the interval to 1/520 of two steps."""
_MARGIN = 0.4
"""Distance beyond the mate's tip circle up to which points are checked, in normal modules."""


@dataclass(frozen=True)
class Clearance:
    """Smallest distance of one kind, and the position in which it occurs.

    Attributes
    ----------
    distance
        In the transverse section [m]; negative where the teeth overlap.
    phi1, phi2
        Rotations of the gears there, as in `mesh_outlines` [rad].
    place1, place2
        The two points, x and y in the transverse plane [m]; axis of gear 1 at the origin, of gear 2 at a_w.
    z
        Axial position of the section from the mid-face of gear 1 [m]; None if all sections are equal.
    """

    distance: float
    phi1: float
    phi2: float
    place1: tuple[float, float]
    place2: tuple[float, float]
    z: float | None = None


@dataclass(frozen=True)
class _Mesh:
    """Outlines of both gears: fine ones to measure distances from, coarse ones whose points are moved."""

    pair: GearPair
    fine: tuple[Outline, Outline]
    coarse: tuple[Outline, Outline]

    def place(self, which: int, phi: float) -> tuple[complex, complex]:
        """Factor e^(iφ) and offset of the axis that transform points of a gear at the rotation `phi`."""
        if which == 0:
            return complex(np.exp(1j * phi)), 0.0
        return complex(np.exp(1j * (mesh_offset(self.pair) + phi))), complex(self.pair.a_w)

    def moved(self, which: int, phi: float) -> tuple[ComplexArray, NDArray[np.int8]]:
        """Points of a gear close to its mate at the rotation `phi`, and their outline parts."""
        own, mate = (self.pair.gear1, self.pair.gear2)[:: 1 - 2 * which]
        line = self.coarse[which]
        turn, axis = self.place(which, phi)
        other = self.place(1 - which, 0.0)[1]
        teeth = np.exp(2j * math.pi / line.z * np.arange(line.z)) * turn
        tips = axis + 0.5 * abs(own.d_a) * teeth
        reach = mate.sign * (np.abs(tips - other) - 0.5 * abs(mate.d_a))
        near = teeth[reach < (_MARGIN + 1.6) * own.m_t]
        points = (axis + line.pitch[None, :] * near[:, None]).ravel()
        parts = np.tile(line.part, near.size)
        inside = mate.sign * (np.abs(points - other) - 0.5 * abs(mate.d_a)) < _MARGIN * own.m_n
        return points[inside], parts[inside]


def clearances(pair: GearPair) -> dict[str, Clearance]:
    """Smallest distances between the teeth of a pair.

    Parameters
    ----------
    pair
        External pair, or pinion (gear 1) with internal gear (gear 2). Gears with an outline are taken with
        their real teeth; flank modifications are neglected.

    Returns
    -------
    dict
        By kind, see `KINDS`; kinds that never come close are missing. Flank clearances are given for centred
        backlash, all others for the worst position within the backlash.

    Raises
    ------
    GeometryError
        If a gear has no tooth.

    Notes
    -----
    For generated teeth the flank clearance is j_bt/2 and the tip clearance a_w − (d_a1 + d_fE2)/2. A tip that
    reaches below the mate's root form circle interferes with the fillet.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> gear = CylindricalGear(z=30, m_n=2e-3, thickness_allowance=-40e-6)
    >>> found = clearances(GearPair(gear, gear, 0.06))
    >>> [round(1e6 * found[kind].distance, 2) for kind in ("front_flanks", "tip_1_root_2")]
    [37.59, 554.95]
    """
    return dict(_found(pair))


@lru_cache(maxsize=64)
def _found(pair: GearPair) -> tuple[tuple[str, Clearance], ...]:
    """Kinds and clearances, cached: equal planets are evaluated once."""
    gears = (pair.gear1, pair.gear2)
    mesh = _Mesh(
        pair,
        (gear_line(gears[0]), gear_line(gears[1])),
        (gear_line(gears[0], _MOVED), gear_line(gears[1], _MOVED)),
    )
    middle = _rolled(mesh, 0.0)
    found = {kind: middle[kind] for kind in (FRONT, BACK) if kind in middle}
    found = {kind: _refined(mesh, kind, 0.0, best) for kind, best in found.items()}
    found |= _tips_to_roots(mesh)
    plays = [0.0]
    for kind, way in ((FRONT, 1.0), (BACK, -1.0)):
        if kind in found and found[kind].distance > 0.0:
            plays.append(way * found[kind].distance / pair.gear2.r_b)
    rolled = [(play, middle if play == 0.0 else _rolled(mesh, play)) for play in plays]
    for kind in KINDS[4:]:
        if kind == "tips" and not pair.is_internal:
            continue
        near = [(best[kind], play) for play, best in rolled if kind in best]
        if near:
            best, play = min(near, key=lambda one: one[0].distance)
            found[kind] = _refined(mesh, kind, play, best)
    return tuple(found.items())


def _tips_to_roots(mesh: _Mesh) -> dict[str, Clearance]:
    """Tip clearances, on the line of centres."""
    pair = mesh.pair
    one, two = (np.abs(line.pitch) for line in mesh.fine)
    side = pair.gear2.sign
    found = {}
    for kind, phi1, r1, r2 in (
        (TIP_1_ROOT_2, 0.0, one.max(), two.min() if side > 0 else two.max()),
        (TIP_2_ROOT_1, math.pi / pair.gear1.z, one.min(), two.max() if side > 0 else two.min()),
    ):
        x1, x2 = float(r1), float(pair.a_w - side * r2)
        phi2 = -phi1 * pair.gear1.z / pair.gear2.z
        found[kind] = Clearance(x2 - x1, phi1, phi2, (x1, 0.0), (x2, 0.0))
    return found


def _rolled(mesh: _Mesh, play: float) -> dict[str, Clearance]:
    """Smallest clearances over `_ROLLED` positions; gear 2 rotated by `play` from centred backlash."""
    pitch = 2.0 * math.pi / mesh.pair.gear1.z
    found: dict[str, Clearance] = {}
    for k in range(_ROLLED):
        _keep(found, _at(mesh, k * pitch / _ROLLED, play))
    return found


def _refined(mesh: _Mesh, kind: str, play: float, best: Clearance) -> Clearance:
    """Refine the smallest clearance of one kind by golden-section search."""
    found = {kind: best}

    def distance(phi1: float) -> float:
        """Clearance in one position; stored in `found` if it is the smallest."""
        near = _at(mesh, phi1, play).get(kind)
        _keep(found, {} if near is None else {kind: near})
        return math.inf if near is None else near.distance

    step = 2.0 * math.pi / mesh.pair.gear1.z / _ROLLED
    low, high = best.phi1 - step, best.phi1 + step
    inner = [high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)]
    values = [distance(phi) for phi in inner]
    for _ in range(_TIMES):
        if values[0] < values[1]:
            high, inner[1], values[1] = inner[1], inner[0], values[0]
            inner[0] = high - _GOLDEN * (high - low)
            values[0] = distance(inner[0])
        else:
            low, inner[0], values[0] = inner[0], inner[1], values[1]
            inner[1] = low + _GOLDEN * (high - low)
            values[1] = distance(inner[1])
    return found[kind]


def _keep(found: dict[str, Clearance], others: dict[str, Clearance]) -> None:
    for kind, other in others.items():
        if kind not in found or other.distance < found[kind].distance:
            found[kind] = other


def _at(mesh: _Mesh, phi1: float, play: float) -> dict[str, Clearance]:
    """Smallest clearance of every kind in one position."""
    pair = mesh.pair
    phi2 = -phi1 * pair.gear1.z / pair.gear2.z + play
    found: dict[str, Clearance] = {}
    for which, phi, phi_mate in ((0, phi1, phi2), (1, phi2, phi1)):
        points, part = mesh.moved(which, phi)
        if not points.size:
            continue
        turn, axis = mesh.place(1 - which, phi_mate)
        near = mesh.fine[1 - which].nearest((points - axis) / turn)
        feet = near.foot * turn + axis
        ends, parts = (
            ((points, feet), (part, near.part)) if which == 0 else ((feet, points), (near.part, part))
        )
        for kind, mask in _kinds(mesh, ends, parts, phi1).items():
            if not mask.any():
                continue
            chosen = np.nonzero(mask)[0]
            k = int(chosen[np.argmin(near.distance[chosen])])
            one, two = complex(ends[0][k]), complex(ends[1][k])
            here = Clearance(float(near.distance[k]), phi1, phi2, (one.real, one.imag), (two.real, two.imag))
            _keep(found, {kind: here})
    return found


def _kinds(
    mesh: _Mesh,
    ends: tuple[ComplexArray, ComplexArray],
    parts: tuple[NDArray[np.int8], NDArray[np.int8]],
    phi1: float,
) -> dict[str, NDArray[np.bool_]]:
    """Masks that assign the pairs of points to their kinds."""
    pair, (one, two) = mesh.pair, parts
    high = [
        gear.sign * (np.abs(end - axis) - 0.25 * abs(gear.d_a + gear.d_Ff)) > 0.0
        for gear, end, axis in zip((pair.gear1, pair.gear2), ends, (0.0, pair.a_w), strict=True)
    ]
    tips = (one == TIP) & (two == TIP) | (one == TIP) & (two == FLANK) & high[1]
    tips |= (one == FLANK) & (two == TIP) & high[0]
    flanks = (one >= FLANK) & (two >= FLANK) & ~tips
    # counter-clockwise rotation of gear 1 closes the gap at its left flanks
    pitch = 2.0 * math.pi / pair.gear1.z
    beside = (np.angle(ends[0]) - phi1 + 0.5 * pitch) % pitch - 0.5 * pitch
    return {
        FRONT: flanks & (beside > 0.0),
        BACK: flanks & (beside <= 0.0),
        "tip_1_fillet_2": (one == TIP) & (two == FILLET),
        "tip_2_fillet_1": (two == TIP) & (one == FILLET),
        "tips": tips,
    }
