# SPDX-License-Identifier: Apache-2.0
"""PL-LP99: planar planetary sets with three and four planets, 18 and 21 degrees of freedom.

J. Lin, R. G. Parker, Analytical characterization of the unique properties of planetary gear free vibration,
J. Vib. Acoust. 121 (1999) 316, numbers of cases.md. Coordinates there are x, y and u = base radius times
angle in axes that go with the carrier; ours are those of the joints, planets on the carrier, which changes
no frequency at rest. Base radii are drawn out of the inertias, which are given as I / r^2, so that gears of
one module do.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import eigh

from pitchpoint.solvers.modal import find_modes
from pitchpoint.system import evaluate
from tests.support.planetary import lin_parker, touching

ROTATIONAL = {
    3: [1475.7, 1930.3, 2658.3, 7462.8, 11775.3],
    4: [1536.6, 1970.6, 2625.7, 7773.6, 13071.1],
}
TRANSLATIONAL = {
    3: [743.2, 1102.4, 1896.0, 2276.4, 6986.3, 9647.9],
    4: [727.0, 1091.0, 1892.8, 2342.5, 7189.9, 10437.6],
}
PLANET = {3: [], 4: [1808.2, 5963.8, 6981.7]}


def modes(n):
    """System, frequencies [Hz] in ascending order and shapes as columns."""
    system = lin_parker(n)
    M, D, K = evaluate.linearize(system, touching(system, 1e-12))
    assert np.abs(D).max() < 1e-9
    squares, shapes = eigh(0.5 * (K + K.T), M)
    return system, np.sqrt(np.maximum(squares, 0.0)) / (2.0 * np.pi), shapes


@pytest.mark.parametrize("n", [3, 4])
def test_all_frequencies(n):
    """Once, twice and n - 3 times; 5e-4: published digits are rounded and some data to three of them."""
    system, found, _ = modes(n)
    assert system.sizes["nd"] == 9 + 3 * n
    wanted = sorted(ROTATIONAL[n] + 2 * TRANSLATIONAL[n] + (n - 3) * PLANET[n])
    assert found[0] < 1e-2
    for frequency, published in zip(found[1:], wanted, strict=True):
        assert frequency == pytest.approx(published, rel=5e-4)
    twice = [f for f in found[1:] if np.abs(np.array(TRANSLATIONAL[n]) / f - 1.0).min() < 5e-4]
    np.testing.assert_allclose(twice[::2], twice[1::2], rtol=1e-8)


@pytest.mark.parametrize("n", [3, 4])
def test_modes_without_load_are_the_published_ones(n):
    """A small torque presses a planet on the front of one mesh and the back of the other.

    All meshes on the front, a state that no torque makes, gives frequencies several percent off.
    """
    found = find_modes(lin_parker(n))
    wanted = sorted(ROTATIONAL[n] + 2 * TRANSLATIONAL[n] + (n - 3) * PLANET[n])
    assert found.frequency[0] == 0.0
    assert found.frequency[1:] == pytest.approx(wanted, rel=5e-4)


@pytest.mark.parametrize("n", [3, 4])
def test_what_stays_where_it_is(n):
    """Rotational modes do not move the centres of sun, carrier, ring; modes of planets do not turn them."""
    system, found, shapes = modes(n)
    at = {
        word: [system.layout.coordinate(f"{b}.{word}") for b in ("sun", "carrier", "ring")]
        for word in ("x", "y", "spin")
    }
    for published, words in [(f, "xy") for f in ROTATIONAL[n]] + [(f, ("x", "y", "spin")) for f in PLANET[n]]:
        shape = np.abs(shapes[:, int(np.argmin(np.abs(found - published)))])
        assert max(shape[at[word]].max() for word in words) < 1e-7 * shape.max()
