# SPDX-License-Identifier: Apache-2.0
"""The page on faults of teeth: its files and its numbers are tried as they stand there."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.tooth_faults import FAULTS
from pitchpoint.model.keys import keys_of
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from pitchpoint.system.compile import compile_model

TEXT = (Path(__file__).parents[2] / "docs" / "faults.md").read_text(encoding="utf-8")
FILES = re.findall(r"^```yaml\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)


def test_the_table_names_all_types_and_their_keys():
    rows = dict(re.findall(r"^\| `(\w+)` \| .* \| (.*) \| .* \|$", TEXT, re.MULTILINE))
    rows.pop("type")
    assert set(rows) == set(FAULTS)
    for name, keys in rows.items():
        assert set(re.findall(r"`(\w+)`", keys)) == set(keys_of(FAULTS[name])) - {"severity"}


@pytest.mark.parametrize("number", range(len(FILES)))
def test_the_files_run_and_every_fault_makes_a_difference(number):
    model = loads_model(FILES[number])
    labels = [(g, f) for g, gear in model.gears.items() for f in gear.faults]
    assert labels
    model = model.replace_all({f"gears.{g}.faults.{f}.severity": 0 for g, f in labels})
    pinion = next(iter(model.gears.values()))

    def rolled(changed):
        data = solve_quasistatic(compile_model(changed), "stage", 12, pinion.number_of_teeth)
        return data["deflection[stage]"].values

    healthy = rolled(model)
    for gear, label in labels:
        # of a missing tooth only so much that a slow roll has an equilibrium
        severity = 0.15 if label == "stump" else 1.0
        found = rolled(model.replace(f"gears.{gear}.faults.{label}.severity", severity))
        assert np.abs(found - healthy).max() > 1e-8, label
