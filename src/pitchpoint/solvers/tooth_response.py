# SPDX-License-Identifier: Apache-2.0
"""Response of one mode to the excitation by its meshes, with the left vector of the mode.

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

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from pitchpoint.solvers.linear_system import Linearised
    from pitchpoint.solvers.mesh_law import MeshLaw

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

Phases = Mapping[str, tuple[float, bool]]
"""Phase of the loaded flank of each mesh at one instant, and whether it grows with time."""

SILENT = 1e-9
"""Excitation over the static deflection up to which it is rounding."""
KEPT = 1e-9
"""Size of a direction over the largest one from which it belongs to the span of the shapes."""
NONE = 1e-13
"""Singular value over the inertia up to which it is rounding: modes of one frequency."""


@dataclass(frozen=True)
class Source:
    """Excitations by teeth of unit energy: k |e|^2 plus that of the static deflection by shuttling forces.

    Parameters
    ----------
    forces
        Generalised forces p, shape (n, nd).
    rows
        Their deflection p^H z per shape, for unsymmetric stiffness with that of a force, shape (n, nd).
    by_error
        Part of the rows that belongs to the transmission error e, shape (n, nd).
    """

    forces: Complex
    rows: Complex
    by_error: Complex

    def reversed(self) -> Source:
        """The excitations in the opposite direction of rotation."""
        return Source(self.forces.conj(), self.rows.conj(), self.by_error.conj())

    def energy(self, shape: Complex) -> float:
        """Twice the strain energy of a shape where the excitations act, as z^H K z."""
        return float(np.linalg.norm(self.rows @ shape) ** 2)

    def shuttles(self, shape: Complex) -> bool:
        """Whether the shuttling forces drive a shape more than the transmission errors do."""
        of_error = self.by_error @ shape
        return bool(np.linalg.norm(self.rows @ shape - of_error) > np.linalg.norm(of_error))


def errors_of(laws: Iterable[MeshLaw]) -> Source | None:
    """Transmission errors of meshes, each one excitation; None without a mesh that has stiffness."""
    stiff = [law for law in laws if law.mean > 0.0]
    if not stiff:
        return None
    forces = np.array([law.stiffness / math.sqrt(law.mean) for law in stiff], np.complex128)
    rows = np.array([law.force / math.sqrt(law.mean) for law in stiff], np.complex128)
    return Source(forces, rows, rows)


def teeth_of(
    laws: Mapping[str, MeshLaw], harmonic: int, modes: tuple[Array, Array], phases: Phases | None
) -> Source | None:
    """Excitation by meshes at a harmonic of the mesh frequency, with its shape over the mesh cycle.

    Meshes without an excitation, such as unloaded ones, count with a transmission error.

    Parameters
    ----------
    laws
        Meshes by name.
    harmonic
        Number of the harmonic.
    modes
        Circular frequencies (n,) and mass-normalised shapes (n, nd) at rest, of which static deflections
        consist.
    phases
        With them all meshes are one excitation; without, each mesh is one, with any phase.
    """
    omega, shapes = modes
    flexible = shapes[omega > 0.0] / omega[omega > 0.0][:, None]
    found = {}
    for name, law in laws.items():
        if law.wave is None or not law.mean > 0.0:
            continue
        e, shuttling = law.excitation(harmonic, *(phases or {}).get(name, (0.0, True)))
        least = SILENT * float(np.linalg.norm(flexible[:, law.wave.places] @ law.wave.mean))
        if abs(e[-1]) * math.sqrt(law.mean) + np.linalg.norm(flexible @ shuttling[-1]) > least:
            found[name] = e[-1], shuttling[-1]
    if len(found) < len(laws):
        return errors_of(laws.values())
    e, shuttling = np.array([x for x, _ in found.values()]), np.array([c for _, c in found.values()])
    k = np.array([law.mean for law in laws.values()])
    weights = np.diag(e)
    if phases is not None:
        weights, shuttling = e[None], shuttling.sum(axis=0, keepdims=True)
    size = np.abs(weights) ** 2 @ k + np.linalg.norm(shuttling @ flexible.T, axis=1) ** 2
    weights, shuttling = weights / np.sqrt(size)[:, None], shuttling / np.sqrt(size)[:, None]
    by_error = weights.conj() @ np.array([law.force for law in laws.values()])
    forces = weights @ np.array([law.stiffness for law in laws.values()]) + shuttling
    return Source(forces, by_error + shuttling.conj(), by_error)


def tooth_response(
    linear: Linearised, source: Source, value: complex, shape: Complex, shapes: Complex
) -> float:
    """Response where a source acts over its static one, at resonance, times the damping ratio of the mode.

    For a transmission error this is the mean tooth deflection over the error. Of several excitations it is
    the largest one for all amplitudes and phases, in the norm of the energy: rank one, it is a product of
    two norms.

    Parameters
    ----------
    linear
        The linear system at the speed.
    source
        Excitations.
    value, shape
        Eigenvalue [1/s] and shape (nd,) of the mode.
    shapes
        Shapes of modes at a near speed (n, nd), in whose span, with this one, the left vector is found.
    """
    w = left_vector(linear, value, shape, shapes)
    modal = abs(w @ ((2.0 * value * linear.at_rest.M + linear.D) @ shape)) * abs(value)
    return float(np.linalg.norm(source.rows @ shape) * np.linalg.norm(source.forces @ w) / modal)


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
