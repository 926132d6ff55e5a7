# SPDX-License-Identifier: Apache-2.0
"""Damaged channels of a record: omitted once, where a report reads the file."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from pitchpoint.cli.examples import examples_folder
from pitchpoint.io.yaml_model import load_model
from pitchpoint.report.collect import time_run, without_damaged

TIME = np.linspace(0.0, 1.0, 50)
DAMAGE = (np.float64(1.0), np.zeros((50, 2)), np.full(50, b"x"), np.zeros(50, complex))


@pytest.mark.parametrize("damage", DAMAGE)
def test_only_numbers_over_time_and_events_stay(damage: np.ndarray) -> None:
    dims = ("time", "more")[: np.ndim(damage)]
    data = {"whole": ("time", TIME**2), "damaged": (dims, damage), "event_name": ("event", ["slip"])}
    found, lost = without_damaged(xr.Dataset(data, coords={"time": TIME}))
    assert lost == ["damaged"]
    assert set(found.data_vars) == {"whole", "event_name"}


@pytest.mark.parametrize(
    ("values", "settle", "words"),
    [([1.0, 2.0, 3.0], 5.0, "fewer than two samples"), ([1.0, 2.0, np.nan], 0.0, "finite")],
)
def test_an_unfinished_run_of_a_turbine_has_no_fatigue_loads(values, settle, words):
    """A run that ended before its settle time, or with a sample that is not a number."""
    model = load_model(examples_folder() / "wind-turbine" / "model.yaml")
    data = xr.Dataset({"beam_force[tower.1.i.my]": ("time", values)}, {"time": [0.0, 0.1, 0.2]})
    data.attrs["options"] = f'{{"settle_time": {settle}}}'
    run = time_run(model, data, data.attrs, "This run is not complete: failed.")
    assert not run.fatigue
    assert run.note.startswith("This run is not complete: failed. No fatigue loads: ") and words in run.note
