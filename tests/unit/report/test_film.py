# SPDX-License-Identifier: Apache-2.0
"""Films of scenes: what stands in their way is told in a sentence; where the programs are, one is made."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest

from pitchpoint.core.errors import PitchpointError
from pitchpoint.report import film as films
from tests.support.browser import CHROMIUM
from tests.support.scene_data import gears, page_of, texts_of


def test_endings_and_files_that_are_there_are_refused(tmp_path: Path) -> None:
    with pytest.raises(PitchpointError, match=r"film.avi has no ending of a film; use .mp4, .webm, .gif"):
        films.film(tmp_path / "page.html", tmp_path / "film.avi")
    (tmp_path / "mine.mp4").write_bytes(b"mine")
    with pytest.raises(PitchpointError, match="is there already, and a film replaces no file"):
        films.film(tmp_path / "page.html", tmp_path / "mine.mp4")
    assert (tmp_path / "mine.mp4").read_bytes() == b"mine"


def test_missing_programs_are_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda name: None)
    with pytest.raises(PitchpointError, match="needs chromium and ffmpeg, which are not installed"):
        films.film(tmp_path / "page.html", tmp_path / "film.mp4")
    monkeypatch.setattr(shutil, "which", lambda name: "/bin/true" if name == "chromium" else None)
    with pytest.raises(PitchpointError, match="needs ffmpeg, which is not installed.*apt install ffmpeg"):
        films.film(tmp_path / "page.html", tmp_path / "film.mp4")


@pytest.mark.skipif(
    not CHROMIUM or not shutil.which("ffmpeg"), reason="no Chromium or no ffmpeg; install both to run it"
)
def test_a_film_has_a_picture_for_every_instant(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page, target, done = tmp_path / "page.html", tmp_path / "film.mp4", []
    page.write_text(page_of(texts_of(*gears())), encoding="utf-8")
    monkeypatch.setattr(films, "LENGTH", 0.2)
    films.film(page, target, lambda k, n, note="": done.append((k, n)))
    assert done == [(k, 5) for k in range(1, 6)]
    probe = ["ffprobe", "-loglevel", "error", "-count_frames", "-show_entries", "stream", "-of", "json"]
    found = json.loads(subprocess.run([*probe, target], capture_output=True, text=True, check=True).stdout)
    stream = found["streams"][0]
    assert (stream["width"], stream["height"], int(stream["nb_read_frames"])) == (1280, 800, 5)
