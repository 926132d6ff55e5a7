# SPDX-License-Identifier: Apache-2.0
"""Cells of a notebook in a browser: scenes draw inside their sandbox, and all follows the theme around."""

from __future__ import annotations

import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.notebook import model_html
from pitchpoint.viz import theme
from tests.support.browser import OpenPage, needs_browser
from tests.support.model_files import TORSIONAL_PAIR
from tests.support.scene_browser import asked, until

pytestmark = needs_browser

READY = "window.pitchpointViewer && pitchpointViewer.state()?.pictures.length"
MARKS = {
    'data-jp-theme-light="true"': "light",
    'data-jp-theme-light="false"': "dark",
    'class="vscode-light"': "light",
    'class="vscode-dark"': "dark",
    'class="vscode-high-contrast"': "dark",
    'data-theme="dark"': "dark",
}
"""How JupyterLab, nbconvert, VS Code and Sphinx mark their pages."""


@pytest.fixture(scope="module")
def cell() -> str:
    return model_html(loads_model(TORSIONAL_PAIR))


def test_a_model_in_a_cell(open_page: OpenPage, cell: str) -> None:
    """It is as dark as the page around it says, until that changes its mind."""
    body = '<body data-jp-theme-light="false">'
    page = open_page(f'<!DOCTYPE html><meta charset="utf-8">{body}{cell}', size=(1000, 900), dark=None)
    (frame,) = page.main_frame.child_frames
    until(frame, READY)
    colour = "getComputedStyle(document.querySelector('.ppv')).backgroundColor"
    assert frame.evaluate(colour) == rgb(theme.DARK["paper"])
    page.evaluate("document.body.dataset.jpThemeLight = 'true'")
    until(frame, f"{colour} === '{rgb(theme.LIGHT['paper'])}'")
    assert frame.evaluate("self.origin") == "null"  # the sandbox is there: the frame belongs to no one
    state = frame.evaluate("pitchpointViewer.state()")
    assert state["message"] is None and len(state["pictures"][0]["bodies"]) == 2
    # the sandbox lets files out
    frame.click(".ppv-tools button:text('Save')")
    with page.expect_download() as file:
        frame.click(".ppv-panel button:text('STL')")
    assert file.value.suggested_filename.endswith(".stl")


def test_drawings_follow_the_theme_of_the_notebook(open_page: OpenPage, cell: str) -> None:
    """Whatever the system prefers."""
    drawing = cell[: cell.index("<iframe")]
    page = open_page(f'<!DOCTYPE html><meta charset="utf-8">{drawing}', dark=True)
    paper = "getComputedStyle($('.pp-paper')).fill"
    for mark, expected in MARKS.items():
        name, _, value = mark.partition("=")
        script = f"document.body.setAttribute('{name}', {value}); const is = {paper};"
        found = asked(page, f"{script} document.body.removeAttribute('{name}'); return [is, {paper}];")
        assert found == [rgb(getattr(theme, expected.upper())["paper"]), rgb(theme.DARK["paper"])], mark
    page.emulate_media(color_scheme="light")
    assert asked(page, f"return {paper};") == rgb(theme.LIGHT["paper"])


def rgb(colour: str) -> str:
    """As browsers write it."""
    return f"rgb({', '.join(str(int(colour[k : k + 2], 16)) for k in (1, 3, 5))})"
