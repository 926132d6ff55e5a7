# SPDX-License-Identifier: Apache-2.0
"""Signed distance of a point from simple surfaces, with normal and curvature.

Coordinates are those of the marker. The plane is z = 0 with the material below. Sphere, cylinder, cone and
torus are centred on the z axis; the cone opens downwards from its tip at the origin. `sense` 1: material
inside, -1: material outside (bore, ball cup, groove). W, the Hessian of the distance, is the curvature of
the offset surface through the point: the normal n = grad phi changes by W dy.

Derivation: docs/theory/contacts.md, "Surfaces".
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel

PLANE, SPHERE, CYLINDER, CONE, TORUS, TRIANGLES = 0, 1, 2, 3, 4, 5
RIM = 6
"""Circle in the plane z = 0 of its marker with a rounding radius: edge of a disc, tyre, ring."""
MIN_DISTANCE = 1e-12
"""Distance from an axis or centre below which the direction away from it is undefined [m]."""

NAMES = {"plane": PLANE, "sphere": SPHERE, "cylinder": CYLINDER, "cone": CONE, "torus": TORUS}


@kernel
def radial(W, n, s, distance):
    """Store the curvature s (1 - n n^T)/distance of a sphere through the point in W.

    >>> import numpy as np
    >>> W = np.zeros((3, 3))
    >>> radial(W, (0.0, 0.0, 1.0), 1.0, 0.5)
    >>> W.diagonal().tolist()
    [2.0, 2.0, 0.0]
    """
    for r in range(3):
        for c in range(3):
            W[r, c] = s * ((1.0 if r == c else 0.0) - n[r] * n[c]) / distance


@kernel
def distance(form, size, sense, y, W):
    """Signed distance [m] of the point y from a surface and its outward normal; W [1/m] is overwritten.

    size = radius [m] of sphere and cylinder; half angle [rad] of the cone; ring radius and tube radius [m]
    of the torus. On an axis or at a centre, where the direction is undefined, x is used.

    >>> import numpy as np
    >>> W = np.zeros((3, 3))
    >>> phi, nx, ny, nz = distance(TORUS, np.array([0.1, 0.02]), 1.0, np.array([0.1, 0.0, 0.03]), W)
    >>> round(float(phi), 9), round(float(nz), 9), round(float(W[0, 0]), 6), round(float(W[1, 1]), 6)
    (0.01, 1.0, 33.333333, 0.0)
    """
    for r in range(3):
        for c in range(3):
            W[r, c] = 0.0
    if form == PLANE:
        return y[2], 0.0, 0.0, 1.0
    rho = math.sqrt(y[0] * y[0] + y[1] * y[1])
    ux = y[0] / rho if rho > 0.0 else 1.0
    uy = y[1] / rho if rho > 0.0 else 0.0
    around = max(rho, MIN_DISTANCE)
    if form == CYLINDER:
        _around(W, sense / around, ux, uy)
        return sense * (rho - size[0]), sense * ux, sense * uy, 0.0
    if form == CONE:
        c = math.cos(size[0])
        s = math.sin(size[0])
        if sense < 0.0 or y[2] * c - rho * s < 0.0:
            _around(W, sense * c / around, ux, uy)
            return sense * (rho * c + y[2] * s), sense * c * ux, sense * c * uy, sense * s
        rho_c = 0.0  # nearest to the tip: distance from a point
        z = y[2]
        tube = 0.0
    elif form == TORUS:
        rho_c = size[0]
        z = y[2]
        tube = size[1]
    else:
        rho_c = 0.0
        z = y[2]
        tube = size[0]
    a = rho - rho_c
    d = max(math.sqrt(a * a + z * z), MIN_DISTANCE)
    n = (sense * a / d * ux, sense * a / d * uy, sense * z / d)
    radial(W, n, sense, d)
    if form == TORUS:  # circumferential curvature follows from the distance to the axis
        _around(W, sense * (a / around - 1.0) / d, ux, uy)
    return sense * (d - tube), n[0], n[1], n[2]


@kernel
def gap_of_length(size, sense, y):
    """Signed distance [m] of the point y from a cylinder with flat ends, the first result of `of_length`.

    >>> import numpy as np
    >>> round(float(gap_of_length(np.array([0.1, 0.5]), 1.0, np.array([0.13, 0.0, 0.29]))), 9)
    0.05
    """
    u = sense * (math.sqrt(y[0] * y[0] + y[1] * y[1]) - size[0])
    v = abs(y[2]) - 0.5 * size[1]
    if u > 0.0 and v > 0.0:
        return math.sqrt(u * u + v * v)
    return max(u, v)


@kernel
def of_length(size, sense, y, W):
    """Signed distance [m] of the point y from a cylinder with flat ends, its outward normal, and W [1/m].

    size = radius and length [m], centred at the origin; `sense` -1: bore of that length through an infinite
    body. Inside the material the nearer of lateral surface and end face applies.

    >>> import numpy as np
    >>> W = np.zeros((3, 3))
    >>> phi, nx, ny, nz = of_length(np.array([0.1, 0.5]), 1.0, np.array([0.13, 0.0, 0.29]), W)
    >>> round(float(phi), 9), round(float(nx), 9), round(float(nz), 9), round(float(W[1, 1]), 6)
    (0.05, 0.6, 0.8, 4.615385)
    """
    for r in range(3):
        for c in range(3):
            W[r, c] = 0.0
    rho = math.sqrt(y[0] * y[0] + y[1] * y[1])
    ux = y[0] / rho if rho > 0.0 else 1.0
    uy = y[1] / rho if rho > 0.0 else 0.0
    around = max(rho, MIN_DISTANCE)
    u = sense * (rho - size[0])
    v = abs(y[2]) - 0.5 * size[1]
    up = 1.0 if y[2] > 0.0 else -1.0
    if u > 0.0 and v > 0.0:
        d = math.sqrt(u * u + v * v)
        a = rho - size[0]
        n = (a / d * ux, a / d * uy, up * v / d)
        radial(W, n, 1.0, d)
        _around(W, (a / around - 1.0) / d, ux, uy)
        return d, n[0], n[1], n[2]
    if u >= v:
        _around(W, sense / around, ux, uy)
        return u, sense * ux, sense * uy, 0.0
    return v, 0.0, 0.0, up


@kernel
def _around(W, k, ux, uy):
    """Add the curvature k in the circumferential direction to W."""
    W[0, 0] += k * uy * uy
    W[0, 1] -= k * ux * uy
    W[1, 0] -= k * ux * uy
    W[1, 1] += k * ux * ux
