# SPDX-License-Identifier: Apache-2.0
"""Extent of the bodies of a scene, which determines the required precision of angles."""

from __future__ import annotations

import numpy as np

from pitchpoint.viz.scene.content import Array, Scene, SceneSolid


def reaches(scene: Scene) -> list[float]:
    """Maximum distance of solids from the origin of each body, including its children [m].

    Parameters
    ----------
    scene
        Scene; a body follows its parent.
    """
    found = [0.0] * len(scene.bodies)
    for solid in scene.solids:
        for b, far in _ends(solid):
            if b >= 0:
                found[b] = max(found[b], far)
    for k in reversed(range(len(found))):
        parent = scene.bodies[k].parent
        if parent >= 0:
            found[parent] = max(found[parent], found[k] + float(np.linalg.norm(scene.bodies[k].place)))
    return found


def _ends(solid: SceneSolid) -> list[tuple[int, float]]:
    """Bodies that move a solid, and its distance from their origins."""
    between = solid.between
    if between is not None:
        return [(b, float(np.linalg.norm(end))) for b, end in zip(between.bodies, between.ends, strict=True)]
    far = max((_size(piece.levels[-1].points) for piece in solid.pieces), default=0.0)
    if solid.points is not None:
        far = _size(solid.points)
    if solid.place is not None:
        far += float(np.linalg.norm(solid.place))
    return [(b, far) for b in (solid.blend.bodies if solid.blend else [solid.body])]


def _size(points: Array) -> float:
    return float(np.linalg.norm(points, axis=1).max(initial=0.0))
