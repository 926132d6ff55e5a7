# SPDX-License-Identifier: Apache-2.0
"""Scene of a model that runs in the page: bodies at rest, and how poses and forces follow from its memory."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.multibody.channels import FRAME
from pitchpoint.report.scene.build import scene_of
from pitchpoint.report.scene.forces import PARTS, bearing_places
from pitchpoint.report.scene.motion import Motion, motion, shown_bodies
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_names, mesh_records
from pitchpoint.viz.scene.content import Scene, SceneArrow

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.solvers.exported_run import ExportedRun

Array = NDArray[np.float64]


def live_scene(model: Model, scenario: str, run: ExportedRun) -> tuple[Scene, dict[str, Any]]:
    """Scene at rest with the forces of the start, and data with which a page moves it.

    Parameters
    ----------
    model, scenario
        Model and name of its scenario.
    run
        Started run.

    Returns
    -------
    Scene
        Without solids if the model defines no geometry.
    dict
        `frame`: size of a frame of a body in the memory, and offsets of its origin, axes and angle [bytes].
        `bodies`: number of the frame of every body of the scene, and that of its parent. `arrows`: by arrow,
        the channel of its contact state or -1, and by component terms of channel and unit vector, in the axes
        of the arrow.
    """
    scene = scene_of(model, None, scenario)
    system = run.system
    row = evaluate.observe(system, run.state)
    columns = {c.name: k for k, c in enumerate(system.layout.channels)}
    moved = motion(system, 1, lambda n: row[[columns[n]]] if n in columns else None, np.array([run.state.t]))
    numbers = {b: k for k, b in enumerate(shown_bodies(system))}
    arrows, terms = [], []
    for name, kind, b, place, directions, channels in _forces(system, moved):
        if b not in numbers or any(c not in columns for group in channels.values() for c in group):
            continue
        parent = scene.bodies[numbers[b]].parent
        of_parent = [k for k, n in numbers.items() if n == parent]
        still, origin = _still(moved, of_parent[0] if of_parent else 0, scene, numbers[b])
        at = (place - origin) @ still
        vectors = {
            word: [(columns[c], *(directions[:, int(axis)] @ still).tolist()) for c, axis in group.items()]
            for word, group in channels.items()
        }
        state = columns.get(f"contact_state[{name}]", -1) if kind == "mesh" else -1
        arrows.append(
            SceneArrow(
                name=name,
                kind=kind,
                body=numbers[b],
                at=at[None],
                components={
                    word: np.array([sum((row[k] * np.array(v) for k, *v in group), np.zeros(3))])
                    for word, group in vectors.items()
                },
                state=None if state < 0 else np.rint(row[[state]]).astype(np.int64),
            )
        )
        terms.append({"state": state, "components": vectors})
    parents = {k: int(system.program["body"]["parent"][b]) for b, k in numbers.items()}
    back = {k: b for b, k in numbers.items()}
    bodies = [[back[k], back.get(scene.bodies[k].parent, 0)] for k in sorted(parents)]
    fields: Any = FRAME.fields
    frame = {"size": FRAME.itemsize} | {name: fields[name][1] for name in ("r", "R", "phi")}
    return replace(scene, arrows=arrows), {"frame": frame, "bodies": bodies, "arrows": terms}


def _forces(system: Any, moved: Motion) -> Any:
    """Name, kind, body, place, axes (columns) and {component: {channel: column}} of every drawn force."""
    for m, (name, record) in enumerate(zip(mesh_names(system), mesh_records(system), strict=True)):
        channels = {word: {f"{word}_force[{name}]": k} for k, word in enumerate(PARTS)}
        axes = moved.directions[0, m].T
        yield name, "mesh", int(record["j"]), moved.pitch_points[0, m], axes, channels
    for name, b, place, axes in bearing_places(system, moved):
        radial = {f"bearing_force[{name}.{c}]": k for k, c in enumerate(("fx", "fy"))}
        channels = {"radial": radial, "axial": {f"bearing_force[{name}.fz]": 2}}
        yield name, "bearing", b, place[0], axes[0], channels


def _still(moved: Motion, parent: int, scene: Scene, k: int) -> tuple[Array, Array]:
    """Axes (columns) and origin of the frame of a body that does not spin with it, in the world."""
    turned = moved.spinning(parent)[0] if parent else np.eye(3)
    origin = moved.place[0, parent] if parent else np.zeros(3)
    body = scene.bodies[k]
    return turned @ body.axes, origin + turned @ body.place
