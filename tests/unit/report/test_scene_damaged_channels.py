# SPDX-License-Identifier: Apache-2.0
"""Scenes of results with damaged channels: a channel of another shape or type is missing, not an error."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from pitchpoint.report.scene.build import _Record

TIME = np.linspace(0.0, 1.0, 50)


@pytest.mark.parametrize(
    "damage", [np.float64(1.0), np.zeros((50, 2)), np.full(50, b"x"), np.full(50, np.nan)]
)
def test_a_channel_of_another_shape_or_type_is_not_there(damage: np.ndarray) -> None:
    dims = ("time", "more")[: np.ndim(damage)]
    data = {"whole": ("time", TIME**2), "damaged": (dims, damage)}
    record = _Record.of(xr.Dataset(data, coords={"time": TIME}), bodies=2)
    assert record.at_frames("damaged") is None
    np.testing.assert_array_equal(record.at_frames("whole"), TIME[record.samples] ** 2)
