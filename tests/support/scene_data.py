# SPDX-License-Identifier: Apache-2.0
"""A scene made up for tests of the viewer: two toothed discs, a shaft that bends, arrows, curves, marks.

Written from `docs/scene_format.md` alone, not with the package, so that the viewer is tested against the
contract. Every number has a closed form, so that a test can say what the page must show.
"""

from __future__ import annotations

import base64
import gzip
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
VIEWER = Path(__file__).parents[2] / "src/pitchpoint/viz/assets/viewer.js"
POLICY = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:"

TEETH = (24, 36)
MODULE, WIDTH = 4e-3, 24e-3
SPEED = 2.0 * np.pi * 25.0
LENGTH, FRAMES = 0.12, 601
DISTANCE = MODULE * sum(TEETH) / 2
FORCE = {"circumferential": 4000.0, "radial": 1456.0, "axial": 800.0}
SHAKE, SHAKE_FREQUENCY = 5e-6, 200.0
TIMES = np.linspace(0.0, LENGTH, FRAMES)


class Block:
    """Numbers of a scene one after the other."""

    def __init__(self) -> None:
        self.data = bytearray()

    def put(self, values: ArrayLike, kind: str = "f8") -> dict[str, Any]:
        self.data += b"\0" * (-len(self.data) % 8)
        array = np.ascontiguousarray(values, dtype=kind if kind == "u1" else f"<{kind}")
        found = {"at": len(self.data), "type": kind, "shape": list(array.shape)}
        self.data += array.tobytes()
        return found

    def coarse(self, values: Array) -> dict[str, Any]:
        """The same in 16 bits."""
        columns = values.reshape(len(values), -1)
        low, step = columns.min(axis=0), np.ptp(columns, axis=0) / 65535
        found = self.put(np.rint((columns - low) / np.where(step > 0, step, 1)).reshape(values.shape), "u2")
        return {**found, "scale": step.tolist(), "offset": low.tolist()}


def load(t: Array) -> Array:
    """Share of the full force: it rises, and vanishes in the last fifth of the record."""
    return np.where(t < 0.8 * LENGTH, 0.25 + 0.75 * t / LENGTH, 0.0)


def passing() -> tuple[Array, NDArray[np.uint8]]:
    """A line at the order of the teeth of the pinion that grows to 1 kN, over 20 pieces of the record."""
    times = (np.arange(20) + 0.5) * LENGTH / 20
    levels = np.zeros((20, 40), dtype=np.uint8)
    levels[:, TEETH[0] - 1] = np.linspace(27, 255, 20)
    return times, levels


def toothed(teeth: int, turned: float) -> Array:
    """Outline of a gear, counter-clockwise, involute flanks on a base circle of 20 degrees."""
    pitch, root, tip = MODULE * teeth / 2, MODULE * (teeth / 2 - 1.25), MODULE * (teeth / 2 + 1)
    base = pitch * np.cos(np.radians(20.0))

    def half(radius: Array) -> Array:
        """Half the angle of a tooth at a radius."""
        alpha = np.arccos(np.minimum(base / radius, 1.0))
        return np.pi / 2 / teeth + 0.0149 - (np.tan(alpha) - alpha)

    flank = np.linspace(max(root, base), tip, 9)
    radius = np.r_[root, flank, flank[::-1], root]
    angle = np.r_[-half(flank[:1]), -half(flank), half(flank[::-1]), half(flank[:1])]
    whole = np.concatenate([angle + turned + 2 * np.pi * k / teeth for k in range(teeth)])
    return np.tile(radius, teeth)[:, None] * np.c_[np.cos(whole), np.sin(whole)]


def extruded(outline: Array, bore: float, width: float, layers: int = 1) -> tuple[Array, NDArray[np.int64]]:
    """A ring between an outline and a bore, as thick as `width`, about z."""
    n = len(outline)
    inner = bore * outline / np.linalg.norm(outline, axis=1)[:, None]
    levels = np.linspace(-width / 2, width / 2, layers + 1)
    points = np.concatenate([np.c_[ring, np.full(n, z)] for ring in (outline, inner) for z in levels])
    k, after = np.arange(n), (np.arange(n) + 1) % n
    faces = []

    def quad(a: Array, b: Array, c: Array, d: Array) -> None:
        faces.extend((np.c_[a, b, c], np.c_[a, c, d]))

    m = layers + 1
    for level in range(layers):
        low, high = level * n, (level + 1) * n
        quad(low + k, low + after, high + after, high + k)
        quad(m * n + low + after, m * n + low + k, m * n + high + k, m * n + high + after)
    top = layers * n
    quad(top + k, top + after, (m + layers) * n + after, (m + layers) * n + k)
    quad(after, k, m * n + k, m * n + after)
    return points, np.concatenate(faces)


def with_edges(corners: Array) -> NDArray[np.bool_]:
    """Triangles of three points; radial edges of a tooth are points in the bore, where some have two."""
    return np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).min(axis=1) > 1e-9


def circle(radius: float, points: int = 32) -> Array:
    angle = 2 * np.pi * np.arange(points) / points
    return radius * np.c_[np.cos(angle), np.sin(angle)]


def box(low: Sequence[float], high: Sequence[float]) -> tuple[Array, NDArray[np.int64]]:
    corner = np.array([[(low, high)[k >> i & 1][i] for i in range(3)] for k in range(8)])
    quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    return corner, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def gears(fine: int = 1, title: str = "Two gears", share: float = 1.0) -> tuple[dict[str, Any], Block]:
    """Header and numbers.

    Parameters
    ----------
    fine
        Layers of triangles over the face width.
    share
        Factor of all forces.
    """
    block = Block()
    t = TIMES
    ratio = TEETH[0] / TEETH[1]
    shake = SHAKE * np.sin(2 * np.pi * SHAKE_FREQUENCY * t)
    gross = block.put(SPEED * t)
    coarse = block.coarse
    moved = np.c_[0 * t, shake, 0 * t]
    bodies = [
        {"name": "pinion", "gross": gross, "spin": coarse(1e-4 * np.cos(2 * np.pi * 300 * t))},
        {"name": "wheel", "gross": gross, "ratio": -ratio, "position": coarse(moved)},
        {"name": "wheel_end", "gross": gross, "ratio": -ratio, "position": coarse(-2 * moved)},
    ]
    places = ([0, 0, 0], [DISTANCE, 0, 0], [DISTANCE, 0, 0.12])
    for body, place in zip(bodies, places, strict=True):
        body.update(parent=-1, place=place, axes=[0, 0, 0, 1])

    def solid(name: str, kind: str, body: int, shape: tuple[Array, NDArray[np.int64]], **more: Any) -> dict:
        points, triangles = shape
        return {
            "name": name,
            "kind": kind,
            "body": body,
            "creases": 35,
            "see_through": False,
            "points": block.put(points, "f4"),
            "triangles": block.put(triangles, "u4"),
            **more,
        }

    outlines = (toothed(TEETH[0], 0.0), toothed(TEETH[1], np.pi / TEETH[1] + np.pi))
    long, length = extruded(circle(0.016), 0.006, 0.16, 16), 0.16
    long[0][:, 2] += 0.06
    weight = np.clip(long[0][:, 2] / 0.12, 0.0, 1.0)
    blend = {
        "bodies": [1, 2],
        "first": block.put(0 * weight, "u2"),
        "second": block.put(0 * weight + 1, "u2"),
        "weight": block.put(weight, "f4"),
    }
    solids = [
        solid("Z1", "gear", 0, extruded(outlines[0], 0.014, WIDTH, fine), teeth=TEETH[0]),
        solid("Z2", "gear", 1, extruded(outlines[1], 0.016, WIDTH, fine), teeth=TEETH[1]),
        solid("drive_shaft", "shaft", 0, extruded(circle(0.014), 0.005, length, 1)),
        solid("output_shaft", "shaft", 1, long, blend=blend),
        solid("case", "housing", -1, box([-0.07, -0.09, -0.1], [0.21, 0.09, 0.16]), see_through=True),
    ]
    now = share * load(t)[:, None]
    point = [TEETH[0] * MODULE / 2, 0.0, 0.0]
    axes = {"circumferential": [0, 1, 0], "radial": [-1, 0, 0], "axial": [0, 0, 1]}
    parts = {part: FORCE[part] * now * np.array(axis)[None] for part, axis in axes.items()}
    full = share * float(np.linalg.norm(list(FORCE.values()))) * load(t).max()
    arrows = [
        {
            "name": "stage_1",
            "kind": "mesh",
            "body": -1,
            "at": block.put([point], "f4"),
            "unit": "N",
            "components": {part: coarse(value) for part, value in parts.items()},
            "size": full,
            "state": block.put(np.where(load(t) > 0, np.where(t < LENGTH / 10, 255, 1), 0), "u1"),
        },
        {
            "name": "bearing_a",
            "kind": "bearing",
            "body": 2,
            "at": block.put([[0, 0, 0]], "f4"),
            "unit": "N",
            "components": {part: coarse(-0.5 * value) for part, value in parts.items()},
            "size": full / 2,
        },
    ]
    starts = block.put(t[:-1:2])

    def channel(
        name: str, label: str, unit: str, values: Array, shown: tuple[str, float], **more: Any
    ) -> dict:
        pairs = values[:-1].reshape(-1, 2)
        return {
            "name": name,
            "label": label,
            "unit": unit,
            "shown_unit": shown[0],
            "scale": shown[1],
            "times": starts,
            "least": block.coarse(pairs.min(axis=1)),
            "most": block.coarse(pairs.max(axis=1)),
            **more,
        }

    force = share * FORCE["circumferential"] * load(t) * (1 + 0.05 * np.sin(2 * np.pi * 600 * t))
    channels = [
        channel(
            "circumferential_force[stage_1]",
            "circumferential force, stage_1",
            "N",
            force,
            ("kN", 1e-3),
            first=True,
        ),
        channel("position_y[wheel]", "displacement y, wheel", "m", shake, ("µm", 1e6), first=True),
        channel("radial_force[stage_1]", "radial force, stage_1", "N", 0.364 * force, ("kN", 1e-3)),
        channel("speed[pinion]", "speed, pinion", "rad/s", 0 * t + SPEED, ("rpm", 30 / np.pi)),
    ]
    frequency = np.linspace(0.0, 2000.0, 400)
    amplitude = 1e3 / (1 + (frequency - 600.0) ** 2 / 50) + 0.1
    modes = [
        {
            "name": "bending",
            "frequency": 412.5,
            "damping": 0.02,
            "position": block.put(
                [[[0, 0, 0], [0, 0, 0]], [[0, 1, 0], [0, 0, 0]], [[0, -2, 0], [0, 0.5, 0]]]
            ),
            "turn": block.put(np.zeros((3, 2, 3))),
        },
        {
            "name": "torsion",
            "frequency": 1210.0,
            "damping": 0.01,
            "position": block.put(np.zeros((3, 2, 3))),
            "turn": block.put([[[0, 0, 1], [0, 0, 0]], [[0, 0, 0.4], [0, 0, 0]], [[0, 0, 0.3], [0, 0, 0]]]),
        },
    ]
    header = {
        "format": "pitchpoint-scene-2",
        "title": title,
        "subtitle": f"scenario rated, {LENGTH} s",
        "up": [0, 1, 0],
        "bodies": bodies,
        "solids": solids,
        "times": block.put(t),
        "arrows": arrows,
        "channels": channels,
        "spectra": [
            {
                "channel": "circumferential_force[stage_1]",
                "lines": block.put(frequency),
                "amplitude": block.put(amplitude),
                "unit": "N",
            },
            {
                "channel": "circumferential_force[stage_1]",
                "of": "pinion",
                "lines": block.put(np.arange(1.0, 41.0)),
                "amplitude": block.put(np.where(np.arange(1, 41) == TEETH[0], 1e3, 0.1)),
                "unit": "N",
            },
        ],
        "maps": [
            {
                "channel": "circumferential_force[stage_1]",
                "of": "pinion",
                "unit": "N",
                "lines": block.put(np.arange(1.0, 41.0)),
                "times": block.put(passing()[0]),
                "most": 1e3,
                "decibels": 80.0,
                "levels": block.put(passing()[1], "u1"),
            }
        ],
        "marks": [
            {"time": 0.02, "kind": "impact", "what": "stage_1"},
            {"time": 0.8 * LENGTH, "kind": "contact_loss", "what": "stage_1"},
        ],
        "modes": modes,
        "notes": ["not in the result, drawn at rest: brake"],
    }
    return header, block


def batch(number: int) -> tuple[dict[str, Any], Block]:
    """Thousands of boxes that turn."""
    block = Block()
    t = np.linspace(0.0, 1.0, 20)
    gross = block.put(6.0 * t)
    points, triangles = box([-0.4, -0.4, -0.4], [0.4, 0.4, 0.4])
    shape = {"points": block.put(points, "f4"), "triangles": block.put(triangles, "u2"), "creases": 30}
    side = int(np.ceil(number ** (1 / 3)))
    bodies, solids = [], []
    for k in range(number):
        place = [k % side, k // side % side, k // side**2]
        bodies.append({"name": f"b{k}", "parent": -1, "place": place, "axes": [0, 0, 0, 1], "gross": gross})
        solids.append({"name": f"box{k}", "kind": "body", "body": k, "see_through": False, **shape})
    header = {
        "format": "pitchpoint-scene-2",
        "title": "Many",
        "subtitle": "",
        "up": [0, 1, 0],
        "bodies": bodies,
        "solids": solids,
        "times": block.put(t),
        "arrows": [],
        "channels": [],
        "spectra": [],
        "marks": [],
        "modes": [],
        "notes": [],
    }
    return header, block


def page_of(*texts: tuple[str, str], size: str = "1000px;height:650px") -> str:
    """A page with scenes given as header and numbers in base64."""
    elements = "".join(
        f'<script type="application/json" id="pp-scene{mark}">{header}</script>'
        f'<script type="text/plain" id="pp-scene-numbers{mark}">{numbers}</script>\n'
        for (header, numbers), mark in zip(texts, ("", "-2"), strict=False)
    )
    compare = "true" if len(texts) == 2 else "false"
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}"><title>scene</title>'
        f"<style>html,body{{margin:0;height:100%}}#view{{width:{size}}}</style></head>\n"
        f'<body><div id="view"></div>{elements}'
        f"<script>{VIEWER.read_text(encoding='utf-8')}</script>\n"
        "<script>const mounted = pitchpointViewer.mount(document.getElementById('view'), "
        f"{{compare: {compare}}});</script></body></html>\n"
    )


def texts_of(header: dict[str, Any], block: Block) -> tuple[str, str]:
    packed = gzip.compress(bytes(block.data), 6)
    return json.dumps(header).replace("</", "<\\/"), base64.b64encode(packed).decode()
