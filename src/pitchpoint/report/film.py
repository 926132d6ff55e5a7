# SPDX-License-Identifier: Apache-2.0
"""A film of a scene: pictures that a browser without a window draws, put together by ffmpeg.

Both are programs of the system; where one is missing a sentence says so.
"""

from __future__ import annotations

import base64
import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.progress import Progress, silent

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
ENDINGS = (".mp4", ".webm", ".gif")
RATE = 25
"""Pictures a second."""
LENGTH = 10.0
"""Seconds that a film lasts: the record is drawn out or together to them."""
SIZE = (1280, 800)
PALETTE = ["-vf", "fps=12.5,scale=640:-2,split[a][b];[a]palettegen[p];[b][p]paletteuse"]
"""What ffmpeg makes of pictures for a GIF, which has 256 colours."""
PATIENCE = 120.0
"""Seconds after which an answer of the browser is no longer waited for."""
READY = "document.querySelector('.ppv')?.dataset.ready ?? ''"


def film(page: str | os.PathLike[str], target: str | os.PathLike[str], tell: Progress = silent) -> Path:
    """Write the record of a page of `write_view` as a film.

    Parameters
    ----------
    page
        The page.
    target
        The film: .mp4, .webm or .gif.
    tell
        Told after every picture.

    Raises
    ------
    PitchpointError
        If the ending is none of these, there is such a file, a program is missing or fails, or the scene
        does not move.
    """
    path = Path(target)
    if path.exists():
        raise PitchpointError(f"{path} is there already, and a film replaces no file; choose another name")
    if path.suffix.lower() not in ENDINGS:
        raise PitchpointError(f"{path.name} has no ending of a film; use {', '.join(ENDINGS)}")
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    encoder = shutil.which("ffmpeg")
    missing = [name for name, found in (("chromium", browser), ("ffmpeg", encoder)) if found is None]
    if browser is None or encoder is None:
        raise PitchpointError(
            f"a film needs {' and '.join(missing)}, which {'is' if len(missing) == 1 else 'are'} not "
            f"installed; on Debian and Ubuntu: apt install {' '.join(missing)}. Pages save films too"
        )
    with tempfile.TemporaryDirectory() as folder, _Browser(browser, folder) as seen:
        seen.open(Path(page).resolve().as_uri())
        first, last = seen.ask("pitchpointViewer.state().window")
        if not last > first:
            raise PitchpointError("the scene has no motion over time, so there is no film of it")
        command = [
            encoder,
            "-loglevel",
            "error",
            "-y",
            "-f",
            "image2pipe",
            "-framerate",
            str(RATE),
            "-i",
            "-",
        ]
        command += PALETTE if path.suffix.lower() == ".gif" else ["-pix_fmt", "yuv420p"]
        with subprocess.Popen(
            [*command, str(path)], stdin=subprocess.PIPE, stderr=subprocess.PIPE
        ) as process:
            assert process.stdin is not None and process.stderr is not None
            count = int(RATE * LENGTH)
            try:
                for k in range(count):
                    process.stdin.write(seen.picture(first + (last - first) * k / (count - 1)))
                    tell(k + 1, count)
                process.stdin.close()
            except BrokenPipeError:
                pass  # ffmpeg says why below
            words = process.stderr.read().decode(errors="replace").strip()
            if process.wait() != 0:
                raise PitchpointError(f"ffmpeg cannot write {path.name}: {words or 'it gives no reason'}")
    return path


class _Browser:
    """A browser that is steered through two pipes, one message after the other."""

    def __init__(self, program: str, folder: str) -> None:
        self.program, self.folder = program, folder
        self.number = 0
        self.rest = b""
        self.session: str | None = None

    def __enter__(self) -> _Browser:
        to_child, self.write = os.pipe()
        self.read, from_child = os.pipe()
        # the browser reads messages from file 3 and writes them to file 4
        shell = 'exec "$@" 3<&"$IN" 4>&"$OUT"'
        flags = "--headless --disable-extensions --no-first-run --disable-background-networking"
        flags += " --hide-scrollbars --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader"
        flags += " --remote-debugging-pipe"
        flags += " --no-sandbox" if hasattr(os, "geteuid") and os.geteuid() == 0 else ""
        command = [self.program, *flags.split(), f"--user-data-dir={self.folder}", "about:blank"]
        environment = {**os.environ, "IN": str(to_child), "OUT": str(from_child)}
        self.process = subprocess.Popen(
            ["bash", "-c", shell, "bash", *command],
            pass_fds=(to_child, from_child),
            env=environment,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(to_child)
        os.close(from_child)
        return self

    def __exit__(self, *_: object) -> None:
        self.process.terminate()
        self.process.wait()
        os.close(self.write)
        os.close(self.read)

    def _say(self, method: str, **values: Any) -> dict[str, Any]:
        """Send a message and wait for its answer."""
        self.number += 1
        message: dict[str, Any] = {"id": self.number, "method": method, "params": values}
        if self.session is not None:
            message["sessionId"] = self.session
        os.write(self.write, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._next()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise PitchpointError(f"the browser refuses {method}: {answer['error'].get('message')}")
                return dict(answer["result"])

    def _next(self) -> dict[str, Any]:
        """The next message of the browser."""
        import select

        while b"\0" not in self.rest:
            ready, _, _ = select.select([self.read], [], [], PATIENCE)
            block = os.read(self.read, 1 << 20) if ready else b""
            if not block:
                raise PitchpointError(f"the browser ({self.program}) does not answer")
            self.rest += block
        text, self.rest = self.rest.split(b"\0", 1)
        return dict(json.loads(text))

    def open(self, address: str) -> None:
        """Load a page with a scene and wait until it shows it."""
        made = self._say("Target.createTarget", url="about:blank")
        attached = self._say("Target.attachToTarget", targetId=made["targetId"], flatten=True)
        self.session = str(attached["sessionId"])
        width, height = SIZE
        self._say(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=False,
        )
        self._say("Page.navigate", url=address)
        until = "new Promise((done) => { const look = () => { const found = %s; found ? done(found) : "
        until += "setTimeout(look, 100); }; look(); })"
        if self.ask(until % READY) != "scene":
            raise PitchpointError("the browser cannot show this scene")

    def ask(self, script: str) -> Any:
        """Value of an expression in the page."""
        answer = self._say("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        return answer["result"].get("value")

    def picture(self, time: float) -> bytes:
        """The page at an instant [s], as JPEG."""
        self.ask(f"pitchpointViewer.seek({time!r}); pitchpointViewer.draw()")
        found = self._say("Page.captureScreenshot", format="jpeg", quality=90)
        return base64.b64decode(found["data"])
