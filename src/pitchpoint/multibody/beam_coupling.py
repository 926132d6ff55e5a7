# SPDX-License-Identifier: Apache-2.0
"""Stiffness of beam elements with coupled sections, from the compliance of the section.

The section forces of an element without loads between its ends follow from the force and the moment on the
second end, so the compliance of that end is an integral of the compliance of the section: the stiffness is
exact for any section that is the same from end to end.

Sources: D. H. Hodges, Nonlinear Composite Beam Theory (2006), chapter 2 (section matrices); J. S.
Przemieniecki, Theory of Matrix Structural Analysis (1968), section 6.5 (stiffness from the compliance).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Matrix = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Coupling:
    """Stiffness and damping of an element in its six deformations.

    The deformations are the elongation [m], the twist, the bending angle of axis 1 between both ends, the sum
    of the slopes of axis 1 at both ends towards the chord, and both for axis 2 [rad].

    Parameters
    ----------
    stiffness
        Symmetric matrix, shape (6, 6) [N/m, N, N m].
    damping
        Symmetric matrix of the rates, shape (6, 6) [N s/m, N s, N m s].
    """

    stiffness: Matrix
    damping: Matrix

    def phi(self, plane: int) -> float:
        """Shear parameter for bending in direction 1 or 2: share of the shear in the compliance for opposite
        moments at both ends, over that of bending [-]."""
        soft, k = np.linalg.inv(self.stiffness), 2 * plane
        return max(3.0 * float(soft[k + 1, k + 1] / soft[k, k]) - 1.0, 0.0)


def coupling(compliance: ArrayLike, length: float, dissipation: ArrayLike | None = None) -> Coupling:
    """Stiffness and damping of an element with the same section from end to end.

    Parameters
    ----------
    compliance
        Strains for the section forces, symmetric, shape (6, 6): along axes 1, 2 and the beam, then about them
        [1/N, 1/(N m), 1/(N m²)].
    length
        Length of the element [m].
    dissipation
        Damping matrix D of the section between two compliances S, S D S, shape (6, 6); None: no damping.

    Examples
    --------
    Bending stiffness 2 and torsional stiffness 1 with the coupling 0.5: a moment M on the end of a cantilever
    of 3 m twists it by -0.5 M 3/(2 1 - 0.5²).

    >>> K = np.diag([1e9, 1e9, 1e9, 2.0, 2.0, 1.0])
    >>> K[3, 5] = K[5, 3] = 0.5
    >>> end = end_matrix(3.0)
    >>> stiffness = end.T @ coupling(np.linalg.inv(K), 3.0).stiffness @ end
    >>> moved = np.linalg.solve(stiffness, [0, 0, 0, 1.0, 0, 0])
    >>> round(float(moved[5]), 6), round(-0.5 * 3 / 1.75, 6)
    (-0.857143, -0.857143)
    """
    stiffness = np.linalg.inv(_integral(np.asarray(compliance, float), length))
    damping = np.zeros((6, 6))
    if dissipation is not None:
        damping = stiffness @ _integral(np.asarray(dissipation, float), length) @ stiffness
    back = np.linalg.inv(end_matrix(length))
    return Coupling(*(_symmetric(back.T @ part @ back) for part in (stiffness, damping)))


def _integral(section: Matrix, length: float) -> Matrix:
    """Integral over the element for the section forces due to force and moment on its second end."""
    middle, arm = np.eye(6), np.zeros((6, 6))
    arm[3, 1], arm[4, 0] = -length, length
    middle += 0.5 * arm
    return np.asarray(length * (middle.T @ section @ middle + arm.T @ section @ arm / 12.0))


def end_matrix(length: float) -> Matrix:
    """Six deformations of an element from displacement and rotation of its second end, the first one fixed,
    shape (6, 6)."""
    end = np.zeros((6, 6))
    end[0, 2] = end[1, 5] = end[4, 3] = end[5, 3] = 1.0
    end[2, 4] = end[3, 4] = -1.0
    end[3, 0] = end[5, 1] = 2.0 / length
    return end


def parallel_compliance(
    *,
    centre: ArrayLike,
    shear_centre: ArrayLike,
    bending: ArrayLike,
    shear: ArrayLike,
    axial: float,
    torsion: float,
) -> Matrix:
    """Compliance of a section with two centres along its principal axes, shape (6, 6).

    Parameters
    ----------
    centre, shear_centre
        Elastic centre and shear centre, shape (2,) [m].
    bending, shear
        Stiffness for bending and for shear in the direction of axes 1 and 2 [N m², N]; shear 0: rigid.
    axial, torsion
        Axial stiffness about the elastic centre and torsional stiffness about the shear centre [N, N m²].
    """
    (x, y), (u, v) = np.asarray(centre, float), np.asarray(shear_centre, float)
    one, two = np.asarray(bending, float)
    forces = np.eye(6)  # about the own centre of each from those about the axis of the beam
    forces[3, 2], forces[4, 2] = -y, x
    forces[5, 0], forces[5, 1] = v, -u
    soft = [1.0 / k if k > 0.0 else 0.0 for k in np.asarray(shear, float)]
    own = np.array([*soft, 1.0 / axial, 1.0 / two, 1.0 / one, 1.0 / torsion])
    return np.asarray(forces.T @ (own[:, None] * forces))


def _symmetric(part: Matrix) -> Matrix:
    return np.asarray(0.5 * (part + part.T))
