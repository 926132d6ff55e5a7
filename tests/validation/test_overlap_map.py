# SPDX-License-Identifier: Apache-2.0
"""MS-OVERLAP: variation of the mesh stiffness over both contact ratios, in closed form.

L. Mauer, SIMPACK User Meeting 2006. The total stiffness is a moving average of the spur gear stiffness over
eps_beta base pitches. For S_R = 1, with e and f the fractional parts of eps_alpha and eps_beta, its peak to
peak over c' b is min(e, 1 - e, f, 1 - f)/eps_beta, and 1 up to eps_beta = min(e, 1 - e): a rectangular wave.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.contact.overlap_map import best_overlap, overlap_map


def test_map_of_rectangular_waves() -> None:
    """Tolerance: round-off of the exact integral."""
    across, up = np.linspace(1.05, 2.45, 15), np.linspace(0.05, 3.0, 60)
    found = overlap_map(across, up, S_R=1.0).peak_to_peak
    e, f = (across % 1.0)[None, :], (up % 1.0)[:, None]
    least = np.minimum(e, 1.0 - e)
    closed = np.minimum(least, np.minimum(f, 1.0 - f)) / up[:, None]
    closed = np.where(up[:, None] <= least, 1.0, closed)
    np.testing.assert_allclose(found, closed, atol=1e-9)


def test_numbers_of_the_parabola() -> None:
    """S_R = 0.8, eps_alpha = 1.3; seven digits are given."""
    found = overlap_map(np.array([1.3]), np.array([0.0, 0.3, 0.7, 0.85, 1.0, 2.0]))
    expected = [0.8213018, 0.7786982, 0.3337278, 0.1408632, 0.0, 0.0]
    np.testing.assert_allclose(found.peak_to_peak[:, 0], expected, atol=1e-7)


@pytest.mark.parametrize("T_R", [0.0, 0.5, 1.0])
def test_best_overlap_ratio(T_R: float) -> None:
    """An average over a whole period is constant; below one period the widest average is best here."""
    for eps_alpha in (1.15, 1.5, 2.2):
        assert best_overlap(eps_alpha, 2.5, 0.8, T_R).peak_to_peak == pytest.approx(0.0, abs=1e-12)
    assert best_overlap(1.3, 2.5) == (1.0, 0.0)
    assert best_overlap(1.3, 0.85).eps_beta == 0.85
