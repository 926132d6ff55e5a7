# SPDX-License-Identifier: Apache-2.0
"""Supports in a scene: radii of shafts, plates and pins of planet carriers, a frame for the housing.

Their positions are given by the model; their shapes are symbolic and marked as schematic.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.frames import GROUND, joint_axes, joint_place, split
from pitchpoint.model.housing import node_bodies
from pitchpoint.model.rings import ring_bodies, rings_of
from pitchpoint.model.shafts import section_at
from pitchpoint.report.scene import shapes
from pitchpoint.report.scene.bearing_sizes import BearingSize, size_on
from pitchpoint.report.scene.gear_room import seated
from pitchpoint.report.scene.places import placed_solid
from pitchpoint.viz.scene.content import SceneSolid

if TYPE_CHECKING:
    from pitchpoint.model.components.joint import Joint
    from pitchpoint.model.model import Model
    from pitchpoint.report.scene.places import Places

Array = NDArray[np.float64]

SPINDLE, RIM = 0.35, 0.4
"""Radius of a spindle, relative to the smallest root radius on it; section height of a linear bearing on a
spindle, relative to the height from the spindle to the root circle."""
DEFAULT_RADIUS = 0.02
"""Radius of the rotating part in a bearing if unknown, relative to the size of the machine."""
EDGE, ROOM = 0.003, 0.02
"""Radius of the bars of a frame, and its distance from the contents, relative to the size of the machine."""


def spindle_radius(model: Model, body: str) -> float | None:
    """Radius of the spindle for the gears of a body without sections [m]; None without gears."""
    gears = seated(model, body).values()
    roots = [g.root for g in gears if g.root is not None]
    if not roots:
        return None
    bores = [g.hub for g in gears if g.hub > 0.0]
    return min(bores) if bores else SPINDLE * min(roots)


def linear_size(model: Model, name: str, size: float) -> BearingSize:
    """Dimensions drawn for a linear bearing; on a spindle it is smaller than the root circles of the gears.

    Parameters
    ----------
    model
        The model.
    name
        Name of the bearing.
    size
        Size of the machine [m], from which that of a shaft of unknown diameter follows.
    """
    part = model.bearings[name]
    radius = shaft_radius(model, part.body, part.position[2]) or DEFAULT_RADIUS * size
    most = math.inf
    if part.body in model.bodies and part.body not in model.shafts:
        roots = [g.root for g in seated(model, part.body).values() if g.root is not None]
        most = min((2.0 * (radius + RIM * (root - radius)) for root in roots), default=math.inf)
    return size_on(radius, part.stiffness.matrix6()[2][2] > 0.0, most)


def shaft_radius(model: Model, body: str, z: float) -> float | None:
    """Radius of the rotating part at an axial position on a body [m]; None if unknown."""
    shaft = model.shafts.get(body)
    if shaft is not None:
        return 0.5 * section_at(shaft, z)[0]
    return spindle_radius(model, body) if body in model.bodies else None


def carriers(model: Model, at: Places) -> dict[str, list[SceneSolid]]:
    """Plates and pins of planet carriers without a solid, by body."""
    found: dict[str, list[SceneSolid]] = {}
    for name, body in model.bodies.items():
        pins = [
            joint
            for joint in model.joints.values()
            if joint.type == "revolute"
            and split(joint.bodies[0])[0] == name
            and (moved := model.bodies.get(split(joint.bodies[1])[0])) is not None
            and moved.gears
            and body.moves != "fixed"
        ]
        origin, axes = at.world(name)
        places = [axes.T @ (p - origin) for j in pins if (p := joint_place(model, j)) is not None]
        along = all(abs(float(axes[:, 2] @ joint_axes(model, j)[:, 2])) > 0.999 for j in pins)
        if not pins or body.solid is not None or not along or len(places) < len(pins):
            continue
        if max(float(np.hypot(p[0], p[1])) for p in places) < 1e-6 * at.size:
            continue
        found[name] = _carrier(model, at, name, list(zip(pins, places, strict=True)))
    return found


def _carrier(model: Model, at: Places, name: str, pins: list[tuple[Joint, Array]]) -> list[SceneSolid]:
    """Plate behind the planets and a pin through each, in the axes of the carrier."""
    pieces = []
    low, high, reach = [], [], []
    for joint, place in pins:
        planet = split(joint.bodies[1])[0]
        for gear, middle in model.bodies[planet].gears.items():
            half = 0.5 * model.gears[gear].face_width
            low.append(place[2] + middle - half)
            high.append(place[2] + middle + half)
        radius = spindle_radius(model, planet) or DEFAULT_RADIUS * at.size
        reach.append((float(np.hypot(place[0], place[1])), radius, place))
    thick = 0.25 * (max(high) - min(low))
    bottom = min(low) - 0.3 * thick
    outer = max(far + 1.6 * radius for far, radius, _ in reach)
    inner = min(0.45 * min(far for far, _, _ in reach), outer * 0.5)
    pieces.append(shapes.moved(shapes.disc(outer, thick, inner, 64), (0.0, 0.0, bottom - 0.5 * thick)))
    for _, radius, place in reach:
        start = np.array([place[0], place[1], bottom - thick])
        end = np.array([place[0], place[1], max(high) + 0.5 * thick])
        pieces.append(shapes.rod(start, end, 0.98 * radius, 24))
    return [placed_solid(f"{name} (carrier)", "carrier", at.own(name), shapes.joined(pieces))]


def covers(model: Model) -> dict[str, str]:
    """Bodies whose solids would hide their contents, by name: "housing", or "carrier" if they rotate.

    They are fixed, or support bearings or rotating gears; moving bodies with own gears and shafts are not
    covers.
    """
    rings = [ring_bodies(p)[1] for g in (model.rolling_bearings, model.plain_bearings) for p in g.values()]
    seats = [b.housing or GROUND for b in model.bearings.values()]
    pins = [j.bodies for j in model.joints.values() if j.type == "revolute"]
    carrying = [on for on, end in pins if (body := model.bodies.get(split(end)[0])) and body.gears]
    holding = {split(end)[0] for end in (*rings, *seats, *carrying)}
    found = {}
    for name, body in model.bodies.items():
        kind = joint_type(model, name) or body.moves
        if name in model.shafts or (kind != "fixed" and (name not in holding or body.gears)):
            continue
        found[name] = "carrier" if kind in ("torsion", "revolute") else "housing"
    return found


def joint_type(model: Model, body: str) -> str | None:
    """Type of the joint that carries a body; None without joint."""
    joint = model.joints.get(model.bodies[body].joint or "")
    return None if joint is None else joint.type


def housings(model: Model, at: Places) -> dict[str, list[SceneSolid]]:
    """Bars along the edges of a box around two or more bearings, by the body that supports them.

    This body is ground or a body without gears and without a solid.
    """
    held: dict[str, list[tuple[str, Array]]] = {}
    for part in model.bearings.values():
        if part.body in model.bodies:
            place = at.world(part.body, part.position)[0]
            held.setdefault(_frame_of(model, part.housing or GROUND), []).append((part.body, place))
    for group in (model.rolling_bearings, model.plain_bearings):
        for pair in group.values():
            inner, outer = ring_bodies(pair)
            where = rings_of(model, pair)[1].place
            if inner in model.bodies and where is not None:
                held.setdefault(_frame_of(model, outer), []).append((inner, where))
    found = {}
    for name, parts in held.items():
        body = model.bodies.get(name)
        if len(parts) < 2:
            continue
        if body is not None and (body.gears or body.bevel_gears or body.solid is not None or body.shaft):
            continue
        if name in model.elastic_bodies:
            continue
        found[name] = [_frame(model, at, name, parts)]
    return found


def _frame_of(model: Model, end: str) -> str:
    """Body with whose frame a bearing is drawn; the nodes of a housing matrix have one frame on ground."""
    body = split(end)[0]
    return GROUND if body in node_bodies(model) else body


def _frame(model: Model, at: Places, name: str, parts: list[tuple[str, Array]]) -> SceneSolid:
    """Box around bearings and the gears that they support."""
    corners = []
    for body, place in parts:
        axis = at.world(body)[1][:, 2]
        radius = (
            shaft_radius(model, body, float((place - at.origin(body)) @ axis)) or DEFAULT_RADIUS * at.size
        )
        drawn = size_on(radius, True)
        corners.append(_reach(place, axis, 0.5 * drawn.outside, 0.5 * drawn.width))
        for gear in seated(model, body).values():
            middle = at.world(body, (0.0, 0.0, gear.middle))[0]
            corners.append(_reach(middle, axis, gear.outer, 0.5 * (gear.high - gear.low)))
    box = np.concatenate(corners)
    low, high = box.min(axis=0) - ROOM * at.size, box.max(axis=0) + ROOM * at.size
    ends = np.array([[(low, high)[k >> i & 1][i] for i in range(3)] for k in range(8)])
    bars = [
        shapes.rod(ends[k], ends[k | 1 << i], EDGE * at.size, 8)
        for k in range(8)
        for i in range(3)
        if not k >> i & 1
    ]
    points, triangles = shapes.joined(bars)
    number, origin, axes = at.seat(name)
    return SceneSolid(
        name="housing (frame)" if name == GROUND else f"{name} (frame)",
        kind="housing",
        body=number,
        points=(points - origin) @ axes,
        triangles=triangles,
        see_through=True,
        schematic=True,
    )


def _reach(origin: Array, axis: Array, radius: float, half: float) -> Array:
    """Corners of a box along the world axes around a disc."""
    size = half * np.abs(axis) + radius * np.sqrt(np.maximum(1.0 - axis**2, 0.0))
    return np.array([origin - size, origin + size])
