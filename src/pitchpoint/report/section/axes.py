# SPDX-License-Identifier: Apache-2.0
"""Axes of a gearbox: coaxial bodies, the connections between axes, and axes that are alike."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.frames import GROUND, body_frame, split

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

PARALLEL = 1e-6
"""Sine of the angle between axes up to which they are parallel."""
COAXIAL = 1e-6
"""Distance of coaxial axes, absolute [m] and relative to their distance from the origin."""
ALIKE = 1e-2
"""Relative difference of distances, such as by pin errors, up to which axes are alike."""


@dataclass
class Line:
    """An axis with its bodies.

    Attributes
    ----------
    point
        Its point nearest to the origin of the world [m].
    way
        Its direction; parallel axes have the same.
    bodies
        Its bodies, with the sign of their z axes along it.
    """

    point: Array
    way: Array
    bodies: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Joined:
    """Two axes that mesh or carry each other.

    Attributes
    ----------
    kind
        mesh, bevel or carrier.
    name
        Name of the mesh, or of the planet.
    lines
        Numbers of the axes; the carrier is the first.
    """

    kind: str
    name: str
    lines: tuple[int, int]


def drawn_bodies(model: Model) -> list[str]:
    """Bodies of the power flow: with gears, shafts, carriers, and rigid ones that links connect.

    Of those without gears and shafts, only bodies parallel to one with them: not the nacelle that turns about
    a tower.
    """
    from pitchpoint.model.mechanism import base_of
    from pitchpoint.model.speed_ratios import links_of

    machine: Any = model
    linked = {body for _, one, two, _ in links_of(machine) for body in (one, two)}
    linked |= {split(end)[0] for clutch in model.clutches.values() for end in clutch.bodies}
    linked -= set(model.elastic_bodies)
    for name, body in model.bodies.items():
        seat = model.mechanism.seats.get(base_of(model, model.mechanism, name))
        if body.gears and seat is not None and "spin" in seat.coordinates:
            linked.add(seat.body)  # carriers
        linked |= {carrier for carrier in [carrier_of(model, name)] if carrier is not None}
    linked |= {name for name in model.bodies if seat_shaft(model, name) is not None}
    geared = [n for n, b in model.bodies.items() if b.gears or b.bevel_gears or n in model.shafts]
    ways = [body_frame(model, name)[1][:, 2] for name in geared]

    def along(name: str) -> bool:
        """Whether the axis of a body is parallel to that of a gear or shaft."""
        z = body_frame(model, name)[1][:, 2]
        return any(float(np.linalg.norm(np.cross(way, z))) < PARALLEL for way in ways)

    return [name for name in model.bodies if name in geared or (name in linked and along(name))]


def carrier_of(model: Model, body: str) -> str | None:
    """Body on whose joint a body with gears rotates, such as the carrier of planets, moving or fixed."""
    seat = model.mechanism.seats.get(body)
    if seat is None or seat.joint is None or seat.parent not in model.bodies or not model.bodies[body].gears:
        return None
    if model.bodies[seat.parent].moves == "fixed" or "spin" in seat.coordinates:
        return seat.parent
    return None


def seat_shaft(model: Model, body: str) -> str | None:
    """Shaft to which a body without gears is fixed by a joint, such as a rotor or the disc of a brake."""
    seat = model.mechanism.seats.get(body)
    if seat is None or seat.joint is None or seat.coordinates or model.bodies[body].gears:
        return None
    return seat.parent if seat.parent in model.shafts else None


def lines_of(model: Model, bodies: Sequence[str]) -> list[Line]:
    """Axes with their bodies, in the order of the bodies.

    Parameters
    ----------
    model
        The model.
    bodies
        Names of the bodies.
    """
    found: list[Line] = []
    for name in bodies:
        origin, axes = body_frame(model, name)
        place = np.zeros(3) if origin is None else origin
        way = next(
            (line.way for line in found if np.linalg.norm(np.cross(line.way, axes[:, 2])) < PARALLEL),
            axes[:, 2],
        )
        sign = float(np.sign(way @ axes[:, 2]))
        point = place - way * (way @ place)
        limit = COAXIAL * (1.0 + float(np.linalg.norm(point)))
        own = next(
            (line for line in found if line.way is way and np.linalg.norm(line.point - point) < limit), None
        )
        if own is None:
            found.append(own := Line(point, way))
        own.bodies[name] = sign
    return found


def connections(model: Model, lines: Sequence[Line]) -> list[Joined]:
    """Meshes and carriers between axes.

    Parameters
    ----------
    model
        The model.
    lines
        Its axes.
    """
    from pitchpoint.model.mechanism import base_of

    of = {body: k for k, line in enumerate(lines) for body in line.bodies}
    found = []
    for body, k in of.items():
        base = carrier_of(model, body) or base_of(model, model.mechanism, body)
        if base != GROUND and base in of and of[base] != k and lines[of[base]].way is lines[k].way:
            found.append(Joined("carrier", body, (of[base], k)))
    for name, mesh in model.every_mesh.items():
        bodies = [model.body_of(gear) for gear in mesh.gears]
        if all(body in of for body in bodies):
            one, two = (of[str(body)] for body in bodies)
            if one != two:
                found.append(Joined("bevel" if name in model.bevel_meshes else "mesh", name, (one, two)))
    return found


def alike(model: Model, lines: Sequence[Line], joined: Sequence[Joined]) -> dict[int, list[int]]:
    """Axes with equal gears around one other axis, such as planets: the first one, and all of them.

    Parameters
    ----------
    model
        The model.
    lines
        The axes.
    joined
        Their connections.
    """
    groups: dict[Any, list[int]] = {}
    for k, line in enumerate(lines):
        near = [each for each in joined if k in each.lines and each.kind != "bevel"]
        centres = {c for each in near for c in each.lines if c != k and _central(each, c, joined)}
        if len(centres) != 1 or len(near) < 2:
            continue  # planets and idlers around one axis have two connections with it
        centre = next(iter(centres))
        distance = float(np.linalg.norm(line.point - lines[centre].point))
        mates = sorted(
            _mate(model, each, line.bodies) for each in near if each.kind == "mesh" and centre in each.lines
        )
        if len(set(mates)) < 2 and not any(each.kind == "carrier" for each in near):
            continue  # both halves of a scissor gear mesh with one gear
        teeth = sorted(
            (model.gears[g].number_of_teeth, g_z)
            for b in line.bodies
            for g, g_z in model.bodies[b].gears.items()
        )
        key = (centre, tuple(mates), tuple(teeth))
        for (other, far), members in groups.items():
            if other == key and abs(far - distance) < ALIKE * distance:
                members.append(k)
                break
        else:
            groups[key, distance] = [k]
    return {members[0]: members for members in groups.values()}


def _central(each: Joined, line: int, joined: Sequence[Joined]) -> bool:
    """Whether a neighbouring axis is a carrier axis, or this is a mesh without carriers."""
    carriers = {one.lines[0] for one in joined if one.kind == "carrier"}
    planets = {one.lines[1] for one in joined if one.kind == "carrier"}
    return line in carriers or line not in planets


def _mate(model: Model, each: Joined, own: Mapping[str, float]) -> str:
    """Gear of the other axis in a mesh."""
    return next(g for g in model.meshes[each.name].gears if model.body_of(g) not in own)
