# SPDX-License-Identifier: Apache-2.0
"""The scene in a real browser: what it draws is what the numbers say, at any time and by any key."""

from __future__ import annotations

import base64
import json
from typing import Any

import numpy as np
import pytest

from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import STATES, about_z, asked, matrix, refused, scene
from tests.support.scene_data import (
    DISTANCE,
    FORCE,
    LENGTH,
    SHAKE,
    SPEED,
    TEETH,
    TIMES,
    VIEWER,
    batch,
    gears,
    load,
    texts_of,
)

pytestmark = needs_browser


@pytest.fixture(scope="module")
def pair() -> tuple[str, str]:
    return texts_of(*gears())


def test_bodies_are_where_the_numbers_put_them(same_scene: OpenPage, pair: tuple[str, str]) -> None:
    """At a frame, and half-way between two: angles and displacements are straight lines there."""
    times = [float(TIMES[210]), float(0.5 * (TIMES[333] + TIMES[334]))]
    script = STATES % times
    found = asked(same_scene(pair), script)
    for t, state in zip(times, found, strict=True):
        assert state["time"] == t and state["message"] is None
        pinion, wheel, end = map(matrix, state["pictures"][0]["bodies"])
        wave = np.sin(2 * np.pi * 200.0 * TIMES)
        shake = SHAKE * np.interp(t, TIMES, wave)
        spin = np.interp(t, TIMES, 1e-4 * np.cos(2 * np.pi * 300 * TIMES))
        # 16 bits of a range of 1e-5 m and 2e-4 rad: half a level
        assert np.abs(wheel[:3, 3] - [DISTANCE, shake, 0.0]).max() < 1e-5 / 65535
        assert np.abs(end[:3, 3] - [DISTANCE, -2 * shake, 0.12]).max() < 2e-5 / 65535
        assert np.abs(pinion[:3, :3] - about_z(SPEED * t + spin)).max() < 2e-4 / 65535
        assert np.abs(wheel[:3, :3] - about_z(-SPEED * t * TEETH[0] / TEETH[1])).max() < 1e-12


def test_magnified_vibrations_leave_the_turning_alone(same_scene: OpenPage, pair: tuple[str, str]) -> None:
    t = float(TIMES[213])
    script = f"V.seek({t}); V.magnify(500); V.draw(); return S();"
    picture = asked(same_scene(pair), script)["pictures"][0]
    pinion, wheel, _ = map(matrix, picture["bodies"])
    wave = SHAKE * np.sin(2 * np.pi * 200.0 * TIMES)
    spin = 1e-4 * np.cos(2 * np.pi * 300 * TIMES)
    level = 500 * np.array([1e-5, 2e-4]) / 65535
    assert picture["magnification"] == 500
    assert abs(wheel[1, 3] - (wave.mean() + 500 * (wave[213] - wave.mean()))) < level[0]
    angle = SPEED * t + spin.mean() + 500 * (spin[213] - spin.mean())
    assert np.abs(pinion[:3, :3] - about_z(angle)).max() < level[1]
    assert np.abs(wheel[:3, :3] - about_z(-SPEED * t * TEETH[0] / TEETH[1])).max() < 1e-12


def test_arrows_follow_the_force(same_scene: OpenPage, pair: tuple[str, str]) -> None:
    times = [float(TIMES[k]) for k in (0, 60, 300, 450, 540)]
    script = STATES % times
    longest = []
    for t, state in zip(times, asked(same_scene(pair), script), strict=True):
        mesh, bearing = state["pictures"][0]["arrows"]
        share = float(load(np.array(t)))
        expected = {"circumferential": [0, 1, 0], "radial": [-1, 0, 0], "axial": [0, 0, 1]}
        for part, axis in expected.items():
            vector = FORCE[part] * share * np.array(axis)
            assert np.abs(mesh["vectors"][part] - vector).max() <= FORCE[part] / 65535
            assert np.abs(bearing["vectors"][part] + 0.5 * vector).max() <= FORCE[part] / 65535
        assert mesh["state"] == (0 if share == 0 else -1 if t < LENGTH / 10 else 1)
        assert mesh["at"] == pytest.approx([TEETH[0] * 2e-3, 0, 0], abs=1e-8)
        # the bearing's arrow hangs on the place at rest, which does not shake
        assert bearing["at"] == pytest.approx([DISTANCE, 0, 0.12], abs=1e-12)
        lengths = mesh["lengths"]
        longest.append(lengths["circumferential"])
        if share:
            assert lengths["circumferential"] / lengths["radial"] == pytest.approx(4000 / 1456, rel=1e-4)
            assert lengths["circumferential"] / bearing["lengths"]["circumferential"] == pytest.approx(
                2, rel=1e-4
            )
    assert longest[-1] == 0 and np.diff(longest[:-1]).min() > 0


def test_arrows_are_painted_as_long_as_the_force(same_scene: OpenPage, pair: tuple[str, str]) -> None:
    """Pixels that change when arrows are hidden: along y the circumferential force, along -x the radial."""
    times = [float(TIMES[k]) for k in (60, 300, 450, 540)]
    script = """
      const canvas = $(".ppv-canvas"), gl = canvas.getContext("webgl2"), {width, height} = canvas;
      const paint = () => { V.draw(); const all = new Uint8Array(4 * width * height);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, all); return all; };
      V.arrows("bearing", false); V.look([0.048, 0, 0], [0, 0, 1], %g);
      const out = [];
      for (const t of %s) {
        V.seek(t);
        V.arrows("mesh", false); const bare = paint();
        V.arrows("mesh", true); const full = paint();
        const boxes = {};
        for (let k = 0; k < full.length; k += 4) {
          if (full[k] === bare[k] && full[k + 1] === bare[k + 1] && full[k + 2] === bare[k + 2]) continue;
          const [r, g, b] = full.subarray(k, k + 3);
          const name = r > 1.5 * g ? "circumferential" : b > 1.3 * g && b > 2 * r ? "radial" : "other";
          const x = (k / 4) %% width - width / 2, y = Math.floor(k / 4 / width) - height / 2;
          const box = (boxes[name] ??= {left: x, right: x, low: y, high: y});
          box.left = Math.min(box.left, x); box.right = Math.max(box.right, x);
          box.low = Math.min(box.low, y); box.high = Math.max(box.high, y);
        }
        out.push({boxes, lengths: S().pictures[0].arrows[0].lengths});
      }
      return {out, height};
    """
    seen = 0.25
    found = asked(same_scene(pair), script % (seen, times))
    ends = []
    for t, one in zip(times, found["out"], strict=True):
        if not load(np.array(t)):
            assert set(one["boxes"]) == {"other"}, "nothing but the ball that says: no contact"
            continue
        up, out = one["boxes"]["circumferential"], one["boxes"]["radial"]
        thick = (up["right"] - up["left"] + 1, out["high"] - out["low"] + 1)
        painted = {"circumferential": up["high"] + 1, "radial": -out["left"]}
        for (part, end), wide in zip(painted.items(), thick, strict=True):
            length = one["lengths"][part] / seen * found["height"]
            # the head is 0.3 of the length; its point is thinner than a pixel
            assert -1 < length - end < 1 + 0.3 * length / wide
        ends.append(painted["circumferential"] / float(load(np.array(t))))
    assert ends == pytest.approx(3 * [np.mean(ends)], rel=0.05), "a point of 2 in 40 pixels"


def test_legend_says_what_the_arrows_are_worth(same_scene: OpenPage, pair: tuple[str, str]) -> None:
    script = """
      V.seek(0.06); V.draw();
      const rows = [...document.querySelectorAll(".ppv-legend tbody tr")].map((row) =>
        row.innerText.split("\\t"));
      named("Forces").click();
      $(".ppv-panel input[type=checkbox]").click(); V.draw();
      const hidden = document.querySelector(".ppv-legend tbody tr").hidden;
      return {rows, hidden, lengths: S().pictures[0].arrows.map((a) => a.lengths.circumferential),
        state: $(".ppv-state").title, colour: getComputedStyle($(".ppv-radial i")).backgroundColor};
    """
    found = asked(same_scene(pair), script)
    share = float(load(np.array(0.06)))
    values = found["rows"][0]
    assert values[0].strip() == "stage_1" and found["state"] == "front flank"
    for text, full in zip(values[1:], FORCE.values(), strict=True):
        assert text == f"{full * share / 1e3:.3f}\u2009kN"
    assert found["hidden"] and found["lengths"][0] == 0 < found["lengths"][1]
    assert found["colour"] == "rgb(0, 114, 178)"


def test_loops_last_one_turn_or_one_mesh_cycle(same_scene: OpenPage, pair: tuple[str, str]) -> None:
    script = """
      const out = [];
      V.seek(0.01);
      for (const what of ["turn", "cycle"]) { const wrong = V.repeat(what);
      out.push([wrong, ...S().window]); }
      V.follow(1); const wrong = V.repeat("cycle"); out.push([wrong, ...S().window]);
      V.play(); for (let k = 0; k < 5; k++) { V.advance(0.02); out.push(S().time); }
      return out;
    """
    turn, cycle, wheel, *later = asked(same_scene(pair), script)
    # the pinion's deviation of 1e-4 rad shifts the end of its turn
    assert turn[0] == "" and turn[2] - turn[1] == pytest.approx(2 * np.pi / SPEED, abs=2.1e-4 / SPEED)
    assert cycle[2] - cycle[1] == pytest.approx(2 * np.pi / TEETH[0] / SPEED, abs=2.1e-4 / SPEED)
    assert wheel[2] - wheel[1] == pytest.approx(2 * np.pi / TEETH[0] / SPEED, rel=1e-9)
    assert all(wheel[1] <= t <= wheel[2] for t in later) and len(set(later)) > 1


def test_nothing_is_drawn_while_nothing_changes(same_scene: OpenPage, pair: tuple[str, str]) -> None:
    """Neither while thirty pictures go by, nor in a while after them."""
    script = """
      const pictures = async (n) => { for (; n; n--) await new Promise(requestAnimationFrame); };
      await pictures(10); const n = S().drawn; await pictures(30); await wait(500); return [n, S().drawn];
    """
    before, after = asked(same_scene(pair), script)
    assert 0 < before == after


def test_followed_body_stays_where_it_is(open_page: OpenPage, pair: tuple[str, str]) -> None:
    """In the eye of the camera the wheel neither moves nor, if requested, turns; the pinion does."""
    script = """
      const look = (t) => { V.seek(t); V.draw(); return S(); };
      V.magnify(1000); V.follow(1);
      const a = look(0.0111), b = look(0.0777);
      named("View").click(); $(".ppv-panel input[type=checkbox]").click();
      return [[a, b], [look(0.0111), look(0.0777)]];
    """
    moved, turned = asked(scene(open_page, pair), script)

    def seen(state: dict[str, Any], body: int) -> np.ndarray:
        picture = state["pictures"][0]
        return matrix(picture["seen"]) @ matrix(picture["bodies"][body])

    assert np.abs(seen(moved[0], 1)[:3, 3] - seen(moved[1], 1)[:3, 3]).max() < 1e-12
    assert np.abs(seen(moved[0], 1) - seen(moved[1], 1)).max() > 0.1
    assert np.abs(seen(turned[0], 1) - seen(turned[1], 1)).max() < 1e-12
    assert np.abs(seen(turned[0], 0) - seen(turned[1], 0)).max() > 0.1


def test_without_webgl_a_sentence_stands_there_and_curves_work(
    open_page: OpenPage, pair: tuple[str, str]
) -> None:
    page = scene(open_page, pair, webgl=False)
    page.evaluate("pitchpointViewer.seek(0.05)")
    page.keyboard.press("ArrowRight")
    state = asked(page, "return S();")
    assert "WebGL 2 is not available" in state["message"] and state["drawn"] == 0
    assert [c["at"] for c in state["cursor"]] == pytest.approx(2 * [0.0502], abs=LENGTH / 900)


def damaged(header: dict[str, Any], block: Any, how: str) -> tuple[str, str]:
    text, numbers = texts_of(header, block)
    if how == "no base64":
        return text, numbers[:-9] + "*&"
    if how == "short gzip":
        return text, base64.b64encode(base64.b64decode(numbers)[:-4000]).decode()
    if how == "short header":
        return text[: len(text) // 2], numbers
    if how == "array beyond the end":
        return text.replace('"points": {"at": ', '"points": {"at": 88'), numbers
    if how == "unknown type":
        return text.replace('"type": "f4"', '"type": "f2"'), numbers
    if how == "no solids":
        return json.dumps({**header, "solids": []}), numbers
    return text.replace("pitchpoint-scene-2", "pitchpoint-scene-9"), numbers


def test_damaged_scenes_are_refused_in_a_sentence(open_page: OpenPage) -> None:
    says = {
        "no base64": "not base64",
        "short gzip": "truncated",
        "short header": "header of this scene cannot be read",
        "array beyond the end": "beyond the end of the data",
        "unknown type": "unknown type or shape",
        "unknown format": 'format "pitchpoint-scene-9"',
    }
    said = refused(open_page, {how: damaged(*gears(), how) for how in says})
    assert all(says[how] in said[how] and said[how].endswith(".") for how in says), said


def test_scene_without_solids_still_has_curves(open_page: OpenPage) -> None:
    state = asked(scene(open_page, damaged(*gears(), "no solids")), "return S();")
    assert "no solids" in state["message"] and len(state["cursor"]) == 2


def test_thousands_of_bodies_move(open_page: OpenPage) -> None:
    script = "V.draw(); V.seek(0.5); V.draw(); return S();"
    state = asked(scene(open_page, texts_of(*batch(5000))), script)
    picture = state["pictures"][0]
    assert len(picture["bodies"]) == 5000 and picture["batches"] == 1 and state["drawn"] >= 2
    assert np.abs(matrix(picture["bodies"][4999])[:3, :3] - about_z(3.0)).max() < 1e-9


def test_script_brings_its_licences_and_ends_no_element() -> None:
    text = VIEWER.read_text(encoding="utf-8")
    assert len(text) < 750_000
    head = text[:4000]
    assert (
        "SPDX-License-Identifier: Apache-2.0" in head
        and "three.js authors" in head
        and "Leon Sorokin" in head
    )
    assert "</script" not in text.lower() and "<!--" not in text
