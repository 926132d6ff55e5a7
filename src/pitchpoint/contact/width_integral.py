# SPDX-License-Identifier: Apache-2.0
"""Exact integral of the pair stiffness over the face width of a helical (or spur) mesh.

Along a contact line the path position changes linearly over the face width, p(z) = psi + j + lam z. The pair
stiffness is a piecewise polynomial of p, at most cubic, so that z^0..z^2 times it is at most of degree five:
three Gauss points on every piece between two kinks integrate it without error. Nothing is divided by lam
except to find the kinks, which makes the limit of a spur gear harmless.

Derivation: docs/theory/stiffness.md, "The mesh".
"""

from __future__ import annotations

import math

from pitchpoint.contact.pair_shape import pair_shape, pair_shape_slope
from pitchpoint.core.kernel import kernel

#: Outer node of three-point Gauss-Legendre on [-1, 1]; weights are 5/9, 8/9, 5/9.
NODE = 0.7745966692414834

#: Below this spread of p over the face (in base pitches) a line counts as parallel to the axis.
PARALLEL = 1e-14


@kernel
def first_pair(psi, spread):
    """Smallest j with psi + j + spread >= 0: the last pair that has any of its line beyond point A.

    psi and the half spread of p over the face, `spread`, in base pitches.

    >>> int(first_pair(0.3, 0.0)), int(first_pair(2.0, 0.0)), int(first_pair(0.3, 0.8))
    (0, -2, -1)
    """
    return int(math.ceil(-psi - spread))


@kernel
def last_pair(psi, spread, eps_alpha):
    """Largest j with psi + j - spread <= eps_alpha: the first pair that has any of its line before point E.

    >>> int(last_pair(0.2, 0.0, 1.3)), int(last_pair(0.4, 0.0, 1.3)), int(last_pair(0.4, 0.2, 1.3))
    (1, 0, 1)
    """
    return int(math.floor(eps_alpha - psi + spread))


@kernel
def face_position(p, p0, lam, half):
    """Where along the face, in [-half, half], the line p0 + lam z reaches p; clipped to the ends.

    >>> round(float(face_position(0.5, 0.3, 10.0, 0.05)), 12)
    0.02
    """
    return max(-half, min(half, (p - p0) / lam))


@kernel
def gauss_moments(z_lo, z_hi, f_lo, f_mid, f_hi):
    """Integrals of f, f z, f z^2 over [z_lo, z_hi] from f at the three Gauss points of the piece.

    Exact where f z^2 is a polynomial of degree five or less.

    >>> tuple(round(float(x), 12) for x in gauss_moments(0.0, 3.0, 1.0, 1.0, 1.0))
    (3.0, 4.5, 9.0)
    """
    r = 0.5 * (z_hi - z_lo)
    m = 0.5 * (z_hi + z_lo)
    d = NODE * r
    a = 5.0 / 9.0 * r * f_lo
    e = 5.0 / 9.0 * r * f_hi
    s = a + 8.0 / 9.0 * r * f_mid + e
    t = (e - a) * d
    return s, m * s + t, m * m * s + 2.0 * m * t + (a + e) * d * d


@kernel
def shape_piece(z_lo, z_hi, p0, lam, eps_alpha, S_R, L, order):
    """Moments of the pair shape (order 0) or of its slope (order 1) over a piece without kinks inside.

    >>> tuple(round(float(x), 12) for x in shape_piece(0.0, 0.1, 0.65, 0.0, 1.3, 0.8, 0.0, 0))
    (0.1, 0.005, 0.000333333333)
    """
    m = p0 + lam * 0.5 * (z_hi + z_lo)
    d = lam * NODE * 0.5 * (z_hi - z_lo)
    if order == 0:
        return gauss_moments(
            z_lo,
            z_hi,
            pair_shape(m - d, eps_alpha, S_R, L),
            pair_shape(m, eps_alpha, S_R, L),
            pair_shape(m + d, eps_alpha, S_R, L),
        )
    return gauss_moments(
        z_lo,
        z_hi,
        pair_shape_slope(m - d, eps_alpha, S_R, L),
        pair_shape_slope(m, eps_alpha, S_R, L),
        pair_shape_slope(m + d, eps_alpha, S_R, L),
    )


@kernel
def pair_moments(p0, lam, b, eps_alpha, S_R, L, order):
    """Integrals over z in [-b/2, b/2] of c(p0 + lam z)/c' z^n, n = 0, 1, 2, for one pair.

    p0 [base pitches] is the position at mid-face, lam = tan(beta_b)/p_bt [1/m] (signed by the hand), b [m];
    the results are in m, m^2, m^3. order 1 gives their derivatives by p0 where they exist; a jump of the
    shape at A or E (L = 0) moves along the face and counts with its exact rate.

    >>> tuple(round(float(x), 12) for x in pair_moments(0.65, 0.0, 0.1, 1.3, 0.8, 0.0, 0))
    (0.1, 0.0, 8.3333333e-05)
    """
    half = 0.5 * b
    if abs(lam) * b < PARALLEL:
        c = b * (pair_shape(p0, eps_alpha, S_R, L) if order == 0 else pair_shape_slope(p0, eps_alpha, S_R, L))
        return c, 0.0, c * b * b / 12.0
    z_A = face_position(0.0, p0, lam, half)
    z_E = face_position(eps_alpha, p0, lam, half)
    z0 = z_A
    z1 = face_position(min(L, 0.5 * eps_alpha), p0, lam, half)
    z2 = face_position(max(eps_alpha - L, 0.5 * eps_alpha), p0, lam, half)
    z3 = z_E
    if lam < 0.0:
        z0, z1, z2, z3 = z3, z2, z1, z0
    k0 = 0.0
    k1 = 0.0
    k2 = 0.0
    if z1 > z0:
        k0, k1, k2 = shape_piece(z0, z1, p0, lam, eps_alpha, S_R, L, order)
    if z2 > z1:
        s0, s1, s2 = shape_piece(z1, z2, p0, lam, eps_alpha, S_R, L, order)
        k0 += s0
        k1 += s1
        k2 += s2
    if z3 > z2:
        s0, s1, s2 = shape_piece(z2, z3, p0, lam, eps_alpha, S_R, L, order)
        k0 += s0
        k1 += s1
        k2 += s2
    if order == 1 and L <= 0.0:
        rate = S_R / abs(lam)
        if abs(z_A) < half:
            k0 += rate
            k1 += rate * z_A
            k2 += rate * z_A * z_A
        if abs(z_E) < half:
            k0 -= rate
            k1 -= rate * z_E
            k2 -= rate * z_E * z_E
    return k0, k1, k2
