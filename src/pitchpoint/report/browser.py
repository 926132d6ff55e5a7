# SPDX-License-Identifier: Apache-2.0
"""Headless browser of the operating system, controlled by Playwright."""

from __future__ import annotations

import importlib.util
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from pitchpoint.core.errors import PitchpointError

if TYPE_CHECKING:
    from playwright.sync_api import Page

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
FLAGS = "--disable-background-networking --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader"


def installed_browser() -> str | None:
    """Path of the browser; None if there is none."""
    return next(filter(None, map(shutil.which, BROWSERS)), None)


def browser_program(kind: str) -> str:
    """Path of the browser.

    Parameters
    ----------
    kind
        Extension of the picture that requires it.

    Raises
    ------
    PitchpointError
        If the browser or its driver is missing.
    """
    program = installed_browser()
    if program is None or importlib.util.find_spec("playwright") is None:
        raise PitchpointError(
            f"a {kind.removeprefix('.')} file requires Chromium and Playwright (pip install "
            "'pitchpoint[film]'); write an html page instead, whose menu saves pictures"
        )
    return program


@contextmanager
def open_page(program: str, width: int, height: int, scale: float = 1.0) -> Iterator[Page]:
    """Empty page of a new browser.

    Parameters
    ----------
    program
        Path of the browser.
    width, height
        Size of the page [pixels].
    scale
        Pixels of a screenshot per pixel of the page.

    Raises
    ------
    PitchpointError
        If the browser fails, also while the page is used.
    """
    from playwright.sync_api import Error, sync_playwright

    root = hasattr(os, "geteuid") and os.geteuid() == 0
    try:
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(
                executable_path=program, args=FLAGS.split(), chromium_sandbox=not root
            )
            yield browser.new_page(viewport={"width": width, "height": height}, device_scale_factor=scale)
            browser.close()
    except Error as error:
        raise PitchpointError(f"the browser ({program}) failed: {error.message.splitlines()[0]}") from None
