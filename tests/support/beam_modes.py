# SPDX-License-Identifier: Apache-2.0
"""Modes of beams as finite-element matrices, and the stiffening of their tension."""

from __future__ import annotations

import numpy as np
from scipy.linalg import eigh

from pitchpoint.multibody.craig_bampton import Modes


def free_modes(structure, count):
    """Lowest elastic modes of the body, nothing held: six rigid motions come before them."""
    values, vectors = eigh(structure.K.toarray(), structure.M.toarray())
    frequency = np.sqrt(np.abs(values)) / (2.0 * np.pi)
    return Modes(frequency[6:], vectors[:, 6:], float(frequency[:6].max())).select(count=count)


def held_modes(structure, nodes, count):
    """Lowest modes of the body with some nodes held, as a blade on its hub."""
    free = np.flatnonzero(~np.isin(structure.node, list(nodes)))
    K, M = structure.K.toarray()[np.ix_(free, free)], structure.M.toarray()[np.ix_(free, free)]
    values, vectors = eigh(K, M)
    shape = np.zeros((structure.size, free.size))
    shape[free] = vectors
    return Modes(np.sqrt(values) / (2.0 * np.pi), shape, 0.0).select(count=count)


def tension_stiffness(beam):
    """Geometric stiffness per tensile force (12, 12) of a beam without shear deformation [1/m, 1, m]."""
    h = beam.length
    part = np.array(
        [
            [36.0, 3.0 * h, -36.0, 3.0 * h],
            [3.0 * h, 4.0 * h**2, -3.0 * h, -(h**2)],
            [-36.0, -3.0 * h, 36.0, -3.0 * h],
            [3.0 * h, -(h**2), -3.0 * h, 4.0 * h**2],
        ]
    ) / (30.0 * h)
    found = np.zeros((12, 12))
    # deflection and slope of both ends in each plane; the slope is ry or -rx
    for places, signs in (([0, 4, 6, 10], [1.0, 1.0, 1.0, 1.0]), ([1, 3, 7, 9], [1.0, -1.0, 1.0, -1.0])):
        found[np.ix_(places, places)] = part * np.outer(signs, signs)
    return found


def axial_stiffening(beams, structure, start=0.0):
    """Stiffness by the tension that inertia loads put into a straight body, per unit of nine loads (9, n, n).

    Loads are the components of the acceleration of the frame and the products xx, yy, zz, xy, yz, zx of
    those of its angular velocity; the body is held at its first node and free at its last. Of them a_z
    pulls by -m, and omega_x^2 and omega_y^2 by m z: a blade that turns.

    Parameters
    ----------
    beams
        The elements in order.
    structure
        What `beam_line` made of them.
    start
        Place of the first node along the axis, from the axis of rotation [m].

    Notes
    -----
    Tension is constant in each element, the mean of what the mass beyond it and half of its own pull.
    """
    n = structure.size
    found = np.zeros((9, n, n))
    outer = np.array([b.mass for b in beams])
    middle = start + np.cumsum([b.length for b in beams]) - 0.5 * np.array([b.length for b in beams])
    for k, beam in enumerate(beams):
        at = slice(6 * k, 6 * k + 12)
        beyond = float(outer[k + 1 :].sum()) + 0.5 * beam.mass
        pull = float((outer[k + 1 :] * middle[k + 1 :]).sum())
        # integral of the pull of the own mass: rho A (z_2^2 - z^2)/2, mean over the element
        first, last = middle[k] - 0.5 * beam.length, middle[k] + 0.5 * beam.length
        pull += beam.rho * beam.section.A * (last**2 / 2.0 - (last**3 - first**3) / (6.0 * beam.length))
        unit = tension_stiffness(beam)
        found[2, at, at] -= beyond * unit
        found[3, at, at] += pull * unit
        found[4, at, at] += pull * unit
    return found
