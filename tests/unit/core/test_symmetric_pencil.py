# SPDX-License-Identifier: Apache-2.0
"""Eigenvalues of two symmetric matrices, against SciPy."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import eigh

from pitchpoint.core.symmetric_pencil import symmetric_pencil


@pytest.mark.parametrize("n", [1, 2, 7, 40])
def test_agrees_with_scipy(n):
    rng = np.random.default_rng(n)
    K, M = (a @ a.T for a in rng.normal(size=(2, n, n)))
    M += n * np.eye(n)
    values, vectors = symmetric_pencil(K, M)
    np.testing.assert_allclose(values, eigh(K, M, eigvals_only=True), rtol=1e-9, atol=1e-12 * np.abs(K).max())
    np.testing.assert_allclose(vectors.T @ M @ vectors, np.eye(n), atol=1e-10)
    np.testing.assert_allclose(K @ vectors, M @ vectors * values, atol=1e-9 * np.abs(K).max())


def test_a_mass_matrix_that_is_not_positive_definite_is_refused():
    with pytest.raises(np.linalg.LinAlgError):
        symmetric_pencil(np.eye(2), np.diag([1.0, -1.0]))
