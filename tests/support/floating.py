# SPDX-License-Identifier: Apache-2.0
"""Elastic bodies of point masses and springs, for tests of reduction and of the floating frame."""

from __future__ import annotations

import numpy as np

from pitchpoint.multibody.structure import make_structure


def truss(seed=1, stiffness=1e4):
    """Nine point masses in space, every pair joined by a spring along its line."""
    rng = np.random.default_rng(seed)
    places = rng.uniform(-1.0, 1.0, size=(9, 3))
    masses = rng.uniform(0.5, 2.0, size=9)
    K = np.zeros((27, 27))
    for a in range(9):
        for b in range(a):
            e = places[a] - places[b]
            e /= np.linalg.norm(e)
            row = np.zeros(27)
            row[3 * a : 3 * a + 3], row[3 * b : 3 * b + 3] = e, -e
            K += stiffness * np.outer(row, row)
    return make_structure(K, np.diag(np.repeat(masses, 3)), places)
