# SPDX-License-Identifier: Apache-2.0
"""Films of scenes: what is in their way is told in a sentence; where the programs are, one is made."""

from __future__ import annotations

import importlib.util
import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import PitchpointError
from pitchpoint.report import film as films
from tests.support.browser import CHROMIUM
from tests.support.model_files import TORSIONAL_PAIR
from tests.support.scene_data import gears, page_of, texts_of


def test_endings_and_files_that_are_there_are_refused(tmp_path: Path) -> None:
    with pytest.raises(PitchpointError, match=r"film.avi has no video extension; use .mp4, .webm, .gif"):
        films.film_maker(tmp_path / "film.avi")
    (tmp_path / "mine.mp4").write_bytes(b"mine")
    with pytest.raises(PitchpointError, match="exists, and a video does not replace files"):
        films.film_maker(tmp_path / "mine.mp4")
    assert (tmp_path / "mine.mp4").read_bytes() == b"mine"


def test_missing_programs_are_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda name: None)
    with pytest.raises(PitchpointError, match="requires chromium and ffmpeg, which are not installed"):
        films.film_maker(tmp_path / "film.mp4")
    monkeypatch.setattr(shutil, "which", lambda name: "/bin/true" if name == "chromium" else None)
    with pytest.raises(PitchpointError, match="requires ffmpeg, which is not installed.*apt install ffmpeg"):
        films.film_maker(tmp_path / "film.mp4")


def test_missing_playwright_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda name: "/bin/true")
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    with pytest.raises(PitchpointError, match=r"requires Playwright.*pip install 'pitchpoint\[film\]'"):
        films.film_maker(tmp_path / "film.mp4")


def test_a_browser_that_fails_is_a_sentence(tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    page.write_text("", encoding="utf-8")
    maker = films.FilmMaker(tmp_path / "film.mp4", "/bin/false", "/bin/true", "mpeg4")
    with pytest.raises(PitchpointError, match=r"the browser \(/bin/false\) failed: .+"):
        films.film(page, maker)
    assert not maker.target.exists()


def test_an_ffmpeg_without_the_encoder_is_told_and_what_it_can_write(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program = tmp_path / "ffmpeg"
    program.write_text(
        "#!/bin/sh\necho ' V....D gif    GIF'\necho ' V....D libvpx    VP8'\n", encoding="utf-8"
    )
    program.chmod(0o755)
    monkeypatch.setattr(shutil, "which", lambda name: str(program))
    with pytest.raises(
        PitchpointError,
        match=r"cannot write .mp4 files, it lacks the encoder libx264 or .*; it writes .webm, .gif",
    ):
        films.film_maker(tmp_path / "film.mp4")
    assert films.film_maker(tmp_path / "film.webm").encoder == "libvpx"


def test_what_is_missing_is_told_before_a_page_is_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    model, page = tmp_path / "pair.yaml", tmp_path / "page.html"
    model.write_text(TORSIONAL_PAIR, encoding="utf-8")
    monkeypatch.setattr(shutil, "which", lambda name: None)
    assert run_command(["view", str(model), "-o", str(page), "--film", str(tmp_path / "film.gif")]) == 2
    assert "requires chromium and ffmpeg" in capsys.readouterr().err
    assert not page.exists()


def stream_of(target: Path) -> dict[str, Any]:
    probe = ["ffprobe", "-loglevel", "error", "-count_frames", "-show_entries", "stream", "-of", "json"]
    found = json.loads(subprocess.run([*probe, target], capture_output=True, text=True, check=True).stdout)
    return dict(found["streams"][0])


@pytest.mark.skipif(not shutil.which("ffmpeg"), reason="no ffmpeg on this machine; install it to run it")
@pytest.mark.parametrize(
    ("ending", "size", "codecs", "span"),
    [
        (".mp4", (640, 400), ("h264", "mpeg4"), 0.24),
        (".webm", (640, 400), ("vp9", "vp8"), 0.24),
        (".gif", (800, 500), ("gif",), 0.48),
    ],
)
def test_pictures_become_films_of_every_ending(
    tmp_path: Path, ending: str, size: tuple[int, int], codecs: tuple[str, ...], span: float
) -> None:
    """All pictures are in the film, in their order, for the time that they last."""
    source = ["-f", "lavfi", "-i", "testsrc=size=640x400:rate=6:duration=1", str(tmp_path / "picture-%d.png")]
    subprocess.run(["ffmpeg", "-loglevel", "error", *source], check=True)
    pictures = [(tmp_path / f"picture-{k}.png").read_bytes() for k in range(1, 7)]
    target = tmp_path / f"film{ending}"
    films.encode(films.film_maker(target), pictures, len(pictures))
    stream = stream_of(target)
    assert (stream["width"], stream["height"]) == size and stream["codec_name"] in codecs
    assert int(stream["nb_read_frames"]) == 6
    numerator, denominator = map(int, stream["r_frame_rate"].split("/"))
    assert 6 * denominator / numerator == pytest.approx(span, rel=0.02)
    # none is held while others pass: each is another picture
    subprocess.run(["ffmpeg", "-loglevel", "error", "-i", target, tmp_path / "seen-%d.png"], check=True)
    assert len({path.read_bytes() for path in tmp_path.glob("seen-*.png")}) == 6


@pytest.mark.skipif(not shutil.which("ffmpeg"), reason="no ffmpeg on this machine; install it to run it")
def test_what_ffmpeg_says_is_told(tmp_path: Path) -> None:
    with pytest.raises(PitchpointError, match=r"ffmpeg cannot write film.gif: .+"):
        films.encode(films.film_maker(tmp_path / "film.gif"), [b"no picture"], 1)


@pytest.mark.skipif(
    not CHROMIUM or not shutil.which("ffmpeg"), reason="no Chromium or no ffmpeg; install both to run it"
)
@pytest.mark.study
def test_a_film_has_a_picture_for_every_instant(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page, target, done = tmp_path / "page.html", tmp_path / "film.mp4", []
    page.write_text(page_of(texts_of(*gears())), encoding="utf-8")
    monkeypatch.setattr(films, "LENGTH", 0.2)
    films.film(page, films.film_maker(target), lambda k, n, note="": done.append((k, n)))
    assert done == [(k, 5) for k in range(1, 6)]
    stream = stream_of(target)
    assert (stream["width"], stream["height"], int(stream["nb_read_frames"])) == (1280, 800, 5)
