# SPDX-License-Identifier: Apache-2.0
"""Solids of a model for its scene: gears with their teeth, shafts, bearings, bodies from files.

Every solid is in the frame of its body at spin 0, as the system has it. What has no drawing is left out and
said: nothing is drawn that the model does not hold, but for spindles, which only join the gears of a body.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.shaft_solid import shaft_solid
from pitchpoint.geometry.triangle_file import join_corners, placed_triangles, read_triangles
from pitchpoint.model.frames import GROUND, frame, marker_of, split
from pitchpoint.model.shafts import nearest_station, section_at, station_names
from pitchpoint.report.scene_gears import gear_part
from pitchpoint.viz.scene import SceneSolid, Skin

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

ROUND = 48
"""Corners of a drawn circle."""
SPINDLE = 0.35
"""Radius of a drawn spindle, as a part of the smallest root radius on it."""


def scene_solids(model: Model, bodies: dict[str, int]) -> tuple[list[SceneSolid], list[str]]:
    """Solids of a model, and what is not drawn.

    Parameters
    ----------
    model
        The model.
    bodies
        Numbers of the bodies of the scene by name.
    """
    found: list[SceneSolid] = []
    notes: list[str] = []
    thinner = thinning(model)
    for name in model.gears:
        seat = _seat(model, name)
        if seat is None:
            continue
        body, height = seat
        try:
            solid, unseen = gear_part(model, name, bodies[body], height, thinner.get(name, 0.0))
        except GeometryError as error:
            notes.append(f"gear {name} is not drawn: {error}")
            continue
        found.append(solid)
        notes += unseen
    for name in model.shafts:
        found.append(_shaft(model, name, bodies))
    for name, part in model.bodies.items():
        if part.solid is not None:
            try:
                found.append(_from_file(model, name, bodies))
            except GeometryError as error:
                notes.append(f"body {name} is not drawn: {error}")
        elif name not in model.shafts and part.gears:
            found += _spindle(model, name, bodies)
    for name in model.rolling_bearings:
        found += _rolling_bearing(model, name, bodies)
    return found, notes


def thinning(model: Model) -> dict[str, float]:
    """Normal tooth thickness that drawn gears lack so that meshes show the backlash that is given [m].

    By gear, at the reference circle; half of a mesh's part each, and of a gear in several meshes the largest.
    The backlash follows the thickness as in `geometry.backlash.backlash_at`.
    """
    found: dict[str, float] = {}
    for name, mesh in model.meshes.items():
        pair = model.pairs[name]
        more = model.backlash(name) - pair.j_bt
        half = 0.5 * more * math.cos(pair.gear1.beta) / math.cos(pair.gear1.alpha_t)
        for gear in mesh.gears:
            found[gear] = max(found.get(gear, half), half)
    return found


def _solid(
    name: str, kind: str, body: int, corners: Array, *, teeth: int = 0, creases: float = 35.0
) -> SceneSolid:
    """Triangles with their corners numbered."""
    first, triangles = join_corners(corners)
    points = corners.reshape(-1, 3)[first]
    return SceneSolid(
        name=name, kind=kind, body=body, points=points, triangles=triangles, teeth=teeth, creases=creases
    )


def _seat(model: Model, gear: str) -> tuple[str, float] | None:
    """Body that a gear turns with, a station of a shaft, and its height there [m]."""
    body = model.body_of(gear)
    if body is None:
        return None
    height = model.bodies[body].gears[gear]
    places = model.stations.get(body)
    if places is None:
        return body, height
    k = nearest_station(places, height)
    return station_names(body, len(places))[k], height - places[k]


def _shaft(model: Model, name: str, bodies: dict[str, int]) -> SceneSolid:
    """A shaft that bends between its stations."""
    shaft, places = model.shafts[name], np.array(model.stations[name])
    # sections are cut at the stations too, so that every ring of corners can follow one
    ends = np.cumsum([0.0, *(s.length for s in shaft.sections)])
    cuts = np.unique(np.concatenate([ends, places]))
    cuts = cuts[np.append(True, np.diff(cuts) > 1e-9 * ends[-1])]
    middles = 0.5 * (cuts[:-1] + cuts[1:])
    pieces = [
        (float(b - a), *section_at(shaft, float(m))) for a, b, m in zip(cuts, cuts[1:], middles, strict=False)
    ]
    found = _solid(name, "shaft", bodies[name], shaft_solid(pieces, ROUND))
    if len(places) < 2:
        return found
    stations = station_names(name, len(places))
    height = np.clip(found.points[:, 2], places[0], places[-1])
    first = np.clip(np.searchsorted(places, height, side="right") - 1, 0, len(places) - 2)
    weight = (height - places[first]) / (places[first + 1] - places[first])
    points = found.points - np.array([0.0, 0.0, places[0]])
    return SceneSolid(
        name=name,
        kind="shaft",
        body=bodies[name],
        points=points,
        triangles=found.triangles,
        skin=Skin([bodies[s] for s in stations], first, first + 1, weight),
    )


def _spindle(model: Model, name: str, bodies: dict[str, int]) -> list[SceneSolid]:
    """Something round that joins the gears of a body without sections."""
    part = model.bodies[name]
    gears = {g: model.gears[g] for g in part.gears}
    outer = [g for g in gears.values() if g.type != "internal"]
    if not outer:
        return []
    bores = [g.bore_diameter for g in outer if g.bore_diameter > 0.0]
    radius = 0.5 * min(bores) if bores else SPINDLE * min(0.5 * g.geometry.d_f for g in outer)
    reach = [(z - 0.5 * gears[g].geometry.b, z + 0.5 * gears[g].geometry.b) for g, z in part.gears.items()]
    ends = [z for pair in reach for z in pair]
    ends += [m.position[2] for m in part.markers.values() if _on_axis(m.position)]
    ends += [b.position[2] for b in model.bearings.values() if b.body == name]
    low, high = min(ends), max(ends)
    over = 0.15 * (high - low)
    corners = shaft_solid([(high - low + 2.0 * over, 2.0 * radius, 0.0)], ROUND)
    return [_solid(f"{name} (spindle)", "shaft", bodies[name], corners + np.array([0.0, 0.0, low - over]))]


def _on_axis(place: Iterable[float]) -> bool:
    x, y, _ = place
    return x == 0.0 and y == 0.0


def _rolling_bearing(model: Model, name: str, bodies: dict[str, int]) -> list[SceneSolid]:
    """Both rings of a rolling bearing, each on the body of its end."""
    part = model.rolling_bearings[name]
    d, pitch = part.element_diameter, part.pitch_diameter
    width, rib = 1.4 * d, 0.5 * d
    inner = (width, pitch - 1.1 * d, pitch - 1.1 * d - rib)
    outer = (width, pitch + 1.1 * d + rib, pitch + 1.1 * d)
    middle = np.array([0.0, 0.0, -0.5 * width])
    found = []
    for end, ring, word in zip(part.ends, (inner, outer), ("inner", "outer"), strict=True):
        body, place, axes = _seat_of_end(model, end)
        if body in bodies or body == GROUND:
            corners = (shaft_solid([ring], ROUND) + middle) @ axes.T + place
            found.append(_solid(f"{name}, {word} ring", "bearing", bodies.get(body, -1), corners))
    return found


def _seat_of_end(model: Model, end: str) -> tuple[str, Array, Array]:
    """Body, a station of a shaft where there is one, with place [m] and axes of an end in it."""
    body, _ = split(end)
    marker = marker_of(model, end)
    place = np.zeros(3) if marker is None else np.array(marker.position, float)
    axes = np.eye(3) if marker is None else frame(marker.axes)
    places = model.stations.get(body)
    if places is None:
        return body, place, axes
    k = nearest_station(places, float(place[2]))
    return station_names(body, len(places))[k], place - np.array([0.0, 0.0, places[k]]), axes


def _from_file(model: Model, name: str, bodies: dict[str, int]) -> SceneSolid:
    """The surface of a file, in the axes of its body."""
    reference = model.bodies[name].solid
    assert reference is not None
    corners = placed_triangles(read_triangles(reference.file), reference.unit or 1.0)
    corners = (corners - np.array(reference.origin or (0.0, 0.0, 0.0))) @ frame(reference.axes)
    return _solid(name, "body", bodies[name], corners, creases=20.0)
