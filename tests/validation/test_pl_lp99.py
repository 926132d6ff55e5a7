# SPDX-License-Identifier: Apache-2.0
"""PL-LP99: planar planetary set with three planets, 18 degrees of freedom.

J. Lin, R. G. Parker, Analytical characterization of the unique properties of planetary gear free vibration,
J. Vib. Acoust. 121 (1999) 316, numbers of cases.md. Coordinates there are x, y and u = base radius times
angle in axes that go with the carrier; ours are those of the joints, planets on the carrier, which changes
no frequency at rest. Base radii are drawn out of the inertias, which are given as I / r^2, so that gears of
one module do.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.system import evaluate
from tests.support.engine import frequencies
from tests.support.planetary import lin_parker, touching

ROTATIONAL = [0.0, 1475.7, 1930.3, 2658.3, 7462.8, 11775.3]
TRANSLATIONAL = [743.2, 1102.4, 1896.0, 2276.4, 6986.3, 9647.9]


@pytest.fixture(scope="module")
def matrices():
    system = lin_parker()
    M, D, K = evaluate.linearize(system, touching(system, 1e-12))
    assert np.abs(D).max() < 1e-9
    return system, M, K


def test_eighteen_frequencies(matrices):
    """Rotational ones once, translational ones twice; 5e-4 as in cases.md (last digit of the data: 1e-2)."""
    system, M, K = matrices
    assert system.sizes["nd"] == 18
    wanted = sorted(ROTATIONAL + 2 * TRANSLATIONAL)
    found = frequencies(M, K)
    for frequency, published in zip(found[1:], wanted[1:], strict=True):
        assert frequency == pytest.approx(published, rel=5e-4)
    assert found[0] < 1e-2
    twice = [f for f in found if np.abs(np.array(TRANSLATIONAL) / f - 1.0).min() < 5e-4]
    np.testing.assert_allclose(twice[::2], twice[1::2], rtol=1e-8)


def test_rotational_modes_do_not_move_centres(matrices):
    """What belongs to single frequencies leaves sun, carrier and ring where they are."""
    system, M, K = matrices
    squares, shapes = np.linalg.eig(np.linalg.solve(M, K))
    centres = [system.layout.coordinate(f"{b}.{c}") for b in ("sun", "carrier", "ring") for c in "xy"]
    for wanted in ROTATIONAL[1:]:
        k = int(np.argmin(np.abs(np.sqrt(np.abs(squares)) / (2.0 * np.pi) - wanted)))
        shape = np.abs(shapes[:, k])
        assert shape[centres].max() < 1e-9 * shape.max()
