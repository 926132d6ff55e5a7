# SPDX-License-Identifier: Apache-2.0
"""Mass invariants of an elastic body: constant integrals that give its inertia in a floating frame.

A point of the body has the velocity v + omega x (x + u) + Phi eta' in the axes of the floating frame, u =
Phi eta. With the rigid-body displacements T_t, T_r(x + u) = T_r0 + sum eta_k T_k of the finite elements and
their mass matrix M, the kinetic energy is 1/2 w^T [T_t T_r Phi]^T M [T_t T_r Phi] w, w = (v, omega, eta').
All constant products are stored. This is exact for solid elements; the rotary inertia of elements with
rotational degrees of freedom is that of the undeformed state.

Sources: Shabana, Dynamics of Multibody Systems, chapter 5; Wallrapp, Mech. Struct. Mach. 22 (1994) 283-304.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.multibody.structure import Structure

Array = NDArray[np.float64]


@dataclass(frozen=True)
class MassInvariants:
    """Mass integrals about the origin of the floating frame, in its axes, for n modal coordinates.

    Parameters
    ----------
    mass
        Mass [kg].
    first
        First moment of mass of the undeformed body, (3,) [kg m].
    inertia
        Inertia of the undeformed body, (3, 3) [kg m^2].
    momentum
        Linear momentum per modal rate, also the derivative of `first` by the modal coordinates, (3, n).
    angular
        Angular momentum per modal rate of the undeformed body, (3, n).
    angular_1
        Derivative of `angular` by modal coordinate k, (k, 3, n): sum of m_ab phi_k,a x phi_l,b.
    inertia_1
        Derivative of the inertia by the modal coordinates, (n, 3, 3), symmetric.
    inertia_2
        Quadratic part of the inertia, (n, n, 3, 3): sum eta_k eta_l inertia_2[k, l].
    modal
        Mass matrix of the modal coordinates, (n, n).
    """

    mass: float
    first: Array
    inertia: Array
    momentum: Array
    angular: Array
    angular_1: Array
    inertia_1: Array
    inertia_2: Array
    modal: Array

    def turned(self, axes: ArrayLike) -> MassInvariants:
        """Invariants in rotated axes, given as columns (3, 3) in the present axes."""
        Q = np.asarray(axes, float)
        return MassInvariants(
            mass=self.mass,
            first=Q.T @ self.first,
            inertia=Q.T @ self.inertia @ Q,
            momentum=Q.T @ self.momentum,
            angular=Q.T @ self.angular,
            angular_1=np.einsum("ia,kin->kan", Q, self.angular_1),
            inertia_1=np.einsum("ia,kij,jb->kab", Q, self.inertia_1, Q),
            inertia_2=np.einsum("ia,klij,jb->klab", Q, self.inertia_2, Q),
            modal=self.modal,
        )


def mass_invariants(
    structure: Structure, shape: ArrayLike, origin: ArrayLike = (0.0, 0.0, 0.0)
) -> MassInvariants:
    """Mass invariants of a structure for given mode shapes.

    Parameters
    ----------
    structure
        Matrices of the body.
    shape
        Displacements per modal coordinate, (size, n).
    origin
        Origin of the floating frame in the axes of the structure [m].

    Raises
    ------
    CompileError
        If the mass matrix is not physical: the mass must be positive and the same in all directions.
    """
    phi = np.asarray(shape, float)
    n = phi.shape[1]
    rigid = structure.rigid(origin)
    Mr, Mp = structure.M @ rigid, structure.M @ phi
    box = rigid.T @ Mr
    mass = float(np.trace(box[:3, :3]) / 3.0)
    if not mass > 0.0 or np.abs(box[:3, :3] - mass * np.eye(3)).max() > 1e-6 * mass:
        weights = ", ".join(f"{w:.6g}" for w in np.diag(box)[:3])
        raise CompileError(
            f"M: the masses along x, y and z are {weights} kg and must be equal and positive; "
            "check M, and the directions and positions of the nodes"
        )
    first = _axial(box[3:6, :3])
    turned = [_turned(structure, phi[:, k]) for k in range(n)]
    Mt = [structure.M @ t for t in turned]
    angular_1, inertia_1 = np.zeros((n, 3, n)), np.zeros((n, 3, 3))
    inertia_2 = np.zeros((n, n, 3, 3))
    for k in range(n):
        angular_1[k] = turned[k].T @ Mp
        cross = rigid[:, 3:].T @ Mt[k]
        inertia_1[k] = cross + cross.T
        for m in range(n):
            inertia_2[k, m] = turned[k].T @ Mt[m]
    inertia_2 = 0.5 * (inertia_2 + inertia_2.transpose(0, 1, 3, 2))
    return MassInvariants(
        mass=mass,
        first=first,
        inertia=0.5 * (box[3:, 3:] + box[3:, 3:].T),
        momentum=np.asarray(Mr[:, :3].T @ phi),
        angular=np.asarray(Mr[:, 3:].T @ phi),
        angular_1=angular_1,
        inertia_1=inertia_1,
        inertia_2=inertia_2,
        modal=np.asarray(phi.T @ Mp),
    )


def _axial(box: Array) -> Array:
    """Vector of the skew-symmetric part of a matrix: the angular momentum due to v is first x v."""
    skew = 0.5 * (box - box.T)
    return np.array([skew[2, 1], skew[0, 2], skew[1, 0]])


def _turned(structure: Structure, phi: Array) -> Array:
    """Node velocities e x phi for unit angular velocities e, shape (size, 3); zero for rotations."""
    moved = np.zeros((len(structure.places), 3))
    translations = structure.direction < 3
    moved[structure.node[translations], structure.direction[translations]] = phi[translations]
    found = np.zeros((structure.size, 3))
    for k in range(3):
        swept = np.cross(np.eye(3)[k], moved)
        found[translations, k] = swept[structure.node[translations], structure.direction[translations]]
    return found
