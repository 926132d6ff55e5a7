# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint modes`: rows in the order of the natural frequency that they show."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from tests.support.cli_files import json_of

DISCS = """\
bodies:
  light: {motion: torsion, inertia: 1 kg m^2}
  heavy: {motion: torsion, position: [0, 0, 1 m], inertia: 1 kg m^2}
bearings:
  a: {body: light, stiffness: {torsion: 9e4}}
  b: {body: heavy, stiffness: {torsion: 1e5}, damping: {torsion: 300}}
"""


def test_rows_are_in_the_order_of_what_they_show(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """300 rad/s without damping, and 316 rad/s that damping lowers to 278 rad/s."""
    file = tmp_path / "discs.yaml"
    file.write_text(DISCS, encoding="utf-8")
    rows = json_of(["modes", str(file)], capsys)["modes"]
    hertz = [math.sqrt(k - c * c / 4.0) / (2.0 * math.pi) for k, c in ((9e4, 0.0), (1e5, 300.0))]
    assert [row["frequency"] for row in rows] == pytest.approx(hertz)
    assert run_command(["modes", str(file)]) == 0
    printed = capsys.readouterr().out
    assert 0 < printed.index(f"{hertz[1]:.6g} Hz") < printed.index(f"{hertz[0]:.6g} Hz")
