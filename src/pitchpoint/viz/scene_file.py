# SPDX-License-Identifier: Apache-2.0
"""A scene as a header and one block of numbers, see `docs/scene_format.md`.

What moves little is kept in 16 bits between its smallest and largest value: 1/65535 of its range is less than
a pixel however much it is magnified. Angles keep all their digits, since teeth are looked at from near.
"""

from __future__ import annotations

import base64
import gzip
import json
import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.viz.scene import (
    Array,
    Indices,
    Scene,
    SceneArrow,
    SceneBody,
    SceneChannel,
    SceneMark,
    SceneMode,
    ScenePiece,
    SceneSolid,
    SceneSpectrum,
)
from pitchpoint.viz.scene_contact_file import contact_entry

FORMAT = "pitchpoint-scene-1"
_LEVELS = 65535
_TYPES = {"f8": "<f8", "f4": "<f4", "u4": "<u4", "u2": "<u2", "u1": "u1"}


class _Block:
    """Numbers one after the other; the same array is written once."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.known: dict[tuple[str, tuple[int, ...], bytes], dict[str, Any]] = {}

    def put(self, values: ArrayLike, kind: str) -> dict[str, Any]:
        """Where an array lies."""
        array = np.ascontiguousarray(values, dtype=_TYPES[kind])
        key = (kind, array.shape, array.tobytes())
        if key not in self.known:
            self.data += b"\0" * (-len(self.data) % 8)
            self.known[key] = {"at": len(self.data), "type": kind, "shape": list(array.shape)}
            self.data += key[2]
        return dict(self.known[key])

    def put_coarse(self, values: ArrayLike) -> dict[str, Any]:
        """The same in 16 bits, each column between its least and its largest value."""
        array = np.asarray(values, dtype=np.float64)
        columns = array.reshape(-1, array.shape[-1] if array.ndim > 1 else 1)
        low, high = columns.min(axis=0), columns.max(axis=0)
        step = (high - low) / _LEVELS
        levels = np.rint((columns - low) / np.where(step > 0.0, step, 1.0))
        found = self.put(levels.reshape(array.shape), "u2")
        return {**found, "scale": step.tolist(), "offset": low.tolist()}


def scene_parts(scene: Scene) -> tuple[dict[str, Any], bytes]:
    """Header and block of numbers of a scene.

    Raises
    ------
    ValueError
        If a number is not finite.
    """
    block = _Block()
    header: dict[str, Any] = {
        "format": FORMAT,
        "title": scene.title,
        "subtitle": scene.subtitle,
        "up": list(scene.up),
        "bodies": [_body(b, block) for b in scene.bodies],
        "solids": [_solid(s, block) for s in scene.solids],
        "times": block.put(scene.times, "f8"),
        "arrows": [_arrow(a, block) for a in scene.arrows],
        "contacts": [contact_entry(c, block) for c in scene.contacts],
        "channels": [_channel(c, block) for c in scene.channels],
        "spectra": [_spectrum(s, block) for s in scene.spectra],
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
        raise ValueError(f"{what}: holds numbers that are not finite")
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


def _body(body: SceneBody, block: _Block) -> dict[str, Any]:
    found: dict[str, Any] = {
        "name": body.name,
        "parent": body.parent,
        "place": [float(x) for x in body.place],
        "axes": quaternion(body.axes),
    }
    for key, track in (("position", body.position), ("turn", body.turn)):
        if track is not None and np.any(_finite(track, body.name)):
            found[key] = block.put_coarse(track)
    for key, track in (("travel", body.travel), ("quaternion", body.quaternion)):
        if track is not None:
            found[key] = block.put(_finite(track, body.name), "f4")
    if body.angle is not None:
        angle = _finite(body.angle, body.name)
        gross = np.zeros_like(angle) if body.gross is None else body.gross * body.ratio
        if body.gross is not None and np.any(gross):
            found["gross"], found["ratio"] = block.put(body.gross, "f8"), body.ratio
        if np.any(angle - gross):
            found["spin"] = block.put_coarse(angle - gross)
    return found


def _solid(solid: SceneSolid, block: _Block) -> dict[str, Any]:
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
    if solid.skin is not None:
        found["skin"] = {
            "bodies": list(solid.skin.bodies),
            "first": block.put(solid.skin.first, "u2"),
            "second": block.put(solid.skin.second, "u2"),
            "weight": block.put(solid.skin.weight, "f4"),
        }
    if solid.sway is not None:
        found["sway"] = {
            "shapes": block.put(_finite(solid.sway.shapes, solid.name), "f4"),
            "node": block.put(solid.sway.node, "u2"),
        }
        if solid.sway.coordinates is not None:
            found["sway"]["coordinates"] = block.put_coarse(_finite(solid.sway.coordinates, solid.name))
    return found


def _mode(mode: SceneMode, block: _Block) -> dict[str, Any]:
    def parts(values: NDArray[np.complex128], axis: int) -> dict[str, Any]:
        """Real and imaginary parts beside each other."""
        return block.put(_finite(np.stack([values.real, values.imag], axis=axis), mode.name), "f4")

    found: dict[str, Any] = {"name": mode.name, "frequency": float(mode.frequency)}
    if mode.damping is not None:
        found["damping"] = float(mode.damping)
    found.update(position=parts(mode.position, 1), turn=parts(mode.turn, 1))
    if mode.sway:
        found["sway"] = {name: parts(values, 1) for name, values in mode.sway.items()}
    return found


def _spectrum(spectrum: SceneSpectrum, block: _Block) -> dict[str, Any]:
    return {
        "channel": spectrum.channel,
        "unit": spectrum.unit,
        "frequency": block.put(spectrum.frequency, "f4"),
        "amplitude": block.put(_finite(spectrum.amplitude, spectrum.channel), "f4"),
    }


def _surface(points: Array, triangles: Indices, name: str, block: _Block) -> dict[str, Any]:
    kind = "u2" if len(points) <= _LEVELS + 1 else "u4"
    return {"points": block.put(_finite(points, name), "f4"), "triangles": block.put(triangles, kind)}


def _piece(piece: ScenePiece, name: str, block: _Block) -> dict[str, Any]:
    levels = [
        {"error": level.error, **_surface(level.points, level.triangles, name, block)}
        for level in piece.levels
    ]
    found: dict[str, Any] = {"turns": block.put(_finite(piece.turns, name), "f8"), "levels": levels}
    return {**found, "fault": piece.fault} if piece.fault else found


def _arrow(arrow: SceneArrow, block: _Block) -> dict[str, Any]:
    total = np.sum([_finite(v, arrow.name) for v in arrow.components.values()], axis=0)
    found: dict[str, Any] = {
        "name": arrow.name,
        "kind": arrow.kind,
        "body": arrow.body,
        "at": block.put(arrow.at, "f4"),
        "unit": "N",
        "components": {role: block.put_coarse(v) for role, v in arrow.components.items()},
        "size": float(np.linalg.norm(total, axis=1).max(initial=0.0)),
    }
    if arrow.state is not None:
        # one byte a frame: -1 becomes 255
        found["state"] = block.put(np.where(arrow.state < 0, 255, arrow.state), "u1")
    return found


def _mark(mark: SceneMark) -> dict[str, Any]:
    found: dict[str, Any] = {"time": mark.time, "kind": mark.kind, "what": mark.what}
    if mark.until is not None:
        found["until"] = mark.until
    return found


def _channel(channel: SceneChannel, block: _Block) -> dict[str, Any]:
    found: dict[str, Any] = {
        "name": channel.name,
        "label": channel.label,
        "unit": channel.unit,
        "shown_unit": channel.shown_unit,
        "scale": channel.scale,
        "times": block.put(channel.times, "f8"),
        "least": block.put_coarse(_finite(channel.least, channel.name)),
        "first": channel.first,
    }
    if np.any(channel.least != channel.most):
        found["most"] = block.put_coarse(_finite(channel.most, channel.name))
    return found
