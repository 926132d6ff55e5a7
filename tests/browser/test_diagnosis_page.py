# SPDX-License-Identifier: Apache-2.0
"""The page of a diagnosis in a real browser: every plot is drawn, no text runs into another."""

from __future__ import annotations

import pytest

from pitchpoint.cli.main import run_command
from tests.support.browser import OpenPage, needs_browser
from tests.support.report_browser import found
from tests.support.rig_records import rig_file

pytestmark = needs_browser


@pytest.fixture(scope="module")
def diagnosis(tmp_path_factory: pytest.TempPathFactory) -> str:
    folder = tmp_path_factory.mktemp("diagnosis")
    page = folder / "page.html"
    options = ["--train", "32/95", "--speed", "10Hz", "--bearing", "left:8,7.94mm,33.5mm,0deg@2"]
    assert run_command(["diagnose", rig_file(folder), *options, "-o", str(page), "-q"]) == 0
    return page.read_text(encoding="utf-8")


@pytest.mark.parametrize("width", [500, 1200])
def test_plots_are_drawn_and_their_texts_do_not_touch(
    diagnosis: str, open_page: OpenPage, width: int
) -> None:
    script = """
      const bad = [];
      for (const node of document.querySelectorAll(".plot")) {
        const name = node.layout.xaxis.title.text;
        if (!node.querySelectorAll(".scatterlayer path").length) bad.push("empty: " + name);
        const boxes = [...node.querySelectorAll(".annotation text, .legendtext, .xtick text")]
          .map((t) => [t.textContent, t.getBoundingClientRect()]);
        boxes.forEach(([a, p], i) => boxes.slice(i + 1).forEach(([b, q]) => {
          const over = p.left < q.right && q.left < p.right && p.top < q.bottom - 1 && q.top < p.bottom - 1;
          if (over) bad.push(`${name}: ${a} on ${b}`);
        }));
      }
      const page = document.documentElement;
      if (page.scrollWidth > page.clientWidth) bad.push("wider than the page");
      return bad;
    """
    assert found(open_page, diagnosis, script, webgl=False, size=(width, 900)) == []
