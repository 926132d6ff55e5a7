# SPDX-License-Identifier: Apache-2.0
"""Solids in a real browser: gears from one tooth, finenesses, stretched and bent solids, schematic parts."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
import pytest
from scipy.spatial import cKDTree

from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import about_z, asked, matrix, scene
from tests.support.scene_data import MODULE, WIDTH, Block, box, extruded, texts_of, toothed, with_edges

pytestmark = needs_browser

POINTS = 20
"""Points of one tooth in `toothed`."""
STL = """
  const stl = async (file = V.file("stl")) => { const bytes = new Uint8Array(await file.arrayBuffer());
    let text = ""; for (const b of bytes) text += String.fromCharCode(b); return btoa(text); };
"""


def pitch(teeth: int) -> tuple[np.ndarray, np.ndarray]:
    """Points and triangles of the first of all pitches of a gear."""
    points, triangles = extruded(toothed(teeth, 0.0), 0.01, WIDTH)
    return points, triangles[np.arange(len(triangles)) % (POINTS * teeth) < POINTS]


def level(block: Block, points: np.ndarray, triangles: np.ndarray, error: float) -> dict[str, Any]:
    return {"error": error, "points": block.put(points, "f4"), "triangles": block.put(triangles, "u4")}


def gear(block: Block, name: str, body: int, teeth: int, **more: Any) -> dict[str, Any]:
    points, triangles = pitch(teeth)
    # coarse: four triangles a tooth are no surface, but distinguished best
    coarse = level(block, points, triangles[:4], 1e-4)
    turns = block.put(2 * np.pi * np.arange(teeth) / teeth)
    piece = {"turns": turns, "levels": [coarse, level(block, points, triangles, 1e-7)]}
    return {"name": name, "kind": "gear", "body": body, "teeth": teeth, "pieces": [piece], **more}


def header(block: Block, bodies: list[Any], solids: list[Any], times: Any = (0.0, 1.0), **more: Any) -> Any:
    return {
        "format": "pitchpoint-scene-2",
        "title": "Solids",
        "up": [0, 1, 0],
        "bodies": bodies,
        "solids": solids,
        "times": block.put(np.array(times)),
        **more,
    }


def triangles_of(stl: str) -> np.ndarray:
    data = base64.b64decode(stl)
    kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("spare", "<u2")])
    return np.frombuffer(data, kind, int.from_bytes(data[80:84], "little"), 84)["corners"].astype(float)


def test_solids_of_the_file_are_closed(open_page: OpenPage) -> None:
    """Copies of a tooth share the points where they meet: every edge has its opposite, to the last bit."""
    block = Block()
    seat = {"place": [0.01, 0, 0.02], "axes": [0.1, 0.3, np.sin(0.2), np.sqrt(0.9 - np.sin(0.2) ** 2)]}
    bodies = [{"name": "a", "place": [0.1, 0, 0], "axes": [0, 0, 0, 1]}]
    texts = texts_of(header(block, bodies, [gear(block, f"Z{z}", 0, z, **seat) for z in (17, 23)]), block)
    found = triangles_of(asked(scene(open_page, texts), STL + "return await stl();"))
    _, corners = np.unique(found.reshape(-1, 3), axis=0, return_inverse=True)
    edges = corners.reshape(-1, 3)[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    assert len(edges) == 3 * (8 * POINTS - 8) * (17 + 23)
    forth, back = (edges[np.lexsort(edges[:, order].T)] for order in ([0, 1], [1, 0]))
    np.testing.assert_array_equal(forth, back[:, ::-1])


def test_copies_of_one_pitch_are_the_whole_gear(open_page: OpenPage) -> None:
    """The file that the page writes has the triangles of the whole gear, moved to its seat and its body."""
    block, teeth = Block(), 17
    seat = {"place": [0.01, 0, 0.02], "axes": [0, 0, np.sin(0.2), np.cos(0.2)]}
    bodies = [{"name": "a", "place": [0.1, 0, 0], "axes": [0, 0, 0, 1]}]
    texts = texts_of(header(block, bodies, [gear(block, "Z", 0, teeth, **seat)]), block)
    found = triangles_of(asked(scene(open_page, texts), STL + "return await stl();"))
    points, triangles = extruded(toothed(teeth, 0.0), 0.01, WIDTH)
    exact = (points @ about_z(0.4).T + np.array(seat["place"]) + [0.1, 0, 0])[triangles]
    exact = exact[with_edges(exact)]

    def volume(corners: np.ndarray) -> float:
        return float(np.einsum("ni,ni->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6)

    assert len(found) == len(exact) and volume(found) == pytest.approx(volume(exact), rel=1e-5)
    # every triangle of the one has its like in the other
    middles = [corners.mean(axis=1) for corners in (found, exact)]
    for one, other in (middles, middles[::-1]):
        assert cKDTree(one).query(other)[0].max() < 1e-7


def test_teeth_are_as_fine_as_they_are_near_and_drawn_where_they_are_seen(open_page: OpenPage) -> None:
    script = """
      V.view("axis"); V.draw(); const far = S();
      V.look([%g, 0, 0], [0, 0, 1], 0.004); V.draw(); const near = S();
      V.view("axis"); V.draw(); return [far, near, S()].map((s) => s.pictures[0]);
    """
    block, teeth = Block(), 40
    bodies = [{"name": "a", "place": [0, 0, 0], "axes": [0, 0, 0, 1]}]
    texts = texts_of(header(block, bodies, [gear(block, "Z", 0, teeth)]), block)
    far, near, again = asked(scene(open_page, texts), script % (MODULE * teeth / 2))
    whole = len(pitch(teeth)[1])
    assert far["triangles"] == whole * teeth
    assert far["drawnTriangles"] == again["drawnTriangles"] == 4 * teeth
    # a picture 4 mm high shows one tooth of 12.6 mm pitch; pitches count as spheres from bore to tip
    assert near["drawnTriangles"] % whole == 0 and 1 <= near["drawnTriangles"] / whole <= teeth / 3


def test_stretched_bent_and_schematic_solids(open_page: OpenPage) -> None:
    """A link between two bodies, a bar that sways, a way that is not magnified, parts that can be hidden."""
    block = Block()
    bodies = [
        {
            "name": "a",
            "place": [0, 0, 0],
            "axes": [0, 0, 0, 1],
            "travel": block.put([[0, 0, 0], [0, 0.3, 0]]),
        },
        {
            "name": "b",
            "place": [1, 0, 0],
            "axes": [0, 0, 0, 1],
            "position": block.put([[0, 0, 0], [0, 0.01, 0]]),
        },
    ]
    link = box([-0.01, -0.01, 0.0], [0.01, 0.01, 1.0])
    bar = box([-0.01, -0.01, 2.0], [0.01, 0.01, 3.0])
    surface = [{"points": block.put(p, "f4"), "triangles": block.put(t, "u2")} for p, t in (link, bar)]
    between = {"bodies": [0, 1], "ends": [[0, 0, 0.1], [0, 0, -0.1]]}
    upper = (bar[0][:, 2] > 2.5).astype(int)
    modal = {
        "shapes": block.put(np.array([[[0, 0, 0], [2.0, 0, 0]]]), "f4"),
        "node": block.put(upper, "u2"),
        "coordinates": block.put([[0.0], [0.05]]),
    }
    solids = [
        {
            "name": "rod",
            "kind": "spring",
            "body": 0,
            "between": between,
            **surface[0],
        },
        {"name": "bar", "kind": "body", "body": -1, "modal": modal, "schematic": True, **surface[1]},
    ]
    zero = np.zeros((2, 2, 3))
    mode = {"name": "1", "frequency": 5.0, "position": block.put(zero), "turn": block.put(zero)}
    mode["modal"] = {"bar": block.put([[1.0, 0.0]])}
    script = (
        STL
        + """
      const out = {};
      V.seek(1); V.draw(); out.end = await stl(); out.bodies = S().pictures[0].bodies;
      V.magnify(10); V.draw(); out.large = S().pictures[0].bodies; out.swung = await stl(); V.magnify(1);
      V.draw(); out.all = S().pictures[0].drawnTriangles;
      named("View").click();
      const stands = [...document.querySelectorAll(".ppv-panel label")].find((l) =>
        l.textContent.includes("schematic parts")).querySelector("input");
      stands.click(); V.draw(); out.fewer = S().pictures[0].drawnTriangles; out.plain = await stl();
      stands.click();
      V.seek(0); V.draw(); out.start = await stl();
      V.mode(0); V.draw(); const swings = V.file("stl"); V.mode(-1); V.draw();
      out.mode = await stl(swings); out.after = await stl();
      return out;
    """
    )
    out = asked(scene(open_page, texts_of(header(block, bodies, solids, modes=[mode]), block)), script)
    corners = triangles_of(out["end"])
    rod, bent = corners[:12].reshape(-1, 3), corners[12:].reshape(-1, 3)
    a, b = np.array([0, 0.3, 0.1]), np.array([1, 0.01, -0.1])
    along = (rod - a) @ (b - a) / np.linalg.norm(b - a)
    assert along.min() == pytest.approx(0, abs=1e-6)
    assert along.max() == pytest.approx(np.linalg.norm(b - a), abs=1e-6)
    off = rod - a - along[:, None] * (b - a) / np.linalg.norm(b - a)
    assert np.linalg.norm(off, axis=1) == pytest.approx(0.01 * np.sqrt(2) * np.ones(36), rel=1e-5)
    assert bent[bent[:, 2] > 2.5, 0].mean() == pytest.approx(0.1, abs=2e-2)
    assert bent[bent[:, 2] > 2.5, 0].max() == pytest.approx(0.11, abs=1e-6)
    assert bent[bent[:, 2] < 2.5, 0].max() == pytest.approx(0.01, abs=1e-6)
    # magnified are deviations from the mean: 0.005 + 10 * 0.005 of the way of b, nothing of a's travel
    places = [[matrix(m)[1, 3] for m in out[key]] for key in ("bodies", "large")]
    assert places[0] == pytest.approx([0.3, 0.01]) and places[1] == pytest.approx([0.3, 0.055])
    swung = triangles_of(out["swung"])[12:].reshape(-1, 3)
    assert swung[:, 0].max() == pytest.approx(2.0 * (0.025 + 10 * 0.025) + 0.01, abs=1e-5)
    assert out["all"] - out["fewer"] == 12 == len(triangles_of(out["plain"]))
    start, shape, after = (triangles_of(out[key])[12:].reshape(-1, 3) for key in ("start", "mode", "after"))
    assert start[:, 0].max() == pytest.approx(0.01, abs=1e-6)
    assert shape[:, 0].max() > 0.02
    assert np.array_equal(start, after)


def test_twenty_gears_load_and_turn(open_page: OpenPage) -> None:
    block = Block()
    bodies, solids = [], []
    gross = block.put(np.linspace(0.0, 20.0, 50))
    for k in range(20):
        place = [0.3 * (k % 5), 0.3 * (k // 5), 0]
        bodies.append(
            {"name": f"b{k}", "place": place, "axes": [0, 0, 0, 1], "gross": gross, "ratio": 1 - k / 9}
        )
        solids.append(gear(block, f"Z{k}", k, 30 + k))
    head = header(block, bodies, solids, np.linspace(0.0, 1.0, 50))
    script = "V.seek(0.5); V.draw(); return S().pictures[0];"
    picture = asked(scene(open_page, texts_of(head, block)), script)
    assert len(picture["bodies"]) == 20 and picture["batches"] == 0
    assert picture["drawnTriangles"] == 4 * sum(range(30, 50))
    angle = 10.0 * (1 - 19 / 9)
    assert np.abs(matrix(picture["bodies"][19])[:3, :3] - about_z(angle)).max() < 1e-9


def test_the_clock_counts_in_the_unit_of_the_record(open_page: OpenPage) -> None:
    """Frames seconds, parts of a millisecond and microseconds apart; each at the middle of the record."""
    clock = "V.seek(%g); V.draw(); return $('.ppv-now').textContent;"
    for length, text in ((20.0, "10.0 s"), (2e-3, "1.00 ms"), (2e-5, "10.0 µs")):
        block = Block()
        times = np.linspace(0.0, length, 21)
        texts = texts_of(header(block, [], [gear(block, "Z", -1, 17)], times), block)
        page = scene(open_page, texts)
        assert asked(page, clock % (length / 2)).replace("\u2009", " ") == text
