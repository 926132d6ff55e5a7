# SPDX-License-Identifier: Apache-2.0
"""Spectra in a real browser: over frequencies, over orders and over time, tied to the time of the scene."""

from __future__ import annotations

import numpy as np
import pytest

from tests.support.browser import OpenPage, needs_browser
from tests.support.scene_browser import asked, scene
from tests.support.scene_data import LENGTH, TEETH, gears, passing, texts_of

pytestmark = needs_browser
FORCE = "circumferential_force[stage_1]"


@pytest.fixture(scope="module")
def pair() -> tuple[str, str]:
    return texts_of(*gears())


def test_the_spectrum_around_the_cursor_is_the_piece_of_the_map_that_it_stands_in(
    open_page: OpenPage, pair: tuple[str, str]
) -> None:
    """Levels are decibels: 255 is the largest amplitude, 1 kN, and 255/80 of them are one decibel.

    Amplitudes are in the unit that the channel is shown in, kN.
    """
    times, levels = passing()
    script = f"""V.spectrum("{FORCE}", "orders of pinion"); const out = [];
      for (const t of {times[[0, 7, 19]].tolist()}) {{ V.seek(t); await wait(50); out.push(S().spectrum); }}
      return out;"""
    found = asked(scene(open_page, pair), script)
    for piece, state in zip((0, 7, 19), found, strict=True):
        assert state["ways"] == ["frequency", "orders of pinion", "orders of pinion and time"]
        near = np.array([value or 0.0 for value in state["near"]])
        assert np.flatnonzero(near).tolist() == [TEETH[0] - 1]
        level = levels[piece, TEETH[0] - 1]
        assert near.max() == pytest.approx(10 ** ((level / 255 - 1) * 4), rel=1e-9)


def test_a_map_moves_the_time_and_the_time_the_cursor_of_the_map(
    open_page: OpenPage, pair: tuple[str, str]
) -> None:
    """Both ways; half-way across the picture is half-way through the record."""
    script = f"""V.spectrum("{FORCE}", "orders of pinion and time"); V.seek({0.3 * LENGTH}); await wait(100);
      const before = S().spectrum.maps[0].cursor;
      const over = $(".ppv-maps .u-over"), box = over.getBoundingClientRect();
      over.setPointerCapture = () => {{}};
      const at = {{clientX: box.left + box.width / 2, clientY: box.top + 9, bubbles: true, button: 0}};
      over.dispatchEvent(new PointerEvent("pointermove", at));
      const read = $(".ppv-spectra output").textContent;
      over.dispatchEvent(new PointerEvent("pointerdown", at));
      await wait(100);
      return [before, S().time, S().spectrum.maps[0].cursor, read];"""
    before, time, after, read = asked(scene(open_page, pair), script)
    assert before == pytest.approx(0.3 * LENGTH, abs=0.01 * LENGTH)
    assert time == pytest.approx(0.5 * LENGTH, abs=0.01 * LENGTH)
    assert after == pytest.approx(time, abs=0.01 * LENGTH)
    assert "order 38" in read and "< 0.000100 kN" in read


def test_choices_keep_the_kind_of_picture(open_page: OpenPage, pair: tuple[str, str]) -> None:
    """By the two lists of the page; the picture is painted, not empty."""
    script = f"""V.spectrum("{FORCE}"); const out = [S().spectrum.over];
      const list = document.querySelectorAll(".ppv-spectra select")[1];
      list.value = "orders of pinion and time"; list.dispatchEvent(new Event("change")); await wait(100);
      out.push(S().spectrum.over);
      const canvas = $(".ppv-maps canvas"), ink = canvas.getContext("2d");
      const {{data}} = ink.getImageData(0, 0, canvas.width, canvas.height);
      const colours = new Set();
      for (let k = 0; k < data.length; k += 4) colours.add(data[k] * 65536 + data[k + 1] * 256 + data[k + 2]);
      out.push(colours.size);
      document.querySelector(".ppv-bar > button").click();
      V.spectrum("a channel without spectrum");
      out.push(S().spectrum); return out;"""
    first, second, colours, closed = asked(scene(open_page, pair), script)
    assert (first, second, closed) == ("frequency", "orders of pinion and time", None)
    assert colours > 20


def test_amplitudes_may_begin_just_below_a_power_of_ten(open_page: OpenPage) -> None:
    """9.7e-5 kN at the lower end: the ticks continue beyond 1e-4 and the line is painted."""
    header, block = gears()
    amplitude = np.geomspace(0.097, 900.0, 400)
    header["spectra"][0]["amplitude"] = block.put(amplitude)
    script = f"""V.spectrum("{FORCE}", "frequency"); await wait(100);
      const canvas = $(".ppv-spectra canvas"), ink = canvas.getContext("2d"), {{width, height}} = canvas;
      const {{data}} = ink.getImageData(0, 0, width, height);
      let painted = 0;
      for (let k = 0; k < data.length; k += 4) painted += data[k + 3] > 0 && data[k] - data[k + 2] > 100;
      return painted;"""
    assert asked(scene(open_page, texts_of(header, block)), script) > 300
