# SPDX-License-Identifier: Apache-2.0
"""Forces of a scene as arrows: mesh forces on the second gears, bearing forces on the supported bodies."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.system.meshes import mesh_names
from pitchpoint.viz.scene.content import SceneArrow

if TYPE_CHECKING:
    from pitchpoint.report.scene.motion import Motion
    from pitchpoint.system.system import System

Array = NDArray[np.float64]
Read = Callable[[str], Array | None]

PARTS = ("circumferential", "radial", "axial")
NOTHING = 1e-6
"""Axial force relative to the largest force of a bearing below which it counts as zero."""


class Forces:
    """Forces over the frames: from the channels, or from the kernels for bodies at rest in these positions.

    Parameters
    ----------
    system
        The machine.
    moved
        Where its bodies are.
    read
        Gives a channel of the result at the frames, or None.
    """

    def __init__(self, system: System, moved: Motion, read: Read) -> None:
        self.read = read
        self.known = not moved.unknown
        self.columns = {c.name: k for k, c in enumerate(system.layout.channels)}
        self.observed = moved.observed
        self.without_damping: list[str] = []

    def of(self, *names: str) -> Array | None:
        """Several channels as columns, shape (n, k); None if not available and not computable."""
        kept = [self.read(name) for name in names]
        if all(one is not None for one in kept):
            return np.stack([np.asarray(one) for one in kept], axis=1)
        if not self.known or not all(name in self.columns for name in names):
            return None
        self.without_damping.append(names[0])
        return self.observed[:, [self.columns[name] for name in names]]


def force_arrows(system: System, moved: Motion, read: Read) -> tuple[list[SceneArrow], list[str]]:
    """Arrows of all meshes and bearings, and remarks on them.

    Parameters
    ----------
    system
        The machine.
    moved
        Where its bodies are.
    read
        Gives a channel of the result at the frames, or None.
    """
    forces = Forces(system, moved, read)
    arrows = [*_mesh_arrows(system, moved, forces), *_bearing_arrows(system, moved, forces)]
    notes = []
    if forces.without_damping:
        what = ", ".join(name.split("[")[1].split("]")[0].split(".")[0] for name in forces.without_damping)
        notes.append(f"forces not in the result, computed from the positions without damping: {what}")
    return arrows, notes


def _mesh_arrows(system: System, moved: Motion, forces: Forces) -> list[SceneArrow]:
    """Forces of all meshes on their second gears, at the pitch points."""
    found = []
    for m, name in enumerate(mesh_names(system)):
        parts = forces.of(*(f"{part}_force[{name}]" for part in PARTS))
        if parts is None:
            continue
        state = forces.read(f"contact_state[{name}]")
        place = moved.pitch_points[:, m]
        found.append(
            SceneArrow(
                name=name,
                kind="mesh",
                at=_steadied(place),
                components={
                    word: parts[:, row, None] * moved.directions[:, m, row] for row, word in enumerate(PARTS)
                },
                state=None if state is None else np.rint(state).astype(np.int64),
            )
        )
    return found


def _steadied(place: Array) -> Array:
    """Positions reduced to one row if they vary by less than 0.1 % of their distance from the origin."""
    steady = np.ptp(place, axis=0).max() <= 1e-3 * float(np.abs(place).max())
    return place[:1] if steady else place


def _bearing_arrows(system: System, moved: Motion, forces: Forces) -> list[SceneArrow]:
    """Forces of all bearings on the supported bodies or inner rings: radial, and axial if any."""
    found = []
    for name, _, place, axes in bearing_places(system, moved):
        parts = forces.of(*(f"bearing_force[{name}.{c}]" for c in ("fx", "fy", "fz")))
        if parts is None:
            continue
        across = np.einsum("nij,nj->ni", axes[:, :, :2], parts[:, :2])
        components = {"radial": across, "axial": parts[:, 2, None] * axes[:, :, 2]}
        if np.abs(parts[:, 2]).max() <= NOTHING * np.abs(parts).max():
            del components["axial"]
        found.append(SceneArrow(name=name, kind="bearing", at=_steadied(place), components=components))
    return found


def bearing_places(system: System, moved: Motion) -> Iterator[tuple[str, int, Array, Array]]:
    """Name, supported body, place (n, 3) and axes of the force (n, 3, 3) of every drawn bearing."""
    for kind, records in system.records.items():
        for record, name in zip(records, system.names.get(kind, ()), strict=False):
            drawn = registry.find(kind).arrow_of(record)
            if not drawn:
                continue
            i, j = int(record["i"]), int(record["j"])
            if drawn == "bearing":  # has its own axes
                place = moved.place[:, i] + record["zi"] * moved.axes[:, i, :, 2]
                axes = moved.axes[:, j] @ record["B"]
            else:
                place = moved.place[:, i] + moved.spinning(i) @ record["p_i"]
                rest = int(record["rest"])
                axes = moved.axes[:, rest] @ record["A_rest"] if rest else moved.spinning(j) @ record["A_j"]
            yield name, i, place, axes
