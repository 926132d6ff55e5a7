# SPDX-License-Identifier: Apache-2.0
"""The page on bevel gears."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from pitchpoint.io.yaml_model import loads_model

PAGE = (Path(__file__).parents[2] / "docs" / "bevel_gears.md").read_text(encoding="utf-8")
MODEL, _, FAULTS = re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL)


def test_the_file_of_the_page_is_a_pair_that_runs():
    model = loads_model(MODEL)
    pair = model.bevel_pairs["stage"]
    assert pair.Sigma == pytest.approx(math.radians(90.0))
    assert pair.problems() == []
    assert pair.eps_gamma > 1.0
    assert model.backlash("stage") == pytest.approx(1e-4 / math.cos(pair.beta_b))
    assert model.body_inertia("input").mass > 0.0


def test_the_faults_of_the_page_are_faults_of_that_pair():
    faults = re.search(r"    faults:\n.*", FAULTS, re.DOTALL)[0]
    model = loads_model(MODEL.replace("    bore_diameter: 12 mm\n", f"    bore_diameter: 12 mm\n{faults}"))
    assert {n: f.form for n, f in model.bevel_gears["pinion"].faults.items()} == {
        "gone": "broken_tooth",
        "chip": "broken_tooth",
        "late": "pitch_error",
    }
