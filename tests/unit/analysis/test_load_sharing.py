# SPDX-License-Identifier: Apache-2.0
"""Load sharing assembled from slots: the curve it was cut from comes out again, whichever slot begins."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.load_sharing import share_along_path


def slots(psi: np.ndarray, eps: float, n_slot: int, first: int) -> np.ndarray:
    """Share of each slot if every pair in contact carries in proportion to 1 + p."""
    turn = -np.concatenate([[0], np.cumsum(np.round(np.diff(psi)).astype(int))])
    weights = np.zeros((psi.size, n_slot))
    for k, p in enumerate(psi):
        for age in range(int(np.ceil(eps))):
            if p + age <= eps:
                weights[k, (first + turn[k] - age) % n_slot] = 1.0 + p + age
    return weights / weights.sum(axis=1, keepdims=True)


@pytest.mark.parametrize("first", range(4))
@pytest.mark.parametrize("eps", [1.6, 2.3])
def test_pieces_fit_together(eps: float, first: int) -> None:
    psi = (0.37 + np.arange(61) / 60.0) % 1.0
    found = share_along_path(psi, slots(psi, eps, 4, first), eps)
    assert found.offset == 0.0
    assert found.way[0] == pytest.approx(psi.min())
    assert np.all(np.diff(found.way) >= 0.0)
    for way, share in zip(found.way, found.share, strict=True):
        beside = np.array([way % 1.0 + age for age in range(4)])
        total = (1.0 + beside[beside <= eps + 1e-12]).sum()
        assert share == pytest.approx((1.0 + way) / total, abs=1e-12)


def test_phase_of_the_other_flank() -> None:
    psi = (0.37 + np.arange(61) / 60.0) % 1.0
    share = slots(psi, 1.6, 3, 1)
    moved = (psi + 0.25) % 1.0
    assert share_along_path(moved, share, 1.6).way.size == 0
    found = share_along_path(moved, share, 1.6, other_flank=True)
    assert found.offset == pytest.approx(0.25, abs=1.0 / 30.0)
    assert found.share.max() == pytest.approx(1.0)


def test_nothing_to_share() -> None:
    assert share_along_path([], np.zeros((0, 3)), 1.6).way.size == 0
    assert share_along_path([0.1, 0.2], np.zeros((2, 0)), 1.6).way.size == 0
