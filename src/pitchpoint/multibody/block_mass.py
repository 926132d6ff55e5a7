# SPDX-License-Identifier: Apache-2.0
"""Inverse of the 6 x 6 mass matrix of one body by 3 x 3 blocks, without pivoting.

With P for the translations, D for the rotations, the coupling B and S = D - B^T P^-1 B,

    [P  B]^-1   [P^-1 + P^-1 B S^-1 B^T P^-1   -P^-1 B S^-1]
    [B^T D]   = [     -S^-1 B^T P^-1                 S^-1  ]

A mass matrix is positive definite, so both determinants are positive unless the body lacks mass or inertia.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import OK, SINGULAR
from pitchpoint.multibody.vectors import dot


@kernel
def _inverse(a, b, c, d, e, f):
    """Inverse of the symmetric matrix [[a, b, c], [b, d, e], [c, e, f]], same order, and its determinant."""
    x = d * f - e * e
    y = c * e - b * f
    z = b * e - c * d
    det = a * x + b * y + c * z
    h = 1.0 / det if det != 0.0 else 0.0
    return x * h, y * h, z * h, (a * f - c * c) * h, (b * c - a * e) * h, (a * d - b * b) * h, det


@kernel
def _times(p, x, y, z):
    """Symmetric matrix p times the vector (x, y, z)."""
    return p[0] * x + p[1] * y + p[2] * z, p[1] * x + p[3] * y + p[4] * z, p[2] * x + p[4] * y + p[5] * z


@kernel
def invert_mass(M):
    """Invert a symmetric positive definite 6 x 6 matrix in place; returns a status."""
    p = _inverse(M[0, 0], M[0, 1], M[0, 2], M[1, 1], M[1, 2], M[2, 2])
    if not p[6] > 0.0:
        return SINGULAR
    b0 = (M[0, 3], M[1, 3], M[2, 3])
    b1 = (M[0, 4], M[1, 4], M[2, 4])
    b2 = (M[0, 5], M[1, 5], M[2, 5])
    y0 = _times(p, b0[0], b0[1], b0[2])
    y1 = _times(p, b1[0], b1[1], b1[2])
    y2 = _times(p, b2[0], b2[1], b2[2])
    s = _inverse(
        M[3, 3] - dot(b0, y0),
        M[3, 4] - dot(b0, y1),
        M[3, 5] - dot(b0, y2),
        M[4, 4] - dot(b1, y1),
        M[4, 5] - dot(b1, y2),
        M[5, 5] - dot(b2, y2),
    )
    if not s[6] > 0.0:
        return SINGULAR
    for i in range(3):
        z = _times(s, y0[i], y1[i], y2[i])
        M[i, 3] = -z[0]
        M[i, 4] = -z[1]
        M[i, 5] = -z[2]
        M[3, i] = -z[0]
        M[4, i] = -z[1]
        M[5, i] = -z[2]
        M[i, 0] = z[0] * y0[0] + z[1] * y1[0] + z[2] * y2[0]
        M[i, 1] = z[0] * y0[1] + z[1] * y1[1] + z[2] * y2[1]
        M[i, 2] = z[0] * y0[2] + z[1] * y1[2] + z[2] * y2[2]
    M[0, 0] += p[0]
    M[0, 1] += p[1]
    M[0, 2] += p[2]
    M[1, 0] += p[1]
    M[1, 1] += p[3]
    M[1, 2] += p[4]
    M[2, 0] += p[2]
    M[2, 1] += p[4]
    M[2, 2] += p[5]
    M[3, 3] = s[0]
    M[3, 4] = s[1]
    M[3, 5] = s[2]
    M[4, 3] = s[1]
    M[4, 4] = s[3]
    M[4, 5] = s[4]
    M[5, 3] = s[2]
    M[5, 4] = s[4]
    M[5, 5] = s[5]
    return OK
