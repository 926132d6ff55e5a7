# SPDX-License-Identifier: Apache-2.0
"""The page of a diagnosis in a real browser: every plot is drawn, no text runs into another, all that can be
pressed has an effect, in light and dark, on a phone and on paper; it gives no information and asks for
nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest

from pitchpoint.cli.main import run_command
from tests.support.browser import Browsers, needs_browser, opening
from tests.support.report_browser import drawn
from tests.support.rig_records import rig_file
from tests.support.scene_browser import asked, until
from tests.support.walk import Walk

if TYPE_CHECKING:
    from playwright.sync_api import Page

pytestmark = needs_browser

TOOLS = {"Download plot as a PNG", "Zoom", "Pan", "Zoom in", "Zoom out", "Reset axes"}
PICTURES = ["spectrum", "orders", "sidebands", "mean turn", "envelope"]
COLOURS = "[$('.plot').layout.font.color, getComputedStyle(document.body).backgroundColor]"
LIGHT, DARK = ["#1f2933", "rgb(255, 255, 255)"], ["#e6e9ed", "rgb(20, 24, 29)"]


@pytest.fixture(scope="module")
def diagnosis(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A damaged tooth, two bearings that no record distinguishes, and another one."""
    folder = tmp_path_factory.mktemp("diagnosis")
    page = folder / "page.html"
    options = ["--train", "32/95", "--speed", "10Hz"]
    for bearing in (
        "left:8,7.94mm,33.5mm,0deg@2",
        "right:8,7.94mm,33.5mm,0deg@2",
        "fast:9,7.94mm,39mm,0deg@1",
    ):
        options += ["--bearing", bearing]
    assert run_command(["diagnose", rig_file(folder), *options, "-o", str(page), "-q"]) == 0
    return page.read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def wide(browsers: Browsers, diagnosis: str, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    """The page, open for several tests; at their end it has reported nothing and requested nothing."""
    with opening(browsers, tmp_path_factory.mktemp("wide")) as open_page:
        yield drawn(open_page, diagnosis, webgl=False, size=(1200, 900))


@pytest.fixture(scope="module")
def narrow(browsers: Browsers, diagnosis: str, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    """The same on a phone in the dark."""
    with opening(browsers, tmp_path_factory.mktemp("narrow")) as open_page:
        yield drawn(open_page, diagnosis, webgl=False, dark=True, size=(500, 900))


@pytest.mark.parametrize("size", ["wide", "narrow"])
def test_plots_are_drawn_and_their_texts_do_not_touch(size: str, request: pytest.FixtureRequest) -> None:
    script = f"""
      const bad = [];
      for (const node of document.querySelectorAll(".plot")) {{
        const name = node.layout.xaxis.title.text;
        if (!node.querySelectorAll(".scatterlayer path").length) bad.push("empty: " + name);
        const boxes = [...node.querySelectorAll(".annotation text, .legendtext, .xtick text")]
          .map((t) => [t.textContent, t.getBoundingClientRect()]);
        boxes.forEach(([a, p], i) => boxes.slice(i + 1).forEach(([b, q]) => {{
          const over = p.left < q.right && q.left < p.right && p.top < q.bottom - 1 && q.top < p.bottom - 1;
          if (over) bad.push(`${{name}}: ${{a}} on ${{b}}`);
        }}));
        const [title, box] = [node.querySelector(".ytitle"), node].map((e) => e.getBoundingClientRect());
        if (title.top < box.top || title.bottom > box.bottom) bad.push("cut: vertical title over " + name);
      }}
      const page = document.documentElement;
      if (page.scrollWidth > page.clientWidth) bad.push("wider than the page");
      return [bad, {COLOURS}];
    """
    bad, colours = asked(request.getfixturevalue(size), script)
    assert bad == []
    assert colours == (DARK if size == "narrow" else LIGHT)


def test_every_tool_of_a_plot_has_an_effect(wide: Page) -> None:
    """There is no other button, list or switch: tools of plots are alike, and those of one are tried."""
    script = (
        "return all('.modebar').map((bar) => [...bar.querySelectorAll('button')].map((b) => b.ariaLabel));"
    )
    tools = asked(wide, script)
    assert len(tools) == len(PICTURES) and all(set(bar) == TOOLS for bar in tools)
    walk = Walk(wide)
    assert walk.over("body", but=".modebar") == []
    wide.evaluate("document.querySelectorAll('.plot')[1].id = 'walked'")
    wide.locator("#walked").hover()
    walk.start = "Plotly.relayout('walked', {'xaxis.range': [1300, 1340]})"
    # zooming is on at first: it has an effect once something else is on, which the walk tries as well
    assert set(walk.over("#walked .modebar")) | {"Zoom"} == TOOLS
    assert [file.rpartition(".")[2] for file in walk.files] == ["png"]


def test_every_entry_of_a_legend_takes_its_lines_away_and_brings_them_back(wide: Page) -> None:
    """Bearings that are alike are one entry with one colour, which represents all their parts."""
    count = "document.querySelectorAll('.plot .scatterlayer .points path').length"
    # or every click waits for a second one, which would leave one entry alone
    wide.evaluate(
        "document.querySelectorAll('.plot').forEach((node) => (node._context.doubleClickDelay = 20))"
    )
    entries = wide.locator(".plot .legendtoggle")
    names = asked(wide, "return all('.plot .legendtext').map((text) => text.textContent);")
    assert names[-2:] == ["left or right", "fast"]
    assert len(names) == entries.count() >= 6
    for name, number in {name: number for number, name in enumerate(names)}.items():
        before = wide.evaluate(count)
        entries.nth(number).click()
        until(wide, f"{count} < {before}")
        lost = before - wide.evaluate(count)
        wide.wait_for_timeout(50)
        entries.nth(number).click()
        until(wide, f"{count} === {before}")
        # of four parts three harmonics each, but what lies beyond the axis
        assert lost >= (9 if name in names[-2:] else 1), name


def test_links_and_keys_reach_every_section(wide: Page) -> None:
    script = """
      const stops = all("a[href], button, input, select, summary, [tabindex='0']").filter((e) =>
        e.checkVisibility() && !e.disabled && e.tabIndex >= 0);
      const order = stops.map((e) => e.getAttribute("href"));
      return [order, all("main section").map((e) => "#" + e.id)];
    """
    order, sections = asked(wide, script)
    assert order[: 1 + len(sections)] == ["#content", *sections] and len(sections) >= 5
    for name in [*sections[1:], sections[0]]:
        top = f"document.querySelector('{name}').getBoundingClientRect().top"
        end = "innerHeight + scrollY >= document.documentElement.scrollHeight - 1"
        if name != sections[0]:
            wide.evaluate("scrollTo({top: 0, behavior: 'instant'})")
            assert wide.evaluate(f"{top} > 80")
        wide.locator(f"nav a[href='{name}']").click()
        until(wide, f"Math.abs({top}) < 80 || ({end} && {top} < innerHeight)")


def test_paper_is_white_and_holds_all_plots_and_tables(narrow: Page) -> None:
    """Printed from a dark screen: A4 less its margins is 182 mm."""
    assert asked(narrow, f"return {COLOURS};") == DARK
    script = """
      dispatchEvent(new Event("beforeprint"));
      const {clientWidth} = $("main");
      return {wide: clientWidth, cut: all("table, .plot svg.main-svg").filter((node) =>
          node.getBoundingClientRect().width > clientWidth + 1).length,
        ink: all(".plot").map((node) => node.layout.font.color), drawn: all(".plot .scatterlayer").length};
    """
    paper = asked(narrow, script)
    assert paper["wide"] == pytest.approx(182 / 25.4 * 96, abs=1)
    assert paper["cut"] == 0 and paper["drawn"] >= len(PICTURES)
    assert paper["ink"] == [LIGHT[0]] * len(PICTURES)
    narrow.evaluate("dispatchEvent(new Event('afterprint'))")
    assert asked(narrow, f"return {COLOURS};") == DARK
