# SPDX-License-Identifier: Apache-2.0
"""Scene of a model at rest from its file alone, without compilation."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.frames import marker_of, place_of, split
from pitchpoint.model.mechanism import seat_frame
from pitchpoint.report.scene.elastic import elastic_parts
from pitchpoint.report.scene.places import Places
from pitchpoint.report.scene.solids import scene_solids
from pitchpoint.viz.scene.content import Scene, SceneBody

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]


def rest_scene(model: Model) -> Scene:
    """Bodies at their positions in the model file, all coordinates zero, in the order of the system.

    Parameters
    ----------
    model
        The model.

    Examples
    --------
    >>> import pitchpoint as pp
    >>> [body.name for body in rest_scene(pp.load_model("pair.yaml")).bodies]  # doctest: +SKIP
    ['input', 'output']
    """
    from pitchpoint.system.rules.bodies import bodies

    found = []
    known = bodies(model)
    for body in known.values():
        place, axes = frame_at_rest(model, body.name)
        found.append(SceneBody(name=body.name, place=place, axes=axes))
    numbers = {number: k for k, number in enumerate(known)}
    places = Places(model, numbers, {body.name: k for k, body in enumerate(found)})
    solids, notes = scene_solids(model, places)
    bending, remarks = elastic_parts(model, places, lambda _: None)
    return Scene(
        title=model.title or "Gears",
        subtitle="at rest",
        bodies=found,
        solids=solids + bending,
        notes=notes + remarks,
    )


def frame_at_rest(model: Model, name: str) -> tuple[Array, Array]:
    """Origin [m] and axes of a body of the system in the world, with all coordinates zero.

    Parameters
    ----------
    model
        The model.
    name
        A body, a station of a shaft, or a node of an elastic body; others are at the origin.
    """
    seats = model.mechanism.seats
    owner, rest = split(name)
    if owner not in seats:
        return np.zeros(3), np.eye(3)
    place, axes = seat_frame(model, seats[owner])
    if owner in model.stations:
        places = model.stations[owner]
        return place + places[int(rest) - 1 if rest else 0] * axes[:, 2], axes
    if rest and marker_of(model, name) is not None:
        node = place_of(model, name)
        place = place if node is None else node
    return place, axes
