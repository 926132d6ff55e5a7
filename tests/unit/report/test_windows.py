# SPDX-License-Identifier: Apache-2.0
"""Terminal, notebook and report name one window of the statistics and give the same numbers."""

from __future__ import annotations

import re
from html import unescape
from pathlib import Path

import pytest

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.report.notebook import dataset_html
from tests.support.model_files import TORSIONAL_PAIR

# the first stored sample of the window is at 12.048 ms
TEXT = TORSIONAL_PAIR.replace(
    "duration: 0.5 s, sample_rate: 100 kHz", "duration: 0.04 s, settle_time: 12 ms, sample_rate: 4.15 kHz"
)
CHANNELS = {
    "mesh force, stage": "mesh_force[stage]",
    "transmission error, stage": "transmission_error[stage]",
}
DIGITS = 5e-4
"""The page has four digits."""
NUMBER = r"[−-]?[\d.]+"


def rows_of(html: str) -> dict[str, list[str]]:
    """Cells by the first cell of each table row."""
    found = {}
    for row in re.findall(r"<tr>(.*?)</tr>", html, re.DOTALL):
        cells = [
            unescape(re.sub("<.*?>", "", c)) for c in re.findall(r"<t[hd].*?>(.*?)</t[hd]>", row, re.DOTALL)
        ]
        found.setdefault(cells[0], cells[1:]) if cells else None
    return found


def numbers(cells: list[str]) -> list[float]:
    """Mean, rms, minimum and maximum [SI prefix of the cell]."""
    return [float(c.replace("−", "-")) for c in cells]


def test_one_window_and_the_same_numbers(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, run = tmp_path / "pair.yaml", tmp_path / "run.h5"
    file.write_text(TEXT)
    assert run_command(["run", str(file), "-s", "steady", "-o", str(run)]) == 0
    said = capsys.readouterr().out
    notebook = dataset_html(pp.open_result(run))
    page = pp.write_report(file, tmp_path / "page.html", run).read_text(encoding="utf-8")
    window = "tatistics from 12 to 40 ms"
    assert window in said and window in notebook
    # summary, contact of the flanks, extremes
    assert page.count(window) == 3 and "tatistics from 12.0" not in page
    extremes = rows_of(page[page.index('<section id="extremes"') :])
    shown = rows_of(notebook)
    for name, terminal in CHANNELS.items():
        unit, mean, rms, low, _, high, _ = extremes[name]
        expected = numbers([mean, rms, low, high])
        assert shown[name][0] == unit
        assert numbers(shown[name][1:]) == pytest.approx(expected, rel=DIGITS)
        line = next(line for line in said.splitlines() if line.strip().startswith(terminal))
        printed = numbers(re.findall(rf"({NUMBER}) {re.escape(unit)}", line))
        assert printed == pytest.approx(expected, rel=DIGITS)


def test_a_note_of_a_run_is_on_the_page_once(tmp_path: Path) -> None:
    """In the remarks of the summary, not again above the curves or in the provenance."""
    file, run = tmp_path / "pair.yaml", tmp_path / "run.h5"
    file.write_text(TEXT.replace("sample_rate: 4.15 kHz", "sample_rate: 4.15 kHz, step: 7 us"))
    assert run_command(["run", str(file), "-s", "steady", "-o", str(run), "--quiet"]) == 0
    page = pp.write_report(file, tmp_path / "page.html", run).read_text(encoding="utf-8")
    assert page.count("steps divide the sample period") == 1
    summary = page[page.index('<section id="summary"') : page.index('<section id="time"')]
    assert "<h3>Remarks</h3>" in summary and "steps divide the sample period" in summary
