# SPDX-License-Identifier: Apache-2.0
"""Everything that can be pressed in a scene has an effect: buttons, ticks, sliders, lists, keys and gestures.

The test knows no names: it finds what there is. Who adds a button without effect, a key that is not told in
the list of keys, or a gesture that no one tries, fails here.
"""

from __future__ import annotations

import copy
import string
from typing import Any

import numpy as np
import pytest

from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import asked, scene, until
from tests.support.scene_contact_data import touching
from tests.support.scene_data import Block, box, gears, texts_of
from tests.support.walk import Walk

pytestmark = needs_browser

START = "V = pitchpointViewer, V.pause(), V.seek(0.0501), V.look([0.05, 0.01, 0.02], [1, 2, 3], 0.5)"
SMALL = {"box": "640px;height:560px", "size": (640, 560)}
SILENT = {"=", "Escape"}
"""Keys in addition to those of the list: plus without shift, and what closes a panel everywhere."""
NAMED = {"space": " ", "←": "ArrowLeft", "→": "ArrowRight", "−": "-"}
GESTURES = {"drag", "wheel", "double click"}


def light(header: dict[str, Any], block: Block) -> tuple[dict[str, Any], Block]:
    """The same scene with boxes in the place of gears and shafts, which are drawn ten times as fast."""
    for solid in header["solids"]:
        solid.pop("blend", None)
        wide = 0.012 if solid["kind"] == "shaft" else 0.04
        points, triangles = box([-wide, -wide, -0.02], [wide, wide, 0.02 + wide])
        solid.update(points=block.put(points, "f4"), triangles=block.put(triangles, "u4"))
    return header, block


def test_every_control_has_an_effect(open_page: OpenPage) -> None:
    """Two meshes and a part that is schematic give every panel something to say."""
    header, block = light(*touching())
    header["contacts"].append({**copy.deepcopy(header["contacts"][0]), "name": "stage_2"})
    header["solids"][3]["schematic"] = True
    page = scene(open_page, texts_of(header, block), **SMALL)
    walk = Walk(page, START)
    found = {"time": walk.over(".ppv-time")}
    page.evaluate("V.follow(1)")
    for button in page.locator(".ppv-tools button").all():
        name = button.text_content()
        # the view of a mesh has cut what other panels control
        page.evaluate("V.section(null)")
        assert walk.changes(button.click, button), name
        found[name] = walk.over(".ppv-panel:not([hidden])")
    found["curves"] = walk.over(".ppv-curves")
    assert [name for name in found if not found[name]] == ["Fit", "Notes (1)"], "those have nothing to press"
    assert sum(map(len, found.values())) >= 50
    endings = [file.rpartition(".")[2] for file in walk.files]
    assert [ending for ending in endings if ending != "mp4"] == ["png", "png", "glb", "stl"]
    assert endings.count("mp4") in (1, 2), "a recording that ends just before stop is pressed starts again"


def test_every_key_is_told_and_has_an_effect(open_page: OpenPage) -> None:
    """Nine bodies, so that every digit has one; a key that does nothing is left to the browser."""
    header, block = light(*gears())
    header["bodies"] += [{**header["bodies"][0], "name": f"b{k}"} for k in range(6)]
    del header["modes"]
    page = scene(open_page, texts_of(header, block), **SMALL)
    walk = Walk(page)
    page.click(".ppv-tools button:last-child")
    page.evaluate("document.activeElement.blur()")
    told = set(asked(page, "return all('.ppv-panel dt').flatMap((dt) => dt.innerText.split(/, /));"))
    page.keyboard.press("Escape")
    assert told > GESTURES
    words = [word for text in told - GESTURES for word in text.split(" ")]
    if "…" in words:
        words += [str(k) for k in range(int(words[words.index("…") - 1]), int(words[words.index("…") + 1]))]
    listed = {NAMED.get(word, word) for word in words} - {"…"}
    page.evaluate("addEventListener('keydown', (event) => { window.taken = event.defaultPrevented; })")
    taken = set()
    for key in (
        *string.printable[1:95],
        "0",
        *"ArrowLeft ArrowRight ArrowUp ArrowDown Home End Escape Enter".split(),
    ):
        page.evaluate(START)
        if key == "Escape":
            page.click(".ppv-tools button:last-child")
            page.evaluate("document.activeElement.blur()")
        if key in listed | SILENT:
            assert walk.changes(lambda key=key: page.keyboard.press(key)), key
        else:
            page.keyboard.press(key)
        if page.evaluate("taken"):
            taken.add(key)
    assert taken == listed | SILENT
    page.keyboard.press("Control+s")
    assert not page.evaluate("taken"), "keys of the browser stay with it"


def test_gestures_turn_shift_and_zoom(open_page: OpenPage) -> None:
    page = scene(open_page, texts_of(*gears()), **SMALL)
    page.evaluate(f"{START}, V.view('axis'), V.draw()")
    area = page.locator(".ppv-canvas").bounding_box()
    middle = (area["x"] + 0.5 * area["width"], area["y"] + 0.5 * area["height"])

    def camera() -> dict[str, Any]:
        page.evaluate("V.draw()")
        return dict(page.evaluate("V.state().camera"))

    def drag(button: str, *keys: str) -> None:
        for key in keys:
            page.keyboard.down(key)
        page.mouse.move(*middle)
        page.mouse.down(button=button)
        page.mouse.move(middle[0] + 60, middle[1] + 30, steps=3)
        page.mouse.up(button=button)
        for key in keys:
            page.keyboard.up(key)

    first = camera()
    drag("left")
    turned = camera()
    assert turned["target"] == pytest.approx(first["target"]) and turned["position"] != first["position"]
    assert turned["distance"] == pytest.approx(first["distance"])
    for how in (("right",), ("left", "Shift")):
        before = camera()
        drag(*how)
        after = camera()
        # the way of the target is square to the view, as long as the way of the pointer
        way = np.subtract(after["target"], before["target"])
        view = np.subtract(before["position"], before["target"])
        assert np.linalg.norm(way) > 0 and abs(way @ view) < 1e-6 * np.linalg.norm(way) * np.linalg.norm(view)
    page.mouse.move(*middle)
    before = camera()
    page.mouse.wheel(0, 300)
    until(page, f"V.draw(), V.state().camera.distance > {1.05 * before['distance']}")
    page.evaluate("V.view('axis'), V.look([0.144, 0, 0], [0, 0, 1], 0.3), V.draw()")
    page.mouse.dblclick(*middle)
    assert page.evaluate("V.state().following") in (1, 2), "the wheel, or its end of the shaft, is there"
