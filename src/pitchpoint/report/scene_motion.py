# SPDX-License-Identifier: Apache-2.0
"""Where all bodies of a result are at chosen times: coordinates from its channels, frames from the system."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.system import evaluate
from pitchpoint.system.system import System
from pitchpoint.viz.scene import SceneBody

Array = NDArray[np.float64]
TWO_PI = 2.0 * math.pi
TURNING = 0.5
"""Travel [rad] from which on a body counts as turning."""
STILL = 1e-12
"""Displacement [m, rad] below which a track is left out."""


@dataclass(frozen=True)
class Motion:
    """Frames of all bodies, ground first, and directions of all meshes, over n times.

    Attributes
    ----------
    place, axes
        World positions of the origins, shape (n, nb, 3) [m], and frames that do not spin, (n, nb, 3, 3).
    angle
        Angle about the third axis, whole turns included, without those of parents, shape (n, nb) [rad].
    pitch_points, directions
        World positions of the pitch points, shape (n, nm, 3) [m], and directions tangential, radial and
        axial of the forces on gear 2, shape (n, nm, 3, 3), rows.
    unknown
        Coordinates that the result does not hold.
    observed
        All observations of the bodies in these places, at rest, shape (n, no): forces without damping.
    """

    place: Array
    axes: Array
    angle: Array
    pitch_points: Array
    directions: Array
    unknown: tuple[str, ...]
    observed: Array

    def spinning(self, b: int) -> Array:
        """Axes that are fixed to a body, shape (n, 3, 3)."""
        c, s = np.cos(self.angle[:, b]), np.sin(self.angle[:, b])
        turned = self.axes[:, b].copy()
        turned[:, :, 0] = c[:, None] * self.axes[:, b, :, 0] + s[:, None] * self.axes[:, b, :, 1]
        turned[:, :, 1] = c[:, None] * self.axes[:, b, :, 1] - s[:, None] * self.axes[:, b, :, 0]
        return turned


def motion(
    system: System,
    n: int,
    read: Callable[[str], Array | None],
    times: Array,
    look: Callable[[int], None] | None = None,
) -> Motion:
    """Frames at n times.

    Parameters
    ----------
    system
        The machine.
    n
        Number of times.
    read
        Gives a channel of the result at these times, shape (n,), or None where it has none.
    times
        The times [s], shape (n,).
    look
        Called with the number of each time when the system stands there.
    """
    layout, body = system.layout, system.program["body"]
    q = np.tile(system.initial_state().q * 0.0, (n, 1))
    angle = np.zeros((n, len(layout.bodies)))
    unknown = []
    words = {"alpha": "rx", "beta": "ry"}
    for b, one in enumerate(system.bodies, start=1):
        if one.state:
            continue
        for k, (coordinate, _) in enumerate(one.coordinates):
            name, dof = layout.bodies[b], int(body[b]["dof"]) + k
            spin = coordinate == "spin"
            word = words.get(coordinate, coordinate)
            channel = f"angle[{name}]" if spin else f"displacement[{name}.{word}]"
            values = read(channel)
            if values is None:
                unknown.append(f"{name}.{coordinate}")
                continue
            q[:, dof] = values
            if spin:
                angle[:, b] = values
    meshes = system.records.get("gear_mesh")
    count = 0 if meshes is None else len(meshes)
    found = Motion(
        np.zeros((n, len(layout.bodies), 3)),
        np.zeros((n, len(layout.bodies), 3, 3)),
        angle,
        np.zeros((n, count, 3)),
        np.zeros((n, count, 3, 3)),
        tuple(unknown),
        np.zeros((n, system.sizes["no"])),
    )
    state = system.initial_state()
    spins = body["spin"]
    spinning = np.flatnonzero(spins >= 0)
    for i in range(n):
        state.t = float(times[i])
        state.q[:] = q[i]
        state.turns[spinning] = np.rint(q[i, spins[spinning]] / TWO_PI)
        state.q[spins[spinning]] -= TWO_PI * state.turns[spinning]
        found.observed[i] = evaluate.observe(system, state)
        frames = system.workspace.fr
        found.place[i], found.axes[i] = frames["r"], frames["R"]
        if meshes is not None:
            found.pitch_points[i] = meshes["P"]
            for row, field in enumerate("tem"):
                found.directions[i, :, row] = meshes[field]
        if look is not None:
            look(i)
    return found


def scene_bodies(system: System, moved: Motion, rest: Motion) -> list[SceneBody]:
    """Bodies of a scene, ground left out; those that hang on a body that turns move in its frame.

    Parameters
    ----------
    system
        The machine.
    moved, rest
        Its motion over the frames of the scene, and at rest, one frame.
    """
    names, parents = system.layout.bodies, system.program["body"]["parent"]
    from scipy.spatial.transform import Rotation

    guide = _guide(moved.angle)
    found: list[SceneBody] = []
    for b in range(1, len(names)):
        parent = int(parents[b])
        place, axes = _in_parent(moved, b, parent)
        place0, axes0 = (x[0] for x in _in_parent(rest, b, parent))
        position = (place - place0) @ axes0
        turn = Rotation.from_matrix(axes0.T @ axes).as_rotvec()
        gross, ratio = _gross(moved.angle, b, guide)
        found.append(
            SceneBody(
                name=names[b],
                parent=parent - 1,
                place=place0,
                axes=axes0,
                position=position if np.abs(position).max() > STILL else None,
                turn=turn if np.abs(turn).max() > STILL else None,
                angle=moved.angle[:, b] if np.any(moved.angle[:, b]) else None,
                gross=gross,
                ratio=ratio,
            )
        )
    return found


def _in_parent(moved: Motion, b: int, parent: int) -> tuple[Array, Array]:
    """Places (n, 3) and axes (n, 3, 3) of a body in the spinning frame of its parent."""
    if parent == 0:
        return moved.place[:, b], moved.axes[:, b]
    inverse = np.swapaxes(moved.spinning(parent), 1, 2)
    place = np.einsum("nij,nj->ni", inverse, moved.place[:, b] - moved.place[:, parent])
    return place, inverse @ moved.axes[:, b]


def _guide(angle: Array) -> int:
    """Body that turns most, whose angle guides those of the others; -1 if none turns."""
    travel = np.abs(angle[-1] - angle[0])
    b = int(np.argmax(travel))
    return b if travel[b] > TURNING else -1


def _gross(angle: Array, b: int, guide: int) -> tuple[Array | None, float]:
    """Angle that kinematics ask for, as that of the guide and a ratio: the best fit over all frames."""
    if guide < 0 or abs(angle[-1, b] - angle[0, b]) < TURNING:
        return None, 1.0
    x = angle[:, guide] - angle[:, guide].mean()
    return angle[:, guide], float(x @ angle[:, b] / (x @ x))
