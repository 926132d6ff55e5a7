# SPDX-License-Identifier: Apache-2.0
"""Signed distance of a point from surfaces of simple shape, with normal and curvature.

Axes are those of the marker: the plane is z = 0 with the material below, sphere, cylinder, cone and torus lie
about the z axis, the cone opens downwards from its tip at the origin. `sense` 1 has the material inside, -1
outside (a bore, a ball cup, a groove). The Hessian of the distance, W, is the curvature of the surface
through the point: the normal n = grad phi changes by W dy with the point.

Derivation: docs/theory/contacts.md, "Surfaces".
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel

PLANE, SPHERE, CYLINDER, CONE, TORUS, TRIANGLES = 0, 1, 2, 3, 4, 5
RIM = 6
"""A circle in the plane z = 0 of its marker, with a rounding: edge of a disc, tyre, ring."""
LEAST = 1e-12
"""Distance from an axis or centre below which there is no direction away from it [m]."""

NAMES = {"plane": PLANE, "sphere": SPHERE, "cylinder": CYLINDER, "cone": CONE, "torus": TORUS}


@kernel
def radial(W, n, s, distance):
    """Curvature s (1 - n n^T)/distance of a sphere through the point, into W.

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
    """Distance [m] of the point y from a surface, its outward normal, and W [1/m] as a result.

    size = radius [m] of sphere and cylinder; half angle [rad] of the cone; radius of the ring and of the tube
    [m] of the torus. On an axis or at a centre, where no direction is nearest, the first one is taken.

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
    around = max(rho, LEAST)
    if form == CYLINDER:
        _around(W, sense / around, ux, uy)
        return sense * (rho - size[0]), sense * ux, sense * uy, 0.0
    if form == CONE:
        c = math.cos(size[0])
        s = math.sin(size[0])
        if sense < 0.0 or y[2] * c - rho * s < 0.0:
            _around(W, sense * c / around, ux, uy)
            return sense * (rho * c + y[2] * s), sense * c * ux, sense * c * uy, sense * s
        rho_c = 0.0  # nearest to the tip: that of a point
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
    d = max(math.sqrt(a * a + z * z), LEAST)
    n = (sense * a / d * ux, sense * a / d * uy, sense * z / d)
    radial(W, n, sense, d)
    if form == TORUS:  # along the ring it is the distance from the axis that counts
        _around(W, sense * (a / around - 1.0) / d, ux, uy)
    return sense * (d - tube), n[0], n[1], n[2]


@kernel
def gap_of_length(size, sense, y):
    """Distance [m] of the point y from a cylinder with flat ends, the first result of `of_length`.

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
    """Distance [m] of the point y from a cylinder with flat ends, its outward normal, and W [1/m].

    size = radius and length [m], the middle at the origin; with `sense` -1 a bore of that length through
    material without end. Inside the material the nearer of jacket and end counts.

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
    around = max(rho, LEAST)
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
    """Add the curvature k in the direction around the axis."""
    W[0, 0] += k * uy * uy
    W[0, 1] -= k * ux * uy
    W[1, 0] -= k * ux * uy
    W[1, 1] += k * ux * ux
