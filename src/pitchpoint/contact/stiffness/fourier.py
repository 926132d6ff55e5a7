# SPDX-License-Identifier: Apache-2.0
"""Mesh stiffness as a Fourier series over the mesh phase."""

from __future__ import annotations

from numpy.typing import ArrayLike

from pitchpoint.contact.stiffness.description import PhaseStiffness, frozen_array, require_positive
from pitchpoint.geometry.gear_pair import GearPair


def fourier(
    pair: GearPair | None, *, mean: float, cosine: ArrayLike = (), sine: ArrayLike = ()
) -> PhaseStiffness:
    """Describe k(psi) = mean (1 + sum_h cosine_h cos(2 pi h psi) + sine_h sin(2 pi h psi)).

    Parameters
    ----------
    pair
        The gear pair; not used.
    mean
        Mean stiffness along the base tangent [N/m].
    cosine, sine
        Coefficients relative to the mean, shape (n,), harmonic 1 first; the shorter list is padded with
        zeros.

    Raises
    ------
    ModelError
        If the stiffness is not positive at all phases.

    Examples
    --------
    >>> law = fourier(None, mean=4.0e8, cosine=[-0.2, -0.1, -0.05])
    >>> (law.mean * law.ratio([0.0, 0.5]) / 1e8).round(12).tolist()
    [2.6, 4.6]
    """
    law = PhaseStiffness(
        mean=mean,
        cosine=frozen_array("stiffness.cosine", cosine),
        sine=frozen_array("stiffness.sine", sine),
    )
    return require_positive("stiffness.cosine", law)
