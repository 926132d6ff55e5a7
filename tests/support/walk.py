# SPDX-License-Identifier: Apache-2.0
"""A walk over all that a reader can press in a page, whatever it is called: each must change something else.

The walk compares what the reader sees besides the control itself: pixels of the scene and of its plots,
texts, the state that the viewer tells, and files that arrive. A control that has no effect at first, like the
place of a cut that is not there yet, has another try after all others of its panel.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from tests.support.scene_browser import HELPERS

if TYPE_CHECKING:
    from playwright.sync_api import Locator, Page

WORDS, PIXELS = 0.4, 1.5
"""How long an effect may take to be told, and to be painted when nothing is told [s]."""
TWO_FRAMES = "for (let k = 0; k < 2; k++) await new Promise(requestAnimationFrame);"
CONTROLS = "button, select, summary, input"
LAST = "Close"
"""It takes the others away."""
SUM = """const sum = (text) => {
  let n = 7; for (const c of text) n = (Math.imul(n, 31) + c.charCodeAt()) | 0; return n; };"""
TOLD = f"""(control) => {{ {HELPERS} {SUM}
  const own = (node) => control && ((control.closest("label") || control).contains(node)
    || control.title && node.title === control.title);
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), words = [];
  while (texts.nextNode()) {{
    const {{parentElement, data}} = texts.currentNode;
    const drawn = parentElement instanceof SVGElement;
    const stands = drawn || parentElement.checkVisibility({{visibilityProperty: true}});
    if (data.trim() && stands && !own(parentElement)) words.push(data);
  }}
  const on = all(".active, [aria-pressed=true], [aria-expanded=true]").filter((node) => !own(node));
  const state = V?.state() ? {{...V.state(), drawn: 0, frame: 0}} : null;
  return sum(JSON.stringify([words.join("|"), on.map((node) => node.ariaLabel), state, scrollY]));
}}"""
"""Texts and numbers, without those of the control itself."""
SEEN = f"""() => {{ {HELPERS} {SUM}
  if (V?.state()) V.draw();
  const canvases = all("canvas").filter((canvas) => canvas.checkVisibility() && canvas.width);
  return sum(canvases.map((canvas) => canvas.toDataURL()).join());
}}"""
"""Pixels of the scene and of its plots."""
NAMES = f"""([area, but]) => {{ {HELPERS}
  const count = {{}}, names = [];
  for (const each of all(area).flatMap((node) => [...node.querySelectorAll("{CONTROLS}")])) {{
    if (!each.checkVisibility({{visibilityProperty: true}}) || each.disabled) continue;
    if (but && each.closest(but)) continue;
    const {{walk}} = each.dataset;
    const name = walk ?? (each.ariaLabel || each.title || each.closest("label")?.innerText || each.innerText);
    each.dataset.walk = name.trim().split("\\n")[0].trim();
    count[each.dataset.walk] = (count[each.dataset.walk] ?? 0) + 1;
    const number = count[each.dataset.walk];
    names.push(each.dataset.place = each.dataset.walk + (number > 1 ? " " + number : ""));
  }}
  return names;
}}"""
"""Of all that can be pressed; a name stays when the words on a button change."""


class Walk:
    """Presses one control after the other.

    Parameters
    ----------
    page
        Open, with all that it shows.
    start
        JavaScript that brings the page to where every control has something to do.
    """

    def __init__(self, page: Page, start: str = "0") -> None:
        self.page, self.start = page, start
        self.files: list[str] = []
        page.on("download", lambda file: self.files.append(file.suggested_filename))

    def over(self, area: str, but: str = "") -> list[str]:
        """Names of all controls in an area, pressed until each has had an effect.

        Parameters
        ----------
        area
            CSS selector of what is walked over; what appears in it meanwhile belongs to it.
        but
            CSS selector of what is left out.
        """
        done: list[str] = []
        lame: list[str] = []
        while fresh := [name for name in self._names(area, but) if name not in (*done, *lame, LAST)]:
            (done if self._works(area, fresh[0]) else lame).append(fresh[0])
        for _ in range(2):
            lame = [name for name in lame if not self._works(area, name)]
        if LAST in self._names(area, but) and not self._works(area, LAST):
            lame.append(LAST)
        assert not lame, f"without effect: {lame}"
        return done

    def changes(
        self, act: Callable[[], Any], control: Locator | None = None, undo: Callable[[], Any] = bool
    ) -> bool:
        """Whether something is different soon after an act.

        Parameters
        ----------
        act
            What the reader does.
        control
            Where; its own looks do not count.
        undo
            What has to be done before the same act has the same effect again.
        """
        files, told = len(self.files), self._told(control)
        act()
        if self._soon(lambda: len(self.files) > files or self._told(control) != told, WORDS):
            return True
        undo()
        self.begin()
        seen = self.page.evaluate(SEEN)
        act()
        return self._soon(lambda: self.page.evaluate(SEEN) != seen, PIXELS)

    def begin(self) -> None:
        """Where every control has something to do, and all of that is drawn."""
        self.page.evaluate(f"async () => {{ {self.start}; {TWO_FRAMES} }}")

    def _soon(self, holds: Callable[[], bool], patience: float) -> bool:
        end = time.monotonic() + patience
        while not (there := holds()) and time.monotonic() < end:
            self.page.wait_for_timeout(20)
        return there

    def _told(self, control: Locator | None) -> str:
        """Nothing once the control has gone."""
        if control is None:
            return str(self.page.evaluate(TOLD))
        return str(control.evaluate(TOLD)) if control.count() else ""

    def _names(self, area: str, but: str) -> list[str]:
        """What can be pressed there now, by name and number among those of its name."""
        return list(self.page.evaluate(NAMES, [area, but]))

    def _works(self, area: str, name: str) -> bool:
        """Whether all that a control can do has an effect."""
        control = self.page.locator(f"{area} [data-place={json.dumps(name, ensure_ascii=False)}]").first
        self.begin()
        tag, kind = control.evaluate("(node) => [node.localName, node.type]")
        if tag == "select":
            return self._choices(control)
        if kind == "range":
            return self.changes(lambda: control.press("End"), control)
        if kind == "search":
            return self.changes(control.focus, control)
        words, works = control.text_content(), self.changes(control.click, control)
        if not control.count():
            return works
        # what is a switch, by its tick or by its words, has two ways, and stays on
        again = not control.is_checked() if kind == "checkbox" else control.text_content() != words
        return works and (not again or self.changes(control.click, control))

    def _choices(self, control: Locator) -> bool:
        """Whether every choice makes a difference to the one before it."""
        options = "(node) => [...node.options].filter((o) => !o.hidden).map((o) => o.value)"
        values, now = control.evaluate(options), control.input_value()
        first = values.index(now)
        ring = values[first:] + values[: first + 1]
        choose = control.select_option
        works = [
            self.changes(lambda new=new: choose(new), control, lambda old=old: choose(old))
            for old, new in pairwise(ring)
        ]
        return all(works)
