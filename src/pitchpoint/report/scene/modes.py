# SPDX-License-Identifier: Apache-2.0
"""Mode shapes of a scene."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import PitchpointError
from pitchpoint.viz.scene.content import SceneBody, SceneMode, SceneSolid

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.system.system import System

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


def scene_modes(
    system: System, count: int, bodies: Sequence[str], solids: Sequence[SceneSolid]
) -> list[SceneMode]:
    """Lowest modes of a system about its loaded state.

    Parameters
    ----------
    system
        System, compiled with a scenario or at rest.
    count
        Number of modes.
    bodies
        Names of the bodies of the scene.
    solids
        Solids of the scene; those with modal coordinates get their modal amplitudes.
    """
    from pitchpoint.solvers.modal import find_modes

    found = find_modes(system, count=count)
    return [
        _mode(
            f"{k + 1}: {found.names[k]}",
            (float(found.frequency[k]), float(found.damping_ratio[k])),
            (found.bodies, found.damped_body_shape[k]),
            (found.coordinates, found.damped_shape[k]),
            bodies,
            solids,
        )
        for k in range(min(count, len(found.names)))
    ]


def modes_of_result(
    result: xr.Dataset, bodies: Sequence[str], solids: Sequence[SceneSolid]
) -> list[SceneMode]:
    """Modes of a result of `pitchpoint modes`, with undamped shapes.

    Parameters
    ----------
    result
        The result.
    bodies, solids
        As in `scene_modes`.

    Raises
    ------
    PitchpointError
        If it does not contain the motion of the bodies.
    """
    if "body_shape" not in result or "undamped_frequency" not in result:
        raise PitchpointError("this result of modes is of an older version; recompute it")
    names = [str(name) for name in result["body"].values]
    coordinates = [str(name) for name in result["coordinate"].values]
    return [
        _mode(
            f"{k + 1}: {result['name'].values[k]}",
            (float(result["undamped_frequency"][k]), float(result["damping_ratio"][k])),
            (names, np.asarray(result["body_shape"].values[k], dtype=complex)),
            (coordinates, np.asarray(result["shape"].values[k], dtype=complex)),
            bodies,
            solids,
        )
        for k in range(result.sizes["mode"])
    ]


def with_parts(mode: SceneMode, bodies: Sequence[SceneBody]) -> SceneMode:
    """Mode of a scene with parts of components, which come after the bodies of the model and follow these.

    Parameters
    ----------
    mode
        Mode of the bodies of the model.
    bodies
        All bodies of the scene.
    """
    position, turn = list(mode.position), list(mode.turn)
    for body in bodies[len(position) :]:
        arm, parent = np.asarray(body.place, float), body.parent
        known = parent >= 0
        position.append(position[parent].copy() if known else np.zeros(3, complex))
        turn.append(turn[parent].copy() if known else np.zeros(3, complex))
        if known:
            position[-1] += np.cross(turn[-1], rest_axes(bodies, parent) @ arm)
    return replace(mode, position=np.array(position).reshape(-1, 3), turn=np.array(turn).reshape(-1, 3))


def rest_axes(bodies: Sequence[SceneBody], number: int) -> Array:
    """Axes of a scene body at rest in the world, shape (3, 3); world axes for -1."""
    if number < 0:
        return np.eye(3)
    return rest_axes(bodies, bodies[number].parent) @ bodies[number].axes


def _mode(
    name: str,
    numbers: tuple[float, float],
    motions: tuple[Sequence[str], Complex],
    coordinates: tuple[Sequence[str], Complex],
    bodies: Sequence[str],
    solids: Sequence[SceneSolid],
) -> SceneMode:
    """Mode with the bodies in the order of the scene."""
    frequency, damping = numbers
    at = {body: k for k, body in enumerate(motions[0])}
    moved = np.array([motions[1][at[body]] for body in bodies]).reshape(-1, 6)
    place = {coordinate: k for k, coordinate in enumerate(coordinates[0])}
    modal = {}
    for solid in solids:
        if solid.modal is None:
            continue
        own = solid.modal.names
        if all(c in place for c in own):
            modal[solid.name] = coordinates[1][[place[c] for c in own]]
    shown = damping if math.isfinite(damping) and frequency > 0.0 else None
    return SceneMode(
        name=name, frequency=frequency, damping=shown, position=moved[:, :3], turn=moved[:, 3:], modal=modal
    )
