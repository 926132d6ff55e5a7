# SPDX-License-Identifier: Apache-2.0
"""Asks pages of the project what they show, after all of it has been drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tests.support.browser import OpenPage
from tests.support.scene_browser import asked, until

if TYPE_CHECKING:
    from playwright.sync_api import Page

DRAWN = """document.documentElement.dataset.ready
  && (!document.querySelector("#pp-view") || document.querySelector(".ppv[data-ready]"))"""


def drawn(open_page: OpenPage, text: str, **how: Any) -> Page:
    """A page of which all plots and the scene are there.

    Parameters
    ----------
    open_page
        The fixture, or a function like it.
    text
        HTML.
    **how
        For `open_page`.
    """
    page = open_page(text, **how)
    until(page, DRAWN)
    return page


def found(open_page: OpenPage, text: str, script: str, **how: Any) -> Any:
    """What a script of the test finds in such a page."""
    return asked(drawn(open_page, text, **how), script)
