# SPDX-License-Identifier: Apache-2.0
"""The scene in a real browser: mode shapes, the view of a mesh, two results side by side, files."""

from __future__ import annotations

import base64
import json
from pathlib import Path

import numpy as np
import pytest

from pitchpoint import load_model
from pitchpoint.report.scene.build import scene_of
from pitchpoint.viz.scene.file import scene_texts
from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import PAINTED, about_z, asked, matrix, scene
from tests.support.scene_data import LENGTH, SPEED, TEETH, TIMES, Block, box, gears, texts_of, with_edges

pytestmark = needs_browser
EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def pair() -> tuple[str, str]:
    return texts_of(*gears())


def test_modes_swing_about_the_place_at_rest(same_scene: OpenPage, pair: tuple[str, str]) -> None:
    """Second body up, third down and twice as wide, a quarter of it a quarter period late."""
    script = """
      V.seek(0.07); V.draw(); const before = S(); V.mode(0); const out = [];
      for (let k = 0; k < 12; k++) { V.advance(0.13); out.push(S()); }
      V.mode(1); V.draw(); const twist = S();
      V.mode(-1); V.draw(); return {before, out, twist, after: S()};
    """
    found = asked(same_scene(pair), script)
    assert found["out"][0]["mode"] == 0 and found["after"]["mode"] == -1
    one, other = (
        np.array([matrix(s["pictures"][0]["bodies"][k])[1, 3] for s in found["out"]]) for k in (1, 2)
    )
    assert np.ptp(one) > 1e-3
    # y1 = a cos(p), y2 = -2 a cos(p) - 0.5 a sin(p): an ellipse with no centre but zero
    size = np.abs(one).max()
    sine = -(other + 2 * one) / 0.5
    radius = np.hypot(one, sine)
    assert radius == pytest.approx(radius.mean() * np.ones(12), rel=1e-9) and radius.mean() >= size
    turned = [matrix(m)[:2, :2] for m in found["twist"]["pictures"][0]["bodies"]]
    angles = [np.arctan2(m[1, 0], m[0, 0]) for m in turned]
    assert angles[1] == pytest.approx(0.4 * angles[0]) and abs(angles[0]) > 0
    assert found["after"]["pictures"] == found["before"]["pictures"]


def test_a_page_of_modes_begins_with_their_list_beside_the_machine(open_page: OpenPage) -> None:
    """On a phone the list would hide the machine: there it stays closed."""
    texts = scene_texts(scene_of(load_model(EXAMPLES / "backlash-oscillator" / "model.yaml"), modes=1))
    script = f"""{PAINTED}
      const list = $(".ppv-panel"), wide = $(".ppv-canvas").clientWidth;
      const edge = () => list.hidden ? 0 : list.offsetWidth / wide;
      const first = [edge(), painted()];
      list.querySelector("button[title=Close]").click(); named("Fit").click(); V.advance(5);
      return [...first, edge(), painted()];
    """
    covered, beside, free, alone = asked(scene(open_page, texts), script)
    assert 0.2 < covered < beside[0] and beside[1] < 1
    assert free == 0 and alone[1] - alone[0] > beside[1] - beside[0] > 0.4
    phone = scene(open_page, texts, box="390px;height:560px", size=(390, 560))
    assert asked(phone, 'return $(".ppv-panel").hidden;')


def test_look_into_a_mesh_cuts_it_where_it_acts(same_scene: OpenPage, pair: tuple[str, str]) -> None:
    script = """
      named("View").click();
      [...document.querySelectorAll(".ppv-panel button")].find((b) => b.textContent === "stage_1").click();
      V.draw(); return S();
    """
    state = asked(same_scene(pair), script)
    point = np.array([TEETH[0] * 2e-3, 0, 0])
    assert state["camera"]["target"] == pytest.approx(list(point), abs=1e-6)
    view = np.array(state["camera"]["position"]) - point
    assert view / np.linalg.norm(view) == pytest.approx([0, 0, 1], abs=2e-3)
    assert state["camera"]["distance"] < 0.1 and state["camera"]["near"] < state["camera"]["distance"]
    assert state["section"] == {"on": True, "normal": [0, 0, 1], "at": pytest.approx(0, abs=1e-9)}


def test_bodies_hang_on_bodies_tilt_and_tumble(open_page: OpenPage) -> None:
    """A carrier that turns, a planet on it that tilts, a stone that tumbles, an arrow at the planet."""
    block = Block()
    half = np.sqrt(0.5)
    tilt = np.array([0.01, -0.02, 0.005])
    points, triangles = box([-0.1, -0.1, -0.1], [0.1, 0.1, 0.1])
    shape = {"points": block.put(points, "f4"), "triangles": block.put(triangles, "u2")}
    header = {
        "format": "pitchpoint-scene-2",
        "title": "",
        "up": [0, 1, 0],
        "bodies": [
            {
                "name": "carrier",
                "place": [1, 2, 3],
                "axes": [half, 0, 0, half],
                "gross": block.put([0.0, 2.0]),
            },
            {
                "name": "planet",
                "parent": 0,
                "place": [0.5, 0, 0],
                "axes": [0, 0, 0, 1],
                "position": block.put([[0, 0, 0], [0.02, 0, 0]]),
                "turn": block.put([tilt, tilt]),
                "gross": block.put([0.0, 2.0]),
                "ratio": -3.0,
                "spin": block.put([0.1, 0.3]),
            },
            {
                "name": "stone",
                "place": [0, 0, 0],
                "axes": [0, 0, 0, 1],
                "quaternion": block.put([[0, 0, 0, 1], [half, 0, 0, half]]),
            },
        ],
        "solids": [{"name": "s", "kind": "body", "body": k, **shape} for k in range(3)],
        "times": block.put([0.0, 1.0]),
        "arrows": [
            {
                "name": "pin",
                "kind": "bearing",
                "body": 1,
                "at": block.put([[0.0, 0.1, 0.0]]),
                "unit": "N",
                "components": {"radial": block.put([[0, 5.0, 0], [0, 5.0, 0]])},
                "size": 5.0,
            }
        ],
    }
    picture = asked(scene(open_page, texts_of(header, block)), "V.seek(0.5); V.draw(); return S();")[
        "pictures"
    ][0]
    carrier, planet, stone = map(matrix, picture["bodies"])
    about_x = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0.0]])
    turned = about_x @ about_z(1.0)
    assert np.abs(carrier[:3, :3] - turned).max() < 1e-12 and list(carrier[:3, 3]) == [1, 2, 3]
    angle = np.linalg.norm(tilt)
    x, y, z = tilt / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    tilted = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    assert np.abs(planet[:3, :3] - turned @ tilted @ about_z(-3.0 + 0.2)).max() < 1e-12
    assert np.abs(planet[:3, 3] - ([1, 2, 3] + turned @ [0.51, 0, 0])).max() < 1e-12
    c, s = np.cos(np.pi / 4), np.sin(np.pi / 4)
    assert np.abs(stone[:3, :3] - [[1, 0, 0], [0, c, -s], [0, s, c]]).max() < 1e-12
    (pin,) = picture["arrows"]
    assert pin["at"] == pytest.approx(list([1, 2, 3] + turned @ [0.5, 0.1, 0]), abs=1e-12)
    assert pin["vectors"]["radial"] == pytest.approx(list(turned @ [0, 5.0, 0]), abs=1e-12)


def test_micrometres_are_seen(open_page: OpenPage) -> None:
    """A block of 0.1 m, a metre from the origin, moves by 5 µm in a picture that is 50 µm high."""
    block = Block()
    moved = [[0.0, 0.0, 0.0], [5e-6, 0.0, 0.0]]
    points, triangles = box([-0.1, -0.1, -0.1], [0.0, 0.1, 0.1])
    header = {
        "format": "pitchpoint-scene-2",
        "title": "",
        "up": [0, 1, 0],
        "bodies": [{"name": "b", "place": [1, 1, 1], "axes": [0, 0, 0, 1], "position": block.put(moved)}],
        "solids": [
            {
                "name": "s",
                "kind": "body",
                "body": 0,
                "points": block.put(points, "f4"),
                "triangles": block.put(triangles, "u2"),
            }
        ],
        "times": block.put([0.0, 1.0]),
    }
    script = """
      const canvas = $(".ppv-canvas"), gl = canvas.getContext("webgl2"), found = [];
      V.look([1, 1, 1.1], [0, 0, 1], 50e-6);
      for (const t of [0, 0.5, 1]) {
        V.seek(t); V.draw();
        const row = new Uint8Array(4 * canvas.width);
        gl.readPixels(0, canvas.height >> 1, canvas.width, 1, gl.RGBA, gl.UNSIGNED_BYTE, row);
        let edge = 0; while (row[4 * edge] === row[0] && edge < canvas.width) edge++;
        found.push(edge - canvas.width / 2);
      }
      return {found, height: canvas.height};
    """
    found = asked(scene(open_page, texts_of(header, block)), script)
    pixel = 50e-6 / found["height"]
    # single precision of 0.1 m in the frame of the body is 6 nm a corner, a tenth of a pixel
    assert np.abs(np.array(found["found"]) * pixel - [0, 2.5e-6, 5e-6]).max() < 1.5 * pixel


def test_two_results_share_time_camera_and_scale(open_page: OpenPage, pair: tuple[str, str]) -> None:
    script = """
      V.seek(0.07); V.draw();
      return {state: S(), names: [...document.querySelectorAll(".ppv-name")].map((n) => n.textContent),
        legends: document.querySelectorAll(".ppv-legend").length};
    """
    other = texts_of(*gears(title="Two gears, half the load", share=0.5))
    found = asked(scene(open_page, pair, other), script)
    one, two = found["state"]["pictures"]
    assert one["bodies"] == two["bodies"] and found["names"] == ["Two gears", "Two gears, half the load"]
    lengths = [p["arrows"][0]["lengths"]["circumferential"] for p in (one, two)]
    assert lengths[0] / lengths[1] == pytest.approx(2, rel=1e-3) and found["legends"] == 2
    assert "|" in found["state"]["cursor"][0]["readings"][0]


def test_files_hold_what_is_shown(same_scene: OpenPage, pair: tuple[str, str]) -> None:
    """STL: triangles where the bodies are. GLB: tracks that a reader can follow. PNG: the size requested."""
    script = """
      const text = async (kind, times) => {
        const bytes = new Uint8Array(await (await V.file(kind, times)).arrayBuffer());
        let out = ""; for (let k = 0; k < bytes.length; k += 30000)
          out += String.fromCharCode(...bytes.subarray(k, k + 30000));
        return btoa(out); };
      V.seek(0.0333); V.draw();
      const size = [$(".ppv-canvas").width, $(".ppv-canvas").height];
      const state = S(), png = await text("png", 2);
      return {size, state, png, stl: await text("stl"), glb: await text("glb")};
    """
    found = asked(same_scene(pair), script)
    picture = base64.b64decode(found["png"])
    assert picture[:8] == b"\x89PNG\r\n\x1a\n"
    assert [int.from_bytes(picture[k : k + 4]) for k in (16, 20)] == [2 * n for n in found["size"]]
    header, block = gears()
    solids = [
        (
            np.frombuffer(block.data, "<f4", np.prod(s["points"]["shape"]), s["points"]["at"]).reshape(-1, 3),
            np.frombuffer(block.data, "<u4", np.prod(s["triangles"]["shape"]), s["triangles"]["at"]).reshape(
                -1, 3
            ),
        )
        for s in header["solids"]
    ]
    facets = np.frombuffer(
        base64.b64decode(found["stl"])[84:], [("n", "<f4", 3), ("p", "<f4", (3, 3)), ("a", "<u2")]
    )
    kept = [with_edges(points[triangles]) for points, triangles in solids]
    assert len(facets) == sum(each.sum() for each in kept)
    pinion = matrix(found["state"]["pictures"][0]["bodies"][0])
    points, triangles = solids[0]
    expected = points[triangles[kept[0]]] @ pinion[:3, :3].T + pinion[:3, 3]
    assert np.abs(facets["p"][: len(expected)] - expected).max() < 1e-7
    check_glb(base64.b64decode(found["glb"]), solids[0])


def check_glb(data: bytes, solid: tuple[np.ndarray, np.ndarray]) -> None:
    magic, version, total, size = np.frombuffer(data, "<u4", 4)
    assert (magic, version, total) == (0x46546C67, 2, len(data))
    node = json.loads(data[20 : 20 + size])
    numbers = data[28 + size :]

    def array(k: int) -> np.ndarray:
        accessor = node["accessors"][k]
        view = node["bufferViews"][accessor["bufferView"]]
        kind = {5126: "<f4", 5125: "<u4"}[accessor["componentType"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        assert view["byteOffset"] % 4 == 0
        return np.frombuffer(numbers, kind, accessor["count"] * width, view["byteOffset"]).reshape(-1, width)

    assert [n["name"] for n in node["nodes"]][:1] == ["pinion"] and len(node["meshes"]) == 5
    first = node["meshes"][0]["primitives"][0]
    assert len(array(first["indices"])) == 3 * len(solid[1])
    corners = array(first["attributes"]["POSITION"])[array(first["indices"])[:, 0]]
    assert np.array_equal(corners, solid[0][solid[1].ravel()])
    (record,) = node["animations"]
    turning = next(c for c in record["channels"] if c["target"] == {"node": 0, "path": "rotation"})
    sampler = record["samplers"][turning["sampler"]]
    times, turns = array(sampler["input"])[:, 0], array(sampler["output"])
    assert times[-1] == pytest.approx(LENGTH) and np.all(np.diff(times) > 0)
    wave = np.interp(times, TIMES, 1e-4 * np.cos(2 * np.pi * 300 * TIMES))
    half = (SPEED * times.astype(float) + wave) / 2
    # signs are chosen for the shorter way: compare rotations, not quaternions
    assert np.abs(np.abs(turns[:, 2] * np.sin(half) + turns[:, 3] * np.cos(half)) - 1).max() < 1e-6
    assert np.einsum("ij,ij->i", turns[1:], turns[:-1]).min() > 0.7
