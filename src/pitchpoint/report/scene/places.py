# SPDX-License-Identifier: Apache-2.0
"""Positions of components in the scene: scene bodies, positions and axes in moving frames."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.model.frames import GROUND, axes_of, body_frame, joint_place, place_of, split
from pitchpoint.report.scene.shapes import Surface
from pitchpoint.system.rules.bodies import frame_at
from pitchpoint.viz.scene.content import SceneSolid

if TYPE_CHECKING:
    from pitchpoint.model.components.joint import Joint
    from pitchpoint.model.model import Model
    from pitchpoint.model.rings import Ring

Array = NDArray[np.float64]


FAR = 4.0
"""Size of a machine over that of its gear train, above which symbols have the size of the train: they would
hide the gears of a wind turbine."""


class Places:
    """Frames of all bodies at their positions in the model file, and the size of the machine.

    Parameters
    ----------
    model
        The model.
    numbers
        Indices of the bodies in the scene by those in the records, without ground.
    names
        Indices of the bodies in the scene by name.
    """

    def __init__(self, model: Model, numbers: Mapping[int, int], names: Mapping[str, int]) -> None:
        self.model, self.numbers, self.names = model, numbers, names
        self.cages: dict[str, tuple[int, tuple[int, Array, Array]]] = {}
        """Scene bodies of the cages of bearings, each with its parent, and origin [m] and axes there."""
        self._joints: dict[str, list[Joint]] = {}
        for joint in model.joints.values():
            for body in {split(end)[0] for end in joint.bodies}:
                self._joints.setdefault(body, []).append(joint)
        points = [p for name in model.bodies for p in (self.origin(name), *self.anchors(name))]
        reach = float(np.linalg.norm(np.ptp(np.array(points), axis=0))) if points else 0.0
        gears = [abs(g.geometry.d_a) for g in model.gears.values()]
        gears += [2.0 * g.geometry.R_e for g in model.bevel_gears.values()]
        shafts = [s.length for s in model.shafts.values()]
        self.size = max(reach, *gears, *shafts, 0.0) or 0.2
        carriers = [
            self.origin(name) for name, body in model.bodies.items() if body.gears or body.bevel_gears
        ]
        if carriers:
            train = float(np.linalg.norm(np.ptp(np.array(carriers), axis=0))) + max(gears)
            self.size = train if self.size > FAR * train else self.size
        elif shaped := _shape_sizes(model):
            train = max(shaped)
            self.size = train if self.size > FAR * train else self.size

    def origin(self, body: str) -> Array:
        """Origin of a body in world coordinates [m]."""
        found = body_frame(self.model, body)[0]
        return np.zeros(3) if found is None else found

    def anchors(self, body: str) -> list[Array]:
        """Connection points of a body in world coordinates [m]."""
        model = self.model
        found = [place_of(model, f"{body}.{m}") for m in model.bodies[body].markers]
        joints = [joint for joint in self._joints.get(body, ()) if joint.type != "free"]
        return [p for p in (*found, *(joint_place(model, j) for j in joints)) if p is not None]

    def seat(self, body: str, place: ArrayLike | None = None) -> tuple[int, Array, Array]:
        """Scene body that a body moves with, -1 for ground, and its rest frame in the world.

        Parameters
        ----------
        body
            Name of the body, or ground.
        place
            Position on it in world coordinates [m]: selects the nearest station of a shaft or node of an
            elastic body.
        """
        where = None if place is None else np.asarray(place, float)
        number, origin, axes = frame_at(self.model, body, where)
        if number not in self.numbers:  # ground, and stations of beams in a scene at rest
            return -1, np.zeros(3), np.eye(3)
        return self.numbers[number], origin, axes

    def world(self, body: str, place: ArrayLike = (0.0, 0.0, 0.0)) -> tuple[Array, Array]:
        """Point of a body in world coordinates [m], and the axes of the body there; world axes for ground.

        Parameters
        ----------
        body
            Name of the body, or ground.
        place
            From the origin of the body along its axes [m].
        """
        axes = np.eye(3) if body == GROUND else body_frame(self.model, body)[1]
        origin = np.zeros(3) if body == GROUND else self.origin(body)
        return origin + axes @ np.asarray(place, float), axes

    def at_world(self, body: str, point: Array, axes: Array) -> tuple[int, Array, Array]:
        """Scene body, and in its frame a point [m] and axes given in world coordinates."""
        number, origin, frame = self.seat(body, point)
        return number, frame.T @ (point - origin), frame.T @ axes

    def own(self, body: str, place: ArrayLike = (0.0, 0.0, 0.0)) -> tuple[int, Array, Array]:
        """Scene body, and in its frame a point of a body [m] and the axes of that body.

        Parameters
        ----------
        body
            Name of the body, or ground.
        place
            From the origin of the body along its axes [m].
        """
        return self.at_world(body, *self.world(body, place))

    def ring(self, ring: Ring) -> tuple[int, Array, Array]:
        """Scene body of a bearing ring, and in its frame the centre [m] and the axes of the ring."""
        return self.at_world(ring.body, np.zeros(3) if ring.place is None else ring.place, ring.axes)

    def end(self, end: str) -> tuple[int, Array, Array]:
        """The same for ground, BODY or BODY.MARKER, with the axes of the marker."""
        body = split(end)[0]
        place = place_of(self.model, end)
        point = np.zeros(3) if place is None else place
        return self.at_world(body, point, axes_of(self.model, end))


def _shape_sizes(model: Model) -> list[float]:
    """Largest sizes of the boxes and bodies of revolution of all bodies [m]."""
    shapes = [shape for body in model.bodies.values() for shape in body.shapes.values()]
    return [max(s.box or (*s.diameters, s.heights[-1] - s.heights[0])) for s in shapes]


def placed_solid(
    name: str, kind: str, seat: tuple[int, Array, Array], surface: Surface, *, schematic: bool = True
) -> SceneSolid:
    """Rigid surface at a point of a body.

    Parameters
    ----------
    name, kind
        Name and kind of the solid.
    seat
        Scene body, origin [m] and axes of the surface in its frame.
    surface
        Points and triangles.
    schematic
        Whether it is a symbol for a component of unknown shape.
    """
    body, place, axes = seat
    points, triangles = surface
    return SceneSolid(
        name=name,
        kind=kind,
        body=body,
        points=points,
        triangles=triangles,
        place=place,
        axes=axes,
        schematic=schematic,
    )
