# SPDX-License-Identifier: Apache-2.0
"""Pages in the headless Chromium of the system, driven by Playwright.

A process starts one browser that draws in software and, if a test asks for it, one without WebGL. Every page
has a context of its own: no storage, no window and no emulated setting passes from one to the next. All that
a page says in its console, all its errors and all its requests are heard; whoever closes it sees that there
were none but that for its own file.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from tempfile import mkdtemp
from typing import TYPE_CHECKING, Any

import pytest

from pitchpoint.report.browser import installed_browser

if TYPE_CHECKING:
    from playwright.sync_api import Browser, BrowserContext, Page, Playwright

CHROMIUM = installed_browser()
MISSING = " and ".join(
    reason
    for reason, there in (
        ("no Chromium on this machine; install it: apt install chromium", CHROMIUM),
        ("no Playwright here; install it: pip install playwright", importlib.util.find_spec("playwright")),
    )
    if not there
)
"""Why pages cannot be opened; empty if they can."""
needs_browser = pytest.mark.skipif(bool(MISSING), reason=MISSING)

# the page around a scene is put together without the graphics that are made in software
SOFTWARE_3D = tuple("--use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader".split())
SOFTWARE_3D += ("--disable-gpu-compositing",)
NO_WEBGL = ("--disable-3d-apis", "--disable-gpu", "--disable-software-rasterizer")
OpenPage = Callable[..., Any]
"""What the fixture `open_page` gives."""
PATIENCE = 60_000.0
"""How long a page may take for anything [ms]."""


class Browsers:
    """The browsers of a process, started when they are needed."""

    def __init__(self) -> None:
        self._playwright: Playwright | None = None
        self._running: dict[tuple[str, ...], Browser] = {}
        self._heard: dict[Page, list[str]] = {}

    def close(self) -> None:
        """End all of them."""
        for browser in self._running.values():
            browser.close()
        self._running.clear()
        if self._playwright is not None:
            self._playwright.stop()
            self._playwright = None

    @contextmanager
    def opened(
        self,
        file: Path,
        *,
        webgl: bool = True,
        dark: bool | None = False,
        size: tuple[int, int] = (1000, 700),
    ) -> Iterator[Page]:
        """Keep a page open; at the end it has said nothing and asked for nothing but itself.

        Parameters
        ----------
        file
            HTML.
        webgl
            Whether the browser offers it.
        dark
            Whether the reader prefers dark colours; None leaves it to the system, and frames to their page.
        size
            Of the window [px].
        """
        scheme = "null" if dark is None else "dark" if dark else "light"
        context = self._browser(SOFTWARE_3D if webgl else NO_WEBGL).new_context(
            viewport={"width": size[0], "height": size[1]}, color_scheme=scheme
        )
        context.set_default_timeout(PATIENCE)
        heard = _listen(context, file.as_uri())
        try:
            page = context.new_page()
            self._heard[page] = heard
            page.goto(file.as_uri())
            yield page
            self.judge(page)
        finally:
            context.close()

    def judge(self, page: Page) -> None:
        """Complain of what a page has said and asked for so far."""
        page.evaluate("0")  # what it has said before has arrived then
        heard = self._heard[page]
        said = "\n".join(heard)
        heard.clear()
        assert not said, said

    def _browser(self, flags: tuple[str, ...]) -> Browser:
        from playwright.sync_api import sync_playwright

        if self._playwright is None:
            self._playwright = sync_playwright().start()
        if flags not in self._running:
            self._running[flags] = self._playwright.chromium.launch(
                executable_path=CHROMIUM, args=["--no-sandbox", "--disable-smooth-scrolling", *flags]
            )
        return self._running[flags]


def _listen(context: BrowserContext, own: str) -> list[str]:
    """What its pages, their frames and windows say, fail in and ask for, as it comes."""
    heard: list[str] = []

    def said(message: Any) -> None:
        # of the driver, about the speed at which tests read pixels; nothing that the page says
        if "GL Driver Message (OpenGL, Performance" not in message.text:
            heard.append(f"console, {message.type}: {message.text}")

    context.on("console", said)
    context.on("page", lambda page: page.on("pageerror", lambda error: heard.append(f"error: {error}")))

    def asked(request: Any) -> None:
        if request.url.partition("#")[0] != own and not request.url.startswith(("data:", "blob:")):
            heard.append(f"request: {request.url[:200]}")

    context.on("request", asked)
    return heard


@contextmanager
def opening(browsers: Browsers, folder: Path) -> Iterator[Callable[..., Page]]:
    """A function that opens pages, of a text or a file; they are closed together, and then judged.

    Parameters
    ----------
    browsers
        Of the process.
    folder
        Where texts are kept as files.
    """
    with ExitStack() as stack:

        def open_page(text: str | Path, **how: Any) -> Page:
            """All of it has been loaded; other arguments are those of `Browsers.opened`."""
            file = text if isinstance(text, Path) else Path(mkdtemp(dir=folder)) / "page.html"
            if isinstance(text, str):
                file.write_text(text, encoding="utf-8")
            return stack.enter_context(browsers.opened(file, **how))

        yield open_page
