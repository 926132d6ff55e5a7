# SPDX-License-Identifier: Apache-2.0
"""Video of a scene: frames rendered by a headless browser and encoded by ffmpeg.

Both are programs of the operating system; Playwright controls the browser. Missing programs are reported
before anything is computed.
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
from pitchpoint.report.browser import installed_browser, open_page

if TYPE_CHECKING:
    from playwright.sync_api import CDPSession, Page

LENGTH = 10.0
"""Duration of a video [s]; the time axis of the record is scaled to it."""
SIZE = (1280, 800)
PATIENCE = 120.0
"""Timeout for the browser [s]."""
READY = "document.querySelector('.ppv')?.dataset.ready ?? ''"


@dataclass(frozen=True)
class _Kind:
    """Encoding of one file format.

    Attributes
    ----------
    encoders
        Suitable encoders of ffmpeg, the best first.
    rate
        Frames per second.
    picture
        Format of the frames: jpeg, or png for formats with a palette.
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
    # constant quality requires a bit rate of 0; speed 5 of 9 halves the time for a few per cent of size
    ".webm": _Kind(
        ("libvpx-vp9", "libvpx"),
        25.0,
        "jpeg",
        ("-pix_fmt", "yuv420p", "-crf", "33", "-b:v", "0", "-cpu-used", "4", "-row-mt", "1"),
    ),
    # one palette for the whole video; ordered dithering is constant from frame to frame and compresses well
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
    """Programs on this computer that create a video, located before anything is computed.

    Attributes
    ----------
    target
        File of the video.
    browser, ffmpeg
        Paths of the programs.
    encoder
        Encoder of ffmpeg.
    """

    target: Path
    browser: str
    ffmpeg: str
    encoder: str

    @property
    def kind(self) -> _Kind:
        """Encoding for the file extension."""
        return KINDS[self.target.suffix.lower()]

    def command(self, file: Path) -> list[str]:
        """Command line of ffmpeg that encodes a stream of frames."""
        pictures = ["-f", "image2pipe", "-framerate", f"{self.kind.rate:g}", "-i", "-"]
        coder = ["-c:v", self.encoder, *self.kind.settings]
        return [self.ffmpeg, "-loglevel", "error", "-y", *pictures, *coder, str(file)]


def film_maker(target: str | os.PathLike[str]) -> FilmMaker:
    """Locate the programs required for a video.

    Parameters
    ----------
    target
        File of the video: .mp4, .webm or .gif.

    Raises
    ------
    PitchpointError
        If the extension is not supported, the file exists, or Playwright, a program or an encoder is missing.
    """
    path = Path(target)
    kind = KINDS.get(path.suffix.lower())
    if kind is None:
        raise PitchpointError(f"{path.name} has no video extension; use {', '.join(KINDS)}")
    check_place(path)
    if path.exists():
        raise PitchpointError(f"{path} exists, and a video does not replace files; choose another name")
    browser = installed_browser()
    ffmpeg = shutil.which("ffmpeg")
    missing = [name for name, found in (("chromium", browser), ("ffmpeg", ffmpeg)) if found is None]
    if browser is None or ffmpeg is None:
        raise PitchpointError(
            f"a video requires {' and '.join(missing)}, which {'is' if len(missing) == 1 else 'are'} not "
            f"installed; on Debian and Ubuntu: apt install {' '.join(missing)}. Pages save videos, too"
        )
    if importlib.util.find_spec("playwright") is None:
        raise PitchpointError(
            "a video requires Playwright, which controls the browser; pip install 'pitchpoint[film]'. "
            "Pages save videos, too"
        )
    listed = subprocess.run(
        [ffmpeg, "-hide_banner", "-encoders"], capture_output=True, text=True, check=False
    )
    known = {line.split()[1] for line in listed.stdout.splitlines() if len(line.split()) > 1}
    encoder = next((name for name in kind.encoders if name in known), None)
    if encoder is None:
        others = [ending for ending, other in KINDS.items() if known & set(other.encoders)]
        raise PitchpointError(
            f"this ffmpeg ({ffmpeg}) cannot write {path.suffix.lower()} files, "
            f"it lacks the encoder {' or '.join(kind.encoders)}; "
            + (f"it writes {', '.join(others)}" if others else "install one with encoders")
        )
    return FilmMaker(path, browser, ffmpeg, encoder)


def film(page: str | os.PathLike[str], maker: FilmMaker, progress: Progress = silent) -> Path:
    """Write the motion in a page of `write_view` as a video.

    Parameters
    ----------
    page
        HTML page with the scene.
    maker
        Target file and programs, from `film_maker`.
    progress
        Called after every picture.

    Raises
    ------
    PitchpointError
        If a program fails, or the scene has no motion.
    """
    with _shown(maker.browser, Path(page).resolve().as_uri()) as seen:
        first, last = seen.evaluate("pitchpointViewer.state().window")
        if not last > first:
            raise PitchpointError("the scene has no motion over time, so no video can be written")
        camera = seen.context.new_cdp_session(seen)
        count = round(maker.kind.rate * LENGTH)
        times = (first + (last - first) * k / (count - 1) for k in range(count))
        encode(maker, (_picture(seen, camera, time, maker.kind.picture) for time in times), count, progress)
    return maker.target


def encode(maker: FilmMaker, pictures: Iterable[bytes], count: int, progress: Progress = silent) -> None:
    """Encode frames with ffmpeg.

    Parameters
    ----------
    maker
        The film and what makes it.
    pictures
        Contents of jpeg or png files.
    count
        Number of frames.
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
            pass  # the error output of ffmpeg is reported below
        words = process.stderr.read().decode(errors="replace").strip()
        if process.wait() != 0:
            raise PitchpointError(f"ffmpeg cannot write {maker.target.name}: {words or 'no reason given'}")


@contextmanager
def _shown(program: str, address: str) -> Iterator[Page]:
    """Open page with a scene, after its first drawing."""
    with open_page(program, *SIZE) as page:
        page.set_default_timeout(1e3 * PATIENCE)
        page.goto(address)
        if page.wait_for_function(READY).json_value() != "scene":
            raise PitchpointError("the browser cannot show this scene")
        yield page


def _picture(page: Page, camera: CDPSession, time: float, kind: str) -> bytes:
    """Screenshot of the page at a time [s], as jpeg or png."""
    page.evaluate(f"pitchpointViewer.seek({time!r}); pitchpointViewer.draw()")
    # the screenshot function of Playwright takes 20 % longer
    quality = {"quality": 90} if kind == "jpeg" else {}
    return base64.b64decode(camera.send("Page.captureScreenshot", {"format": kind, **quality})["data"])
