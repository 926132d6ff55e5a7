# SPDX-License-Identifier: Apache-2.0
"""The broken tooth of the shovel gearbox on the page of `pitchpoint diagnose`."""

from __future__ import annotations

import html
import re
from pathlib import Path

import h5py
import numpy as np
import pytest

from pitchpoint.cli.main import run_command

FILE = Path(__file__).parents[2] / "examples" / "shovel-gearbox" / "paper.yaml"


def softest_place(result: str) -> float:
    """Angle of the third shaft [deg], from t = 3 s, at which stage 3 lacks the stiffness of the broken tooth:
    centroid, over one turn, of the stiffness below the median of the 11 pitches at the same phase."""
    with h5py.File(result) as record:
        angle, stiffness = record["angle[third]"][()], record["mesh_stiffness[stage_3]"][()]
        start = int(np.searchsorted(record["time"][()], 3.0))
    turns = np.abs(angle[start:] - angle[start]) / (2.0 * np.pi)
    places = np.floor(turns % 1.0 * 440).astype(int)
    mean = np.bincount(places, stiffness[start:], 440) / np.bincount(places, minlength=440)
    pitches = mean.reshape(11, 40)
    missing = np.clip(np.median(pitches, axis=0) - pitches, 0.0, None).ravel()
    centre = np.angle(missing @ np.exp(2j * np.pi * (np.arange(440) + 0.5) / 440))
    return float(np.degrees(centre)) % 360.0


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
    # ten tests of orders and sidebands, and of the period in the level of each of five gears
    assert "by noise alone: less than 0.001 %, over all 15 tests" in text
    place = re.search(r"the tooth of 11 that meshes [\d.]+ pitches \((\d+)°\) after t = 3 s", text)
    assert place, "the event lasts as long as a pitch of Z5: its tooth is named"
    assert abs(float(place[1]) - softest_place(result)) < 0.5 * 360.0 / 11
    assert "FM4" in printed
    assert "too few revolutions of output or output_right (0.9" in text
    for frequency in ("135.7 Hz", "20.1 Hz", "3.251 Hz"):
        assert frequency in text
