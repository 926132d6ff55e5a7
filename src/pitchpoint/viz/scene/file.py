# SPDX-License-Identifier: Apache-2.0
"""Scene as a header and one block of numbers, see `docs/scene_format.md`.

The precision of all numbers is that of their visible effect; kinematic angles have full precision for close
views of teeth.
"""

from __future__ import annotations

import base64
import gzip
import json
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.viz.scene.content import (
    Array,
    Indices,
    ModalShape,
    Scene,
    SceneArrow,
    SceneBody,
    SceneMark,
    SceneMode,
    ScenePiece,
    SceneSolid,
)
from pitchpoint.viz.scene.entries import channel_entries, contact_entry, map_entry, spectrum_entry
from pitchpoint.viz.scene.packing import LENGTH, Block, unseen
from pitchpoint.viz.scene.reach import reaches

FORMAT = "pitchpoint-scene-2"
_FORCE = 1.0 / 16384.0
"""Maximum error of a force relative to the maximum of its arrow."""
_PLACE = 1e-6
"""Maximum error of the point of application of a force [m]."""
_POINT = 5e-8
"""Maximum error of a point of a solid relative to the largest coordinate: single precision."""


def scene_parts(scene: Scene) -> tuple[dict[str, Any], bytes]:
    """Header and block of numbers of a scene.

    Raises
    ------
    ValueError
        If a number is not finite.
    """
    block = Block()
    reach = reaches(scene)
    header: dict[str, Any] = {
        "format": FORMAT,
        "title": scene.title,
        "subtitle": scene.subtitle,
        **({"label": scene.label} if scene.label else {}),
        "up": list(scene.up),
        "bodies": [_body(b, r, block) for b, r in zip(scene.bodies, reach, strict=True)],
        "solids": [_solid(s, block) for s in scene.solids],
        "times": block.put(scene.times, "f8"),
        "arrows": [_arrow(a, block) for a in scene.arrows],
        "contacts": [contact_entry(c, block) for c in scene.contacts],
        **channel_entries(scene.channels, block),
        "spectra": [spectrum_entry(s, block) for s in scene.spectra],
        "maps": [map_entry(m, block) for m in scene.maps],
        "marks": [_mark(m) for m in scene.marks],
        "modes": [_mode(m, block) for m in scene.modes],
        "notes": list(scene.notes),
    }
    return header, bytes(block.data)


def scene_texts(scene: Scene) -> tuple[str, str]:
    """Header as JSON, and numbers as base64 of gzip, for the elements of a page; the same bits each time."""
    header, data = scene_parts(scene)
    text = json.dumps(header, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    packed = gzip.compress(data, compresslevel=9, mtime=0)
    return text.replace("</", "<\\/"), base64.b64encode(packed).decode("ascii")


def _finite(values: NDArray[np.float64], what: str) -> NDArray[np.float64]:
    if not np.isfinite(values).all():
        raise ValueError(f"{what}: contains non-finite numbers")
    return values


def quaternion(axes: NDArray[np.float64]) -> list[float]:
    """Quaternion (x, y, z, w) of a right-handed frame, shape (3, 3), columns are its axes.

    Examples
    --------
    >>> quaternion(np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]))  # 120 deg about [1, 1, 1]
    [0.5, 0.5, 0.5, 0.5]
    """
    r = np.asarray(axes, dtype=np.float64)
    trace = float(np.trace(r))
    squares = np.array([2.0 * r[0, 0] - trace, 2.0 * r[1, 1] - trace, 2.0 * r[2, 2] - trace, trace]) + 1.0
    k = int(np.argmax(squares))
    s = 2.0 * math.sqrt(squares[k])
    if k == 3:
        found = [(r[2, 1] - r[1, 2]) / s, (r[0, 2] - r[2, 0]) / s, (r[1, 0] - r[0, 1]) / s, 0.25 * s]
    else:
        i, j = (k + 1) % 3, (k + 2) % 3
        found = [0.0, 0.0, 0.0, (r[j, i] - r[i, j]) / s]
        found[k] = 0.25 * s
        found[i] = (r[i, k] + r[k, i]) / s
        found[j] = (r[j, k] + r[k, j]) / s
    return [float(x) for x in found]


def _body(body: SceneBody, reach: float, block: Block) -> dict[str, Any]:
    found: dict[str, Any] = {
        "name": body.name,
        "parent": body.parent,
        "place": [float(x) for x in body.place],
        "axes": quaternion(body.axes),
    }
    if body.part:
        found["part"] = True
    angle_error = LENGTH / reach if reach > 0.0 else LENGTH
    tracks = {
        "position": (body.position, LENGTH),
        "turn": (body.turn, angle_error),
        "travel": (body.travel, LENGTH),
        "quaternion": (body.quaternion, 0.5 * angle_error),
    }
    for key, (track, error) in tracks.items():
        if track is not None and np.any(_finite(track, body.name)):
            found[key] = block.put_track(track, unseen(track, error))
    if body.angle is not None:
        angle = _finite(body.angle, body.name)
        gross = np.zeros_like(angle) if body.gross is None else body.gross * body.ratio
        if body.gross is not None and np.any(gross):
            found["gross"], found["ratio"] = block.put(body.gross, "f8"), body.ratio
        if np.any(angle - gross):
            found["spin"] = block.put_track(angle - gross, unseen(angle - gross, angle_error))
    return found


def _solid(solid: SceneSolid, block: Block) -> dict[str, Any]:
    found: dict[str, Any] = {
        "name": solid.name,
        "kind": solid.kind,
        "body": solid.body,
        "creases": solid.creases,
        "see_through": solid.see_through,
    }
    if solid.pieces:
        found["pieces"] = [_piece(piece, solid.name, block) for piece in solid.pieces]
    else:
        assert solid.points is not None and solid.triangles is not None
        found.update(_surface(solid.points, solid.triangles, solid.name, block))
    if solid.place is not None:
        found["place"] = [float(x) for x in solid.place]
    if solid.axes is not None:
        found["axes"] = quaternion(solid.axes)
    if solid.between is not None:
        ends = [[float(x) for x in end] for end in solid.between.ends]
        found["between"] = {"bodies": list(solid.between.bodies), "ends": ends}
    if solid.schematic:
        found["schematic"] = True
    if solid.teeth:
        found["teeth"] = solid.teeth
    if solid.blend is not None:
        found["blend"] = {
            "bodies": list(solid.blend.bodies),
            "first": block.put(solid.blend.first, "u2"),
            "second": block.put(solid.blend.second, "u2"),
            "weight": block.put(solid.blend.weight, "f4"),
        }
    if solid.modal is not None:
        found["modal"] = {
            "shapes": block.put(_finite(solid.modal.shapes, solid.name), "f4"),
            "node": block.put(solid.modal.node, "u2"),
        }
        if solid.modal.coordinates is not None:
            found["modal"]["coordinates"] = _bending(solid.modal, solid.name, block)
    return found


def _bending(modal: ModalShape, name: str, block: Block) -> dict[str, Any]:
    """Modal coordinates, with the total displacement of a node as precise as the position of a body."""
    assert modal.coordinates is not None
    reach = np.linalg.norm(modal.shapes, axis=2).max(axis=1)
    values = _finite(modal.coordinates, name)
    error = unseen(values * reach, LENGTH) / len(reach)
    return block.put_steps(values, 2.0 * error / np.where(reach > 0.0, reach, 1.0))


def _mode(mode: SceneMode, block: Block) -> dict[str, Any]:
    def parts(values: NDArray[np.complex128], axis: int) -> dict[str, Any]:
        """Real and imaginary parts next to each other."""
        return block.put(_finite(np.stack([values.real, values.imag], axis=axis), mode.name), "f4")

    found: dict[str, Any] = {"name": mode.name, "frequency": float(mode.frequency)}
    if mode.damping is not None:
        found["damping"] = float(mode.damping)
    found.update(position=parts(mode.position, 1), turn=parts(mode.turn, 1))
    if mode.modal:
        found["modal"] = {name: parts(values, 1) for name, values in mode.modal.items()}
    return found


def _surface(points: Array, triangles: Indices, name: str, block: Block) -> dict[str, Any]:
    size = float(np.abs(_finite(points, name)).max(initial=0.0))
    return {"points": block.put_steps(points, 2.0 * _POINT * size), "triangles": block.put_whole(triangles)}


def _piece(piece: ScenePiece, name: str, block: Block) -> dict[str, Any]:
    levels = [
        {"error": level.error, **_surface(level.points, level.triangles, name, block)}
        for level in piece.levels
    ]
    found: dict[str, Any] = {"turns": block.put(_finite(piece.turns, name), "f8"), "levels": levels}
    return {**found, "fault": piece.fault} if piece.fault else found


def _arrow(arrow: SceneArrow, block: Block) -> dict[str, Any]:
    total = np.sum([_finite(v, arrow.name) for v in arrow.components.values()], axis=0)
    size = float(np.linalg.norm(total, axis=1).max(initial=0.0))
    parts = block.put_tracks(list(arrow.components.values()), _FORCE * size)
    found: dict[str, Any] = {
        "name": arrow.name,
        "kind": arrow.kind,
        "body": arrow.body,
        "at": block.put_track(arrow.at, _PLACE),
        "unit": "N",
        "components": dict(zip(arrow.components, parts, strict=True)),
        "size": size,
    }
    if arrow.state is not None:
        # one byte per frame: -1 becomes 255
        found["state"] = block.put(np.where(arrow.state < 0, 255, arrow.state), "u1")
    return found


def _mark(mark: SceneMark) -> dict[str, Any]:
    found: dict[str, Any] = {"time": mark.time, "kind": mark.kind, "what": mark.what}
    if mark.until is not None:
        found["until"] = mark.until
    return found
