# SPDX-License-Identifier: Apache-2.0
"""Tests hear what pages say and do, and find controls without effect; else they would prove nothing."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support import walk
from tests.support.browser import Browsers, OpenPage, needs_browser, opening

pytestmark = needs_browser

NOISE = {
    "console, log: hello": "<script>console.log('hello')</script>",
    "console, error: no": "<script>console.error('no')</script>",
    "error: lost": "<script>setTimeout(() => { throw new Error('lost') })</script>",
    "error: refused": "<script>Promise.reject(new Error('refused'))</script>",
    "request: http://nowhere.invalid/x.png": "<img src='http://nowhere.invalid/x.png'>",
    # a frame of no one may ask before it is listened to; the console hears of it all the same
    "net::ERR": "<iframe sandbox srcdoc=\"<img src='http://nowhere.invalid/y.png'>\"></iframe>",
    "violates": "<meta http-equiv=Content-Security-Policy content=\"default-src 'none'\"><script>0</script>",
}
DEAD = """<p id=said>0</p><button onclick="said.textContent++">more</button><button>dead</button>"""


@pytest.mark.study
def test_pages_are_overheard(browsers: Browsers, tmp_path: Path) -> None:
    for words, text in NOISE.items():
        with pytest.raises(AssertionError, match=words), opening(browsers, tmp_path) as open_page:
            open_page(f"<!DOCTYPE html>{text}", webgl=False).wait_for_timeout(50)


def test_controls_without_effect_are_named(open_page: OpenPage, monkeypatch: pytest.MonkeyPatch) -> None:
    for patience in ("WORDS", "PIXELS"):
        monkeypatch.setattr(walk, patience, 0.1)
    with pytest.raises(AssertionError) as error:
        walk.Walk(open_page(f"<!DOCTYPE html>{DEAD}", webgl=False)).over("body")
    assert str(error.value) == "without effect: ['dead']"
