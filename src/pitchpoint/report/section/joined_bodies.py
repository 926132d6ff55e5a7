# SPDX-License-Identifier: Apache-2.0
"""Couplings between the bodies of an axis, and bodies without gears at their ends, such as motors and
brakes."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from pitchpoint.model.frames import split
from pitchpoint.model.shafts import section_at
from pitchpoint.report.scene.supports import shaft_radius
from pitchpoint.report.section.axes import Line, seat_shaft
from pitchpoint.report.section.boxes import box_line
from pitchpoint.report.section.carriers import HUB, Carrier, planets_of
from pitchpoint.report.section.clutches import is_nested
from pitchpoint.report.section.places import Positions
from pitchpoint.viz.section_content import Piece

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

STEEL = 7850.0
"""Density of discs that represent inertias [kg/m^3]."""
LOW, FLANGE = 0.02, 0.04
"""Least and largest height of a flange above the shaft, relative to the size of the machine; between them it
is the radius of the shaft."""
DISC = 0.2
"""Half width of a disc relative to its radius."""
LEAST, LARGEST = 0.06, 0.16
"""Least and largest radius of a disc, relative to the size of the machine."""

Ends = tuple[float, float]
Place = tuple[str, float]
"""A body and a position along its axis from its origin [m]."""


def connected(
    model: Model,
    line: Line,
    at: Positions,
    ends: Mapping[str, Ends],
    size: float,
    carriers: Mapping[str, Carrier],
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
    carriers
        Its carriers.
    """
    reach = dict(ends)
    discs = {
        body: at.starts[body]
        for body in line.bodies
        if body not in ends and not _rides(model, body) and model.bodies[body].moves != "fixed"
    }
    found: list[Piece] = []
    for name, one, two, place in _couplings(model, line, carriers):
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
            for end, body in ((reach[low][1], low), (reach[high][0], high)):
                if body in carriers and abs(z - end) > 0.2 * radius:
                    found.append(_stub(end, z, min(radius, 2.5 * HUB * carriers[body].room.far)))
            if low not in model.shafts:
                reach[low] = (reach[low][0], max(reach[low][1], z))
            if high not in model.shafts:
                reach[high] = (min(reach[high][0], z), reach[high][1])
        else:
            disc, shaft = (one, two) if one in discs else (two, one)
            wanted = discs[disc]
            if reach[shaft][0] < wanted < reach[shaft][1] and at.gears:  # no place of its own: outwards
                middle = 0.5 * (min(at.gears.values()) + max(at.gears.values()))
                wanted = reach[shaft][int(sum(reach[shaft]) > 2.0 * middle)]
            if place is not None and shaft in model.shafts:
                wanted = at.starts[place[0]] + line.bodies[place[0]] * place[1]
            ends_of = reach[shaft]
            if shaft in carriers:  # on the side on which it is connected
                ends_of = (ends_of[int(carriers[shaft].closed > 0.0)],) * 2
                discs[disc] = wanted = ends_of[0] + 1.8 * radius * carriers[shaft].closed
            end, discs[disc] = _beyond(ends_of, wanted, discs[disc], radius)
            z = 0.5 * (end + discs[disc])
            found.append(_stub(end, discs[disc], radius))
        half, gap = 0.2 * radius, 0.03 * radius
        nested = _nested(model, line, at, (one, two), z)
        if nested is not None:
            found.append(Piece(kind="flange", line=box_line(z - half, z + half, *nested), name=name))
            continue
        found.append(Piece(kind="flange", line=box_line(z - half, z - gap, 0.0, radius)))
        found.append(Piece(kind="flange", line=box_line(z + gap, z + half, 0.0, radius), name=name))
    masses = [_disc(model, body, z, size) for body, z in discs.items()]
    masses += [piece for body in line.bodies if (piece := _seated(model, line, at, body, size)) is not None]
    return found, masses, reach


def _beyond(ends: Ends, wanted: float, place: float, radius: float) -> tuple[float, float]:
    """End of a shaft next to a disc, and the position of the disc beyond it."""
    low, high = ends
    end = low if abs(wanted - low) <= abs(wanted - high) else high
    way = -1.0 if end == low else 1.0
    return end, place if (place - end) * way > 1.6 * radius else end + way * 1.8 * radius


def _couplings(
    model: Model, line: Line, carriers: Mapping[str, Carrier]
) -> list[tuple[str, str, str, Place | None]]:
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
            if len(c.bodies) == 2 and c.stage is None and not is_nested(model, c.bodies, carriers)
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
    if not radii:
        return 0.05 * size
    return min(radii) + min(max(min(radii), LOW * size), FLANGE * size)


def _nested(model: Model, line: Line, at: Positions, bodies: tuple[str, str], z: float) -> Ends | None:
    """Radii between which a coupling connects a shaft with a hollow one around it [m]; None for others."""
    found = []
    for body in bodies:
        if body not in model.shafts:
            return None
        place = (z - at.starts[body]) * line.bodies[body]
        if not 0.0 <= place <= model.shafts[body].length:
            return None
        found.append(section_at(model.shafts[body], place))
    (inner, _), (outer, bore) = sorted(found)
    return (0.5 * inner, 0.5 * max(bore, 1.02 * inner)) if bore >= 0.98 * inner and outer > inner else None


def _stub(one: float, two: float, radius: float) -> Piece:
    """Shaft from an end to a disc."""
    return Piece(kind="spindle", line=box_line(min(one, two), max(one, two), 0.0, 0.4 * radius))


def _rides(model: Model, body: str) -> bool:
    """Whether a body is on a joint of another one, such as a planet."""
    seat = model.mechanism.seats.get(body)
    return seat is not None and seat.parent in model.bodies


def _seated(model: Model, line: Line, at: Positions, body: str, size: float) -> Piece | None:
    """Disc of a body fixed to a shaft, such as a rotor or a brake disc: around the shaft, or at its end."""
    shaft = seat_shaft(model, body)
    if shaft is None or shaft not in line.bodies or planets_of(model, body):
        return None
    radius = _disc_radius(model, body, size)
    half, z = DISC * radius, at.starts[body]
    inner = shaft_radius(model, shaft, (z - at.starts[shaft]) * line.bodies[shaft]) or 0.0
    start, end = sorted(
        (at.starts[shaft], at.starts[shaft] + line.bodies[shaft] * model.shafts[shaft].length)
    )
    if z - start < half or end - z < half:
        z, inner = (z - half, 0.0) if z - start < half else (z + half, 0.0)
    radius = max(radius, 1.5 * inner)
    return Piece(kind="mass", line=box_line(z - half, z + half, inner, radius), name=body)


def _disc_radius(model: Model, body: str, size: float) -> float:
    """Radius of a disc with the inertia of a body, where it is not too large or small [m]."""
    inertia = model.body_inertia(body).polar
    radius = (2.0 * inertia / (0.3 * math.pi * STEEL)) ** 0.2 if inertia > 0.0 else 0.0
    return min(max(radius, LEAST * size), LARGEST * size)


def _disc(model: Model, body: str, z: float, size: float) -> Piece:
    """Disc with the inertia of a body."""
    radius = _disc_radius(model, body, size)
    return Piece(kind="mass", line=box_line(z - DISC * radius, z + DISC * radius, 0.0, radius), name=body)
