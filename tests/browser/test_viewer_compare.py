# SPDX-License-Identifier: Apache-2.0
"""Two results side by side: each fits its picture, both turn together, follow by name, share a clock."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import PAINTED, asked, matrix, scene
from tests.support.scene_data import LENGTH, SPEED, TEETH, TIMES, Array, batch, gears, texts_of

pytestmark = needs_browser


@pytest.fixture(scope="module")
def pair() -> tuple[str, str]:
    return texts_of(*gears())


def sampled(times: Array) -> tuple[str, str]:
    """The same gears, at other instants: they turn, and nothing else."""
    header, block = gears(title="Sampled")
    gross = block.put(SPEED * times)
    for body in header["bodies"]:
        body.pop("spin", None), body.pop("position", None)
        body["gross"] = gross
    header |= {"arrows": [], "marks": [], "channels": [], "spectra": [], "maps": []}
    return texts_of(header | {"times": block.put(times)}, block)


def test_machines_of_other_sizes_fit_each_its_picture(open_page: OpenPage, pair: tuple[str, str]) -> None:
    """Gears of 0.3 m beside boxes of 3 m; alike ones are seen from one place, so that sizes are compared."""
    script = f"""{PAINTED}
      const out = [];
      for (const view of ["axis", "iso"]) {{
        V.view(view); V.draw();
        out.push([S().pictures.map((picture) => picture.factor), [0, 1].map((half) => painted(half, 2))]);
      }}
      const scales = all(".ppv-scale");
      return [out, scales.map((scale) => !scale.hidden), scales.map((scale) => scale.textContent)];
    """
    views, shown, sizes = asked(scene(open_page, pair, texts_of(*batch(64))), script)
    for factors, halves in views:
        assert factors[0] == 1 and 8 < factors[1] < 25
        for left, right, top, bottom in halves:
            assert 0 < left < right < 1 and 0 < top < bottom < 1
            assert max(right - left, bottom - top) > 0.5
    assert shown == [True, True] and sizes[0] != sizes[1]
    other = texts_of(*gears(title="Another", share=0.5))
    alike, shown, _ = asked(scene(open_page, pair, other), script)
    assert [factors for factors, _ in alike] == [[1, 1], [1, 1]] and shown == [True, False]


def test_both_pictures_follow_the_body_of_the_name(open_page: OpenPage, pair: tuple[str, str]) -> None:
    """In the second the names of pinion and wheel have changed places, and one body is called otherwise."""
    header, block = gears(title="Renamed")
    for body, name in zip(header["bodies"], ("wheel", "pinion", "far_end"), strict=True):
        body["name"] = name
    script = """
      const look = (t) => { V.seek(t); V.draw(); return S().pictures; };
      named("View").click(); $(".ppv-panel input[type=checkbox]").click();
      const names = [...$(".ppv-panel select").options].map((option) => option.textContent);
      const out = [];
      for (const body of [0, 3]) { V.follow(body); out.push([look(0.0111), look(0.0777)]); }
      V.follow(-1);
      return [names, out, look(0.02)];
    """
    names, ((before, after), (early, late)), free = asked(
        scene(open_page, pair, texts_of(header, block)), script
    )
    assert names == ["none", "pinion", "wheel", "wheel_end", "far_end"]

    def seen(picture: dict[str, Any], body: int) -> Array:
        return np.asarray(matrix(picture["seen"]) @ matrix(picture["bodies"][body]))

    for k, (followed, other) in enumerate(((0, 1), (1, 0))):
        assert np.abs(seen(before[k], followed) - seen(after[k], followed)).max() < 1e-12
        assert np.abs(seen(before[k], other) - seen(after[k], other)).max() > 0.1
        # what is followed is shown in the middle
        middle = seen(after[k], followed)[:3, 3]
        assert np.abs(middle - after[k]["target"]).max() < 1e-3
    assert np.abs(seen(early[1], 2) - seen(late[1], 2)).max() < 1e-12
    assert np.array_equal(matrix(early[0]["seen"]), matrix(late[0]["seen"])), "the first has no far end"
    assert all(np.array_equal(matrix(picture["seen"]), np.eye(4)) for picture in free)


def test_steps_are_frames_of_the_finer_record_and_say_so(open_page: OpenPage, pair: tuple[str, str]) -> None:
    """0.2 ms beside 0.7 ms that lie in between and continue for half as long again: no step is shorter."""
    coarse = np.arange(0.1e-3, 1.5 * LENGTH, 0.7e-3)
    script = f"""
      const press = (title) => all(".ppv-transport button").find((b) => b.title.startsWith(title)).click();
      const out = [];
      V.seek(0.03);
      for (let k = 0; k < 3; k++) {{ press("One frame forward"); out.push(S().time); }}
      const clock = $(".ppv-now").textContent, says = all(".ppv-transport button").map((b) => b.title);
      V.seek({LENGTH}); const on = () => {{ press("One frame forward"); out.push(S().time); }}; on(); on();
      V.seek(0.01); const wrong = V.repeat("turn");
      named("Notes (2)").click();
      return {{out, clock, says, wrong, window: S().window, note: $(".ppv-notes").textContent}};
    """
    found = asked(scene(open_page, pair, sampled(coarse)), script)
    beyond = coarse[coarse > LENGTH + 1e-4][:2]
    assert found["out"] == pytest.approx([*TIMES[151:154], *beyond], abs=1e-12)
    assert found["clock"] == "30.60\u2009ms"
    assert [t for t in found["says"] if t.startswith("One frame")] == [
        f"One frame {way}, 200\u2009µs, the frame interval of Two gears"
        for way in ("back (left arrow)", "forward (right arrow)")
    ]
    assert "the frames of Sampled, every 700\u2009µs, are interpolated linearly" in found["note"]
    # a turn of the pinion, whichever record the clock counts by
    window = found["window"]
    assert found["wrong"] == "" and window[1] - window[0] == pytest.approx(2 * np.pi / SPEED, rel=1e-3)
    assert TEETH[0] < TEETH[1]


def test_records_of_the_same_frames_say_nothing_of_them(open_page: OpenPage, pair: tuple[str, str]) -> None:
    script = """const titles = all(".ppv-transport button").map((b) => b.title).join();
      return [titles, named("Notes (1)") !== undefined];"""
    titles, one = asked(scene(open_page, pair, texts_of(*gears(title="Again"))), script)
    assert "as the frames" not in titles and one
