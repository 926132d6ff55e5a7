# SPDX-License-Identifier: Apache-2.0
"""A scene as a part of a page, as a page and as a frame in another document: the same scene each time."""

from __future__ import annotations

from html.parser import HTMLParser

import pytest

from pitchpoint.viz.scene.page import scene_elements, scene_fragment, scene_frame, scene_page
from tests.support.report_data import scene


class Frames(HTMLParser):
    """Attributes of all frames."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[dict[str, str | None]] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "iframe":
            self.found.append(dict(attrs))


def test_page_and_fragment_hold_the_scene_once() -> None:
    elements = scene_elements(scene())
    for text in (scene_page(scene()), scene_fragment(scene(), height="300px")):
        assert text.count(elements) == 1
        assert text.count('id="pp-view"') == 1
    assert "height:300px" in scene_fragment(scene(), height="300px")
    assert '{"compare":true}' in scene_fragment(scene(), scene())
    for wrong in ((), (scene(), scene(), scene())):
        with pytest.raises(ValueError, match="scenes in a page"):
            scene_fragment(*wrong)


def test_a_frame_holds_the_whole_page_so_that_a_document_can_have_several() -> None:
    (frame,) = Frames(scene_frame(scene(), height="200px")).found
    assert frame["srcdoc"] == scene_page(scene())
    assert frame["title"] == "wedge"
    assert "height:200px" in str(frame["style"])
    assert "allow-same-origin" not in str(frame["sandbox"])
