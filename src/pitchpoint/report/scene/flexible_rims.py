# SPDX-License-Identifier: Apache-2.0
"""Gears with flexible rims in a scene: whole teeth and rim, which follow the ring modes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.multibody.rim import terms_at
from pitchpoint.system.rules.flexible_rim import coordinates_of_rim, rim_of, terms_of_rim
from pitchpoint.viz.scene.content import ModalShape, SceneSolid

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]
Read = Callable[[str], "Array | None"]
"""Function that returns a channel of a result at the frames, None if not available."""

LEVEL = 1
"""Level of detail of the teeth, from coarse."""
PER_TOOTH = 4
"""Angles of a pitch at which the deflection is evaluated."""
HEIGHTS = 4
"""Radii between tip and outside at which it is evaluated."""


def with_rims(model: Model, solids: Sequence[SceneSolid], read: Read) -> list[SceneSolid]:
    """Solids of a scene, those of gears with flexible rims deformable.

    Parameters
    ----------
    model
        The model.
    solids
        Solids of the scene.
    read
        Function that returns channels of the result at the frames.
    """
    found = []
    for solid in solids:
        gear = model.gears.get(solid.name) if solid.kind == "gear" else None
        bends = gear is not None and gear.flexible_rim is not None and model.body_of(solid.name) is not None
        found.append(_bent(model, solid, read) if bends else solid)
    return found


def _bent(model: Model, solid: SceneSolid, read: Read) -> SceneSolid:
    """Gear as one surface with its ring modes."""
    gear = model.gears[solid.name]
    points, triangles = _whole(solid)
    axes = np.eye(3) if solid.axes is None else solid.axes
    x, y, _ = axes @ points.T
    count = PER_TOOTH * gear.number_of_teeth
    sector = np.round(np.arctan2(y, x) / math.tau * count).astype(np.int64) % count
    radius = np.hypot(x, y)
    low, high = float(radius.min()), float(radius.max())
    height = np.round((radius - low) / (high - low) * (HEIGHTS - 1)).astype(np.int64)
    theta = math.tau * np.arange(count) / count
    shapes = [_displacement(model, solid.name, theta, r) for r in np.linspace(low, high, HEIGHTS)]
    names = coordinates_of_rim(model, solid.name)
    values = [read(f"displacement[{c}]") for c in names]
    known = [v for v in values if v is not None]
    return replace(
        solid,
        pieces=(),
        points=points,
        triangles=triangles,
        modal=ModalShape(
            np.concatenate(shapes, axis=1) @ axes,
            height * count + sector,
            np.column_stack(known) if len(known) == len(values) else None,
            tuple(names),
        ),
    )


def _whole(solid: SceneSolid) -> tuple[Array, NDArray[np.int64]]:
    """Points and triangles of all teeth."""
    points: list[Array] = []
    triangles: list[NDArray[np.int64]] = []
    start = 0
    for piece in solid.pieces:
        level = piece.levels[min(LEVEL, len(piece.levels) - 1)]
        for turn in piece.turns:
            c, s = math.cos(turn), math.sin(turn)
            points.append(level.points @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]))
            triangles.append(np.asarray(level.triangles, np.int64) + start)
            start += len(level.points)
    return np.concatenate(points), np.concatenate(triangles)


def _displacement(model: Model, name: str, theta: Array, radius: float) -> Array:
    """Displacement per coordinate at a radius, body axes, shape (coordinates, angles, 3)."""
    gear = model.gears[name]
    found = np.zeros((len(rim_of(gear).words), theta.size, 3))
    out = np.column_stack([np.cos(theta), np.sin(theta), 0.0 * theta])
    along = np.column_stack([-np.sin(theta), np.cos(theta), 0.0 * theta])
    for k, n, component, of_cosine, of_sine in terms_at(
        terms_of_rim(model, str(model.body_of(name)), name), radius
    ):
        value = of_cosine * np.cos(n * theta) + of_sine * np.sin(n * theta)
        found[int(k)] += value[:, None] * (out if component == 0 else along)
    return found
