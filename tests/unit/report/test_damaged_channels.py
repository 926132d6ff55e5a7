# SPDX-License-Identifier: Apache-2.0
"""Damaged channels of a record: omitted once, where a report reads the file."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from pitchpoint.report.collect import without_damaged

TIME = np.linspace(0.0, 1.0, 50)
DAMAGE = (np.float64(1.0), np.zeros((50, 2)), np.full(50, b"x"), np.zeros(50, complex))


@pytest.mark.parametrize("damage", DAMAGE)
def test_only_numbers_over_time_and_events_stay(damage: np.ndarray) -> None:
    dims = ("time", "more")[: np.ndim(damage)]
    data = {"whole": ("time", TIME**2), "damaged": (dims, damage), "event_name": ("event", ["slip"])}
    found, lost = without_damaged(xr.Dataset(data, coords={"time": TIME}))
    assert lost == ["damaged"]
    assert set(found.data_vars) == {"whole", "event_name"}
