# SPDX-License-Identifier: Apache-2.0
"""The 3-D scene as it plays: pictures a second by a real clock, drawn in software at 1000 x 650 pixels."""

from __future__ import annotations

import math
import os
import shutil
import tempfile
from pathlib import Path
from typing import Any

from benchmarks.rows import Row

SHOVEL = Path(__file__).parents[1] / "examples" / "shovel-gearbox" / "model.yaml"
WIDTH, HEIGHT = 1000, 650
SETTLE, SPAN, TRIES = 2.0, 4.0, 3
"""Seconds before pictures are counted, seconds of counting, and how often: the best counts."""
LEAST = 10
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
    from pitchpoint.report.scene import scene_of
    from pitchpoint.solvers.time import solve_time
    from pitchpoint.system.compile import compile_model
    from pitchpoint.viz.scene_page import scene_page

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


def paces(files: dict[str, Path], browser: Path | str) -> dict[str, tuple[float, dict[str, Any]]]:
    """Pictures a second of pages that play, the best of several tries in turn, and what was drawn."""
    from playwright.sync_api import sync_playwright

    best: dict[str, tuple[float, dict[str, Any]]] = {}
    with sync_playwright() as driver:
        program = driver.chromium.launch(executable_path=browser, args=["--no-sandbox", *SOFTWARE])
        for _ in range(TRIES):
            for name, file in files.items():
                page = program.new_page(viewport={"width": WIDTH, "height": HEIGHT})
                page.goto(file.as_uri())
                page.evaluate(READY)
                page.evaluate("pitchpointViewer.play()")
                page.wait_for_timeout(1e3 * SETTLE)
                pace = float(page.evaluate(COUNT, SPAN))
                if pace > best.get(name, (0.0, {}))[0]:
                    best[name] = pace, page.evaluate("pitchpointViewer.state()")
                page.close()
        program.close()
    return best


def rows() -> list[Row]:
    """Pictures a second of both scenes; empty without Playwright or Chromium."""
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    try:
        import playwright  # noqa: F401
    except ImportError:
        browser = None
    with tempfile.TemporaryDirectory() as folder:
        files = pages(Path(folder))
        best = paces(files, browser) if browser else {}
    found = []
    for name in files:
        pace, state = best.get(name, (math.nan, {}))
        text = "no Playwright or no Chromium"
        if state:
            triangles = sum(picture["drawnTriangles"] for picture in state["pictures"])
            ratio, load = state["ratio"], os.getloadavg()[0]
            size = f"{WIDTH} x {HEIGHT} at {ratio:g} of their pixels"
            text = f"software, {size}; {triangles} triangles; load {load:.1f}"
        found.append(Row(f"scene of the {name}", pace, "pictures/s", f">= {LEAST}" if state else "", text))
    return found
