# SPDX-License-Identifier: Apache-2.0
"""PL-K94: torsional planetary set with a fixed ring, planets hanging on the carrier, in closed form.

A. Kahraman, Natural modes of planetary gear trains, J. Sound Vib. 173 (1994), numbers of cases.md: three
planets, base radii of sun and planet 0.5 m, carrier arm 1 m, inertias 4 (carrier), 0.5 (sun), 0.75 kg m^2
(planet), meshes 7 (sun) and 11 N/m (ring). His angles are absolute, ours are those of the planets on the
carrier; frequencies do not care. Springs act along base tangents: only base radii enter, so the pressure
angle is free. The published four digits are those of the closed form, here written out with all digits.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.system import evaluate
from tests.support.engine import frequencies
from tests.support.planetary import gear_pairs, planetary, touching

K_SUN, K_RING, ARM, BASE = 7.0, 11.0, 1.0, 0.5
CARRIER, SUN, PLANET = 4.0, 0.5, 0.75
PUBLISHED = [0.0, 0.38984840, 0.38984840, 0.50872897, 0.70788679]


def closed_form():
    """Own matrices: absolute angles of carrier, sun, planets; deflections of all six springs."""
    M = np.diag([CARRIER, SUN, PLANET, PLANET, PLANET])
    K = np.zeros((5, 5))
    for n in range(3):
        sun, ring = np.zeros(5), np.zeros(5)
        sun[[0, 1, 2 + n]] = -ARM, BASE, BASE
        ring[[0, 2 + n]] = -ARM, -BASE
        K += K_SUN * np.outer(sun, sun) + K_RING * np.outer(ring, ring)
    return frequencies(M, K)


def test_the_closed_form_has_the_published_numbers():
    np.testing.assert_allclose(closed_form(), PUBLISHED, atol=1e-8)


@pytest.mark.parametrize("alpha", [14.5, 24.6])
def test_frequencies_of_the_set(alpha):
    """Springs of 10 N/m against inertias of 1 kg m^2: rounding only."""
    alpha = math.radians(alpha)
    module = 2.0 * BASE / (40 * math.cos(alpha))
    pairs = gear_pairs(40, 40, module, alpha)
    # the ring is a body that turns: its inertia stops it, as good as a wall to 1e-12
    system = planetary(pairs, (SUN, CARRIER, 1e13, PLANET), (K_SUN, K_RING))
    M, D, K = evaluate.linearize(system, touching(system, 1e-9))
    found = frequencies(M, K)
    assert np.abs(D).max() < 1e-12
    np.testing.assert_allclose(found[-4:], closed_form()[-4:], rtol=1e-9)
    for frequency, published in zip(found[-4:], PUBLISHED[-4:], strict=True):
        assert frequency == pytest.approx(published, abs=1e-8)
    np.testing.assert_allclose(found[:2], 0.0, atol=1e-6)
