# SPDX-License-Identifier: Apache-2.0
"""Mechanisms with one freedom as point masses on curves: the oracle of closed loops, without any joint.

The places of all masses are functions of one coordinate u, fitted by Chebyshev polynomials to rounding. Then
M(u) = sum m |x'|^2, V(u) = - sum m g . x, and Lagrange's equation M u'' + M' u'^2 / 2 + V' = 0 is
integrated by SciPy. A slender rod is m/6, 4m/6, m/6 at its ends and its middle, exactly: the places along
it are linear, so energies are integrals of quadratic functions (Simpson's rule).
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial import chebyshev
from scipy.integrate import solve_ivp

ROD = np.array([1.0, 4.0, 1.0]) / 6.0
"""Shares of the mass of a slender rod at its start, middle and end."""


def turn_about(point, axis, angle):
    """Homogeneous matrix (4, 4) that turns about a line through a point (Rodrigues)."""
    a = np.asarray(axis, float) / np.linalg.norm(axis)
    K = np.array([[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]])
    found = np.eye(4)
    found[:3, :3] += np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K
    found[:3, 3] = np.asarray(point, float) - found[:3, :3] @ point
    return found


def along_rod(start, end):
    """The three places of the masses of a slender rod, shape (3, 3)."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    return np.array([start, 0.5 * (start + end), end])


class OneFreedom:
    """Masses (n,) at places(u) (n, 3) over an interval of u, repeated after 2 pi if that is `periodic`."""

    def __init__(self, masses, places, interval, gravity, degree=100, periodic=False):
        self.masses = np.asarray(masses, float)
        self.interval = (-np.inf, np.inf) if periodic else interval
        self.gravity = np.asarray(gravity, float)
        middle, half = 0.5 * sum(interval), 0.5 * (interval[1] - interval[0])
        period = 2.0 * np.pi if periodic else 1e9
        self._scaled = lambda u: (u - period * np.round(u / period) - middle) / half
        nodes = np.cos(np.pi * (np.arange(degree + 1) + 0.5) / (degree + 1))
        values = np.array([places(middle + half * x) for x in nodes]).reshape(degree + 1, -1)
        self._fits = [chebyshev.chebfit(nodes, values, degree)]
        for _ in range(2):
            self._fits.append(chebyshev.chebder(self._fits[-1]) / half)
        tail = np.abs(self._fits[0][-3:]).max()
        assert tail < 1e-12, f"the interval is too wide for the degree: {tail}"

    def places(self, u, derivative=0):
        """Places (n, 3) or their derivatives by u."""
        return chebyshev.chebval(self._scaled(u), self._fits[derivative]).reshape(-1, 3)

    def energy(self, u, rate):
        """Kinetic and potential energy [J]."""
        slope = self.places(u, 1)
        mass = np.einsum("n,ni,ni->", self.masses, slope, slope)
        return 0.5 * mass * rate**2, -float(self.masses @ self.places(u) @ self.gravity)

    def acceleration(self, u, rate):
        """u'' from Lagrange's equation."""
        slope, bend = self.places(u, 1), self.places(u, 2)
        mass = np.einsum("n,ni,ni->", self.masses, slope, slope)
        swing = np.einsum("n,ni,ni->", self.masses, slope, bend) * rate**2
        return (float(self.masses @ slope @ self.gravity) - swing) / mass

    def motion(self, u, rate, times):
        """Coordinate and rate at times, shape (2, len(times)), to 1e-12 or so."""
        found = solve_ivp(
            lambda t, y: (y[1], self.acceleration(*y)),
            (0.0, times[-1]),
            (u, rate),
            "DOP853",
            t_eval=times,
            rtol=1e-13,
            atol=1e-13,
        )
        assert found.success
        assert self.interval[0] < found.y[0].min() and found.y[0].max() < self.interval[1]
        return found.y
