# SPDX-License-Identifier: Apache-2.0
"""Inverse of a mass matrix by 3 x 3 blocks against LAPACK."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.status import OK, SINGULAR
from pitchpoint.multibody.block_mass import invert_mass

pytestmark = pytest.mark.nojit


@pytest.mark.parametrize("seed", range(5))
def test_against_lapack(seed: int) -> None:
    """Translations of 1 kg beside rotations of 1e-6 kg m^2: what counts is the scaled matrix.

    Tolerance: condition of the scaled matrix (below 1e4 here) times rounding.
    """
    rng = np.random.default_rng(seed)
    L = np.eye(6) + 0.4 * rng.normal(size=(6, 6))
    scale = np.diag([1.0, 1.0, 1.0, 1e-3, 1e-3, 1e-3])
    M = scale @ L @ L.T @ scale
    found = M.copy()
    assert invert_mass(found) == OK
    wanted = np.linalg.inv(M)
    np.testing.assert_allclose(scale @ found @ scale, scale @ wanted @ scale, rtol=1e-10, atol=1e-10)


def test_a_body_without_inertia_is_found() -> None:
    M = np.diag([1.0, 1.0, 1.0, 1.0, 0.0, 1.0])
    assert invert_mass(M) == SINGULAR
    assert invert_mass(np.diag([0.0, 1.0, 1.0, 1.0, 1.0, 1.0])) == SINGULAR
