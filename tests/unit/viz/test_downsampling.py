# SPDX-License-Identifier: Apache-2.0
"""Min/max decimation never loses a peak."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.viz.downsampling import kept_samples


@given(st.integers(1, 3000), st.integers(1, 500), st.integers(0, 2**31 - 1))
def test_extremes_and_ends_survive(n: int, limit: int, seed: int) -> None:
    x = np.random.default_rng(seed).normal(size=n)
    kept = kept_samples(x, limit)
    assert kept.size <= max(limit, 4)
    assert (np.diff(kept) > 0).all()
    assert {0, n - 1, int(x.argmin()), int(x.argmax())} <= set(kept.tolist())


@given(st.lists(st.integers(0, 49_999), min_size=1, max_size=20, unique=True))
def test_every_single_sample_impact_survives(places: list[int]) -> None:
    """Twenty impacts of one sample each, at most one per bucket kept with its full height."""
    x = np.zeros(50_000)
    x[places] = 1.0 + np.arange(len(places))
    kept = kept_samples(x, 4000)
    buckets: dict[int, int] = {}
    edges = np.linspace(0, x.size, 1001).round()
    for place in places:
        bucket = int(np.searchsorted(edges, place, side="right"))
        buckets[bucket] = max(buckets.get(bucket, place), place, key=lambda p: x[p])
    assert set(buckets.values()) <= set(kept.tolist())


def test_gaps_do_not_hide_peaks() -> None:
    x = np.full(10_000, np.nan)
    x[5000] = 3.0
    assert 5000 in kept_samples(x, 100)
