# SPDX-License-Identifier: Apache-2.0
"""The report in a real browser: every plot is drawn, nothing fails, nothing overflows on a phone."""

from __future__ import annotations

import html
import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from pitchpoint.viz.report import report_html
from tests.support.chromium import BROWSER, chromium, window
from tests.support.report_data import report_model, report_results

pytestmark = pytest.mark.skipif(
    BROWSER is None, reason="no Chromium on this machine; install chromium to run it"
)


def in_browser(page: Path, _: Path, *flags: str) -> str:
    """The document after its scripts have run; flags are those of the window."""
    show = chromium("--disable-gpu").show
    return str(show(page, "document.documentElement.outerHTML", budget=20_000, wait=True, **window(*flags)))


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    page = tmp_path_factory.mktemp("report") / "report.html"
    page.write_text(report_html(report_model(), report_results()), encoding="utf-8")
    return page


@pytest.fixture(scope="module")
def drawn(report: Path) -> Iterator[Callable[[str], str]]:
    """What a script finds in the report on a phone, which is drawn once."""
    with chromium("--disable-gpu").opened(report, budget=20_000, size=(500, 900)) as value_of:
        yield lambda script: str(value_of(f"(() => {{ {script} }})()"))


def with_probe(report: Path, script: str) -> Path:
    """The report with a script of the test at its end."""
    text = report.read_text(encoding="utf-8")
    page = report.with_name("probed.html")
    page.write_text(
        text.replace("</body>", f"<pre id='found'></pre><script>{script}</script></body>"), encoding="utf-8"
    )
    return page


def found(dom: str) -> str:
    match = re.search(r"<pre id=['\"]found['\"]>(.*?)</pre>", dom, re.DOTALL)
    assert match
    return html.unescape(match.group(1))


def test_every_plot_is_drawn(report: Path, drawn: Callable[[str], str]) -> None:
    dom = drawn("return document.documentElement.outerHTML;")
    expected = report.read_text(encoding="utf-8").count('<div class="plot"')
    assert re.search(r'data-ready="(\d+)"', dom).group(1) == str(expected)  # type: ignore[union-attr]
    assert len(re.findall(r'class="plot js-plotly-plot"', dom)) == expected


def test_no_plot_is_empty_and_nothing_is_wider_than_the_page(drawn: Callable[[str], str]) -> None:
    script = """
      const bad = [];
      for (const node of document.querySelectorAll(".plot")) {
        const marks = node.querySelectorAll(".scatterlayer path, .heatmaplayer image").length;
        if (!marks) bad.push("empty: " + node.layout.yaxis.title.text);
      }
      const page = document.documentElement;
      const over = page.scrollWidth - page.clientWidth;
      if (over > 0) bad.push("wider than the page by " + over);
      return bad.join("; ") || "fine";
    """
    assert drawn(script) == "fine"


def test_dark_mode_has_light_ink(report: Path, drawn: Callable[[str], str]) -> None:
    ink = 'document.querySelector(".plot").layout.font.color'
    script = f'{ink} + " " + getComputedStyle(document.body).backgroundColor'
    assert drawn(f"return {script};") == "#1f2933 rgb(255, 255, 255)"
    dark = chromium("--disable-gpu").show(report, script, budget=20_000, wait=True, dark=True)
    assert dark == "#e6e9ed rgb(20, 24, 29)"


def test_reader_chooses_whose_orders_a_picture_shows(drawn: Callable[[str], str]) -> None:
    """The driven shaft turns half as fast in these data: orders double, speeds halve, titles follow."""
    script = """
      const look = (node) => [node._fullData[0].x[10], node.layout.xaxis.range[1],
        (node.layout.annotations || []).map((a) => Number(a.text))[0] || 0, node._fullData[0].y[3]];
      const said = [];
      for (const select of document.querySelectorAll(".shaft select")) {
        const node = select.parentNode.nextElementSibling;
        const before = look(node);
        select.value = "driven";
        select.dispatchEvent(new Event("change"));
        const ratio = look(node).map((v, k) => (before[k] ? (v / before[k]).toFixed(2) : "-"));
        said.push(node.layout.xaxis.title.text + " " + ratio.join(" "));
        select.value = "driver";
        select.dispatchEvent(new Event("change"));
        if (String(look(node)) !== String(before)) said.push("not back");
      }
      return said.join("; ");
    """
    said = drawn(script).split("; ")
    title = "order [per revolution of driven]"
    assert said == [f"{title} 2.00 2.00 2.00 1.00"] * 2 + [f"{title} 2.00 2.00 - 0.50"] * 2
