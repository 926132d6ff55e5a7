# SPDX-License-Identifier: Apache-2.0
"""Curves of a scene are never cut off, in windows of any size; planets are shown apart or together."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import asked, scene
from tests.support.scene_data import LENGTH, Block, gears, texts_of

pytestmark = needs_browser

WINDOWS = [(360, 640), (640, 480), (768, 600), (1024, 420), (1440, 380), (1440, 900)]

CUT = """
  const box = (node) => node.getBoundingClientRect();
  const list = box($(".ppv-plots")), root = box($(".ppv"));
  const plots = all(".ppv-plot").map((node) => ({
    top: box(node).top - list.top, bottom: box(node).bottom - list.top,
    drawn: getComputedStyle(node).opacity !== "0"}));
  // ink on the outermost pixels of a canvas is a label that is cut
  const inked = all(".ppv-plots canvas").map((canvas) => {
    const {width, height} = canvas;
    const copy = Object.assign(document.createElement("canvas"), {width, height});
    const pen = copy.getContext("2d", {willReadFrequently: true});
    pen.drawImage(canvas, 0, 0);
    const {data} = pen.getImageData(0, 0, width, height);
    const ink = (x, y) => data[4 * (y * width + x) + 3] > 60;
    let n = 0;
    for (let y = 0; y < height; y++) n += ink(0, y) + ink(width - 1, y);
    for (let x = 0; x < width; x++) n += ink(x, height - 1);
    return n; });
  const words = all(".ppv-caption .ppv-curve, .ppv-caption .ppv-curve > *").filter((node) => {
    const own = box(node), around = box(node.closest(".ppv-caption"));
    const wider = node.scrollWidth > node.clientWidth + 1;
    return own.right > around.right + 1 || own.left < around.left - 1
      || wider && getComputedStyle(node).display !== "inline"; }).map((node) => node.textContent);
  const more = $(".ppv-more").hidden ? null : box($(".ppv-more"));
  const covered = more ? all(".ppv-plot").filter((node) => getComputedStyle(node).opacity !== "0"
    && box(node).bottom > more.top + 1 && box(node).right > more.left).length : 0;
  const below = root.bottom - box($(".ppv-curves-body")).bottom;
  return {plots, covered, height: list.height, inked, words, below,
    wide: document.documentElement.scrollWidth,
    more: $(".ppv-more").hidden ? 0 : parseInt($(".ppv-more").textContent.slice(2)),
    scene: box($(".ppv-scene")).height};
"""


def curves(block: Block, names: list[str], levels: list[float], unit: str) -> list[dict[str, Any]]:
    times = np.linspace(0.0, LENGTH, 200)
    return [
        {
            "name": f"{unit}[{name}]",
            "label": f"a quantity with long words, {name}",
            "unit": unit,
            "times": block.put(times),
            "least": block.put(level + np.sin(40.0 * times + k)),
            "most": block.put(level + 0.5 + np.sin(40.0 * times + k)),
            "first": True,
        }
        for k, (name, level) in enumerate(zip(names, levels, strict=True))
    ]


@pytest.fixture(scope="module")
def many() -> tuple[str, str]:
    """Five plots: two units, and levels apart, one with labels of eleven digits."""
    header, block = gears()
    header["channels"] = [
        *curves(block, ["stage_1", "stage_2"], [0.0, 0.5], "N"),
        *curves(block, ["first bearing"], [1234567.25], "N"),
        *curves(block, ["x", "y", "z"], [0.0, 1e3, -1e3], "m"),
    ]
    header["spectra"] = header["maps"] = []
    return texts_of(header, block)


@pytest.mark.parametrize("size", WINDOWS, ids=lambda size: f"{size[0]}x{size[1]}")
def test_no_curve_is_cut_off(open_page: OpenPage, many: tuple[str, str], size: tuple[int, int]) -> None:
    """Each plot is wholly visible or wholly out of sight, and those out of sight are counted."""
    wide, high = size
    page = scene(open_page, many, box=f"{wide}px;height:{high}px", size=size)
    found = asked(page, CUT)
    assert found["wide"] <= wide and found["scene"] >= 100 and abs(found["below"]) <= 1
    whole = [p for p in found["plots"] if p["top"] >= -1 and p["bottom"] <= found["height"] + 1]
    cut = [p for p in found["plots"] if p not in whole and p["top"] < found["height"] and p["drawn"]]
    assert whole and all(p["drawn"] for p in whole) and not cut, found
    assert not found["covered"], "the button for the next plots covers nothing"
    assert found["more"] == len(found["plots"]) - len(whole)
    assert not any(found["inked"]), "labels of axes are complete"
    assert not found["words"], "captions are complete"
    # the next plots, by the button
    if found["more"]:
        after = asked(page, f"$('.ppv-more').click(); await wait(300); {CUT}")
        assert not any(-0.9 * (p["bottom"] - p["top"]) < p["top"] < -6 for p in after["plots"]), after
        assert after["more"] < found["more"] and not after["covered"]
        cut = [p for p in after["plots"] if p["bottom"] > after["height"] + 1 and p["top"] < after["height"]]
        assert not any(p["drawn"] for p in cut), after


@pytest.fixture(scope="module")
def planets() -> tuple[str, str]:
    header, block = gears()
    channels = curves(block, [f"s{k}" for k in range(4)], [3.0, 0.0, 1.0, 2.0], "N")
    for k, channel in enumerate(channels):
        channel["group"] = {"name": "N[planets]", "label": "force, planets with sun", "planet": k + 1}
    header["channels"] = channels + curves(block, ["input"], [0.0], "m")
    header["spectra"] = header["maps"] = []
    return texts_of(header, block)


def test_planets_are_one_curve_or_one_each(open_page: OpenPage, planets: tuple[str, str]) -> None:
    """The group is the range of all four; apart they have numbers and different colours."""
    script = """
      const words = () => all(".ppv-plots .ppv-curve span").map((node) => node.textContent);
      const press = (text) => all(".ppv-caption button").find((node) => node.textContent === text).click();
      V.seek(0); V.draw();
      const out = {together: words(), channels: S().channels, reading: $(".ppv-caption output").textContent};
      press("apart"); V.draw();
      out.apart = words();
      out.colours = all(".ppv-curve i").map((node) => node.style.background);
      press("together");
      out.again = words();
      return out;
    """
    found = asked(scene(open_page, planets), script)
    long = "a quantity with long words, input"
    assert found["together"] == found["again"] == ["force, planets with sun", long]
    assert found["apart"] == [*(f"force, planet {k} with sun" for k in range(1, 5)), long]
    assert len(set(found["colours"][:4])) == 4
    low, high = (float(x.replace("\u2212", "-")) for x in found["reading"].split(" … "))
    at_start = np.array([3.0, 0.0, 1.0, 2.0]) + np.sin(np.arange(4))
    assert low == pytest.approx(at_start.min(), abs=0.02)
    assert high == pytest.approx(at_start.max() + 0.5, abs=0.02)


def test_the_list_of_channels_has_one_entry_for_all_planets(
    open_page: OpenPage, planets: tuple[str, str]
) -> None:
    script = """
      const options = () => all(".ppv-list [role=option]").map((node) => node.textContent);
      $(".ppv-picker input").focus();
      const out = [options()];
      $(".ppv-unfold").click();
      out.push(options(), $(".ppv-unfold").getAttribute("aria-expanded"), document.activeElement.className);
      all(".ppv-list [role=option]")[2].click();
      out.push(S().channels);
      return out;
    """
    closed, opened, expanded, focus, channels = asked(scene(open_page, planets), script)
    assert closed == ["force, planets with sun", "a quantity with long words, input"]
    assert opened == [closed[0], *(f"force, planet {k} with sun" for k in range(1, 5)), closed[1]]
    assert expanded == "true" and focus == "ppv-unfold", "the focus stays on the button"
    assert "N[s1]" in channels
