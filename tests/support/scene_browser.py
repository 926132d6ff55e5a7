# SPDX-License-Identifier: Apache-2.0
"""Asks pages with scenes what they show, in a headless browser that draws in software."""

from __future__ import annotations

import time
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from tests.support.browser import PATIENCE, OpenPage
from tests.support.scene_data import page_of

if TYPE_CHECKING:
    from playwright.sync_api import Frame, Page

HELPERS = """
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const until = async (holds) => { for (let k = 0; k < 600 && !holds(); k++) await wait(20); };
  const V = window.pitchpointViewer, S = () => V.state();
  const $ = (what) => document.querySelector(what), all = (what) => [...document.querySelectorAll(what)];
  const named = (text) => all(".ppv-tools button").find((b) => b.textContent === text);
"""
PAINTED = """
  // box of the solids in a part of the canvas, in parts of it: left, right, top, bottom
  const painted = (part = 0, parts = 1) => {
    for (const kind of ["mesh", "bearing", "pair"]) V.arrows(kind, false);
    V.lines(false); V.draw();
    const canvas = $(".ppv-canvas"), gl = canvas.getContext("webgl2"), {height} = canvas;
    const width = Math.floor(canvas.width / parts), all = new Uint8Array(4 * width * height);
    gl.readPixels(part * width, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, all);
    let [left, right, top, bottom] = [1, 0, 1, 0];
    for (let k = 0; k < width * height; k++) {
      if ([0, 1, 2].every((c) => Math.abs(all[4 * k + c] - all[c]) < 3)) continue;
      const x = (k % width) / width, y = 1 - (Math.floor(k / width) + 1) / height;
      left = Math.min(left, x); right = Math.max(right, x + 1 / width);
      top = Math.min(top, y); bottom = Math.max(bottom, y + 1 / height);
    }
    return [left, right, top, bottom];
  };
"""
STATES = "const out = []; for (const t of %s) { V.seek(t); V.draw(); out.push(S()); } return out;"


def asked(page: Page, script: str) -> Any:
    """What a script of the test returns.

    Parameters
    ----------
    page
        Open.
    script
        Body of an asynchronous function in JavaScript, with the helpers above.
    """
    return page.evaluate(f"async () => {{ {HELPERS} {{ {script} }} }}")


def until(frame: Page | Frame, condition: str) -> None:
    """Wait until something holds; Playwright's own way compiles text in the page, which the policy forbids.

    Parameters
    ----------
    frame
        A page, or a frame of one.
    condition
        In JavaScript.
    """
    end = time.monotonic() + PATIENCE / 1e3
    while not frame.evaluate(condition):
        assert time.monotonic() < end, f"still not: {condition}"
        time.sleep(0.02)


def scene(open_page: OpenPage, *texts: tuple[str, str], **how: Any) -> Page:
    """A page with one scene or two, which can be read.

    Parameters
    ----------
    open_page
        The fixture.
    *texts
        Header and numbers of each.
    **how
        `box` is the size of the viewer as CSS has it, the rest is for `open_page`.
    """
    box = {"size": how.pop("box")} if "box" in how else {}
    page = open_page(page_of(*texts, **box), **how)
    assert page.evaluate("mounted"), refusal(page)
    return page


def as_at_first(page: Page) -> None:
    """Undo what tests do to a scene by its functions and its keys, apart from the speed."""
    asked(
        page,
        """
        window.curvesAtFirst ??= S().channels;
        for (const name of S().channels) if (!curvesAtFirst.includes(name)) V.show(name, false);
        for (const name of curvesAtFirst) V.show(name);
        V.pause(); V.repeat("record"); V.follow(-1); V.magnify(1); V.seek(0); V.view("iso"); V.gauge(-1, 1);
        V.pattern("off"); V.shade("load"); V.lines();
        V.arrows("mesh"); V.arrows("bearing"); V.arrows("pair", false);
        if (S().mode >= 0) V.mode(-1);
        for (const key of S().section.on ? ["s", "Escape"] : ["Escape"])
          document.body.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true}));
        V.draw();
        """,
    )


def refusal(page: Page) -> str:
    """The sentence that stands where a scene cannot."""
    return str(page.text_content(".ppv-message"))


def refused(open_page: OpenPage, texts: Mapping[str, tuple[str, str]]) -> dict[str, str]:
    """The sentences in the place of scenes that cannot be read, which are tried one after the other.

    Parameters
    ----------
    open_page
        The fixture.
    texts
        Header and numbers of each, by any name.
    """
    page = open_page(page_of(*list(texts.values())[:1]))
    assert not page.evaluate("mounted")
    again = """([header, numbers]) => {
      document.getElementById("pp-scene").textContent = header;
      document.getElementById("pp-scene-numbers").textContent = numbers;
      return pitchpointViewer.mount(document.getElementById("view")); }"""
    return {name: refusal(page) for name, text in texts.items() if not page.evaluate(again, list(text))}


def matrix(elements: list[float]) -> np.ndarray:
    """A matrix of the viewer, which counts by columns."""
    return np.array(elements).reshape(4, 4).T


def about_z(angle: float) -> np.ndarray:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
