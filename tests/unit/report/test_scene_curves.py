# SPDX-License-Identifier: Apache-2.0
"""Curves of a scene: all samples of a short record, pieces with their mean of a long one."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from pitchpoint.report.scene.curves import scene_curves


def curves(samples: int, others: int = 1):
    time = np.linspace(0.0, 1.0, samples)
    values = {"speed[a]": 10.0 + np.sin(300.0 * time)}
    values |= {f"angle[b{k}]": time**2 for k in range(others)}
    data = xr.Dataset({n: ("time", x) for n, x in values.items()}, {"time": time})
    return {c.name: c for c in scene_curves(data, ["speed[a]"])}, time, values


def test_short_records_have_all_samples():
    found, time, values = curves(4000)
    for name, channel in found.items():
        assert np.array_equal(channel.times, time)
        assert all(np.array_equal(x, values[name]) for x in (channel.least, channel.most, channel.mean))


@pytest.mark.parametrize(("name", "pieces"), [("speed[a]", 6666), ("angle[b0]", 1000)])
def test_long_records_have_pieces_with_their_mean(name, pieces):
    found, time, values = curves(60_000)
    channel, x = found[name], values[name]
    assert len(channel.times) == pieces
    starts = np.searchsorted(time, channel.times)
    for k in (0, 17, pieces - 1):
        part = x[starts[k] : (*starts, time.size)[k + 1]]
        known = (part.min(), part.max(), part.mean())
        assert (channel.least[k], channel.most[k], channel.mean[k]) == pytest.approx(known, rel=1e-12)


def test_thousands_of_channels_have_fewer_pieces():
    found, _, _ = curves(2_000, 3000)
    assert len(found["angle[b0]"].times) == pytest.approx(5e6 / 3000 / 3, rel=0.01)
