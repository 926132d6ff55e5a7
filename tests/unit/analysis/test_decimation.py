# SPDX-License-Identifier: Apache-2.0
"""Thinning out: what passes, what is stopped, and where the samples lie."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.decimation import PASS, REACH, STOP, decimated, decimation_filter
from pitchpoint.analysis.sampled import SignalError


@pytest.mark.parametrize("factor", [2, 3, 8])
def test_pass_band_and_stop_band(factor: int) -> None:
    """Kaiser's design of 80 dB: ripple 1e-4 below the pass edge and at most 1e-4 left above the stop edge."""
    weights = decimation_filter(factor)
    share = np.linspace(0.0, 0.5 * factor, 4001)  # frequency over the new rate
    n = np.arange(weights.size) - factor * REACH
    gain = np.cos(2.0 * np.pi * np.outer(share / factor, n)) @ weights
    assert np.abs(gain[share <= PASS] - 1.0).max() < 1.2e-4
    assert np.abs(gain[share >= STOP]).max() < 1.2e-4


@pytest.mark.parametrize("factor", [2, 5])
def test_samples_lie_where_they_did(factor: int) -> None:
    """A slow sine keeps its phase: the first sample left belongs to the old sample factor REACH."""
    n = np.arange(factor * (2 * REACH + 40) + 1)
    slow = np.sin(2.0 * np.pi * 0.1 * n / factor + 0.3)
    found = decimated(slow, factor)
    kept = slow[factor * REACH : n.size - factor * REACH : factor]
    assert found.shape == kept.shape
    np.testing.assert_allclose(found, kept, atol=1.2e-4)  # the ripple of the pass band
    both = decimated(np.column_stack([slow, 2.0 * slow]), factor)
    np.testing.assert_allclose(both, np.column_stack([found, 2.0 * found]), atol=1e-14)


def test_too_short_or_nothing_to_do() -> None:
    with pytest.raises(SignalError, match="less than the filter has"):
        decimated(np.zeros(50), 2)
    with pytest.raises(SignalError, match="does not decimate"):
        decimation_filter(1)
