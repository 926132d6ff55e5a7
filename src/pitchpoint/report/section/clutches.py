# SPDX-License-Identifier: Apache-2.0
"""Symbols of brakes, and of clutches between carriers and rings: two plates, or a disc in a fixed part."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import product
from typing import TYPE_CHECKING

from pitchpoint.model.frames import split
from pitchpoint.report.scene.supports import shaft_radius
from pitchpoint.report.section.axes import Line
from pitchpoint.report.section.boxes import box_line, span_line
from pitchpoint.report.section.carriers import Carrier
from pitchpoint.report.section.drums import WALL, Gaps, Part, has_ring, parts_of
from pitchpoint.report.section.places import Positions
from pitchpoint.viz.section_content import Piece

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

PLATE = 0.012
"""Thickness of a plate and its distance from the other one, relative to the size of the machine."""
LINING = 0.07
"""Height of the plates relative to the size of the machine."""
NARROW = 0.1
"""Thickness of the plates of a brake relative to the gap in which it is."""
BETWEEN = 0.05
"""Thickness of the plates of a clutch relative to the gap in which it is."""
OUTSIDE = 0.3
"""Weight of a difference of radii against an axial distance in the choice of the parts of a clutch."""
DISC = 2.0
"""Radius of the disc of a brake relative to that of its shaft."""


def is_nested(model: Model, ends: Sequence[str], carriers: Mapping[str, Carrier]) -> bool:
    """Whether a clutch is between bodies of which one is a carrier or has a ring, around other parts.

    Parameters
    ----------
    model
        The model.
    ends
        Ends of the clutch.
    carriers
        Carriers of its axis.
    """
    return any(body in carriers or has_ring(model, body) for body in (split(end)[0] for end in ends))


def clutch_pieces(
    model: Model,
    line: Line,
    at: Positions,
    carriers: Mapping[str, Carrier],
    free: Gaps,
    ends: Mapping[str, tuple[float, float]],
    size: float,
) -> list[Piece]:
    """Brakes of an axis, and its clutches between nested bodies.

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
        Ends of its bodies without data of their own [m].
    size
        Size of the machine [m].
    """
    found: list[Piece] = []
    for name, clutch in model.clutches.items():
        bodies = [split(end)[0] for end in clutch.bodies]
        if clutch.stage is not None or not {*bodies} <= line.bodies.keys():
            continue
        parts = [parts_of(model, at, body, carriers) for body in bodies]
        if len(bodies) == 1:
            found += _brake(model, line, at, name, parts[0], free, ends, size)
        elif is_nested(model, clutch.bodies, carriers) and all(parts):
            found += _clutch(name, parts[0], parts[1], free, size)
    return found


def _clutch(name: str, one: Sequence[Part], two: Sequence[Part], free: Gaps, size: float) -> list[Piece]:
    """Two plates in a gap between the nearest parts of two bodies, with walls to them."""
    low, high = min(
        ((a, b) if a.low <= b.low else (b, a) for a, b in product(one, two)),
        key=lambda pair: (
            pair[1].low <= pair[0].high,
            pair[1].low - pair[0].high + OUTSIDE * abs(pair[0].outer - pair[1].outer),
        ),
    )
    thick, wall = PLATE * size, WALL * size
    if high.low > low.high:
        place, width = free.take(low.high, high.low)
        thick, wall = min(thick, BETWEEN * width), min(wall, BETWEEN * width)
        faces = (low.high, high.low)
    else:  # at one place: beyond both
        place = max(low.high, high.high) + 3.0 * thick
        faces = (low.high, high.high)
    radii = sorted((low.outer, high.outer))
    bottom = (
        max(min(radii[0], max(low.inner, high.inner)), 0.0)
        if radii[1] - radii[0] < LINING * size
        else radii[0]
    )
    bottom, top = min(bottom, radii[1] - LINING * size), radii[1]
    bottom = max(bottom, top - 2.0 * LINING * size, 0.3 * top)
    found = []
    for part, face, side in ((low, faces[0], -1.0), (high, faces[1], 1.0)):
        near = place + side * 0.5 * thick
        far = near + side * thick
        if high.low <= low.high:
            near, far = place + side * 0.5 * thick, place + side * 1.5 * thick
        plate = box_line(min(near, far), max(near, far), bottom, top)
        found.append(Piece(kind="lining", line=plate, name=name if side > 0.0 else ""))
        level = min(max(part.outer, bottom + wall), top)
        found.append(Piece(kind="drum", line=box_line(min(face, far), max(face, far), level - wall, level)))
        if part.outer < bottom:
            start = min(face, far) if side < 0.0 else max(face, far)
            found.append(Piece(kind="drum", line=span_line(start, side * wall, part.outer, level)))
    return found


def _brake(
    model: Model,
    line: Line,
    at: Positions,
    name: str,
    parts: Sequence[Part],
    free: Gaps,
    ends: Mapping[str, tuple[float, float]],
    size: float,
) -> list[Piece]:
    """Disc on a body between the plates of a fixed housing, around its ring, its plate or its shaft."""
    end = model.clutches[name].bodies[0]
    body, marker = split(end)
    thick, lining = PLATE * size, LINING * size
    nested = [part for part in parts if part.inner > 0.0]
    if nested:
        part = max(nested, key=lambda p: p.outer)
        place, inner = 0.5 * (part.low + part.high), part.outer
    else:
        place, width = _place(model, line, at, body, marker, parts, free, ends)
        thick = min(thick, NARROW * width)
        radius = shaft_radius(model, body, (place - at.starts[body]) * line.bodies[body]) or 0.03 * size
        inner = 0.0 if body not in model.shafts and not parts else radius
        lining = max(lining, (DISC - 1.0) * radius)
    outer = inner + lining
    disc = box_line(place - 0.5 * thick, place + 0.5 * thick, inner, outer)
    gap = 0.4 * thick
    held = [
        span_line(place + side * (0.5 * thick + gap), side * thick, outer - 0.6 * lining, outer + gap + thick)
        for side in (-1.0, 1.0)
    ]
    cap = box_line(place - 1.5 * thick - gap, place + 1.5 * thick + gap, outer + gap, outer + gap + thick)
    return [
        Piece(kind="lining", line=disc),
        *(Piece(kind="ground", line=plate) for plate in held),
        Piece(kind="ground", line=cap, name=name),
    ]


def _place(
    model: Model,
    line: Line,
    at: Positions,
    body: str,
    marker: str,
    parts: Sequence[Part],
    free: Gaps,
    ends: Mapping[str, tuple[float, float]],
) -> tuple[float, float]:
    """Position of a brake on a shaft and the room there [m]: at its marker, at the free end of its spindle,
    else between its gears."""
    if marker:
        place = model.bodies[body].markers[marker].position[2]
        return at.starts[body] + line.bodies[body] * float(place), math.inf
    if body in model.shafts or not parts or body not in ends:
        return at.starts[body], math.inf
    low, high = ends[body]
    if high > parts[-1].high:
        return 0.5 * (high + parts[-1].high), math.inf
    if low < parts[0].low:
        return 0.5 * (low + parts[0].low), math.inf
    return free.take(low, high)
