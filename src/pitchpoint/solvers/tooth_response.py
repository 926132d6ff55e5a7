# SPDX-License-Identifier: Apache-2.0
"""Response of one mode to the transmission errors of its meshes, with the left vector of the mode.

With A(lambda) = lambda^2 M + lambda D + K, A z = 0 and w^T A = 0, a mode of the eigenvalue lambda responds to
a force f e^(i Omega t) with the amplitude [1]_

    z (w^T f)/((i Omega - lambda) w^T (2 lambda M + D) z)

For symmetric matrices w = z; with gyroscopic terms and light damping w is close to the conjugate of z.
Torques that follow a tilting axis make K unsymmetric and can turn w by far more than they damp.

References
----------
.. [1] F. Tisseur, K. Meerbergen: The quadratic eigenvalue problem, SIAM Review 43 (2001) 235-286.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from pitchpoint.solvers.linear_system import Linearised
    from pitchpoint.solvers.mesh_law import MeshLaw

Complex = NDArray[np.complex128]

KEPT = 1e-9
"""Size of a direction over the largest one from which it belongs to the span of the shapes."""
NONE = 1e-13
"""Singular value over the inertia up to which it is rounding: modes of one frequency."""


def tooth_response(
    linear: Linearised, laws: Sequence[MeshLaw], value: complex, shape: Complex, shapes: Complex
) -> float:
    """Mean tooth deflection over transmission error at resonance, times the damping ratio of the mode.

    Of several meshes it is the largest one for all amplitudes and phases of the errors, in the norm
    sqrt(sum k |u|^2): rank one, it is a product of two norms.

    Parameters
    ----------
    linear
        The linear system at the speed.
    laws
        The meshes.
    value, shape
        Eigenvalue [1/s] and shape (nd,) of the mode.
    shapes
        Shapes of modes at a near speed (n, nd), in whose span, with this one, the left vector is found.
    """
    stiff = [law for law in laws if law.mean > 0.0]
    if not stiff:
        return 0.0
    w = left_vector(linear, value, shape, shapes)
    u = np.array([(law.force @ shape) / np.sqrt(law.mean) for law in stiff])
    work = np.array([(w @ law.stiffness) / np.sqrt(law.mean) for law in stiff])
    modal = abs(w @ ((2.0 * value * linear.at_rest.M + linear.D) @ shape)) * abs(value)
    return float(np.linalg.norm(u) * np.linalg.norm(work) / modal)


def left_vector(linear: Linearised, value: complex, shape: Complex, shapes: Complex) -> Complex:
    """Left vector of a mode, shape (nd,), not normalised; arguments as in `tooth_response`.

    One step of inverse iteration from the conjugate shape. Of modes of one frequency it is the left vector
    that belongs to this shape.
    """
    M, D, K = linear.at_rest.M, linear.D, linear.K
    rows = np.vstack([shapes.real, shapes.imag, shape.real[None], shape.imag[None]])
    _, size, basis = np.linalg.svd(rows, full_matrices=False)
    B = basis[size > KEPT * size[0]].T
    inertia, damping, stiffness = (f * (B.T @ X @ B) for f, X in ((value**2, M), (value, D), (1.0, K)))
    U, size, V = np.linalg.svd(inertia + damping + stiffness)
    least = NONE * float(np.linalg.norm(inertia))
    start = B.T @ (M @ shape.conj())
    return np.asarray(B @ (U.conj() @ ((V.conj() @ start) / np.maximum(size, least))))
