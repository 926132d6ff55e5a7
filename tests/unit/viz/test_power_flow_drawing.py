# SPDX-License-Identifier: Apache-2.0
"""Drawings of power flows: places of blocks, bands and names."""

from __future__ import annotations

import re

import numpy as np
import pytest

from pitchpoint.viz.power_flow import OUTSIDE, PowerBlock, PowerFlow, PowerLink
from pitchpoint.viz.power_flow_drawing import power_flow_svg
from pitchpoint.viz.report.power import power_section
from tests.support.report_data import power


def test_blocks_stand_behind_what_feeds_them_and_apart() -> None:
    svg = power_flow_svg(power())
    found = re.findall(r'pp-block" rx="5" x="([\d.]+)" y="([\d.]+)" width="\d+" height="([\d.]+)"', svg)
    (x1, *_), (x2, *_), (x3, *_) = ([float(v) for v in row] for row in found)
    assert x1 < x2 < x3  # the third is fed by both others
    assert power_flow_svg(PowerFlow(span=(0.0, 1.0), blocks=[], links=[])) == ""
    circle = [
        PowerLink(name=n, kind="mesh", start=a, end=1 - a, given=1.0, taken=1.0) for a, n in enumerate("ab")
    ]
    blocks = [PowerBlock(name=n, speed=1.0) for n in "xy"]
    assert power_flow_svg(PowerFlow(span=(0.0, 1.0), blocks=blocks, links=circle)).count("pp-band") == 3


def test_bands_that_come_together_are_named_apart() -> None:
    """Three planets on one carrier: each power stands by its planet, over all bands."""
    blocks = [PowerBlock(name=n, speed=1.0) for n in ("sun", "p1", "p2", "p3", "carrier")]
    links = [
        PowerLink(name=name, kind=kind, start=a, end=b, given=given, taken=given)
        for k, given in ((1, 7000.0), (2, 7100.0), (3, 7200.0))
        for name, kind, a, b in ((f"s{k}", "mesh", 0, k), (f"p{k} on carrier", "carrier", k, 4))
    ]
    svg = power_flow_svg(PowerFlow(span=(0.0, 1.0), blocks=blocks, links=links))
    at = re.findall(r'<text class="pp-small" x="([\d.]+)" y="([\d.]+)" text-anchor="start">(7\d00) W', svg)
    assert len(at) == 3 and len({x for x, _, _ in at}) == 1
    assert np.diff(sorted(float(y) for _, y, _ in at)).min() > 28.0  # two lines
    assert "on carrier" not in svg and svg.rindex('class="pp-band"') < svg.index('class="pp-small"')


def link(name: str, start: int, end: int, given: float) -> PowerLink:
    kind = "load" if OUTSIDE in (start, end) else "mesh"
    return PowerLink(
        name=name,
        kind=kind,
        start=start,
        end=end,
        given=given,
        taken=0.98 * given,
        losses={"f": 0.02 * given},
    )


FLOWS = {
    "parallel": (2, [link("in", OUTSIDE, 0, 900.0), *(link(f"mesh_{k}", 0, 1, 300.0) for k in range(3))]),
    "crossing": (
        4,
        [link("ad", 0, 3, 400.0), link("ac", 0, 2, 100.0), link("bc", 1, 2, 450.0), link("bd", 1, 3, 50.0)],
    ),
    "circulating": (
        3,
        [link("forth", 0, 1, 1e3), link("on", 1, 2, 900.0), link("back_long_name", 2, 0, 880.0)],
    ),
}


@pytest.mark.parametrize("case", FLOWS)
def test_no_label_covers_another_one_or_a_block_or_leaves_the_drawing(case: str) -> None:
    """Letters of 14 px are about 7 px wide: narrower than the estimate of the drawing itself."""
    count, links = FLOWS[case]
    blocks = [PowerBlock(name=f"b{k}", speed=10.0) for k in range(count)]
    svg = power_flow_svg(PowerFlow(span=(0.0, 1.0), blocks=blocks, links=links))
    found = re.findall(
        r'<text class="pp-(?:halo|small)" x="([-\d.]+)" y="([-\d.]+)" text-anchor="(\w+)">([^<]+)', svg
    )
    boxes = []
    for x, y, anchor, words in found:
        if words.endswith("rpm"):
            continue
        wide = 7.0 * len(words)
        left = float(x) - {"start": 0.0, "middle": 0.5 * wide, "end": wide}[anchor]
        boxes.append((left, float(y) - 9.0, left + wide, float(y) + 1.0))
    names = len(boxes)
    assert names >= 3 * sum(OUTSIDE not in (one.start, one.end) for one in links)
    rects = re.findall(r'pp-block" rx="5" x="([-\d.]+)" y="([-\d.]+)" width="(\d+)" height="([\d.]+)"', svg)
    boxes += [(x, y, x + w, y + h) for x, y, w, h in ([float(v) for v in row] for row in rects)]
    for k, (a, b, c, d) in enumerate(boxes[:names]):
        for p, q, r, s in boxes[k + 1 :]:
            assert not (a < r and p < c and b < s and q < d), (found[k], (p, q, r, s))
    [(dx, dy)] = re.findall(r'<g transform="translate\(([\d.]+) ([\d.]+)\)">', svg)
    [(width, height)] = re.findall(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', svg)
    assert min(box[0] for box in boxes) + float(dx) >= 0.0
    assert min(box[1] for box in boxes) + float(dy) >= 0.0
    assert max(box[2] for box in boxes) + float(dx) <= float(width)
    assert max(box[3] for box in boxes) + float(dy) <= float(height)


PLANETS = {"p1": 16750.0, "p2": 35530.0, "p3": 16870.0, "p4": 35500.0}


def test_names_of_four_planets_are_on_no_band() -> None:
    """Unequal planets, two with a small power to the ring: names only next to the bands that they name."""
    blocks = [PowerBlock(name=n, speed=1.0) for n in ("sun", *PLANETS, "carrier")]
    links = [link("motor", OUTSIDE, 0, 104650.0), link("output", 5, OUTSIDE, 104650.0)]
    for k, (name, given) in enumerate(PLANETS.items(), start=1):
        links.append(link(f"sun-planet_{k}", 0, k, given))
        links.append(PowerLink(name=name, kind="carrier", start=k, end=5, given=given, taken=given))
    links += [link(f"planet_{k}-ring", k, OUTSIDE, 210.0) for k in (1, 3)]
    svg = power_flow_svg(PowerFlow(span=(0.0, 1.0), blocks=blocks, links=links))
    texts = re.findall(
        r'<text class="pp-(?:halo|small)" x="([-\d.]+)" y="([-\d.]+)" text-anchor="(start|end)">([^<]+)', svg
    )
    assert sum("sun-planet" in words for *_, words in texts) == 4
    paths = re.findall(
        r"M([-\d.]+) ([-\d.]+)H([-\d.]+)C([-\d.]+) [-\d.]+ ([-\d.]+) [-\d.]+ ([-\d.]+) ([-\d.]+)"
        r"H([-\d.]+)V([-\d.]+)",
        svg,
    )
    assert len(paths) == 12
    t = np.linspace(0.0, 1.0, 200)
    for x, y, anchor, words in texts:
        wide = 7.0 * len(words)
        left = float(x) - (wide if anchor == "end" else 0.0)
        own = 0
        for a, ya, begin, there, back, end, yb, b, bottom in (map(float, p) for p in paths):
            high = bottom - yb
            bend = 3.0 * t * (1.0 - t) ** 2, 3.0 * t**2 * (1.0 - t)
            along = np.r_[a, begin * (1.0 - t) ** 3 + there * bend[0] + back * bend[1] + end * t**3, b]
            top = np.r_[ya, ya + (yb - ya) * (bend[1] + t**3), yb]
            over = np.interp(np.linspace(left, left + wide, 40), along, top, left=np.nan, right=np.nan)
            assert not np.any((over < float(y) + 1.0) & (over + high > float(y) - 9.0)), words
            own += bool(np.nanmin(np.abs(np.r_[over, over + high, 1e9] - float(y) + 4.0)) < 60.0)
        assert own >= 1, f"{words} is near a band"


def test_negligible_powers_are_named_but_not_drawn() -> None:
    """A planet without load: neither its bands nor its block."""
    blocks = [PowerBlock(name=n, speed=1.0) for n in ("sun", "planet_1", "planet_2", "ring")]
    links = [
        PowerLink(
            name=f"{blocks[a].name}-{blocks[b].name}", kind="mesh", start=a, end=b, given=given, taken=given
        )
        for a, b, given in ((0, 1, 1000.0), (1, 3, 1000.0), (0, 2, 0.9), (2, 3, 0.9))
    ]
    flow = PowerFlow(span=(0.0, 1.0), blocks=blocks, links=links)
    svg = power_flow_svg(flow)
    assert svg.count('class="pp-band"') == 2 and "planet_1" in svg and "planet_2" not in svg
    text = "".join(power_section({"run": flow}).parts)
    assert "Powers up to 0.1 % of the largest power are not drawn: sun-planet_2, planet_2-ring." in text


def test_a_band_back_to_an_earlier_block_runs_below_all_others() -> None:
    """A closed loop: once, the band ran straight back behind the others and could not be seen."""
    count, links = FLOWS["circulating"]
    blocks = [PowerBlock(name=f"b{k}", speed=10.0) for k in range(count)]
    svg = power_flow_svg(PowerFlow(span=(0.0, 1.0), blocks=blocks, links=links))
    rects = re.findall(r'pp-block" rx="5" x="([-\d.]+)" y="([-\d.]+)" width="(\d+)" height="([\d.]+)"', svg)
    bottom = max(float(y) + float(h) for _, y, _, h in rects)
    left, right = min(float(x) for x, *_ in rects), max(float(x) + float(w) for x, _, w, _ in rects)
    [(tail, tip_x, tip_y, back)] = re.findall(
        r'class="pp-arrow" d="M([-\d.]+) [-\d.]+L([-\d.]+) ([-\d.]+)L([-\d.]+) ', svg
    )
    assert float(tip_x) < float(tail) == float(back)  # to the left
    assert float(tip_y) > bottom + 40.0 and left < float(tip_x) < right
    [(name_x, name_y)] = re.findall(r'x="([-\d.]+)" y="([-\d.]+)" text-anchor="middle">back_long_name', svg)
    assert bottom < float(name_y) < float(tip_y) and abs(float(name_x) - float(tip_x)) < 10.0
