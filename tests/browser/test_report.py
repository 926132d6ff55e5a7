# SPDX-License-Identifier: Apache-2.0
"""The report in a real browser: every plot is drawn, scene and curves share their time, nothing is asked of a
network, nothing overflows on a phone or on paper, and it works by keys, in the dark and without WebGL.

One run of the browser answers the questions of several tests.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from pitchpoint.viz.report.build import report_html
from tests.support.browser import Browsers, needs_browser, opening
from tests.support.report_browser import drawn, found
from tests.support.report_data import report_model, report_results
from tests.support.scene_browser import asked
from tests.support.walk import Walk

pytestmark = needs_browser

TOOLS = ["Download plot as a PNG", "Zoom", "Pan", "Zoom in", "Zoom out", "Reset axes"]


@pytest.fixture(scope="module")
def report() -> str:
    return report_html(report_model(), report_results())


WIDE = """
  const drawn = all(".plot.js-plotly-plot").length;
  const empty = all(".plot").filter((node) =>
    !node.querySelectorAll(".scatterlayer path, .heatmaplayer image").length).length;
  const asked = performance.getEntriesByType("resource").map((e) => e.name)
    .filter((name) => !/^(data|blob):/.test(name));
  const colours = [$(".plot").layout.font.color, getComputedStyle(document.body).backgroundColor];

  // the scene moves the cursor of the curves of its run, at the place where their axis has that time
  const lines = () => all(".linked .plot .now").filter((line) => !line.hidden);
  pitchpointViewer.seek(0.15);
  const [line] = lines(), node = line.parentNode;
  const at = () => {
    const box = node.querySelector(".nsewdrag").getBoundingClientRect();
    const share = (line.getBoundingClientRect().left + 0.75 - box.left) / box.width;
    const [a, b] = node.layout.xaxis.range;
    return [a + share * (b - a), node.layout.xaxis.title.text];
  };
  const cursor = at(), others = all(".plot:not(.linked *) .now").length;
  // a click into a curve moves the scene, a drag does not
  const box = node.querySelector(".nsewdrag").getBoundingClientRect();
  const press = (kind, x) => node.dispatchEvent(new PointerEvent(kind, {bubbles: true, clientX: x,
    clientY: box.top + 20}));
  press("pointerdown", box.left + 0.25 * box.width); press("pointerup", box.left + 0.25 * box.width);
  const clicked = pitchpointViewer.state().time, [a, b] = node.layout.xaxis.range;
  press("pointerdown", box.left + 0.5 * box.width); press("pointerup", box.left + 0.6 * box.width);
  const dragged = pitchpointViewer.state().time;
  const button = $(".when"), wanted = Number(button.dataset.time);
  button.click();
  const sought = pitchpointViewer.state().time;

  // paper: everything folded is open, the scene is a picture, no table is wider than the page
  dispatchEvent(new Event("beforeprint"));
  const still = $("#pp-still").src.slice(0, 22), folded = all("details:not([open])").length;
  const image = new Image(), pen = document.createElement("canvas").getContext("2d");
  image.src = $("#pp-still").src;
  await image.decode();
  pen.drawImage(image, 0, 0);
  const corner = [...pen.getImageData(2, 2, 1, 1).data];
  const paper = $("main").clientWidth;
  const cut = all("table").filter((table) => table.getBoundingClientRect().width > paper + 1).length;
  dispatchEvent(new Event("afterprint"));

  // keys: the skip link comes first, every link of the bar leads to a section, what has the focus shows it
  const stops = all("a[href], button, input, select, summary, [tabindex='0']").filter((e) =>
    e.checkVisibility() && !e.disabled && e.tabIndex >= 0);
  stops[0].focus({focusVisible: true});
  const shown = getComputedStyle(stops[0]).outlineStyle, place = stops[0].getBoundingClientRect().left;
  const order = stops.slice(0, 3).map((e) => e.getAttribute("href"));
  const lost = all("nav a, .skip").filter((link) => !$(link.getAttribute("href"))).length;
  const nameless = stops.filter((e) => !(e.textContent.trim() || e.title || e.labels?.length
    || e.ariaLabel)).length;
  const {ready} = document.documentElement.dataset, count = all(".plot").length;

  // plots below each other are aligned; a band with the mean becomes samples when zoomed
  const timed = all(".plot").filter((plot) => plot.layout?.meta?.clock), groups = {};
  for (const plot of timed) {
    const {left} = plot.getBoundingClientRect(), section = plot.closest("section").id;
    (groups[[section, plot.layout.xaxis.title.text, Math.round(left)]] ??= []).push(plot._fullLayout._size.l);
  }
  const uneven = Math.max(...Object.values(groups).map((edges) => Math.max(...edges) - Math.min(...edges)));
  const dense = timed.find((plot) => /^#.{8}$/.test(plot.data[0].fillcolor));
  const drawnLine = () => dense.data.find((trace) => trace.mode === "lines" && !trace.fill);
  const [from, to] = dense._fullLayout.xaxis.range, coarse = drawnLine().x.length;
  const near = [from + 0.5 * (to - from), from + 0.501 * (to - from)];
  await Plotly.relayout(dense, {"xaxis.range": near});
  const zoomed = [...drawnLine().x].filter((t) => near[0] <= t && t <= near[1]).length;
  return {drawn, count, ready, empty, asked, colours, cursor, others,
    clicked, expected: (a + 0.25 * (b - a)) / node.layout.meta.clock, dragged, wanted, sought,
    still, corner, folded, paper, cut, shown, place, order, lost, nameless,
    uneven, coarse, zoomed};
"""


@pytest.fixture(scope="module")
def wide(browsers: Browsers, report: str, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    with opening(browsers, tmp_path_factory.mktemp("wide")) as open_page:
        answer: dict[str, Any] = found(open_page, report, WIDE, size=(1280, 900))
    return answer


def test_every_plot_is_drawn_and_none_is_empty(wide: dict[str, Any], report: str) -> None:
    assert wide["count"] == wide["drawn"] == int(wide["ready"]) == report.count('<div class="plot"') > 15
    assert wide["empty"] == 0


def test_plots_below_each_other_are_aligned(wide: dict[str, Any]) -> None:
    assert wide["uneven"] < 1.5


def test_zooming_shows_the_samples(wide: dict[str, Any]) -> None:
    """A line of one point per pixel at first; then of a thousandth of the record."""
    assert 200 < wide["coarse"] < 2000
    assert wide["zoomed"] >= 8


def test_nothing_is_asked_of_a_network(wide: dict[str, Any]) -> None:
    """The policy of the page forbids it; `found` sees that the policy had nothing to forbid."""
    assert wide["asked"] == []


def test_scene_and_curves_share_their_time(wide: dict[str, Any]) -> None:
    assert wide["cursor"][1] == "time [ms]"
    assert wide["cursor"][0] == pytest.approx(150.0, abs=0.3)  # a pixel of 700
    assert wide["others"] == 0  # the run-up is not in the scene
    assert wide["clicked"] == pytest.approx(wide["expected"], abs=1e-4)
    assert wide["dragged"] == wide["clicked"]
    assert wide["sought"] == pytest.approx(wide["wanted"], abs=1e-9)


def test_paper_gets_a_picture_of_the_scene_and_all_tables(wide: dict[str, Any]) -> None:
    assert wide["still"] == "data:image/png;base64,"
    assert wide["corner"] == [255, 255, 255, 255]  # paper, not the grey or black of a screen
    assert wide["folded"] == wide["cut"] == 0
    assert wide["paper"] == pytest.approx(182 / 25.4 * 96, abs=1)  # A4 less its margins


def test_keys_reach_everything(wide: dict[str, Any]) -> None:
    assert wide["order"][:2] == ["#content", "#summary"]
    assert wide["shown"] != "none" and wide["place"] >= 0.0  # the skip link comes into view
    assert wide["lost"] == wide["nameless"] == 0


@pytest.fixture(scope="module")
def narrow(browsers: Browsers, report: str, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """The report without WebGL, on a phone in the dark."""
    with opening(browsers, tmp_path_factory.mktemp("narrow")) as open_page:
        yield drawn(open_page, report, webgl=False, dark=True, size=(500, 900))


def test_a_narrow_page_in_the_dark_without_webgl(narrow: Any, wide: dict[str, Any]) -> None:
    script = """
      const page = document.documentElement;
      all(".shaft option").forEach((option) => (option.textContent = "a_shaft_of_a_long_name_".repeat(5)));
      return {choices: all(".shaft option").length,
        over: page.scrollWidth - page.clientWidth, said: $(".ppv-message")?.textContent,
        colours: [$(".plot").layout.font.color, getComputedStyle(document.body).backgroundColor],
        drawn: all(".plot.js-plotly-plot").length};
    """
    told = asked(narrow, script)
    assert told["choices"] > 0 and told["over"] <= 0
    assert "WebGL 2 is not available" in told["said"]
    assert told["drawn"] == wide["drawn"]
    assert wide["colours"] == ["#1f2933", "rgb(255, 255, 255)"]
    assert told["colours"] == ["#e6e9ed", "rgb(20, 24, 29)"]


def test_reader_chooses_whose_orders_a_picture_shows(narrow: Any) -> None:
    """The driven shaft turns half as fast in these data: orders double, speeds halve, titles follow."""
    script = """
      const look = (node) => [node._fullData[0].x[10], node.layout.xaxis.range[1],
        (node.layout.annotations || []).map((a) => Number(a.text))[0] || 0, node._fullData[0].y[3]];
      const said = [];
      for (const select of all(".shaft select")) {
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
      return said;
    """
    title = "order of driven [–]"
    said = asked(narrow, script)
    assert said == [f"{title} 2.00 2.00 2.00 1.00"] * 2 + [f"{title} 2.00 2.00 - 0.50"] * 2


def test_every_control_has_an_effect(narrow: Any) -> None:
    """Without WebGL, the scene has tests of its own. Tools of plots are alike; none leads out of the page."""
    walk = Walk(narrow, "pitchpointViewer.seek(0)")
    found = walk.over("main", but=".ppv, .modebar")
    assert sum(name.startswith("show the scene at") for name in found) >= 8
    assert sum(name.startswith("orders of") for name in found) == 4
    labels = "(bar) => [...bar.querySelectorAll('button')].map((b) => b.ariaLabel)"
    tools = asked(narrow, f"return all('.modebar').map({labels});")
    assert len(tools) > 15 and all(bar == TOOLS for bar in tools)
    narrow.evaluate("document.querySelector('#time .plot').id = 'first'")
    narrow.locator("#first").hover()
    walk.start = "Plotly.relayout('first', {'xaxis.range': [20, 60]})"
    assert sorted(walk.over("#first .modebar")) == sorted(TOOLS)
    assert [file.rpartition(".")[2] for file in walk.files] == ["png"]
