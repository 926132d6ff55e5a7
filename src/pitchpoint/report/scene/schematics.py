# SPDX-License-Identifier: Apache-2.0
"""Schematic solids of bodies without a shape: bars between their joints, balls, discs, springs.

All are marked as schematic. Positions and directions are those of the model, thicknesses are symbolic.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.model.components.actuator import Strut
from pitchpoint.model.frames import body_frame, joint_axes, joint_place, split
from pitchpoint.report.scene import shapes
from pitchpoint.report.scene.bearings import bearing_seats
from pitchpoint.report.scene.contact_curves import contact_parts
from pitchpoint.report.scene.places import placed_solid
from pitchpoint.viz.scene.content import Between, SceneSolid

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.report.scene.places import Places

Array = NDArray[np.float64]

STEEL = 7850.0
"""Density of balls and discs that represent masses and inertias [kg/m^3]."""
BAR, PIN, BALL, DISC = 0.010, 0.017, 0.045, 0.4
"""Radii of bars, pins, the largest ball and disc, relative to the size of the machine."""
SLIGHT = 1e-4
"""Mass of a body at the end of a beam over the largest mass, below which it is not drawn."""
GUESSED = 0.2
"""The same for a disc with known inertia only: the inertia of a vehicle is not that of a disc."""
RAIL = 0.15
"""Half length of a rail, relative to the size of the machine."""
PINNED = ("revolute", "cylindrical", "screw", "universal", "planar")


def schematics(
    model: Model, at: Places, drawn: set[str], wheeled: set[str]
) -> tuple[list[SceneSolid], list[str]]:
    """All schematic solids, and remarks on them.

    Parameters
    ----------
    model
        The model.
    at
        Where things sit in the scene.
    drawn
        Names of the bodies with a shape.
    wheeled
        Names of the bodies with wheels, which have no disc.
    """
    parts, notes = contact_parts(model, at.size)
    found: list[SceneSolid] = []
    shaped = drawn | wheeled | {split(where)[0] for _, where, _ in parts}
    for name in model.bodies:
        if name not in drawn and name not in model.elastic_bodies:
            found += _figure(at, name, name in shaped)
    bars = bool(found)
    found += _pins(at)
    found += _guides(at)
    found += _struts(at)
    found += _unbalances(at)
    found += [
        placed_solid(name, "body", at.end(where), surface, schematic=False) for name, where, surface in parts
    ]
    if bars:
        notes.append("bars, balls and discs represent bodies without a shape in the model")
    return found, notes


def stand_in(
    at: Places, name: str, kind: str, body: str, surface: shapes.Surface, place: ArrayLike | None = None
) -> SceneSolid:
    """Schematic solid on a body from a surface in world coordinates.

    Parameters
    ----------
    at
        Where things sit in the scene.
    name, kind
        Of the solid.
    body
        Name of the body, or ground.
    surface
        Surface in world coordinates [m].
    place
        Its position on an elastic shaft or body, in world coordinates [m]; default: middle of the surface.
    """
    points, triangles = surface
    number, origin, axes = at.seat(body, points.mean(axis=0) if place is None else place)
    return SceneSolid(
        name=name,
        kind=kind,
        body=number,
        points=(points - origin) @ axes,
        triangles=triangles,
        schematic=True,
    )


def _figure(at: Places, name: str, shaped: bool) -> list[SceneSolid]:
    """Bars from the joint that carries a body to its connection points, and a ball for its mass; else a disc.

    Only bars if other parts of the body are drawn.
    """
    part, bar = at.model.bodies[name], BAR * at.size
    points = at.anchors(name)
    origin, axes = at.origin(name), body_frame(at.model, name)[1]
    center = origin + axes @ np.array(part.center or (0.0, 0.0, 0.0))
    joint = at.model.joints.get(part.joint or "")
    place = None if joint is None else joint_place(at.model, joint)
    hub = place if place is not None else origin if part.moves != "fixed" or not points else points[0]
    pieces: list[shapes.Surface] = []
    for p in points:
        if part.moves == "fixed":
            pieces.append(shapes.ball(1.5 * bar, p, 12))
        elif np.linalg.norm(p - hub) > bar:
            pieces += [shapes.rod(hub, p, bar), shapes.ball(bar, p, 12)]
    heavy = part.mass or 0.0
    if part.moves == "fixed" or (shaped and not pieces) or (not pieces and _is_end(at.model, name)):
        pass
    elif joint is not None and joint.type == "prismatic" and part.center is None:
        side = min(BALL * at.size, max(4.0 * bar, (heavy / STEEL) ** (1.0 / 3.0)))
        pieces.append(
            shapes.box((side, side, side), center, shapes.across(joint_axes(at.model, joint)[:, 2]))
        )
    elif heavy > 0.0 and (part.center is not None or pieces):
        radius = min(BALL * at.size, max(1.6 * bar, (3.0 * heavy / (4.0 * math.pi * STEEL)) ** (1.0 / 3.0)))
        if np.linalg.norm(center - hub) > bar:
            pieces.append(shapes.rod(hub, center, 0.8 * bar))
        pieces.append(shapes.ball(radius, center))
    elif not shaped:
        pieces += [shapes.moved(piece, origin, axes) for piece in _rotor(at, name)]
    return [stand_in(at, name, "body", name, shapes.joined(pieces))] if pieces else []


def _is_end(model: Model, name: str) -> bool:
    """Whether a body is the end of a beam and has next to no mass, such as the tip of a blade."""
    heaviest = max(body.mass or 0.0 for body in model.bodies.values())
    ends = {split(end)[0] for beam in model.beams.values() for end in beam.ends}
    return name in ends and (model.bodies[name].mass or 0.0) < SLIGHT * heaviest


def _rotor(at: Places, name: str) -> list[shapes.Surface]:
    """Disc of a body; next to its bearings, if any, with a journal through these."""
    disc = _disc(at, name)
    seats = bearing_seats(at.model, at, name)
    if not seats:
        return [disc]
    low, high = min(seat.low for seat in seats), max(seat.high for seat in seats)
    thick = float(np.ptp(disc[0][:, 2]))
    journal = shapes.rod(
        (0.0, 0.0, low - 0.1 * (high - low)), (0.0, 0.0, high + 0.6 * thick), seats[0].radius, 48
    )
    return [journal, shapes.moved(disc, (0.0, 0.0, high + 0.7 * thick))]


def _disc(at: Places, name: str) -> shapes.Surface:
    """Steel disc with the inertia of a body, and its mass if given."""
    inertia, mass = at.model.body_inertia(name).polar, at.model.bodies[name].mass or 0.0
    radius = (2.0 * inertia / (0.3 * math.pi * STEEL)) ** 0.2
    if mass > 0.0 and inertia > 0.0:
        radius = math.sqrt(2.0 * inertia / mass)
    radius = min(max(radius, 0.04 * at.size), (DISC if mass > 0.0 else GUESSED) * at.size)
    return shapes.disc(radius, 0.3 * radius, 0.12 * radius)


def _pins(at: Places) -> list[SceneSolid]:
    """Pins and balls for joints."""
    found = []
    for name, joint in at.model.joints.items():
        place, body = joint_place(at.model, joint), split(joint.bodies[1])[0]
        if place is None:
            continue
        axis, radius = joint_axes(at.model, joint)[:, 2], PIN * at.size
        if joint.type in PINNED:
            surface = shapes.rod(place - 1.6 * radius * axis, place + 1.6 * radius * axis, radius)
        elif joint.type == "spherical":
            surface = shapes.ball(radius, place)
        else:
            continue
        found.append(stand_in(at, f"joint {name}", "bearing", body, surface))
    return found


def _guides(at: Places) -> list[SceneSolid]:
    """Rails on both sides of a sliding body."""
    found, thin = [], 0.4 * BAR * at.size
    for name, joint in at.model.joints.items():
        place = joint_place(at.model, joint)
        if joint.type != "prismatic" or place is None:
            continue
        axes = joint_axes(at.model, joint)
        long, beside = RAIL * at.size * axes[:, 2], (0.5 * BALL * at.size + thin) * axes[:, 0]
        rails = [shapes.rod(p - long, p + long, thin, 10) for p in (place - beside, place + beside)]
        base = split(joint.bodies[0])[0]
        found.append(stand_in(at, f"joint {name}", "bearing", base, shapes.joined(rails), place))
    return found


def _unbalances(at: Places) -> list[SceneSolid]:
    """Steel ball for every point mass, with a minimum size."""
    found = []
    for name, part in at.model.unbalances.items():
        radius = (3.0 * part.mass / (4.0 * math.pi * STEEL)) ** (1.0 / 3.0)
        radius = min(max(radius, 0.6 * BAR * at.size), BALL * at.size)
        place = at.world(part.body, part.position)[0]
        surface = shapes.ball(radius, place)
        found.append(stand_in(at, f"unbalance {name}", "bearing", part.body, surface, place))
    return found


def _struts(at: Places) -> list[SceneSolid]:
    """Actuators between two points."""
    struts = {n: p for n, p in at.model.actuators.items() if isinstance(p, Strut)}
    return [link(at, f"actuator {n}", p.ends, "spring", piston(at)) for n, p in struts.items()]


def thin(at: Places) -> float:
    """Radius of thin bars [m]."""
    return 0.55 * BAR * at.size


def bar(at: Places) -> shapes.Surface:
    """Bar of unit length."""
    r = thin(at)
    return shapes.turned_profile([(0.0, 0.0), (r, 0.0), (r, 1.0), (0.0, 1.0)], 12)


def piston(at: Places) -> shapes.Surface:
    """Piston in its cylinder, of unit length."""
    r = thin(at)
    return shapes.turned_profile(
        [(0.0, 0.0), (0.5 * r, 0.0), (0.5 * r, 0.45), (1.8 * r, 0.45), (1.8 * r, 1.0), (0.0, 1.0)], 16
    )


def link(at: Places, name: str, ends: Sequence[str], kind: str, surface: shapes.Surface) -> SceneSolid:
    """Surface of unit length, stretched between two points.

    Parameters
    ----------
    at
        Where things sit in the scene.
    name, kind
        Of the solid.
    ends
        Both ends: ground, BODY or BODY.MARKER.
    surface
        From 0 to 1 along z.
    """
    return stretched(name, kind, [at.end(end) for end in ends], surface)


def stretched(
    name: str, kind: str, ends: Sequence[tuple[int, Array, Array]], surface: shapes.Surface
) -> SceneSolid:
    """Surface of unit length between points of two scene bodies."""
    (a, first, _), (b, second, _) = ends
    points, triangles = surface
    return SceneSolid(
        name=name,
        kind=kind,
        body=a,
        points=points,
        triangles=triangles,
        between=Between((a, b), (first, second)),
        schematic=True,
    )
