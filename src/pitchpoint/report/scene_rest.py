# SPDX-License-Identifier: Apache-2.0
"""The scene of a model at rest from its file alone: nothing is compiled, so it is there at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.frames import body_frame
from pitchpoint.model.shafts import station_names
from pitchpoint.report.scene_elastic import elastic_parts
from pitchpoint.report.scene_places import Places
from pitchpoint.report.scene_solids import scene_solids
from pitchpoint.system.rules.bodies import body_numbers
from pitchpoint.viz.scene import Scene, SceneBody

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]


def rest_scene(model: Model) -> Scene:
    """Every body where the file places it, all coordinates zero; shafts as rows of stations.

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
    bodies: list[SceneBody] = []
    numbers: dict[int, int] = {}
    records = body_numbers(model)
    for name in model.bodies:
        origin, axes = body_frame(model, name)
        place = np.zeros(3) if origin is None else origin
        heights = model.stations.get(name, (0.0,))
        for k, (station, height) in enumerate(
            zip(station_names(name, len(heights)), heights, strict=True)
        ):
            numbers[records[name] + k] = len(bodies)
            bodies.append(SceneBody(name=station, place=place + height * axes[:, 2], axes=axes))
    places = Places(model, numbers, {body.name: k for k, body in enumerate(bodies)})
    solids, notes = scene_solids(model, places)
    bending, said = elastic_parts(model, places, lambda _: None)
    return Scene(
        title=model.title or "Gears",
        subtitle="at rest",
        bodies=bodies,
        solids=solids + bending,
        times=np.zeros(1),
        notes=notes + said,
    )
