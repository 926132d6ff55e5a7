# SPDX-License-Identifier: Apache-2.0
"""Excitation of a mesh over its cycle: transmission error, and shuttling forces of helical teeth.

With the mean stiffness K of a mesh, its forces at rest and the deflection there,

    Q = -K q + p

defines the forces p that excite the linear system. A uniform error e of the flanks has p = K s e with the
rotation s of `mesh_law`. The rest of p has no part along the base tangent: on helical teeth the lines of
contact move across the face width, and the centre of force shuttles with them. It tilts the gears even if
force and transmission error are constant.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.solvers.cycle_means import GAUSS

if TYPE_CHECKING:
    from pitchpoint.solvers.cycle_means import CycleMean
    from pitchpoint.solvers.element_tangents import Share

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

EQUAL = 1e-12
"""Relative difference up to which weights are equal."""


@dataclass(frozen=True)
class ToothWave:
    """Excitation p of a loaded mesh over its cycle.

    Parameters
    ----------
    places
        Coordinates of p, shape (m,).
    phases, weights
        Phases of the loaded flank [-] and their weights in the mean over the cycle, shape (n,).
    forces
        Generalised forces p at these phases, shape (n, m).
    mean
        Mean generalised forces of the mesh, shape (m,).
    """

    places: NDArray[np.int64]
    phases: Array
    weights: Array
    forces: Array
    mean: Array

    def harmonics(self, count: int) -> Complex:
        """Complex amplitudes of p, e^(2 pi i h phase), h = 1 to `count`, shape (count, m)."""
        return np.asarray(2.0 * fourier_weights(self.phases, self.weights, count) @ self.forces)


def fourier_weights(phases: Array, weights: Array, count: int) -> Complex:
    """Weights of the values at the phases of a cycle in its Fourier coefficients 1 to `count`, (count, n).

    Between two kinks the parabola through the three values there is integrated, so that high harmonics do not
    need more phases [1]_; equal weights belong to equal steps.

    References
    ----------
    .. [1] L. N. G. Filon: On a quadrature formula for trigonometric integrals, Proc. R. Soc. Edinburgh 49
       (1928) 38-47.

    Examples
    --------
    >>> x, w = np.polynomial.legendre.leggauss(3)
    >>> ramp = fourier_weights(0.5 + 0.5 * x, 0.5 * w, 3) @ (0.5 + 0.5 * x)  # i/(2 pi h)
    >>> (ramp.imag * 2.0 * np.pi * np.arange(1, 4)).round(9).tolist()
    [1.0, 1.0, 1.0]
    """
    turned = -2j * np.pi * np.arange(1, count + 1)
    if np.ptp(weights) <= EQUAL * weights.max():
        return np.asarray(weights * np.exp(np.outer(turned, phases)))
    x, _ = np.polynomial.legendre.leggauss(GAUSS)
    fine, share = np.polynomial.legendre.leggauss(2 * count + 10)
    parabolas = np.linalg.solve(np.vander(x).T, np.vander(fine, GAUSS).T)
    middle = phases.reshape(-1, GAUSS)[:, GAUSS // 2]
    length = weights.reshape(-1, GAUSS).sum(axis=1)
    along = middle[:, None] + 0.5 * length[:, None] * fine
    waves = np.exp(turned[:, None, None] * along) * (0.5 * share)
    return np.asarray((length[:, None] * (waves @ parabolas.T)).reshape(count, -1))


def tooth_wave(share: Share, cycle: CycleMean) -> ToothWave:
    """Excitation over a cycle; `share`: the mean stiffness of the mesh."""
    moved = (cycle.places - cycle.places[:1])[:, share.places]
    forces = cycle.forces[:, share.places]
    p = forces + moved @ share.matrix.T
    return ToothWave(share.places, cycle.phases, cycle.weights, p, cycle.weights @ forces)
