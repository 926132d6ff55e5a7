# SPDX-License-Identifier: Apache-2.0
"""The live page: the compiled model in the browser follows our own run, and its sliders act."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.report.exported_model import begin_export
from pitchpoint.report.live import live_text, offered
from pitchpoint.report.scene.motion import motion, shown_bodies
from pitchpoint.solvers.fixed_steps import start_fixed_steps
from tests.support.browser import OpenPage, needs_browser
from tests.support.fmu_models import own_run, own_start, pair

if TYPE_CHECKING:
    from playwright.sync_api import Page

pytestmark = needs_browser
SAMPLES = """n => {
  document.getElementById("run").click();
  live.run.reset();
  const rows = [];
  for (let k = 0; k < n; k++) { if (!live.run.step()) break; rows.push(Array.from(live.run.get())); }
  return rows;
}"""

RATE = """() => {
  const begin = performance.now();
  let n = 0;
  for (; performance.now() - begin < 500; n += 200) for (let k = 0; k < 20; k++) live.run.step();
  return n / ((performance.now() - begin) / 1000);
}"""


def until(page: Page, expression: str) -> None:
    """Wait until an expression is true; the page forbids the evaluation of texts by its own scripts."""
    for _ in range(600):
        if page.evaluate(expression):
            return
        page.wait_for_timeout(50)
    raise AssertionError(expression)


@pytest.fixture(scope="module")
def text() -> str:
    """Live page of the pair with backlash."""
    pytest.importorskip("ziglang", reason="ziglang is not installed (extra fmi)")
    model = pair("adams")
    run, tunable = begin_export(model, "steady", ["meshes.stage.backlash.normal"])
    return live_text(run, tunable, model, "steady")[0]


def test_the_model_in_the_browser_follows_our_own_run(text: str, open_page: OpenPage) -> None:
    """Its code has no fused products; limit: three times the deviation of a run that begins 4e-16 rad off."""
    found = np.array(open_page(text).evaluate(SAMPLES, 100))
    start = own_start("adams")
    state = start.state.copy()
    state.q[0] += 4e-16
    moved = start_fixed_steps(start.system, state, start.system.scenario, 1e-5)
    own = own_run("adams").advance(1000, every=10).rows[:, 1:]
    limit = 3.0 * np.abs(moved.advance(1000, every=10).rows[:, 1:] - own).max(axis=0)
    size = np.abs(own).max(axis=0)
    assert found.shape == own.shape
    assert np.all(np.abs(found - own).max(axis=0) <= limit + 1e-12 * size)


def test_sliders_act_and_reset_begins_again(text: str, open_page: OpenPage) -> None:
    page = open_page(text)
    until(page, "live.run.steps > 100")
    before = np.array(page.evaluate(SAMPLES, 20))
    assert page.locator("#status").inner_text().endswith("paused")
    slider = page.get_by_label("loads.input.torque, slider")
    slider.fill("267")  # of 400, from 0 to 300 N m
    assert page.get_by_label("loads.input.torque", exact=True).input_value() == "200.25"
    after = np.array(page.evaluate(SAMPLES.replace('document.getElementById("run").click();', ""), 20))
    assert np.abs(after - before).max() > 1.0
    torque = [each["name"] for each in page.evaluate("live.model.outputs")].index("torque[input]")
    assert np.all(after[:, torque] == 200.25)
    page.get_by_role("button", name="Reset").click()
    until(page, "live.run.steps > 20 && live.run.steps < 5000")
    drawn = page.evaluate(
        "document.querySelector('#plots canvas').getContext('2d')"
        ".getImageData(0, 0, 400, 150).data.some(x => x)"
    )
    assert drawn


def test_a_run_that_fails_says_so(text: str, open_page: OpenPage) -> None:
    page = open_page(text)
    page.get_by_label("loads.input.torque", exact=True).fill("1e99")
    page.get_by_label("loads.input.torque", exact=True).press("Enter")
    until(page, "live.run.failed")
    until(page, "document.getElementById('status').textContent.startsWith('The run has failed')")
    assert page.get_by_role("button", name="Run").is_disabled()


@pytest.fixture(scope="module")
def helical() -> tuple[str, object]:
    """Page of the pair of 12 degrees of freedom with the sliders that are offered, and its model."""
    pytest.importorskip("ziglang", reason="ziglang is not installed (extra fmi)")
    file = Path(__file__).parents[2] / "benchmarks" / "pair_12dof.yaml"
    model, run, tunable = offered(load_model(str(file)), "steady")
    return live_text(run, tunable, model, "steady")[0], run


def test_the_scene_follows_the_model(helical: tuple[str, object], open_page: OpenPage) -> None:
    """Bodies and arrows after 2 ms against the frames and forces of our own kernels in the same position."""
    text, run = helical
    page = open_page(text)
    until(page, "pitchpointViewer.state() !== null && live.run.steps > 0")
    page.evaluate(SAMPLES, 40)
    page.evaluate("pitchpointViewer.live(live.poses); pitchpointViewer.draw()")
    names = [each["name"] for each in page.evaluate("live.model.outputs")]
    values = dict(zip(names, page.evaluate("Array.from(live.run.get())"), strict=True))
    moved = motion(run.system, 1, lambda n: np.array([values[n]]) if n in values else None, np.array([2e-3]))
    picture = page.evaluate("pitchpointViewer.state()")["pictures"][0]
    for k, b in enumerate(shown_bodies(run.system)):
        found = np.array(picture["bodies"][k]).reshape(4, 4).T
        np.testing.assert_allclose(found[:3, 3], moved.place[0, b], atol=1e-9)
        np.testing.assert_allclose(found[:3, :3], moved.spinning(b)[0], atol=1e-9)
    arrows = {arrow["name"]: arrow for arrow in picture["arrows"]}
    assert set(arrows) == {"stage", "input_bearing", "output_bearing"}
    for row, part in enumerate(("circumferential", "radial", "axial")):
        want = values[f"{part}_force[stage]"] * moved.directions[0, 0, row]
        np.testing.assert_allclose(arrows["stage"]["vectors"][part], want, atol=1e-3 * abs(want).max())
    radial = np.hypot(*(values[f"bearing_force[input_bearing.{c}]"] for c in ("fx", "fy")))
    assert np.linalg.norm(arrows["input_bearing"]["vectors"]["radial"]) == pytest.approx(radial, rel=1e-9)


def test_sliders_of_the_five_numbers(helical: tuple[str, object], open_page: OpenPage) -> None:
    """Torque, speed, backlash, centre distance, damping: each changes the run, within its range."""
    page = open_page(helical[0])
    until(page, "pitchpointViewer.state() !== null && live.run.steps > 0")
    plain = np.array(page.evaluate(SAMPLES, 20))
    names = [each["name"] for each in page.evaluate("live.model.outputs")]
    for label, value in {
        "loads.drive.torque": "110",
        "initial speed of input": "1600",
        "meshes.stage.backlash.normal": "0.11",
        "meshes.stage.center_distance": "132.1",
        "meshes.stage.damping.ratio": "0.05",
    }.items():
        box = page.get_by_label(label, exact=True)
        before = box.input_value()
        box.fill(value)
        box.press("Enter")
        changed = np.array(page.evaluate(SAMPLES, 20))
        assert np.abs(changed - plain).max() > 1e-6, label
        if label.startswith("initial"):
            speed = changed[0, names.index("speed[input]")]
            assert speed == pytest.approx(1600.0 * np.pi / 30.0, rel=1e-3)
        box.fill(before)
        box.press("Enter")
    torque = page.get_by_label("loads.drive.torque", exact=True)
    torque.fill("200")
    torque.press("Enter")
    page.get_by_role("button", name="Reset").click()
    assert float(page.get_by_label("loads.brake.torque", exact=True).input_value()) == pytest.approx(480.0)
    for label, value, limit, words in (
        ("meshes.stage.center_distance", "150", 132.262, "150 mm is above the range: set to 132.262 mm"),
        ("meshes.stage.damping.ratio", "-1", 0.0, "-1 is below the range: set to 0"),  # of the model file
        ("meshes.stage.backlash.normal", "0.3", 0.3, ""),  # beyond the end of the slider
    ):
        box = page.get_by_label(label, exact=True)
        box.fill(value)
        box.press("Enter")
        assert float(box.input_value()) == pytest.approx(limit, abs=1e-3)
        assert box.locator("xpath=ancestor::*[@class='control']").locator(".note").inner_text() == words


def test_the_legend_names_the_flanks_that_come_into_contact(
    helical: tuple[str, object], open_page: OpenPage
) -> None:
    page = open_page(helical[0], size=(1600, 900))
    until(page, "pitchpointViewer.state() !== null && live.run.steps > 0")
    words = "document.querySelector('.ppv-states').textContent"
    assert page.evaluate(words) == "front flank"
    for label, value in (("loads.drive.torque", "-100"), ("loads.brake.torque", "-240")):
        box = page.get_by_label(label, exact=True)
        box.fill(value)
        box.press("Enter")
    until(page, f"{words} === 'front flankback flankno contact'")


def test_ticks_are_round(helical: tuple[str, object], open_page: OpenPage) -> None:
    """At most the given number of ticks, but two at least."""
    page = open_page(helical[0])
    for arguments, found, places in (
        ("0.3, 52.1, 5", [20.0, 40.0], 0),
        ("1.476, 1.526, 3", [1.48, 1.5, 1.52], 2),
        ("-14468, 2796, 8", [-10000.0, -5000.0, 0.0], 0),
        ("2706, 2799, 2", [2720.0, 2740.0, 2760.0, 2780.0], 0),
    ):
        ticks = page.evaluate(f"live.ticks({arguments})")
        np.testing.assert_allclose(ticks["found"], found, rtol=1e-12)
        assert ticks["places"] == places


def test_ten_thousand_steps_to_rounding(helical: tuple[str, object], open_page: OpenPage) -> None:
    """Coordinates to 1e-12 m and rad, speeds to 1e-12; WebAssembly has no fused products.

    Forces are stiffnesses times coordinates: their limit is four times the deviation of a run that begins
    4e-16 rad off.
    """
    text, run = helical
    page = open_page(text)
    until(page, "pitchpointViewer.state() !== null && live.run.steps > 0")
    found = np.array(page.evaluate(SAMPLES, 1000))
    runs = []
    for change in (0.0, 4e-16):
        system, state = run.system.copy(), run.state.copy()
        state.q[system.layout.coordinate("input.spin")] += change
        begun = start_fixed_steps(system, state, system.scenario, run.h)
        runs.append(begun.advance(10_000, every=10).rows[:, 1:])
    own, moved = runs
    size, left, room = (np.abs(x).max(axis=0) for x in (own, found - own, moved - own))
    names = [channel.name for channel in system.layout.channels]
    for k, name in enumerate(names):
        if name.startswith(("angle", "displacement")):
            assert left[k] <= 1e-12, name
        else:
            assert left[k] <= 1e-12 * size[k] + 4.0 * room[k], name
        assert not name.startswith("speed") or left[k] <= 1e-12 * size[k]
    rate = page.evaluate(RATE)
    assert rate > 1e5
