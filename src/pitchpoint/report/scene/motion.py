# SPDX-License-Identifier: Apache-2.0
"""Motion of all bodies of a result at given times: coordinates from its channels, frames from the system."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.progress import report_step
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import force_directions, mesh_records
from pitchpoint.system.system import System
from pitchpoint.viz.scene.content import SceneBody

Array = NDArray[np.float64]
TWO_PI = 2.0 * math.pi
TURNING = 0.5
"""Rotation [rad] above which a body counts as rotating."""
STILL = 1e-12
"""Displacement [m, rad] below which a track is omitted."""
SWING = 0.05
"""Rotation [rad] about one axis above which it counts as motion instead of vibration."""
TUMBLE = 0.3
"""The same for rotations about several axes, beyond the validity of small rotation vectors."""
STRIDE = 50
"""Number of times between progress reports."""
WAY = 0.01
"""Displacement above which it counts as motion, relative to the size of the machine."""


@dataclass(frozen=True)
class Motion:
    """Frames of all bodies, ground first, and directions of all meshes, over n times.

    Attributes
    ----------
    place, axes
        World positions of the origins, shape (n, nb, 3) [m], and frames that do not spin, (n, nb, 3, 3).
    angle
        Angle about the third axis, including whole turns, relative to the parent, shape (n, nb) [rad].
    pitch_points, directions
        World positions of the pitch points, shape (n, nm, 3) [m], and directions tangential, radial and
        axial of the forces on gear 2, shape (n, nm, 3, 3), rows.
    unknown
        Coordinates that are not in the result.
    observed
        All observations in these positions at rest, shape (n, no): forces without damping.
    """

    place: Array
    axes: Array
    angle: Array
    pitch_points: Array
    directions: Array
    unknown: tuple[str, ...]
    observed: Array

    def spinning(self, b: int) -> Array:
        """Body-fixed axes, shape (n, 3, 3)."""
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
        Function that returns a channel of the result at these times, shape (n,), or None.
    times
        The times [s], shape (n,).
    look
        Called with the index of each time when the system is in this state.
    """
    layout, body = system.layout, system.program["body"]
    q, charts, unknown = coordinates(system, n, read)
    spins = body["spin"]
    spinning = np.flatnonzero(spins >= 0)
    angle = np.zeros((n, len(layout.bodies)))
    angle[:, spinning] = q[:, spins[spinning]]
    meshes = mesh_records(system)
    count = len(meshes)
    found = Motion(
        np.zeros((n, len(layout.bodies), 3)),
        np.zeros((n, len(layout.bodies), 3, 3)),
        angle,
        np.zeros((n, count, 3)),
        np.zeros((n, count, 3, 3)),
        unknown,
        np.zeros((n, system.sizes["no"])),
    )
    state = system.initial_state()
    for i in range(n):
        if i % STRIDE == 0:
            report_step(f"scene, {100.0 * i / n:.0f} %")
        state.t = float(times[i])
        state.q[:] = q[i]
        state.charts[:] = charts[i]
        state.turns[spinning] = np.rint(q[i, spins[spinning]] / TWO_PI)
        state.q[spins[spinning]] -= TWO_PI * state.turns[spinning]
        found.observed[i] = evaluate.observe(system, state)
        frames = system.workspace.fr
        found.place[i], found.axes[i] = frames["r"], frames["R"]
        for m, record in enumerate(meshes):
            found.pitch_points[i, m] = record["now"]["P"]
            found.directions[i, m] = force_directions(record)
        if look is not None:
            look(i)
    return found


def coordinates(
    system: System, n: int, read: Callable[[str], Array | None]
) -> tuple[Array, Array, tuple[str, ...]]:
    """Coordinates with whole turns (n, nd), attitudes (n, charts, 3, 3), and those not in the result.

    Parameters
    ----------
    system, n, read
        See `motion`.
    """
    q = np.zeros((n, system.sizes["nd"]))
    charts = np.tile(system.initial_state().charts, (n, 1, 1, 1))
    unknown = []
    words = {"alpha": "rx", "beta": "ry"}
    for b, one in enumerate(system.bodies, start=1):
        if one.state:
            continue
        record, name = system.program["body"][b], system.layout.bodies[b]
        for k, (coordinate, unit) in enumerate(one.coordinates):
            if int(record["chart"]) >= 0 and unit == "rad":
                if coordinate == "alpha" and not _attitudes(name, read, charts[:, int(record["chart"])]):
                    unknown.append(f"attitude of {name}")
                continue
            word = words.get(coordinate, coordinate)
            values = read(f"angle[{name}]" if coordinate == "spin" else f"displacement[{name}.{word}]")
            if values is None:
                unknown.append(f"{name}.{coordinate}")
            else:
                q[:, int(record["dof"]) + k] = values
    return q, charts, tuple(unknown)


def _attitudes(name: str, read: Callable[[str], Array | None], charts: Array) -> bool:
    """Set the attitudes of a tumbling body, shape (n, 3, 3); return whether they are known."""
    from scipy.spatial.transform import Rotation

    parts = [read(f"attitude[{name}.{c}]") for c in "xyzw"]
    if any(part is None for part in parts):
        return False
    quaternion = np.column_stack([part for part in parts if part is not None])
    # a model at rest has zeros
    if np.any(quaternion):
        charts[:] = Rotation.from_quat(quaternion).as_matrix()
    return True


def shown_bodies(system: System) -> list[int]:
    """Indices of the bodies in a scene, without auxiliary bodies for coordinates of elastic ones."""
    names, model = system.layout.bodies, system.model
    helpers: set[str] = set()
    if model is not None:
        for name, part in model.elastic_bodies.items():
            own = {f"{name}.{node}" for node in part.nodes}
            helpers |= {n for n in names if n.startswith(f"{name}.") and n not in own}
    return [b for b, one in enumerate(system.bodies, start=1) if not one.state and names[b] not in helpers]


def scene_bodies(system: System, moved: Motion, rest: Motion) -> list[SceneBody]:
    """Bodies of a scene without ground; children of a rotating body move in its frame.

    Parameters
    ----------
    system
        The machine.
    moved, rest
        Motion over the frames of the scene, and the rest position as one frame.
    """
    names, shown = system.layout.bodies, shown_bodies(system)
    numbers = {b: k for k, b in enumerate(shown)}
    size = float(np.linalg.norm(np.ptp(moved.place.reshape(-1, 3), axis=0))) if shown else 0.0
    found: list[SceneBody] = []
    for b in shown:
        parent = int(system.program["body"]["parent"][b])
        while parent and parent not in numbers:
            parent = int(system.program["body"]["parent"][parent])
        place, axes = _in_parent(moved, b, parent)
        place0, axes0 = (x[0] for x in _in_parent(rest, b, parent))
        way = (place - place0) @ axes0
        far = float(np.ptp(way, axis=0).max()) > WAY * size
        angle = moved.angle[:, b]
        gross, ratio = kinematic(angle, moved)
        turn, quaternion = _turns(axes0.T @ axes)
        found.append(
            SceneBody(
                name=names[b],
                parent=numbers[parent] if parent else -1,
                place=place0,
                axes=axes0,
                travel=way if far else None,
                position=None if far or np.abs(way).max() <= STILL else way,
                turn=turn,
                quaternion=quaternion,
                angle=angle if np.any(angle) else None,
                gross=gross,
                ratio=ratio,
            )
        )
    return found


def _turns(axes: Array) -> tuple[Array | None, Array | None]:
    """Axes over time, shape (n, 3, 3), as small rotation vectors, or as quaternions for large rotations."""
    from scipy.spatial.transform import Rotation

    turned = Rotation.from_matrix(axes)
    vector = turned.as_rotvec()
    largest = float(np.abs(vector).max())
    if largest <= TUMBLE:
        return (vector if largest > STILL else None), None
    found = turned.as_quat()
    # equal signs of neighbours: interpolation between frames takes the shorter path
    signs = np.sign((found[1:] * found[:-1]).sum(axis=1))
    found[1:] *= np.cumprod(np.where(signs == 0.0, 1.0, signs))[:, None]
    return None, found


def _in_parent(moved: Motion, b: int, parent: int) -> tuple[Array, Array]:
    """Positions (n, 3) and axes (n, 3, 3) of a body in the spinning frame of its parent."""
    if parent == 0:
        return moved.place[:, b], moved.axes[:, b]
    inverse = np.swapaxes(moved.spinning(parent), 1, 2)
    place = np.einsum("nij,nj->ni", inverse, moved.place[:, b] - moved.place[:, parent])
    return place, inverse @ moved.axes[:, b]


def kinematic(angle: Array, moved: Motion) -> tuple[Array | None, float]:
    """Kinematic part of an angle [rad]: that of the guiding body times a ratio, fitted over all frames.

    Parameters
    ----------
    angle
        The angle over the frames, including whole turns, shape (n,).
    moved
        Motion of all bodies.
    """
    guide = _guide(moved.angle)
    lead = None if guide < 0 else moved.angle[:, guide]
    gross, ratio = None, 1.0
    if lead is not None and abs(angle[-1] - angle[0]) >= TURNING:
        x = lead - lead.mean()
        gross, ratio = lead, 1.0 if np.array_equal(angle, lead) else float(x @ angle / (x @ x))
    if np.ptp(angle - (0.0 if gross is None else ratio * gross)) > SWING:
        return angle, 1.0
    return gross, ratio


def _guide(angle: Array) -> int:
    """Body with the largest rotation, which guides the angles of the others; -1 if none rotates."""
    travel = np.abs(angle[-1] - angle[0])
    b = int(np.argmax(travel))
    return b if travel[b] > TURNING else -1
