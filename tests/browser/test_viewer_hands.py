# SPDX-License-Identifier: Apache-2.0
"""Time, curves and camera under the reader's hands: a real keyboard and a real mouse."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import asked, scene, until
from tests.support.scene_data import FORCE, LENGTH, SPEED, TIMES, gears, load, texts_of

pytestmark = needs_browser


@pytest.fixture(scope="module")
def pair() -> tuple[str, str]:
    return texts_of(*gears())


def state(page: Any) -> dict[str, Any]:
    return dict(page.evaluate("pitchpointViewer.state()"))


def test_keys_and_buttons_move_time(open_page: OpenPage, pair: tuple[str, str]) -> None:
    page = scene(open_page, pair)

    def after(*keys: str) -> dict[str, Any]:
        for key in keys:
            page.keyboard.press(key)
        return state(page)

    page.evaluate("pitchpointViewer.seek(0.03)")
    assert after("ArrowRight")["frame"] == 151
    assert after("ArrowLeft", "ArrowLeft")["frame"] == 149
    assert after("Home")["time"] == 0.0
    assert after("End")["time"] == pytest.approx(LENGTH)
    assert after("Home", "]")["time"] == 0.02
    assert after("]")["time"] == pytest.approx(0.8 * LENGTH)
    assert after("[")["time"] == 0.02
    before = state(page)["speed"]
    assert 1.9 < after("+")["speed"] / before < 2.6
    assert 0.3 < after("-", "-")["speed"] / before < 0.6
    after(*"+++", "Home")
    play = page.locator(".ppv-play")
    play.click()
    assert state(page)["playing"] and play.get_attribute("aria-label") == "Pause (space)"
    until(page, "pitchpointViewer.state().time > 0.01")
    assert not after(" ")["playing"] and play.get_attribute("aria-label") == "Play (space)"
    page.evaluate("pitchpointViewer.seek(0.05)")
    assert page.text_content(".ppv-now") == "50.00\u2009ms"
    assert after("s")["section"]["on"] and after("m")["pictures"][0]["magnification"] == 10
    assert after("2")["following"] == 1 and after("0")["following"] == -1
    nameless = "(b) => !b.title && !b.ariaLabel && !b.closest('label')"
    assert asked(page, f"return all('.ppv button, .ppv input').filter({nameless}).length;") == 0


def test_cursor_and_time_are_linked_both_ways(same_scene: OpenPage, pair: tuple[str, str]) -> None:
    page = same_scene(pair)
    page.evaluate("pitchpointViewer.seek(0.05)")
    cursors = state(page)["cursor"]
    # a pixel of the plot is 1/900 of the record
    pixel = LENGTH / 900
    assert [cursor["at"] for cursor in cursors] == pytest.approx([0.05, 0.05], abs=pixel)
    force = FORCE["circumferential"] * load(TIMES) * (1 + 0.05 * np.sin(2 * np.pi * 600 * TIMES)) / 1e3
    at = force[250:252]
    assert cursors[0]["readings"] == [f"{at.min():.3f} … {at.max():.3f}"]

    for plot in page.locator(".u-over").all():
        box = plot.bounding_box()

        def at_share(share: float, box: dict[str, float] = box) -> tuple[float, float]:
            return box["x"] + share * box["width"], box["y"] + 0.5 * box["height"]

        page.mouse.move(*at_share(0.25))
        page.mouse.down()
        assert state(page)["time"] == pytest.approx(0.25 * LENGTH, abs=pixel)
        page.mouse.move(*at_share(0.75))
        page.mouse.up()
        page.mouse.move(*at_share(0.1))
        found = state(page)
        assert found["time"] == pytest.approx(0.75 * LENGTH, abs=pixel)
        assert [cursor["at"] for cursor in found["cursor"]] == pytest.approx(2 * [found["time"]], abs=pixel)


def test_curves_are_found_by_words_and_share_a_plot_by_unit(
    same_scene: OpenPage, pair: tuple[str, str]
) -> None:
    page = same_scene(pair)
    page.fill(".ppv-picker input", "RADIAL stage")
    (only,) = page.locator(".ppv-list button").all()
    assert only.text_content() == "radial force, stage_1"
    only.click()
    found = state(page)
    assert "radial_force[stage_1]" in found["channels"] and len(found["cursor"]) == 2
    page.fill(".ppv-picker input", "speed")
    page.keyboard.press("Enter")
    found = state(page)
    assert "speed[pinion]" in found["channels"] and len(found["cursor"]) == 3
    page.click("button[title='Remove speed, pinion']")
    assert len(state(page)["cursor"]) == 2


def test_wheel_scrolls_a_longer_page_until_the_scene_is_clicked(
    open_page: OpenPage, same_scene: OpenPage, pair: tuple[str, str]
) -> None:
    def zoomed(page: Any) -> float:
        """How much nearer the camera goes by a turn of the wheel."""
        before = state(page)["camera"]["distance"]
        page.locator(".ppv-canvas").hover(position={"x": 400, "y": 100})
        page.mouse.wheel(0, -300)
        page.evaluate("new Promise((done) => setTimeout(done, 100)).then(() => pitchpointViewer.draw())")
        return float(state(page)["camera"]["distance"] / before)

    small = scene(open_page, pair, box="800px;height:400px")
    assert zoomed(small) == 1.0
    small.click(".ppv-canvas", position={"x": 400, "y": 100})
    assert zoomed(small) < 0.8
    assert zoomed(same_scene(pair)) < 0.8


def test_curves_far_apart_have_plots_of_their_own(open_page: OpenPage) -> None:
    """Ripples of 10 µm about 0 and 100 µm share no plot; those about 0 and 30 µm, four spans or less, do."""
    header, block = gears()
    shake = next(c for c in header["channels"] if c["name"] == "position_y[wheel]")
    shake["first"] = False
    for away, name in ((100e-6, "far"), (30e-6, "near")):
        tables = {
            side: {**shake[side], "offset": [shake[side]["offset"][0] + away]} for side in ("least", "most")
        }
        header["channels"].append({**shake, **tables, "name": name, "label": name})
    script = """const out = [];
      for (const chosen of [["position_y[wheel]", "near"], ["position_y[wheel]", "far"]]) {
        for (const name of S().channels) V.show(name, false);
        for (const name of chosen) V.show(name);
        out.push(S().cursor.map(({readings}) => readings.length)); }
      return out;"""
    near, far = asked(scene(open_page, texts_of(header, block)), script)
    assert (near, far) == ([2], [1, 1])


def test_a_record_that_has_ended_has_no_value(open_page: OpenPage, pair: tuple[str, str]) -> None:
    """The second ends half-way; the first continues."""
    header, block = gears(title="Short")
    half = LENGTH / 2
    for body in header["bodies"]:
        body.pop("spin", None), body.pop("position", None)
        body["gross"] = block.put(SPEED * TIMES[:301])
    header |= {"arrows": [], "marks": [], "times": block.put(TIMES[:301])}
    for channel in header["channels"]:
        starts = block.put(TIMES[:300:2])
        channel |= {
            "times": starts,
            "least": block.put(np.full(150, 1.0)),
            "most": block.put(np.full(150, 1.0)),
        }
    script = f"""const out = [];
      for (const t of [{half}, {half + 1e-3}]) {{
        V.seek(t); await wait(50);
        out.push([S().cursor[0].readings[0].split(" | ")[1], all(".ppv-name").map((n) => n.textContent)]); }}
      return out;"""
    before, after = asked(scene(open_page, pair, texts_of(header, block)), script)
    assert before == ["0.001", ["Two gears", "Short"]]
    assert after[0] == "–" and after[1][0] == "Two gears"
    assert after[1][1].replace("\u2009", " ") == "Short (ended at 60.0 ms)"
