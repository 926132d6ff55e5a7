# SPDX-License-Identifier: Apache-2.0
"""Schematic connections of a body with ring gears: drums around other parts, webs between them.

Coaxial bodies such as those of an automatic transmission have gears and carriers in several planes. A drum
leads from a ring along the axis, a web in a free gap between the planes leads to the radius of the next part.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import TYPE_CHECKING

from pitchpoint.report.section.axes import Line
from pitchpoint.report.section.boxes import span_line
from pitchpoint.report.section.carriers import Carrier, ring_radius
from pitchpoint.report.section.layout import gaps
from pitchpoint.report.section.places import Positions
from pitchpoint.viz.section_content import Piece

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

WALL = 0.009
"""Thickness of drums and webs, relative to the size of the machine."""
CLEAR = 0.03
"""Distance of a drum from the parts inside, relative to the size of the machine."""
SHAFT_END = 0.03
"""Radius of the end of a ring towards a coupling, relative to the size of the machine."""


@dataclass(frozen=True)
class Part:
    """Gear or plate of a body: ends along the axis and radii [m]."""

    low: float
    high: float
    inner: float
    outer: float


@dataclass
class Gaps:
    """Free gaps between the planes of an axis, each with the number of walls in it so far."""

    free: Sequence[tuple[float, float]]
    used: dict[tuple[float, float], int] = field(default_factory=dict)

    def take(self, low: float, high: float) -> tuple[float, float]:
        """Position of the next wall between two parts, in their widest free gap, and its width [m].

        Examples
        --------
        >>> free = Gaps([(0.0, 4.0), (5.0, 6.0)])
        >>> free.take(0.0, 6.0), free.take(0.0, 6.0)
        ((2.0, 4.0), (1.0, 4.0))
        """
        inside = [(max(a, low), min(b, high)) for a, b in self.free if a < high and b > low]
        if not inside:
            return 0.5 * (low + high), high - low
        best = max(inside, key=lambda gap: gap[1] - gap[0])
        self.used[best] = count = self.used.get(best, 0) + 1
        return best[0] + _halved(count) * (best[1] - best[0]), best[1] - best[0]


def _halved(count: int) -> float:
    """Points that divide an interval evenly as their number grows: 1/2, 1/4, 3/4, 1/8, 5/8 …"""
    value, scale = 0.0, 0.5
    while count:
        value += scale * (count & 1)
        count >>= 1
        scale *= 0.5
    return value


def has_ring(model: Model, body: str) -> bool:
    """Whether a body without sections has an internal gear."""
    return body not in model.shafts and any(
        model.gears[g].geometry.is_internal for g in model.bodies[body].gears
    )


def parts_of(model: Model, at: Positions, body: str, carriers: Mapping[str, Carrier]) -> list[Part]:
    """Gears of a body, and the plates of a carrier, in the order along the axis.

    Parameters
    ----------
    model
        The model.
    at
        Positions along the axes.
    body
        The body.
    carriers
        Carriers of its axis.
    """
    found = []
    for name in model.bodies[body].gears:
        gear = model.gears[name]
        root, half = 0.5 * abs(gear.geometry.d_f), 0.5 * gear.face_width
        inner, outer = (root, ring_radius(gear)) if gear.geometry.is_internal else (0.0, root)
        found.append(Part(at.gears[name] - half, at.gears[name] + half, inner, outer))
    if body in carriers:
        room = carriers[body].room
        found += [Part(*room.plate(way), 0.3 * room.far, room.outer) for way in (-1.0, 1.0)]
    return sorted(found, key=lambda part: part.low)


def free_gaps(model: Model, line: Line, at: Positions, carriers: Mapping[str, Carrier]) -> Gaps:
    """Free gaps between gears and plates of an axis.

    Parameters
    ----------
    model
        The model.
    line
        The axis.
    at
        Positions along the axes.
    carriers
        Its carriers.
    """
    parts = [part for body in line.bodies for part in parts_of(model, at, body, carriers)]
    if not parts:
        return Gaps([])
    low, high = min(p.low for p in parts), max(p.high for p in parts)
    more = 0.2 * (high - low)
    return Gaps(gaps([(p.low, p.high) for p in parts], low - more, high + more))


def drum_pieces(
    model: Model,
    line: Line,
    at: Positions,
    carriers: Mapping[str, Carrier],
    free: Gaps,
    ends: Mapping[str, tuple[float, float]],
    rings: Mapping[str, Sequence[Part]],
    size: float,
) -> list[Piece]:
    """Drums and webs of the bodies with ring gears or bearings around an axis.

    Parameters
    ----------
    model
        The model.
    line
        The axis.
    at
        Positions along the axes.
    carriers
        Its carriers.
    free
        Free gaps between its planes.
    ends
        Ends of the bodies up to couplings [m].
    rings
        Seats of rolling bearings on bodies without sections.
    size
        Size of the machine [m].
    """
    wall = WALL * size
    found: list[Piece] = []
    for body in line.bodies:
        seats = rings.get(body, ())
        fixed = model.bodies[body].moves == "fixed"
        if fixed and not seats or not (has_ring(model, body) or body in carriers and seats):
            continue
        parts = parts_of(model, at, body, carriers)
        others = [p for b in line.bodies if b != body for p in parts_of(model, at, b, carriers)]
        if body in carriers:  # plates are joined by the pins
            gears = [*parts_of(model, at, body, {}), *seats]
            parts = [*gears, *_nearest(carriers[body], gears)]
        else:
            parts += seats
        parts.sort(key=lambda part: part.low)
        start = len(found)
        found += [_drum(part.low, part.high, part.inner, part.outer) for part in seats]
        for one, two in pairwise(parts):
            if one.high < two.low:
                found += _wall(one, two, others, free, wall, size)
        low, high = ends.get(body, (parts[0].low, parts[-1].high))
        if fixed:
            found[start:] = [replace(piece, kind="held") for piece in found[start:]]
        if fixed or body in carriers:
            continue
        if low < parts[0].low - wall:
            found += _end(parts[0], low, free, wall, size)
        if high > parts[-1].high + wall:
            found += _end(parts[-1], high, free, wall, size)
    return found


def _nearest(carrier: Carrier, gears: Sequence[Part]) -> list[Part]:
    """Plate of a carrier next to gears of the same body."""
    room = carrier.room
    above = sum(g.low + g.high for g in gears) > len(gears) * (room.low + room.high)
    return [Part(*room.plate(1.0 if above else -1.0), 0.3 * room.far, room.outer)]


def _wall(one: Part, two: Part, others: Sequence[Part], free: Gaps, wall: float, size: float) -> list[Piece]:
    """Walls from a part to the next one, outside of all parts of other bodies between them."""
    between = [p for p in others if p.high > one.high and p.low < two.low]
    around = max((p.outer for p in between), default=0.0)
    shared = min(one.outer, two.outer)
    if max(one.inner, two.inner) < shared and (around < shared or not between):
        return [_drum(one.high, two.low, shared - wall, shared)]
    outer, inner = (one, two) if one.outer > two.outer else (two, one)
    if around < outer.outer - wall:  # a web in the gap next to the smaller one, then along the larger one
        level = inner.outer
        if inner is one:
            ends = (one.high, min((p.low for p in between if p.low >= one.high), default=two.low))
        else:
            ends = (max((p.high for p in between if p.high <= two.low), default=one.high), two.low)
        place, _ = free.take(*ends)
        faces = [part.high if part is one else part.low for part in (outer, inner)]
        return [
            _drum(place, faces[0], outer.outer - wall, outer.outer),
            _drum(place - 0.5 * wall, place + 0.5 * wall, level - wall, outer.outer),
            _drum(place, faces[1], level - wall, level),
        ]
    radius = around + CLEAR * size
    return [
        _drum(one.high - wall, one.high, one.outer, radius),
        _drum(one.high - wall, two.low + wall, radius, radius + wall),
        _drum(two.low, two.low + wall, two.outer, radius),
    ]


def _end(part: Part, end: float, free: Gaps, wall: float, size: float) -> list[Piece]:
    """Web from a ring to its shaft end, at a coupling or bearing next to it."""
    radius = SHAFT_END * size
    above = end > part.high
    face = part.high if above else part.low
    place, _ = free.take(*sorted((face, end)))
    if part.inner == 0.0:
        return [_drum(face, end, 0.0, min(radius, part.outer))]
    return [
        _drum(face, place, part.outer - wall, part.outer),
        _drum(place - 0.5 * wall, place + 0.5 * wall, 0.0, part.outer),
        _drum(place, end, 0.0, radius),
    ]


def _drum(start: float, end: float, inner: float, outer: float) -> Piece:
    """Wall between two positions in any order."""
    return Piece(kind="drum", line=span_line(start, end - start, inner, outer))
