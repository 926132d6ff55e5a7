# SPDX-License-Identifier: Apache-2.0
"""Rings of rolling and plain bearings: their bodies, and their frames as assembled."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np

from pitchpoint.model.frames import GROUND, Array, axes_of, body_frame, place_of, split

if TYPE_CHECKING:
    from pitchpoint.model.components.rolling_bearing import PlainBearing, RollingBearing

    Ringed: TypeAlias = RollingBearing | PlainBearing


class Ring(NamedTuple):
    """One ring of a bearing as assembled.

    Attributes
    ----------
    body
        Body of the ring, or ground.
    seat
        Position in the world that selects the station or node of the body [m]; None if unknown.
    place
        Position of the centre in the world [m]; None if that of the body is unknown.
    axes
        Axes in the world, columns.
    """

    body: str
    seat: Array | None
    place: Array | None
    axes: Array


def ring_ends(part: Ringed) -> tuple[str, str]:
    """Names of the ends of inner and outer ring: ground, BODY or BODY.MARKER.

    Examples
    --------
    >>> from pitchpoint.model.components.rolling_bearing import PlainBearing
    >>> ring_ends(PlainBearing(body="shaft", clearance=1e-5, stiffness=1e9))
    ('shaft', 'ground')
    """
    return part.ends if part.ends is not None else (str(part.body), part.housing or GROUND)


def ring_bodies(part: Ringed) -> tuple[str, str]:
    """Bodies of the inner and the outer ring."""
    inner, outer = (split(name)[0] for name in ring_ends(part))
    return inner, outer


def rings_of(machine: Any, part: Ringed) -> tuple[Ring, Ring]:
    """Inner and outer ring of a bearing as assembled.

    A ring on ground has the position and axes of the other ring, wherever its shaft is. So has a ring on a
    body without marker that carries the body of the other ring by a joint, such as a planet carrier; the
    position of the bearing is along the axis from there. The rings of a bearing with `body` coincide; they
    have the axes of this body.

    Parameters
    ----------
    machine
        A model or its parts, with the positions of its bodies.
    part
        The bearing.
    """
    one, two = ring_ends(part)
    if part.ends is None:
        place = mounted_place(machine, part)
        axes = body_frame(machine, one)[1]
        seat = place_of(machine, two) if split(two)[1] else place
        return Ring(one, place, place, axes), Ring(split(two)[0], seat, place, axes)
    places = [place_of(machine, end) for end in (one, two)]
    turned = [axes_of(machine, end) for end in (one, two)]
    if (k := following(machine, part)) is not None:
        turned[k] = turned[1 - k]
        held = places[1 - k]
        places = 2 * [None if held is None else held + turned[k][:, 2] * part.position[2]]
    inner, outer = (
        Ring(split(end)[0], place, place, axes)
        for end, place, axes in zip((one, two), places, turned, strict=True)
    )
    return inner, outer


def following(machine: Any, part: Ringed) -> int | None:
    """Index of the ring that is where the other one is, as of `rings_of`; None without one."""
    ends = ring_ends(part)
    seats = machine.mechanism.seats
    for k, end in enumerate(ends):
        other = split(ends[1 - k])[0]
        carries = other in seats and seats[other].joint is not None and seats[other].parent == end
        if end == GROUND or carries:
            return k
    return None


def mounted_place(machine: Any, part: Ringed) -> Array | None:
    """Position of a bearing with `body` in the world [m]; None if that of the body is unknown."""
    origin, axes = body_frame(machine, str(part.body))
    return None if origin is None else np.asarray(origin + axes[:, 2] * part.position[2])
