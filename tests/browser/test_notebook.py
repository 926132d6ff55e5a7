# SPDX-License-Identifier: Apache-2.0
"""The scene of a notebook in a browser: it draws inside its sandbox, and no console hears of it."""

from __future__ import annotations

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.notebook import model_html
from tests.support.browser import OpenPage, needs_browser
from tests.support.model_files import TORSIONAL_PAIR
from tests.support.scene_browser import until

pytestmark = needs_browser


def test_a_model_in_a_cell(open_page: OpenPage) -> None:
    text = model_html(loads_model(TORSIONAL_PAIR))
    page = open_page(f'<!DOCTYPE html><meta charset="utf-8">{text}', size=(1000, 900))
    (frame,) = page.main_frame.child_frames
    until(frame, "window.pitchpointViewer && pitchpointViewer.state()?.pictures.length")
    assert frame.evaluate("self.origin") == "null"  # the sandbox is there: the frame belongs to nobody
    state = frame.evaluate("pitchpointViewer.state()")
    assert state["message"] is None and len(state["pictures"][0]["bodies"]) == 2
