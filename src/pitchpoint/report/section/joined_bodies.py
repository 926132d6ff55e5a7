# SPDX-License-Identifier: Apache-2.0
"""Couplings between the bodies of an axis, and bodies without gears at their ends, such as motors and
brakes."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from pitchpoint.model.frames import split
from pitchpoint.report.scene.supports import shaft_radius
from pitchpoint.report.section.axes import Line
from pitchpoint.report.section.bearings import box_line
from pitchpoint.report.section.places import Positions
from pitchpoint.viz.section_content import Piece

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

STEEL = 7850.0
"""Density of discs that represent inertias [kg/m^3]."""
FLANGE = 2.0
"""Radius of a flange relative to that of the shaft."""
LEAST, LARGEST = 0.06, 0.16
"""Least and largest radius of a disc, relative to the size of the machine."""

Ends = tuple[float, float]
Place = tuple[str, float]
"""A body and a position along its axis from its origin [m]."""


def connected(
    model: Model, line: Line, at: Positions, ends: Mapping[str, Ends], size: float
) -> tuple[list[Piece], list[Piece], dict[str, Ends]]:
    """Couplings of an axis, discs of its bodies without shaft or gears, and the ends of its shafts up to
    them.

    A disc that would be inside a shaft is placed beyond the nearest end of it.

    Parameters
    ----------
    model
        The model.
    line
        The axis.
    at
        Positions along the axes.
    ends
        Ends of shafts and spindles by body [m].
    size
        Size of the machine [m].
    """
    reach = dict(ends)
    discs = {
        body: at.starts[body]
        for body in line.bodies
        if body not in ends and not _rides(model, body) and model.bodies[body].moves != "fixed"
    }
    found: list[Piece] = []
    for name, one, two, place in _couplings(model, line):
        radius = _flange(model, one, two, size)
        if one not in reach and one not in discs or two not in reach and two not in discs:
            continue
        if one in discs and two in discs:
            if abs(discs[one] - discs[two]) < 2.0 * radius:
                discs[two] = discs[one] + 3.0 * radius
            z = 0.5 * (discs[one] + discs[two])
            found.append(_stub(discs[one], discs[two], radius))
        elif one in reach and two in reach:
            low, high = sorted((one, two), key=lambda body: sum(reach[body]))
            z = 0.5 * (reach[low][1] + reach[high][0])
            if (one in model.shafts or two in model.shafts) and place is not None:
                z = at.starts[place[0]] + line.bodies[place[0]] * place[1]
            if low not in model.shafts:
                reach[low] = (reach[low][0], max(reach[low][1], z))
            if high not in model.shafts:
                reach[high] = (min(reach[high][0], z), reach[high][1])
        else:
            disc, shaft = (one, two) if one in discs else (two, one)
            wanted = discs[disc]
            if place is not None and shaft in model.shafts:
                wanted = at.starts[place[0]] + line.bodies[place[0]] * place[1]
            end, discs[disc] = _beyond(reach[shaft], wanted, discs[disc], radius)
            z = 0.5 * (end + discs[disc])
            found.append(_stub(end, discs[disc], radius))
        half, gap = 0.2 * radius, 0.03 * radius
        found.append(Piece(kind="flange", line=box_line(z - half, z - gap, 0.0, radius)))
        found.append(Piece(kind="flange", line=box_line(z + gap, z + half, 0.0, radius), name=name))
    masses = [_disc(model, body, z, size) for body, z in discs.items()]
    return found, masses, reach


def _beyond(ends: Ends, wanted: float, place: float, radius: float) -> tuple[float, float]:
    """End of a shaft next to a disc, and the position of the disc beyond it."""
    low, high = ends
    end = low if abs(wanted - low) <= abs(wanted - high) else high
    way = -1.0 if end == low else 1.0
    return end, place if (place - end) * way > 1.6 * radius else end + way * 1.8 * radius


def _couplings(model: Model, line: Line) -> list[tuple[str, str, str, Place | None]]:
    """Couplings between bodies of an axis, with the places that the model gives."""
    # hub and spring of a scissor gear are inside the gear
    parts: list[tuple[str, tuple[str, ...], Place | None]] = [
        (name, c.bodies, (split(c.bodies[0])[0], c.position[2]))
        for name, c in model.couplings.items()
        if c.stage is None
    ]
    for group in (model.clutches, model.torsion_springs):
        parts += [
            (name, c.bodies, _marked(model, c.bodies))
            for name, c in group.items()
            if len(c.bodies) == 2 and c.stage is None
        ]
    found = []
    for name, ends, place in parts:
        one, two = (split(end)[0] for end in ends)
        if one in line.bodies and two in line.bodies:
            found.append((name, one, two, place))
    return found


def _marked(model: Model, ends: Sequence[str]) -> Place | None:
    """Place of the first end at a marker of a shaft, for parts without a position of their own."""
    for body, marker in map(split, ends):
        if marker and body in model.shafts:
            return body, float(model.bodies[body].markers[marker].position[2])
    return None


def _flange(model: Model, one: str, two: str, size: float) -> float:
    """Radius of the flanges of a coupling [m]."""
    radii = [r for body in (one, two) if (r := shaft_radius(model, body, 0.0))]
    return max(FLANGE * min(radii), 0.03 * size) if radii else 0.05 * size


def _stub(one: float, two: float, radius: float) -> Piece:
    """Shaft from an end to a disc."""
    return Piece(kind="spindle", line=box_line(min(one, two), max(one, two), 0.0, 0.4 * radius))


def _rides(model: Model, body: str) -> bool:
    """Whether a body is on a joint of another one, such as a planet."""
    seat = model.mechanism.seats.get(body)
    return seat is not None and seat.parent in model.bodies


def _disc(model: Model, body: str, z: float, size: float) -> Piece:
    """Disc with the inertia of a body where it is not too large or small."""
    inertia = model.body_inertia(body).polar
    radius = (2.0 * inertia / (0.3 * math.pi * STEEL)) ** 0.2 if inertia > 0.0 else 0.0
    radius = min(max(radius, LEAST * size), LARGEST * size)
    return Piece(kind="mass", line=box_line(z - 0.2 * radius, z + 0.2 * radius, 0.0, radius), name=body)
