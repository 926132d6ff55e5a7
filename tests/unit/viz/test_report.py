# SPDX-License-Identifier: Apache-2.0
"""The report: one file, nothing loaded from outside, sections only where data are, always the same bytes."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from html.parser import HTMLParser
from typing import Any

import numpy as np
import pytest

from pitchpoint.viz.quantities import Channel
from pitchpoint.viz.report.build import (
    MeshCycleData,
    ReportModel,
    ReportResults,
    RollData,
    SceneData,
    TimeRun,
    report_html,
)
from pitchpoint.viz.report.cycles import mesh_cycle_section
from pitchpoint.viz.report.extremes import extreme_section
from pitchpoint.viz.tables import symbol_html
from tests.support.report_data import numbers_of, power, run

VOID = {"meta", "link", "br", "img", "input", "hr", "rect", "circle", "line", "path"}


class Page(HTMLParser):
    """Collects what the tests ask about and checks that tags are balanced."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.addresses: list[str] = []
        self.sections: list[str] = []
        self.ids: list[str] = []
        self.headings: list[str] = []
        self.figures: list[dict[str, object]] = []
        self._json = False
        self.feed(text)
        assert self.open == []
        assert len(set(self.ids)) == len(self.ids)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = dict(attrs)
        self.addresses += [str(found[k]) for k in ("src", "href", "data", "action") if found.get(k)]
        if tag == "section":
            self.sections.append(str(found["id"]))
        self.ids += [str(found["id"])] if "id" in found else []
        self._json = tag == "script" and found.get("type") == "application/json" and "id" not in found
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        pass

    def handle_endtag(self, tag: str) -> None:
        if tag not in VOID:
            assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if self._json:
            self.figures.append(json.loads(data))
        if self.open and self.open[-1] in ("h1", "h2"):
            self.headings.append(data)


@pytest.fixture(scope="module")
def text(model: ReportModel, results: ReportResults) -> str:
    return report_html(model, results)


def test_report_has_every_section(text: str) -> None:
    page = Page(text)
    first = "summary scene power time sweep cases spectra campbell modes cycle gears drawing"
    assert page.sections == [*first.split(), "extremes", "provenance", "notes"]
    assert page.headings[0] == "Pair <50/50> & its resonance"
    assert len(page.figures) >= 15


def test_report_is_self_contained(text: str) -> None:
    page = Page(text)
    assert page.addresses
    assert all(a.startswith("#") for a in page.addresses)
    assert "default-src 'none'" in text
    assert text.count("Licensed under the MIT license") == 1


def test_every_figure_has_data_and_titles_with_units(text: str) -> None:
    for figure in Page(text).figures:
        layout = figure["layout"]
        assert figure["data"]
        assert isinstance(layout, dict)
        for axis in ("xaxis", "yaxis"):
            title = layout[axis]["title"]["text"]
            assert "[" in title
            assert title.endswith("]")


def test_same_input_same_text_and_no_date(model: ReportModel, results: ReportResults, text: str) -> None:
    assert report_html(model, results) == text
    assert len(text.encode()) < 4e6


def test_orders_refer_to_the_shaft_of_gear_1_and_offer_the_others(model: ReportModel) -> None:
    steady = run(1800.0, 1800.0, 0.2)
    angle = steady["angle[driver]"]
    data = {
        "time": steady["time"],
        "angle[a_fixed]": type(angle)("angle[a_fixed]", 0.0 * angle.values, "rad"),
        **steady,
        "angle[rattling]": type(angle)("angle[rattling]", angle.values**2, "rad"),
    }
    results = ReportResults(runs={"r": TimeRun(data=data)})
    for shafts, chosen in (({"stage": "driver"}, "driver"), ({"stage": "driven"}, "driven"), ({}, "driver")):
        figures: list[Any] = Page(report_html(replace(model, shafts=shafts), results)).figures
        offers = [f["layout"]["meta"]["orders"] for f in figures if "orders" in f["layout"].get("meta", {})]
        assert len(offers) == 2
        for offer in offers:
            assert offer["shaft"] == chosen
            assert set(offer["speeds"]) == {"driver", "driven"}
            assert offer["speeds"]["driven"] / offer["speeds"]["driver"] == pytest.approx(-0.5)


def test_only_gears_gives_only_gears() -> None:
    text = report_html(
        ReportModel(title="bare", gears={"g": {"z": 17, "m_n": 0.003}}, date="2026-11-21"), ReportResults()
    )
    page = Page(text)
    assert page.sections == ["gears"]  # no empty head of anything else
    assert page.figures == []
    assert "plotly.js (" not in text
    assert "2026-11-21" in text
    assert "normal module" in text


def test_text_of_users_is_escaped(text: str) -> None:
    assert "<brackets>" not in text
    assert "&lt;brackets&gt;" in text


def test_contact_and_statistics_appear(text: str) -> None:
    assert "maximum contact loss" in text
    assert "rms (alternating)" in text
    assert "Jumps: up at 2350, down at 1750 Hz mesh frequency." in text


def test_sweep_without_contact_loss_says_so(model: ReportModel) -> None:
    points = [
        {"direction": "up", "mesh_frequency": f, "deflection": {"rms": 1e-6}, "contact_loss_share": 0.0}
        for f in (100.0, 200.0, 300.0)
    ]
    text = report_html(
        model, ReportResults(sweeps={"s": {"points": points, "jumps": []}, "none": {"points": []}})
    )
    assert "The flanks of the swept mesh stay in contact at every point of this sweep." in text
    assert "No jump found" in text


def test_short_uneven_and_standing_runs(model: ReportModel) -> None:
    """A record of an adaptive solver, one that stopped early, and a shaft that turns back."""
    data = run(1800.0, 1800.0, 0.02)
    uneven = {k: v for k, v in data.items() if k == "time"}
    uneven["time"] = data["time"] * (1.0 + 0.1 * data["time"])
    rest = {k: v for k, v in data.items() if k in ("deflection[stage]", "contact_state[stage]")}
    swinging = dict(data)
    angle = data["angle[driver]"]
    swinging["angle[driver]"] = type(angle)(angle.name, np.sin(400.0 * data["time"]), "rad", "angle")

    def begin(n: int) -> dict:
        """The first samples of the run."""
        return {k: (v[:n] if k == "time" else type(v)(v.name, v.values[:n], v.unit)) for k, v in data.items()}

    results = ReportResults(
        runs={
            "uneven": TimeRun(data=uneven | rest, note="stopped: <the step became too small>"),
            "swinging": TimeRun(data=swinging),
            **{f"{n} samples": TimeRun(data=begin(n)) for n in (1, 2, 3)},
            "empty": TimeRun(data={"time": np.empty(0)}),
        }
    )
    text = report_html(model, results)
    Page(text)
    assert "stopped: &lt;the step became too small&gt;" in text
    assert "reverses" in text
    assert "<h3>2 samples</h3>" in text


@pytest.mark.parametrize(
    ("symbol", "html"),
    [
        ("m_n", "m<sub>n</sub>"),
        ("x₁ + x₂", "x<sub>1</sub> + x<sub>2</sub>"),
        ("ε_α", "ε<sub>α</sub>"),
        ("", ""),
    ],
)
def test_symbols(symbol: str, html: str) -> None:
    assert symbol_html(symbol) == html


def test_a_failed_case_says_what_happened(text: str) -> None:
    assert "<td>a force became &lt;infinite&gt; at t = 0.004 s</td>" in text


@pytest.mark.parametrize(
    ("cycles", "repeats", "words", "end"),
    [
        (1, 1, "two mesh cycles.", 2.0),
        (3, 3, "three mesh cycles, after which it repeats.", 3.0),
        (12, 57, "the first 12 of 57 mesh cycles, after which it repeats.", 12.0),
        (1, 0, "one mesh cycle; no repetition within this range.", 1.0),
    ],
)
def test_a_roll_is_drawn_as_far_as_it_is_known(cycles: int, repeats: int, words: str, end: float) -> None:
    phase = np.linspace(0.0, cycles, 10 * cycles + 1)
    data = MeshCycleData(error_phase=phase, errors={"loaded": 1e-6 * phase}, cycles=cycles, repeats=repeats)
    page = Page("".join(mesh_cycle_section({"m": data}).parts))
    figure: Any = page.figures[0]
    assert plotted(figure["data"][0], "x")[-1] == pytest.approx(end)
    assert words in mesh_cycle_section({"m": data}).parts[-1]


def test_a_given_roll_has_a_section_with_all_its_periods(model: ReportModel) -> None:
    periods = np.linspace(0.0, 40.0, 401)
    curves = {"m": (periods, {"without load": 1e-6 * np.sin(periods), "mesh force 5 N": 0.0 * periods})}
    text = report_html(
        model, ReportResults(rolls={"r": RollData(curves=curves, mesh="m", note="It stopped.")})
    )
    page = Page(text)
    assert "roll" in page.sections
    assert "It stopped." in text
    assert "over 40 rolled periods; peak to peak 2 µm without load, 0 µm at a mesh force of 5 N." in text


def plotted(trace: Any, letter: str) -> Any:
    """Numbers of a trace as the script of a page reads them."""
    return trace[letter] if isinstance(trace.get(letter), list) else numbers_of(trace, letter)


def test_what_a_table_of_channels_leaves_out_is_said(model: ReportModel) -> None:
    data = run(1800.0, 1800.0, 0.05)
    channel = type(data["angle[driver]"])
    zeros = {f"friction_power[{k}]": channel(f"friction_power[{k}]", 0.0 * data["time"], "W") for k in "abc"}
    text = report_html(model, ReportResults(runs={"r": TimeRun(data=data | zeros)}))
    assert "Not listed, but in the result: 3 channels zero throughout and 3 channels of other" in text


def test_maps_of_a_run_up_show_all_of_it(model: ReportModel) -> None:
    """Statistics begin after settling; maps show the start too."""
    meshes = {"mesh of the stage": 500.0}
    runs = {"r": TimeRun(data=run(500.0, 3000.0, 0.5), settle_time=0.1, mesh_frequencies=meshes)}
    figures: list[Any] = Page(report_html(model, ReportResults(runs=runs))).figures
    maps = [f for f in figures if f["data"][0]["type"] == "heatmap"]
    over_time = [f for f in maps if f["layout"]["xaxis"]["title"]["text"] == "time [ms]"]
    assert over_time
    for figure in maps:
        assert "mesh of the stage" in [a["text"] for a in figure["layout"]["annotations"]]
    for figure in over_time:
        x = plotted(figure["data"][0], "x")
        assert 0.0 <= x[0] < 10.0
        assert 470.0 < x[-1] < 500.0


def test_the_summary_says_how_every_result_ended(text: str) -> None:
    assert '<p class="alert" role="note">run-up is not complete: failed: a force &lt;x&gt;.</p>' in text
    summary = text[text.index('id="summary"') : text.index('id="scene"')]
    rows = {
        row.partition("</th>")[0].rpartition(">")[2]: [c.rpartition(">")[2] for c in row.split("</td>")[:-1]]
        for row in summary.split('<tr><th scope="row">')[1:]
    }
    assert rows["status"] == ["finished", "failed: a force &lt;x&gt;"]
    assert rows["input power"] == ["1000 W", "–"]
    assert rows["losses"] == ["14 W", "–"]
    # the peak is that of the points of the sweep: 40 µm at 1000 Hz over the frequency, from 1.75 kHz on
    up, down = summary.split('<tr><th scope="row">sweep</th>')[1:]
    assert "16.67 µm at 2400 Hz, 2880 rpm" in up and "2350 Hz" in up
    assert "22.22 µm at 1800 Hz, 2160 rpm" in down and "0 to 40 %" in down
    assert "2 of 3 finished" in summary


def test_power_closes_and_is_drawn(text: str) -> None:
    """1000 W in, 984 W out, 14 W lost: 2 W are left, a five-hundredth of the largest power."""
    flow = power()
    assert (flow.put_in, flow.taken_out, flow.lost, flow.remainder) == (1000.0, 984.0, 14.0, 2.0)
    assert "input 1000 W, output 984 W, losses 14 W; remainder 2 W, 0.2 % of the largest power." in text
    assert "Largest remainder of a block: 1 W, three." in text
    section = text[text.index('<section id="power"') : text.index('<section id="time"')]
    drawn = [float(w) for w in re.findall(r"V(-?[\d.]+)", section)]
    assert section.count('class="pp-band"') == 5 == len(drawn)
    assert section.count('class="pp-block"') == 3
    # as the table has it, without a sign
    assert ">9 W lost<" in section and "−9 W" not in section
    assert "No power flow of run-up: it is &lt;not&gt; known." in section


def extremes(sizes: dict[str, float], seen: str = "") -> str:
    """Section about channels that swing once between plus and minus their size [m]."""
    time = np.linspace(0.0, 1.0, 101)
    data: dict[str, Any] = {"time": time}
    data |= {n: Channel(n, size * np.sin(2 * np.pi * time), "m") for n, size in sizes.items()}
    return "".join(extreme_section({"r": TimeRun(data=data)}, seen).parts)


def test_extremes_of_one_unit_share_it_and_tell_when() -> None:
    text = extremes({"deflection[a]": 9e-5, "deflection[b]": 2e-4}, seen="r")
    assert text.count(">µm<") == 2
    assert "−90<" in text
    moments = [float(t) for t in re.findall(r'data-time="([\d.]+)"', text)]
    assert moments == pytest.approx([0.75, 0.25] * 2)
    assert "data-time" not in extremes({"deflection[a]": 9e-5})


def test_rows_beyond_thirty_fold_away() -> None:
    text = extremes({f"deflection[{k}]": 9e-5 for k in range(41)})
    assert text.count("<tr>") == 41 + 2
    assert "<summary>11 more channels</summary>" in text


def test_without_a_scene_a_sentence_stands_in_its_place(model: ReportModel) -> None:
    text = report_html(model, ReportResults(scene=SceneData(words="There is no scene: no <shapes>.")))
    assert "<p>There is no scene: no &lt;shapes&gt;.</p>" in text
    assert "pp-scene" not in text


def test_torques_of_inputs_and_outputs_are_those_of_their_channels(model: ReportModel) -> None:
    """Means over all steps with the sign of the channel, not power over speed."""
    data = run(1800.0, 1800.0, 0.05)
    channel = type(data["angle[driver]"])
    mean = {"mean": -9.87, "rms": 0.0, "min": -9.9, "max": -9.8}
    torque = channel("torque[motor]", -9.9 + 0.0 * data["time"], "N m", statistics=mean)
    results = ReportResults(runs={"r": TimeRun(data=data | {"torque[motor]": torque})}, powers={"r": power()})
    text = report_html(model, results)
    assert "motor: 954.9 rpm, −9.87 N m, 1000 W" in text
    assert "brake: −477.5 rpm, 984 W" in text
