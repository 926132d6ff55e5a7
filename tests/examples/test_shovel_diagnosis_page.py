# SPDX-License-Identifier: Apache-2.0
"""The broken tooth of the shovel gearbox on the page of `pitchpoint diagnose`."""

from __future__ import annotations

import html
import re
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command

FILE = Path(__file__).parents[2] / "examples" / "shovel-gearbox" / "paper.yaml"


@pytest.mark.study
def test_the_page_names_the_third_shaft_and_its_gears(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Three turns of the third shaft (3.383 s each) and a little; it carries Z5 with the broken tooth."""
    result, page = str(tmp_path / "broken.h5"), tmp_path / "page.html"
    settings = ["gears.Z5.faults.broken.severity=1", "scenarios.rated.duration=13.5 s"]
    options = [word for text in settings for word in ("--set", text)]
    assert run_command(["run", str(FILE), "--scenario", "rated", *options, "-o", result, "-q"]) == 0
    capsys.readouterr()
    assert run_command(["diagnose", result, "-c", "signal[third_force_x]", "-o", str(page)]) == 0
    printed = capsys.readouterr().out
    text = html.unescape(page.read_text(encoding="utf-8"))
    assert re.search(r"A local fault on gear [^(]*Z5[^(]* \(shaft third or third_right, 0.29557 Hz\)", text)
    assert "by noise alone: less than 0.001 %, over all 10 tests" in text
    # Z4 and Z5 turn together: nothing is said about a tooth of one of them, but where on the shaft it is
    assert re.search(r"\d+° after t = 3 s", text) and "pitches" not in text
    assert "FM4" in printed
    assert "too few revolutions of output or output_right (0.9" in text
    for frequency in ("135.7 Hz", "20.1 Hz", "3.251 Hz"):
        assert frequency in text
