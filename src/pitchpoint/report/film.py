# SPDX-License-Identifier: Apache-2.0
"""A film of a scene: pictures that a browser without a window draws, assembled by ffmpeg.

Both are programs of the system, the browser is driven by Playwright; what is missing is named before anything
is computed.
"""

from __future__ import annotations

import base64
import importlib.util
import os
import shutil
import subprocess
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.io.target import check_place, make_folder, replacing

if TYPE_CHECKING:
    from playwright.sync_api import CDPSession, Page

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
LENGTH = 10.0
"""Seconds that a film lasts: the record is drawn out or together to them."""
SIZE = (1280, 800)
PATIENCE = 120.0
"""Seconds after which an answer of the browser is no longer waited for."""
FLAGS = "--disable-background-networking --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader"
READY = "document.querySelector('.ppv')?.dataset.ready ?? ''"


@dataclass(frozen=True)
class _Kind:
    """How a film of one ending is made.

    Attributes
    ----------
    encoders
        Encoders of ffmpeg that make it, the best first.
    rate
        Pictures a second.
    picture
        What the browser draws: jpeg, or png where its noise would cost colours.
    settings
        Arguments of ffmpeg.
    """

    encoders: tuple[str, ...]
    rate: float
    picture: str
    settings: tuple[str, ...]


KINDS = {
    ".mp4": _Kind(
        ("libx264", "libopenh264", "mpeg4"), 25.0, "jpeg", ("-pix_fmt", "yuv420p", "-movflags", "+faststart")
    ),
    # constant quality needs a rate of 0; the fifth of nine speeds halves the time for a few per cent of size
    ".webm": _Kind(
        ("libvpx-vp9", "libvpx"),
        25.0,
        "jpeg",
        ("-pix_fmt", "yuv420p", "-crf", "33", "-b:v", "0", "-cpu-used", "4", "-row-mt", "1"),
    ),
    # one palette of the whole film; an ordered pattern stays where it is, which packs well
    ".gif": _Kind(
        ("gif",),
        12.5,
        "png",
        (
            "-filter_complex",
            "scale=800:-2:flags=lanczos,split[a][b];[a]palettegen[p];"
            "[b][p]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle",
        ),
    ),
}


@dataclass(frozen=True)
class FilmMaker:
    """The programs of this machine that make a film, found before anything is computed.

    Attributes
    ----------
    target
        The film.
    browser, ffmpeg
        The programs.
    encoder
        What ffmpeg makes the film with.
    """

    target: Path
    browser: str
    ffmpeg: str
    encoder: str

    @property
    def kind(self) -> _Kind:
        """How its ending is made."""
        return KINDS[self.target.suffix.lower()]

    def command(self, file: Path) -> list[str]:
        """What makes a film of pictures that come one after the other."""
        pictures = ["-f", "image2pipe", "-framerate", f"{self.kind.rate:g}", "-i", "-"]
        coder = ["-c:v", self.encoder, *self.kind.settings]
        return [self.ffmpeg, "-loglevel", "error", "-y", *pictures, *coder, str(file)]


def film_maker(target: str | os.PathLike[str]) -> FilmMaker:
    """Look for what a film needs.

    Parameters
    ----------
    target
        The film: .mp4, .webm or .gif.

    Raises
    ------
    PitchpointError
        If the ending is none of these, the file exists, or Playwright, a program or its encoder is missing.
    """
    path = Path(target)
    kind = KINDS.get(path.suffix.lower())
    if kind is None:
        raise PitchpointError(f"{path.name} has no ending of a film; use {', '.join(KINDS)}")
    check_place(path)
    if path.exists():
        raise PitchpointError(f"{path} is there already, and a film replaces no file; choose another name")
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    ffmpeg = shutil.which("ffmpeg")
    missing = [name for name, found in (("chromium", browser), ("ffmpeg", ffmpeg)) if found is None]
    if browser is None or ffmpeg is None:
        raise PitchpointError(
            f"a film needs {' and '.join(missing)}, which {'is' if len(missing) == 1 else 'are'} not "
            f"installed; on Debian and Ubuntu: apt install {' '.join(missing)}. Pages save films too"
        )
    if importlib.util.find_spec("playwright") is None:
        raise PitchpointError(
            "a film needs Playwright, which drives the browser; pip install 'pitchpoint[film]'. "
            "Pages save films too"
        )
    listed = subprocess.run(
        [ffmpeg, "-hide_banner", "-encoders"], capture_output=True, text=True, check=False
    )
    known = {line.split()[1] for line in listed.stdout.splitlines() if len(line.split()) > 1}
    encoder = next((name for name in kind.encoders if name in known), None)
    if encoder is None:
        others = [ending for ending, other in KINDS.items() if known & set(other.encoders)]
        raise PitchpointError(
            f"this ffmpeg ({ffmpeg}) writes no {path.suffix.lower()}, "
            f"it has no {' or '.join(kind.encoders)}; "
            + (f"it writes {', '.join(others)}" if others else "install one with encoders")
        )
    return FilmMaker(path, browser, ffmpeg, encoder)


def film(page: str | os.PathLike[str], maker: FilmMaker, progress: Progress = silent) -> Path:
    """Write the record of a page of `write_view` as a film.

    Parameters
    ----------
    page
        The page.
    maker
        The film and what makes it, from `film_maker`.
    progress
        Called after every picture.

    Raises
    ------
    PitchpointError
        If a program fails, or the scene does not move.
    """
    with _shown(maker.browser, Path(page).resolve().as_uri()) as seen:
        first, last = seen.evaluate("pitchpointViewer.state().window")
        if not last > first:
            raise PitchpointError("the scene has no motion over time, so there is no film of it")
        camera = seen.context.new_cdp_session(seen)
        count = round(maker.kind.rate * LENGTH)
        times = (first + (last - first) * k / (count - 1) for k in range(count))
        encode(maker, (_picture(seen, camera, time, maker.kind.picture) for time in times), count, progress)
    return maker.target


def encode(maker: FilmMaker, pictures: Iterable[bytes], count: int, progress: Progress = silent) -> None:
    """Hand pictures to ffmpeg.

    Parameters
    ----------
    maker
        The film and what makes it.
    pictures
        Jpeg or png files.
    count
        How many there are.
    progress
        Called after every picture.

    Raises
    ------
    PitchpointError
        If ffmpeg fails.
    """
    make_folder(maker.target)
    pipe = subprocess.PIPE
    with (
        replacing(maker.target) as draft,
        subprocess.Popen(maker.command(draft), stdin=pipe, stderr=pipe) as process,
    ):
        assert process.stdin is not None and process.stderr is not None
        try:
            for k, picture in enumerate(pictures):
                process.stdin.write(picture)
                progress(k + 1, count)
            process.stdin.close()
        except BrokenPipeError:
            pass  # ffmpeg states why below
        words = process.stderr.read().decode(errors="replace").strip()
        if process.wait() != 0:
            raise PitchpointError(f"ffmpeg cannot write {maker.target.name}: {words or 'it gives no reason'}")


@contextmanager
def _shown(program: str, address: str) -> Iterator[Page]:
    """A page with a scene, once it shows it."""
    from playwright.sync_api import Error, sync_playwright

    root = hasattr(os, "geteuid") and os.geteuid() == 0
    try:
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(
                executable_path=program, args=FLAGS.split(), chromium_sandbox=not root
            )
            page = browser.new_page(viewport={"width": SIZE[0], "height": SIZE[1]})
            page.set_default_timeout(1e3 * PATIENCE)
            page.goto(address)
            if page.wait_for_function(READY).json_value() != "scene":
                raise PitchpointError("the browser cannot show this scene")
            yield page
    except Error as error:
        raise PitchpointError(f"the browser ({program}) fails: {error.message.splitlines()[0]}") from None


def _picture(page: Page, camera: CDPSession, time: float, kind: str) -> bytes:
    """The page at an instant [s], as jpeg or png."""
    page.evaluate(f"pitchpointViewer.seek({time!r}); pitchpointViewer.draw()")
    # Playwright's own screenshot takes a fifth longer
    quality = {"quality": 90} if kind == "jpeg" else {}
    return base64.b64decode(camera.send("Page.captureScreenshot", {"format": kind, **quality})["data"])
