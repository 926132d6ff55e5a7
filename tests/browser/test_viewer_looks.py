# SPDX-License-Identifier: Apache-2.0
"""What a reader sees first: whole solids, buttons within reach, clean cuts, honest lines, films that play."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import PAINTED, asked, scene
from tests.support.scene_data import LENGTH, TEETH, Block, box, circle, extruded, gears, passing, texts_of

pytestmark = needs_browser
FORCE = "circumferential_force[stage_1]"


@pytest.fixture(scope="module")
def pair() -> tuple[str, str]:
    return texts_of(*gears())


def bare(
    block: Block, solids: list[dict[str, Any]], bodies: Sequence[dict[str, Any]] = ()
) -> tuple[str, str]:
    """A scene of solids that are at rest."""
    header = {
        "format": "pitchpoint-scene-2",
        "title": "Solids",
        "up": [0, 1, 0],
        "bodies": list(bodies),
        "solids": solids,
    }
    return texts_of({**header, "times": block.put([0.0])}, block)


def solid(block: Block, name: str, kind: str, shape: tuple[Any, Any]) -> dict[str, Any]:
    points, triangles = shape
    surface = {"points": block.put(points, "f4"), "triangles": block.put(triangles, "u4"), "creases": 30}
    return {"name": name, "kind": kind, "body": -1, "see_through": False, **surface}


def test_one_point_that_stands_out_is_fitted_into_the_picture(open_page: OpenPage) -> None:
    """A needle on a ring of thousands of corners, from three sides: a sample need not hold its tip."""
    points, triangles = extruded(circle(0.1, 1000), 0.05, 0.02)
    needle = [[0.0, 0.6, 0.02], [0.05, 0.6, 0.0], [0.02, 0.08, 0.01]]
    n = len(points)
    shape = (
        np.concatenate([points, needle]),
        np.concatenate([triangles, [[n, n + 1, n + 2], [n, n + 2, n + 1]]]),
    )
    block = Block()
    script = f"""{PAINTED} const out = [];
      for (const view of ["axis", "front", "iso"]) {{ V.view(view); out.push(painted()); }} return out;"""
    for left, right, top, bottom in asked(
        scene(open_page, bare(block, [solid(block, "needle", "body", shape)])), script
    ):
        assert left > 0.01 and right < 0.99
        assert top == pytest.approx(0.05, abs=0.02) and bottom == pytest.approx(0.95, abs=0.02)


def test_narrow_pages_have_all_buttons_and_nothing_under_the_folded_forces(open_page: OpenPage) -> None:
    """390 pixels; the gears are as high as the page, so that they would touch the upper edge."""
    header, block = gears()
    header["solids"] = [
        *header["solids"][:2],
        solid(block, "mast", "body", box([-0.05, -0.2, 0], [0.1, 0.2, 0.01])),
    ]
    script = f"""{PAINTED}
      V.view("axis"); V.draw();
      const [head, canvas] = [".ppv-legend", ".ppv-canvas"].map((what) => $(what).getBoundingClientRect());
      const folded = $(".ppv-legend").classList.contains("ppv-folded");
      const tools = all(".ppv-tools button").map((b) => {{
        const box = b.getBoundingClientRect();
        return b.contains(document.elementFromPoint((box.left + box.right) / 2, (box.top + box.bottom) / 2))
          && box.left >= 0 && box.right <= innerWidth; }});
      return {{folded, tools, below: (head.bottom - canvas.top) / canvas.height, box: painted()}};
    """
    page = scene(open_page, texts_of(header, block), box="390px;height:560px", size=(390, 560))
    found = asked(page, script)
    assert found["folded"] and len(found["tools"]) >= 9 and all(found["tools"])
    left, right, top, bottom = found["box"]
    assert found["below"] < top and bottom < 1 and 0 < left < right < 1
    assert bottom - top > 0.5


def test_a_cut_shows_nothing_of_what_sits_in_a_bore(open_page: OpenPage) -> None:
    """A shaft of 60 facets in a ring of 48 within the same circle, along x, looked at from 14 mm.

    Cut square to z next to the shaft, the ring is the cut and the shaft behind its bore is not seen; cut
    through the middle, the shaft is the cut and the bore behind it is not seen.
    """
    turned = np.array([[0, 0, 1], [0, 1, 0], [-1, 0, 0.0]])
    ring, shaft = extruded(circle(0.03, 48), 0.015, 0.04), extruded(circle(0.015, 60), 0.004, 0.2)
    block = Block()
    solids = [
        solid(block, name, kind, (points @ turned.T, triangles))
        for name, kind, (points, triangles) in (("ring", "gear", ring), ("shaft", "shaft", shaft))
    ]
    script = """
      V.view("axis"); named("Section").click();
      const list = $(".ppv-panel select"), place = $(".ppv-panel input[type=range]");
      list.value = "z"; list.dispatchEvent(new Event("change"));
      $(".ppv-panel input[type=checkbox]").click();
      const canvas = $(".ppv-canvas"), gl = canvas.getContext("webgl2"), {width, height} = canvas;
      const cut = (share) => {
        place.value = 1000 * share; place.dispatchEvent(new Event("input")); return S().section.at; };
      const [low, high] = [cut(0), cut(1)];
      const paint = (at, y) => {
        cut((at - low) / (high - low));
        V.look([0, y, at], [0, 0, 1], 0.007); V.draw();
        const all = new Uint8Array(4 * width * height), hues = {};
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, all);
        for (let k = 0; k < all.length; k += 4) {
          const hue = (all[k + 2] - all[k]) / all[k + 1];
          const name = hue > 0.15 ? "ring" : hue < 0.1 ? "shaft" : "other";
          hues[name] = (hues[name] ?? 0) + 1; }
        return hues; };
      return [paint(0.016, 0.004), paint(0, 0.0095)];
    """
    beside, through = asked(scene(open_page, bare(block, solids)), script)
    assert set(beside) == {"ring"} and set(through) == {"shaft"}, (beside, through)


def test_a_film_ends_by_itself_and_plays(open_page: OpenPage, pair: tuple[str, str], tmp_path: Path) -> None:
    """The record at a fifth of real time: 0.6 s."""
    page = scene(open_page, pair)
    for key in "+" * 9 + "--":
        page.keyboard.press(key)
    speed = page.evaluate("pitchpointViewer.state().speed")
    assert 0.1 < speed < 0.5
    page.get_by_role("button", name="Picture, solids, video").click()
    with page.expect_download() as saved:
        page.get_by_role("button", name="Record a video").click()
    state = page.evaluate("pitchpointViewer.state()")
    assert state["time"] == pytest.approx(LENGTH) and not state["playing"]
    ending = Path(saved.value.suggested_filename).suffix
    file = tmp_path / f"film{ending}"
    saved.value.save_as(file)
    film = base64.b64encode(file.read_bytes()).decode()
    page = open_page(f'<video muted src="data:video/{ending[1:]};base64,{film}"></video>')
    script = """const film = $("video"); await film.play(); await until(() => film.ended);
      return [film.ended, film.videoWidth, film.error?.message ?? "", film.currentTime];"""
    ended, width, wrong, length = asked(page, script)
    assert ended and width == 1000 and not wrong
    # a slow machine draws few pictures, and the last of them has no length
    assert 0.1 * LENGTH / speed < length < 3 * LENGTH / speed + 1


def test_lines_are_told_as_exactly_as_the_record_resolves_them(open_page: OpenPage) -> None:
    """1.25 turns have a line every 0.8 orders, of which this spectrum keeps every third."""
    header, block = gears()
    spectrum = header["spectra"][1]
    spectrum |= {"lines": block.put(2.4 * np.arange(1.0, 41.0)), "resolution": 0.8}
    header["spectra"][0] |= {"resolution": 8.333}
    header["maps"] = []
    script = f"""
      const read = async (over) => {{
        V.spectrum("{FORCE}", over); await wait(100);
        const plot = $(".ppv-spectra .u-over"), box = plot.getBoundingClientRect();
        plot.dispatchEvent(new MouseEvent("mousemove", {{clientX: box.left + 0.5 * box.width,
          clientY: box.top + 9, bubbles: true}}));
        await wait(100);
        return $(".ppv-spectra output").textContent; }};
      return [await read("orders of pinion"), await read("frequency")];
    """
    order, frequency = asked(scene(open_page, texts_of(header, block)), script)
    value, _, _ = order.partition(" ± 0.4: ")
    assert float(value.removeprefix("order ")) in np.round(2.4 * np.arange(1, 41), 1)
    assert 990 < float(frequency.partition(" ± 4 Hz: ")[0].removesuffix(" Hz")) < 1010


def test_the_line_around_the_cursor_has_gaps(open_page: OpenPage) -> None:
    """Orders 12, 24 and 30 to 35 are in the map, all else is less than it tells: no red line joins them."""
    header, block = gears()
    _, levels = passing()
    levels[:, TEETH[0] // 2 - 1] = 255
    levels[:, 29:35] = 255
    header["maps"][0]["levels"] = block.put(levels, "u1")
    # other lines than those of the map, as of a record that is longer than a piece of it
    header["spectra"][1] |= {"lines": block.put(np.arange(0.3, 40.3, 1.0))}
    script = f"""
      V.seek(0.1); V.spectrum("{FORCE}", "orders of pinion"); await wait(200);
      const canvas = $(".ppv-spectra canvas"), ink = canvas.getContext("2d"), {{width, height}} = canvas;
      const {{data}} = ink.getImageData(0, 0, width, height), columns = [];
      for (let x = 0; x < width; x++) {{
        let red = 0;
        for (let y = 0; y < height; y++) {{ const k = 4 * (y * width + x);
          const [r, g, b] = data.subarray(k, k + 3);
          if (r > 180 && r - g > 80 && Math.abs(g - b) < 30) red++; }}
        columns.push(red); }}
      const plot = $(".ppv-spectra .u-over").getBoundingClientRect(), box = canvas.getBoundingClientRect();
      return [columns, (plot.left - box.left) * width / box.width, plot.width * width / box.width];
    """
    columns, left, width = asked(scene(open_page, texts_of(header, block)), script)
    red = (np.flatnonzero(columns) - left) / width * (40.0 - 0.3) + 0.3
    assert len(red) and all(np.abs(red - order).min() < 0.3 for order in (12, 24))
    lone = red[red < 29.5]
    assert np.minimum(np.abs(lone - 12), np.abs(lone - 24)).max() < 0.6, "nothing elsewhere"
    # five lines in a row are a line without points
    row = np.array(columns)[np.flatnonzero(columns)[(red > 30.5) & (red < 34.5)]]
    assert len(row) > 50 and row.max() <= 3
