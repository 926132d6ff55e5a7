# SPDX-License-Identifier: Apache-2.0
"""The page on faults of bearings, seats and axes: its files run, its tables name all types."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.bearing_fault import BEARING_FAULTS
from pitchpoint.model.components.gear_faults import SEAT_FAULTS
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

TEXT = (Path(__file__).parents[2] / "docs" / "bearing_faults.md").read_text(encoding="utf-8")
FILES = re.findall(r"^```yaml\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)


def test_the_tables_name_all_types():
    rows = set(re.findall(r"^\| `(\w+)` \|", TEXT, re.MULTILINE)) - {"type"}
    assert rows == {*BEARING_FAULTS, *SEAT_FAULTS}


@pytest.mark.parametrize("number", range(len(FILES)))
def test_the_files_run_and_every_fault_makes_a_difference(number):
    model = loads_model(FILES[number])
    places = [
        f"{group}.{name}.faults.{label}.severity"
        for group in ("gears", "bearings", "rolling_bearings")
        for name, part in getattr(model, group).items()
        for label in part.faults
    ]
    places += [f"meshes.{name}.misalignment.severity" for name, m in model.meshes.items() if m.misalignment]
    assert places

    def force(changed):
        system = compile_model(changed, "run")
        if changed.meshes:
            return solve_quasistatic(system, "stage", 8, 20)["deflection[stage]"].values
        data = solve_time(system)
        return np.concatenate([data[name].values for name in data if name.endswith((".fx]", ".fy]"))])

    healthy = force(model.replace_all(dict.fromkeys(places, 0)))
    for place in places:
        changed = model.replace_all({**dict.fromkeys(places, 0), place: 1})
        found = force(changed)
        assert np.abs(found - healthy).max() > 1e-5 * np.abs(healthy).max(), place
