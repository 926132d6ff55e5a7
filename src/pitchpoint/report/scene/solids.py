# SPDX-License-Identifier: Apache-2.0
"""Solids of a model for its scene: gears with their teeth, shafts, bearings, bodies from files.

Every solid is in the frame of its body at spin 0, as in the system. Components that cannot be drawn are
omitted with a remark. Only components of the model are drawn, except for spindles and pins, which
connect the gears of a body or carry them.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError, MissingDependencyError
from pitchpoint.geometry.shaft_solid import shaft_solid
from pitchpoint.geometry.triangle_file import join_corners
from pitchpoint.model.frames import frame
from pitchpoint.model.shafts import middle_of, section_at, station_names
from pitchpoint.report.scene.bearings import bearing_seats, bearing_solids, pin_of
from pitchpoint.report.scene.bevel_gears import bevel_part
from pitchpoint.report.scene.cad_files import surface_of
from pitchpoint.report.scene.connections import joining_parts
from pitchpoint.report.scene.gear_room import seated
from pitchpoint.report.scene.gears import gear_part
from pitchpoint.report.scene.ratios import ratio_parts
from pitchpoint.report.scene.schematics import schematics
from pitchpoint.report.scene.shapes import moved, rounded_box, turned_profile
from pitchpoint.report.scene.supports import carriers, covers, housings, spindle_radius
from pitchpoint.viz.scene.content import Blend, SceneSolid

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.report.scene.places import Places

Array = NDArray[np.float64]

ROUND = 48
"""Number of corners of a circle."""


def scene_solids(model: Model, at: Places) -> tuple[list[SceneSolid], list[str]]:
    """Solids of a model, and remarks on omitted ones.

    Parameters
    ----------
    model
        The model.
    at
        Where things sit in the scene.
    """
    found: list[SceneSolid] = []
    notes: list[str] = []
    cover = covers(model)
    thinner = drawn_allowances(model)
    for name in model.gears:
        body = model.body_of(name)
        if body is None:
            continue
        seat = at.own(body, (0.0, 0.0, model.bodies[body].gears[name]))
        try:
            pin = pin_of(model, at, body)
            room = 0.0 if pin is None else pin.outside
            solid, unseen = gear_part(model, name, seat, thinner.get(name, 0.0), room)
        except GeometryError as error:
            notes.append(f"gear {name} is not drawn: {error}")
            continue
        found.append(solid)
        notes += unseen
    for name in model.bevel_gears:
        body = model.body_of(name)
        if body is None:
            continue
        apex = model.bodies[body].bevel_gears[name]
        # on an elastic shaft the gear moves with the station of its teeth
        middle = middle_of(model.bevel_gears[name], apex) if body in model.shafts else apex
        number, place, axes = at.own(body, (0.0, 0.0, middle))
        seat = number, place + (apex - middle) * axes[:, 2], axes
        try:
            found.append(bevel_part(model, name, seat, thinner.get(name, 0.0)))
        except GeometryError as error:
            notes.append(f"bevel gear {name} is not drawn: {error}")
    for name in model.shafts:
        found.append(_shaft(model, name, at.names))
    for name, part in model.bodies.items():
        if part.solid is not None:
            try:
                found.append(_from_file(model, name, at, cover.get(name)))
            except (GeometryError, MissingDependencyError) as error:
                notes.append(f"body {name} is not drawn: {error}")
        elif name not in model.shafts and (part.gears or part.bevel_gears):
            found += _spindle(model, name, at)
        found += body_shapes(model, name, at)
    found += bearing_solids(model, at)
    plates = carriers(model, at)
    found += [solid for part in plates.values() for solid in part]
    frames = housings(model, at)
    found += [solid for part in frames.values() for solid in part]
    if frames:
        notes.append("frames around gears represent housings without a shape in the model")
    if model.bearings:
        notes.append(
            "linear bearings are drawn in catalogue sizes for their shafts or smaller than their gears; "
            "the model has no sizes"
        )
    if plates:
        notes.append("plates of carriers show positions, not sizes")
    shapes = {n for n, p in model.bodies.items() if p.gears or p.bevel_gears or p.solid is not None}
    shapes |= {n for n, p in model.bodies.items() if p.of_housing or p.shapes}
    shapes |= {*plates, *frames}
    wheels, lacking = ratio_parts(model, at)
    wheeled = {n for n in model.bodies if at.names.get(n) in {solid.body for solid in wheels}}
    more, remarks = schematics(model, at, shapes | set(model.shafts), wheeled)
    return [*found, *more, *joining_parts(model, at), *wheels], [*notes, *remarks, *lacking]


def drawn_allowances(model: Model) -> dict[str, float]:
    """Reduction of the normal tooth thickness of drawn gears for the given backlash of their meshes [m].

    By gear, at the reference circle, for bevel gears at mid-face; each gear has half of the value of a mesh,
    and a gear in several meshes the maximum. The relation to the backlash is that of
    `geometry.backlash.backlash_at`.
    """
    found: dict[str, float] = {}
    for name, mesh in model.meshes.items():
        pair = model.pairs[name]
        more = model.backlash(name) - pair.j_bt
        half = 0.5 * more * math.cos(pair.gear1.beta) / math.cos(pair.gear1.alpha_t)
        for gear in mesh.gears:
            found[gear] = max(found.get(gear, half), half)
    for name, bevel in model.bevel_meshes.items():
        pitch = model.bevel_pairs[name]
        more = model.backlash(name) - pitch.R_m * pitch.sigma_j
        half = 0.5 * more * math.cos(pitch.gear1.beta_m) / math.cos(pitch.alpha_t)
        for gear in bevel.gears:
            # the same arc at another cone distance
            own = half * model.bevel_gears[gear].geometry.R_m / pitch.R_m
            found[gear] = max(found.get(gear, own), own)
    return found


def _solid(
    name: str, kind: str, body: int, corners: Array, *, creases: float = 35.0, schematic: bool = False
) -> SceneSolid:
    """Triangles with indexed corners."""
    first, triangles = join_corners(corners)
    points = corners.reshape(-1, 3)[first]
    return SceneSolid(
        name=name,
        kind=kind,
        body=body,
        points=points,
        triangles=triangles,
        creases=creases,
        schematic=schematic,
    )


def _shaft(model: Model, name: str, bodies: Mapping[str, int]) -> SceneSolid:
    """Shaft that deforms between its stations."""
    shaft, places = model.shafts[name], np.array(model.stations[name])
    # sections are also divided at the stations, so that every ring of corners can follow one
    ends = np.cumsum([0.0, *(s.length for s in shaft.sections)])
    cuts = np.unique(np.concatenate([ends, places]))
    cuts = cuts[np.append(True, np.diff(cuts) > 1e-9 * ends[-1])]
    middles = 0.5 * (cuts[:-1] + cuts[1:])
    pieces = [
        (float(b - a), *section_at(shaft, float(m))) for a, b, m in zip(cuts, cuts[1:], middles, strict=False)
    ]
    corners = shaft_solid(pieces, ROUND)
    if len(places) < 2:
        return _solid(name, "shaft", bodies[name], corners)
    kept, triangles = join_corners(corners)
    points = corners.reshape(-1, 3)[kept]
    stations = station_names(name, len(places))
    height = np.clip(points[:, 2], places[0], places[-1])
    first = np.clip(np.searchsorted(places, height, side="right") - 1, 0, len(places) - 2)
    weight = (height - places[first]) / (places[first + 1] - places[first])
    return SceneSolid(
        name=name,
        kind="shaft",
        body=bodies[name],
        points=points - np.array([0.0, 0.0, places[0]]),
        triangles=triangles,
        blend=Blend([bodies[s] for s in stations], first, first + 1, weight),
    )


def _spindle(model: Model, name: str, at: Places) -> list[SceneSolid]:
    """Spindle that connects the gears of a body without sections, or the pin on which they turn."""
    part, pin = model.bodies[name], pin_of(model, at, name)
    radius = spindle_radius(model, name)
    if radius is None or (pin is not None and _has_spindle(model, pin.body)):
        return []
    radius = radius if pin is None else pin.radius
    ends = [z for gear in seated(model, name).values() for z in (gear.low, gear.high)]
    ends += [m.position[2] for m in part.markers.values() if _on_axis(m.position)]
    ends += [z for seat in bearing_seats(model, at, name) for z in (seat.low, seat.high)]
    low, high = min(ends), max(ends)
    over = 0.15 * (high - low)
    corners = shaft_solid([(high - low + 2.0 * over, 2.0 * radius, 0.0)], ROUND)
    start = at.world(name, (0.0, 0.0, low - over))
    number, place, axes = at.at_world(name if pin is None else pin.body, *start)
    word = "spindle" if pin is None else "pin"
    return [_solid(f"{name} ({word})", "shaft", number, corners @ axes.T + place, schematic=True)]


def body_shapes(model: Model, name: str, at: Places) -> list[SceneSolid]:
    """Boxes and bodies of revolution of a body; covers are transparent."""
    found = []
    for word, shape in model.bodies[name].shapes.items():
        if shape.box is not None:
            surface = rounded_box(shape.box, shape.rounding)
        else:
            line = [(0.5 * d, h) for h, d in zip(shape.heights, shape.diameters, strict=True)]
            ends = [line[0]] * (line[0][0] > 0.0), [line[-1]] * (line[-1][0] > 0.0)
            surface = turned_profile(
                [*((0.0, h) for _, h in ends[0]), *line, *((0.0, h) for _, h in ends[1])], ROUND
            )
        points, triangles = moved(surface, shape.position, frame(shape.axes))
        number, place, axes = at.own(name)
        found.append(
            SceneSolid(
                name=f"{name}.{word}",
                kind="housing" if shape.cover else "body",
                body=number,
                points=points @ axes.T + place,
                triangles=triangles,
                see_through=shape.cover,
            )
        )
    return found


def _has_spindle(model: Model, name: str) -> bool:
    """Whether a shaft or spindle is drawn for a body."""
    return name in model.shafts or (name in model.bodies and spindle_radius(model, name) is not None)


def _on_axis(place: Iterable[float]) -> bool:
    x, y, _ = place
    return x == 0.0 and y == 0.0


def _from_file(model: Model, name: str, at: Places, cover: str | None) -> SceneSolid:
    """Surface of a solid file, in the axes of its body; covers are transparent."""
    reference = model.bodies[name].solid
    assert reference is not None
    points, triangles = surface_of(reference)
    points = (points - np.array(reference.origin or (0.0, 0.0, 0.0))) @ frame(reference.axes)
    number, place, axes = at.own(name)
    return SceneSolid(
        name=name,
        kind=cover or "body",
        body=number,
        points=points @ axes.T + place,
        triangles=triangles,
        creases=20.0,
        see_through=cover is not None,
    )
