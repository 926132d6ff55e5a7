# SPDX-License-Identifier: Apache-2.0
"""Torsional stiffness between bodies and ground, or between two bodies on one axis.

Gear ratios and given speeds take precedence: a body on a torsion spring with a given speed starts with it and
oscillates. A body whose speed they do not determine, such as a ring gear on a torque arm, starts at rest if
it has a torsional support."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.formula.formula import Formula
from pitchpoint.model.components.bearing_fault import play
from pitchpoint.model.components.law import Constant, FormulaLaw, TableLaw
from pitchpoint.model.engagement import Engaged, braked_body, held_body, is_open
from pitchpoint.model.frames import GROUND, axes_of, bodies_of, place_of, split
from pitchpoint.model.mechanism import seat_frame

if TYPE_CHECKING:
    from pitchpoint.model.components.bushing import Bushing
    from pitchpoint.model.components.law import Law
    from pitchpoint.model.components.spring import Spring
    from pitchpoint.model.frames import Array
    from pitchpoint.model.mechanism import Seat
    from pitchpoint.model.parts import Parts

SAME = 1e-9
"""Relative stiffness, deviation of a cosine from one, and distance [m] that count as zero."""
INCLINED = math.sqrt(0.5)
"""Cosine of the angle between two axes from which a rotation about one of them is not one about the other."""


def supported_bodies(parts: Parts, engaged: Engaged = None) -> list[str]:
    """Bodies that are supported in rotation by a stiffness to a fixed body or by a closed brake, brakes last.

    Torsion springs, springs with a lever arm, bushings, bearings with torsional stiffness, supports of
    a flexible rim in tangential direction; brakes that are closed at t = 0, or those of `engaged`.
    """
    springs = parts.torsion_springs.values()
    found = [bodies_of(s.bodies)[0] for s in springs if len(s.bodies) == 1 and s.stiffness > 0.0]
    for spring in parts.springs.values():
        body = held_body(parts, [split(end)[0] for end in spring.ends])
        if body is not None and spring.stiffness > 0.0 and _has_lever(parts, spring, body):
            found.append(body)
    for bearing in parts.bearings.values():
        stiff = bearing.stiffness.matrix6()[5][5] > 0.0 and play(bearing.faults.values()) == 0.0
        if stiff and bearing.housing in (None, GROUND):
            found.append(bearing.body)
    for name, gear in parts.gears.items():
        rim = getattr(gear, "flexible_rim", None)
        owner = parts.body_of(name)
        if owner and rim is not None and rim.supports is not None and rim.supports.tangential > 0.0:
            found.append(owner)
    coaxial = bushed_pairs(parts)
    for name, bushing in parts.bushings.items():
        ends = [split(end)[0] for end in bushing.ends]
        body = held_body(parts, ends)
        turning = [body] if body is not None else [] if name in coaxial else _framed(parts, ends)
        found += [one for one in turning if _resists(parts, bushing, one)]
    for name, clutch in parts.clutches.items():
        body = braked_body(parts, clutch)
        if body is not None and closed_at_start(clutch.capacity) and not is_open(name, clutch, engaged):
            found.append(body)
    return list(dict.fromkeys(body for body in found if body in parts.bodies))


def bushed_pairs(parts: Parts) -> dict[str, tuple[str, str]]:
    """Pairs of coaxial bodies that are coupled by a bushing with torsional stiffness, by bushing."""
    found = {}
    for name, bushing in parts.bushings.items():
        one, two = (split(end)[0] for end in bushing.ends)
        seats = parts.mechanism.seats
        if one == two or one not in seats or two not in seats or held_body(parts, [one, two]):
            continue
        if not _resists(parts, bushing, one):
            continue
        (place, axes), (other, turned) = (seat_frame(parts, seats[body]) for body in (one, two))
        off = np.cross(other - place, axes[:, 2])
        if axes[:, 2] @ turned[:, 2] > 1.0 - SAME and np.linalg.norm(off) <= SAME:
            found[name] = (one, two)
    return found


def _framed(parts: Parts, ends: Sequence[str]) -> list[str]:
    """Those of two bodies that spin about an axis about which the joints of the other one do not.

    Such as a gearbox on torque arms of a machine frame that only yaws.
    """
    seats, found = parts.mechanism.seats, []
    for body, other in (ends, ends[::-1]):
        if body not in seats or other not in seats or "spin" not in seats[body].coordinates:
            continue
        axis = seat_frame(parts, seats[body])[1][:, 2]
        while other in seats and not _spins_about(parts, seats[other], axis):
            other = seats[other].parent
        if other == GROUND:
            found.append(body)
    return found


def _spins_about(parts: Parts, seat: Seat, axis: Array) -> bool:
    """Whether a body spins on its joint about an axis within 45 deg of the given one."""
    return "spin" in seat.coordinates and bool(abs(seat_frame(parts, seat)[1][:, 2] @ axis) > INCLINED)


def _has_lever(parts: Parts, spring: Spring, body: str) -> bool:
    """Whether a spring has a lever arm about the axis of its body: neither intersects it nor is parallel to
    it."""
    at, frame = seat_frame(parts, parts.mechanism.seats[body])
    places = [place_of(parts, end) for end in spring.ends]
    if any(place is None for place in places):
        return False
    one, two = (np.asarray(place) - at for place in places)
    return bool(abs(frame[:, 2] @ np.cross(one, two)) > SAME * np.linalg.norm(two - one))


def _resists(parts: Parts, bushing: Bushing, body: str) -> bool:
    """Whether a bushing resists a rotation of one of its bodies about the axis of the body."""
    end = next(e for e in bushing.ends if split(e)[0] == body)
    directions = bushing.ends[1] if split(bushing.ends[1])[0] != GROUND else bushing.ends[0]
    at, frame = seat_frame(parts, parts.mechanism.seats[body])
    place = place_of(parts, end)
    if place is None:
        return False
    axes: Array = axes_of(parts, directions)
    way = np.cross(frame[:, 2], place - at)
    K = np.array(bushing.stiffness.matrix6())
    force = K @ np.concatenate([axes.T @ way, axes.T @ frame[:, 2]])
    return bool(np.abs(force).max() > SAME * np.abs(K).max(initial=0.0))


def closed_at_start(capacity: Law) -> bool:
    """Whether a clutch or brake has a capacity at t = 0; assumed for a Python function."""
    if isinstance(capacity, Constant):
        return capacity.value > 0.0
    if isinstance(capacity, TableLaw):
        return float(np.interp(0.0, capacity.abscissa, capacity.values)) > 0.0
    if isinstance(capacity, FormulaLaw):
        return bool(Formula.parse(capacity.text, capacity.variables)(*np.zeros(len(capacity.variables))) > 0)
    return True
