# SPDX-License-Identifier: Apache-2.0
"""Timoshenko beam elements as matrices: stiffness, consistent mass, gyration, stiffness by axial force.

Order of the twelve displacements: three translations and three rotations of the first end, then those of the
second; the third axis is that of the beam. Shape functions are the exact static ones with shear deflection.

Sources: Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines (2010), section 5.4 and 5.5;
Przemieniecki, Theory of Matrix Structural Analysis (1968), chapters 5, 11 and 15.
"""

from __future__ import annotations

import numpy as np


def stiffness(beam):
    """Stiffness matrix (12, 12) [N/m, N/rad, N m/rad]."""
    s, h = beam.section, beam.length
    K = np.zeros((12, 12))
    for plane, second in ((1, s.I_1), (2, s.I_2)):
        p = beam.phi(plane)
        rows = [[12.0, 6 * h, -12, 6 * h], [0, (4 + p) * h**2, -6 * h, (2 - p) * h**2]]
        rows += [[0, 0, 12, -6 * h], [0, 0, 0, (4 + p) * h**2]]
        _spread(K, plane, beam.E * second / ((1 + p) * h**3) * _full(rows))
    _pair(K, 2, beam.E * s.A / h * np.array([[1.0, -1.0], [-1.0, 1.0]]))
    _pair(K, 5, beam.G * s.J / h * np.array([[1.0, -1.0], [-1.0, 1.0]]))
    return K


def consistent_mass(beam):
    """Mass matrix (12, 12) of translation and rotary inertia [kg, kg m, kg m^2]."""
    s, h = beam.section, beam.length
    M = np.zeros((12, 12))
    for plane, second in ((1, s.I_1), (2, s.I_2)):
        p = beam.phi(plane)
        a, b, c = 312 + 588 * p + 280 * p**2, (44 + 77 * p + 35 * p**2) * h, 108 + 252 * p + 140 * p**2
        d, e = -(26 + 63 * p + 35 * p**2) * h, (8 + 14 * p + 7 * p**2) * h**2
        f = -(6 + 14 * p + 7 * p**2) * h**2
        rows = [[a, b, c, d], [0, e, -d, f], [0, 0, a, -b], [0, 0, 0, e]]
        _spread(M, plane, beam.mass / (840 * (1 + p) ** 2) * _full(rows))
        _spread(M, plane, beam.rho * second * _rotary(beam, p))
    third = np.array([[2.0, 1.0], [1.0, 2.0]]) / 6.0
    _pair(M, 2, beam.mass * third)
    _pair(M, 5, beam.rho * (s.I_1 + s.I_2) * h * third)
    return M


def gyroscopic(beam):
    """Matrix D (12, 12) per spin speed, of the gyroscopic force -omega D x' [kg m^2].

    For round sections. Rotation about axis 1 and rotation about axis 2 feed each other.
    """
    p = beam.phi(1)
    polar = beam.rho * (beam.section.I_1 + beam.section.I_2) * _rotary(beam, p)
    D = np.zeros((12, 12))
    # displacements of plane 1: x, ry; of plane 2: y, -rx
    one, two = _places(1), _places(2)
    for r in range(4):
        for c in range(4):
            D[one[r][0], two[c][0]] += one[r][1] * two[c][1] * polar[r, c]
            D[two[r][0], one[c][0]] -= two[r][1] * one[c][1] * polar[r, c]
    return D


def geometric(beam):
    """Stiffness per tension (12, 12), of a beam without shear deflection [1/m, 1, m]."""
    h = beam.length
    K = np.zeros((12, 12))
    rows = [[36.0, 3 * h, -36, 3 * h], [0, 4 * h**2, -3 * h, -(h**2)]]
    rows += [[0, 0, 36, -3 * h], [0, 0, 0, 4 * h**2]]
    for plane in (1, 2):
        _spread(K, plane, _full(rows) / (30.0 * h))
    return K


def _rotary(beam, p):
    """Integral of the products of the section rotations, per rho I (4, 4)."""
    h = beam.length
    a, b = 36.0, (3 - 15 * p) * h
    c, d = (4 + 5 * p + 10 * p**2) * h**2, (-1 - 5 * p + 5 * p**2) * h**2
    rows = [[a, b, -a, b], [0, c, -b, d], [0, 0, a, -b], [0, 0, 0, c]]
    return _full(rows) / (30.0 * h * (1 + p) ** 2)


def _full(rows):
    upper = np.triu(np.array(rows, float))
    return upper + np.triu(upper, 1).T


def _places(plane):
    """Displacement and slope of both ends in a plane: index and sign. Slope is ry, or -rx."""
    first, turn, sign = (0, 4, 1.0) if plane == 1 else (1, 3, -1.0)
    return ((first, 1.0), (turn, sign), (6 + first, 1.0), (6 + turn, sign))


def _spread(K, plane, part):
    for r, (i, a) in enumerate(_places(plane)):
        for c, (j, b) in enumerate(_places(plane)):
            K[i, j] += a * b * part[r, c]


def _pair(K, first, part):
    K[np.ix_([first, first + 6], [first, first + 6])] += part
