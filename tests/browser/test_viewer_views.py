# SPDX-License-Identifier: Apache-2.0
"""Standard views, projections, sections with hatched faces, and addresses that keep them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from tests.browser.test_viewer_looks import bare, solid
from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import asked, scene
from tests.support.scene_data import Block, box, circle, extruded, gears, page_of, texts_of

pytestmark = needs_browser

PIXELS = """
  const pixels = () => {
    V.draw();
    const canvas = $(".ppv-canvas"), gl = canvas.getContext("webgl2"), {width, height} = canvas;
    const data = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
    return {data, width, height}; };
"""


@pytest.fixture(scope="module")
def pair() -> tuple[str, str]:
    return texts_of(*gears())


def test_views_look_along_the_axes_by_name_and_by_key(same_scene: OpenPage, pair: tuple[str, str]) -> None:
    """Shafts along z, y up. `front` is the older name of `side`."""
    script = """
      const out = {};
      const way = () => { V.draw(); const {position, target} = S().camera;
        const d = position.map((x, k) => x - target[k]), l = Math.hypot(...d); return d.map((x) => x / l); };
      for (const name of ["axis", "side", "front", "top", "iso"]) { V.view(name); out[name] = way(); }
      for (const key of "aeti") {
        document.body.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true})); out[key] = way(); }
      return out;
    """
    found = asked(same_scene(pair), script)
    for name, expected in (("axis", [0, 0, 1]), ("side", [1, 0, 0]), ("top", [0, 1, 0])):
        assert np.abs(found[name]) == pytest.approx(expected, abs=2e-3), name
    assert found["front"] == pytest.approx(found["side"])
    assert min(map(abs, found["iso"])) > 0.3
    for key, name in zip("aeti", ("axis", "side", "top", "iso"), strict=True):
        assert found[key] == pytest.approx(found[name], abs=1e-6)


def test_at_rest_gears_and_shafts_show_the_axis(open_page: OpenPage) -> None:
    """A gear along x at rest, y up, in a housing with the axes of the world."""
    block = Block()
    half = math.sqrt(0.5)
    bodies = [
        {"name": "housing", "parent": -1, "place": [0, 0, 0], "axes": [0, 0, 0, 1]},
        {"name": "pinion", "parent": -1, "place": [0, 0, 0], "axes": [0, half, 0, half]},
    ]
    solids = [
        {**solid(block, "foot", "housing", box([-0.3, -0.3, -0.3], [0.3, -0.2, 0.3])), "body": 0},
        {**solid(block, "teeth", "gear", extruded(circle(0.1, 60), 0.05, 0.02)), "body": 1},
    ]
    text = bare(block, solids, bodies)
    script = """V.view("axis"); V.draw(); const {position, target} = S().camera;
      const d = position.map((x, k) => x - target[k]), l = Math.hypot(...d); return d.map((x) => x / l);"""
    assert np.abs(asked(scene(open_page, text), script)) == pytest.approx([1, 0, 0], abs=2e-3)


def test_parallel_projection_shows_equal_boxes_equally_large(open_page: OpenPage) -> None:
    """Two boxes 1 m behind each other; in central projection the nearer one is larger."""
    block = Block()
    solids = [
        solid(block, "near", "gear", box([-0.3, -0.05, 0.5], [-0.1, 0.05, 0.52])),
        solid(block, "far", "gear", box([0.1, -0.05, -0.5], [0.3, 0.05, -0.48])),
    ]
    script = f"""{PIXELS}
      const widths = () => {{
        const {{data, width, height}} = pixels(), counts = [0, 0];
        const y = Math.floor(height / 2);
        for (let x = 0; x < width; x++) {{
          const k = 4 * (y * width + x);
          if ([0, 1, 2].some((c) => Math.abs(data[k + c] - data[c]) > 12)) counts[x < width / 2 ? 0 : 1]++; }}
        return counts; }};
      V.look([0, 0, 0], [0, 0, 1], 1);
      const out = [widths()];
      V.project("parallel"); V.look([0, 0, 0], [0, 0, 1], 1);
      out.push(widths(), S().projection, $(".ppv-canvas").clientHeight);
      // the pointer finds the part that is there
      V.look([0.2, 0, 0], [0, 0, 1], 1); V.draw();
      const canvas = $(".ppv-canvas"), area = canvas.getBoundingClientRect();
      canvas.dispatchEvent(new PointerEvent("pointermove", {{clientX: area.left + area.width / 2,
        clientY: area.top + area.height / 2, pointerType: "mouse", bubbles: true}}));
      await wait(150);
      out.push($(".ppv-label").textContent);
      // closer than the near part, which central projection would leave behind the camera
      V.look([-0.2, 0, 0], [0, 0, 1], 0.4);
      out.push(widths());
      return out;
    """
    central, parallel, projection, height, label, closer = asked(
        scene(open_page, bare(block, solids)), script
    )
    assert central[0] > 1.5 * central[1]
    assert projection == "parallel" and abs(parallel[0] - parallel[1]) <= 2
    # 0.2 m of 1 m over the height of the canvas
    assert parallel[0] == pytest.approx(0.2 * height, abs=3)
    assert label.startswith("far")
    # its left half; the far part is at the right edge
    assert closer[0] == pytest.approx(0.1 / 0.4 * height, abs=3)


def rings() -> tuple[str, str]:
    """A shaft in a ring in a housing wall, all along z, and an open strip."""
    block = Block()
    solids = [
        solid(block, "shaft", "shaft", extruded(circle(0.02, 48), 0.0001, 0.2)),
        solid(block, "ring", "bearing", extruded(circle(0.06, 48), 0.02, 0.05)),
        solid(block, "wheel", "gear", extruded(circle(0.1, 48), 0.06, 0.05)),
    ]
    strip = (
        np.array([[0.12, -0.05, -0.02], [0.12, 0.05, -0.02], [0.12, 0.05, 0.07], [0.12, -0.05, 0.07]]),
        np.array([[0, 1, 2], [0, 2, 3]]),
    )
    solids.append(solid(block, "strip", "body", strip))
    return bare(block, solids)


def test_cut_parts_are_filled_with_hatches_that_differ(open_page: OpenPage) -> None:
    """Areas of the faces as those of the rings, within their outlines; lines in different directions."""
    script = f"""{PIXELS}
      V.project("parallel"); V.section("z", 0.025); V.look([0, 0, 0.025], [0, 0, 1], 0.25);
      const {{data, width, height}} = pixels();
      const scale = 0.25 / $(".ppv-canvas").clientHeight, areas = {{}}, spans = {{}};
      const radii = {{shaft: [0.002, 0.019], ring: [0.021, 0.058], wheel: [0.062, 0.098]}};
      for (const [name, [low, high]] of Object.entries(radii)) {{
        let dark = 0, light = 0; const rows = [];
        for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) {{
          const r = Math.hypot(x + 0.5 - width / 2, y + 0.5 - height / 2) * scale;
          if (r < low || r > high) continue;
          const k = 4 * (y * width + x), bright = data[k] + data[k + 1] + data[k + 2];
          if (bright < 330) {{ dark++; rows.push([x, y]); }} else light++; }}
        // direction of the hatch: whose projection of the dark pixels is the least even
        const spread = (angle) => {{
          const bins = new Map();
          for (const [x, y] of rows) {{
            const s = Math.round(-x * Math.sin(angle) + y * Math.cos(angle));
            bins.set(s, (bins.get(s) ?? 0) + 1); }}
          let sum = 0; for (const n of bins.values()) sum += n * n; return sum; }};
        const angles = [...Array(36).keys()].map((k) => k * Math.PI / 36), sums = angles.map(spread);
        const best = 5 * sums.indexOf(Math.max(...sums));
        areas[name] = dark / (dark + light); spans[name] = best; }}
      return {{areas, spans, hatches: S().pictures[0].hatches, section: S().section}};
    """
    found = asked(scene(open_page, rings()), script)
    assert found["section"]["on"] and found["section"]["at"] == pytest.approx(0.025)
    assert set(found["hatches"]) == {"shaft", "ring", "wheel"}, "an open surface has no inside to fill"
    for name, share in found["areas"].items():
        assert 0.05 < share < 0.5, (name, share)
    told = [(h["angle"], h["spacing"]) for h in found["hatches"].values()]
    assert len(set(told)) == 3
    for name, hatch in found["hatches"].items():
        # on the screen y is up, as in the plane seen along -z; mirrored or not is a matter of its frame
        angle = math.degrees(hatch["angle"])
        off = min(abs(math.remainder(found["spans"][name] - sign * angle, 180.0)) for sign in (1, -1))
        assert off <= 10.0, (name, found["spans"][name], angle)


def test_a_section_can_be_moved_turned_and_put_parallel_to_the_screen(open_page: OpenPage) -> None:
    script = """
      const key = (k) => document.body.dispatchEvent(new KeyboardEvent("keydown", {key: k, bubbles: true}));
      const slider = (text, value) => { const node = all(".ppv-panel input[type=range]")
        .find((each) => each.ariaLabel.startsWith(text)); node.value = value;
        node.dispatchEvent(new Event("input")); return S().section; };
      named("Section").click();
      V.section("z", 0.05);
      const out = [S().section];
      key("p"); out.push(S().section);
      out.push(slider("Turn", 30), slider("Tilt", 0));
      V.look([0, 0, 0.05], [1, 2, 3], 0.3); V.draw(); key("S"); out.push(S().section);
      const {position, target} = S().camera;
      out.push(position.map((x, k) => x - target[k]));
      V.section(null); out.push(S().section.on);
      return out;
    """
    first, moved, turned, _, facing, way, on = asked(scene(open_page, rings()), script)
    assert first["normal"] == [0, 0, 1] and moved["at"] > first["at"]
    angle = math.degrees(math.acos(np.dot(turned["normal"], [0, 0, 1])))
    assert angle == pytest.approx(30.0, abs=1e-6)
    assert facing["on"] and facing["normal"] == pytest.approx(list(way / np.linalg.norm(way)), abs=1e-6)
    assert facing["at"] == pytest.approx(np.dot(facing["normal"], [0, 0, 0.05]), abs=1e-4)
    assert on is False


def test_the_address_of_a_page_keeps_its_view(open_page: OpenPage, pair: tuple[str, str]) -> None:
    """Copied from one page and opened in another: same time, camera, projection and section."""
    script = """
      V.seek(0.05); V.project("parallel"); V.look([0.05, 0.01, 0.02], [1, 2, 3], 0.5);
      V.section([0, 1, 0], 0.01);
      V.draw(); named("Save").click();
      all(".ppv-panel button").find((node) => node.textContent === "copy link").click();
      await wait(200);
      return [location.hash, S(), $(".ppv-view .ppv-status").textContent];
    """
    page = scene(open_page, pair)
    hash_, before, words = asked(page, script)
    assert "link" in words
    page.reload()
    assert page.evaluate("mounted")
    after = asked(page, "V.draw(); return S();")
    assert page.evaluate("location.hash") == hash_
    assert after["time"] == pytest.approx(before["time"]) and after["projection"] == "parallel"
    for key in ("position", "target"):
        assert after["camera"][key] == pytest.approx(before["camera"][key], abs=1e-6)
    assert after["section"]["on"] and after["section"]["normal"] == pytest.approx([0, 1, 0])
    assert after["section"]["at"] == pytest.approx(0.01)


def test_a_page_begins_as_its_options_say(open_page: OpenPage, pair: tuple[str, str]) -> None:
    text = page_of(pair).replace(
        "{compare: false}", '{compare: false, start: {view: "axis", projection: "parallel", section: "axis"}}'
    )
    page = open_page(text)
    assert page.evaluate("mounted")
    state: dict[str, Any] = asked(page, "V.draw(); return S();")
    way = np.subtract(state["camera"]["position"], state["camera"]["target"])
    assert np.abs(way / np.linalg.norm(way)) == pytest.approx([0, 0, 1], abs=2e-3)
    assert state["projection"] == "parallel" and state["section"]["on"]
    assert state["section"]["normal"] == pytest.approx([0, 0, 1])
