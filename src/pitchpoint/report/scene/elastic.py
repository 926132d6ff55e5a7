# SPDX-License-Identifier: Apache-2.0
"""Deformable solids of a scene: beams between bodies, and elastic bodies as bars between their nodes."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import PitchpointError
from pitchpoint.model.frames import place_of, split, unit
from pitchpoint.model.shafts import station_names
from pitchpoint.report.scene.blades import blade_rings, rigid_blades
from pitchpoint.report.scene.shapes import skin
from pitchpoint.viz.scene.content import Blend, ModalShape, SceneSolid

if TYPE_CHECKING:
    from pitchpoint.model.components.beam import Beam
    from pitchpoint.model.model import Model
    from pitchpoint.report.scene.places import Places

Array = NDArray[np.float64]
Read = Callable[[str], "Array | None"]
"""Function that returns a channel of a result at the frames, None if not available."""

RINGS = 4
"""Number of rings of corners along every segment of a beam."""
MAX_NODES = 300
SLENDER = 0.015
"""Radius of beams of unknown section, relative to their length."""
BAR = 0.008
"""Half width of the bars between nodes, relative to the size of the machine."""


def elastic_parts(model: Model, at: Places, read: Read) -> tuple[list[SceneSolid], list[str]]:
    """Solids of beams and elastic bodies, and remarks on omitted ones.

    Parameters
    ----------
    model
        The model.
    at
        Where things sit in the scene.
    read
        Function that returns channels of the result at the frames.
    """
    blades = blade_rings(model)
    found = [_beam(model, name, part, at, blades.get(name)) for name, part in model.beams.items()]
    found += rigid_blades(model, at)
    notes: list[str] = []
    for name in model.elastic_bodies:
        try:
            found.append(_nodes(model, name, at, read))
        except PitchpointError as error:
            notes.append(f"elastic body {name} is not drawn: {error}")
    if model.elastic_bodies:
        notes.append("elastic bodies are drawn as bars between their nodes: matrices have no surface")
    return found, notes


def _beam(model: Model, name: str, part: Beam, at: Places, blade: Array | None = None) -> SceneSolid:
    """Beam with its cross section, or with the sections of a blade, which follows its ends and stations."""
    root, tip = (place_of(model, end) for end in part.ends)
    assert root is not None and tip is not None
    z = unit(tip - root)
    wish = np.array(part.axis or ((0.0, 1.0, 0.0) if abs(z[0]) > 0.999 else (1.0, 0.0, 0.0)))
    x = unit(wish - z * (z @ wish))
    y = np.cross(z, x)
    outline = _section(part, float(np.linalg.norm(tip - root)))
    count = RINGS * part.pieces + 1
    share = np.linspace(0.0, 1.0, count)
    ring = outline[:, :1] * x + outline[:, 1:] * y
    wide = np.ones(count)
    if part.diameters:
        known = 0.5 * np.array(part.diameters)
        wide = np.interp(share, np.linspace(0.0, 1.0, len(known)), known) / np.linalg.norm(outline[0])
    points = (root + share[:, None] * (tip - root))[:, None, :] + wide[:, None, None] * ring
    n = len(outline)
    if blade is not None:
        points, n, count = blade, blade.shape[1], len(blade)
        share = np.clip((blade.mean(axis=1) - root) @ z / float(np.linalg.norm(tip - root)), 0.0, 1.0)
    stations = [at.names.get(label) for label in station_names(name, part.pieces)[1:]]
    between = [number for number in stations if number is not None]
    # a scene at rest has no stations of beams
    pieces = len(between) + 1 if len(between) == len(stations) else 1
    first = np.minimum((share * pieces + 1e-9).astype(np.int64), pieces - 1)
    weight = share * pieces - first
    bodies = [at.seat(split(part.ends[0])[0], root)[0], *between[: pieces - 1]]
    bodies.append(at.seat(split(part.ends[1])[0], tip)[0])
    _, origin, axes = at.seat(split(part.ends[0])[0], root)
    return SceneSolid(
        name=name,
        kind="shaft",
        body=bodies[0],
        points=(points.reshape(-1, 3) - origin) @ axes,
        triangles=skin(count, n),
        blend=Blend(bodies, np.repeat(first, n), np.repeat(first + 1, n), np.repeat(weight, n)),
    )


def _section(part: Beam, length: float) -> Array:
    """Corners of the cross section of a beam along its axes 1 and 2, (n, 2) [m]; a circle if unknown."""
    section = part.section
    if section is None:  # properties without a shape
        radius = SLENDER * length
    elif section.width is not None and section.height is not None:
        w, h = 0.5 * section.width, 0.5 * section.height
        return np.array([[w, -h], [w, h], [-w, h], [-w, -h]])
    else:
        radius = 0.5 * section.diameter if section.diameter else math.sqrt((section.area or 0.0) / math.pi)
    angle = 2.0 * math.pi / 20 * np.arange(20)
    return radius * np.column_stack([np.cos(angle), np.sin(angle)])


def _nodes(model: Model, name: str, at: Places, read: Read) -> SceneSolid:
    """Bars between neighbouring nodes, which follow the modal coordinates."""
    from pitchpoint.system.rules.elastic_body import file_nodes

    places, shape = file_nodes(model, name)
    kept = np.arange(0, len(places), -(-len(places) // MAX_NODES))
    places, shape = places[kept], shape[kept]
    half = BAR * at.size
    points: list[Array] = []
    node: list[int] = []
    faces: list[NDArray[np.int64]] = []
    corner = half * np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])
    k, after = np.arange(4), (np.arange(4) + 1) % 4
    for i, j in neighbours(places):
        if np.linalg.norm(places[j] - places[i]) < 1e-6 * at.size:
            continue  # coincident nodes
        z = unit(places[j] - places[i])
        x = unit(np.cross(np.eye(3)[int(np.argmin(np.abs(z)))], z))
        ring = corner[:, :1] * x + corner[:, 1:] * np.cross(z, x)
        first = 4 * len(points)
        points += [places[i] + ring, places[j] + ring]
        node += [i] * 4 + [j] * 4
        faces += [
            np.c_[first + k, first + after, first + 4 + k],
            np.c_[first + after, first + 4 + after, first + 4 + k],
        ]
        faces.append(first + np.array([[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7]]))
    number = at.seat(name)[0]
    values = [read(f"displacement[{c}]") for c in coordinates_of(name, shape.shape[2])]
    known = [v for v in values if v is not None]
    return SceneSolid(
        name=name,
        kind="body",
        body=number,
        points=np.concatenate(points),
        triangles=np.concatenate(faces),
        modal=ModalShape(
            np.moveaxis(shape, 2, 0),
            np.array(node, np.int64),
            np.column_stack(known) if len(known) == len(values) else None,
            tuple(coordinates_of(name, shape.shape[2])),
        ),
        schematic=True,
    )


def neighbours(places: Array) -> NDArray[np.int64]:
    """Pairs of points of which no third one is nearer to both, shape (pairs, 2).

    The pairs connect all points (G. T. Toussaint, Pattern Recognition 12 (1980) 261-268).

    Examples
    --------
    The corners of a square, without its diagonals:

    >>> neighbours(np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])).tolist()
    [[0, 1], [0, 3], [1, 2], [2, 3]]
    """
    from scipy.spatial.distance import cdist

    apart = cdist(places, places)
    nearer = np.array([np.maximum(row, apart).min(axis=1) for row in apart])
    return np.argwhere(np.triu(nearer >= (1.0 - 1e-6) * apart, 1))


def coordinates_of(name: str, count: int) -> list[str]:
    """Names of the modal coordinates of an elastic body.

    Examples
    --------
    >>> coordinates_of("rod", 4)[2:]
    ['rod.1.eta3', 'rod.2.eta4']
    """
    return [f"{name}.{m // 3 + 1}.eta{m + 1}" for m in range(count)]
