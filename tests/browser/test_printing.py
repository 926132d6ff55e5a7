# SPDX-License-Identifier: Apache-2.0
"""Pages that are printed as soon as they have loaded, without anybody waiting: all plots are on the paper."""

from __future__ import annotations

import base64
import re
import shutil
import subprocess
import zlib
from pathlib import Path

import numpy as np
import plotly.graph_objects as go
import pytest

from pitchpoint.viz.report.page import Section, asset, page
from pitchpoint.viz.tables import plain_table
from tests.support.browser import CHROMIUM, needs_browser

pytestmark = needs_browser
FLAGS = (
    *"--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-extensions".split(),
    *"--disable-background-networking --disable-component-update --disable-sync".split(),
)
POINTS = 900


def chromium(folder: Path, text: str, *orders: str) -> str:
    """What the browser says to an order about a page, without any waiting."""
    file = folder / "page.html"
    file.write_text(text, encoding="utf-8")
    assert CHROMIUM is not None
    command = [CHROMIUM, *FLAGS, f"--user-data-dir={folder / 'profile'}", *orders, file.as_uri()]
    return subprocess.run(command, capture_output=True, text=True, check=True, timeout=120).stdout


def test_plots_are_on_the_paper_of_a_page_that_is_printed_at_once(tmp_path: Path) -> None:
    section = Section("signals", "Signals")
    x = np.arange(float(POINTS))
    for amplitude in (1.0, 2.0, 3.0):
        section.add_figure(go.Figure(go.Scatter(x=x, y=amplitude * (-1.0) ** x, mode="lines")))
    paper = tmp_path / "paper.pdf"
    chromium(tmp_path, page("printed", [], [section], ""), f"--print-to-pdf={paper}")
    lines = 0
    for stream in re.findall(rb"stream\r?\n(.*?)endstream", paper.read_bytes(), re.DOTALL):
        try:
            drawn = zlib.decompress(stream)
        except zlib.error:
            continue
        lines += len(re.findall(rb" l\n", drawn))
    # every plot is one line through all points; frames and ticks are a few strokes more
    assert 3 * (POINTS - 1) <= lines < 3 * (POINTS - 1) + 600


def test_what_zlib_packs_comes_out_as_it_was(tmp_path: Path) -> None:
    """Stored blocks, codes fixed and made for the text, matches that overlap themselves, and the library."""
    random = np.random.default_rng(2)
    texts = [
        b"",
        b"abc",
        70_000 * b"a",
        random.integers(0, 256, 90_000, dtype=np.uint8).tobytes(),
        random.integers(0, 3, 90_000, dtype=np.uint8).tobytes(),
        asset("report.css").encode() * 5,
    ]
    cases = []
    for text in texts:
        for level, strategy in ((9, 0), (1, 0), (0, 0), (9, zlib.Z_FIXED), (9, zlib.Z_HUFFMAN_ONLY)):
            packer = zlib.compressobj(level, zlib.DEFLATED, -15, 9, strategy)
            packed = packer.compress(text) + packer.flush()
            cases.append((base64.b64encode(packed).decode(), len(text), zlib.crc32(text)))
    script = """
      const table = Array.from({length: 256}, (_, n) => {
        for (let k = 0; k < 8; k++) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
        return n >>> 0;
      });
      const crc = (bytes) => ~bytes.reduce((sum, x) => (sum >>> 8) ^ table[(sum ^ x) & 255], -1) >>> 0;
      const unpacked = (text, size) => inflate(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)), size);
      const found = cases.map(([text, size, sum]) => crc(unpacked(text, size)) === sum);
      let damaged = "taken";
      try { unpacked(cases[5][0].slice(0, 2), 3); } catch (error) { damaged = error.message; }
      document.body.textContent = JSON.stringify([found, damaged]);
    """
    listed = ",".join(f"['{text}',{size},{crc}]" for text, size, crc in cases)
    scripts = (asset("inflate.js"), f"const cases=[{listed}];{script}")
    body = "<body></body>" + "".join(f"<script>{one}</script>" for one in scripts)
    said = chromium(tmp_path, f"<!DOCTYPE html><html>{body}</html>", "--dump-dom")
    found = re.search(r'\[\[(.*?)\],"(.*?)"\]', said)
    assert found is not None, said
    assert found.group(1).split(",") == ["true"] * len(cases)
    assert found.group(2) == "the packed script is damaged"


PDFTOTEXT = shutil.which("pdftotext")
ROWS = 12
"""Rows of the short tables."""


@pytest.mark.skipif(PDFTOTEXT is None, reason="no pdftotext on this machine; install poppler-utils to run it")
def test_headings_stay_with_what_follows_and_short_tables_whole(tmp_path: Path) -> None:
    """At every height on the page: heading, sentence and table of a dozen rows; heading and two plots."""
    line = go.Scatter(x=[0.0, 1.0], y=[0.0, 1.0], mode="lines")
    sections = []
    for k in range(14):
        section = Section(f"s{k}", f"Chapter {k}")
        rows = [f"<tr><th>first{k}</th><td>1</td></tr>"]
        rows += [f"<tr><th>row</th><td>{n}</td></tr>" for n in range(ROWS - 2)]
        table = plain_table(("name", "value"), [*rows, f"<tr><th>last{k}</th><td>1</td></tr>"])
        section.add(
            f"<h4>Table {k}</h4><p>Above table {k}. {'Words and more words. ' * 3 * (k % 3)}</p>{table}"
        )
        section.add(f"<h4>Plots {k}</h4>")
        section.add_figure(go.Figure(line), f"Left {k}", beside=go.Figure(line), beside_caption=f"Right {k}")
        section.add("<p>Something lower.</p>" * (k % 4))
        sections.append(section)
    paper = tmp_path / "paper.pdf"
    chromium(tmp_path, page("printed", [], sections, ""), f"--print-to-pdf={paper}", "--no-pdf-header-footer")
    command = [str(PDFTOTEXT), "-layout", str(paper), "-"]
    said = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout
    pages = said.split("\f")
    assert len(pages) > 8

    def sheet(words: str) -> int:
        (found,) = (n for n, text in enumerate(pages) if re.search(rf"\b{words}\b", text))
        return found

    for k in range(14):
        together = {sheet(f"{words}{k}") for words in ("Table ", "Above table ", "first", "last")}
        assert together == {sheet(f"Chapter {k}")}, k
        assert len({sheet(f"{words} {k}") for words in ("Plots", "Left", "Right")}) == 1, k
