# SPDX-License-Identifier: Apache-2.0
"""Covers, batches, scenes side by side and small screens in a real browser."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import asked, scene
from tests.support.scene_data import Block, batch, box, gears, texts_of

pytestmark = needs_browser

PAINTED = """
  const canvas = $(".ppv-canvas"), gl = canvas.getContext("webgl2");
  const colour = () => { const rgba = new Uint8Array(4);
    gl.readPixels(canvas.width >> 1, canvas.height >> 1, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
    return [...rgba.slice(0, 3)]; };
  const paper = getComputedStyle($(".ppv-scene")).backgroundColor.match(/[0-9]+/g).map(Number);
  // whether there is a solid at a place, seen along z in a picture 1 m high
  const painted = (...place) => { V.look(place, [0, 0, 1], 1); V.draw();
    return colour().some((c, k) => Math.abs(c - paper[k]) > 4); };
  const label = (words) => [...document.querySelectorAll(".ppv-panel label")].find((l) =>
    l.textContent.includes(words));
  const housing = (how) => { const select = label("housing").querySelector("select");
    select.value = how; select.dispatchEvent(new Event("change")); };
"""


def solid(block: Block, name: str, low: Any, high: Any, **more: Any) -> dict[str, Any]:
    points, triangles = box(low, high)
    surface = {"points": block.put(points, "f4"), "triangles": block.put(triangles, "u2")}
    return {"name": name, "kind": "body", "body": -1, **surface, **more}


def test_hundreds_of_solids_bend_and_can_be_hidden(open_page: OpenPage) -> None:
    """Next to 320 boxes: a rod whose upper end goes 5 m aside, a bar that sways by 5 m, a cover."""
    header, block = batch(320)
    ends = [{"name": f"end{k}", "place": [-20, 10 * k, 0], "axes": [0, 0, 0, 1]} for k in range(2)]
    ends[1]["position"] = block.put(np.outer(np.linspace(0.0, 5.0, 20), [1.0, 0.0, 0.0]))
    header["bodies"] += ends
    # a crate of eight corners: y = 0 follows the first end, y = 10 the second
    rod = solid(block, "rod", [-0.4, 0.0, -0.4], [0.4, 10.0, 0.4], body=320)
    upper = (box([0, 0, 0], [1, 1, 1])[0][:, 1] > 0.5).astype(float)
    rod["blend"] = {
        "bodies": [320, 321],
        "first": block.put(np.zeros(len(upper)), "u2"),
        "second": block.put(np.ones(len(upper)), "u2"),
        "weight": block.put(upper, "f4"),
    }
    bar = solid(block, "bar", [-40.4, 0.0, -0.4], [-39.6, 10.0, 0.4], schematic=True)
    bar["modal"] = {
        "shapes": block.put([[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]], "f4"),
        "node": block.put(upper, "u2"),
        "coordinates": block.put(np.linspace(0.0, 5.0, 20)[:, None]),
    }
    cover = solid(block, "cover", [-60.4, 0.0, -0.4], [-59.6, 10.0, 0.4], see_through=True)
    header["solids"] += [rod, bar, cover]
    script = (
        PAINTED
        + """
      const look = () => [[-20, 9], [-15.5, 9], [-40, 9], [-35.5, 9], [-60, 9], [0, 0]].map(([x, y]) =>
        painted(x, y, x ? 0 : 0.4));
      const out = {};
      V.seek(0); out.start = look();
      V.seek(1); out.end = look();
      const all = S().pictures[0].drawnTriangles;
      named("View").click();
      label("schematic parts").querySelector("input").click(); V.draw(); out.plain = look();
      out.fewer = all - S().pictures[0].drawnTriangles;
      housing("hidden"); V.draw(); out.open = look();
      housing("solid"); label("schematic parts").querySelector("input").click(); V.draw(); out.again = look();
      out.batches = S().pictures[0].batches;
      return out;
    """
    )
    out = asked(scene(open_page, texts_of(header, block)), script)
    assert out["batches"] == 2 and out["fewer"] == 12
    assert out["start"] == [True, False, True, False, True, True]
    assert out["end"] == out["again"] == [False, True, False, True, True, True]
    assert out["plain"] == [False, True, False, False, True, True]
    assert out["open"] == [False, True, False, False, False, True]


def covered() -> tuple[str, str]:
    """A cube of 2 m in a cover of 10 m, both on bodies of their own."""
    block = Block()
    bodies = [{"name": name, "place": [0, 0, 0], "axes": [0, 0, 0, 1]} for name in ("cube", "cover")]
    solids = [
        solid(block, "cube", [-1, -1, -1], [1, 1, 1], body=0),
        solid(block, "cover", [-5, -5, -5], [5, 5, 5], body=1, kind="housing", see_through=True),
    ]
    header = {"format": "pitchpoint-scene-2", "up": [0, 1, 0], "bodies": bodies, "solids": solids}
    return texts_of({**header, "times": block.put([0.0])}, block)


def test_a_cover_hides_nothing_and_is_cut_picked_and_kept(open_page: OpenPage) -> None:
    script = (
        PAINTED
        + """
      const out = {fit: S().camera};
      const pick = (share) => { const r = canvas.getBoundingClientRect(); V.follow(-1);
        V.look([0, 0, 0], [0, 0, 1], 12); V.draw();
        canvas.dispatchEvent(new MouseEvent("dblclick", {clientX: r.left + r.width / 2,
          clientY: r.top + r.height * share})); return S().following; };
      const seen = () => { V.follow(-1); V.look([0, 0, 0], [0, 0, 1], 12); V.draw(); return colour(); };
      const glb = async () => { const bytes = await V.file("glb").arrayBuffer();
        const size = new DataView(bytes).getUint32(12, true);
        return JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, size))); };
      named("View").click();
      out.picked = [pick(0.5), pick(0.2)];
      for (const how of ["see-through", "hidden", "solid"]) { housing(how); out[how] = seen(); }
      housing("see-through"); const file = await glb();
      out.modes = file.meshes.map((mesh) => [mesh.name,
        file.materials[mesh.primitives[0].material].alphaMode ?? "OPAQUE"]);
      housing("hidden"); out.kept = (await glb()).meshes.map((mesh) => mesh.name); housing("see-through");
      // square to z through the middle: the front of both is gone, the cube shows its cut
      document.activeElement.blur();
      document.body.dispatchEvent(new KeyboardEvent("keydown", {key: "s", bubbles: true}));
      out.section = S().section; out.cut = [pick(0.5), pick(0.2)];
      return out;
    """
    )
    out = asked(scene(open_page, covered()), script)
    # fitted is the cube; nothing of the cover lies before the near or behind the far plane
    camera = out["fit"]
    away = np.linalg.norm(np.array(camera["position"]) - camera["target"])
    assert away < 10.0 and camera["near"] <= max(0.01 * away, away - 5.0 * np.sqrt(3.0))
    assert camera["far"] > away + 5.0 * np.sqrt(3.0)
    assert out["picked"] == [0, 1] and out["cut"] == [0, 1] and out["section"]["on"]
    # through the cover the cube is nearer to its own colour than to that of the cover
    through, alone, solid_ = (np.array(out[key], float) for key in ("see-through", "hidden", "solid"))
    assert 0.0 < np.abs(through - alone).max() < 0.5 * np.abs(solid_ - alone).max() + 12.0
    assert dict(out["modes"]) == {"cube": "OPAQUE", "cover": "BLEND"} and out["kept"] == ["cube"]


@pytest.mark.parametrize(
    ("scenes", "names"),
    [
        ([{"label": "healthy.h5"}, {"label": "broken.h5"}], ["healthy.h5", "broken.h5"]),
        (
            [{"title": f"Crawler gearbox of a mining shovel, {end}"} for end in ("healthy", "one chip")],
            ["… healthy", "… one chip"],
        ),
    ],
    ids=["files", "titles"],
)  # fmt: skip
def test_two_scenes_are_told_apart_and_both_have_their_forces(
    open_page: OpenPage, scenes: list[dict[str, Any]], names: list[str]
) -> None:
    (one, block), (two, other) = gears(), gears()
    two["arrows"][0]["name"] = "another"
    script = """
      named("View").click();
      return {names: [...document.querySelectorAll(".ppv-name")].map((n) => n.textContent),
        rows: [...document.querySelectorAll(".ppv-legend tbody tr:first-child th")].map((n) => n.textContent),
        looks: [...document.querySelectorAll(".ppv-panel [title^='View the']")].map((b) => b.textContent)};
    """
    texts = [
        texts_of({**h, **more}, b) for (h, b), more in zip(((one, block), (two, other)), scenes, strict=True)
    ]
    found = asked(scene(open_page, *texts), script)
    assert found["names"] == names and found["rows"] == ["stage_1", "another"]
    assert found["looks"] == ["stage_1", "another"]


def test_a_view_leaves_room_for_the_forces_and_looks_from_the_side(open_page: OpenPage) -> None:
    """No pixel of a long bar lies under the table of forces; without it the bar is in the middle."""
    header, block = gears()
    header["solids"].append(solid(block, "bar", [-0.4, -0.4, -0.1], [0.4, 0.4, 0.1]))
    script = """
      const canvas = $(".ppv-canvas"), gl = canvas.getContext("webgl2"), legend = $(".ppv-legend");
      const {width, height} = canvas, data = new Uint8Array(4 * width * height);
      const ends = () => { V.draw();
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
        let [low, high] = [width, 0];
        for (let k = 0; k < width * height; k++) if ([0, 1, 2].some((c) => data[4 * k + c] !== data[c])) {
          low = Math.min(low, k % width); high = Math.max(high, k % width); }
        return [low, width - 1 - high]; };
      const fit = () => { $(".ppv-tools button").click(); V.draw(); return ends(); };
      const out = {wide: legend.offsetWidth, beside: fit()};
      legend.querySelector("button").click(); out.alone = fit(); out.folded = legend.offsetHeight;
      return {...out, camera: S().camera};
    """
    out = asked(scene(open_page, texts_of({**header, "up": [0, 0, 1]}, block)), script)
    assert out["beside"][1] > out["wide"] and out["alone"][1] < out["beside"][1]
    for key, taken in (("beside", out["wide"]), ("alone", 0)):
        left, right = out[key]
        assert right - taken == pytest.approx(left, abs=0.06 * 1000), key
    # the axes of the gears are vertical here: 0.55 up for 1 and 0.7 across
    way = np.subtract(out["camera"]["position"], out["camera"]["target"])
    assert way[2] / np.linalg.norm(way) == pytest.approx(0.55 / np.sqrt(0.55**2 + 1 + 0.7**2), abs=1e-3)


def test_a_phone_shows_everything_and_follows_fingers(open_page: OpenPage) -> None:
    """At 360 px nothing reaches over the edge but rows that scroll; one finger turns, two zoom and shift."""
    header, block = gears()
    script = """
      const canvas = $(".ppv-canvas"), root = $(".ppv"); canvas.setPointerCapture = () => {};
      const box = canvas.getBoundingClientRect();
      const over = [...root.querySelectorAll("*")].filter((e) => e.offsetParent
        && !e.closest(".ppv-tools, .ppv-legend, .uplot")
        && e.getBoundingClientRect().right > box.left + 360.5).map((e) => e.className || e.tagName);
      const legend = $(".ppv-legend").getBoundingClientRect();
      const out = {over, width: root.scrollWidth, scene: [box.width, box.height], legend: legend.height,
        action: canvas.style.touchAction};
      $(".ppv-legend button").click(); out.opened = $(".ppv-legend").getBoundingClientRect().height;
      const touch = (kind, pointerId, x, y) => canvas.dispatchEvent(new PointerEvent("pointer" + kind,
        {pointerId, pointerType: "touch", button: 0, clientX: box.left + x, clientY: box.top + y}));
      const state = () => { V.draw(); return S().camera; };
      out.start = state();
      touch("down", 1, 100, 100); touch("move", 1, 140, 100); touch("up", 1, 140, 100); out.turned = state();
      touch("down", 1, 130, 100); touch("down", 2, 230, 100);
      touch("move", 1, 80, 100); touch("move", 2, 280, 100); out.zoomed = state();
      touch("move", 1, 80, 140); touch("move", 2, 280, 140); out.shifted = state();
      touch("up", 1, 80, 140); touch("up", 2, 280, 140);
      const label = $(".ppv-label"); out.quiet = label.hidden;
      V.look([0.035, 0, 0], [0, 0, 1], 0.3); V.draw();
      touch("down", 1, box.width / 2, box.height / 2); touch("up", 1, box.width / 2, box.height / 2);
      out.named = label.hidden ? "" : label.textContent;
      touch("down", 1, 9, 9); touch("up", 1, 9, 9); out.nothing = label.hidden;
      return out;
    """
    out = asked(scene(open_page, texts_of(header, block), box="360px;height:640px"), script)
    assert out["over"] == [] and out["width"] == 360 and out["scene"][1] > 0.3 * 640
    assert out["legend"] < 40 < out["opened"] and out["action"] == "none"
    start, turned, zoomed, shifted = (out[key] for key in ("start", "turned", "zoomed", "shifted"))
    assert turned["target"] == start["target"] and turned["distance"] == start["distance"]
    assert np.linalg.norm(np.subtract(turned["position"], start["position"])) > 0.2 * start["distance"]
    assert zoomed["distance"] == pytest.approx(0.5 * turned["distance"], rel=1e-9)
    pixel = 2 * zoomed["distance"] * np.tan(np.radians(14.0)) / out["scene"][1]
    moved = np.linalg.norm(np.subtract(shifted["target"], zoomed["target"]))
    # the fingers move in turn: in between they are 2 % farther apart, which zooms by as much
    assert moved == pytest.approx(40 * pixel, rel=0.02)
    assert out["quiet"] and out["named"] == "Z1, gear, 24 teeth" and out["nothing"]
    assert shifted["distance"] == pytest.approx(zoomed["distance"], rel=0.02)
