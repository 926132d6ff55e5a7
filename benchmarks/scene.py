# SPDX-License-Identifier: Apache-2.0
"""The 3-D scene as it plays at 1000 x 650 pixels: drawn in software, and what it leaves to a GPU."""

from __future__ import annotations

import importlib.util
import math
import os
import shutil
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from benchmarks.rows import Row

if TYPE_CHECKING:
    from playwright.sync_api import CDPSession, Page

SHOVEL = Path(__file__).parents[1] / "examples" / "shovel-gearbox" / "model.yaml"
WIDTH, HEIGHT = 1000, 650
SETTLE, SPAN, TRIES = 2.0, 4.0, 3
"""Seconds before pictures are counted, seconds of counting, and how often: the best counts."""
TARGET, TARGET_WITH_GPU = 10, 20
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
SOFTWARE = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
# the policy of a page lets no driver evaluate texts later on
READY = """
() => new Promise((done) => {
  const look = () => window.pitchpointViewer?.state() ? done() : setTimeout(look, 50);
  look();
})
"""
COUNT = """
(span) => new Promise((done) => {
  const drawn = () => pitchpointViewer.state().drawn;
  const from = drawn(), begun = performance.now();
  setTimeout(() => done((drawn() - from) / (performance.now() - begun) * 1000), 1000 * span);
})
"""
PAIRS = 10
GEARS = """\
  a{k}: {{number_of_teeth: 23, normal_module: 3 mm, helix_angle: 15 deg, hand: left, face_width: 30 mm, bore_diameter: 20 mm, profile_shift_coefficient: 0.2}}
  b{k}: {{number_of_teeth: 41, normal_module: 3 mm, helix_angle: 15 deg, hand: right, face_width: 30 mm, bore_diameter: 40 mm, profile_shift_coefficient: 0}}
"""  # noqa: E501
BODIES = """\
  in{k}: {{gears: [a{k}], motion: free, position: [0, {y} mm, {z} mm]}}
  out{k}: {{gears: [b{k}], motion: free}}
"""
STIFF = "stiffness: {{radial: 2e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}}, damping: {{ratio: 0.1}}"
PARTS = {
    "gears": GEARS,
    "bodies": BODIES,
    "meshes": "  m{k}: {{gears: [a{k}, b{k}], stiffness: {{law: din3990}}, damping: {{ratio: 0.1}}}}\n",
    "bearings": f"  s{{k}}: {{{{body: in{{k}}, {STIFF}}}}}\n  t{{k}}: {{{{body: out{{k}}, {STIFF}}}}}\n",
    "loads": "  u{k}: {{body: in{k}, torque: 100 N m}}\n  v{k}: {{body: out{k}, torque: balance}}\n",
}


def many_gears() -> str:
    """A model with ten pairs of gears on bearings, in two rows."""
    texts = [
        f"{part}:\n" + "".join(one.format(k=k, y=160 * (k % 2), z=60 * (k // 2)) for k in range(PAIRS))
        for part, one in PARTS.items()
    ]
    speeds = ", ".join(f"in{k}: 600 rpm" for k in range(PAIRS))
    scenario = f"scenarios:\n  on: {{speed: {{{speeds}}}, duration: 0.1 s, sample_rate: 20 kHz}}\n"
    return "title: twenty gears\n" + "".join(texts) + scenario


def pages(folder: Path) -> dict[str, Path]:
    """Pages of the shovel gearbox on elastic shafts and of twenty gears, each with a short record."""
    from pitchpoint.io.yaml_model import load_model, loads_model
    from pitchpoint.report.scene.build import scene_of
    from pitchpoint.solvers.time import solve_time
    from pitchpoint.system.compile import compile_model
    from pitchpoint.viz.scene.page import scene_page

    brief = {"scenarios.rated.duration": 0.4, "scenarios.rated.settle_time": 0.0}
    models = {
        "shovel gearbox": (load_model(SHOVEL).replace_all(brief), "rated"),
        "20 gears": (loads_model(many_gears()), "on"),
    }
    found = {}
    for name, (model, scenario) in models.items():
        result = solve_time(compile_model(model, scenario))
        found[name] = folder / f"{name.replace(' ', '-')}.html"
        found[name].write_text(scene_page(scene_of(model, result, scenario)), encoding="utf-8")
    return found


class Pace(NamedTuple):
    """How a scene plays: pictures a second, seconds that the page's thread works for one, what was drawn."""

    pictures: float
    own: float
    state: dict[str, Any]


def worked(metrics: CDPSession) -> float:
    """Seconds of processor time that the page's thread has worked: scripts, layout, commands for drawing."""
    found = metrics.send("Performance.getMetrics")["metrics"]
    return next(float(one["value"]) for one in found if one["name"] == "TaskDuration")


def pace(page: Page) -> Pace:
    """Play a page and count."""
    metrics = page.context.new_cdp_session(page)
    metrics.send("Performance.enable", {"timeDomain": "threadTicks"})
    page.evaluate(READY)
    page.evaluate("pitchpointViewer.play()")
    page.wait_for_timeout(1e3 * SETTLE)
    before, drawn = worked(metrics), page.evaluate("pitchpointViewer.state().drawn")
    pictures = float(page.evaluate(COUNT, SPAN))
    after, state = worked(metrics), page.evaluate("pitchpointViewer.state()")
    return Pace(pictures, (after - before) / (state["drawn"] - drawn), state)


def paces(files: dict[str, Path], browser: Path | str) -> dict[str, Pace]:
    """The best of several tries of each page, in turn."""
    from playwright.sync_api import sync_playwright

    best: dict[str, Pace] = {}
    with sync_playwright() as driver:
        program = driver.chromium.launch(executable_path=browser, args=["--no-sandbox", *SOFTWARE])
        for _ in range(TRIES):
            for name, file in files.items():
                page = program.new_page(viewport={"width": WIDTH, "height": HEIGHT})
                page.goto(file.as_uri())
                found = pace(page)
                if name not in best or found.pictures > best[name].pictures:
                    best[name] = found
                page.close()
        program.close()
    return best


def rows() -> list[Row]:
    """Both scenes, drawn in software and what a GPU leaves; one row that reports this without a browser."""
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None or not importlib.util.find_spec("playwright"):
        return [Row("scene of a gearbox", math.nan, "pictures/s", "", "no Playwright or no Chromium")]
    with tempfile.TemporaryDirectory() as folder:
        best = paces(pages(Path(folder)), browser)
    found = []
    for name, (pictures, own, state) in best.items():
        triangles = sum(picture["drawnTriangles"] for picture in state["pictures"])
        size = f"{WIDTH} x {HEIGHT} at {state['ratio']:g} of their pixels"
        text = f"software, {size}; {triangles} triangles; load {os.getloadavg()[0]:.1f}"
        found.append(Row(f"scene of the {name}", pictures, "pictures/s", f">= {TARGET}", text))
        text = f"the page's thread for a picture; {TARGET_WITH_GPU} pictures/s where a GPU draws"
        limit = f"<= {1e3 / TARGET_WITH_GPU:g}"
        found.append(Row(f"scene of the {name}, without drawing", 1e3 * own, "ms", limit, text))
    return found
