# SPDX-License-Identifier: Apache-2.0
"""One headless Chromium for all pages of a file of tests, spoken to through its debugging pipe.

Starting it takes longer than most pages. Every page has a context of its own: no storage, no window and no
emulated setting passes from one to the next.
"""

from __future__ import annotations

import atexit
import json
import os
import select
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
QUIET = (
    *"--headless --no-sandbox --disable-quic --no-first-run --disable-extensions".split(),
    *"--disable-background-networking --disable-component-update --disable-sync".split(),
)
SOFTWARE_3D = tuple("--use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader".split())
START = """
import fcntl, os, sys
for place, end in enumerate([fcntl.fcntl(int(end), fcntl.F_DUPFD, 10) for end in sys.argv[1:3]], 3):
    os.dup2(end, place)
os.execvp(sys.argv[3], sys.argv[3:])
"""
"""Chromium reads from 3 and writes to 4."""
PATIENCE = 180.0
"""What a page may take by the clock [s]; its own clock is virtual and runs ahead."""


class Chromium:
    """A running browser.

    Parameters
    ----------
    flags
        Flags of its command beside those that keep it quiet.
    """

    def __init__(self, *flags: str) -> None:
        assert BROWSER is not None
        self._profile = tempfile.mkdtemp(prefix="chromium-")
        (theirs_in, self._out), (self._in, theirs_out) = os.pipe(), os.pipe()
        command = [BROWSER, *QUIET, *flags, "--remote-debugging-pipe", f"--user-data-dir={self._profile}"]
        self._process = subprocess.Popen(
            [sys.executable, "-c", START, str(theirs_in), str(theirs_out), *command],
            pass_fds=(theirs_in, theirs_out),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(theirs_in)
        os.close(theirs_out)
        self._count, self._buffer = 0, b""
        self._over: set[str] = set()

    def close(self) -> None:
        """End the browser and remove its profile."""
        os.close(self._out)
        os.close(self._in)
        try:
            self._process.wait(10.0)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        shutil.rmtree(self._profile, ignore_errors=True)

    def show(self, page: Path, ask: str, *, budget: int, wait: bool, **window: Any) -> Any:
        """Value of an expression in a page whose scripts have run.

        Parameters
        ----------
        page
            File.
        ask
            JavaScript.
        budget
            How long the scripts may run by the clock of the page [ms].
        wait
            Whether that time has to pass; else the first value that is not empty ends it.
        window
            As for `opened`.
        """
        with self.opened(page, budget=budget, **window) as value_of:
            return value_of(ask, wait)

    @contextmanager
    def opened(
        self, page: Path, *, budget: int, size: tuple[int, int] = (1000, 700), dark: bool = False
    ) -> Iterator[Callable[..., Any]]:
        """Keep a page open: a function of an expression and whether to wait until the time is over.

        Parameters
        ----------
        page
            File.
        budget
            How long the scripts may run by the clock of the page [ms].
        size
            Of the window [px].
        dark
            Whether the user prefers dark colours.
        """
        context = self._call("Target.createBrowserContext")["browserContextId"]
        target = self._call("Target.createTarget", url="about:blank", browserContextId=context)["targetId"]
        on = self._call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        shape = {"width": size[0], "height": size[1], "deviceScaleFactor": 1, "mobile": False}
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        try:
            self._call("Page.enable", on)
            self._call("Emulation.setDeviceMetricsOverride", on, **shape)
            self._call("Emulation.setEmulatedMedia", on, features=[scheme])
            self._call("Emulation.setVirtualTimePolicy", on, policy="pause")
            self._call("Page.navigate", on, url=page.as_uri())
            self._call(
                "Emulation.setVirtualTimePolicy",
                on,
                policy="pauseIfNetworkFetchesPending",
                budget=budget,
                maxVirtualTimeTaskStarvationCount=9999,
            )
            yield lambda ask, wait=True: self._value(on, ask, wait)
        finally:
            self._call("Target.disposeBrowserContext", browserContextId=context)
            self._over.discard(on)

    def _value(self, on: str, ask: str, wait: bool) -> Any:
        """The value, once it is there or the time of the page is over."""
        end = time.monotonic() + PATIENCE
        while True:
            over = on in self._over
            said = {} if wait and not over else self._call("Runtime.evaluate", on, expression=ask)
            assert "exceptionDetails" not in said, said
            value = said.get("result", {}).get("value")
            if over or value:
                return value
            assert time.monotonic() < end, "the page does not end"
            if wait:
                self._note(self._read())
            else:
                time.sleep(0.02)

    def _note(self, said: dict[str, Any]) -> None:
        """Keep whose time is over."""
        if said.get("method") == "Emulation.virtualTimeBudgetExpired":
            self._over.add(said["sessionId"])

    def _call(self, method: str, session: str = "", **parameters: Any) -> dict[str, Any]:
        """Result of a command; what happens meanwhile is noted."""
        self._count += 1
        asked = {"id": self._count, "method": method, "params": parameters}
        if session:
            asked["sessionId"] = session
        os.write(self._out, json.dumps(asked).encode() + b"\0")
        while True:
            said = self._read()
            if said.get("id") == self._count:
                assert "error" not in said, f"{method}: {said['error']}"
                return dict(said["result"])
            self._note(said)

    def _read(self) -> dict[str, Any]:
        """Next message."""
        while b"\0" not in self._buffer:
            assert select.select([self._in], [], [], PATIENCE)[0], "Chromium says nothing"
            part = os.read(self._in, 1 << 20)
            assert part, "Chromium has ended"
            self._buffer += part
        message, _, self._buffer = self._buffer.partition(b"\0")
        return dict(json.loads(message))


def window(*flags: str) -> dict[str, Any]:
    """What flags of a command say about the window, as arguments of `Chromium.show`."""
    given = dict(flag.partition("=")[::2] for flag in flags)
    width, _, height = given.get("--window-size", "1000,700").partition(",")
    dark = given.get("--blink-settings") == "preferredColorScheme=0"
    assert set(given) <= {"--window-size", "--blink-settings"}, f"not of the window: {flags}"
    return {"size": (int(width), int(height)), "dark": dark}


_running: dict[tuple[str, ...], Chromium] = {}


def chromium(*flags: str) -> Chromium:
    """The browser of this process with these flags."""
    if flags not in _running:
        _running[flags] = Chromium(*flags)
    return _running[flags]


def close_all() -> None:
    """End all browsers of this process."""
    while _running:
        _running.popitem()[1].close()


atexit.register(close_all)
