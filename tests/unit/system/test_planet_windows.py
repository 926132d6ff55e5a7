# SPDX-License-Identifier: Apache-2.0
"""Notes on planets whose statistics cover a part of a turn."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import pitchpoint
from pitchpoint.system.planet_windows import turning_body, window_notes

FILE = Path(__file__).parents[3] / "examples" / "wind-drive-5mw" / "model.yaml"


@pytest.mark.filterwarnings("ignore:profile shifts:pitchpoint.ValidityWarning")
@pytest.mark.parametrize(("turns", "noted"), [(2.0, False), (1.25, True), (math.nan, False), (0.0, False)])
def test_a_note_for_parts_of_a_turn(turns, noted):
    """Statistics are NaN if a run ends before its window begins."""
    model = pitchpoint.load_model(FILE)
    bodies = (model.planetary_stages["stage_1"].carrier, "main_shaft")
    statistics = {f"speed[{body}]": {"mean": turns * math.tau / 10.0} for body in bodies}
    assert turning_body(model, bodies[0], "speed", statistics) == bodies[0]
    found = [str(each) for each in window_notes(model, statistics, 10.0)]
    assert any("1.25 turns of carrier_1" in each for each in found) == noted
