# SPDX-License-Identifier: Apache-2.0
"""The live page: the compiled model in the browser follows our own run, and its sliders act."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from pitchpoint.report.exported_model import begin_export, live_text
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
    return live_text(run, tunable, model.title)[0]


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
    slider.fill("200.25")
    assert page.get_by_label("loads.input.torque", exact=True).input_value() == "200.25"
    after = np.array(page.evaluate(SAMPLES.replace('document.getElementById("run").click();', ""), 20))
    assert np.abs(after - before).max() > 1.0
    torque = [each["name"] for each in page.evaluate("live.model.outputs")].index("torque[input]")
    assert np.all(after[:, torque] == 200.25)
    page.get_by_role("button", name="Reset").click()
    until(page, "live.run.steps > 20 && live.run.steps < 5000")
    drawn = page.evaluate(
        "document.querySelector('canvas').getContext('2d').getImageData(0, 0, 400, 150).data.some(x => x)"
    )
    assert drawn


def test_a_run_that_fails_says_so(text: str, open_page: OpenPage) -> None:
    page = open_page(text)
    page.get_by_label("loads.input.torque", exact=True).fill("1e99")
    page.get_by_label("loads.input.torque", exact=True).press("Enter")
    until(page, "live.run.failed")
    until(page, "document.getElementById('status').textContent.startsWith('The run has failed')")
    assert page.get_by_role("button", name="Run").is_disabled()
